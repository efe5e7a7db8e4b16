/**
 * @file
 * @brief Where things are in the window: bar, picture, lesson panel; how large letters are.
 */
#include "base/language.h"
#include "view/window_internal.h"

#include <libintl.h>
#include <math.h>

/** Rows of text that fill the height below the toolbar: with a toolbar of three rows, letters are
 *  still 1/30 of the window, which can be read from the last row of a class. */
static const float ROWS_BELOW_TOOLBAR = 26;
/** Rows of text that fill the height of the picture above the panel of a lesson: with the panel
 * they are 30, so letters are 1/30 of the window there, too. */
static const float ROWS_ABOVE_PANEL = 20;
/** Smallest height of letters, screen units. */
static const float TEXT_SIZE_MINIMUM = 14;
/** Largest part of the window's height for the bar. */
static const double TOOLBAR_FRACTION_MAXIMUM = 0.25;
/** Most times that the bar is laid out until its height and its letters agree. */
enum { LAYOUTS_MAXIMUM = 4 };
/** Factor of the size of letters in a presentation. */
static const float PRESENTATION_SCALE = 1.4F;
/** Width of the window beside the picture from which the lesson panel stands there, and not below,
 *  in heights of letters. */
static const double PANEL_WIDTH_MINIMUM = 12;
/** Largest width of the lesson panel beside the picture, in heights of letters. */
static const double PANEL_WIDTH_MAXIMUM = 20;
/** Height of the lesson panel below the picture, in heights of letters. */
static const double PANEL_HEIGHT = 10;

/* --- where the picture is --------------------------------------------------------------------- */

SDL_Rect window_picture_rect(const Window *window) {
    SDL_Rect whole = window_area(window);
    const RenderSettings *settings = &window->base_settings;
    double ratio = (double)settings->width / settings->height;
    SDL_Rect rect = whole;
    rect.h = SDL_max(1, (int)(whole.w / ratio + 0.5));
    if (rect.h > whole.h) {
        rect.h = whole.h;
        rect.w = SDL_clamp((int)(whole.h * ratio + 0.5), 1, whole.w);
    }
    rect.x += (whole.w - rect.w) / 2;
    rect.y += (whole.h - rect.h) / 2;
    return rect;
}

double window_pixels_per_unit(const Window *window) {
    int width = 0, pixels = 0, height = 0;
    SDL_GetWindowSize(window->sdl.window, &width, NULL);
    sdl_window_size(&window->sdl, &pixels, &height);
    return (double)pixels / SDL_max(1, width);
}

bool window_picture_position(const Window *window, int x, int y, double *right, double *down) {
    double scale = window_pixels_per_unit(window);
    SDL_Rect area = window_area(window);
    SDL_Rect rect = window->ray_view.is_open ? ray_view_layout(&window->ray_view, &area).inset
                                             : window_picture_rect(window);
    *right = ((x + 0.5) * scale - rect.x) / rect.w;
    *down = ((y + 0.5) * scale - rect.y) / rect.h;
    return *right >= 0 && *right < 1 && *down >= 0 && *down < 1;
}

int window_toolbar_height(const Window *window) {
    return window->gui
               ? (int)((double)window->toolbar.height * window_pixels_per_unit(window) + 0.5)
               : 0;
}

SDL_Rect window_split_off_panel(const Window *window, SDL_Rect *area) {
    const RenderSettings *settings = &window->base_settings;
    double text_scale = window->text_scale > 0 ? window->text_scale : 1;
    double least = (double)TEXT_SIZE_MINIMUM * window_pixels_per_unit(window);
    double letter = text_scale * fmax(least, area->h / (double)ROWS_BELOW_TOOLBAR);
    double beside = area->w - (double)area->h * settings->width / settings->height;
    SDL_Rect panel = {0};
    if (!window->gui || !window->lesson_panel.lesson) {
        return panel;
    }
    panel = *area;
    if (beside >= PANEL_WIDTH_MINIMUM * letter) {
        panel.w = (int)fmin(beside, PANEL_WIDTH_MAXIMUM * letter);
        area->w -= panel.w;
        panel.x += area->w;
        return panel;
    }
    // Its letters are those of a window without the panel.
    letter =
        text_scale * fmax(least, area->h / ((double)ROWS_ABOVE_PANEL + PANEL_HEIGHT * text_scale));
    panel.h = SDL_clamp((int)(PANEL_HEIGHT * letter + 0.5), 1, area->h / 2 + 1);
    area->h = SDL_max(1, area->h - panel.h);
    panel.y += area->h;
    return panel;
}

