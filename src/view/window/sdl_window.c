/**
 * @file
 * @brief The window on the screen, and textures.
 *
 * The processor renders all pixels, so a graphics card cannot help. On X11 SDL's software renderer
 * copies them to the window through shared memory: it opens in 30 ms and shows 800x600 in 0.2 ms;
 * OpenGL took 80 to 260 ms and 2 ms. SDL 2 has no such path for Wayland and others: there the
 * accelerated renderer is used, else the software one. `SDL_RENDER_DRIVER` overrides all this.
 */
#include "view/window/sdl_window.h"

#include "base/language.h"
#include "dioptre/scene.h"

#include <string.h>

/** Sets an error with SDL's message. @param format What failed, with `%s`. @return false. */
__attribute__((format(printf, 2, 0))) static bool set_sdl_error(Error *error, const char *format) {
    return error_set(error, STATUS_FAILED, format, SDL_GetError());
}

/** Shrinks a size to the first screen, with the same aspect ratio. @param[in,out] width Screen
 *  units. */
static void fit_to_screen(int *width, int *height) {
    SDL_Rect usable;
    if (SDL_GetDisplayUsableBounds(0, &usable) == 0 && usable.w > 0 && usable.h > 0) {
        double shrink = SDL_min((double)usable.w / *width, (double)usable.h / *height);
        if (shrink < 1) {
            *width = SDL_max(1, (int)(*width * shrink));
            *height = SDL_max(1, (int)(*height * shrink));
        }
    }
}

/** @return The renderer of a window; NULL: SDL failed. */
static SDL_Renderer *create_renderer(SDL_Window *window) {
    bool is_x11 = strcmp(SDL_GetCurrentVideoDriver(), "x11") == 0;
    bool is_forced = SDL_GetHint(SDL_HINT_RENDER_DRIVER) != NULL;
    if (is_x11 && !is_forced) {
        SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
        return SDL_CreateRenderer(window, -1, SDL_RENDERER_SOFTWARE);
    }
    SDL_Renderer *renderer = SDL_CreateRenderer(window, -1, SDL_RENDERER_ACCELERATED);
    return renderer ? renderer : SDL_CreateRenderer(window, -1, SDL_RENDERER_SOFTWARE);
}

int sdl_window_grow(const SdlWindow *sdl, int units) {
    int x = 0, y = 0, width = 0, height = 0, above = 0, below = 0;
    SDL_Rect usable;
    SDL_GetWindowSize(sdl->window, &width, &height);
    int grown = SDL_max(1, height + units);
    int display = SDL_GetWindowDisplayIndex(sdl->window);
    if (units > 0 && SDL_GetDisplayUsableBounds(SDL_max(0, display), &usable) == 0) {
        SDL_GetWindowBordersSize(sdl->window, &above, NULL, &below, NULL);
        SDL_GetWindowPosition(sdl->window, &x, &y);
        grown = SDL_max(height, SDL_min(grown, usable.h - above - below));
        int lowest = usable.y + usable.h - below - grown;
        if (y > lowest) {
            SDL_SetWindowPosition(sdl->window, x, SDL_max(usable.y + above, lowest));
        }
    }
    if (grown != height) {
        SDL_SetWindowSize(sdl->window, width, grown);
    }
    return grown - height;
}

bool sdl_window_open(SdlWindow *sdl, const char *title, int width, int height, Error *error) {
    *sdl = (SdlWindow){0};
    // No smoothing: a class sees the pixels as they were traced.
    SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "nearest");
    fit_to_screen(&width, &height);
    sdl->window = SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width,
                                   height, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
    if (!sdl->window) {
        return set_sdl_error(error, N_("cannot open a window: %s"));
    }
    sdl->renderer = create_renderer(sdl->window);
    if (!sdl->renderer) {
        set_sdl_error(error, N_("cannot draw in a window: %s"));
        sdl_window_close(sdl);
        return false;
    }
    return true;
}

void sdl_window_close(SdlWindow *sdl) {
    if (sdl->renderer) {
        SDL_DestroyRenderer(sdl->renderer);
    }
    if (sdl->window) {
        SDL_DestroyWindow(sdl->window);
    }
    *sdl = (SdlWindow){0};
}

void sdl_window_size(const SdlWindow *sdl, int *width, int *height) {
    if (SDL_GetRendererOutputSize(sdl->renderer, width, height) != 0) {
        SDL_GetWindowSize(sdl->window, width, height);
    }
    *width = SDL_clamp(*width, 1, IMAGE_SIZE_MAXIMUM);
    *height = SDL_clamp(*height, 1, IMAGE_SIZE_MAXIMUM);
}

void sdl_window_clear(SdlWindow *sdl) {
    SDL_SetRenderDrawColor(sdl->renderer, 0, 0, 0, SDL_ALPHA_OPAQUE);
    SDL_RenderClear(sdl->renderer);
}

void sdl_window_present(SdlWindow *sdl) {
    SDL_RenderPresent(sdl->renderer);
}

void sdl_window_toggle_full_screen(SdlWindow *sdl) {
    bool is_full = SDL_GetWindowFlags(sdl->window) & SDL_WINDOW_FULLSCREEN_DESKTOP;
    SDL_SetWindowFullscreen(sdl->window, is_full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP);
}

/* --- textures --------------------------------------------------------------------------------- */

uint8_t *streaming_texture_lock(StreamingTexture *texture, SDL_Renderer *renderer, int width,
                                int height, int *pitch) {
    if (texture->width != width || texture->height != height) {
        streaming_texture_release(texture);
    }
    if (!texture->texture) {
        texture->texture = SDL_CreateTexture(renderer, SDL_PIXELFORMAT_XRGB8888,
                                             SDL_TEXTUREACCESS_STREAMING, width, height);
        texture->width = width;
        texture->height = height;
    }
    void *pixels = NULL;
    if (!texture->texture || SDL_LockTexture(texture->texture, NULL, &pixels, pitch) != 0) {
        return NULL;
    }
    return pixels;
}

void streaming_texture_unlock(StreamingTexture *texture) {
    SDL_UnlockTexture(texture->texture);
}

void streaming_texture_draw(const StreamingTexture *texture, SDL_Renderer *renderer,
                            const SDL_Rect *destination, const SDL_Rect *clip) {
    if (texture->texture) {
        SDL_RenderSetClipRect(renderer, clip);
        SDL_RenderCopy(renderer, texture->texture, NULL, destination);
        SDL_RenderSetClipRect(renderer, NULL);
    }
}

void streaming_texture_release(StreamingTexture *texture) {
    if (texture->texture) {
        SDL_DestroyTexture(texture->texture);
    }
    *texture = (StreamingTexture){0};
}
