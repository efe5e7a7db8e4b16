/**
 * @file
 * @brief Canvases: pictures as textures.
 */
#include "view/canvas.h"

uint8_t *canvas_lock(Canvas *canvas, SDL_Renderer *renderer, int width, int height, int *pitch) {
    if (canvas->width != width || canvas->height != height) {
        canvas_forget(canvas);
    }
    if (!canvas->texture) {
        canvas->texture = SDL_CreateTexture(renderer, SDL_PIXELFORMAT_XRGB8888,
                                            SDL_TEXTUREACCESS_STREAMING, width, height);
        canvas->width = width;
        canvas->height = height;
    }
    void *pixels = NULL;
    if (!canvas->texture || SDL_LockTexture(canvas->texture, NULL, &pixels, pitch) != 0) {
        return NULL;
    }
    return pixels;
}

void canvas_unlock(Canvas *canvas) {
    SDL_UnlockTexture(canvas->texture);
}

void canvas_show(const Canvas *canvas, SDL_Renderer *renderer, const SDL_Rect *room,
                 const SDL_Rect *part) {
    if (canvas->texture) {
        SDL_RenderSetClipRect(renderer, part);
        SDL_RenderCopy(renderer, canvas->texture, NULL, room);
        SDL_RenderSetClipRect(renderer, NULL);
    }
}

void canvas_forget(Canvas *canvas) {
    if (canvas->texture) {
        SDL_DestroyTexture(canvas->texture);
    }
    *canvas = (Canvas){0};
}
