/**
 * @file
 * @brief A canvas: a picture as the window shows it.
 */
#ifndef DIOPTRE_VIEW_CANVAS_H
#define DIOPTRE_VIEW_CANVAS_H

#include <SDL.h>
#include <stdint.h>

/** A picture, ready to be shown. Starts as `{0}`: empty. */
typedef struct Canvas {
    SDL_Texture *texture; /**< The picture, or NULL while there is none; owned. */
    int width;            /**< Pixels of it. */
    int height;           /**< Pixels of it. */
} Canvas;

/**
 * Gives access to the pixels, until #canvas_unlock.
 * @param[in,out] canvas  The canvas.
 * @param renderer        What draws in the window.
 * @param width           Pixels that the picture shall have; it is made anew if it has others.
 * @param height          Pixels that it shall have.
 * @param[out] pitch      Bytes from a row to the next.
 * @return Where to write blue, green, red and an unused byte for each pixel; NULL if that failed.
 */
uint8_t *canvas_lock(Canvas *canvas, SDL_Renderer *renderer, int width, int height, int *pitch);

/** Ends the access to the pixels. @param[in,out] canvas The canvas. */
void canvas_unlock(Canvas *canvas);

/**
 * Puts the picture into the window, stretched if the room for it has another size.
 * @param canvas    The canvas; nothing is shown of an empty one.
 * @param renderer  What draws in the window.
 * @param room      Where all of it belongs, pixels of the window.
 * @param part      What of that room is shown.
 */
void canvas_show(const Canvas *canvas, SDL_Renderer *renderer, const SDL_Rect *room,
                 const SDL_Rect *part);

/** Empties it: the graphics card lost the picture, or nobody wants it. @param[in,out] canvas It. */
void canvas_forget(Canvas *canvas);

#endif
