/**
 * @file
 * @brief Words from outside, made safe to show on a terminal.
 */
#include "script/text.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/**
 * @return Bytes of the character that a first byte begins, by UTF-8; 0 if none begins so.
 * @param first  The byte, 0x80 or more.
 */
static size_t sequence_length(unsigned char first) {
    if (first >= 0xC2 && first <= 0xDF) {
        return 2;
    }
    if (first >= 0xE0 && first <= 0xEF) {
        return 3;
    }
    return first >= 0xF0 && first <= 0xF4 ? 4 : 0;
}

/**
 * @return Bytes of the character at the start of a text that is longer than a byte; 0 where there
 *         is none, or only one of the control characters U+0080 to U+009F.
 * @param text    Bytes; the first is 0x80 or more.
 * @param length  How many, at least 1.
 */
static size_t wide_character(const unsigned char *text, size_t length) {
    size_t wanted = sequence_length(text[0]);
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
 * @return Bytes of the character at the start of a text that may be shown as it is; 0 where the
 *         first byte has to be escaped.
 * @param text    Bytes.
 * @param length  How many, at least 1.
 */
static size_t printable_character(const unsigned char *text, size_t length) {
    if (text[0] >= 0x80) {
        return wide_character(text, length);
    }
    bool is_blank = text[0] == '\n' || text[0] == '\t';
    bool is_control = text[0] < 0x20 || text[0] == 0x7F;
    return is_control && !is_blank ? 0 : 1;
}

void text_clean(char *out, size_t size, const char *text, size_t length) {
    const unsigned char *from = (const unsigned char *)text;
    size_t written = 0;
    while (length > 0) {
        char escape[] = "\\255";
        size_t taken = printable_character(from, length);
        const void *piece = taken ? (const void *)from : escape;
        size_t piece_length =
            taken ? taken : (size_t)snprintf(escape, sizeof escape, "\\%u", from[0]);
        if (written + piece_length >= size) {
            break;
        }
        memcpy(out + written, piece, piece_length);
        written += piece_length;
        from += taken ? taken : 1;
        length -= taken ? taken : 1;
    }
    out[written] = '\0';
}

void text_clean_path(char out[TEXT_PATH_SIZE], const char *path) {
    static const char mark[] = "...";
    size_t room = TEXT_PATH_SIZE - sizeof mark;
    size_t length = strlen(path);
    if (length < TEXT_PATH_SIZE) {
        text_clean(out, TEXT_PATH_SIZE, path, length);
        return;
    }
    memcpy(out, mark, sizeof mark);
    text_clean(out + strlen(mark), room + 1, path + length - room, room);
}
