/**
 * @file
 * @brief What happens when the display goes away while the window is open.
 */
#ifndef DIOPTRE_VIEW_WINDOW_X11_ERRORS_H
#define DIOPTRE_VIEW_WINDOW_X11_ERRORS_H

/**
 * Makes the program end with words of its own, and status 1, when the X server vanishes, and go on
 * when a single request to it fails. Does nothing where SDL uses another display system, which
 * tells by an event. Call it before SDL's video is up.
 */
void x11_errors_install(void);

#endif
