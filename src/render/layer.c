/**
 * @file
 * @brief The table of layers: their numbers, scales, colours and legends.
 */
#include "base/language.h"
#include "render/layer_renderer.h"
#include "render/palette.h"

#include <libintl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/** Colour of rays without a hit: at neither end of any palette. */
static const uint8_t MISSING_COLOR[3] = {0x48, 0x4c, 0x54};
/** Colour of acne: distinct from that of leaks for colour-blind people, too. */
static const uint8_t ACNE_COLOR[3] = {0xff, 0x7a, 0x00};
/** Colour of leaks. */
static const uint8_t LEAK_COLOR[3] = {0x2f, 0xb4, 0xff};

/** Low end of the scale of errors, in steps of 8 bits: double's are seen, too. */
static const double ERROR_SCALE_MINIMUM = 1e-16;
/** Ratio of greatest to least number from which a scale is logarithmic. */
static const double LOG_SCALE_RATIO = 4;
/** Decades up to which the legend of a logarithmic scale has 1, 2, 3, 5, 10, 20 and so on. */
static const double FEWEST_DECADES = 2;
/** Decades up to which it has 1, 2, 5, 10, 20 and so on. */
static const double FEW_DECADES = 2.5;
/** Decades up to which it has 1, 3, 10, 30 and so on; beyond, powers of ten alone. */
static const double SOME_DECADES = 4;
/** Approximate number of ticks of a linear scale. */
static const double LINEAR_TICKS = 5;

/* --- numbers ---------------------------------------------------------------------------------- */

/** Reads the normal. See #LayerClass.read. */
static void read_normal(const AovSample *sample, float values[LAYER_VALUES]) {
    for (int i = 0; i < LAYER_VALUES; i++) {
        values[i] = sample->shape < 0 ? NAN : (float)sample->normal[i];
    }
}

/** Reads the distance. See #LayerClass.read. */
static void read_distance(const AovSample *sample, float values[LAYER_VALUES]) {
    values[0] = isfinite(sample->distance) ? (float)sample->distance : NAN;
}

/** Reads the shape. See #LayerClass.read. */
static void read_shape_id(const AovSample *sample, float values[LAYER_VALUES]) {
    values[0] = sample->shape < 0 ? NAN : (float)sample->shape;
}

/** Reads (u, v). See #LayerClass.read. */
static void read_uv(const AovSample *sample, float values[LAYER_VALUES]) {
    values[0] = sample->shape < 0 ? NAN : (float)sample->uv[0];
    values[1] = (float)sample->uv[1];
}

/** Reads the number of rays. See #LayerClass.read. */
static void read_ray_count(const AovSample *sample, float values[LAYER_VALUES]) {
    values[0] = (float)sample->ray_count;
}

/** Reads the number of steps; none where no distance field is sphere-traced. See
 *  #LayerClass.read. */
static void read_step_count(const AovSample *sample, float values[LAYER_VALUES]) {
    values[0] = sample->step_count > 0 ? (float)sample->step_count : NAN;
}

/** Reads the number of operations; none where no distance field is sphere-traced. See
 *  #LayerClass.read. */
static void read_operation_count(const AovSample *sample, float values[LAYER_VALUES]) {
    values[0] = sample->operation_count > 0 ? (float)sample->operation_count : NAN;
}

/* --- colours ---------------------------------------------------------------------------------- */

/** @return Position of a number on a scale, 0 to 1. */
static double scale_fraction(const LayerScale *scale, double value) {
    if (scale->is_log) {
        return value > scale->low ? log(value / scale->low) * scale->slope : 0;
    }
    return (value - scale->low) * scale->slope;
}

/** Colours a magnitude. See #LayerClass.color. */
static void color_cividis(const LayerScale *scale, const float *values, uint8_t rgb[3]) {
    palette_color(&palette_cividis, scale_fraction(scale, (double)values[0]), rgb);
}

/** @return A number as a step of 8 bits. @param unit_value The number; clamped to 0 to 1. */
static uint8_t to_8_bits(double unit_value) {
    return (uint8_t)(fmin(fmax(unit_value, 0), 1) * UINT8_MAX + 0.5);
}

/** Colours a normal: red, green and blue are x, y and z. See #LayerClass.color. */
static void color_normal(const LayerScale *scale, const float *values, uint8_t rgb[3]) {
    (void)scale;
    for (int i = 0; i < LAYER_VALUES; i++) {
        rgb[i] = to_8_bits(0.5 + 0.5 * (double)values[i]);
    }
}

