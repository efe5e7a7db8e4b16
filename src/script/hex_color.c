/**
 * @file
 * @brief Colours as on the web.
 */
#include "script/hex_color.h"

#include <ctype.h>
#include <stdlib.h>

/**
 * @return The linear light of an encoded part of a colour, 0 to 1 (IEC 61966-2-1).
 * @param text  Two hexadecimal digits, and then anything.
 */
static double read_part(const char *text) {
    char digits[] = {text[0], text[1], '\0'};
    double encoded = (double)strtol(digits, NULL, 16) / 255;
    return encoded <= 0.04045 ? encoded / 12.92 : pow((encoded + 0.055) / 1.055, 2.4);
}

bool hex_color_read(const char *text, size_t length, Color *color) {
    if (length != 7 || text[0] != '#') {
        return false;
    }
    for (size_t i = 1; i < length; i++) {
        if (!isxdigit((unsigned char)text[i])) {
            return false;
        }
    }
    *color = (Color){read_part(text + 1), read_part(text + 3), read_part(text + 5)};
    return true;
}
