/**
 * @file
 * @brief A writer of JSON: objects, arrays and values, one object per line.
 *
 * The writer adds commas and escapes, so the output is valid for all file names and numbers. Keys
 * appear in the order of the calls. Inside an array, and at the top level, names are NULL.
 */
#ifndef DIOPTRE_BASE_JSON_H
#define DIOPTRE_BASE_JSON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/** Significant digits from which every double can be read back exactly. */
enum { JSON_EXACT_DIGITS = 17 };

/** A document that is being written. */
typedef struct JsonWriter {
    FILE *stream;     /**< The output; not owned. */
    bool needs_comma; /**< Whether a value precedes in the object or array under way. */
} JsonWriter;

/** Begins an object. */
void json_object_begin(JsonWriter *json, const char *name);

/** Ends an object. */
void json_object_end(JsonWriter *json);

/** Begins an array. */
void json_array_begin(JsonWriter *json, const char *name);

/** Ends an array. */
void json_array_end(JsonWriter *json);

/** Ends the object of the top level and its line. */
void json_line_end(JsonWriter *json);

/**
 * Writes a string.
 * @param text  Any bytes. Each byte that is not part of valid UTF-8 becomes U+FFFD.
 */
void json_string(JsonWriter *json, const char *name, const char *text);

/** Writes a number. Infinities and NaN become null. @param digits Significant digits. */
void json_number(JsonWriter *json, const char *name, double value, int digits);

/** Writes a number with a fixed number of decimals. Infinities and NaN become null. */
void json_decimal(JsonWriter *json, const char *name, double value, int decimals);

/** Writes an integer. */
void json_integer(JsonWriter *json, const char *name, long long value);

/** Writes a count. */
void json_count(JsonWriter *json, const char *name, unsigned long long value);

/** Writes true or false. */
void json_bool(JsonWriter *json, const char *name, bool value);

/** Writes null. */
void json_null(JsonWriter *json, const char *name);

/** Writes an array of numbers. @param digits Significant digits. */
void json_numbers(JsonWriter *json, const char *name, const double *values, size_t count,
                  int digits);

#endif
