/**
 * @file
 * @brief The window on the screen: opening it, its size.
 */
#ifndef DIOPTRE_VIEW_WINDOW_SDL_WINDOW_H
#define DIOPTRE_VIEW_WINDOW_SDL_WINDOW_H

#include "dioptre/error.h"

#include <SDL.h>
#include <stdbool.h>
#include <stdint.h>

/** A window. Starts as `{0}`: closed. */
typedef struct SdlWindow {
    SDL_Window *window;     /**< The window; owned. */
    SDL_Renderer *renderer; /**< What draws in it; owned. */
} SdlWindow;

/**
 * Opens a window, no larger than the screen has room for.
 * @param[out] sdl  The window; give it back with #sdl_window_close.
 * @param width  Width wanted, in the screen's units.
 * @return Whether it is open.
 */
bool sdl_window_open(SdlWindow *sdl, const char *title, int width, int height, Error *error);

/** Closes a window. @param[in,out] sdl The window, open or not. */
void sdl_window_close(SdlWindow *sdl);

/** Finds how many pixels the window really has, which on a HiDPI screen are more than its units.
 *  @param[out] width Pixels, at least 1 and at most #IMAGE_SIZE_MAXIMUM. */
void sdl_window_size(const SdlWindow *sdl, int *width, int *height);

/** Begins a black window; then pictures and panels may be laid over it. */
void sdl_window_clear(SdlWindow *sdl);

/** Shows what was put there since #sdl_window_clear. */
void sdl_window_present(SdlWindow *sdl);

/** Changes between the whole screen and a window. */
void sdl_window_toggle_full_screen(SdlWindow *sdl);

#endif
