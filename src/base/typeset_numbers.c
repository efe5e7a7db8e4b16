/**
 * @file
 * @brief Numbers as they are printed in books.
 */
#include "base/typeset_numbers.h"

#include "base/language.h"

#include <ctype.h>
#include <stdbool.h>
#include <string.h>

/** Digits from which a number is written in groups. */
enum { GROUPED_DIGITS = 5 };
/** Digits of a group. */
enum { GROUP_DIGITS = 3 };
/** The minus sign. */
static const char MINUS[] = "\xe2\x88\x92";
/** The space between groups: narrow, and not broken. */
static const char GROUP_SPACE[] = "\xe2\x80\xaf";
/** The sign that a number is squared. */
static const char SQUARED[] = "\xc2\xb2";

/** A text that is written. */
typedef struct Setting {
    char text[TYPESET_TEXT_SIZE]; /**< It. */
    size_t used;                  /**< Its bytes. */
    bool is_full;                 /**< Whether it had no room for some of them. */
} Setting;

/** The parts of a number, as printf writes it. */
typedef struct Number {
    size_t whole;        /**< Digits before the decimal sign. */
    size_t mantissa;     /**< Bytes before the exponent. */
    const char *power;   /**< First digit of the exponent that is not 0; NULL: no exponent. */
    size_t power_digits; /**< Its digits. */
    bool is_negative;    /**< Whether the exponent is. */
    size_t size;         /**< All bytes. */
} Number;

/** Writes some bytes. */
static void put(Setting *setting, const char *bytes, size_t count) {
    setting->is_full = setting->is_full || setting->used + count >= sizeof setting->text;
    if (!setting->is_full) {
        memcpy(setting->text + setting->used, bytes, count);
        setting->used += count;
    }
}

/** Writes a text. */
static void put_text(Setting *setting, const char *text) {
    put(setting, text, strlen(text));
}

/** @return Number of digits that a text begins with. */
static size_t count_digits(const char *text) {
    return strspn(text, "0123456789");
}

/** @return Whether a letter belongs to a word, or to a number that began before. */
static bool is_of_word(char c) {
    return isalnum((unsigned char)c) || c == '_' || c == '.' || c == ',';
}

/** @return Whether a number begins here, without its sign: not in a name such as f32x8 or box-0001.
 *  @param text What it stands in. */
static bool begins_number(const char *text, const char *at) {
    const bool is_joined =
        at > text && (is_of_word(at[-1]) || (at[-1] == '-' && at - 1 > text && is_of_word(at[-2])));
    return isdigit((unsigned char)*at) && !is_joined;
}

/** Finds the exponent of a number. @param[in,out] number Its mantissa is known. */
static void read_power(const char *at, Number *number) {
    const char *exponent = at + number->mantissa;
    const bool has_sign = exponent[0] == 'e' && (exponent[1] == '-' || exponent[1] == '+');
    const size_t digits = has_sign ? count_digits(exponent + 2) : 0;
    if (digits > 0) {
        size_t zeros = strspn(exponent + 2, "0");
        zeros = zeros < digits ? zeros : digits - 1;
        number->power = exponent + 2 + zeros;
        number->power_digits = digits - zeros;
        number->is_negative = exponent[1] == '-';
        number->size += 2 + digits;
    }
}

/** Reads a number. @return false if it is the beginning of a word. */
static bool read_number(const char *at, Number *number) {
    *number = (Number){.whole = count_digits(at)};
    const char *rest = at + number->whole;
    const bool has_fraction = (*rest == '.' || *rest == ',') && isdigit((unsigned char)rest[1]);
    number->mantissa = number->whole + (has_fraction ? 1 + count_digits(rest + 1) : 0);
    number->size = number->mantissa;
    read_power(at, number);
    const char after = at[number->size];
    return !isalnum((unsigned char)after) && after != '_';
}

/** Writes a mantissa, whose digits are grouped in French. */
static void put_mantissa(Setting *setting, const char *at, const Number *number) {
    const bool is_grouped = number->whole >= GROUPED_DIGITS && at[0] != '0' && language_is_french();
    for (size_t i = 0; i < number->whole; i++) {
        if (is_grouped && i > 0 && (number->whole - i) % GROUP_DIGITS == 0) {
            put_text(setting, GROUP_SPACE);
        }
        put(setting, at + i, 1);
    }
    put(setting, at + number->whole, number->mantissa - number->whole);
}

/** Writes a power of ten. */
static void put_power(Setting *setting, const Number *number) {
    static const char *const raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    put_text(setting, "\xc2\xa0×\xc2\xa0"
                      "10");
    put_text(setting, number->is_negative ? "⁻" : "");
    for (size_t i = 0; i < number->power_digits; i++) {
        put_text(setting, raised[number->power[i] - '0']);
    }
}

/** Writes a number: one with a power of ten in parentheses where it is squared, or divided by. */
static void put_number(Setting *setting, const char *text, const char *at, const Number *number) {
    const char *after = at + number->size;
    const bool is_divisor = at - text >= 2 && at[-2] == '/' && at[-1] == ' ';
    const bool is_squared = strncmp(after, SQUARED, strlen(SQUARED)) == 0;
    const bool is_closed = number->power && (is_divisor || is_squared);
    put_text(setting, is_closed ? "(" : "");
    put_mantissa(setting, at, number);
    if (number->power) {
        put_power(setting, number);
    }
    put_text(setting, is_closed ? ")" : "");
}

/** @return Whether the sign of a number stands here, not a hyphen. */
static bool is_minus(const char *text, const char *at) {
    return *at == '-' && isdigit((unsigned char)at[1]) &&
           (at == text || (!is_of_word(at[-1]) && at[-1] != ')' && at[-1] != '-'));
}

void typeset_numbers(char *text, size_t size) {
    Setting setting = {.used = 0};
    language_localize_numbers(text, size);
    for (const char *at = text; *at;) {
        Number number;
        if (begins_number(text, at) && read_number(at, &number)) {
            put_number(&setting, text, at, &number);
            at += number.size;
        } else if (is_minus(text, at)) {
            put_text(&setting, MINUS);
            at++;
        } else {
            put(&setting, at++, 1);
        }
    }
    if (!setting.is_full && setting.used < size) {
        memcpy(text, setting.text, setting.used);
        text[setting.used] = '\0';
    }
}