SDL_Rect window_area_below_toolbar(const Window *window) {
    SDL_Rect area = {.y = window->toolbar.is_folded ? 0 : window_toolbar_height(window)};
    sdl_window_size(&window->sdl, &area.w, &area.h);
    area.h = SDL_max(1, area.h - area.y);
    return area;
}

SDL_Rect window_area(const Window *window) {
    SDL_Rect area = window_area_below_toolbar(window);
    window_split_off_panel(window, &area);
    return area;
}

int window_used_height(const Window *window) {
    int width = 0, height = 0;
    sdl_window_size(&window->sdl, &width, &height);
    return SDL_max(0, height - window_area(window).h);
}

void window_size_below_toolbar(const Window *window, int *width, int *height) {
    SDL_GetWindowSize(window->sdl.window, width, height);
    *height -= (int)(window_used_height(window) / window_pixels_per_unit(window));
}

void window_set_size_below_toolbar(Window *window, int width, int height) {
    height += (int)(window_used_height(window) / window_pixels_per_unit(window));
    SDL_SetWindowSize(window->sdl.window, width, height);
}

SDL_Rect window_to_units(const Window *window, SDL_Rect rect) {
    double scale = window_pixels_per_unit(window);
    return (SDL_Rect){(int)(rect.x / scale), (int)(rect.y / scale), (int)(rect.w / scale),
                      (int)(rect.h / scale)};
}

GuiRect window_area_units(const Window *window) {
    SDL_Rect area = window_to_units(window, window_area(window));
    return (GuiRect){(float)area.x, (float)area.y, (float)area.w, (float)area.h};
}

/** @return A part of the window, screen units, without what the button of a folded toolbar hides.
 */
static GuiRect below_button(const Window *window, SDL_Rect pixels) {
    const SDL_Rect units = window_to_units(window, pixels);
    GuiRect area = {(float)units.x, (float)units.y, (float)units.w, (float)units.h};
    float hidden = SDL_max(0, window->toolbar.height - area.y);
    area.y += hidden;
    area.height = SDL_max(1, area.height - hidden);
    return area;
}

GuiRect window_area_below_button(const Window *window) {
    return below_button(window, window_area(window));
}

GuiRect window_whole_below_button(const Window *window) {
    return below_button(window, window_area_below_toolbar(window));
}

/** @return Size of the window, screen units. */
static SDL_Point size_in_units(const Window *window) {
    SDL_Point size;
    SDL_GetWindowSize(window->sdl.window, &size.x, &size.y);
    return size;
}

/** @return The height of letters by the height below the bar as it is, screen units. */
static float unsettled_text_size(const Window *window) {
    int width = 0, height = 0;
    double scale = window->text_scale > 0 ? window->text_scale : 1;
    scale *= window->is_presenting ? (double)PRESENTATION_SCALE : 1;
    window_size_below_toolbar(window, &width, &height);
    // The bar of the rays has the letters of the usual one: else each would change the other.
    height += (int)(window->toolbar.height - window->toolbar.usual_height);
    const float rows = window_area(window).h < window_area_below_toolbar(window).h
                           ? ROWS_ABOVE_PANEL
                           : ROWS_BELOW_TOOLBAR;
    // Whole units: the bar keeps its height while the window gains a pixel.
    return ceilf((float)scale * SDL_max(TEXT_SIZE_MINIMUM, (float)height / rows));
}

