/**
 * @file
 * @brief Text of strangers, escaped for terminals.
 */
#include "base/sanitize.h"

#include "base/utf8.h"

#include <string.h>

/** Size of an escape such as `\255`, with its final zero. */
enum { ESCAPE_SIZE = 5 };

/** A piece of sanitized text: a printable character, or the escape of a byte. */
typedef struct Piece {
    const char *bytes;        /**< Its bytes: in the text, or #escape. */
    size_t size;              /**< Their number. */
    size_t consumed;          /**< Bytes of the text that it stands for. */
    char escape[ESCAPE_SIZE]; /**< Memory for an escape. */
} Piece;

/**
 * Sanitizes the start of a text.
 * @param[out] piece  The piece; must not move afterwards.
 * @param text        The text.
 * @param length      Its bytes, at least 1.
 * @param is_line     Whether newlines and tabs are escaped, too.
 */
static void take_piece(Piece *piece, const char *text, size_t length, bool is_line) {
    uint32_t code = 0;
    size_t size = utf8_decode(text, length, &code);
    bool is_blank = !is_line && (code == '\n' || code == '\t');
    if (size > 0 && (is_blank || !utf8_is_control(code))) {
        *piece = (Piece){.bytes = text, .size = size, .consumed = size};
        return;
    }
    *piece = (Piece){.bytes = piece->escape, .consumed = 1};
    piece->size =
        (size_t)snprintf(piece->escape, ESCAPE_SIZE, "\\%u", (unsigned)(unsigned char)text[0]);
}

/** Copies text; see #sanitize_text and #sanitize_line. */
static void copy_sanitized(char *out, size_t size, const char *text, size_t length, bool is_line) {
    size_t written = 0;
    Piece piece;
    for (; length > 0; text += piece.consumed, length -= piece.consumed) {
        take_piece(&piece, text, length, is_line);
        if (written + piece.size >= size) {
            break;
        }
        memcpy(out + written, piece.bytes, piece.size);
        written += piece.size;
    }
    out[written] = '\0';
}

/** Prints text; see #sanitize_print and #sanitize_print_line. */
static void print_sanitized(const char *text, FILE *stream, bool is_line) {
    Piece piece;
    for (size_t left = strlen(text); left > 0; text += piece.consumed, left -= piece.consumed) {
        take_piece(&piece, text, left, is_line);
        fwrite(piece.bytes, 1, piece.size, stream);
    }
}

void sanitize_text(char *out, size_t size, const char *text, size_t length) {
    copy_sanitized(out, size, text, length, false);
}

void sanitize_line(char *out, size_t size, const char *text) {
    copy_sanitized(out, size, text, strlen(text), true);
}

void sanitize_path(char out[SANITIZED_PATH_SIZE], const char *path) {
    static const char ellipsis[] = "...";
    size_t tail_length = SANITIZED_PATH_SIZE - sizeof ellipsis;
    size_t length = strlen(path);
    if (length < SANITIZED_PATH_SIZE) {
        sanitize_line(out, SANITIZED_PATH_SIZE, path);
        return;
    }
    memcpy(out, ellipsis, sizeof ellipsis);
    sanitize_line(out + strlen(ellipsis), tail_length + 1, path + length - tail_length);
}

void sanitize_print(const char *text, FILE *stream) {
    print_sanitized(text, stream, false);
}

void sanitize_print_line(const char *text, FILE *stream) {
    print_sanitized(text, stream, true);
}
