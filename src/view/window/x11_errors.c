/**
 * @file
 * @brief What happens when the display goes away.
 *
 * Xlib calls a handler when the connection breaks and ends the program when the handler returns;
 * SDL 2 offers no way to set that handler. So libX11 is opened as SDL does it, if it is there: the
 * program itself needs no X11 to be built or to start. SDL keeps the handler for failed requests
 * that it finds when it starts, calls it after its own, and puts it back when it ends; so ours must
 * be there before.
 */
#include "view/window/x11_errors.h"

#include "dioptre/error.h"

#include <dlfcn.h>
#include <libintl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/** Told by Xlib that the connection broke; must not return. The argument is Xlib's `Display`. */
typedef int (*IoErrorHandler)(void *display);

/** Xlib's XSetIOErrorHandler: sets the handler, returns the one before. */
typedef IoErrorHandler (*SetIoErrorHandler)(IoErrorHandler handler);

/** Told by Xlib that one request failed. The arguments are Xlib's `Display` and `XErrorEvent`. */
typedef int (*ErrorHandler)(void *display, void *event);

/** Xlib's XSetErrorHandler: sets the handler, returns the one before. */
typedef ErrorHandler (*SetErrorHandler)(ErrorHandler handler);

/** Says that the display is gone and ends the program. Pictures are written beside their place and
 *  renamed, so none is left half done; what was printed is kept. @return Never. */
static int on_connection_lost(void *display) {
    (void)display;
    const char *message = gettext("dioptre: the display went away\n");
    fflush(stdout);
    ssize_t written = write(STDERR_FILENO, message, strlen(message));
    (void)written;
    _exit(STATUS_FAILED);
}

/** Passes over a failed request. Xlib's own handler would end the program, although nothing is
 *  lost: a message to a window that has just been closed, as when full screen is left and the
 *  program after it. @return Anything; Xlib does not look. */
static int on_request_failed(void *display, void *event) {
    (void)display;
    (void)event;
    return 0;
}

/**
 * Finds a function of Xlib. C has no cast from an object's address to a function's; POSIX says that
 * they are alike.
 * @param[out] function  Its address, of `size` bytes; zero where there is none.
 * @param size  Bytes of a function's address.
 */
static void find_function(void *library, const char *name, void *function, size_t size) {
    void *address = dlsym(library, name);
    memcpy(function, &address, size);
}

void x11_errors_install(void) {
    // Stays open: its handlers are needed until the very end.
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
