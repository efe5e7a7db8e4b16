/**
 * @file
 * @brief PNG of cairo's pictures by stb_image_write, for pictures within SVG charts.
 */
#include "web/libraries/stb.h"

#include <cairo.h>
#include <stdlib.h>

/** Where the bytes go. */
typedef struct PngSink {
    cairo_write_func_t write; /**< Gets them. */
    void *context;            /**< Its first argument. */
    cairo_status_t status;    /**< What it returned. */
} PngSink;

/** Hands bytes on. See stbi_write_func. */
static void hand_on(void *context, void *bytes, int size) {
    PngSink *sink = context;
    if (sink->status == CAIRO_STATUS_SUCCESS) {
        sink->status = sink->write(sink->context, bytes, (unsigned)size);
    }
}

cairo_status_t cairo_surface_write_to_png_stream(cairo_surface_t *surface, cairo_write_func_t write,
                                                 void *closure) {
    PngSink sink = {write, closure, CAIRO_STATUS_SUCCESS};
    int width = cairo_image_surface_get_width(surface);
    int height = cairo_image_surface_get_height(surface);
    int stride = cairo_image_surface_get_stride(surface);
    const unsigned char *pixels = cairo_image_surface_get_data(surface);
    unsigned char *rgb = malloc((size_t)width * (size_t)height * 3);
    if (!rgb) {
        return CAIRO_STATUS_NO_MEMORY;
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            const unsigned char *bgra = pixels + y * stride + 4 * x;
            unsigned char *to = rgb + 3 * ((size_t)y * (size_t)width + (size_t)x);
            to[0] = bgra[2];
            to[1] = bgra[1];
            to[2] = bgra[0];
        }
    }
    stbi_write_png_to_func(hand_on, &sink, width, height, 3, rgb, 3 * width);
    free(rgb);
    return sink.status;
}
