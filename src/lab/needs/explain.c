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

/* --- the number type ----------------------------------------------------------------------------
 */

/** Says by experiment what makes float fail. */
static void append_float_cause(TextBuffer *text, const Needs *needs) {
    size_t off = needs->float_trial.off, straight = needs->float_depth_0_trial.off;
    size_t unlit = needs->float_unlit_trial.off;
    if (needs->is_recursive) {
        append_format(
            text,
            ". Without any turn of a ray %zu would be off, and without lights and shadows "
            "as well %zu",
            straight, unlit);
    } else {
        append_format(text, ". Without lights and shadows %zu would be off", unlit);
    }
    if (2 * unlit >= off) {
        append_text(text, N_(": float misses the places that rays meet, or their textures"));
    } else if (2 * straight >= off) {
        append_text(text, N_(": float misses shades and shadows"));
    } else {
        append_text(text, N_(": each turn of a ray magnifies the roundings of float"));
    }
}

/** Names the sufficient number type. */
static void append_number_type(TextBuffer *text, const Needs *needs) {
    const NeedsTrial *trial = &needs->float_trial;
    if (needs->settings.engine->mantissa_bits < needs->reference.engine->mantissa_bits) {
        append_format(text,
                      "Float is enough: double would take %.2g times as long and change %zu of %zu "
                      "pixels by %g steps or more, none by more than %.2g",
                      needs->double_over_float_seconds, trial->off, trial->pixels,
                      needs->error_steps, trial->max_steps);
        return;
    }
    append_text(text, needs_is_refuted(needs) ? N_("Double is best: ") : N_("Double is enough: "));
    append_format(
        text,
        "float would take %.2g times as long and put %zu of %zu pixels off by %g steps or "
        "more, by up to %.2g",
        1 / needs->double_over_float_seconds, trial->off, trial->pixels, needs->error_steps,
        trial->max_steps);
    if (needs->has_float_cause) {
        append_float_cause(text, needs);
    }
}

/** Says which engine of the number type is taken. */
static void append_engine(TextBuffer *text, const Needs *needs) {
    if (needs->settings.engine != needs->default_engine) {
        append_format(
            text,
            ". %s has the same bits as %s, which is taken by default, and was %.2g times as "
            "fast here",
            needs->settings.engine->name, needs->default_engine->name, needs->engine_ratio);
    }
}

/* --- depth, cutoff and tolerances ---------------------------------------------------------------
 */

/** Explains the depth. */
static void append_depth(TextBuffer *text, const Needs *needs) {
    if (!needs->is_recursive) {
        append_format(text, ". Depth 0: nothing mirrors and nothing lets light through");
        return;
    }
    append_format(text,
                  ". Depth %d: more turns of rays change %zu of %zu pixels, by up to %.2g steps",
                  needs->settings.depth, needs->depth_trial.off, needs->depth_trial.pixels,
                  needs->depth_trial.max_steps);
    if (needs->settings.depth > 0) {
        append_format(text, "; one turn less leaves %zu off, by up to %.2g",
                      needs->shallower_trial.off, needs->shallower_trial.max_steps);
    }
    if (needs->scene_depth >= 0 && needs->scene_depth < needs->settings.depth) {
        append_format(text, "; the depth %d that is set leaves %zu off, by up to %.3g",
                      needs->scene_depth, needs->scene_depth_trial.off,
                      needs->scene_depth_trial.max_steps);
    }
}

/** Explains the cutoff. */
static void append_cutoff(TextBuffer *text, const Needs *needs) {
    if (needs->is_recursive) {
        append_format(text,
                      ". Cutoff %g: the rays that it ends change %zu of %zu pixels, by up to %.2g "
                      "steps; a cutoff of %g would leave %zu off",
                      needs->settings.cutoff, needs->cutoff_trial.off, needs->cutoff_trial.pixels,
                      needs->cutoff_trial.max_steps, needs->coarser_cutoff,
                      needs->coarser_cutoff_trial.off);
    }
}

/** Explains tolerances. */
static void append_tolerance(TextBuffer *text, const Needs *needs) {
    if (!needs->has_sdf) {
        return;
    }
    if (!needs->is_tolerance_sufficient) {
        append_format(
            text,
            ". The scene's own tolerances leave %zu of %zu pixels off, by up to %.2g steps, "
            "and those %g times as large still %zu: they are taken as they are",
            needs->own_tolerance_trial.off, needs->own_tolerance_trial.pixels,
            needs->own_tolerance_trial.max_steps, needs->finest_tolerance,
            needs->finest_tolerance_trial.off);
    } else {
        append_format(
            text,
            ". Tolerances of the fields %g times the scene's: finer ones change %zu of %zu "
            "pixels, by up to %.2g steps",
            needs->settings.tolerance, needs->tolerance_trial.off, needs->tolerance_trial.pixels,
            needs->tolerance_trial.max_steps);
    }
    append_format(text, "; %g times as coarse, %zu would be off, by up to %.2g",
                  needs->coarser_tolerance / needs->settings.tolerance,
                  needs->coarser_tolerance_trial.off, needs->coarser_tolerance_trial.max_steps);
}

