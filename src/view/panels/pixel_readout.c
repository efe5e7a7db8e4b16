/**
 * @file
 * @brief Writing what a pixel shows.
 */
#include "view/panels/pixel_readout.h"

#include "base/typeset_numbers.h"
#include "view/panels/thing_title.h"

#include <libintl.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/** Appends to a readout. @param format As for printf. */
static void append(char text[READOUT_SIZE], const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void append(char text[READOUT_SIZE], const char *format, ...) {
    size_t used = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + used, READOUT_SIZE - used, format, arguments);
    va_end(arguments);
    typeset_numbers(text + used, READOUT_SIZE - used);
}

/** Names what the ray through the middle of a pixel meets. @param[out] title Empty: not known. */
static void name_shape(const Scene *scene, const PixelReading *reading,
                       char title[THING_TITLE_SIZE]) {
    title[0] = '\0';
    if (reading->shape >= 0 && scene && (size_t)reading->shape < scene->shape_count) {
        shape_title(scene, reading->shape, title);
    } else if (reading->shape < 0) {
        snprintf(title, THING_TITLE_SIZE, "%s",
                 isfinite(reading->distance) ? gettext("a lamp") : gettext("the sky"));
    }
}

/** Appends what the ray through the middle of the pixel meets. The layer of shapes says it itself.
 */
static void append_shape(const PixelReadout *readout, char text[READOUT_SIZE]) {
    char title[THING_TITLE_SIZE];
    name_shape(readout->scene, &readout->readings[0], title);
    if (title[0] != '\0' && readout->readings[0].layer != LAYER_SHAPES) {
        append(text, ", %s", title);
    }
}

/** Appends the value of a pixel; of the layer of shapes a name, as the index of a shape counts from
 *  0 over all kinds, and so contradicts the numbers in names. */
static void append_value(const Scene *scene, const PixelReading *reading, char text[READOUT_SIZE]) {
    char value[LAYER_TEXT_SIZE], title[THING_TITLE_SIZE];
    const uint8_t *rgb = reading->rgb;
    name_shape(scene, reading, title);
    if (reading->layer == LAYER_SHAPES && title[0] != '\0') {
        append(text, "%s%s%s", gettext(layer_name(reading->layer)), gettext(": "), title);
    } else if (reading->layer == LAYER_SHADED) {
        append(text, gettext("colour %d %d %d of 255"), rgb[0], rgb[1], rgb[2]);
    } else {
        layer_value_text(reading->layer, reading->values, value);
        append(text, "%s%s%s", gettext(layer_name(reading->layer)), gettext(": "), value);
    }
}

void pixel_readout_value(const PixelReadout *readout, size_t picture, char text[READOUT_SIZE]) {
    text[0] = '\0';
    append_value(readout->scene, &readout->readings[picture], text);
}

/** Appends the difference of two pixels, if there is one. */
static void append_difference(const PixelReading *a, const PixelReading *b,
                              char text[READOUT_SIZE]) {
    const char *unit = layer_difference_unit(a->layer);
    double difference = (double)NAN;
    if (a->layer != LAYER_SHADED && a->layer == b->layer) {
        difference = layer_difference(a->layer, a->values, b->values);
    }
    bool is_binary = a->layer == LAYER_SHAPES || a->layer == LAYER_ACNE;
    if (a->layer != b->layer) {
        append(text, "%s", gettext("two different layers are not compared"));
    } else if (a->layer == LAYER_SHADED) {
        append(text, gettext("left minus right: %+d %+d %+d"), a->rgb[0] - b->rgb[0],
               a->rgb[1] - b->rgb[1], a->rgb[2] - b->rgb[2]);
    } else if (isnan(difference)) {
        append(text, "%s", gettext("no difference is known"));
    } else if (is_binary) {
        append(text, "%s", difference != 0 ? gettext("not the same") : gettext("the same"));
    } else {
        append(text,
               difference != 0 ? gettext("left minus right: %+.6g %s")
                               : gettext("left minus right: %.6g %s"),
               difference, unit[0] != '\0' ? gettext(unit) : "");
    }
}

void pixel_readout_difference(const PixelReading readings[READOUT_PICTURES],
                              char text[READOUT_SIZE]) {
    text[0] = '\0';
    append_difference(&readings[0], &readings[1], text);
}

void pixel_readout_write(const PixelReadout *readout, char text[READOUT_SIZE]) {
    text[0] = '\0';
    append(text,
           readout->is_magnified ? gettext("pixel (%d, %d) in the magnifier")
                                 : gettext("pixel (%d, %d) under the mouse"),
           readout->x, readout->y);
    append_shape(readout, text);
    if (readout->count == 1) {
        append(text, ", ");
        append_value(readout->scene, &readout->readings[0], text);
        if (readout->readings[0].layer == LAYER_SHADED && readout->samples > 1) {
            append(text, gettext(" (mean of up to %d samples)"), readout->samples);
        }
        return;
    }
    append(text, "\n%s ", gettext("left:"));
    append_value(readout->scene, &readout->readings[0], text);
    append(text, "\n%s ", gettext("right:"));
    append_value(readout->scene, &readout->readings[1], text);
    append(text, "\n");
    append_difference(&readout->readings[0], &readout->readings[1], text);
}
