/**
 * @file
 * @brief Drawing panels: letters as large as wanted, where the window has room for them.
 */
#include "view/panels/panel.h"

#include "view/window/font.h"

/** A row is as high as the window's height divided by this. */
static const int LINES_PER_WINDOW = 28;
/** Smallest size of letters that is tried, pixels: below it they are only dots. */
static const int FONT_SIZE_MINIMUM = 4;
/** Size of letters below which no window of a sensible size goes, pixels. */
static const int FONT_SIZE_READABLE = 12;

/** How many times as wide as a letter's size a colour is shown. */
static const int SWATCH_WIDTH = 2;

/** Colour of the words. */
static const SDL_Color TEXT_COLOR = {240, 240, 240, SDL_ALPHA_OPAQUE};
/** Colour of the labels: apart from the words by hue and by lightness. */
static const SDL_Color LABEL_COLOR = {255, 205, 90, SDL_ALPHA_OPAQUE};
/** Colour of the headings. */
static const SDL_Color HEADING_COLOR = {150, 200, 255, SDL_ALPHA_OPAQUE};
/** Colours of headings and labels that belong together, as on a drawn keyboard; told apart by those
 *  who are colour-blind, too. */
static const SDL_Color tint_colors[] = {
    {255, 205, 90, SDL_ALPHA_OPAQUE},  {120, 190, 255, SDL_ALPHA_OPAQUE},
    {90, 215, 170, SDL_ALPHA_OPAQUE},  {255, 145, 110, SDL_ALPHA_OPAQUE},
    {205, 205, 215, SDL_ALPHA_OPAQUE}, {225, 165, 215, SDL_ALPHA_OPAQUE}};
/** Colour of the panel: dark, and the picture can be guessed behind it. */
static const SDL_Color PANEL_COLOR = {15, 18, 28, 215};

/** A panel laid out in letters of one size. All lengths are pixels. */
typedef struct PanelLayout {
    const PanelRow *rows; /**< What is said. */
    size_t count;         /**< How many rows. */
    TTF_Font *font;       /**< The letters; owned. */
    int line_height;      /**< Height of a row. */
    int margin;           /**< Empty border, and gap between the columns. */
    int label_width;      /**< Width of the column of labels, with the gap after it; 0: none. */
    int text_width;       /**< Width of the column of words. */
} PanelLayout;

/**
 * Lays the rows out in letters of one size.
 * @param[in,out] layout  The rows and the font; the lengths are set.
 * @param size            Size of the letters, pixels.
 */
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

/**
 * @return Where a row begins, counted from the panel's upper end. A heading stands off what is
 *         before it.
 * @param index  Which row; the number of rows: where the next would begin.
 */
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

/**
 * Lays the rows out in the largest letters, up to those wanted, that fit a window.
 * @param[in,out] layout  The rows and the font; the lengths are set.
 * @return Their size, pixels.
 */
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

/** Shows a colour; those of rows that follow each other touch. @param y Upper end of its row,
 *  pixels. */
static void draw_swatch(SDL_Surface *panel, const PanelLayout *layout, const uint8_t rgb[3],
                        int y) {
    int width = layout->label_width - layout->margin; // The gap is as wide as the margin.
    SDL_Rect destination = {.x = layout->margin, .y = y, .w = width, .h = layout->line_height};
    SDL_FillRect(panel, &destination,
                 SDL_MapRGBA(panel->format, rgb[0], rgb[1], rgb[2], SDL_ALPHA_OPAQUE));
}

/** @return The panel with all rows, or NULL without memory. */
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
