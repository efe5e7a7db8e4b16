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

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/** Told by Xlib that the connection broke; must not return. The argument is Xlib's `Display`. */
typedef int (*LostHandler)(void *display);

/** Xlib's XSetIOErrorHandler: sets the handler, returns the one before. */
typedef LostHandler (*SetLostHandler)(LostHandler handler);

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

void lost_display_prepare(void) {
    void *library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
    if (library) {
        SetLostHandler set_handler;
        /* C has no cast from an object's address to a function's; POSIX says that they are alike.
         */
        void *address = dlsym(library, "XSetIOErrorHandler");
        memcpy(&set_handler, &address, sizeof set_handler);
        if (set_handler) {
            set_handler(end_program);
        }
        dlclose(library);
    }
}
