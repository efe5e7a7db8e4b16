/**
 * @file
 * @brief How two pictures differ.
 */
#include "dioptre/picture.h"

#include <stdlib.h>

/** Steps that a pixel may be off before #Comparison.share_off counts it: rounding at a border. */
enum { STEPS_ALLOWED = 1 };
/** Brightness in the map of a pixel that is off by the least: dim, but to be seen on black. */
enum { MAP_FLOOR = 64 };
/** Colours a pixel. */
enum { CHANNELS = 3 };

/** What is added up over all pixels. */
typedef struct Sums {
    int worst_step;        /**< Largest difference of a channel, in steps. */
    size_t pixels_off;     /**< Pixels that are off by more than `STEPS_ALLOWED`. */
    uint64_t step_squares; /**< Sum of the squares of the differences, in steps. */
    double light_squares;  /**< Sum of the squares of the differences, in linear light. */
    double light[256];     /**< The linear light of each step. */
} Sums;

/**
 * Compares one pixel.
 * @param[in,out] sums  What is added to.
 * @param a             Red, green and blue.
 * @param b             Red, green and blue of the other.
 * @return The largest difference of a channel, 0 to 255 steps.
 */
static int compare_pixel(Sums *sums, const uint8_t *a, const uint8_t *b) {
    int largest = 0;
    for (int channel = 0; channel < CHANNELS; channel++) {
        int steps = abs(a[channel] - b[channel]);
        double light = sums->light[a[channel]] - sums->light[b[channel]];
        sums->step_squares += (uint64_t)(steps * steps);
        sums->light_squares += light * light;
        largest = steps > largest ? steps : largest;
    }
    sums->worst_step = largest > sums->worst_step ? largest : sums->worst_step;
    sums->pixels_off += largest > STEPS_ALLOWED;
    return largest;
}

/**
 * Draws a pixel of the map.
 * @param[out] pixel  Its red, green and blue.
 * @param steps       How far the pixel is off, 0 to 255.
 */
static void draw_difference(uint8_t *pixel, int steps) {
    int grey = steps == 0 ? 0 : MAP_FLOOR + steps * (UINT8_MAX - MAP_FLOOR) / UINT8_MAX;
    for (int channel = 0; channel < CHANNELS; channel++) {
        pixel[channel] = (uint8_t)grey;
    }
}

/**
 * Makes the measures of the sums.
 * @param sums    The sums over all pixels.
 * @param width   Pixels.
 * @param height  Pixels.
 * @return The measures.
 */
static Comparison conclude(const Sums *sums, int width, int height) {
    double pixels = (double)width * height;
    double step_error = (double)sums->step_squares / (CHANNELS * pixels);
    return (Comparison){
        .width = width,
        .height = height,
        .worst_step = sums->worst_step,
        .share_off = (double)sums->pixels_off / pixels,
        .rmse = sqrt(sums->light_squares / (CHANNELS * pixels)),
        .psnr = step_error > 0 ? 10 * log10(UINT8_MAX * UINT8_MAX / step_error) : (double)INFINITY,
    };
}

Comparison picture_compare(const Picture *a, const Picture *b, Picture *map) {
    Sums sums = {0};
    for (int step = 0; step <= UINT8_MAX; step++) {
        sums.light[step] = encoding_decode(ENCODING_SRGB, step);
    }
    size_t bytes = (size_t)a->width * (size_t)a->height * CHANNELS;
    for (size_t i = 0; i < bytes; i += CHANNELS) {
        int steps = compare_pixel(&sums, a->pixels + i, b->pixels + i);
        if (map) {
            draw_difference(map->pixels + i, steps);
        }
    }
    return conclude(&sums, a->width, a->height);
}
