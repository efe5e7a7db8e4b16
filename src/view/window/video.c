/**
 * @file
 * @brief SDL's video, set up for a window among others.
 */
#include "view/window/video.h"

#include "view/window/x11_errors.h"

#include <SDL.h>
#include <libintl.h>
#include <locale.h>
#include <string.h>

/**
 * @return Whether SDL has a screen that somebody can see. Without one it takes a driver that shows
 *         nothing; that is only right for who asked for it by `SDL_VIDEODRIVER`.
 */
static bool has_visible_screen(void) {
    static const char *const headless[] = {"offscreen", "dummy", "evdev"};
    const char *driver = SDL_GetCurrentVideoDriver();
    const char *display = SDL_getenv("DISPLAY");
    const char *hint = SDL_GetHint(SDL_HINT_VIDEODRIVER);
    bool is_requested = hint && *hint;
    for (size_t i = 0; i < sizeof headless / sizeof headless[0]; i++) {
        if (strcmp(driver, headless[i]) == 0 && !is_requested) {
            if (display) {
                SDL_SetError(gettext("DISPLAY is not to be opened: %s"), display);
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
    /* Xlib turns titles from UTF-8 by the locale; in the plain "C" one it fails at their signs. */
    setlocale(LC_CTYPE, "C.UTF-8");
    /* Ctrl-C is ours, see interrupt.h. */
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    /* A window among others, not a game: the screen may sleep, the compositor stays on. */
    SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
    SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
    x11_errors_install();
    if (SDL_Init(SDL_INIT_VIDEO) != 0 || !has_visible_screen()) {
        return error_set(error, STATUS_FAILED,
                         "no display to open a window on (%s); `dioptre render` draws without one",
                         SDL_GetError());
    }
    /* Keys are keys here: no input method should swallow or compose them. */
    SDL_StopTextInput();
    return true;
}
