/**
 * @file
 * @brief Drawing the list of scenes.
 */
#include "view/panels/browser.h"

#include "base/language.h"
#include "view/window/font.h"

#include <libintl.h>
#include <string.h>

/** Colour of texts. */
static const SDL_Color TEXT_COLOR = {240, 240, 240, SDL_ALPHA_OPAQUE};
/** Colour of the heading, and of the frame of the selected scene. */
static const SDL_Color SELECTED_COLOR = {255, 205, 90, SDL_ALPHA_OPAQUE};
/** Colour of errors. */
static const SDL_Color ERROR_COLOR = {255, 160, 130, SDL_ALPHA_OPAQUE};
/** Colour of a thumbnail that is not drawn yet. */
static const SDL_Color PLACEHOLDER_COLOR = {42, 46, 58, SDL_ALPHA_OPAQUE};

BrowserGrid browser_panel_grid(const PanelBounds *bounds) {
    /** Approximate width of a thumbnail in a window of 600 pixels' height. */
    const int usual_width = 155;
    const int font_size = SDL_clamp((int)(bounds->height / 34 * bounds->scale), 8, 60);
    int columns =
        SDL_clamp((int)(bounds->width / (usual_width * SDL_max(1, bounds->height / 600.0))), 1, 8);
    BrowserGrid grid = {.columns = columns, .font_size = font_size, .top = 2 * font_size};
    grid.width = SDL_max(8, (bounds->width - font_size) / columns);
    grid.height = (grid.width - 8) * 3 / 4 + 8 + font_size * 3 / 2;
    grid.left = (bounds->width - columns * grid.width) / 2;
    grid.rows = SDL_max(1, (bounds->height - grid.top - 4 * font_size) / grid.height);
    return grid;
}

/** Fills a rectangle. */
static void fill_rect(SDL_Surface *panel, const SDL_Rect *area, SDL_Color color) {
    SDL_FillRect(panel, area, SDL_MapRGBA(panel->format, color.r, color.g, color.b, color.a));
}

/** Draws a thumbnail. */
static void draw_thumbnail(SDL_Surface *panel, const Picture *picture, SDL_Rect area) {
    SDL_Surface *small =
        SDL_CreateRGBSurfaceWithFormatFrom(picture->pixels, picture->width, picture->height, 24,
                                           3 * picture->width, SDL_PIXELFORMAT_RGB24);
    if (small) {
        SDL_BlitScaled(small, NULL, panel, &area);
        SDL_FreeSurface(small);
    }
}

/** Writes a text in rows; those that do not fit are left out. */
static void draw_wrapped_text(SDL_Surface *panel, TTF_Font *font, const char *text, SDL_Rect area,
                              SDL_Color color) {
    char copy[SCENE_ENTRY_TITLE_SIZE];
    PanelRow rows[12];
    const int line = TTF_FontLineSkip(font),
              character_width = SDL_max(1, font_text_width(font, "n"));
    size_t maximum = (size_t)SDL_clamp(area.h / line, 0, 12);
    SDL_strlcpy(copy, text, sizeof copy);
    size_t count = word_wrap(copy, SDL_max(1, area.w / character_width), rows, maximum);
    for (size_t i = 0; i < count; i++) {
        font_draw_text(panel, font, rows[i].text, color, area.x, area.y + (int)i * line);
    }
}

/** Draws a scene: its thumbnail, or its error, and its name. */
static void draw_entry(SDL_Surface *panel, TTF_Font *font, const SceneEntry *scene, SDL_Rect cell,
                       bool is_selected) {
    /** Pixels between thumbnails, and width of the frame of the selected one. */
    const int frame = 4;
    SDL_Rect area = {cell.x + frame, cell.y + frame, cell.w - 2 * frame,
                     (cell.w - 2 * frame) * 3 / 4};
    SDL_Rect around = {area.x - frame, area.y - frame, area.w + 2 * frame, area.h + 2 * frame};
    if (is_selected) {
        fill_rect(panel, &around, SELECTED_COLOR);
    }
    fill_rect(panel, &area, PLACEHOLDER_COLOR);
    if (scene->picture.pixels) {
        draw_thumbnail(panel, &scene->picture, area);
    } else {
        SDL_Rect text_area = {area.x + frame, area.y + frame, area.w - 2 * frame,
                              area.h - 2 * frame};
        SDL_SetClipRect(panel, &text_area);
        draw_wrapped_text(panel, font, scene->is_loaded ? scene->title : "…", text_area,
                          scene->is_loaded ? ERROR_COLOR : TEXT_COLOR);
    }
    SDL_SetClipRect(panel, &cell);
    font_draw_text(panel, font, scene->name, is_selected ? SELECTED_COLOR : TEXT_COLOR, area.x,
                   area.y + area.h + frame);
    SDL_SetClipRect(panel, NULL);
}

/** Draws all visible scenes. */
static void draw_entries(SDL_Surface *panel, TTF_Font *font, const Browser *browser,
                         const BrowserGrid *grid) {
    for (int i = 0; i < grid->rows * grid->columns; i++) {
        size_t index = browser->first_row * (size_t)grid->columns + (size_t)i;
        SDL_Rect cell = {grid->left + i % grid->columns * grid->width,
                         grid->top + i / grid->columns * grid->height, grid->width, grid->height};
        if (index < browser->list.count) {
            draw_entry(panel, font, &browser->list.scenes[index], cell, index == browser->selected);
        }
    }
}

/** Writes the heading above the scenes, and the selected one's title or error below. */
static void draw_heading_and_title(SDL_Surface *panel, TTF_Font *font, const Browser *browser,
                                   const BrowserGrid *grid) {
    const SceneList *list = &browser->list;
    char heading[PATH_MAX + 128];
    snprintf(heading, sizeof heading, gettext("Scene %zu of %zu — arrows, Enter, Esc"),
             list->count ? browser->selected + 1 : 0, list->count);
    font_draw_text(panel, font, heading, SELECTED_COLOR, grid->left + 4, grid->font_size / 3);
    if (browser->selected < list->count) {
        const SceneEntry *scene = &list->scenes[browser->selected];
        int top = grid->top + grid->rows * grid->height;
        SDL_Rect below = {grid->left + 4, top, grid->columns * grid->width - 8, panel->h - top};
        draw_wrapped_text(panel, font, scene->title, below,
                          scene->is_loaded && !scene->picture.pixels ? ERROR_COLOR : TEXT_COLOR);
    }
}

SDL_Surface *browser_panel_draw(const Browser *browser, const PanelBounds *bounds) {
    BrowserGrid grid = browser_panel_grid(bounds);
    TTF_Font *font = font_open();
    SDL_Surface *panel = font ? panel_create(bounds->width, bounds->height) : NULL;
    if (panel) {
        TTF_SetFontSize(font, grid.font_size);
        draw_entries(panel, font, browser, &grid);
        draw_heading_and_title(panel, font, browser, &grid);
    }
    if (font) {
        font_close(font);
    }
    return panel;
}
