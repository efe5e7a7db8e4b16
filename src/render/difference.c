/**
 * @file
 * @brief The difference of two pictures, in colours.
 */
#include "dioptre/difference.h"

#include "render/palette.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/** Steps at which the legend has a number, from the greatest on. */
static const int TICK_STEPS[] = {255, 31, 7, 1, 0, -1, -7, -31, -255};
/** How many. */
enum { TICK_COUNT = sizeof TICK_STEPS / sizeof TICK_STEPS[0] };

/** @return Where a difference stands between the ends of its colours: one step is far from none,
 * and the largest are near each other. @param steps The difference. */
static double steps_share(int steps) {
    double bits = log2(1.0 + abs(steps)) / 8; // 255 steps: 8 bits.
    return 0.5 + (steps < 0 ? -bits : bits) / 2;
}

/** Makes the colours of all differences. @param[out] colors Of -255 to 255: blue, green, red. */
static void colors_make(uint8_t colors[2 * UINT8_MAX + 1][3]) {
    for (int steps = -UINT8_MAX; steps <= UINT8_MAX; steps++) {
        uint8_t *color = colors[steps + UINT8_MAX], rgb[3];
        palette_color(&palette_signed, steps_share(steps), rgb);
        color[0] = rgb[2];
        color[1] = rgb[1];
        color[2] = rgb[0];
    }
}

/** @return The difference of the primary that differs most, with its sign. @param a A pixel.
 *  @param b Another. */
static int pixel_steps(const uint8_t *a, const uint8_t *b) {
    int most = 0;
    for (int i = 0; i < 3; i++) {
        int steps = a[i] - b[i];
        most = abs(steps) > abs(most) ? steps : most;
    }
    return most;
}

Difference difference_draw(const uint8_t *a, const uint8_t *b, size_t pixels, uint8_t *bgrx) {
    uint8_t colors[2 * UINT8_MAX + 1][3];
    Difference difference = {.pixels = pixels};
    colors_make(colors);
    for (size_t i = 0; i < 4 * pixels; i += 4) {
        int steps = pixel_steps(a + i, b + i);
        const uint8_t *color = colors[steps + UINT8_MAX];
        difference.off += abs(steps) > 1;
        difference.worst = abs(steps) > difference.worst ? abs(steps) : difference.worst;
        bgrx[i] = color[0];
        bgrx[i + 1] = color[1];
        bgrx[i + 2] = color[2];
        bgrx[i + 3] = UINT8_MAX;
    }
    return difference;
}

size_t difference_legend(LayerTick ticks[LAYER_TICKS]) {
    for (size_t i = 0; i < TICK_COUNT; i++) {
        ticks[i] = (LayerTick){.words = NULL};
        snprintf(ticks[i].number, sizeof ticks[i].number, TICK_STEPS[i] ? "%+d" : "%d",
                 TICK_STEPS[i]);
        palette_color(&palette_signed, steps_share(TICK_STEPS[i]), ticks[i].rgb);
    }
    return TICK_COUNT;
}