/* --- offset and rays per pixel ------------------------------------------------------------------
 */

/** Explains the ray offset. */
static void append_offset(TextBuffer *text, const Needs *needs) {
    const NeedsTrial *none = &needs->offset_trials[OFFSET_NONE];
    if (needs->settings.offset != OFFSET_BOUND) {
        append_format(
            text,
            ". Offset %s: it changes %zu of %zu pixels and takes %.2g times as long as the "
            "bound of each point",
            offset_strategy_names[needs->settings.offset],
            needs->offset_trials[needs->settings.offset].off, none->pixels, needs->offset_ratio);
    } else if (needs_trial_fails(none)) {
        append_format(text,
                      ". Rays start a bound away from surfaces: from the surface itself %zu of %zu "
                      "pixels would be off",
                      none->off, none->pixels);
    } else {
        append_format(text,
                      ". Rays start a bound away from surfaces: from the surface itself %zu of %zu "
                      "pixels would be off, but that saves no time",
                      none->off, none->pixels);
    }
}

/** Explains the rays per pixel. */
static void append_samples(TextBuffer *text, const Needs *needs) {
    const NeedsNoise *asked = &needs->noise[0], *last = &needs->noise[needs->noise_count - 1];
    int samples = needs->settings.samples;
    for (int i = 0; i < needs->noise_count; i++) {
        asked = needs->noise[i].samples == samples ? &needs->noise[i] : asked;
    }
    append_format(text,
                  ngettext(". %d ray per pixel: ", ". %d rays per pixel: ", (unsigned long)samples),
                  samples);
    append_format(text, "four times as many change %zu of %zu pixels, by up to %.2g steps",
                  asked->trial.off, asked->trial.pixels, asked->trial.max_steps);
    if (needs->is_noise_sufficient && samples > needs->asked_samples) {
        append_format(text, "; the %d of the scene leave %zu off", needs->asked_samples,
                      needs->noise[0].trial.off);
    } else if (!needs->is_noise_sufficient && last->samples > samples) {
        append_format(
            text,
            ". So the picture can be told from a better one by its noise; %d rays take %d "
            "times as long and still leave %zu off",
            last->samples, last->samples / samples, last->trial.off);
    } else if (!needs->is_noise_sufficient) {
        append_text(text, N_(". So the picture can be told from a better one by its noise"));
    }
}

/* --- all together -------------------------------------------------------------------------------
 */

/** Tells what whole pictures refuted. */
static void append_corrections(TextBuffer *text, const Needs *needs) {
    for (int i = 0; i < needs->correction_count; i++) {
        const NeedsCorrection *correction = &needs->corrections[i];
        char before[64];
        const NeedsSettings *settings = &correction->before;
        switch (correction->setting) {
        case NEEDS_ENGINE:
            snprintf(before, sizeof before, "%s", settings->engine->name);
            break;
        case NEEDS_DEPTH:
            snprintf(before, sizeof before, gettext("depth %d"), settings->depth);
            break;
        case NEEDS_CUTOFF:
            snprintf(before, sizeof before, gettext("cutoff %g"), settings->cutoff);
            break;
        case NEEDS_OFFSET:
            snprintf(before, sizeof before, gettext("offset %s"),
                     offset_strategy_names[settings->offset]);
            break;
        case NEEDS_TOLERANCE:
        case NEEDS_SETTING_COUNT:
            snprintf(before, sizeof before, gettext("tolerance %g"), settings->tolerance);
            break;
        }
        append_format(
            text, ". A whole picture refuted %s: %zu of %zu pixels were off, and %zu without it",
            before, correction->trial.off, correction->trial.pixels, correction->without.off);
    }
}

/** Says what no setting cures. */
static void append_refuted(TextBuffer *text, const Needs *needs) {
    for (int i = 0; i < needs->check_count; i++) {
        const NeedsCheck *check = &needs->checks[i];
        if (needs_trial_fails(&check->trial)) {
            append_format(text,
                          ". Against %s %zu of %zu pixels are still off, by up to %.2g steps: no "
                          "setting but that number type is finer",
                          type_name(check->reference), check->trial.off, check->trial.pixels,
                          check->trial.max_steps);
        }
    }
}

void needs_explain(const Needs *needs, char *words, size_t size) {
    TextBuffer text = {words, size};
    words[0] = 0;
    append_number_type(&text, needs);
    append_engine(&text, needs);
    append_depth(&text, needs);
    append_cutoff(&text, needs);
    append_tolerance(&text, needs);
    append_offset(&text, needs);
    append_samples(&text, needs);
    append_corrections(&text, needs);
    append_refuted(&text, needs);
    append_format(&text, ". Everything on would take %.2g times as long.", needs->reference_ratio);
}
