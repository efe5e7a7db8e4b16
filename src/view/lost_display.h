/**
 * @file
 * @brief What happens when the display goes away while the window is open.
 */
#ifndef DIOPTRE_VIEW_LOST_DISPLAY_H
#define DIOPTRE_VIEW_LOST_DISPLAY_H

#include <SDL.h>

/**
 * Makes the program end with words of its own, and status 1, when the X server vanishes. Does
 * nothing where SDL uses another display system, which tells by an event. Call it with SDL's video
 * up.
 */
void lost_display_prepare(void);

/**
 * Closes a window and waits until the X server has answered all that was asked of it, so that a
 * request that fails now is passed over: once SDL has ended, Xlib's own handler would end the
 * program for it.
 * @param window  The window.
 */
void lost_display_close(SDL_Window *window);

#endif
