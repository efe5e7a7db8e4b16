/**
 * @file
 * @brief The exact curves between linear light and 8-bit steps: sRGB (IEC 61966-2-1), and none.
 */
#include "base/encoding.h"

#include <math.h>

/** Where sRGB passes from a straight line to a power, in linear light. */
#define SRGB_LINEAR_END 0.0031308
/** The same place, in encoded numbers. */
#define SRGB_ENCODED_END 0.04045
/** Slope of the straight line. */
#define SRGB_SLOPE 12.92
/** Exponent of the power. */
#define SRGB_GAMMA 2.4
/** How far the power is shifted down, so that the two pieces meet. */
#define SRGB_OFFSET 0.055

double encoding_encode(Encoding encoding, double linear) {
    if (encoding == ENCODING_LINEAR) {
        return ENCODING_CODE_MAXIMUM * linear;
    }
    if (linear <= SRGB_LINEAR_END) {
        return ENCODING_CODE_MAXIMUM * (SRGB_SLOPE * linear);
    }
    return ENCODING_CODE_MAXIMUM * ((1 + SRGB_OFFSET) * pow(linear, 1 / SRGB_GAMMA) - SRGB_OFFSET);
}

double encoding_decode(Encoding encoding, double code) {
    double encoded = code / ENCODING_CODE_MAXIMUM;
    if (encoding == ENCODING_LINEAR) {
        return encoded;
    }
    if (encoded <= SRGB_ENCODED_END) {
        return encoded / SRGB_SLOPE;
    }
    return pow((encoded + SRGB_OFFSET) / (1 + SRGB_OFFSET), SRGB_GAMMA);
}
