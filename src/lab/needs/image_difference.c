/**
 * @file
 * @brief Compares renders.
 */
#include "lab/needs/image_difference.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** @return Encoded light, 8-bit steps. NaN is displayed as black. */
static double encoded_steps(double light, Encoding encoding) {
    double inside = light > 0 ? (light < 1 ? light : 1) : 0;
    return encoding_encode(encoding, inside);
}

double image_difference_steps(const double a[3], const double b[3], Encoding encoding) {
    double worst = 0;
    for (int i = 0; i < 3; i++) {
        if (a[i] != b[i]) {
            worst =
                fmax(worst, fabs(encoded_steps(a[i], encoding) - encoded_steps(b[i], encoding)));
        }
    }
    return worst;
}

/** @return The mean squared difference of the channels of two colours, clamped to 0 to 1. */
static double mean_squared_difference(const double a[3], const double b[3]) {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double away = fmax(0, fmin(1, a[i])) - fmax(0, fmin(1, b[i]));
        sum += away * away;
    }
    return sum / 3;
}

ImageDifference image_difference_of(const SampledRender *a, const SampledRender *b,
                                    const SampledRender *path_reference, Encoding encoding) {
    ImageDifference difference = {.rays = a->ray_count};
    double equal_squares = 0, squares = 0;
    for (size_t i = 0; i < a->ray_count; i++) {
        const double *light = &a->rgb[3 * i], *other = &b->rgb[3 * i];
        bool is_equal = !path_reference || a->path_hashes[i] == path_reference->path_hashes[i];
        double steps = image_difference_steps(light, other, encoding),
               square = mean_squared_difference(light, other);
        squares += square;
        difference.same_path += is_equal;
        difference.edge_flips += !is_equal && steps >= IMAGE_DIFFERENCE_VISIBLE;
        difference.visible += is_equal && steps >= IMAGE_DIFFERENCE_VISIBLE;
        if (is_equal) {
            difference.max_steps = fmax(difference.max_steps, steps);
            equal_squares += square;
        }
    }
    difference.same_path_rms =
        difference.same_path ? sqrt(equal_squares / (double)difference.same_path) : 0;
    difference.total_rms = difference.rays ? sqrt(squares / (double)difference.rays) : 0;
    return difference;
}
