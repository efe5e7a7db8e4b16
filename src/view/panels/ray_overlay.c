/**
 * @file
 * @brief Draws rays into an image with cairo, and the image into the window.
 */
#include "view/panels/ray_overlay.h"

#include "render/ray_drawing.h"

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

/** Draws an image into the window. */
static void show_image(cairo_surface_t *image, SDL_Renderer *renderer, const SDL_Rect *rect) {
    SDL_Texture *texture = SDL_CreateTexture(renderer, SDL_PIXELFORMAT_ARGB8888,
                                             SDL_TEXTUREACCESS_STATIC, rect->w, rect->h);
    if (texture) {
        SDL_UpdateTexture(texture, NULL, cairo_image_surface_get_data(image),
                          cairo_image_surface_get_stride(image));
        SDL_SetTextureBlendMode(texture, SDL_BLENDMODE_BLEND);
        SDL_RenderCopy(renderer, texture, NULL, rect);
        SDL_DestroyTexture(texture);
    }
}

void ray_overlay_draw(const RayOverlay *overlay, SDL_Renderer *renderer, const SDL_Rect *rect) {
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, rect->w, rect->h);
    RayDrawing drawing = {.cairo = cairo_create(image),
                          .tree = overlay->ray_tree,
                          .orbit = overlay->orbit,
                          .view = orbit_camera_project(overlay->orbit, rect->w, rect->h),
                          .selected = overlay->selected};
    ray_drawing_rays(&drawing);
    ray_drawing_mark(&drawing, overlay->ray_tree->nodes[0].origin, RAY_MARK_EYE, NULL);
    for (size_t i = 0; i < overlay->light_count; i++) {
        ray_drawing_mark(&drawing, overlay->light_positions[i], RAY_MARK_LIGHT, NULL);
    }
    if (cairo_status(drawing.cairo) == CAIRO_STATUS_SUCCESS) {
        unpremultiply(image);
        show_image(image, renderer, rect);
    }
    cairo_destroy(drawing.cairo);
    cairo_surface_destroy(image);
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
