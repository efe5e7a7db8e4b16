/**
 * @file
 * @brief Comparing shots.
 */
#include "lab/contrast.h"

#include <math.h>

/** @return A light as it is shown, steps. What is no number is shown as black.
 *  @param light Linear light. @param encoding How. */
static double shown(double light, Encoding encoding) {
    double inside = light > 0 ? (light < 1 ? light : 1) : 0;
    return encoding_encode(encoding, inside);
}

double contrast_steps(const double a[3], const double b[3], Encoding encoding) {
    double worst = 0;
    for (int i = 0; i < 3; i++) {
        if (a[i] != b[i]) {
            worst = fmax(worst, fabs(shown(a[i], encoding) - shown(b[i], encoding)));
        }
    }
    return worst;
}

/** @return The square of the difference of two colours, mean of the primaries, of light that is
 *          shown. @param a Linear light. @param b Linear light. */
static double light_square(const double a[3], const double b[3]) {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double away = fmax(0, fmin(1, a[i])) - fmax(0, fmin(1, b[i]));
        sum += away * away;
    }
    return sum / 3;
}

Contrast contrast_of(const Shot *a, const Shot *b, const Shot *trails, Encoding encoding) {
    Contrast contrast = {.rays = a->count};
    double equal_squares = 0, squares = 0;
    for (size_t i = 0; i < a->count; i++) {
        const double *light = &a->rgb[3 * i], *other = &b->rgb[3 * i];
        bool is_equal = !trails || a->trails[i] == trails->trails[i];
        double steps = contrast_steps(light, other, encoding), square = light_square(light, other);
        squares += square;
        contrast.equal += is_equal;
        contrast.flips += !is_equal && steps >= CONTRAST_VISIBLE;
        contrast.off += is_equal && steps >= CONTRAST_VISIBLE;
        if (is_equal) {
            contrast.worst = fmax(contrast.worst, steps);
            equal_squares += square;
        }
    }
    contrast.mean = contrast.equal ? sqrt(equal_squares / (double)contrast.equal) : 0;
    contrast.whole = contrast.rays ? sqrt(squares / (double)contrast.rays) : 0;
    return contrast;
}
