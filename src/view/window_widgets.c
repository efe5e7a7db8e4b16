/**
 * @file
 * @brief Buttons, lists, marks and messages over the picture, and where the picture is.
 */
#include "view/window.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Rows of text that fill the height below the toolbar: with a toolbar of three rows, letters are
 *  still 1/30 of the window, which can be read from the last row of a class. */
static const float ROWS_BELOW_TOOLBAR = 26;
/** Smallest height of letters, screen units. */
static const float TEXT_SIZE_MINIMUM = 14;
/** Largest part of the window's height for the bar. */
static const double TOOLBAR_FRACTION_MAXIMUM = 0.25;
/** Most times that the bar is laid out until its height and its letters agree. */
enum { LAYOUTS_MAXIMUM = 4 };
/** Seconds that a message is shown. */
static const double TOAST_SECONDS = 4;
/** Seconds that the hint at the start is shown. */
static const double HINT_SECONDS = 6;
/** Room for the swatch beside the sign of a recording, in heights of letters. */
static const float RECORDING_MARGIN = 3.5F;
/** Factor of the size of letters in a presentation. */
static const float PRESENTATION_SCALE = 1.4F;
/** Width of the window beside the picture from which the lesson panel stands there, and not below,
 *  in heights of letters. */
static const double PANEL_WIDTH_MINIMUM = 12;
/** Largest width of the lesson panel beside the picture, in heights of letters. */
static const double PANEL_WIDTH_MAXIMUM = 20;
/** Height of the lesson panel below the picture, in heights of letters. */
static const double PANEL_HEIGHT = 8.5;
/** How near to a light's mark the mouse takes hold of it, in heights of letters. */
static const float MARK_REACH = 0.9F;

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

/** @return Pixels per screen unit: more than 1 on a HiDPI screen. */
static double pixels_per_unit(const Window *window) {
    int width = 0, pixels = 0, height = 0;
    SDL_GetWindowSize(window->sdl.window, &width, NULL);
    sdl_window_size(&window->sdl, &pixels, &height);
    return (double)pixels / SDL_max(1, width);
}

bool window_picture_position(const Window *window, int x, int y, double *right, double *down) {
    double scale = pixels_per_unit(window);
    SDL_Rect area = window_area(window);
    SDL_Rect rect = window->ray_view.is_open ? ray_view_layout(&window->ray_view, &area).inset
                                             : window_picture_rect(window);
    *right = ((x + 0.5) * scale - rect.x) / rect.w;
    *down = ((y + 0.5) * scale - rect.y) / rect.h;
    return *right >= 0 && *right < 1 && *down >= 0 && *down < 1;
}

int window_toolbar_height(const Window *window) {
    return window->gui ? (int)((double)window->toolbar.height * pixels_per_unit(window) + 0.5) : 0;
}

/** Divides the window between picture and lesson panel: it stands beside the picture where there is
 *  room, else below. @param[in,out] area The part below the toolbar; becomes that of the picture.
 *  @return The part of the panel, pixels; empty: it is closed. */
static SDL_Rect split_off_panel(const Window *window, SDL_Rect *area) {
    const RenderSettings *settings = &window->base_settings;
    double text_scale = window->text_scale > 0 ? window->text_scale : 1;
    double least = (double)TEXT_SIZE_MINIMUM * pixels_per_unit(window);
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
    letter = text_scale *
             fmax(least, area->h / ((double)ROWS_BELOW_TOOLBAR + PANEL_HEIGHT * text_scale));
    panel.h = SDL_clamp((int)(PANEL_HEIGHT * letter + 0.5), 1, area->h / 2 + 1);
    area->h = SDL_max(1, area->h - panel.h);
    panel.y += area->h;
    return panel;
}

/** @return The part of the window below the toolbar, pixels. */
static SDL_Rect area_below_toolbar(const Window *window) {
    SDL_Rect area = {.y = window->toolbar.is_folded ? 0 : window_toolbar_height(window)};
    sdl_window_size(&window->sdl, &area.w, &area.h);
    area.h = SDL_max(1, area.h - area.y);
    return area;
}

SDL_Rect window_area(const Window *window) {
    SDL_Rect area = area_below_toolbar(window);
    split_off_panel(window, &area);
    return area;
}