/** Colours a shape. See #LayerClass.color. */
static void color_shape(const LayerScale *scale, const float *values, uint8_t rgb[3]) {
    (void)scale;
    palette_category((unsigned)values[0], rgb);
}

/** Colours of the corners of a texture: (0, 0), (1, 0), (0, 1) and (1, 1). */
static const uint8_t UV_CORNER_COLORS[4][3] = {
    {0x14, 0x18, 0x30}, {0xe6, 0x8a, 0x00}, {0x1c, 0x8c, 0xe0}, {0xff, 0xf8, 0xe0}};
/** Grid lines per width and height of a texture. */
static const double UV_LINES = 10;
/** Width of a grid line, as a fraction of the distance between two. */
static const double UV_LINE_WIDTH = 0.08;

/** @return The fractional part of a number. */
static double fraction(double x) {
    return x - floor(x);
}

/** Colours (u, v), with a grid line at each tenth. See #LayerClass.color. */
static void color_uv(const LayerScale *scale, const float *values, uint8_t rgb[3]) {
    (void)scale;
    double u = (double)values[0], v = (double)values[1];
    double across = u == 1 ? 1 : fraction(u), up = v == 1 ? 1 : fraction(v);
    bool is_line = fraction(u * UV_LINES) < UV_LINE_WIDTH || fraction(v * UV_LINES) < UV_LINE_WIDTH;
    for (int i = 0; i < 3; i++) {
        double below =
            UV_CORNER_COLORS[0][i] + (UV_CORNER_COLORS[1][i] - UV_CORNER_COLORS[0][i]) * across;
        double above =
            UV_CORNER_COLORS[2][i] + (UV_CORNER_COLORS[3][i] - UV_CORNER_COLORS[2][i]) * across;
        double color = below + (above - below) * up;
        rgb[i] = (uint8_t)(is_line ? color / 2 : color);
    }
}

/** Colours an error; in a preview the pixel is grey, as bright as the picture. See
 *  #LayerClass.color. @param values Error, brightness. */
static void color_error(const LayerScale *scale, const float *values, uint8_t rgb[3]) {
    bool is_known = values[0] >= 0;
    memset(rgb, is_known ? 0 : to_8_bits((double)values[1]), 3);
    if (is_known && values[0] > 0) {
        color_cividis(scale, values, rgb);
    }
}

/** Colours an artefact; other pixels are grey, as bright as the picture. See #LayerClass.color.
 *  @param values Brightness, #ShadingArtifact. */
static void color_artifact(const LayerScale *scale, const float *values, uint8_t rgb[3]) {
    (void)scale;
    memset(rgb, to_8_bits((double)values[0]), 3);
    if (values[1] > ARTIFACT_NONE) {
        memcpy(rgb, (int)values[1] == ARTIFACT_ACNE ? ACNE_COLOR : LEAK_COLOR, 3);
    }
}

/* --- differences ------------------------------------------------------------------------------ */

/** @return The angle between two normals, degrees. See #LayerClass.difference. */
static double angle_between_normals(const float *a, const float *b) {
    double cosine = 0, sine = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double cross = (double)a[j] * (double)b[k] - (double)a[k] * (double)b[j];
        cosine += (double)a[i] * (double)b[i];
        sine += cross * cross;
    }
    return atan2(sqrt(sine), cosine) * (180 / M_PI);
}

/** @return 1 if the shapes are not the same, else 0. See #LayerClass.difference. */
static double is_other_shape(const float *a, const float *b) {
    return a[0] != b[0];
}

/** @return The difference of u or of v, whichever is larger. See #LayerClass.difference. */
static double largest_uv_difference(const float *a, const float *b) {
    double u = (double)a[0] - (double)b[0], v = (double)a[1] - (double)b[1];
    return fabs(u) >= fabs(v) ? u : v;
}

/** @return 1 where only the first has an artefact, -1 where only the second has. See
 *  #LayerClass.difference. */
static double artifact_difference(const float *a, const float *b) {
    return (a[1] > ARTIFACT_NONE) - (b[1] > ARTIFACT_NONE);
}

/* --- legends ---------------------------------------------------------------------------------- */

/** Normals along the axes. */
static const FixedLegendEntry normal_legend[] = {{{1, 0, 0}, "+x", NULL}, {{-1, 0, 0}, "−x", NULL},
                                                 {{0, 1, 0}, "+y", NULL}, {{0, -1, 0}, "−y", NULL},
                                                 {{0, 0, 1}, "+z", NULL}, {{0, 0, -1}, "−z", NULL},
                                                 {{0}, NULL, NULL}};
