/**
 * @file
 * @brief Drawing panels: letters as large as wanted, where the window has room for them.
 */
#include "view/panel.h"

#include "view/font.h"

/** A row is as high as the window's height divided by this. */
static const int LINES_A_WINDOW = 28;
/** Smallest size of letters that is tried, pixels: below it they are only dots. */
static const int SIZE_MINIMUM = 4;
/** Size of letters below which no window of a sensible size goes, pixels. */
static const int SIZE_READABLE = 12;

/** How many times as wide as a letter's size a colour is shown. */
static const int SWATCH_SIZES = 2;

/** Colour of the words. */
static const SDL_Color WORDS = {240, 240, 240, SDL_ALPHA_OPAQUE};
/** Colour of the labels: apart from the words by hue and by lightness. */
static const SDL_Color LABELS = {255, 205, 90, SDL_ALPHA_OPAQUE};
/** Colour of the headings. */
static const SDL_Color HEADINGS = {150, 200, 255, SDL_ALPHA_OPAQUE};
/** Colours of headings and labels that belong together, as on a drawn keyboard; told apart by those
 *  who are colour-blind, too. */
static const SDL_Color tints[] = {
    {255, 205, 90, SDL_ALPHA_OPAQUE},  {120, 190, 255, SDL_ALPHA_OPAQUE},
    {90, 215, 170, SDL_ALPHA_OPAQUE},  {255, 145, 110, SDL_ALPHA_OPAQUE},
    {205, 205, 215, SDL_ALPHA_OPAQUE}, {225, 165, 215, SDL_ALPHA_OPAQUE}};
/** Colour of the panel: dark, and the picture can be guessed behind it. */
static const SDL_Color PANEL = {15, 18, 28, 215};

/** A panel laid out in letters of one size. All lengths are pixels. */
typedef struct Layout {
    const PanelRow *rows; /**< What is said. */
    size_t count;         /**< How many rows. */
    TTF_Font *font;       /**< The letters; owned. */
    int line;             /**< Height of a row. */
    int margin;           /**< Empty border, and gap between the columns. */
    int labels_width;     /**< Width of the column of labels, with the gap after it; 0: none. */
    int words_width;      /**< Width of the column of words. */
} Layout;

/**
 * Lays the rows out in letters of one size.
 * @param[in,out] layout  The rows and the font; the lengths are set.
 * @param size            Size of the letters, pixels.
 */
static void lay_out(Layout *layout, int size) {
    TTF_SetFontSize(layout->font, size);
    layout->line = TTF_FontLineSkip(layout->font);
    layout->margin = size;
    layout->labels_width = layout->words_width = 0;
    int headings_width = 0;
    for (size_t i = 0; i < layout->count; i++) {
        const PanelRow *row = &layout->rows[i];
        int label = font_width(layout->font, row->label),
            words = font_width(layout->font, row->text);
        int *width = row->is_heading ? &headings_width : &layout->words_width;
        *width = SDL_max(*width, words);
        label = row->has_swatch ? SWATCH_SIZES * size : label;
        layout->labels_width = SDL_max(layout->labels_width, label > 0 ? label + size : 0);
    }
    layout->words_width = SDL_max(layout->words_width, headings_width - layout->labels_width);
}

/** @return Width of the panel. @param layout The layout. */
static int panel_width(const Layout *layout) {
    return layout->labels_width + layout->words_width + 2 * layout->margin;
}

/** @return Where a row begins, counted from the panel's upper end. A heading stands off what is
 *          before it. @param layout The layout. @param index Which row; the number of rows: where
 *          the next would begin. */
static int row_top(const Layout *layout, size_t index) {
    int top = layout->margin / 2 + layout->line * (int)index;
    for (size_t i = 1; i <= index && i < layout->count; i++) {
        top += layout->rows[i].is_heading ? layout->margin / 2 : 0;
    }
    return top;
}

/** @return Height of the panel. @param layout The layout. */
static int panel_height(const Layout *layout) {
    return row_top(layout, layout->count) + layout->margin / 2;
}

/**
 * Lays the rows out in the largest letters, up to those wanted, that fit a window.
 * @param[in,out] layout  The rows and the font; the lengths are set.
 * @param room            The room.
 * @return Their size, pixels.
 */
static int lay_out_to_fit(Layout *layout, const PanelRoom *room) {
    int size = (int)(SDL_max(SIZE_READABLE, room->height / LINES_A_WINDOW) * room->scale);
    size = SDL_max(size, SIZE_MINIMUM);
    lay_out(layout, size);
    while (size > SIZE_MINIMUM &&
           (panel_width(layout) > room->width || panel_height(layout) > room->height)) {
        lay_out(layout, --size);
    }
    return size;
}

SDL_Color panel_tint(int tint) {
    return tints[(tint - 1) % (int)(sizeof tints / sizeof *tints)];
}

SDL_Surface *panel_create(int width, int height) {
    SDL_Surface *panel =
        SDL_CreateRGBSurfaceWithFormat(0, width, height, 32, SDL_PIXELFORMAT_ARGB8888);
    if (panel) {
        SDL_FillRect(panel, NULL, SDL_MapRGBA(panel->format, PANEL.r, PANEL.g, PANEL.b, PANEL.a));
    }
    return panel;
}

/** Shows a colour; those of rows that follow each other touch. @param panel The panel. @param
 * layout The layout. @param rgb The colour. @param y Upper end of its row, pixels. */
static void draw_swatch(SDL_Surface *panel, const Layout *layout, const uint8_t rgb[3], int y) {
    int width = layout->labels_width - layout->margin; // The gap is as wide as the margin.
    SDL_Rect place = {.x = layout->margin, .y = y, .w = width, .h = layout->line};
    SDL_FillRect(panel, &place,
                 SDL_MapRGBA(panel->format, rgb[0], rgb[1], rgb[2], SDL_ALPHA_OPAQUE));
}

/** @return The panel with all rows, or NULL without memory. @param layout The layout. */
static SDL_Surface *draw_panel(const Layout *layout) {
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
        SDL_Color label = row->tint ? panel_tint(row->tint) : LABELS;
        SDL_Color heading = row->tint ? panel_tint(row->tint) : HEADINGS;
        font_write(panel, layout->font, row->label, label, x, y);
        x += row->is_heading ? 0 : layout->labels_width;
        font_write(panel, layout->font, row->text, row->is_heading ? heading : WORDS, x, y);
    }
    return panel;
}

int panel_size(const PanelRow *rows, size_t count, const PanelRoom *room) {
    Layout layout = {.rows = rows, .count = count, .font = font_open()};
    if (!layout.font) {
        return 0;
    }
    int size = lay_out_to_fit(&layout, room);
    font_close(layout.font);
    return size;
}

SDL_Surface *panel_draw_in(const PanelRow *rows, size_t count, int size) {
    Layout layout = {.rows = rows, .count = count, .font = font_open()};
    if (!layout.font) {
        return NULL;
    }
    lay_out(&layout, size);
    SDL_Surface *panel = draw_panel(&layout);
    font_close(layout.font);
    return panel;
}

SDL_Surface *panel_draw(const PanelRow *rows, size_t count, const PanelRoom *room) {
    int size = panel_size(rows, count, room);
    return size > 0 ? panel_draw_in(rows, count, size) : NULL;
}
