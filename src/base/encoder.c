/**
 * @file
 * @brief Encoding of linear light to 8 bits by table.
 *
 * The transfer curve is monotonic, so each code begins at one threshold, and encoding is a search
 * for the last threshold that is not above the light. #encoder_init finds the 255 thresholds once;
 * #encoder_encode needs no power function.
 */
#include "base/picture.h"

#include <math.h>

/** Cells of the table over 0 to 1. Each holds at most one threshold, as the narrowest step, at the
 *  dark end of sRGB, is 1 / (12.92 * 255) wide. */
enum { ENCODER_CELLS = 4096 };

/** Finds the threshold of a code. The inverse curve comes within a float or two; from there
 *  neighbours are tried with the forward curve, which defines the code. @return The least float
 * that is rounded to this code or a higher one. */
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
