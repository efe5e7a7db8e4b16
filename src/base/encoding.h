/**
 * @file
 * @brief The exact transfer curves between linear light and 8-bit codes.
 */
#ifndef DIOPTRE_BASE_ENCODING_H
#define DIOPTRE_BASE_ENCODING_H

/** A transfer curve. */
typedef enum {
    ENCODING_SRGB,  /**< The exact sRGB curve. */
    ENCODING_LINEAR /**< Linear. */
} Encoding;

/** Largest code. */
enum { ENCODING_CODE_MAXIMUM = 255 };

/**
 * Encodes linear light without rounding.
 * @param encoding  The curve.
 * @param linear     Linear light, 0 to 1.
 * @return 0 to #ENCODING_CODE_MAXIMUM, with a fraction.
 */
double encoding_encode(Encoding encoding, double linear);

/**
 * @return The encoded value of \p a minus that of \p b. Values that lie close together lose no
 *         digits.
 * @param encoding  The curve.
 * @param a         Linear light, 0 to 1.
 * @param b         The same.
 */
double encoding_difference(Encoding encoding, double a, double b);

/**
 * @return The linear light of a code.
 * @param encoding  The curve.
 * @param code      0 to #ENCODING_CODE_MAXIMUM, also with a fraction.
 */
double encoding_decode(Encoding encoding, double code);

#endif