/** The first shapes of a scene. */
static const FixedLegendEntry shape_legend[] = {
    {{0}, "0", NULL}, {{1}, "1", NULL}, {{2}, "2", NULL},   {{3}, "3", NULL}, {{4}, "4", NULL},
    {{5}, "5", NULL}, {{6}, "6", NULL}, {{7}, "7 …", NULL}, {{0}, NULL, NULL}};
/** The corners of a texture, just inside. */
static const FixedLegendEntry uv_legend[] = {{{0.99F, 0.99F}, "(1, 1)", NULL},
                                             {{0.05F, 0.99F}, "(0, 1)", NULL},
                                             {{0.99F, 0.05F}, "(1, 0)", NULL},
                                             {{0.05F, 0.05F}, "(0, 0)", NULL},
                                             {{0}, NULL, NULL}};
/** The artefacts. */
static const FixedLegendEntry artifact_legend[] = {
    {{0, ARTIFACT_ACNE}, "", N_("acne: dark, should be lit")},
    {{0, ARTIFACT_LEAK}, "", N_("leak: lit, should be dark")},
    {{0}, NULL, NULL}};

/* --- the layers ------------------------------------------------------------------------------- */

/** How often the time of each pixel is taken; the shortest counts. */
enum { TIME_REPEATS = 5 };

/** All layers. */
static const LayerClass layers[LAYER_COUNT] = {
    [LAYER_SHADED] = {.name = N_("light"), .unit = ""},
    [LAYER_NORMALS] = {.name = N_("normals"),
                       .unit = "",
                       .has_missing = true,
                       .legend = normal_legend,
                       .read = read_normal,
                       .difference = angle_between_normals,
                       .difference_unit = N_("degrees"),
                       .difference_high = 180,
                       .color = color_normal},
    [LAYER_DISTANCE] = {.name = N_("distance"),
                        .unit = N_("scene units"),
                        .has_missing = true,
                        .read = read_distance,
                        .color = color_cividis},
    [LAYER_SHAPES] = {.name = N_("shapes"),
                      .unit = "",
                      .has_missing = true,
                      .legend = shape_legend,
                      .read = read_shape_id,
                      .difference = is_other_shape,
                      .difference_high = 1,
                      .color = color_shape},
    [LAYER_UV] = {.name = N_("places on pictures"),
                  .unit = "(u, v)",
                  .aov_mask = AOV_UV,
                  .has_missing = true,
                  .legend = uv_legend,
                  .read = read_uv,
                  .difference = largest_uv_difference,
                  .color = color_uv},
    [LAYER_RAYS] = {.name = N_("rays spent"),
                    .unit = N_("rays per pixel"),
                    .aov_mask = AOV_RADIANCE,
                    .read = read_ray_count,
                    .color = color_cividis},
    [LAYER_STEPS] = {.name = N_("marching steps"),
                     .unit = N_("steps per ray"),
                     .aov_mask = AOV_STEPS,
                     .has_missing = true,
                     .read = read_step_count,
                     .color = color_cividis},
    [LAYER_OPERATIONS] = {.name = N_("operations spent"),
                          .unit = N_("operations per ray"),
                          .aov_mask = AOV_OPERATIONS,
                          .has_missing = true,
                          .read = read_operation_count,
                          .color = color_cividis},
    [LAYER_TIME] = {.name = N_("time spent"),
                    .unit = N_("ns per pixel"),
                    .is_timed = true,
                    .repeats = TIME_REPEATS,
                    .measure = measure_time,
                    .color = color_cividis},
    [LAYER_ERROR] = {.name = N_("error"),
                     .unit = N_("steps of 255"),
                     .scale_low = ERROR_SCALE_MINIMUM,
                     .scale_high = ENCODING_CODE_MAXIMUM,
                     .zero_label = N_("no error"),
                     .reference = REFERENCE_EXACT,
                     .has_preview = true, // The reference may be slow.
                     .measure = measure_error,
                     .classify = classify_error,
                     .color = color_error},
    [LAYER_ACNE] = {.name = N_("acne and leaks"),
                    .unit = "",
                    .legend = artifact_legend,
                    .reference = REFERENCE_DOUBLE,
                    .measure = measure_artifacts,
                    .classify = classify_path,
                    .difference = artifact_difference,
                    .difference_high = 1,
                    .color = color_artifact},
    [LAYER_ROUNDING] = {.name = N_("rounding"),
                        .unit = N_("steps of 255"),
                        .scale_low = ERROR_SCALE_MINIMUM,
                        .scale_high = ENCODING_CODE_MAXIMUM,
                        .zero_label = N_("no difference"),
                        .has_preview = true, // Three pictures take three times as long as one.
                        .measure = measure_rounding,
                        .classify = classify_error,
                        .color = color_error},
};

