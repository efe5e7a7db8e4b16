/**
 * @file
 * @brief Drawing panels, breaking text into rows, and keeping panels as textures.
 */
#include "view/panels/panel.h"

#include "view/window/font.h"

#include <string.h>

/** Rows of default size that fill the window's height. */
static const int LINES_PER_WINDOW = 28;
/** Smallest size of letters, pixels: smaller ones are only dots. */
static const int FONT_SIZE_MINIMUM = 4;
/** Smallest default size of letters, pixels. */
static const int FONT_SIZE_READABLE = 12;

/** Width of a colour swatch, in sizes of letters. */
static const int SWATCH_WIDTH = 2;

/** Colour of texts. */
static const SDL_Color TEXT_COLOR = {240, 240, 240, SDL_ALPHA_OPAQUE};
/** Colour of labels: differs from the texts by hue and by lightness. */
static const SDL_Color LABEL_COLOR = {255, 205, 90, SDL_ALPHA_OPAQUE};
/** Colour of the headings. */
static const SDL_Color HEADING_COLOR = {150, 200, 255, SDL_ALPHA_OPAQUE};
/** Colours of groups, as on the drawn keyboard; distinct for colour-blind viewers too. */
static const SDL_Color tint_colors[] = {
    {255, 205, 90, SDL_ALPHA_OPAQUE},  {120, 190, 255, SDL_ALPHA_OPAQUE},
    {90, 215, 170, SDL_ALPHA_OPAQUE},  {255, 145, 110, SDL_ALPHA_OPAQUE},
    {205, 205, 215, SDL_ALPHA_OPAQUE}, {225, 165, 215, SDL_ALPHA_OPAQUE}};
/** Colour of a panel: dark, slightly transparent. */
static const SDL_Color PANEL_COLOR = {15, 18, 28, 215};

/** The layout of a panel in letters of one size. All lengths are pixels. */
typedef struct PanelLayout {
    const PanelRow *rows; /**< The rows. */
    size_t count;         /**< Their number. */
    TTF_Font *font;       /**< The font; owned. */
    int line_height;      /**< Height of a row. */
    int margin;           /**< Empty border, and gap between the columns. */
    int label_width;      /**< Width of the labels' column with its gap; 0: none. */
    int text_width;       /**< Width of the texts' column. */
} PanelLayout;

/** Computes the lengths of a layout. @param size Size of the letters, pixels. */
static void layout_rows(PanelLayout *layout, int size) {
    TTF_SetFontSize(layout->font, size);
    layout->line_height = TTF_FontLineSkip(layout->font);
    layout->margin = size;
    layout->label_width = layout->text_width = 0;
    int headings_width = 0;
    for (size_t i = 0; i < layout->count; i++) {
        const PanelRow *row = &layout->rows[i];
        int label_width = font_text_width(layout->font, row->label),
            text_width = font_text_width(layout->font, row->text);
        int *width = row->is_heading ? &headings_width : &layout->text_width;
        *width = SDL_max(*width, text_width);
        label_width = row->has_swatch ? SWATCH_WIDTH * size : label_width;
        layout->label_width =
            SDL_max(layout->label_width, label_width > 0 ? label_width + size : 0);
    }
    layout->text_width = SDL_max(layout->text_width, headings_width - layout->label_width);
}

/** @return Width of the panel. */
static int panel_width(const PanelLayout *layout) {
    return layout->label_width + layout->text_width + 2 * layout->margin;
}

/** @return Top of a row, from the top of the panel; there is a gap above each heading. @param index
 *  The row; the number of rows: the end of the last one. */
static int row_top(const PanelLayout *layout, size_t index) {
    int top = layout->margin / 2 + layout->line_height * (int)index;
    for (size_t i = 1; i <= index && i < layout->count; i++) {
        top += layout->rows[i].is_heading ? layout->margin / 2 : 0;
    }
    return top;
}

/** @return Height of the panel. */
static int panel_height(const PanelLayout *layout) {
    return row_top(layout, layout->count) + layout->margin / 2;
}

/** Computes the layout in the largest letters that fit, up to the default size. @return Their size,
 *  pixels. */
static int layout_to_fit(PanelLayout *layout, const PanelBounds *bounds) {
    int size =
        (int)(SDL_max(FONT_SIZE_READABLE, bounds->height / LINES_PER_WINDOW) * bounds->scale);
    size = SDL_max(size, FONT_SIZE_MINIMUM);
    layout_rows(layout, size);
    while (size > FONT_SIZE_MINIMUM &&
           (panel_width(layout) > bounds->width || panel_height(layout) > bounds->height)) {
        layout_rows(layout, --size);
    }
    return size;
}

SDL_Color panel_tint_color(int tint) {
    return tint_colors[(tint - 1) % (int)(sizeof tint_colors / sizeof *tint_colors)];
}

SDL_Surface *panel_create(int width, int height) {
    SDL_Surface *panel =
        SDL_CreateRGBSurfaceWithFormat(0, width, height, 32, SDL_PIXELFORMAT_ARGB8888);
    if (panel) {
        SDL_FillRect(
            panel, NULL,
            SDL_MapRGBA(panel->format, PANEL_COLOR.r, PANEL_COLOR.g, PANEL_COLOR.b, PANEL_COLOR.a));
    }
    return panel;
}

/** Draws a colour swatch; those of neighbouring rows touch. @param y Top of its row, pixels. */
static void draw_swatch(SDL_Surface *panel, const PanelLayout *layout, const uint8_t rgb[3],
                        int y) {
    int width = layout->label_width - layout->margin; // The gap is as wide as the margin.
    SDL_Rect destination = {.x = layout->margin, .y = y, .w = width, .h = layout->line_height};
    SDL_FillRect(panel, &destination,
                 SDL_MapRGBA(panel->format, rgb[0], rgb[1], rgb[2], SDL_ALPHA_OPAQUE));
}

