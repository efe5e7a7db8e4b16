/**
 * @file
 * @brief The window on the screen: opening it, its size.
 */
#ifndef DIOPTRE_VIEW_DISPLAY_H
#define DIOPTRE_VIEW_DISPLAY_H

#include "dioptre/error.h"

#include <SDL.h>
#include <stdbool.h>
#include <stdint.h>

/** A window. Starts as `{0}`: closed. */
typedef struct Display {
    SDL_Window *window;     /**< The window; owned. */
    SDL_Renderer *renderer; /**< What draws in it; owned. */
} Display;

/**
 * Opens a window, no larger than the screen has room for.
 * @param[out] display  The window; give it back with #display_close.
 * @param title         Its title, UTF-8.
 * @param width         Width wanted, in the screen's units.
 * @param height        Height wanted.
 * @param[out] error    What is wrong.
 * @return Whether it is open.
 */
bool display_open(Display *display, const char *title, int width, int height, Error *error);

/** Closes a window. @param[in,out] display The window, open or not. */
void display_close(Display *display);

/**
 * Finds how many pixels the window really has, which on a HiDPI screen are more than its units.
 * @param display      The window.
 * @param[out] width   Pixels, at least 1 and at most #IMAGE_SIZE_MAXIMUM.
 * @param[out] height  Pixels, likewise.
 */
void display_size(const Display *display, int *width, int *height);

/** Begins a black window; then pictures and panels may be laid over it. @param[in,out] display It.
 */
void display_begin(Display *display);

/** Shows what was put there since #display_begin. @param[in,out] display The window. */
void display_end(Display *display);

/** Changes between the whole screen and a window. @param[in,out] display The window. */
void display_toggle_full_screen(Display *display);

#endif
