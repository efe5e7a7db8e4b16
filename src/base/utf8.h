/**
 * @file
 * @brief Characters of UTF-8 text.
 */
#ifndef DIOPTRE_BASE_UTF8_H
#define DIOPTRE_BASE_UTF8_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/**
 * Decodes the character at the start of a text.
 * @param text       The bytes.
 * @param length     Number of bytes, at least 1.
 * @param[out] code  The code point.
 * @return Bytes of the character, 1 to 4; 0: there is no valid one. Overlong forms, surrogates and
 *         numbers above U+10FFFF are invalid (RFC 3629).
 */
size_t utf8_decode(const char *text, size_t length, uint32_t *code);

/**
 * @return Whether a character can change how a terminal shows the text around it: the control
 *         characters U+0000 to U+001F and U+007F to U+009F, and those of the direction of text,
 *         which can make a name look like another (Unicode Technical Report 36, 3.4).
 * @param code  The code point.
 */
bool utf8_is_control(uint32_t code);

/** Takes the last character off a text; does nothing if it is empty. */
void utf8_erase_last(char *text);

/** @return Whether a text is valid and holds no control, as above. @param text The text. */
bool utf8_is_printable(const char *text);

#endif