int window_used_height(const Window *window) {
    int width = 0, height = 0;
    sdl_window_size(&window->sdl, &width, &height);
    return SDL_max(0, height - window_area(window).h);
}

void window_size_below_toolbar(const Window *window, int *width, int *height) {
    SDL_GetWindowSize(window->sdl.window, width, height);
    *height -= (int)(window_used_height(window) / pixels_per_unit(window));
}

void window_set_size_below_toolbar(Window *window, int width, int height) {
    height += (int)(window_used_height(window) / pixels_per_unit(window));
    SDL_SetWindowSize(window->sdl.window, width, height);
}

/* --- messages --------------------------------------------------------------------------------- */

void window_set_state(Window *window, const WindowState *state) {
    window->state = *state;
}

void window_set_toast(Window *window, const char *text) {
    SDL_strlcpy(window->toast.text, text, sizeof window->toast.text);
    window->toast.end_time = clock_now_seconds() + TOAST_SECONDS;
    if (window->gui) {
        window_present(window);
    }
}

void window_end_toast(Window *window) {
    window->toast.end_time = 0;
}

/** Writes what a newcomer may press. */
static void set_hint(Window *window) {
    static const char *const names[] = {"light up", "light left", "light down", "light right"};
    char light[GUI_LABEL_SIZE] = "", help[GUI_LABEL_SIZE] = "";
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        help_key_names(command_find(window->help.commands, names[i]), window->help.by_letter, light,
                       sizeof light);
    }
    help_key_names(command_find(window->help.commands, "help"), window->help.by_letter, help,
                   sizeof help);
    snprintf(window->hint.text, sizeof window->hint.text,
             gettext("Drag a light, or press %s. ↑ ← ↓ → move the camera. Click a thing to "
                     "change it. Help: %s"),
             light, help);
    window->hint.end_time = clock_now_seconds() + HINT_SECONDS;
}

void window_end_hint(Window *window) {
    window->hint.end_time = 0;
}

/** Removes a message whose time is over. @return Whether it was shown until now. */
static bool toast_expire(Toast *toast, double now) {
    bool is_over = toast->text[0] != '\0' && now >= toast->end_time;
    if (is_over) {
        toast->text[0] = '\0';
    }
    return is_over;
}

/* --- frames ----------------------------------------------------------------------------------- */

/** @return Height of bar and lesson panel, pixels, when the picture keeps a height. @param picture
 *  That height, pixels. */
static int height_to_use(const Window *window, int picture) {
    SDL_Rect area = area_below_toolbar(window);
    bool is_below = split_off_panel(window, &area).y > area.y;
    double text_scale = window->text_scale > 0 ? window->text_scale : 1;
    double least = (double)TEXT_SIZE_MINIMUM * pixels_per_unit(window);
    double letter = text_scale * fmax(least, picture / (double)ROWS_BELOW_TOOLBAR);
    return area.y + (is_below ? (int)(PANEL_HEIGHT * letter + 0.5) : 0);
}

/** Grows or shrinks the window by as much as bar and lesson panel, so that the picture keeps its
 *  size. @return Whether the window has another size now. */
