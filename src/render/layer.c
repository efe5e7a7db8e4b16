/**
 * @file
 * @brief Layers: their numbers, scales, colours and legends.
 */
#include "dioptre/layer.h"

#include "dioptre/language.h"
#include "dioptre/scene.h"
#include "render/palette.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/** Where nothing is met: neither end of any palette. */
static const uint8_t NOTHING[3] = {0x48, 0x4c, 0x54};
/** Acne: one of two colours that nobody takes for the other. */
static const uint8_t ACNE[3] = {0xff, 0x7a, 0x00};
/** Leaks. */
static const uint8_t LEAK[3] = {0x2f, 0xb4, 0xff};

/** Errors from that share of a step on are told apart; 0 is always the first colour. */
static const double ERROR_LEAST = 1e-4;
/** Times that the greatest number is the least one from which on ratios are shown. */
static const double RATIO_SHOWN = 4;
/** Powers of ten within which the legend of ratios has all of 1, 2, 5, 10, 20 and so on. */
static const double FEW_DECADES = 2.5;
/** Powers of ten within which it has 1, 3, 10, 30 and so on; beyond, powers of ten alone. */
static const double SOME_DECADES = 4;
/** Steps that a scale of differences has about. */
static const double STEPS = 5;

/* --- numbers ---------------------------------------------------------------------------------- */

/** Takes the normal. See #LayerClass.take. @param point The pixel. @param[out] numbers Its numbers.
 */
static void take_normal(const SurveyPoint *point, float numbers[LAYER_NUMBERS]) {
    for (int i = 0; i < LAYER_NUMBERS; i++) {
        numbers[i] = point->shape < 0 ? NAN : (float)point->normal[i];
    }
}

/** Takes the distance. See #LayerClass.take. @param point The pixel. @param[out] numbers Its
 *  numbers. */
static void take_distance(const SurveyPoint *point, float numbers[LAYER_NUMBERS]) {
    numbers[0] = isfinite(point->distance) ? (float)point->distance : NAN;
}

/** Takes the shape. See #LayerClass.take. @param point The pixel. @param[out] numbers Its numbers.
 */
static void take_shape(const SurveyPoint *point, float numbers[LAYER_NUMBERS]) {
    numbers[0] = point->shape < 0 ? NAN : (float)point->shape;
}

/** Takes the place on a picture. See #LayerClass.take. @param point The pixel. @param[out] numbers
 *  Its numbers. */
static void take_place(const SurveyPoint *point, float numbers[LAYER_NUMBERS]) {
    numbers[0] = point->shape < 0 ? NAN : (float)point->place[0];
    numbers[1] = (float)point->place[1];
}

/** Takes the rays. See #LayerClass.take. @param point The pixel. @param[out] numbers Its numbers.
 */
static void take_rays(const SurveyPoint *point, float numbers[LAYER_NUMBERS]) {
    numbers[0] = (float)point->rays;
}

/** Takes the steps. See #LayerClass.take. @param point The pixel. @param[out] numbers Its numbers;
 *  none where nothing is marched. */
static void take_steps(const SurveyPoint *point, float numbers[LAYER_NUMBERS]) {
    numbers[0] = point->steps > 0 ? (float)point->steps : NAN;
}

/* --- colours ---------------------------------------------------------------------------------- */

/** @return Where a number stands on a scale, 0 to 1. @param scale The scale. @param number It. */
static double scale_share(const LayerScale *scale, double number) {
    if (scale->is_log) {
        return number > scale->low ? log(number / scale->low) * scale->rate : 0;
    }
    return (number - scale->low) * scale->rate;
}

/** Colours a magnitude. See #LayerClass.color. @param scale The scale. @param numbers The pixel's.
 *  @param[out] rgb Its colour. */
static void color_cividis(const LayerScale *scale, const float *numbers, uint8_t rgb[3]) {
    palette_color(&palette_cividis, scale_share(scale, (double)numbers[0]), rgb);
}

/** Colours a magnitude. See #LayerClass.color. @param scale The scale. @param numbers The pixel's.
 *  @param[out] rgb Its colour. */
static void color_viridis(const LayerScale *scale, const float *numbers, uint8_t rgb[3]) {
    palette_color(&palette_viridis, scale_share(scale, (double)numbers[0]), rgb);
}

/** @return A share as a step of 8 bits. @param share It, cut to 0 to 1. */
static uint8_t step_of(double share) {
    return (uint8_t)(fmin(fmax(share, 0), 1) * UINT8_MAX + 0.5);
}

/** Colours a normal: red, green and blue are x, y and z. See #LayerClass.color. @param scale Not
 *  looked at. @param numbers The pixel's. @param[out] rgb Its colour. */
