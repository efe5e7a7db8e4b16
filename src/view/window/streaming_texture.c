/**
 * @file
 * @brief Canvases: pictures as textures.
 */
#include "view/window/streaming_texture.h"

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
