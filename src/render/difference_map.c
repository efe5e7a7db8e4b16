/**
 * @file
 * @brief False-colour picture of the difference of two pictures.
 */
#include "render/difference_map.h"

#include "base/language.h"
#include "render/palette.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Colour of pixels whose difference is unknown. */
static const uint8_t UNKNOWN_COLOR[3] = {0x48, 0x4c, 0x54};
/** Ticks of the legend on each side of 0. */
enum { TICKS_PER_SIDE = 4 };
/** The ticks of light, steps of 8 bits. */
static const double LIGHT_TICKS[TICKS_PER_SIDE] = {255, 63, 15, 3};
/** Where the ticks of magnitudes lie, from the end of the scale. Each is a tenth of the last. */
static const double MAGNITUDE_TICKS[TICKS_PER_SIDE] = {1, 0.1, 0.01};
/** The ticks of errors, steps of 8 bits. */
static const double ERROR_TICKS[TICKS_PER_SIDE] = {255, 1, 1e-6, 1e-12};
/** The tick of differences that are 0 or 1. */
static const double BINARY_TICKS[TICKS_PER_SIDE] = {1};

/** The scale of light: one step is far from none. */
static LayerScale light_scale(void) {
    return (LayerScale){1, UINT8_MAX, true, 1 / log1p(UINT8_MAX)};
}

/** @return Position of a difference on the bar, 0 to 1: linear near 0, then logarithmic. */
static double bar_position(const LayerScale *scale, double value) {
    double magnitude = log1p(fabs(value) / scale->low) * scale->slope;
    return 0.5 + (value < 0 ? -magnitude : magnitude) / 2;
}

void difference_map_bar_color(double fraction, uint8_t rgb[3]) {
    palette_color(&palette_diverging, fraction, rgb);
}

void difference_map_color(const DifferenceMap *map, double value, uint8_t rgb[3]) {
    if (isnan(value)) {
        memcpy(rgb, UNKNOWN_COLOR, sizeof UNKNOWN_COLOR);
    } else {
        difference_map_bar_color(bar_position(&map->scale, value), rgb);
    }
}

/** Writes a pixel. @param[out] bgrx Blue, green, red and an unused byte. */
static void write_pixel(const uint8_t rgb[3], uint8_t *bgrx) {
    bgrx[0] = rgb[2];
    bgrx[1] = rgb[1];
    bgrx[2] = rgb[0];
    bgrx[3] = UINT8_MAX;
}

/** @return The difference of the channel that differs most, with its sign. */
static int pixel_difference(const uint8_t *a, const uint8_t *b) {
    int largest = 0;
    for (int i = 0; i < 3; i++) {
        int difference = a[i] - b[i];
        largest = abs(difference) > abs(largest) ? difference : largest;
    }
    return largest;
}

DifferenceMap difference_map_draw(const uint8_t *a, const uint8_t *b, size_t pixel_count,
                                  uint8_t *bgrx) {
    uint8_t colors[2 * UINT8_MAX + 1][3];
    DifferenceMap map = {.scale = light_scale(), .pixel_count = pixel_count};
    for (int difference = -UINT8_MAX; difference <= UINT8_MAX; difference++) {
        difference_map_color(&map, difference, colors[difference + UINT8_MAX]);
    }
    for (size_t i = 0; i < 4 * pixel_count; i += 4) {
        int delta = pixel_difference(a + i, b + i);
        map.differing_pixels += abs(delta) > 1;
        map.max_difference = fmax(map.max_difference, abs(delta));
        write_pixel(colors[delta + UINT8_MAX], bgrx + i);
    }
    return map;
}

/** Finds the largest difference, and how many pixels differ. */
static void measure_values(DifferenceMap *map, const float *a, const float *b) {
    for (size_t i = 0; i < LAYER_VALUES * map->pixel_count; i += LAYER_VALUES) {
        double value = layer_difference(map->layer, a + i, b + i);
        map->unknown_pixels += isnan(value) ? 1 : 0;
        map->differing_pixels += fabs(value) > 0;
        map->max_difference = fmax(map->max_difference, fabs(value));
    }
}

DifferenceMap difference_map_draw_values(Layer layer, const float *a, const float *b,
                                         size_t pixel_count, uint8_t *bgrx) {
    DifferenceMap map = {.layer = layer, .pixel_count = pixel_count};
    measure_values(&map, a, b);
    map.scale = layer_difference_scale(layer, map.max_difference);
    double last = 0;
    uint8_t rgb[3];
    difference_map_color(&map, last, rgb);
    for (size_t i = 0; i < pixel_count; i++) {
        double value = layer_difference(layer, a + LAYER_VALUES * i, b + LAYER_VALUES * i);
        if (value != last) { // Neighbours are often equal, and logarithms take time.
            difference_map_color(&map, value, rgb);
            last = value;
        }
        write_pixel(rgb, bgrx + 4 * i);
    }
    return map;
}

DifferenceMap difference_map_draw_none(size_t pixel_count, uint8_t *bgrx) {
    for (size_t i = 0; i < pixel_count; i++) {
        write_pixel(UNKNOWN_COLOR, bgrx + 4 * i);
    }
    return (DifferenceMap){
        .is_of_two_layers = true, .pixel_count = pixel_count, .unknown_pixels = pixel_count};
}

/** @return The ticks of one side, from the largest down; 0 ends them. @param[out] unit What they
 *  are multiplied with. */
static const double *ticks_of(const DifferenceMap *map, double *unit) {
    bool is_light = map->layer == LAYER_SHADED;
    bool is_error = map->layer == LAYER_ERROR || map->layer == LAYER_ROUNDING;
    bool is_binary = map->layer == LAYER_SHAPES || map->layer == LAYER_ACNE;
    *unit = is_light || is_error || is_binary ? 1 : map->scale.high;
    return is_light    ? LIGHT_TICKS
           : is_error  ? ERROR_TICKS
           : is_binary ? BINARY_TICKS
                       : MAGNITUDE_TICKS;
}

/** Adds a tick. @return Number of rows. */
static size_t add_tick(const DifferenceMap *map, double value, LegendEntry *entries, size_t count) {
    entries[count] = (LegendEntry){.position = bar_position(&map->scale, value)};
    snprintf(entries[count].number, sizeof entries[count].number, value != 0 ? "%+.6g" : "%.6g",
             value);
    difference_map_color(map, value, entries[count].rgb);
    return count + 1;
}

size_t difference_map_legend(const DifferenceMap *map,
                             LegendEntry entries[LEGEND_ENTRIES_MAXIMUM]) {
    double unit = 1;
    const double *ticks = ticks_of(map, &unit);
    bool is_one_sided = map->layer == LAYER_NORMALS || map->layer == LAYER_SHAPES;
    size_t count = 0, side = 0;
    if (map->is_of_two_layers) {
        return 0;
    }
    for (; side < TICKS_PER_SIDE && ticks[side] > 0; side++) {
        count = add_tick(map, ticks[side] * unit, entries, count);
    }
    count = add_tick(map, 0, entries, count);
    while (side-- > 0 && !is_one_sided) {
        count = add_tick(map, -ticks[side] * unit, entries, count);
    }
    if (map->unknown_pixels > 0) {
        bool is_missing = layer_has_missing(map->layer);
        entries[count] =
            (LegendEntry){.label = is_missing ? N_("in only one of them") : N_("not measured yet"),
                          .position = LEGEND_APART};
        difference_map_color(map, (double)NAN, entries[count++].rgb);
    }
    return count;
}
