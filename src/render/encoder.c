/**
 * @file
 * @brief From linear light to 8-bit steps, by table.
 *
 * A picture of 8-bit steps needs no power function a pixel. The curve only rises, so each step
 * begins at one light, and to encode is to find the last step that has begun. #encoder_init finds
 * the 255 floats where steps begin, once; #encoder_encode looks one of them up.
 */
#include "dioptre/picture.h"

/** Cells that the light from 0 to 1 is cut into: so fine that each holds at most one threshold,
 *  as the narrowest step, at the dark end of sRGB, is 1 / (12.92 * 255) wide. */
enum { CELLS = 4096 };

/**
 * Finds where a step begins. The curve backwards comes within a float or two of it; from there the
 * neighbours are tried, with the curve forwards, which is what the step is defined by.
 * @param encoding  Which curve.
 * @param step      1 to 255.
 * @return The smallest float whose light is rounded to this step or a higher one.
 */
static float find_threshold(Encoding encoding, int step) {
    double border = step - 0.5;
    float light = (float)encoding_decode(encoding, border);
    while (encoding_encode(encoding, (double)light) >= border) {
        light = nextafterf(light, 0.0F);
    }
    while (encoding_encode(encoding, (double)light) < border) {
        light = nextafterf(light, 1.0F);
    }
    return light;
}

void encoder_init(Encoder *encoder, Encoding encoding) {
    encoder->threshold[0] = 0;
    for (int step = 1; step <= ENCODING_STEP_MAXIMUM; step++) {
        encoder->threshold[step] = find_threshold(encoding, step);
    }
    encoder->threshold[ENCODING_STEP_MAXIMUM + 1] = INFINITY;
    int step = 0;
    for (int i = 0; i <= CELLS; i++) {
        step += (float)i / CELLS >= encoder->threshold[step + 1];
        encoder->cell[i] = (uint8_t)step;
    }
}