/** @return The panel with all rows; NULL without memory. */
static SDL_Surface *draw_layout(const PanelLayout *layout) {
    SDL_Surface *panel = panel_create(panel_width(layout), panel_height(layout));
    if (!panel) {
        return NULL;
    }
    for (size_t i = 0; i < layout->count; i++) {
        const PanelRow *row = &layout->rows[i];
        int x = layout->margin, y = row_top(layout, i);
        if (row->has_swatch) {
            draw_swatch(panel, layout, row->swatch, y);
        }
        SDL_Color label = row->tint ? panel_tint_color(row->tint) : LABEL_COLOR;
        SDL_Color heading = row->tint ? panel_tint_color(row->tint) : HEADING_COLOR;
        font_draw_text(panel, layout->font, row->label, label, x, y);
        x += row->is_heading ? 0 : layout->label_width;
        font_draw_text(panel, layout->font, row->text, row->is_heading ? heading : TEXT_COLOR, x,
                       y);
    }
    return panel;
}

int panel_font_size(const PanelRow *rows, size_t count, const PanelBounds *bounds) {
    PanelLayout layout = {.rows = rows, .count = count, .font = font_open()};
    if (!layout.font) {
        return 0;
    }
    int size = layout_to_fit(&layout, bounds);
    font_close(layout.font);
    return size;
}

SDL_Surface *panel_draw_at_size(const PanelRow *rows, size_t count, int size) {
    PanelLayout layout = {.rows = rows, .count = count, .font = font_open()};
    if (!layout.font) {
        return NULL;
    }
    layout_rows(&layout, size);
    SDL_Surface *panel = draw_layout(&layout);
    font_close(layout.font);
    return panel;
}

SDL_Surface *panel_draw(const PanelRow *rows, size_t count, const PanelBounds *bounds) {
    int size = panel_font_size(rows, count, bounds);
    return size > 0 ? panel_draw_at_size(rows, count, size) : NULL;
}

/* --- breaking text into rows ------------------------------------------------------------------ */

/** @return Where a row is full, or its line ends. @param row The rest of the text, UTF-8. */
static char *word_wrap_row_limit(char *row, int characters) {
    char *end = row;
    for (; *end && *end != '\n'; end++) {
        bool is_character = (*end & 0xC0) != 0x80; // No continuation byte of UTF-8.
        if (is_character && characters-- == 0) {
            break;
        }
    }
    return end;
}

/** @return Where a row is broken: at its last space, or after a first word that is too long. */
static char *word_wrap_row_end(char *row, int characters) {
    char *limit = word_wrap_row_limit(row, characters), *end = limit;
    while (end > row && *end && *end != ' ' && *end != '\n') {
        end--;
    }
    return end > row || *row == '\n' ? end : limit + strcspn(limit, " \n");
}

size_t word_wrap(char *text, int characters, PanelRow *rows, size_t maximum) {
    size_t count = 0;
    char *rest = text;
    while (*rest && count < maximum) {
        char *end = word_wrap_row_end(rest, characters);
        rows[count++] = (PanelRow){.text = rest};
        rest = *end ? end + 1 : end;
        *end = '\0';
    }
    return count;
}

/* --- panels as textures ----------------------------------------------------------------------- */

bool overlay_is_stale(const Overlay *overlay) {
    return !overlay->texture;
}

void overlay_draw(Overlay *overlay, const OverlayTarget *target, const PanelRow *rows,
                  size_t count) {
    PanelBounds bounds = overlay_bounds(target);
    overlay_set_surface(overlay, target, panel_draw(rows, count, &bounds));
}

PanelBounds overlay_bounds(const OverlayTarget *target) {
    PanelBounds bounds = {.scale = target->scale};
    SDL_GetRendererOutputSize(target->renderer, &bounds.width, &bounds.height);
    bounds.width = (int)(bounds.width * target->width_fraction);
    bounds.height = SDL_max(1, bounds.height - target->top);
    return bounds;
}

void overlay_set_surface(Overlay *overlay, const OverlayTarget *target, SDL_Surface *panel) {
    overlay_invalidate(overlay);
    if (panel) {
        overlay->texture = SDL_CreateTextureFromSurface(target->renderer, panel);
        SDL_FreeSurface(panel);
    }
}

void overlay_show(const Overlay *overlay, const OverlayTarget *target) {
    SDL_Rect destination = {0};
    int width = 0, height = 0;
    if (!overlay->texture) {
        return;
    }
    SDL_GetRendererOutputSize(target->renderer, &width, &height);
    SDL_QueryTexture(overlay->texture, NULL, NULL, &destination.w, &destination.h);
    bool is_corner = overlay->anchor == OVERLAY_TOP_LEFT || overlay->anchor == OVERLAY_TOP_RIGHT;
    int right = width - destination.w, below = height - target->top - destination.h;
    destination.x = !is_corner ? right / 2 : overlay->anchor == OVERLAY_TOP_LEFT ? 0 : right;
    destination.y = is_corner ? 0 : overlay->anchor == OVERLAY_CENTER ? below / 2 : below;
    destination.y += target->top;
    SDL_RenderCopy(target->renderer, overlay->texture, NULL, &destination);
}

void overlay_invalidate(Overlay *overlay) {
    if (overlay->texture) {
        SDL_DestroyTexture(overlay->texture);
        overlay->texture = NULL;
    }
}
