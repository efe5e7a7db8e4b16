/**
 * @file
 * @brief Encoding of linear light to 8 bits by table.
 *
 * The transfer curve is monotonic: each code begins at one threshold. Encoding is a search for the
 * last threshold that is not above the light. #encoder_init computes the 255 thresholds once;
 * #encoder_encode needs no power function.
 */
#include "base/picture.h"

#include <math.h>

/**
 * Computes the threshold of a code. The inverse curve gives an estimate within a few floats; its
 * neighbours are tested with the forward curve, which defines the codes.
 * @return The smallest float that is rounded to this code or a higher one.
 */
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
