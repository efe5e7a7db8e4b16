/**
 * @file
 * @brief Messages on the picture: toasts, the hint at the start, the sign of a recording; and when
 *        anything on it changes by itself.
 */
#include "view/window_internal.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Seconds that a message is shown. */
static const double TOAST_SECONDS = 4;
/** Seconds that the hint at the start is shown. */
static const double HINT_SECONDS = 6;
/** Least width of the room beside the inspector for messages, in heights of letters. */
static const float LEAST_ROOM = 10;
/** Room for the swatch beside the sign of a recording, in heights of letters. */
static const float RECORDING_MARGIN = 3.5F;

void window_set_toast(Window *window, const char *text) {
    SDL_strlcpy(window->toast.text, text, sizeof window->toast.text);
    window->toast.end_time = clock_now_seconds() + TOAST_SECONDS;
    if (window->gui) {
        window_present(window);
    }
}

void window_keep_toast(Window *window) {
    window->toast.end_time = HUGE_VAL;
}

void window_end_toast(Window *window) {
    window->toast.end_time = 0;
}

void window_set_hint(Window *window) {
    static const char *const names[] = {"light up", "light left", "light down", "light right"};
    char light[GUI_LABEL_SIZE] = "", help[GUI_LABEL_SIZE] = "";
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        help_key_names(&window->help, command_find(window->help.commands, names[i]), light,
                       sizeof light);
    }
    help_key_names(&window->help, command_find(window->help.commands, "help"), help, sizeof help);
    snprintf(window->hint.text, sizeof window->hint.text,
             gettext("Move a light: drag it, or press %s. The arrow keys move the camera. Click a "
                     "thing to change it. Help: %s"),
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

void window_show_recording_sign(const Window *window, int width) {
    static const unsigned char red[3] = {230, 60, 50};
    const char *text = gettext("recording");
    const Readout *readout = &window->readout;
    const float size = gui_text_size();
    const float above = readout->is_above ? readout->rect.height : 0;
    if (window->state.is_recording) {
        const GuiPoint corner = {(float)width - gui_text_width(text) - RECORDING_MARGIN * size,
                                 window->toolbar.height + above + 2 * size};
        gui_readout("recording", text, red, &(GuiReadoutPlace){corner, (float)width, GUI_ABOVE});
    }
}

/** @return Whether help or list lie over the picture. */
static bool is_covered(const Window *window) {
    return window->help.is_open || window->browser.is_open;
}

/** @return The message at the lower edge: the newest one, else the hint; empty: none. */
static const char *message_text(const Window *window) {
    // The hint is about the picture: it would shine through the list or the help.
    const char *hint = is_covered(window) ? "" : window->hint.text;
    const char *text = window->toast.text[0] != '\0' ? window->toast.text : hint;
    return strcmp(text, window->notice.text) == 0 ? "" : text;
}

/** Finds the room of messages: beside the inspector where that is wide enough, else the window.
 *  @param[out] middle Its middle. @return Its width. */
static float find_room(const Window *window, float *middle) {
    int width = 0;
    const SDL_Rect beside = window_area_beside_inspector(window);
    SDL_GetWindowSize(window->sdl.window, &width, NULL);
    const bool is_beside = !is_covered(window) && gui_inspector_rect().width > 0 &&
                           (float)beside.w >= LEAST_ROOM * gui_text_size();
    *middle = is_beside ? (float)beside.x + (float)beside.w / 2 : (float)width / 2;
    return is_beside ? (float)beside.w : (float)width;
}

float window_messages_height(const Window *window) {
    const char *text = message_text(window);
    float middle;
    const float room = find_room(window, &middle);
    return text[0] != '\0' ? gui_message_size(text, room).y + gui_text_size() / 2 : 0;
}

/** @return The lower edge of a message: above the legends that it would hide, where there is room.
 *  @param middle Its middle. @param low Where it would be. */
static float above_legends(const Window *window, GuiPoint size, float middle, float low) {
    const GuiRect message = {middle - size.x / 2, low - size.y, size.x, size.y};
    float edge = low;
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        const GuiRect *legend = &window->legend_rects[i];
        if (rects_overlap(&message, legend)) {
            edge = fminf(edge, legend->y - gui_text_size() / 4);
        }
    }
    return edge - size.y > window->toolbar.height ? edge : low;
}

void window_show_messages(const Window *window, float bottom) {
    const char *text = message_text(window);
    float middle, edge = bottom - gui_text_size() / 2;
    const float room = find_room(window, &middle);
    if (text[0] != '\0') {
        edge = is_covered(window)
                   ? edge
                   : above_legends(window, gui_message_size(text, room), middle, edge);
        gui_message("toast", text, room, (GuiPoint){middle, edge}, GUI_ABOVE);
    }
}

/* --- what changes by itself ------------------------------------------------------------------- */

/** Takes the settings away that came by themselves. @return Whether they were shown until now. */
static bool expire_settings(Window *window, double now) {
    bool is_over = window->settings_end_time > 0 && now >= window->settings_end_time;
    if (is_over) {
        window_end_settings(window);
    }
    return is_over;
}

bool window_widgets_are_due(Window *window, double now) {
    bool is_over = toast_expire(&window->toast, now);
    is_over = toast_expire(&window->hint, now) || is_over;
    is_over = toast_expire(&window->layer_name, now) || is_over;
    is_over = expire_settings(window, now) || is_over;
    return is_over || window_progress_timeout(window, now) <= 0 ||
           gui_timeout(window->gui, now) <= 0 || gui_needs_frame(window->gui);
}

double window_widgets_timeout(const Window *window, double now) {
    const Toast *const toasts[] = {&window->toast, &window->hint, &window->layer_name};
    double delay = gui_needs_frame(window->gui) ? 0 : window_progress_timeout(window, now);
    delay = fmin(delay, gui_timeout(window->gui, now));
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
