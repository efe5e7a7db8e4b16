/**
 * @file
 * @brief Hexadecimal colours, such as `#ff8000`.
 */
#include "script/hex_color.h"

#include "base/encoding.h"

#include <ctype.h>
#include <stdlib.h>

/**
 * @return A channel of a colour in linear light, 0 to 1.
 * @param text  Two hexadecimal digits; what follows is not read.
 */
static double read_channel(const char *text) {
    char digits[] = {text[0], text[1], '\0'};
    return encoding_decode(ENCODING_SRGB, (double)strtol(digits, NULL, 16));
}

bool hex_color_read(const char *text, size_t length, Rgbd *color) {
    if (length != 7 || text[0] != '#') {
        return false;
    }
    for (size_t i = 1; i < length; i++) {
        if (!isxdigit((unsigned char)text[i])) {
            return false;
        }
    }
    *color = (Rgbd){read_channel(text + 1), read_channel(text + 3), read_channel(text + 5)};
    return true;
}
