/**
 * @file
 * @brief Starting SDL's video for an ordinary desktop window; errors of X11.
 */
#include "view/window/sdl_window.h"

#include <dlfcn.h>
#include <libintl.h>
#include <locale.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/** Xlib calls it when the connection is lost; must not return. The argument is Xlib's `Display`. */
typedef int (*IoErrorHandler)(void *display);

/** Xlib's XSetIOErrorHandler: sets the handler, returns the previous one. */
typedef IoErrorHandler (*SetIoErrorHandler)(IoErrorHandler handler);

/** Xlib calls it when a request fails. The arguments are Xlib's `Display` and `XErrorEvent`. */
typedef int (*ErrorHandler)(void *display, void *event);

/** Xlib's XSetErrorHandler: sets the handler, returns the previous one. */
typedef ErrorHandler (*SetErrorHandler)(ErrorHandler handler);

/** Reports that the display is gone, and ends the program. Pictures are written to temporary files
 *  and renamed, so none is left incomplete; standard output is flushed. @return Never. */
static int on_connection_lost(void *display) {
    (void)display;
    const char *message = gettext("dioptre: the display went away\n");
    fflush(stdout);
    ssize_t written = write(STDERR_FILENO, message, strlen(message));
    (void)written;
    _exit(STATUS_FAILED);
}

/** Ignores a failed request. Xlib's own handler would end the program for a harmless failure, such
 *  as a message to a window that was just closed. @return Anything; Xlib ignores it. */
static int on_request_failed(void *display, void *event) {
    (void)display;
    (void)event;
    return 0;
}

/** Finds a function of Xlib. C has no cast from a data pointer to a function pointer; POSIX makes
 *  them equal in size. @param[out] function Its address; NULL: none. @param size Bytes of it. */
static void find_function(void *library, const char *name, void *function, size_t size) {
    void *address = dlsym(library, name);
    memcpy(function, &address, size);
}

/**
 * Installs handlers of X11 errors: when the X server vanishes, the program reports it and ends with
 * status 1; when a single request fails, it continues. Other display systems send an event instead.
 * SDL 2 cannot set these handlers, so libX11 is opened like SDL does, if it is installed. SDL keeps
 * the handler of failed requests that it finds at its start, so this must run before.
 */
static void install_x11_error_handlers(void) {
    // The library stays open: its handlers are needed until the program ends.
    void *library = dlopen("libX11.so.6", RTLD_LAZY);
    if (library) {
        SetIoErrorHandler set_lost = NULL;
        SetErrorHandler set_request = NULL;
        find_function(library, "XSetIOErrorHandler", &set_lost, sizeof set_lost);
        find_function(library, "XSetErrorHandler", &set_request, sizeof set_request);
        if (set_lost && set_request) {
            set_lost(on_connection_lost);
            set_request(on_request_failed);
        }
    }
}

/** @return Whether SDL has a visible screen. Without one it chooses a driver that shows nothing,
 *  which is accepted only if `SDL_VIDEODRIVER` asks for it. */
static bool has_visible_screen(void) {
    static const char *const headless[] = {"offscreen", "dummy", "evdev"};
    const char *driver = SDL_GetCurrentVideoDriver();
    const char *display = SDL_getenv("DISPLAY");
    const char *hint = SDL_GetHint(SDL_HINT_VIDEODRIVER);
    bool is_requested = hint && *hint;
    for (size_t i = 0; i < sizeof headless / sizeof headless[0]; i++) {
        if (strcmp(driver, headless[i]) == 0 && !is_requested) {
            if (display) {
                SDL_SetError(gettext("DISPLAY cannot be opened: %s"), display);
            } else {
                SDL_SetError("%s", gettext("DISPLAY is not set"));
            }
            return false;
        }
    }
    return true;
}

bool video_start(Error *error) {
    SDL_SetHint(SDL_HINT_APP_NAME, "dioptre");
    // Xlib converts titles from UTF-8 by the locale; the "C" locale fails at non-ASCII characters.
    setlocale(LC_CTYPE, "C.UTF-8");
    // Signals are handled by view/input/signal_thread.c.
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    // A desktop window, not a game: the screen may sleep, the compositor stays on.
    SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
    SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
    install_x11_error_handlers();
    if (SDL_Init(SDL_INIT_VIDEO) != 0 || !has_visible_screen()) {
        return error_set(error, STATUS_FAILED,
                         "no display to open a window on (%s); `dioptre render` draws without one",
                         SDL_GetError());
    }
    // Keys are commands: no input method should compose them.
    SDL_StopTextInput();
    return true;
}