/** @return The layout of the window, its letters not settled yet. */
static TextFit new_text_fit(const Window *window) {
    const RenderSettings *settings = &window->base_settings;
    return (TextFit){.window = size_in_units(window),
                     .text_scale = window->text_scale,
                     .is_folded = window->toolbar.is_folded,
                     .is_presenting = window->is_presenting,
                     .has_lesson = window->lesson_panel.lesson != NULL,
                     .is_french = language_is_french(),
                     .aspect = (double)settings->width / settings->height,
                     .shows_rays = window->ray_view.is_open};
}

/** @return Whether two layouts have the same inputs. */
static bool is_same_layout(const TextFit *a, const TextFit *b) {
    return a->window.x == b->window.x && a->window.y == b->window.y &&
           a->text_scale == b->text_scale && a->is_folded == b->is_folded &&
           a->is_presenting == b->is_presenting && a->has_lesson == b->has_lesson &&
           a->shows_rays == b->shows_rays && a->is_french == b->is_french && a->aspect == b->aspect;
}

void window_settle_text_size(Window *window) {
    const TextFit fit = new_text_fit(window);
    if (!is_same_layout(&fit, &window->text_fit)) {
        window->text_fit = fit;
    }
    float size = unsettled_text_size(window);
    // With larger letters the bar may need another row, which leaves room for smaller ones, and
    // with these it needs a row less: this would go on for ever. Letters that have grown do not
    // shrink.
    float before = window->text_fit.height;
    window->text_fit.height = window->text_fit.has_grown ? fmaxf(size, before) : size;
    window->text_fit.has_grown = window->text_fit.has_grown || (before > 0 && size > before);
}

float window_text_size(const Window *window) {
    return window->text_fit.height;
}

/* --- the size of the window ------------------------------------------------------------------- */

/** @return Height of bar and lesson panel, pixels, when the picture keeps a height. @param picture
 *  That height, pixels. */
static int height_to_use(const Window *window, int picture) {
    SDL_Rect area = window_area_below_toolbar(window);
    bool is_below = window_split_off_panel(window, &area).y > area.y;
    double text_scale = window->text_scale > 0 ? window->text_scale : 1;
    double least = (double)TEXT_SIZE_MINIMUM * window_pixels_per_unit(window);
    double letter = text_scale * fmax(least, picture / (double)ROWS_ABOVE_PANEL);
    return area.y + (is_below ? (int)(PANEL_HEIGHT * letter + 0.5) : 0);
}

/** @return Whether the window has the size of the screen, whatever it holds. */
static bool has_fixed_size(const Window *window) {
    const Uint32 flags = SDL_GetWindowFlags(window->sdl.window);
    return flags & (SDL_WINDOW_FULLSCREEN_DESKTOP | SDL_WINDOW_MAXIMIZED);
}

/** Grows or shrinks the window by as much as bar and lesson panel, so that the picture keeps its
 *  size. @return Whether the window has another size now. */
static bool fit_window(Window *window) {
    int width = 0, height = 0;
    sdl_window_size(&window->sdl, &width, &height);
    int used = height_to_use(window, height - window->fitted_height);
    int added = used - window->fitted_height;
    if (has_fixed_size(window)) {
        window->fitted_height = used;
        return false;
    }
    SDL_GetWindowSize(window->sdl.window, &width, &height);
    int change = sdl_window_grow(&window->sdl, (int)(added / window_pixels_per_unit(window)));
    window->fitted_height += (int)(change * window_pixels_per_unit(window));
    return change != 0;
}

/** Has the bar laid out: it learns its height in one frame, and has it in the next. */
static void layout_toolbar(Window *window) {
    window_present(window);
    window_present(window);
}

