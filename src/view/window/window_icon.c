/**
 * @file
 * @brief The window's icon: the picture of src/desktop/org.dioptre.Dioptre.svg, drawn anew.
 *
 * All lengths are those of that file.
 */
#include "view/window/window_icon.h"

#include <cairo.h>
#include <math.h>

/** Side of the picture in the file, and pixels of the icon: desktops show at most 64. */
enum { SIDE = 128, ICON_PIXELS = 64 };

/** Draws the ground: a night sky with rounded corners. */
static void draw_ground(cairo_t *cairo) {
    const double low = 4, high = SIDE - 4, radius = 24;
    cairo_pattern_t *night = cairo_pattern_create_linear(0, low, 0, high);
    cairo_pattern_add_color_stop_rgb(night, 0, 0x1d / 255.0, 0x35 / 255.0, 0x57 / 255.0);
    cairo_pattern_add_color_stop_rgb(night, 1, 0x0b / 255.0, 0x1a / 255.0, 0x2e / 255.0);
    for (int i = 0; i < 4; i++) {
        cairo_arc(cairo, i == 1 || i == 2 ? low + radius : high - radius,
                  i == 2 || i == 3 ? low + radius : high - radius, radius, i * M_PI_2,
                  (i + 1) * M_PI_2);
    }
    cairo_set_source(cairo, night);
    cairo_fill(cairo);
    cairo_pattern_destroy(night);
}

/** Draws the ball of glass. */
static void draw_glass(cairo_t *cairo) {
    const double x = 62, y = 68, radius = 34, side = 2 * radius;
    const double shine_x = x - radius + 0.36 * side, shine_y = y - radius + 0.3 * side;
    cairo_pattern_t *glass =
        cairo_pattern_create_radial(shine_x, shine_y, 0, shine_x, shine_y, 0.8 * side);
    cairo_pattern_add_color_stop_rgba(glass, 0, 1, 1, 1, 0.95);
    cairo_pattern_add_color_stop_rgba(glass, 0.25, 0xbf / 255.0, 0xe3 / 255.0, 0xf2 / 255.0, 0.75);
    cairo_pattern_add_color_stop_rgba(glass, 1, 0x4f / 255.0, 0xa3 / 255.0, 0xc7 / 255.0, 0.6);
    cairo_arc(cairo, x, y, radius, 0, 2 * M_PI);
    cairo_set_source(cairo, glass);
    cairo_fill_preserve(cairo);
    cairo_pattern_destroy(glass);
    cairo_set_source_rgb(cairo, 0xd9 / 255.0, 0xf0 / 255.0, 0xf8 / 255.0);
    cairo_set_line_width(cairo, 3);
    cairo_stroke(cairo);
}

/** Draws the ray, and the points where the glass bends it. */
static void draw_ray(cairo_t *cairo) {
    static const double points[][2] = {{12, 37.2}, {37.8, 44.2}, {95.8, 71.7}, {115.3, 85.7}};
    for (int i = 0; i < 4; i++) {
        cairo_line_to(cairo, points[i][0], points[i][1]);
    }
    cairo_set_source_rgb(cairo, 1, 0xd1 / 255.0, 0x66 / 255.0);
    cairo_set_line_width(cairo, 6);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(cairo);
    cairo_set_source_rgb(cairo, 0xe6 / 255.0, 0x39 / 255.0, 0x46 / 255.0);
    for (int i = 1; i <= 2; i++) {
        cairo_arc(cairo, points[i][0], points[i][1], 5, 0, 2 * M_PI);
        cairo_fill(cairo);
    }
}

SDL_Surface *window_icon_create(void) {
    // Cairo multiplies colours by their opacity, SDL does not: only the edge differs.
    SDL_Surface *surface =
        SDL_CreateRGBSurfaceWithFormat(0, ICON_PIXELS, ICON_PIXELS, 32, SDL_PIXELFORMAT_ARGB8888);
    if (!surface) {
        return NULL;
    }
    SDL_memset(surface->pixels, 0, (size_t)surface->pitch * ICON_PIXELS);
    cairo_surface_t *image = cairo_image_surface_create_for_data(
        surface->pixels, CAIRO_FORMAT_ARGB32, ICON_PIXELS, ICON_PIXELS, surface->pitch);
    cairo_t *cairo = cairo_create(image);
    cairo_scale(cairo, (double)ICON_PIXELS / SIDE, (double)ICON_PIXELS / SIDE);
    draw_ground(cairo);
    draw_glass(cairo);
    draw_ray(cairo);
    cairo_destroy(cairo);
    cairo_surface_destroy(image);
    return surface;
}

void window_icon_set(SDL_Window *window) {
    SDL_Surface *icon = window_icon_create();
    if (icon) {
        SDL_SetWindowIcon(window, icon);
        SDL_FreeSurface(icon);
    }
}
