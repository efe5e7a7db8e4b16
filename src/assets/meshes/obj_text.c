/**
 * @file
 * @brief The statements, words and numbers of an OBJ text.
 */
#include "assets/meshes/obj_text.h"

#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/** Size of the longest number, with its final zero; exporters write 25 characters or fewer. */
enum { NUMBER_SIZE = 1024 };
/** Largest number of digits that a double and a uint64_t always hold exactly. */
enum { EXACT_DIGITS = 15 };
/** Largest power of ten that a double holds exactly. */
enum { EXACT_POWER = 22 };
/** Exponents are read up to this size; zero or infinity is certain before it. */
enum { EXPONENT_MAXIMUM = 99999 };

/** @return Whether a character separates words. */
static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

/** @return Whether a character ends a line. */
static bool is_newline(char c) {
    return c == '\n' || c == '\r';
}

/** @return Whether a character is a decimal digit. */
static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/** Moves the position behind the end of a line, at which it is. */
static void skip_newline(ObjText *text) {
    bool is_pair = text->end - text->next >= 2 && text->next[0] == '\r' && text->next[1] == '\n';
    text->next += is_pair ? 2 : 1;
    text->line++;
}

/** @return Whether the statement continues in the next line. */
static bool is_continuation(const ObjText *text) {
    return text->next < text->end && *text->next == '\\' &&
           (text->next + 1 == text->end || is_newline(text->next[1]));
}

/** Moves the position behind a continuation, at which it is. */
static void skip_continuation(ObjText *text) {
    text->next++;
    if (text->next < text->end) {
        skip_newline(text);
    }
}

/** Moves the position to the next word, or to the end of the statement. */
static void skip_blanks(ObjText *text) {
    while (text->next < text->end) {
        if (is_blank(*text->next)) {
            text->next++;
        } else if (is_continuation(text)) {
            skip_continuation(text);
        } else {
            break;
        }
    }
}

ObjText obj_text_start(const char *text, size_t size) {
    static const char mark[] = "\xEF\xBB\xBF";
    size_t length = sizeof mark - 1;
    bool is_marked = size >= length && memcmp(text, mark, length) == 0;
    return (ObjText){.next = text + (is_marked ? length : 0), .end = text + size, .line = 1};
}

bool obj_text_is_at_end(ObjText *text) {
    skip_blanks(text);
    return text->next == text->end || is_newline(*text->next) || *text->next == '#';
}

/** Moves the position to the end of its line, in which a backslash continues nothing. */
static void skip_comment(ObjText *text) {
    while (text->next < text->end && !is_newline(*text->next)) {
        text->next++;
    }
}

void obj_text_next_statement(ObjText *text) {
    while (text->next < text->end && !is_newline(*text->next)) {
        if (*text->next == '#') {
            skip_comment(text);
        } else if (is_continuation(text)) {
            skip_continuation(text);
        } else {
            text->next++;
        }
    }
    if (text->next < text->end) {
        skip_newline(text);
    }
}

bool obj_text_is_word_end(const ObjText *text) {
    return text->next == text->end || is_blank(*text->next) || is_newline(*text->next) ||
           *text->next == '#' || is_continuation(text);
}

ObjWord obj_text_word(ObjText *text) {
    skip_blanks(text);
    ObjWord word = {.start = text->next};
    while (!obj_text_is_word_end(text)) {
        text->next++;
    }
    word.length = (size_t)(text->next - word.start);
    return word;
}

/** A decimal number as it is written: digits times a power of ten. */
typedef struct Decimal {
    bool is_negative; /**< Whether its sign is `-`. */
    uint64_t digits;  /**< Its digits, without the point; wraps around if there are too many. */
    int digit_count;  /**< Number of digits from the first that is not zero. */
    int written;      /**< Number of digits, zeros too. */
    long exponent;    /**< The power of ten. */
} Decimal;

