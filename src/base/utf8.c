/**
 * @file
 * @brief Characters of UTF-8 text.
 */
#include "base/utf8.h"

#include <string.h>

/** Bits of a byte that follows the first one of a character: these are 10, then six of the code. */
enum { FOLLOWING_MASK = 0xC0, FOLLOWING_MARK = 0x80, FOLLOWING_BITS = 6 };

size_t utf8_decode(const char *text, size_t length, uint32_t *code) {
    static const uint32_t minimums[] = {0, 0, 0x80, 0x800, 0x10000}; // Per number of bytes.
    const unsigned char *bytes = (const unsigned char *)text;
    unsigned char lead = bytes[0];
    size_t size = lead < 0x80 ? 1 : lead < 0xC0 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (size == 0 || size > length || lead >= 0xF8) {
        return 0;
    }
    *code = size == 1 ? lead : lead & (0x7Fu >> size);
    for (size_t i = 1; i < size; i++) {
        if ((bytes[i] & FOLLOWING_MASK) != FOLLOWING_MARK) {
            return 0;
        }
        *code = *code << FOLLOWING_BITS | (bytes[i] & (uint32_t)~FOLLOWING_MASK);
    }
    bool is_surrogate = *code >= 0xD800 && *code <= 0xDFFF;
    return *code < minimums[size] || *code > 0x10FFFF || is_surrogate ? 0 : size;
}

bool utf8_is_control(uint32_t code) {
    bool is_direction = code == 0x061C || code == 0x200E || code == 0x200F ||
                        (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
    return code < 0x20 || (code >= 0x7F && code <= 0x9F) || is_direction;
}

bool utf8_is_printable(const char *text) {
    size_t size = 0;
    for (size_t left = strlen(text); left > 0; left -= size, text += size) {
        uint32_t code;
        size = utf8_decode(text, left, &code);
        if (size == 0 || utf8_is_control(code)) {
            return false;
        }
    }
    return true;
}

void utf8_erase_last(char *text) {
    size_t length = strlen(text);
    while (length > 0 && (text[length - 1] & 0xC0) == 0x80) {
        length--; // A continuation byte.
    }
    text[length > 0 ? length - 1 : 0] = '\0';
}
