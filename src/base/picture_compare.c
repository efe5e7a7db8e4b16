/**
 * @file
 * @brief Comparison of two pictures.
 */
#include "base/picture.h"

#include <math.h>
#include <stdlib.h>

/**
 * Largest difference that #PictureComparison.differing_fraction ignores, because rounding can cause
 * it.
 */
enum { DIFFERENCE_TOLERANCE = 1 };
/** Brightness in the map of the smallest difference: visible on black. */
enum { MAP_BRIGHTNESS_MINIMUM = 64 };
/** Channels of a pixel. */
enum { CHANNELS = 3 };

/** Sums over all pixels. */
typedef struct DifferenceSums {
    int max_difference;      /**< Largest difference of a channel, in codes. */
    size_t differing_pixels; /**< Pixels that differ by more than #DIFFERENCE_TOLERANCE. */
    uint64_t code_squares;   /**< Sum of the squared differences, in codes. */
    double linear_squares;   /**< Sum of the squared differences, in linear light. */
    double linear[256];      /**< Linear light of each code. */
} DifferenceSums;

/**
 * Compares one pixel.
 * @param sums  The sums to update.
 * @param a     Red, green and blue.
 * @param b     Red, green and blue of the other picture.
 * @return The largest difference of a channel, 0 to 255.
 */
static int add_pixel_difference(DifferenceSums *sums, const uint8_t *a, const uint8_t *b) {
    int largest = 0;
    for (int channel = 0; channel < CHANNELS; channel++) {
        int difference = abs(a[channel] - b[channel]);
        double linear_difference = sums->linear[a[channel]] - sums->linear[b[channel]];
        sums->code_squares += (uint64_t)(difference * difference);
        sums->linear_squares += linear_difference * linear_difference;
        largest = difference > largest ? difference : largest;
    }
    sums->max_difference = largest > sums->max_difference ? largest : sums->max_difference;
    sums->differing_pixels += largest > DIFFERENCE_TOLERANCE;
    return largest;
}

/**
 * Draws a pixel of the map.
 * @param[out] pixel  Its red, green and blue.
 * @param difference       Largest difference of a channel, 0 to 255.
 */
static void set_map_pixel(uint8_t *pixel, int difference) {
    int grey = difference == 0 ? 0
                               : MAP_BRIGHTNESS_MINIMUM +
                                     difference * (UINT8_MAX - MAP_BRIGHTNESS_MINIMUM) / UINT8_MAX;
    for (int channel = 0; channel < CHANNELS; channel++) {
        pixel[channel] = (uint8_t)grey;
    }
}

/**
 * @return The comparison of the sums over all pixels.
 * @param sums  The sums.
 */
static PictureComparison comparison_from_sums(const DifferenceSums *sums, int width, int height) {
    double pixels = (double)width * height;
    double mean_square = (double)sums->code_squares / (CHANNELS * pixels);
    return (PictureComparison){
        .width = width,
        .height = height,
        .max_difference = sums->max_difference,
        .differing_fraction = (double)sums->differing_pixels / pixels,
        .rmse = sqrt(sums->linear_squares / (CHANNELS * pixels)),
        .psnr =
            mean_square > 0 ? 10 * log10(UINT8_MAX * UINT8_MAX / mean_square) : (double)INFINITY,
    };
}

PictureComparison picture_compare(const Picture *a, const Picture *b, Picture *map) {
    DifferenceSums sums = {0};
    for (int code = 0; code <= UINT8_MAX; code++) {
        sums.linear[code] = encoding_decode(ENCODING_SRGB, code);
    }
    size_t bytes = (size_t)a->width * (size_t)a->height * CHANNELS;
    for (size_t i = 0; i < bytes; i += CHANNELS) {
        int difference = add_pixel_difference(&sums, a->pixels + i, b->pixels + i);
        if (map) {
            set_map_pixel(map->pixels + i, difference);
        }
    }
    return comparison_from_sums(&sums, a->width, a->height);
}