static void color_normal(const LayerScale *scale, const float *numbers, uint8_t rgb[3]) {
    (void)scale;
    for (int i = 0; i < LAYER_NUMBERS; i++) {
        rgb[i] = step_of(0.5 + 0.5 * (double)numbers[i]);
    }
}

/** Colours a shape. See #LayerClass.color. @param scale Not looked at. @param numbers The pixel's.
 *  @param[out] rgb Its colour. */
static void color_shape(const LayerScale *scale, const float *numbers, uint8_t rgb[3]) {
    (void)scale;
    palette_kind((unsigned)numbers[0], rgb);
}

/** Colours of the corners of a picture: (0, 0), (1, 0), (0, 1) and (1, 1). */
static const uint8_t CORNERS[4][3] = {
    {0x14, 0x18, 0x30}, {0xe6, 0x8a, 0x00}, {0x1c, 0x8c, 0xe0}, {0xff, 0xf8, 0xe0}};
/** Lines of a picture are drawn at every so many of its width or height. */
static const double LINES = 10;
/** How wide they are, of the way from one to the next. */
static const double LINE_WIDTH = 0.08;

/** @return The part of a number after its whole part. @param x Any number. */
static double fraction(double x) {
    return x - floor(x);
}

/** Colours a place on a picture, with lines at its tenths. See #LayerClass.color. @param scale Not
 *  looked at. @param numbers The pixel's. @param[out] rgb Its colour. */
static void color_place(const LayerScale *scale, const float *numbers, uint8_t rgb[3]) {
    (void)scale;
    double u = (double)numbers[0], v = (double)numbers[1];
    double across = u == 1 ? 1 : fraction(u), up = v == 1 ? 1 : fraction(v);
    bool is_line = fraction(u * LINES) < LINE_WIDTH || fraction(v * LINES) < LINE_WIDTH;
    for (int i = 0; i < 3; i++) {
        double below = CORNERS[0][i] + (CORNERS[1][i] - CORNERS[0][i]) * across;
        double above = CORNERS[2][i] + (CORNERS[3][i] - CORNERS[2][i]) * across;
        double color = below + (above - below) * up;
        rgb[i] = (uint8_t)(is_line ? color / 2 : color);
    }
}

/** Colours an error; what is not known yet is grey, as bright as the picture. See
 *  #LayerClass.color. @param scale The scale. @param numbers The pixel's: error, brightness.
 *  @param[out] rgb Its colour. */
static void color_error(const LayerScale *scale, const float *numbers, uint8_t rgb[3]) {
    bool is_known = numbers[0] >= 0;
    memset(rgb, is_known ? 0 : step_of((double)numbers[1]), 3);
    if (is_known && numbers[0] > 0) {
        color_cividis(scale, numbers, rgb);
    }
}

/** Colours a fault; the others are grey, as bright as the picture. See #LayerClass.color. @param
 *  scale Not looked at. @param numbers The pixel's: brightness, #LayerFault. @param[out] rgb Its
 *  colour. */
static void color_fault(const LayerScale *scale, const float *numbers, uint8_t rgb[3]) {
    (void)scale;
    memset(rgb, step_of((double)numbers[0]), 3);
    if (numbers[1] > FAULT_NONE) {
        memcpy(rgb, (int)numbers[1] == FAULT_ACNE ? ACNE : LEAK, 3);
    }
}

/* --- legends ---------------------------------------------------------------------------------- */

/** A row of a legend that always says the same. */
typedef struct FixedTick {
    float numbers[LAYER_NUMBERS]; /**< A pixel of its colour. */
    const char *number;           /**< What it stands for; empty: words do. */
    const char *words;            /**< The words, or NULL. */
} FixedTick;

/** Normals along the axes. */
static const FixedTick normal_ticks[] = {{{1, 0, 0}, "+x", NULL}, {{-1, 0, 0}, "−x", NULL},
                                         {{0, 1, 0}, "+y", NULL}, {{0, -1, 0}, "−y", NULL},
                                         {{0, 0, 1}, "+z", NULL}, {{0, 0, -1}, "−z", NULL},
                                         {{0}, NULL, NULL}};
/** The first shapes of a scene. */
static const FixedTick shape_ticks[] = {{{0}, "0", NULL}, {{1}, "1", NULL},   {{2}, "2", NULL},
                                        {{3}, "3", NULL}, {{4}, "4", NULL},   {{5}, "5", NULL},
                                        {{6}, "6", NULL}, {{7}, "7 …", NULL}, {{0}, NULL, NULL}};