static bool fit_window(Window *window) {
    Uint32 flags = SDL_GetWindowFlags(window->sdl.window);
    int width = 0, height = 0;
    sdl_window_size(&window->sdl, &width, &height);
    int used = height_to_use(window, height - window->fitted_height);
    int added = used - window->fitted_height;
    if (flags & (SDL_WINDOW_FULLSCREEN_DESKTOP | SDL_WINDOW_MAXIMIZED)) {
        window->fitted_height = used;
        return false;
    }
    SDL_GetWindowSize(window->sdl.window, &width, &height);
    int change = sdl_window_grow(&window->sdl, (int)(added / pixels_per_unit(window)));
    window->fitted_height += (int)(change * pixels_per_unit(window));
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

/** Shows or hides the toolbar. @return false if the window is too small: it stays hidden. */
static bool set_toolbar_folded(Window *window, bool is_folded) {
    int width = 0, height = 0;
    window->toolbar.is_folded = is_folded;
    layout_toolbar(window);
    sdl_window_size(&window->sdl, &width, &height);
    bool is_too_small = window_area(window).y > TOOLBAR_FRACTION_MAXIMUM * height;
    window->toolbar.is_folded = is_folded || is_too_small;
    window_relayout_toolbar(window);
    return !is_too_small;
}

void window_open_widgets(Window *window) {
    window->gui = gui_create(window->sdl.window, window->sdl.renderer);
    window->toolbar.is_folded = true;
    if (window->gui && !window->state.is_playing) {
        set_hint(window);
        set_toolbar_folded(window, false);
    } else if (window->gui) {
        window_relayout_toolbar(window);
    }
}

void window_set_lesson_panel(Window *window, const LessonPanel *panel) {
    bool is_other = !window->lesson_panel.lesson != !panel->lesson;
    window->lesson_panel = *panel;
    if (is_other && window->gui) {
        window_relayout_toolbar(window);
    } else if (window->gui) {
        window_present(window);
    }
}

void window_toggle_toolbar(Window *window) {
    if (!set_toolbar_folded(window, !window->toolbar.is_folded)) {
        window_set_toast(window, gettext("the window is too small for the toolbar"));
    }
}

void window_toggle_presentation(Window *window) {
    window->is_presenting = !window->is_presenting;
    window->toolbar.is_folded = window->is_presenting;
    window_relayout_toolbar(window);
    if (window->gui) {
        gui_set_ring(window->gui, window->is_presenting);
    }
    window_present(window);
}

/** Takes the settings away that came by themselves. @return Whether they were shown until now. */
static bool expire_settings(Window *window, double now) {
    bool is_over = window->settings_end_time > 0 && now >= window->settings_end_time;
    if (is_over) {
        window->shows_settings = false;
        window->settings_end_time = 0;
        for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
            hud_invalidate(&window->huds[i]);
        }
    }
    return is_over;
}

bool window_widgets_are_due(Window *window, double now) {
    bool is_over = toast_expire(&window->toast, now);
    is_over = toast_expire(&window->hint, now) || is_over;
    is_over = toast_expire(&window->layer_name, now) || is_over;
    is_over = expire_settings(window, now) || is_over;
    return is_over || window_progress_timeout(window, now) <= 0 || gui_needs_frame(window->gui);
}

double window_widgets_timeout(const Window *window, double now) {
    const Toast *const toasts[] = {&window->toast, &window->hint, &window->layer_name};
    double delay = gui_needs_frame(window->gui) ? 0 : window_progress_timeout(window, now);
    for (size_t i = 0; i < sizeof toasts / sizeof *toasts; i++) {
        if (toasts[i]->text[0] != '\0') {
            delay = fmin(delay, fmax(0, toasts[i]->end_time - now));
        }
    }
    if (window->settings_end_time > 0) {
        delay = fmin(delay, fmax(0, window->settings_end_time - now));
    }
    return delay;
}

SDL_Rect window_to_units(const Window *window, SDL_Rect rect) {
    double scale = pixels_per_unit(window);
    return (SDL_Rect){(int)(rect.x / scale), (int)(rect.y / scale), (int)(rect.w / scale),
                      (int)(rect.h / scale)};
}

/** @return The part of the window below the toolbar, screen units. */
static GuiRect window_area_units(const Window *window) {
    SDL_Rect area = window_to_units(window, window_area(window));
    return (GuiRect){(float)area.x, (float)area.y, (float)area.w, (float)area.h};
}

/** Shows the bar. */
static void show_toolbar(Window *window) {
    const WindowState *state = &window->state;
    RenderSettings settings = window_requested_settings(window);
    ToolbarContent content = {.help = &window->help,
                              .settings = &settings,
                              .layer = window_active_viewport(window)->layer,
                              .split = window->split.mode,
                              .shows_settings = window->shows_settings,
                              .shows_rays = window->ray_view.is_open,
                              .shows_chart = window->settings_chart.is_open,
                              .shows_magnifier = window->magnifier.is_on,
                              .is_animated = state->is_animated,
                              .is_running = state->is_running,
                              .is_recording = state->is_recording};
    toolbar_show(&window->toolbar, &content);
}

