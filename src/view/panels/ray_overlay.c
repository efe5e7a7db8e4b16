/**
 * @file
 * @brief Draws rays into an image with cairo, and the image into the window.
 */
#include "view/panels/ray_overlay.h"

/** @return A colour channel without its factor alpha. @param shift Of the channel in the pixel. */
static Uint32 unpremultiplied(Uint32 pixel, int shift) {
    Uint32 alpha = pixel >> 24, value = pixel >> shift & 0xff;
    return ((255 * value + alpha / 2) / alpha) << shift;
}

/** Converts an image from cairo's premultiplied alpha to the straight alpha that SDL blends. */
static void unpremultiply(cairo_surface_t *image) {
    cairo_surface_flush(image);
    int width = cairo_image_surface_get_width(image),
        height = cairo_image_surface_get_height(image);
    size_t stride = (size_t)cairo_image_surface_get_stride(image);
    unsigned char *data = cairo_image_surface_get_data(image);
    for (int row = 0; row < height; row++) {
        Uint32 *pixels = (Uint32 *)(void *)(data + (size_t)row * stride);
        for (int column = 0; column < width; column++) {
            Uint32 pixel = pixels[column], alpha = pixel >> 24;
            if (alpha > 0 && alpha < 255) {
                pixels[column] = (pixel & 0xff000000) | unpremultiplied(pixel, 16) |
                                 unpremultiplied(pixel, 8) | unpremultiplied(pixel, 0);
            }
        }
    }
}

/** @return An image as a texture; NULL if SDL failed. */
static SDL_Texture *to_texture(cairo_surface_t *image, SDL_Renderer *renderer) {
    SDL_Texture *texture = SDL_CreateTexture(
        renderer, SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STATIC,
        cairo_image_surface_get_width(image), cairo_image_surface_get_height(image));
    if (texture) {
        SDL_UpdateTexture(texture, NULL, cairo_image_surface_get_data(image),
                          cairo_image_surface_get_stride(image));
        SDL_SetTextureBlendMode(texture, SDL_BLENDMODE_BLEND);
    }
    return texture;
}

/** Draws rays, the camera and the lights. @return The drawing; NULL without memory. */
static SDL_Texture *draw_overlay(const RayOverlay *overlay, SDL_Renderer *renderer, int width,
                                 int height) {
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    RayDrawing drawing = overlay->drawing;
    SDL_Texture *texture = NULL;
    drawing.cairo = cairo_create(image);
    ray_drawing_rays(&drawing);
    ray_drawing_march(&drawing);
    ray_drawing_mark(&drawing, drawing.tree->nodes[0].origin, RAY_MARK_EYE, NULL);
    for (size_t i = 0; i < overlay->light_count; i++) {
        ray_drawing_mark(&drawing, overlay->light_positions[i], RAY_MARK_LIGHT, NULL);
    }
    if (cairo_status(drawing.cairo) == CAIRO_STATUS_SUCCESS) {
        unpremultiply(image);
        texture = to_texture(image, renderer);
    }
    cairo_destroy(drawing.cairo);
    cairo_surface_destroy(image);
    return texture;
}

void ray_overlay_show(OverlayImage *image, const RayOverlay *overlay, SDL_Renderer *renderer,
                      const SDL_Rect *rect) {
    if (image->width != rect->w || image->height != rect->h) {
        ray_overlay_release(image);
    }
    if (!image->texture) {
        *image =
            (OverlayImage){draw_overlay(overlay, renderer, rect->w, rect->h), rect->w, rect->h};
    }
    if (image->texture) {
        SDL_RenderCopy(renderer, image->texture, NULL, rect);
    }
}

void ray_overlay_draw_pane(OverlayImage *image, RayPane pane, const RayPaneInput *input,
                           SDL_Renderer *renderer, int width, int height) {
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    RayPaneInput target = *input;
    target.drawing.cairo = cairo_create(surface);
    ray_overlay_release(image);
    ray_pane_draw(pane, &target, width, height);
    if (cairo_status(target.drawing.cairo) == CAIRO_STATUS_SUCCESS) {
        cairo_surface_flush(surface);
        *image = (OverlayImage){to_texture(surface, renderer), width, height};
    }
    cairo_destroy(target.drawing.cairo);
    cairo_surface_destroy(surface);
}

void ray_overlay_release(OverlayImage *image) {
    if (image->texture) {
        SDL_DestroyTexture(image->texture);
        image->texture = NULL;
    }
}

void ray_overlay_mark_pixel(SDL_Renderer *renderer, double x, double y, double size) {
    const Uint8 greys[] = {0, 255};
    const double widths[] = {fmax(4, size / 5), fmax(2, size / 10)};
    SDL_SetRenderDrawBlendMode(renderer, SDL_BLENDMODE_NONE);
    for (int pass = 0; pass < 2; pass++) {
        const float first = (float)(size / 3), length = (float)(size - size / 3),
                    width = (float)widths[pass], half = width / 2;
        const float left = (float)x, top = (float)y;
        const SDL_FRect arms[] = {{left + first, top - half, length, width},
                                  {left - first - length, top - half, length, width},
                                  {left - half, top + first, width, length},
                                  {left - half, top - first - length, width, length}};
        SDL_SetRenderDrawColor(renderer, greys[pass], greys[pass], greys[pass], SDL_ALPHA_OPAQUE);
        SDL_RenderFillRectsF(renderer, arms, 4);
    }
}
