/**
 * @file
 * @brief SDL: its video, the window on the screen, and textures in it.
 */
#ifndef DIOPTRE_VIEW_WINDOW_SDL_WINDOW_H
#define DIOPTRE_VIEW_WINDOW_SDL_WINDOW_H

#include "base/error.h"

#include <SDL.h>
#include <stdbool.h>
#include <stdint.h>

/**
 * Starts SDL's video. `SDL_Quit` ends it, also after a failure.
 * @param[out] error  There is no display.
 * @return Whether a window can be opened.
 */
bool video_start(Error *error);

/** A window. Starts as `{0}`: closed. */
typedef struct SdlWindow {
    SDL_Window *window;     /**< The window; owned. */
    SDL_Renderer *renderer; /**< Its renderer; owned. */
} SdlWindow;

/**
 * Opens a window, no larger than the screen.
 * @param[out] sdl  The window, to be closed with #sdl_window_close.
 * @param width  Screen units.
 * @return Whether it is open.
 */
bool sdl_window_open(SdlWindow *sdl, const char *title, int width, int height, Error *error);

/** Makes a window higher, or lower: it stays on its screen. @param units Screen units; below 0:
 * lower.
 *  @return By how much it has grown, screen units: less than asked for on a small screen. */
int sdl_window_grow(const SdlWindow *sdl, int units);

/** Closes a window, if it is open. */
void sdl_window_close(SdlWindow *sdl);

/** Returns the size in pixels, which on a HiDPI screen is more than in screen units. @param[out]
 *  width At least 1 and at most #IMAGE_SIZE_MAXIMUM. */
void sdl_window_size(const SdlWindow *sdl, int *width, int *height);

/** Clears the window to black. */
void sdl_window_clear(SdlWindow *sdl);

/** Shows what was drawn since #sdl_window_clear. */
void sdl_window_present(SdlWindow *sdl);

/** Changes between full screen and window. */
void sdl_window_toggle_full_screen(SdlWindow *sdl);

/** A texture whose pixels the processor writes. Starts as `{0}`: empty. */
typedef struct StreamingTexture {
    SDL_Texture *texture; /**< The texture; NULL: none yet; owned. */
    int width;            /**< Pixels. */
    int height;           /**< Pixels. */
} StreamingTexture;

/**
 * Gives access to the pixels, until #streaming_texture_unlock.
 * @param width  Pixels; a texture of another size is replaced.
 * @param[out] pitch  Bytes from a row to the next.
 * @return Blue, green, red and an unused byte per pixel, to be written; NULL: SDL failed.
 */
uint8_t *streaming_texture_lock(StreamingTexture *texture, SDL_Renderer *renderer, int width,
                                int height, int *pitch);

/** Ends the access to the pixels. */
void streaming_texture_unlock(StreamingTexture *texture);

/** Draws the texture in the window, scaled to the destination; does nothing if it is empty. @param
 *  destination Pixels of the window. @param clip The part of the destination that is drawn. */
void streaming_texture_draw(const StreamingTexture *texture, SDL_Renderer *renderer,
                            const SDL_Rect *destination, const SDL_Rect *clip);

/** Frees the texture: the graphics device was reset, or the picture is closed. */
void streaming_texture_release(StreamingTexture *texture);

#endif