/** Shows that a lesson is recorded, in the upper right corner of the picture. */
static void show_recording_sign(const Window *window, int width) {
    static const unsigned char red[3] = {230, 60, 50};
    const char *text = gettext("recording");
    float size = gui_text_size();
    if (window->state.is_recording) {
        gui_readout(text, red,
                    (GuiPoint){(float)width - gui_text_width(text) - RECORDING_MARGIN * size,
                               window->toolbar.height + 2 * size});
    }
}

/** Shows the messages at the lower edge: the newest one, else the hint. @param bottom Lower end of
 *  the room for them. */
static void show_messages(const Window *window, int width, float bottom) {
    const Toast *toast = window->toast.text[0] != '\0' ? &window->toast : &window->hint;
    if (toast->text[0] != '\0' && strcmp(toast->text, window->notice.text) != 0) {
        gui_message("toast", toast->text,
                    (GuiPoint){(float)width / 2, bottom - gui_text_size() / 2}, GUI_ABOVE);
    }
}

/** @return The height of letters, screen units. The bar does not count, as it grows with them. */
static float text_size(const Window *window) {
    int width = 0, height = 0;
    double scale = window->text_scale > 0 ? window->text_scale : 1;
    scale *= window->is_presenting ? (double)PRESENTATION_SCALE : 1;
    window_size_below_toolbar(window, &width, &height);
    // Whole units: the bar keeps its height while the window gains a pixel.
    return ceilf((float)scale * SDL_max(TEXT_SIZE_MINIMUM, (float)height / ROWS_BELOW_TOOLBAR));
}

/** Gives the mouse the shape of what it does: a hand over a light, arrows at the bar between two
 *  pictures and while something is dragged. */
static void show_cursor(const Window *window) {
    int x = 0, y = 0;
    double right = 0, down = 0;
    Uint32 buttons = SDL_GetMouseState(&x, &y);
    bool is_inside = SDL_GetMouseFocus() == window->sdl.window && !window->help.is_open &&
                     !window->browser.is_open &&
                     window_picture_position(window, x, y, &right, &down);
    if (!is_inside) {
        return;
    }
    bool is_at_bar = !window->ray_view.is_open && window_is_at_bar(window, right);
    if (window->split.is_dragged || is_at_bar) {
        gui_set_cursor(GUI_CURSOR_SIDEWAYS);
    } else if (buttons & SDL_BUTTON_LMASK) {
        gui_set_cursor(GUI_CURSOR_MOVE);
    } else if (window_light_at(window, x, y)) {
        gui_set_cursor(GUI_CURSOR_HAND);
    }
}

/** Shows the marks of the lights. */
static void show_light_marks(Window *window) {
    if (!window->ray_view.is_open && !window->toolbar.is_folded && window->state.scene) {
        SDL_Rect picture = window_to_units(window, window_picture_rect(window));
        light_marks_show(&window->light_marks, window->state.scene, &picture,
                         window->state.selected_light);
    }
}

/** Shows the help, and requests the command that is clicked there. */
static void show_help(Window *window, const GuiRect *area) {
    help_show(&window->help, area);
    if (window->help.requested) {
        window->toolbar.command = window->help.requested->name;
        window->toolbar.repetitions = 1;
        window->help.requested = NULL;
    }
}

/** Shows the selected object's outline and inspector. */
static void show_object_inspector(Window *window) {
    const WindowState *state = &window->state;
    ObjectInspector *inspector = &window->object_inspector;
    SDL_Rect picture = window_to_units(window, window_picture_rect(window));
    SceneObject object;
    bool is_light = inspector->number > 0 && !scene_object_is_shape(inspector->keyword) &&
                    scene_object_find(state->scene, inspector->keyword, inspector->number, &object);
    if (!state->scene || window->ray_view.is_open) {
        return;
    }
    object_inspector_outline(inspector, state->scene, &picture);
    const ObjectInspectorContent content = {.scene = state->scene,
                                            .history = state->edits,
                                            .is_light_moved =
                                                is_light && state->is_light_moved[object.index],
                                            .is_read_only = state->is_playing,
                                            .top = window->toolbar.height};
    object_inspector_show(inspector, &content);
}