/** The corners of a picture, just inside. */
static const FixedTick place_ticks[] = {{{0.99F, 0.99F}, "(1, 1)", NULL},
                                        {{0.05F, 0.99F}, "(0, 1)", NULL},
                                        {{0.99F, 0.05F}, "(1, 0)", NULL},
                                        {{0.05F, 0.05F}, "(0, 0)", NULL},
                                        {{0}, NULL, NULL}};
/** What may be wrong. */
static const FixedTick fault_ticks[] = {{{0, FAULT_ACNE}, "", N_("acne: dark, should be lit")},
                                        {{0, FAULT_LEAK}, "", N_("leak: lit, should be dark")},
                                        {{0}, NULL, NULL}};

/* --- the layers ------------------------------------------------------------------------------- */

/** A layer. */
typedef struct LayerClass {
    const char *name;       /**< See #layer_name. */
    const char *unit;       /**< See #layer_unit. */
    unsigned wants;         /**< See #layer_wants. */
    bool compares;          /**< See #layer_compares. */
    bool has_nothing;       /**< Whether some pixels may have no number. */
    const FixedTick *ticks; /**< Its legend; NULL: it has a scale. */

    /** Takes its numbers. See #layer_numbers. NULL: they do not come from a survey.
     *  @param point The pixel. @param[out] numbers Its numbers. */
    void (*take)(const SurveyPoint *point, float numbers[LAYER_NUMBERS]);

    /** Finds the colour of a pixel that has numbers. @param scale The scale. @param numbers They.
     *  @param[out] rgb The colour. */
    void (*color)(const LayerScale *scale, const float *numbers, uint8_t rgb[3]);
} LayerClass;

/** All layers, but for the light itself. */
static const LayerClass layers[LAYER_COUNT] = {
    [LAYER_SHADED] = {.name = N_("light"), .unit = ""},
    [LAYER_NORMALS] = {.name = N_("normals"),
                       .unit = "",
                       .has_nothing = true,
                       .ticks = normal_ticks,
                       .take = take_normal,
                       .color = color_normal},
    [LAYER_DISTANCE] = {.name = N_("distance"),
                        .unit = N_("scene units"),
                        .has_nothing = true,
                        .take = take_distance,
                        .color = color_cividis},
    [LAYER_SHAPES] = {.name = N_("shapes"),
                      .unit = "",
                      .has_nothing = true,
                      .ticks = shape_ticks,
                      .take = take_shape,
                      .color = color_shape},
    [LAYER_PLACE] = {.name = N_("places on pictures"),
                     .unit = "(u, v)",
                     .wants = SURVEY_PLACE,
                     .has_nothing = true,
                     .ticks = place_ticks,
                     .take = take_place,
                     .color = color_place},
    [LAYER_RAYS] = {.name = N_("rays spent"),
                    .unit = N_("a pixel"),
                    .wants = SURVEY_LIGHT,
                    .take = take_rays,
                    .color = color_cividis},
    [LAYER_STEPS] = {.name = N_("marching steps"),
                     .unit = N_("a ray"),
                     .wants = SURVEY_STEPS,
                     .has_nothing = true,
                     .take = take_steps,
                     .color = color_viridis},
    [LAYER_TIME] = {.name = N_("time spent"), .unit = N_("ns a pixel"), .color = color_cividis},
    [LAYER_ERROR] = {.name = N_("error"),
                     .unit = N_("steps of 255"),
                     .compares = true,
                     .color = color_error},
    [LAYER_ACNE] = {.name = N_("acne and leaks"),
                    .unit = "",
                    .wants = SURVEY_LIGHT,
                    .compares = true,
                    .ticks = fault_ticks,
                    .color = color_fault},
};

const char *layer_name(Layer layer) {
    return layers[layer].name;
}

const char *layer_unit(Layer layer) {
    return layers[layer].unit;
}

unsigned layer_wants(Layer layer) {
    return layers[layer].wants;
}

bool layer_compares(Layer layer) {
    return layers[layer].compares;
}

void layer_numbers(Layer layer, const SurveyPoint *point, float numbers[LAYER_NUMBERS]) {
    layers[layer].take(point, numbers);
}

void layer_color(Layer layer, const LayerScale *scale, const float numbers[LAYER_NUMBERS],
                 uint8_t rgb[3]) {
    if (isnan(numbers[0]) && layers[layer].has_nothing) {
        memcpy(rgb, NOTHING, sizeof NOTHING);
    } else {
        layers[layer].color(scale, numbers, rgb);
    }
}

/* --- scales ----------------------------------------------------------------------------------- */

/** @return The greatest of 1, 2 and 5 times a power of ten that is not above a number. @param x It,
 *  above 0. */
