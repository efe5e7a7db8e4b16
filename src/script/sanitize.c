/**
 * @file
 * @brief Text of scenes, escaped for terminals.
 */
#include "script/sanitize.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/**
 * @return Length of a UTF-8 sequence by its first byte, 2 to 4; 0 if the byte is invalid there.
 * @param first  The byte, 0x80 or more.
 */
static size_t utf8_sequence_length(unsigned char first) {
    if (first >= 0xC2 && first <= 0xDF) {
        return 2;
    }
    if (first >= 0xE0 && first <= 0xEF) {
        return 3;
    }
    return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

/**
 * @return Length of the multibyte character at the start of a text; 0 if there is none, or if it is
 *         a control character (U+0080 to U+009F).
 * @param text    Bytes; the first is 0x80 or more.
 * @param length  Number of bytes, at least 1.
 */
static size_t utf8_character_length(const unsigned char *text, size_t length) {
    size_t wanted = utf8_sequence_length(text[0]);
    if (wanted == 0 || wanted > length) {
        return 0;
    }
    for (size_t i = 1; i < wanted; i++) {
        if ((text[i] & 0xC0) != 0x80) {
            return 0;
        }
    }
    bool is_control = text[0] == 0xC2 && text[1] < 0xA0;
    return is_control ? 0 : wanted;
}

/**
 * @return Length of the printable character at the start of a text; 0 if its first byte must be
 *         escaped.
 * @param text    The bytes.
 * @param length  Number of bytes, at least 1.
 */
static size_t printable_length(const unsigned char *text, size_t length) {
    if (text[0] >= 0x80) {
        return utf8_character_length(text, length);
    }
    bool is_blank = text[0] == '\n' || text[0] == '\t';
    bool is_control = text[0] < 0x20 || text[0] == 0x7F;
    return is_control && !is_blank ? 0 : 1;
}

void sanitize_text(char *out, size_t size, const char *text, size_t length) {
    const unsigned char *in = (const unsigned char *)text;
    size_t written = 0;
    while (length > 0) {
        char escape[] = "\\255";
        size_t consumed = printable_length(in, length);
        const void *piece = consumed ? (const void *)in : escape;
        size_t piece_length =
            consumed ? consumed : (size_t)snprintf(escape, sizeof escape, "\\%u", in[0]);
        if (written + piece_length >= size) {
            break;
        }
        memcpy(out + written, piece, piece_length);
        written += piece_length;
        in += consumed ? consumed : 1;
        length -= consumed ? consumed : 1;
    }
    out[written] = '\0';
}

void sanitize_path(char out[SANITIZED_PATH_SIZE], const char *path) {
    static const char ellipsis[] = "...";
    size_t tail_length = SANITIZED_PATH_SIZE - sizeof ellipsis;
    size_t length = strlen(path);
    if (length < SANITIZED_PATH_SIZE) {
        sanitize_text(out, SANITIZED_PATH_SIZE, path, length);
        return;
    }
    memcpy(out, ellipsis, sizeof ellipsis);
    sanitize_text(out + strlen(ellipsis), tail_length + 1, path + length - tail_length,
                  tail_length);
}
