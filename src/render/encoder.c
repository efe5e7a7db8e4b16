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
enum { ENCODER_CELLS = 4096 };

/** Finds where a step begins. The curve backwards comes within a float or two of it; from there the
 *  neighbours are tried, with the curve forwards, which is what the step is defined by. @return The
 *  smallest float whose light is rounded to this step or a higher one. */
static float find_threshold(Encoding encoding, int code) {
    double border = code - 0.5;
    float linear = (float)encoding_decode(encoding, border);
    while (encoding_encode(encoding, (double)linear) >= border) {
        linear = nextafterf(linear, 0.0F);
    }
    while (encoding_encode(encoding, (double)linear) < border) {
        linear = nextafterf(linear, 1.0F);
    }
    return linear;
}

void encoder_init(Encoder *encoder, Encoding encoding) {
    encoder->thresholds[0] = 0;
    for (int code = 1; code <= ENCODING_CODE_MAXIMUM; code++) {
        encoder->thresholds[code] = find_threshold(encoding, code);
    }
    encoder->thresholds[ENCODING_CODE_MAXIMUM + 1] = INFINITY;
    int code = 0;
    for (int i = 0; i <= ENCODER_CELLS; i++) {
        code += (float)i / ENCODER_CELLS >= encoder->thresholds[code + 1];
        encoder->first_codes[i] = (uint8_t)code;
    }
}
