/**
 * @file
 * @brief A canvas: a picture as the window shows it.
 */
#ifndef DIOPTRE_VIEW_WINDOW_STREAMING_TEXTURE_H
#define DIOPTRE_VIEW_WINDOW_STREAMING_TEXTURE_H

#include <SDL.h>
#include <stdint.h>

/** A picture, ready to be shown. Starts as `{0}`: empty. */
typedef struct StreamingTexture {
    SDL_Texture *texture; /**< The picture, or NULL while there is none; owned. */
    int width;            /**< Pixels of it. */
    int height;           /**< Pixels of it. */
} StreamingTexture;

/**
 * Gives access to the pixels, until #streaming_texture_unlock.
 * @param renderer  What draws in the window.
 * @param width  Pixels that the picture shall have; it is made anew if it has others.
 * @param height  Pixels that it shall have.
 * @param[out] pitch  Bytes from a row to the next.
 * @return Where to write blue, green, red and an unused byte for each pixel; NULL if that failed.
 */
uint8_t *streaming_texture_lock(StreamingTexture *texture, SDL_Renderer *renderer, int width,
                                int height, int *pitch);

/** Ends the access to the pixels. */
void streaming_texture_unlock(StreamingTexture *texture);

/**
 * Puts the picture into the window, stretched if the room for it has another size.
 * @param texture    The canvas; nothing is shown of an empty one.
 * @param renderer  What draws in the window.
 * @param destination      Where all of it belongs, pixels of the window.
 * @param clip      What of that room is shown.
 */
void streaming_texture_draw(const StreamingTexture *texture, SDL_Renderer *renderer,
                            const SDL_Rect *destination, const SDL_Rect *clip);

/** Empties it: the graphics card lost the picture, or nobody wants it. */
void streaming_texture_release(StreamingTexture *texture);

#endif
