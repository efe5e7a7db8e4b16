/**
 * @file
 * @brief The exact transfer curves between linear light and 8-bit codes: sRGB (IEC 61966-2-1) and
 * linear.
 */
#include "base/encoding.h"

#include <math.h>

/** End of the linear part of the sRGB curve, in linear light. */
#define SRGB_LINEAR_END 0.0031308
/** End of the linear part, in encoded values. */
#define SRGB_ENCODED_END 0.04045
/** Slope of the linear part. */
#define SRGB_SLOPE 12.92
/** Exponent of the power part. */
#define SRGB_GAMMA 2.4
/** Offset of the power part, which makes the curve continuous. */
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

double encoding_difference(Encoding encoding, double a, double b) {
    /** Relative difference below which the subtraction of two encoded values would lose digits. */
    const double near = 1e-3;
    double difference = a - b;
    if (encoding == ENCODING_LINEAR || fmax(a, b) <= SRGB_LINEAR_END) {
        double slope = encoding == ENCODING_LINEAR ? 1 : SRGB_SLOPE;
        return ENCODING_CODE_MAXIMUM * slope * difference;
    }
    if (fmin(a, b) > SRGB_LINEAR_END && fabs(difference) < near * b) {
        double power = (1 + SRGB_OFFSET) * pow(b, 1 / SRGB_GAMMA);
        return ENCODING_CODE_MAXIMUM * power * expm1(log1p(difference / b) / SRGB_GAMMA);
    }
    return encoding_encode(encoding, a) - encoding_encode(encoding, b);
}

double encoding_decode(Encoding encoding, double code) {
    double encoded = code / ENCODING_CODE_MAXIMUM;
    if (encoding == ENCODING_LINEAR) {
        return encoded;
    }
    if (encoded <= SRGB_ENCODED_END) {
        return encoded / SRGB_SLOPE;
    }
    // At most 1, also while the processor rounds upwards: white is a valid colour.
    return fmin(pow((encoded + SRGB_OFFSET) / (1 + SRGB_OFFSET), SRGB_GAMMA), 1);
}