/** Reads a sign. @return Whether it is `-`. */
static bool read_sign(const char **next, const char *end) {
    bool is_negative = *next < end && **next == '-';
    *next += *next < end && (**next == '-' || **next == '+');
    return is_negative;
}

/** Reads digits. @return Number of digits. */
static int read_digits(Decimal *decimal, const char **next, const char *end) {
    const char *start = *next;
    for (; *next < end && is_digit(**next) && *next - start < NUMBER_SIZE; (*next)++) {
        decimal->digits = 10 * decimal->digits + (uint64_t)(**next - '0');
        decimal->digit_count += decimal->digit_count > 0 || **next != '0';
    }
    decimal->written += (int)(*next - start);
    return (int)(*next - start);
}

/** Reads the exponent of a number. @return false if it has no digits. */
static bool read_exponent(Decimal *decimal, const char **next, const char *end) {
    if (*next == end || (**next != 'e' && **next != 'E')) {
        return true;
    }
    ++*next;
    bool is_negative = read_sign(next, end);
    const char *start = *next;
    long exponent = 0;
    for (; *next < end && is_digit(**next); (*next)++) {
        exponent = exponent < EXPONENT_MAXIMUM ? 10 * exponent + (**next - '0') : exponent;
    }
    decimal->exponent += is_negative ? -exponent : exponent;
    return *next > start;
}

/** Reads a number as it is written. @return false if it is none. */
static bool read_decimal(Decimal *decimal, const char **next, const char *end) {
    *decimal = (Decimal){.is_negative = read_sign(next, end)};
    read_digits(decimal, next, end);
    if (*next < end && **next == '.') {
        ++*next;
        decimal->exponent = -read_digits(decimal, next, end);
    }
    return decimal->written > 0 && read_exponent(decimal, next, end);
}

/**
 * Converts a number with few digits: both factors are exact, so the result is rounded once
 * (Clinger, *How to Read Floating Point Numbers Accurately*, 1990).
 * @return false if it has too many digits or too large an exponent.
 */
static bool convert_short(const Decimal *decimal, double *number) {
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    long exponent = decimal->exponent;
    if (decimal->digit_count > EXACT_DIGITS || exponent < -EXACT_POWER || exponent > EXACT_POWER) {
        return false;
    }
    double digits = (double)decimal->digits;
    double size = exponent < 0 ? digits / powers[-exponent] : digits * powers[exponent];
    *number = decimal->is_negative ? -size : size;
    return true;
}

/**
 * Converts any number. No part of the program sets LC_NUMERIC, so its decimal point is `.`.
 * @return false if it is too long.
 */
static bool convert_long(const char *start, size_t length, double *number) {
    char copy[NUMBER_SIZE], *end;
    if (length >= sizeof copy) {
        return false;
    }
    memcpy(copy, start, length);
    copy[length] = '\0';
    *number = strtod(copy, &end);
    return *end == '\0';
}

bool obj_text_number(ObjText *text, double *number) {
    skip_blanks(text);
    Decimal decimal;
    const char *start = text->next;
    bool is_number = read_decimal(&decimal, &text->next, text->end) && obj_text_is_word_end(text) &&
                     (convert_short(&decimal, number) ||
                      convert_long(start, (size_t)(text->next - start), number));
    if (!is_number) {
        text->next = start;
    }
    return is_number;
}

bool obj_text_index(ObjText *text, long long *index) {
    const char *start = text->next;
    bool is_negative = read_sign(&text->next, text->end);
    const char *digits = text->next;
    unsigned long long size = 0;
    for (; text->next < text->end && is_digit(*text->next); text->next++) {
        size = size < LLONG_MAX / 10 ? 10 * size + (unsigned)(*text->next - '0') : LLONG_MAX;
    }
    if (text->next == digits) {
        text->next = start;
        return false;
    }
    *index = is_negative ? -(long long)size : (long long)size;
    return true;
}

bool obj_text_slash(ObjText *text) {
    bool is_slash = text->next < text->end && *text->next == '/';
    text->next += is_slash;
    return is_slash;
}