static double round_down(double x) {
    double power = pow(10, floor(log10(x)));
    double digit = x / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

/** @return The next of the same series. @param x One of them. */
static double round_next(double x) {
    double next = round_down(x * 2.25);
    return next > x * 1.5 ? next : round_down(x * 2.75);
}

/** @return The least of the same series that is not below a number. @param x It, above 0. */
static double round_up(double x) {
    double below = round_down(x);
    return below < x ? round_next(below) : below;
}

/** @return The way from one number of a legend to the next. @param scale A scale of differences. */
static double scale_step(const LayerScale *scale) {
    return round_up((scale->high - scale->low) / STEPS * 0.999);
}

/** @return A scale of ratios. @param low Its lower end, above 0. @param high Its upper end. */
static LayerScale ratio_scale(double low, double high) {
    return (LayerScale){low, high, true, 1 / log(high / low)};
}

LayerScale layer_scale(Layer layer, double low, double high) {
    if (layer == LAYER_ERROR) {
        return ratio_scale(ERROR_LEAST, ENCODING_STEP_MAXIMUM);
    }
    if (layers[layer].ticks || !(high >= low)) {
        return (LayerScale){0};
    }
    if (low > 0 && high > low * RATIO_SHOWN) {
        return ratio_scale(round_down(low), round_up(high));
    }
    LayerScale scale = {.low = low, .high = high > low ? high : low + 1};
    double step = scale_step(&scale);
    low = floor(low / step) * step;
    high = ceil(scale.high / step) * step;
    return (LayerScale){low, high, false, 1 / (high - low)};
}

/** Adds a row to a legend. @param layer The layer. @param scale Its scale. @param number Of its
 *  colour. @param[out] tick The row. */
static void tick_at(Layer layer, const LayerScale *scale, double number, LayerTick *tick) {
    float numbers[LAYER_NUMBERS] = {(float)number};
    *tick = (LayerTick){.words = NULL};
    snprintf(tick->number, sizeof tick->number, "%.9g", number);
    layer_color(layer, scale, numbers, tick->rgb);
}

/** @return The number below another in a legend of ratios, so that not too many are named.
 *  @param scale The scale. @param number A number. */
static double ratio_below(const LayerScale *scale, double number) {
    double decades = log10(scale->high / scale->low);
    if (decades < FEW_DECADES) {
        return round_down(number * 0.75);
    }
    double one = pow(10, floor(log10(number * 0.999)));
    if (decades < SOME_DECADES) {
        return number > 4 * one ? 3 * one : one;
    }
    double leap = pow(10, ceil(decades / (LAYER_TICKS - 3)));
    double power = pow(10, floor(log10(number * 1.0001)));
    return power < number * 0.999 ? power : number / leap;
}

/** Writes the legend of a scale. @param layer The layer. @param scale It. @param[out] ticks The
 *  rows. @return How many. */
static size_t scale_legend(Layer layer, const LayerScale *scale, LayerTick ticks[LAYER_TICKS]) {
    size_t count = 0;
    if (!(scale->high > scale->low)) {
        return 0;
    }
    double step = scale->is_log ? 0 : scale_step(scale), slack = 1e-6;
    double number = scale->high;
    double end = scale->is_log ? scale->low * (1 - slack) : scale->low - step * slack;
    while (number >= end && count < LAYER_TICKS - 1) {
        tick_at(layer, scale, fabs(number) < step * slack ? 0 : number, &ticks[count++]);
        number = scale->is_log ? ratio_below(scale, number) : number - step;
    }
    return count;
}

/** Writes a legend that always says the same. @param layer The layer. @param scale Its scale.
 *  @param[out] ticks The rows. @return How many. */
static size_t fixed_legend(Layer layer, const LayerScale *scale, LayerTick ticks[LAYER_TICKS]) {
    size_t count = 0;
    for (const FixedTick *tick = layers[layer].ticks; tick->number; tick++, count++) {
        ticks[count] = (LayerTick){.words = tick->words};
        snprintf(ticks[count].number, sizeof ticks[count].number, "%s", tick->number);
        layer_color(layer, scale, tick->numbers, ticks[count].rgb);
    }
    return count;
}

size_t layer_legend(Layer layer, const LayerScale *scale, LayerTick ticks[LAYER_TICKS]) {
    if (layer == LAYER_SHADED) {
        return 0;
    }
    size_t count =
        layers[layer].ticks ? fixed_legend(layer, scale, ticks) : scale_legend(layer, scale, ticks);
    if (layers[layer].has_nothing || layer == LAYER_ERROR) {
        const float none[LAYER_NUMBERS] = {layer == LAYER_ERROR ? 0 : NAN};
        ticks[count] = (LayerTick){.words = layer == LAYER_ERROR ? N_("no error") : N_("nothing")};
        layer_color(layer, scale, none, ticks[count++].rgb);
    }
    return count;
}