void window_relayout_toolbar(Window *window) {
    layout_toolbar(window);
    for (int i = 0; i < LAYOUTS_MAXIMUM && fit_window(window); i++) {
        layout_toolbar(window); // Its letters follow the height below it.
    }
    window_on_resize(window);
}

/** @return Whether the bar takes too much of the window. */
static bool is_toolbar_large(const Window *window) {
    int width = 0, height = 0;
    sdl_window_size(&window->sdl, &width, &height);
    return window_area_below_toolbar(window).y > TOOLBAR_FRACTION_MAXIMUM * height;
}

bool window_fold_large_toolbar(Window *window) {
    bool is_large = is_toolbar_large(window);
    window->toolbar.is_folded = window->toolbar.is_folded || is_large;
    return is_large;
}

/** Shows or hides the toolbar. @return false if the window is too small: it stays hidden. */
static bool set_toolbar_folded(Window *window, bool is_folded) {
    window->hides_toolbar = window->toolbar.is_folded = is_folded;
    layout_toolbar(window);
    bool is_too_small = window_fold_large_toolbar(window);
    window_relayout_toolbar(window);
    return !is_too_small;
}

void window_open_widgets(Window *window) {
    window->gui = gui_create(window->sdl.window, window->sdl.renderer);
    window->toolbar.is_folded = true;
    if (window->gui && !window->state.is_playing) {
        window_set_hint(window);
        set_toolbar_folded(window, false);
    } else if (window->gui) {
        window->hides_toolbar = true;
        window_relayout_toolbar(window);
    }
}

void window_set_lesson_panel(Window *window, const LessonPanel *panel) {
    bool is_other = !window->lesson_panel.lesson != !panel->lesson;
    window->lesson_panel = *panel;
    window->ray_view.is_in_lesson = window->help.is_in_lesson = panel->lesson != NULL;
    if (is_other && window->gui) {
        // The window keeps its size: a class would see it jump.
        layout_toolbar(window);
        window_on_resize(window);
    } else if (window->gui) {
        window_present(window);
    }
    gui_request_frames(window->gui); // The first frame of another panel lays it out, hidden.
}

/** @return A change of the toolbar that begins. */
static ToolbarChange begin_change(const Window *window) {
    return (ToolbarChange){.was_folded = window->toolbar.is_folded,
                           .was_presenting = window->is_presenting,
                           .before = size_in_units(window)};
}

/** Ends a change of the toolbar. One that takes the last one back gives a window that nobody has
 *  resized since the size that it had: fitted to letters of whole units, it would be off by some
 *  pixels. */
static void end_change(Window *window, ToolbarChange change) {
    const ToolbarChange *last = &window->toolbar_change;
    bool is_back = last->was_folded == window->toolbar.is_folded &&
                   last->was_presenting == window->is_presenting &&
                   last->after.x == change.before.x && last->after.y == change.before.y;
    if (is_back && !has_fixed_size(window)) {
        SDL_SetWindowSize(window->sdl.window, last->before.x, last->before.y);
        layout_toolbar(window);
        window_on_resize(window);
    }
    change.after = size_in_units(window);
    window->toolbar_change = change;
}

void window_toggle_toolbar(Window *window) {
    const ToolbarChange change = begin_change(window);
    const bool is_wanted = window->toolbar.is_folded;
    if (window->is_presenting) {
        window->hides_toolbar = false;
        window_toggle_presentation(window);
    } else if (set_toolbar_folded(window, !is_wanted)) {
        end_change(window, change);
    }
    if (is_wanted && window->toolbar.is_folded) {
        window_set_toast(window, gettext("the window is too small for the toolbar"));
    }
}

void window_toggle_presentation(Window *window) {
    const ToolbarChange change = begin_change(window);
    window->is_presenting = !window->is_presenting;
    window->toolbar.is_folded = window->is_presenting || window->hides_toolbar;
    window_relayout_toolbar(window);
    end_change(window, change);
    if (window->gui) {
        gui_set_ring(window->gui, window->is_presenting);
    }
    window_present(window);
}
