/**
 * @file
 * @brief False-colour picture of the difference of two pictures.
 */
#include "render/difference_map.h"

#include "render/palette.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/** Differences in the legend, steps of 8 bits. */
static const int LEGEND_DIFFERENCES[] = {255, 31, 7, 1, 0, -1, -7, -31, -255};
/** Number of them. */
enum { LEGEND_COUNT = sizeof LEGEND_DIFFERENCES / sizeof LEGEND_DIFFERENCES[0] };

/** @return Position of a difference in the palette, 0 to 1: logarithmic, so that one step is far
 * from none. */
static double difference_palette_position(int difference) {
    double bits = log2(1.0 + abs(difference)) / 8; // 255 steps: 8 bits.
    return 0.5 + (difference < 0 ? -bits : bits) / 2;
}

/** Computes the colours of all differences. @param[out] colors Of -255 to 255: blue, green, red. */
static void difference_colors_init(uint8_t colors[2 * UINT8_MAX + 1][3]) {
    for (int difference = -UINT8_MAX; difference <= UINT8_MAX; difference++) {
        uint8_t *color = colors[difference + UINT8_MAX], rgb[3];
        palette_color(&palette_diverging, difference_palette_position(difference), rgb);
        color[0] = rgb[2];
        color[1] = rgb[1];
        color[2] = rgb[0];
    }
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
    DifferenceMap map = {.pixel_count = pixel_count};
    difference_colors_init(colors);
    for (size_t i = 0; i < 4 * pixel_count; i += 4) {
        int delta = pixel_difference(a + i, b + i);
        const uint8_t *color = colors[delta + UINT8_MAX];
        map.differing_pixels += abs(delta) > 1;
        map.max_difference = abs(delta) > map.max_difference ? abs(delta) : map.max_difference;
        bgrx[i] = color[0];
        bgrx[i + 1] = color[1];
        bgrx[i + 2] = color[2];
        bgrx[i + 3] = UINT8_MAX;
    }
    return map;
}

size_t difference_map_legend(LegendEntry entries[LEGEND_ENTRIES_MAXIMUM]) {
    for (size_t i = 0; i < LEGEND_COUNT; i++) {
        entries[i] = (LegendEntry){.label = NULL};
        snprintf(entries[i].number, sizeof entries[i].number, LEGEND_DIFFERENCES[i] ? "%+d" : "%d",
                 LEGEND_DIFFERENCES[i]);
        palette_color(&palette_diverging, difference_palette_position(LEGEND_DIFFERENCES[i]),
                      entries[i].rgb);
    }
    return LEGEND_COUNT;
}
