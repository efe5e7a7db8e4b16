/**
 * @file
 * @brief Explains in a paragraph what a scene needs, and why.
 */
#include "base/language.h"
#include "lab/needs/needs.h"

#include <libintl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/** A text that grows. */
typedef struct TextBuffer {
    char *buffer; /**< The text, ended by a zero. */
    size_t size;  /**< Bytes of the buffer. */
} TextBuffer;

/** Appends to a text. @param format English, as for printf; translated here. */
static void append_format(TextBuffer *text, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void append_format(TextBuffer *text, const char *format, ...) {
    size_t length = strlen(text->buffer);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text->buffer + length, text->size - length, gettext(format), arguments);
    va_end(arguments);
}

/** Appends to a text. @param words English, no format; translated here. */
static void append_text(TextBuffer *text, const char *words) {
    size_t length = strlen(text->buffer);
    snprintf(text->buffer + length, text->size - length, "%s", gettext(words));
}

/** @return The number type of an engine. */
static const char *type_name(const Engine *engine) {
    return engine->mantissa_bits < 53 ? "float" : engine->mantissa_bits == 53 ? "double" : "quad";
}

/** Bytes of an ordinal number, with its final zero. */
enum { ORDINAL_SIZE = 24 };

/** @return The ordinal of a number. @param n At least 0. */
static const char *format_ordinal(int n, char words[ORDINAL_SIZE]) {
    // French has a special form for 1, but not for 21.
    static const char *const forms[] = {N_("%dth"), N_("%dst"), N_("%dnd"), N_("%drd"), N_("1st")};
    int last = n % 10;
    int form = n / 10 % 10 == 1 || last > 3 ? 0 : last;
    snprintf(words, ORDINAL_SIZE, gettext(forms[n == 1 ? 4 : form]), n);
    return words;
}

/** Explains the estimate: why float is sufficient, or not. */
static void append_cause(TextBuffer *text, const PrecisionEstimate *forecast, bool is_enough) {
    if (is_enough && forecast->max_distance_in_radii > 0) {
        append_format(text, "the farthest thing is %.3g of its radii away",
                      forecast->max_distance_in_radii);
        return;
    }
    static const char *const causes[PRECISION_CAUSE_COUNT] = {
        [PRECISION_DISTANCE] = N_("the farthest thing is too many of its radii away"),
        [PRECISION_PIXEL_ANGLE] = N_("a pixel is hardly wider than an ulp of a ray's direction"),
        [PRECISION_POSITION] = N_("coordinates are so large that an ulp of them is seen"),
        [PRECISION_RAY_DIVERGENCE] = N_("curved mirrors and glass drive rays apart at each turn"),
        [PRECISION_HORIZON] = N_("towards the horizon the texels of a picture crowd in a pixel"),
        [PRECISION_FRACTAL] = N_("a fractal turns its normals within a tolerance"),
        [PRECISION_THIN_GLASS] = N_("walls of glass are as thin as roundings of their coordinates"),
        [PRECISION_SHADOW_TERMINATOR] =
            N_("faces of models that lamps graze are lit or dark as roundings have it"),
        [PRECISION_TRAPPED_LIGHT] = N_("overlapping glass reflects light dozens of times")};
    append_text(text, is_enough ? N_("no length of the scene is large against another")
                                : causes[forecast->cause]);
}

/** Names the sufficient number type. */
static void append_number_type(TextBuffer *text, const Needs *needs) {
    const NeedsEngine *chosen = &needs->engines[needs->engine], *fast = &needs->engines[0];
    bool is_float = needs->engine == 0;
    bool is_forecast = precision_estimate_error(&needs->forecast) < PRECISION_VISIBLE_ERROR;
    append_format(text, "%c%s is enough: ", type_name(chosen->engine)[0] - 'a' + 'A',
                  type_name(chosen->engine) + 1);
    if (is_float == is_forecast) {
        append_cause(text, &needs->forecast, is_float);
    } else {
        append_format(text, "the pilot says so against the forecast of %.2g steps",
                      precision_estimate_error(&needs->forecast));
    }
    double ratio = needs->engines[1].cpu_seconds / fast->cpu_seconds;
    if (is_float) {
        append_format(
            text,
            "; it is off by %.2g steps at most, and double would take %.2g times as long and "
            "change nothing that can be seen",
            fast->trial.max_steps, ratio);
    } else {
        append_format(
            text,
            "; float would take %.2g times as long and be off by up to %.2g steps in %zu of %zu "
            "rays",
            1 / ratio, fast->trial.max_steps, fast->trial.visible + fast->trial.outliers,
            fast->trial.rays);
    }
}

/** Explains the depth. */
static void append_depth(TextBuffer *text, const Needs *needs) {
    if (!needs->is_recursive) {
        append_format(text, ". Depth 0: nothing mirrors and nothing lets light through");
        return;
    }
    char words[ORDINAL_SIZE];
    append_format(text, ". Depth %d: the %s turn of a ray is worth %.2g steps at most",
                  needs->depth, format_ordinal(needs->depth + 1, words),
                  needs->depth_trial.max_steps);
    if (needs->depth > 0) {
        append_format(text, ", the %s still %.2g", format_ordinal(needs->depth, words),
                      needs->shallower_trial.max_steps);
    }
    if (needs->scene_depth >= 0 && needs->scene_depth < needs->depth) {
        append_format(text, "; the scene's own %d leaves up to %.3g", needs->scene_depth,
                      needs->scene_depth_trial.max_steps);
    }
    if (needs->cutoff_trial.visible > 0) {
        append_format(
            text,
            ". Light is so bright here that rays count which end at a share of 0.00015: by %.2g "
            "steps in %zu of %zu",
            needs->cutoff_trial.max_steps, needs->cutoff_trial.visible, needs->cutoff_trial.rays);
    }
}

/** Explains tolerances, offset and samples. */
static void append_other_settings(TextBuffer *text, const Needs *needs) {
    if (needs->has_sdf && needs_trial_fails(&needs->tolerance_trial)) {
        append_format(
            text,
            ". Finer tolerances of the fields would still change %zu of %zu rays, by up to %.2g "
            "steps",
            needs->tolerance_trial.visible, needs->tolerance_trial.rays,
            needs->tolerance_trial.max_steps);
    } else if (needs->has_sdf) {
        append_format(
            text, ". Tolerances of the fields may be %g times as coarse: that is worth %.2g steps",
            needs->tolerance, needs->tolerance_trial.max_steps);
    }
    double wrong = (double)(needs->offset_none_trial.visible + needs->offset_none_trial.outliers);
    append_format(
        text,
        ". Rays must start a bound away from surfaces: at the surface itself %.2g %% of them "
        "would be wrong",
        100 * wrong / (double)needs->offset_none_trial.rays);
    append_format(
        text, ngettext(". %d ray a pixel: ", ". %d rays a pixel: ", (unsigned long)needs->samples),
        needs->samples);
    if (needs->samples_fraction > 0) {
        append_format(text,
                      "four times as many would still change %.2g %% of the pixels, by "
                      "%.2g steps",
                      100 * needs->samples_fraction, needs->samples_rms);
    } else {
        append_format(text, "more would change nothing");
    }
}

void needs_explain(const Needs *needs, char *words, size_t size) {
    TextBuffer text = {words, size};
    words[0] = 0;
    append_number_type(&text, needs);
    append_depth(&text, needs);
    append_other_settings(&text, needs);
    append_format(&text, ". All this takes %.2g times less than everything on.",
                  needs->reference_cpu_seconds /
                      needs->engines[needs->engine < 2 ? needs->engine : 1].cpu_seconds);
}
