/**
 * @file
 * @brief The exact curve between linear light and 8-bit steps (IEC 61966-2-1).
 *
 * A picture of 8-bit steps needs no power function a pixel. The curve only rises, so each step
 * begins at one light, and to encode is to find the last step that has begun. #encoder_init finds
 * the 255 floats where steps begin, once; #encoder_encode looks one of them up.
 */
#include "dioptre/picture.h"

/** The last step of a channel: full light. */
enum { STEP_MAXIMUM = 255 };
/** Cells that the light from 0 to 1 is cut into: so fine that each holds at most one threshold,
 *  as the narrowest step, at the dark end of sRGB, is 1 / (12.92 * 255) wide. */
enum { CELLS = 4096 };

/** Where sRGB passes from a straight line to a power, in linear light. */
#define SRGB_LINEAR_END 0.0031308
/** The same place, in encoded numbers. */
#define SRGB_ENCODED_END 0.04045
/** Slope of the straight line. */
#define SRGB_SLOPE 12.92
/** Exponent of the power. */
#define SRGB_GAMMA 2.4
/** How far the power is shifted down, so that the two pieces meet. */
#define SRGB_SHIFT 0.055

/**
 * Encodes light without rounding it to a step.
 * @param encoding  Which curve.
 * @param light     Linear light, 0 to 1.
 * @return 0 to 255, with a fraction.
 */
static double encode_exactly(Encoding encoding, double light) {
    if (encoding == ENCODING_LINEAR) {
        return STEP_MAXIMUM * light;
    }
    if (light <= SRGB_LINEAR_END) {
        return STEP_MAXIMUM * (SRGB_SLOPE * light);
    }
    return STEP_MAXIMUM * ((1 + SRGB_SHIFT) * pow(light, 1 / SRGB_GAMMA) - SRGB_SHIFT);
}

/**
 * Decodes a number of the encoded scale.
 * @param encoding  Which curve.
 * @param step      0 to 255, fractions too.
 * @return Linear light, 0 to 1.
 */
static double decode_exactly(Encoding encoding, double step) {
    double encoded = step / STEP_MAXIMUM;
    if (encoding == ENCODING_LINEAR) {
        return encoded;
    }
    if (encoded <= SRGB_ENCODED_END) {
        return encoded / SRGB_SLOPE;
    }
    return pow((encoded + SRGB_SHIFT) / (1 + SRGB_SHIFT), SRGB_GAMMA);
}

/**
 * Finds where a step begins. The curve backwards comes within a float or two of it; from there the
 * neighbours are tried, with the curve forwards, which is what the step is defined by.
 * @param encoding  Which curve.
 * @param step      1 to 255.
 * @return The smallest float whose light is rounded to this step or a higher one.
 */
static float find_threshold(Encoding encoding, int step) {
    double border = step - 0.5;
    float light = (float)decode_exactly(encoding, border);
    while (encode_exactly(encoding, (double)light) >= border) {
        light = nextafterf(light, 0.0F);
    }
    while (encode_exactly(encoding, (double)light) < border) {
        light = nextafterf(light, 1.0F);
    }
    return light;
}

void encoder_init(Encoder *encoder, Encoding encoding) {
    encoder->threshold[0] = 0;
    for (int step = 1; step <= STEP_MAXIMUM; step++) {
        encoder->threshold[step] = find_threshold(encoding, step);
    }
    encoder->threshold[STEP_MAXIMUM + 1] = INFINITY;
    int step = 0;
    for (int i = 0; i <= CELLS; i++) {
        step += (float)i / CELLS >= encoder->threshold[step + 1];
        encoder->cell[i] = (uint8_t)step;
    }
}

double encoding_decode(Encoding encoding, uint8_t step) {
    return decode_exactly(encoding, step);
}
