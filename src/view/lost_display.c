/**
 * @file
 * @brief What happens when the display goes away.
 *
 * Xlib calls a handler when the connection breaks and ends the program when the handler returns;
 * SDL 2 offers no way to set that handler. So it is looked up in the libX11 that SDL has loaded
 * already: the program itself needs no X11 to be built or to start.
 */
#include "view/lost_display.h"

#include "dioptre/error.h"

#include <SDL_syswm.h>
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/** Told by Xlib that the connection broke; must not return. The argument is Xlib's `Display`. */
typedef int (*LostHandler)(void *display);

/** Xlib's XSetIOErrorHandler: sets the handler, returns the one before. */
typedef LostHandler (*SetLostHandler)(LostHandler handler);

/** Told by Xlib that one request failed. The arguments are Xlib's `Display` and `XErrorEvent`. */
typedef int (*RequestHandler)(void *display, void *event);

/** Xlib's XSetErrorHandler: sets the handler, returns the one before. */
typedef RequestHandler (*SetRequestHandler)(RequestHandler handler);

/** Xlib's XSync: waits until all requests are answered. */
typedef int (*Synchronize)(void *display, int discard);

/**
 * Says that the display is gone and ends the program. Pictures are written beside their place and
 * renamed, so none is left half done; what was printed is kept.
 * @param display  Xlib's display, broken.
 * @return Never.
 */
static int end_program(void *display) {
    (void)display;
    static const char words[] = "dioptre: the display went away\n";
    fflush(stdout);
    ssize_t written = write(STDERR_FILENO, words, sizeof words - 1);
    (void)written;
    _exit(STATUS_FAILED);
}

/**
 * Passes over a failed request. Xlib's own handler would end the program, although nothing is lost:
 * a message to a window that has just been closed, as when full screen is left and the program
 * after it.
 * @param display  Xlib's display.
 * @param event    What failed.
 * @return Anything; Xlib does not look.
 */
static int pass_over(void *display, void *event) {
    (void)display;
    (void)event;
    return 0;
}

/**
 * Finds a function of Xlib. C has no cast from an object's address to a function's; POSIX says that
 * they are alike.
 * @param library        The open library.
 * @param name           The function.
 * @param[out] function  Its address, of `size` bytes; zero where there is none.
 * @param size           Bytes of a function's address.
 */
static void find_function(void *library, const char *name, void *function, size_t size) {
    void *address = dlsym(library, name);
    memcpy(function, &address, size);
}

void lost_display_prepare(void) {
    void *library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
    if (library) {
        SetLostHandler set_lost = NULL;
        SetRequestHandler set_request = NULL;
        find_function(library, "XSetIOErrorHandler", &set_lost, sizeof set_lost);
        find_function(library, "XSetErrorHandler", &set_request, sizeof set_request);
        if (set_lost && set_request) {
            set_lost(end_program);
            set_request(pass_over);
        }
        dlclose(library);
    }
}

/** @return The X display that a window is on; NULL where it is on another display system.
 *  @param window The window. */
static void *display_of(SDL_Window *window) {
    SDL_SysWMinfo info;
    SDL_VERSION(&info.version);
#if defined(SDL_VIDEO_DRIVER_X11)
    if (SDL_GetWindowWMInfo(window, &info) && info.subsystem == SDL_SYSWM_X11) {
        return info.info.x11.display;
    }
#else
    (void)window;
#endif
    return NULL;
}

void lost_display_close(SDL_Window *window) {
    void *display = display_of(window);
    void *library = display ? dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD) : NULL;
    SDL_DestroyWindow(window);
    if (library) {
        Synchronize synchronize = NULL;
        find_function(library, "XSync", &synchronize, sizeof synchronize);
        // SDL may have put back Xlib's handler meanwhile.
        lost_display_prepare();
        if (synchronize) {
            synchronize(display, 0);
        }
        dlclose(library);
    }
}
