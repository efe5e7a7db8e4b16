/**
 * @file
 * @brief Drawing the list of scenes.
 */
#include "view/browser_panel.h"

#include "dioptre/language.h"
#include "view/font.h"
#include "view/rows.h"

#include <libintl.h>
#include <string.h>

/** Colour of the words. */
static const SDL_Color WORDS = {240, 240, 240, SDL_ALPHA_OPAQUE};
/** Colour of the heading, and around the chosen scene. */
static const SDL_Color CHOSEN = {255, 205, 90, SDL_ALPHA_OPAQUE};
/** Colour of what is wrong. */
static const SDL_Color WRONG = {255, 160, 130, SDL_ALPHA_OPAQUE};
/** Colour where there is no picture yet. */
static const SDL_Color EMPTY = {42, 46, 58, SDL_ALPHA_OPAQUE};

BrowserGrid browser_grid(const PanelRoom *room) {
    /** Pixels that a picture is wide about, in a window of usual size. */
    const int usual = 155;
    const int letters = SDL_clamp((int)(room->height / 34 * room->scale), 8, 60);
    int columns = SDL_clamp((int)(room->width / (usual * SDL_max(1, room->height / 600.0))), 1, 8);
    BrowserGrid grid = {.columns = columns, .letters = letters, .top = 2 * letters};
    grid.width = SDL_max(8, (room->width - letters) / columns);
    grid.height = (grid.width - 8) * 3 / 4 + 8 + letters * 3 / 2;
    grid.left = (room->width - columns * grid.width) / 2;
    grid.rows = SDL_max(1, (room->height - grid.top - 4 * letters) / grid.height);
    return grid;
}

/** Fills a part of the panel. @param panel The panel. @param area Which. @param color The colour.
 */
static void fill(SDL_Surface *panel, const SDL_Rect *area, SDL_Color color) {
    SDL_FillRect(panel, area, SDL_MapRGBA(panel->format, color.r, color.g, color.b, color.a));
}

/** Draws a scene's picture. @param panel The panel. @param picture The picture. @param area Where
 *  to. */
static void draw_picture(SDL_Surface *panel, const Picture *picture, SDL_Rect area) {
    SDL_Surface *small =
        SDL_CreateRGBSurfaceWithFormatFrom(picture->pixels, picture->width, picture->height, 24,
                                           3 * picture->width, SDL_PIXELFORMAT_RGB24);
    if (small) {
        SDL_BlitScaled(small, NULL, panel, &area);
        SDL_FreeSurface(small);
    }
}

/** Writes words in rows. @param panel The panel. @param font The letters. @param words The words.
 *  @param area Where; what does not fit is left out. @param color Their colour. */
static void write_rows(SDL_Surface *panel, TTF_Font *font, const char *words, SDL_Rect area,
                       SDL_Color color) {
    char copy[LISTED_TITLE_SIZE];
    PanelRow rows[12];
    const int line = TTF_FontLineSkip(font), letter = SDL_max(1, font_width(font, "n"));
    size_t most = (size_t)SDL_clamp(area.h / line, 0, 12);
    SDL_strlcpy(copy, words, sizeof copy);
    size_t count = rows_cut(copy, SDL_max(1, area.w / letter), rows, most);
    for (size_t i = 0; i < count; i++) {
        font_write(panel, font, rows[i].text, color, area.x, area.y + (int)i * line);
    }
}

/** Draws a scene. @param panel The panel. @param font The letters. @param scene The scene.
 *  @param cell Where. @param is_chosen Whether it is the chosen one. */
static void draw_scene(SDL_Surface *panel, TTF_Font *font, const ListedScene *scene, SDL_Rect cell,
                       bool is_chosen) {
    /** Pixels between pictures, which is also the frame of the chosen one. */
    const int frame = 4;
    SDL_Rect area = {cell.x + frame, cell.y + frame, cell.w - 2 * frame,
                     (cell.w - 2 * frame) * 3 / 4};
    SDL_Rect around = {area.x - frame, area.y - frame, area.w + 2 * frame, area.h + 2 * frame};
    if (is_chosen) {
        fill(panel, &around, CHOSEN);
    }
    fill(panel, &area, EMPTY);
    if (scene->picture.pixels) {
        draw_picture(panel, &scene->picture, area);
    } else {
        SDL_Rect words = {area.x + frame, area.y + frame, area.w - 2 * frame, area.h - 2 * frame};
        SDL_SetClipRect(panel, &words);
        write_rows(panel, font, scene->is_done ? scene->title : "…", words,
                   scene->is_done ? WRONG : WORDS);
    }
    SDL_SetClipRect(panel, &cell);
    font_write(panel, font, scene->name, is_chosen ? CHOSEN : WORDS, area.x,
               area.y + area.h + frame);
    SDL_SetClipRect(panel, NULL);
}

/** Draws all scenes that are seen. @param panel The panel. @param font The letters. @param browser
 *  The list. @param grid Where they stand. */
static void draw_scenes(SDL_Surface *panel, TTF_Font *font, const Browser *browser,
                        const BrowserGrid *grid) {
    for (int i = 0; i < grid->rows * grid->columns; i++) {
        size_t index = browser->first_row * (size_t)grid->columns + (size_t)i;
        SDL_Rect cell = {grid->left + i % grid->columns * grid->width,
                         grid->top + i / grid->columns * grid->height, grid->width, grid->height};
        if (index < browser->list.count) {
            draw_scene(panel, font, &browser->list.scenes[index], cell, index == browser->selected);
        }
    }
}

/** Writes what stands around the scenes: a heading above, the chosen one's words below.
 *  @param panel The panel. @param font The letters. @param browser The list. @param grid Where the
 *  scenes stand. */
static void write_words(SDL_Surface *panel, TTF_Font *font, const Browser *browser,
                        const BrowserGrid *grid) {
    const SceneList *list = &browser->list;
    char heading[PATH_MAX + 128];
    snprintf(heading, sizeof heading, gettext("Scene %zu of %zu — arrows, Enter, Esc"),
             list->count ? browser->selected + 1 : 0, list->count);
    font_write(panel, font, heading, CHOSEN, grid->left + 4, grid->letters / 3);
    if (browser->selected < list->count) {
        const ListedScene *scene = &list->scenes[browser->selected];
        int top = grid->top + grid->rows * grid->height;
        SDL_Rect below = {grid->left + 4, top, grid->columns * grid->width - 8, panel->h - top};
        write_rows(panel, font, scene->title, below,
                   scene->is_done && !scene->picture.pixels ? WRONG : WORDS);
    }
}

SDL_Surface *browser_draw(const Browser *browser, const PanelRoom *room) {
    BrowserGrid grid = browser_grid(room);
    TTF_Font *font = font_open();
    SDL_Surface *panel = font ? panel_create(room->width, room->height) : NULL;
    if (panel) {
        TTF_SetFontSize(font, grid.letters);
        draw_scenes(panel, font, browser, &grid);
        write_words(panel, font, browser, &grid);
    }
    if (font) {
        font_close(font);
    }
    return panel;
}
