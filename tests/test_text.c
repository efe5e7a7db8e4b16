/**
 * @file
 * @brief Text of strangers: UTF-8, terminals, JSON.
 */
#include "base/json.h"
#include "base/sanitize.h"
#include "base/utf8.h"
#include "testing.h"

#include <stdlib.h>
#include <string.h>

/** Number of code points of Unicode, and of the surrogates among them. */
enum { CODE_POINTS = 0x110000, SURROGATES = 0x800 };

/** Encodes a code point. @return Bytes written, by the table of RFC 3629, 3. */
static size_t encode(uint32_t code, char bytes[4]) {
    if (code < 0x80) {
        bytes[0] = (char)code;
        return 1;
    }
    size_t size = code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    for (size_t i = size - 1; i > 0; i--, code >>= 6) {
        bytes[i] = (char)(0x80 | (code & 0x3F));
    }
    bytes[0] = (char)(code | (0xF00u >> size & 0xFF));
    return size;
}

/** Every code point is decoded; none is where it is cut, and surrogates are none. */
static void test_code_points(void **state) {
    (void)state;
    for (uint32_t code = 0; code < CODE_POINTS; code++) {
        char bytes[4];
        uint32_t decoded = 0;
        size_t size = encode(code, bytes);
        bool is_surrogate = code >= 0xD800 && code < 0xD800 + SURROGATES;
        assert_int_equal(utf8_decode(bytes, size, &decoded), is_surrogate ? 0 : size);
        assert_true(is_surrogate || decoded == code);
        for (size_t cut = 1; cut < size; cut++) {
            assert_int_equal(utf8_decode(bytes, cut, &decoded), 0);
        }
    }
}

/** Of all bytes, in twos and threes and at the borders of fours, as many are characters as Unicode
 *  has of that length. */
static void test_invalid_bytes(void **state) {
    (void)state;
    size_t counts[5] = {0};
    uint32_t code;
    for (unsigned bits = 0; bits < 1u << 24; bits++) {
        char bytes[3] = {(char)(bits >> 16), (char)(bits >> 8), (char)bits};
        counts[utf8_decode(bytes, 3, &code)]++;
    }
    assert_int_equal(counts[1], 0x80 << 16);
    assert_int_equal(counts[2], (0x800 - 0x80) << 8);
    assert_int_equal(counts[3], 0x10000 - 0x800 - SURROGATES);
    assert_int_equal(counts[4], 0);
    static const char *const invalid[] = {
        "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xF8\x80\x80\x80",
        "\xFF\x80\x80\x80", "\xF0\x90\x80\x7F", "\xF0\x90\xC0\x80", "\xF0\x50\x80\x80"};
    for (size_t i = 0; i < sizeof invalid / sizeof *invalid; i++) {
        assert_int_equal(utf8_decode(invalid[i], 4, &code), 0);
    }
}

/** What is printed holds no control character, whatever comes in, and text is unchanged. */
static void test_sanitize(void **state) {
    (void)state;
    char out[64];
    sanitize_text(out, sizeof out, "a\tb\n\x1b[31m\xC2\x9B\x7F\xFF\xE2\x80\xAE\xC3\xA9", 18);
    assert_string_equal(out, "a\tb\n\\27[31m\\194\\155\\127\\255\\226\\128\\174\xC3\xA9");
    sanitize_line(out, sizeof out, "a\tb\n\xC3\xA9");
    assert_string_equal(out, "a\\9b\\10\xC3\xA9");
    sanitize_line(out, 4, "ab\n");
    assert_string_equal(out, "ab");
    for (uint32_t code = 1; code < 0x3000; code++) {
        char bytes[5] = "";
        uint32_t shown;
        encode(code, bytes);
        sanitize_line(out, sizeof out, bytes);
        utf8_decode(out, strlen(out), &shown);
        assert_true(strcmp(out, bytes) == 0 ? !utf8_is_control(code) : shown == '\\');
    }
    size_t size;
    char *printed = NULL;
    FILE *stream = open_memstream(&printed, &size);
    sanitize_print("a\n\x1b", stream);
    sanitize_print_line("\n\xC2\x80", stream);
    fclose(stream);
    assert_string_equal(printed, "a\n\\27\\10\\194\\128");
    free(printed);
}

/** Strings of JSON hold no control character and no byte that is not UTF-8. */
static void test_json(void **state) {
    (void)state;
    size_t size;
    char *text = NULL;
    JsonWriter json = {.stream = open_memstream(&text, &size)};
    json_string(&json, NULL, "\"\\\n\x1b\x7F\xC2\x9B\xE2\x80\xAE\xFF\xC3\xA9\xC3");
    fclose(json.stream);
    assert_string_equal(text,
                        "\"\\\"\\\\\\u000a\\u001b\\u007f\\u009b\\u202e\\ufffd\xC3\xA9\\ufffd\"");
    free(text);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_code_points),
        cmocka_unit_test(test_invalid_bytes),
        cmocka_unit_test(test_sanitize),
        cmocka_unit_test(test_json),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
