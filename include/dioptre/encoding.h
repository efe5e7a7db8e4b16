/**
 * @file
 * @brief The exact curves between linear light and the 8-bit steps of pictures and colours.
 */
#ifndef DIOPTRE_ENCODING_H
#define DIOPTRE_ENCODING_H

/** How linear light becomes the numbers of a picture file. */
typedef enum {
    ENCODING_SRGB,  /**< The exact sRGB curve. */
    ENCODING_LINEAR /**< Left as it is. */
} Encoding;

/** The last step of a channel: full light. */
enum { ENCODING_CODE_MAXIMUM = 255 };

/**
 * Encodes light without rounding it to a step.
 * @param encoding  Which curve.
 * @param linear     Linear light, 0 to 1.
 * @return 0 to #ENCODING_CODE_MAXIMUM, with a fraction.
 */
double encoding_encode(Encoding encoding, double linear);

/**
 * @return The linear light that a step stands for: the middle of what is shown so.
 * @param encoding  Which curve.
 * @param code      0 to #ENCODING_CODE_MAXIMUM, fractions too.
 */
double encoding_decode(Encoding encoding, double code);

#endif
