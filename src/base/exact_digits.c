/**
 * @file
 * @brief The digits with which a number is written so that it can be read back exactly.
 */
#include "base/exact_digits.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>

int exact_digits(double value, int least) {
    /** Bytes of a number with all its digits, a sign, a point, an exponent and the final zero. */
    enum { TEXT_SIZE = DBL_DECIMAL_DIG + 8 };
    char text[TEXT_SIZE];
    int digits = least - 1;
    do {
        digits++;
        snprintf(text, sizeof text, "%.*g", digits, value);
    } while (digits < DBL_DECIMAL_DIG && strtod(text, NULL) != value);
    return digits;
}
