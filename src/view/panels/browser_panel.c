/**
 * @file
 * @brief Showing the list of scenes.
 */
#include "view/panels/browser.h"

#include "base/language.h"

#include <libintl.h>
#include <stdio.h>

/** Height of the part above the thumbnails, in heights of letters. */
static const float HEADER_HEIGHT = 4.2F;
/** Height of the part below them, for the title of the selected scene. */
static const float FOOTER_HEIGHT = 3;
/** Largest part of the room for each of both. */
static const float PART_MAXIMUM = 0.3F;
/** Bytes of the header with the final zero. */
enum { HEADER_SIZE = 256 };

/** @return The texture of a thumbnail, made when it is first shown; NULL: it is not drawn yet. */
static SDL_Texture *thumbnail_texture(Browser *browser, size_t index, SDL_Renderer *renderer) {
    const Picture *picture = &browser->list.scenes[index].picture;
    if (!browser->textures[index] && picture->pixels) {
        SDL_Texture *texture =
            SDL_CreateTexture(renderer, SDL_PIXELFORMAT_RGB24, SDL_TEXTUREACCESS_STATIC,
                              picture->width, picture->height);
        if (texture) {
            SDL_UpdateTexture(texture, NULL, picture->pixels, 3 * picture->width);
            SDL_SetTextureScaleMode(texture, SDL_ScaleModeLinear);
        }
        browser->textures[index] = texture;
    }
    return browser->textures[index];
}

/** Shows the buttons that go to the lessons and to the scenes. @return The #BrowserPart whose
 * button was clicked; -1: none. */
static int show_parts(const Browser *browser, const BrowserOrder *order) {
    const char *const names[] = {
        [BROWSER_LESSONS] = gettext("Lessons"), [BROWSER_SCENES] = gettext("Scenes")};
    const size_t counts[] = {
        [BROWSER_LESSONS] = order->lessons, [BROWSER_SCENES] = order->count - order->lessons};
    int clicked = -1;
    for (int i = BROWSER_LESSONS; i <= BROWSER_SCENES; i++) {
        char label[HEADER_SIZE];
        snprintf(label, sizeof label, "%s (%zu)", names[i], counts[i]);
        if (i > BROWSER_LESSONS) {
            gui_same_line(label);
        }
        const bool is_here = counts[i] > 0 && (int)browser_part(browser, order) == i;
        if (gui_step_button(label, gettext("go there — Tab"), counts[i] > 0, is_here)) {
            clicked = i;
        }
    }
    return clicked;
}

/** Writes what is searched, and shows the buttons that go through the list and close it. @return
 * See #show_parts. */
static int show_header(Browser *browser, const BrowserOrder *order, const GuiRect *rect) {
    const char *close = gettext("✕ close");
    gui_panel_begin("scenes header", rect);
    const int part = show_parts(browser, order);
    gui_at_right(close);
    if (gui_step_button(close, gettext("back to the picture — Esc"), true, false)) {
        browser->is_close_requested = true;
    }
    gui_search_box(browser->filter, gettext("Type to search; click, or arrows and Enter"));
    gui_panel_end();
    return part;
}

/** @return Whether a scene could not be loaded. */
static bool is_faulty_scene(const SceneEntry *scene) {
    return scene->is_loaded && !scene->picture.pixels;
}

/** Writes title, length and first words of a lesson. */
static void show_summary(const SceneEntry *lesson) {
    const LessonSummary *summary = &lesson->summary;
    char line[2 * SCENE_TITLE_SIZE + 3 * HEADER_SIZE], steps[HEADER_SIZE], questions[HEADER_SIZE];
    snprintf(steps, sizeof steps, ngettext("%d step", "%d steps", (unsigned long)summary->steps),
             summary->steps);
    snprintf(questions, sizeof questions,
             ngettext("%d question", "%d questions", (unsigned long)summary->questions),
             summary->questions);
    // Below its picture a very long title is cut.
    snprintf(line, sizeof line, "%s%s%s, %s%s%s", lesson->title, gettext(": "), steps, questions,
             summary->first_words[0] != '\0' ? " — " : "", summary->first_words);
    gui_paragraph(line, GUI_COLOR_TEXT, 1);
}

/** Writes the title of the scene that is described, or its error; of a lesson, what it is about. */
static void show_footer(const Browser *browser, const BrowserOrder *order, const GuiRect *rect) {
    gui_panel_begin("scenes footer", rect);
    if (order->count > 0 && browser->described < browser->list.count) {
        const SceneEntry *scene = &browser->list.scenes[browser->described];
        bool is_faulty = is_faulty_scene(scene);
        if (scene->is_lesson && !is_faulty && scene->summary.steps > 0) {
            show_summary(scene);
        } else {
            gui_paragraph(scene->title, is_faulty ? GUI_COLOR_ERROR : GUI_COLOR_TEXT, 1);
        }
    }
    gui_panel_end();
}

