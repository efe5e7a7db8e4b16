/**
 * @file
 * @brief A writer of JSON.
 */
#include "base/json.h"

#include "base/utf8.h"

#include <math.h>
#include <string.h>

/** Writes a text as a JSON string, quotes included. */
static void write_quoted(FILE *stream, const char *text) {
    fputc('"', stream);
    for (size_t left = strlen(text), size; left > 0; text += size, left -= size) {
        uint32_t code = 0;
        size = utf8_decode(text, left, &code);
        if (size == 0) {
            fputs("\\ufffd", stream);
            size = 1;
        } else if (code == '"' || code == '\\') {
            fprintf(stream, "\\%c", (char)code);
        } else if (utf8_is_control(code)) {
            fprintf(stream, "\\u%04x", code); // All of them are below U+10000.
        } else {
            fwrite(text, 1, size, stream);
        }
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