/** Shows list, formulas and numbers of the rays, if they are shown. */
static void show_rays(Window *window) {
    bool is_covered = window->help.is_open || window->browser.is_open;
    if (window->ray_view.is_open && !is_covered && window->state.scene) {
        double scale = pixels_per_unit(window);
        SDL_Rect area = window_to_units(window, window_area(window));
        ray_view_show_widgets(&window->ray_view, window->state.scene, &window->help, &area, scale);
    }
}

/** Shows the panel of the lesson that plays. */
static void show_lesson_panel(Window *window) {
    SDL_Rect area = area_below_toolbar(window), panel = split_off_panel(window, &area);
    if (window->lesson_panel.lesson) {
        panel = window_to_units(window, panel);
        lesson_panel_show(&window->lesson_panel, &panel);
    }
}

/** @return The part of the window for panels: below the bar, or below its button if it is folded.
 */
static GuiRect area_below_button(const Window *window) {
    GuiRect area = window_area_units(window);
    float hidden = SDL_max(0, window->toolbar.height - area.y);
    area.y += hidden;
    area.height = SDL_max(1, area.height - hidden);
    return area;
}

void window_show_widgets(Window *window) {
    int width = 0, height = 0;
    if (!window->gui) {
        return;
    }
    SDL_GetWindowSize(window->sdl.window, &width, &height);
    gui_begin_frame(window->gui, text_size(window));
    window->toolbar.height = 0;
    // The button of a folded bar would cover the words of a lesson or of rays.
    bool has_words = window->lesson_panel.lesson || window->ray_view.is_open;
    if (!window->is_presenting && !(window->toolbar.is_folded && has_words)) {
        show_toolbar(window);
    }
    show_cursor(window);
    GuiRect area = area_below_button(window);
    float bottom = area.y + area.height;
    window->light_marks.count = 0;
    if (window->help.is_open) {
        show_help(window, &area);
    } else if (window->browser.is_open) {
        browser_show(&window->browser, window->sdl.renderer, &area);
    } else {
        show_light_marks(window);
        show_object_inspector(window);
        window_follow_mouse(window);
        window_show_values(window);
        window_show_readout(window);
        show_rays(window);
        window_show_progress(window);
        show_lesson_panel(window);
        area.height = SDL_max(1, area.height - gui_readout_height());
        bottom = window_show_panels(window, &area);
    }
    show_recording_sign(window, width);
    show_messages(window, width, bottom);
    if (window->layer_name.text[0] != '\0') {
        gui_title(window->layer_name.text, (GuiPoint){(float)width / 2, area.y + gui_text_size()});
    }
    gui_end_frame(window->gui);
}

bool window_ray_at(const Window *window, int x, int y, size_t *ray) {
    double scale = pixels_per_unit(window);
    SDL_Rect area = window_area(window);
    return ray_view_ray_at(&window->ray_view, (x + 0.5) * scale, (y + 0.5) * scale, &area, ray);
}

void window_show_panels_alone(Window *window) {
    if (!window->gui) {
        return;
    }
    GuiRect area = window_area_units(window);
    gui_begin_frame(window->gui, text_size(window));
    window_show_values(window);
    show_rays(window);
    window_show_panels(window, &area);
    gui_end_frame(window->gui);
    gui_request_frames(window->gui);
}

const LightMark *window_light_at(const Window *window, int x, int y) {
    return light_marks_at(&window->light_marks, (GuiPoint){(float)x, (float)y},
                          MARK_REACH * text_size(window));
}

bool window_drag_offset(const Window *window, size_t light, GuiPoint from, GuiPoint to,
                        bool is_along, Vec3d *offset) {
    SDL_Rect picture = window_to_units(window, window_picture_rect(window));
    return window->state.scene && light_marks_drag_offset(window->state.scene, light, &picture,
                                                          from, to, is_along, offset);
}

bool window_drag_offset_at(const Window *window, Vec3d point, const PictureDrag *drag,
                           Vec3d *offset) {
    SDL_Rect picture = window_to_units(window, window_picture_rect(window));
    return window->state.scene &&
           picture_drag_offset(&window->state.scene->camera, point, &picture, drag, offset);
}