/** @return What stands below the picture of a scene: the title of a lesson, else its name with
 *  spaces, where it can be broken into lines. @param[out] name Room for it. */
static const char *name_below(const SceneEntry *scene, char name[SCENE_ENTRY_NAME_SIZE]) {
    if (scene->is_lesson && !is_faulty_scene(scene)) {
        return scene->title;
    }
    SDL_strlcpy(name, scene->label, SCENE_ENTRY_NAME_SIZE);
    for (char *c = name; *c; c++) {
        *c = *c == '-' ? ' ' : *c;
    }
    return name;
}

/** @return Height of the names of a line of thumbnails: those of a line are equally high. @param
 *  first Position of its first scene. @param end Behind the last one of all. */
static float line_name_height(const Browser *browser, const BrowserOrder *order, size_t first,
                              size_t end, float width) {
    float height = 0;
    for (size_t i = first; i < end && i < first + (size_t)browser->columns; i++) {
        char name[SCENE_ENTRY_NAME_SIZE];
        const SceneEntry *scene = &browser->list.scenes[order->indices[i]];
        height = SDL_max(height, gui_thumbnail_name_height(name_below(scene, name), width));
    }
    return height;
}

/** Shows some scenes of the order. @param first First position. @param end Behind the last one. */
static void show_part(Browser *browser, const BrowserOrder *order, size_t first, size_t end,
                      SDL_Renderer *renderer) {
    float width = gui_thumbnail_width(&browser->columns), name_height = 0;
    for (size_t i = first; i < end; i++) {
        size_t index = order->indices[i];
        SceneEntry *scene = &browser->list.scenes[index];
        bool is_selected = index == browser->selected;
        bool is_faulty = is_faulty_scene(scene);
        char name[SCENE_ENTRY_NAME_SIZE];
        const int column = (int)((i - first) % (size_t)browser->columns);
        if (column == 0) {
            name_height = line_name_height(browser, order, i, end, width);
        }
        const GuiThumbnail thumbnail = {.texture = thumbnail_texture(browser, index, renderer),
                                        .name = name_below(scene, name),
                                        .name_height = name_height,
                                        .message = is_faulty          ? "⚠"
                                                   : scene->is_loaded ? NULL
                                                                      : "…",
                                        .color = is_faulty ? GUI_COLOR_ERROR : GUI_COLOR_FAINT,
                                        .is_selected = is_selected,
                                        .scrolls_to_it = is_selected && browser->scrolls};
        GuiMouse mouse = gui_thumbnail((int)index, &thumbnail, column, width, &scene->is_in_sight);
        browser->described =
            mouse == GUI_IDLE || !browser->follows_mouse ? browser->described : index;
        if (mouse == GUI_CLICKED) {
            browser->selected = index;
            browser->is_requested = true;
        }
    }
}

/** Shows the thumbnails. */
static void show_scenes(Browser *browser, const BrowserOrder *order, const GuiRect *rect,
                        SDL_Renderer *renderer) {
    browser->follows_mouse = browser->follows_mouse || gui_mouse_has_moved();
    gui_gallery_begin("scenes", rect);
    browser->described = browser->selected;
    if (order->lessons > 0) {
        gui_heading(gettext("Lessons"));
        show_part(browser, order, 0, order->lessons, renderer);
    }
    if (order->count > order->lessons) {
        gui_heading(gettext("Scenes"));
        show_part(browser, order, order->lessons, order->count, renderer);
    }
    if (order->count == 0) {
        gui_paragraph(gettext("nothing found"), GUI_COLOR_FAINT, 1);
    }
    browser->scrolls = false;
    gui_panel_end();
}

void browser_show(Browser *browser, SDL_Renderer *renderer, const GuiRect *room) {
    if (!browser->is_open || !browser->list.is_started) {
        return;
    }
    const float size = gui_text_size(), most = PART_MAXIMUM * room->height;
    GuiRect header = *room, scenes = *room, footer = *room;
    header.height = SDL_min(HEADER_HEIGHT * size, most);
    footer.height = SDL_min(FOOTER_HEIGHT * size, most);
    footer.y = room->y + room->height - footer.height;
    scenes.y = header.y + header.height;
    scenes.height = SDL_max(1, footer.y - scenes.y);
    BrowserOrder order;
    scene_list_lock(&browser->list);
    browser_order(browser, &order);
    const int part = show_header(browser, &order, &header);
    show_scenes(browser, &order, &scenes, renderer);
    show_footer(browser, &order, &footer);
    scene_list_unlock(&browser->list);
    if (part >= 0) {
        browser_go_to(browser, (BrowserPart)part); // It locks the list.
    }
}