const LayerClass *layer_class(Layer layer) {
    return &layers[layer];
}

const char *layer_name(Layer layer) {
    return layers[layer].name;
}

const char *layer_unit(Layer layer) {
    return layers[layer].unit;
}

void layer_values(Layer layer, const AovSample *sample, float values[LAYER_VALUES]) {
    layers[layer].read(sample, values);
}

void layer_color(Layer layer, const LayerScale *scale, const float values[LAYER_VALUES],
                 uint8_t rgb[3]) {
    if (isnan(values[0]) && layers[layer].has_missing) {
        memcpy(rgb, MISSING_COLOR, sizeof MISSING_COLOR);
    } else {
        layers[layer].color(scale, values, rgb);
    }
}

/* --- scales ----------------------------------------------------------------------------------- */

/** @return The greatest of 1, 2 and 5 times a power of ten that is not above a number. */
static double round_down_1_2_5(double x) {
    double power = pow(10, floor(log10(x)));
    double digit = x / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

/** @return The next of the same series. */
static double next_1_2_5(double x) {
    double next = round_down_1_2_5(x * 2.25);
    return next > x * 1.5 ? next : round_down_1_2_5(x * 2.75);
}

/** @return The least of the same series that is not below a number. */
static double round_up_1_2_5(double x) {
    double below = round_down_1_2_5(x);
    return below < x ? next_1_2_5(below) : below;
}

/** @return Distance between two ticks of a linear scale. */
static double linear_step(const LayerScale *scale) {
    return round_up_1_2_5((scale->high - scale->low) / LINEAR_TICKS * 0.999);
}

/**
 * @return A logarithmic scale.
 * @param low  Its lower end, above 0.
 */
static LayerScale log_scale(double low, double high) {
    return (LayerScale){low, high, true, 1 / log(high / low)};
}

void layer_value_text(Layer layer, const float values[LAYER_VALUES], char text[LAYER_TEXT_SIZE]) {
    double x = (double)values[0], y = (double)values[1], z = (double)values[2];
    const char *unit = layer_unit(layer);
    if (layer == LAYER_ACNE) {
        const FixedLegendEntry *entry = layer_class(layer)->legend;
        while (entry->number && entry->values[1] != values[1]) {
            entry++;
        }
        snprintf(text, LAYER_TEXT_SIZE, "%s",
                 gettext(entry->number ? entry->label : N_("as in the reference")));
    } else if (isnan(x)) {
        bool is_missing = layer_class(layer)->has_missing;
        snprintf(text, LAYER_TEXT_SIZE, "%s",
                 is_missing ? gettext("nothing") : gettext("not measured yet"));
    } else if (layer == LAYER_NORMALS) {
        snprintf(text, LAYER_TEXT_SIZE, "(%.4f, %.4f, %.4f)", x, y, z);
    } else if (layer == LAYER_UV) {
        snprintf(text, LAYER_TEXT_SIZE, "(%.5g, %.5g)", x, y);
    } else if (unit[0] == '\0') {
        snprintf(text, LAYER_TEXT_SIZE, "%.6g", x);
    } else {
        snprintf(text, LAYER_TEXT_SIZE, "%.6g %s", x, gettext(unit));
    }
}

double layer_difference(Layer layer, const float a[LAYER_VALUES], const float b[LAYER_VALUES]) {
    bool is_a_missing = isnan(a[0]), is_b_missing = isnan(b[0]);
    if (is_a_missing || is_b_missing) {
        return is_a_missing && is_b_missing && layers[layer].has_missing ? 0 : (double)NAN;
    }
    return layers[layer].difference ? layers[layer].difference(a, b) : (double)a[0] - (double)b[0];
}

const char *layer_difference_unit(Layer layer) {
    const char *unit = layers[layer].difference_unit;
    return unit ? unit : layers[layer].unit;
}

bool layer_has_missing(Layer layer) {
    return layers[layer].has_missing;
}

LayerScale layer_difference_scale(Layer layer, double largest) {
    const LayerClass *class = &layers[layer];
    double high = class->scale_high > 0        ? class->scale_high
                  : class->difference_high > 0 ? class->difference_high
                  : largest > 0                ? round_up_1_2_5(largest)
                                               : 1;
    // As many numbers as a picture has steps are linear: the same colours as in its difference.
    double low = class->scale_low > 0 ? class->scale_low : high / ENCODING_CODE_MAXIMUM;
    return (LayerScale){low, high, true, 1 / log1p(high / low)};
}

LayerScale layer_scale(Layer layer, double low, double high) {
    if (layers[layer].scale_high > 0) {
        return log_scale(layers[layer].scale_low, layers[layer].scale_high);
    }
    if (layers[layer].legend || !(high >= low)) {
        return (LayerScale){0};
    }
    if (low > 0 && high > low * LOG_SCALE_RATIO) {
        return log_scale(round_down_1_2_5(low), round_up_1_2_5(high));
    }
    LayerScale scale = {.low = low, .high = high > low ? high : low + 1};
    double step = linear_step(&scale);
    low = floor(low / step) * step;
    high = ceil(scale.high / step) * step;
    return (LayerScale){low, high, false, 1 / (high - low)};
}

/** Writes a row of a legend. */
static void legend_entry_at(Layer layer, const LayerScale *scale, double value,
                            LegendEntry *entry) {
    float values[LAYER_VALUES] = {(float)value};
    *entry = (LegendEntry){.position = scale_fraction(scale, value)};
    snprintf(entry->number, sizeof entry->number, "%.9g", value);
    layer_color(layer, scale, values, entry->rgb);
}

/** @return The next number below one whose first digit is in a list. @param digits The digits,
 *  from the largest down; the last is 1. */
static double next_digit_below(double value, const int *digits) {
    /** A digit that has lost some roundings is still that digit. */
    const double rounding = 1e-3;
    double power = pow(10, floor(log10(value * (1 - rounding))));
    while (*digits > 1 && value / power < *digits * (1 + rounding)) {
        digits++;
    }
    return power * *digits;
}

/** @return The next lower number in the legend of a logarithmic scale; few enough fit. */
static double next_log_value_below(const LayerScale *scale, double value) {
    double decades = log10(scale->high / scale->low);
    if (decades <= FEWEST_DECADES) {
        return next_digit_below(value, (const int[]){5, 3, 2, 1});
    }
    if (decades < FEW_DECADES) {
        return next_digit_below(value, (const int[]){5, 2, 1});
    }
    if (decades < SOME_DECADES) {
        return next_digit_below(value, (const int[]){3, 1});
    }
    // Powers of ten in equal steps, of which 1 is one.
    double step = ceil(decades / (LEGEND_ENTRIES_MAXIMUM - 3));
    return pow(10, step * floor(log10(value * 0.999) / step));
}

/** Writes the legend of a scale. @return Number of rows. */
static size_t scale_legend(Layer layer, const LayerScale *scale,
                           LegendEntry entries[LEGEND_ENTRIES_MAXIMUM]) {
    size_t count = 0;
    if (!(scale->high > scale->low)) {
        return 0;
    }
    double step = scale->is_log ? 0 : linear_step(scale), tolerance = 1e-6;
    double value = scale->high;
    double end = scale->is_log ? scale->low * (1 - tolerance) : scale->low - step * tolerance;
    while (value >= end && count < LEGEND_ENTRIES_MAXIMUM - 1) {
        legend_entry_at(layer, scale, fabs(value) < step * tolerance ? 0 : value,
                        &entries[count++]);
        value = scale->is_log ? next_log_value_below(scale, value) : value - step;
    }
    return count;
}

/** Writes a legend that is always the same. @return Number of rows. */
static size_t fixed_legend(Layer layer, const LayerScale *scale,
                           LegendEntry entries[LEGEND_ENTRIES_MAXIMUM]) {
    size_t count = 0;
    for (const FixedLegendEntry *entry = layers[layer].legend; entry->number; entry++, count++) {
        entries[count] = (LegendEntry){.label = entry->label, .position = LEGEND_APART};
        snprintf(entries[count].number, sizeof entries[count].number, "%s", entry->number);
        layer_color(layer, scale, entry->values, entries[count].rgb);
    }
    return count;
}

size_t layer_legend(Layer layer, const LayerScale *scale,
                    LegendEntry entries[LEGEND_ENTRIES_MAXIMUM]) {
    if (layer == LAYER_SHADED) {
        return 0;
    }
    size_t count = layers[layer].legend ? fixed_legend(layer, scale, entries)
                                        : scale_legend(layer, scale, entries);
    const char *zero_label = layers[layer].zero_label;
    if (layers[layer].has_missing || zero_label) {
        const float values[LAYER_VALUES] = {zero_label ? 0 : NAN};
        entries[count] = (LegendEntry){.label = zero_label ? zero_label : N_("nothing"),
                                       .position = LEGEND_APART};
        layer_color(layer, scale, values, entries[count++].rgb);
    }
    return count;
}
