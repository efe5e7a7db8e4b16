/**
 * @file
 * @brief A writer of JSON.
 */
#include "base/json.h"

#include <math.h>
#include <stdint.h>

/**
 * @return Bytes of the UTF-8 sequence at the start of a text; 0: no valid one. Overlong forms,
 *         surrogates and numbers above U+10FFFF are invalid (RFC 3629).
 */
static size_t utf8_sequence_length(const unsigned char *text) {
    static const uint32_t minimum[] = {0, 0, 0x80, 0x800, 0x10000};
    unsigned char lead = text[0];
    size_t length = lead < 0x80 ? 1 : lead < 0xC0 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (lead >= 0xF8 || length < 2) {
        return lead >= 0xF8 ? 0 : length;
    }
    uint32_t code = lead & (0x7Fu >> length);
    for (size_t i = 1; i < length; i++) {
        if ((text[i] & 0xC0) != 0x80) { // Also the final zero: reading stops there.
            return 0;
        }
        code = code << 6 | (text[i] & 0x3Fu);
    }
    bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
    return code < minimum[length] || code > 0x10FFFF || is_surrogate ? 0 : length;
}

/** Writes a text as a JSON string, quotes included. */
static void write_quoted(FILE *stream, const char *text) {
    fputc('"', stream);
    for (const unsigned char *c = (const unsigned char *)text; *c;) {
        size_t length = utf8_sequence_length(c);
        if (length == 0) {
            fputs("\\ufffd", stream);
        } else if (*c == '"' || *c == '\\') {
            fprintf(stream, "\\%c", *c);
        } else if (*c < ' ') {
            fprintf(stream, "\\u%04x", *c);
        } else {
            fwrite(c, 1, length, stream);
        }
        c += length ? length : 1;
    }
    fputc('"', stream);
}

/** Writes the comma and the name before a value, if needed. */
static void begin_value(JsonWriter *json, const char *name) {
    if (json->needs_comma) {
        fputs(", ", json->stream);
    }
    if (name) {
        write_quoted(json->stream, name);
        fputs(": ", json->stream);
    }
    json->needs_comma = true;
}

/** Begins an object or an array. */
static void open_container(JsonWriter *json, const char *name, char bracket) {
    begin_value(json, name);
    fputc(bracket, json->stream);
    json->needs_comma = false;
}

/** Ends an object or an array. */
static void close_container(JsonWriter *json, char bracket) {
    fputc(bracket, json->stream);
    json->needs_comma = true;
}

void json_object_begin(JsonWriter *json, const char *name) {
    open_container(json, name, '{');
}

void json_object_end(JsonWriter *json) {
    close_container(json, '}');
}

void json_array_begin(JsonWriter *json, const char *name) {
    open_container(json, name, '[');
}

void json_array_end(JsonWriter *json) {
    close_container(json, ']');
}

void json_line_end(JsonWriter *json) {
    fputs("}\n", json->stream);
    json->needs_comma = false;
}

void json_string(JsonWriter *json, const char *name, const char *text) {
    begin_value(json, name);
    write_quoted(json->stream, text);
}

void json_number(JsonWriter *json, const char *name, double value, int digits) {
    begin_value(json, name);
    isfinite(value) ? fprintf(json->stream, "%.*g", digits, value) : fputs("null", json->stream);
}

void json_decimal(JsonWriter *json, const char *name, double value, int decimals) {
    begin_value(json, name);
    isfinite(value) ? fprintf(json->stream, "%.*f", decimals, value) : fputs("null", json->stream);
}

void json_integer(JsonWriter *json, const char *name, long long value) {
    begin_value(json, name);
    fprintf(json->stream, "%lld", value);
}

void json_count(JsonWriter *json, const char *name, unsigned long long value) {
    begin_value(json, name);
    fprintf(json->stream, "%llu", value);
}

void json_bool(JsonWriter *json, const char *name, bool value) {
    begin_value(json, name);
    fputs(value ? "true" : "false", json->stream);
}

void json_null(JsonWriter *json, const char *name) {
    begin_value(json, name);
    fputs("null", json->stream);
}

void json_numbers(JsonWriter *json, const char *name, const double *values, size_t count,
                  int digits) {
    json_array_begin(json, name);
    for (size_t i = 0; i < count; i++) {
        json_number(json, NULL, values[i], digits);
    }
    json_array_end(json);
}
