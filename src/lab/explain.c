/**
 * @file
 * @brief Saying in a paragraph what a scene needs, and why.
 */
#include "dioptre/language.h"
#include "dioptre/needs.h"

#include <libintl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/** A text that grows. */
typedef struct Text {
    char *words; /**< It. */
    size_t size; /**< Bytes there is room for. */
} Text;

/** Adds to a text. @param[in,out] text The text. @param format What, in English, as for printf,
 * looked up here. */
static void say(Text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void say(Text *text, const char *format, ...) {
    size_t length = strlen(text->words);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text->words + length, text->size - length, gettext(format), arguments);
    va_end(arguments);
}

/** Adds to a text what is no format. @param[in,out] text The text. @param words What, in English,
 *  looked up here. */
static void say_words(Text *text, const char *words) {
    size_t length = strlen(text->words);
    snprintf(text->words + length, text->size - length, "%s", gettext(words));
}

/** @return What an engine computes with. @param engine The engine. */
static const char *type_name(const Engine *engine) {
    return engine->mantissa_bits < 53 ? "float" : engine->mantissa_bits == 53 ? "double" : "quad";
}

/** Bytes of an ordinal number, with its final zero. */
enum { ORDINAL_SIZE = 24 };

/** @return A number's ordinal. @param n The number, at least 0. @param[out] words Room for it. */
static const char *ordinal(int n, char words[ORDINAL_SIZE]) {
    // A language may have a word of its own for the first alone, not for the 21st.
    static const char *const forms[] = {N_("%dth"), N_("%dst"), N_("%dnd"), N_("%drd"), N_("1st")};
    int last = n % 10;
    int form = n / 10 % 10 == 1 || last > 3 ? 0 : last;
    snprintf(words, ORDINAL_SIZE, gettext(forms[n == 1 ? 4 : form]), n);
    return words;
}

/** Says why float is forecast to be enough, or not. @param[in,out] text The text.
 *  @param forecast The forecast. @param is_enough Whether it is. */
static void say_cause(Text *text, const Forecast *forecast, bool is_enough) {
    if (is_enough && forecast->radii > 0) {
        say(text, "the farthest thing is %.3g of its radii away", forecast->radii);
        return;
    }
    static const char *const causes[FORECAST_COUNT] = {
        [FORECAST_DISTANCE] = N_("the farthest thing is too many of its radii away"),
        [FORECAST_PIXEL] = N_("a pixel is hardly wider than an ulp of a ray's direction"),
        [FORECAST_PLACE] = N_("coordinates are so large that an ulp of them is seen"),
        [FORECAST_TURNS] = N_("curved mirrors and glass drive rays apart at each turn"),
        [FORECAST_HORIZON] = N_("towards the horizon the texels of a picture crowd in a pixel"),
        [FORECAST_FRACTAL] = N_("a fractal turns its normals within a tolerance"),
        [FORECAST_WALL] = N_("walls of glass are as thin as roundings of their coordinates"),
        [FORECAST_FACETS] =
            N_("faces of models that lamps graze are lit or dark as roundings have it")};
    say_words(text, is_enough ? N_("no length of the scene is large against another")
                              : causes[forecast->cause]);
}

/** Says which number type is enough. @param[in,out] text The text. @param needs What is needed. */
static void say_type(Text *text, const Needs *needs) {
    const NeedsEngine *chosen = &needs->engines[needs->engine], *fast = &needs->engines[0];
    bool is_float = needs->engine == 0;
    bool is_forecast = forecast_steps(&needs->forecast) < FORECAST_VISIBLE;
    say(text, "%c%s is enough: ", type_name(chosen->engine)[0] - 'a' + 'A',
        type_name(chosen->engine) + 1);
    if (is_float == is_forecast) {
        say_cause(text, &needs->forecast, is_float);
    } else {
        say(text, "the pilot says so against the forecast of %.2g steps",
            forecast_steps(&needs->forecast));
    }
    double ratio = needs->engines[1].seconds / fast->seconds;
    if (is_float) {
        say(text,
            "; it is off by %.2g steps at most, and double would take %.2g times as long and "
            "change nothing that can be seen",
            fast->trial.worst, ratio);
    } else {
        say(text,
            "; float would take %.2g times as long and be off by up to %.2g steps in %zu of %zu "
            "rays",
            1 / ratio, fast->trial.worst, fast->trial.off + fast->trial.strays, fast->trial.rays);
    }
}

/** Says how deep rays must be followed. @param[in,out] text The text. @param needs What is needed.
 */
static void say_depth(Text *text, const Needs *needs) {
    if (!needs->is_recursive) {
        say(text, ". Depth 0: nothing mirrors and nothing lets light through");
        return;
    }
    char words[ORDINAL_SIZE];
    say(text, ". Depth %d: the %s turn of a ray is worth %.2g steps at most", needs->depth,
        ordinal(needs->depth + 1, words), needs->at_depth.worst);
    if (needs->depth > 0) {
        say(text, ", the %s still %.2g", ordinal(needs->depth, words), needs->shallower.worst);
    }
    if (needs->depth_asked >= 0 && needs->depth_asked < needs->depth) {
        say(text, "; the scene's own %d leaves up to %.3g", needs->depth_asked,
            needs->as_asked.worst);
    }
    if (needs->at_cutoff.off > 0) {
        say(text,
            ". Light is so bright here that rays count which end at a share of 0.00015: by %.2g "
            "steps in %zu of %zu",
            needs->at_cutoff.worst, needs->at_cutoff.off, needs->at_cutoff.rays);
    }
}

/** Says what else is needed. @param[in,out] text The text. @param needs What is needed. */
static void say_rest(Text *text, const Needs *needs) {
    if (needs->is_marched && needs_fails(&needs->at_tolerance)) {
        say(text,
            ". Finer tolerances of the fields would still change %zu of %zu rays, by up to %.2g "
            "steps",
            needs->at_tolerance.off, needs->at_tolerance.rays, needs->at_tolerance.worst);
    } else if (needs->is_marched) {
        say(text, ". Tolerances of the fields may be %g times as coarse: that is worth %.2g steps",
            needs->tolerance, needs->at_tolerance.worst);
    }
    double wrong = (double)(needs->offset_none.off + needs->offset_none.strays);
    say(text,
        ". Rays must start a bound away from surfaces: at the surface itself %.2g %% of them "
        "would be wrong",
        100 * wrong / (double)needs->offset_none.rays);
    say(text, ngettext(". %d ray a pixel: ", ". %d rays a pixel: ", (unsigned long)needs->samples),
        needs->samples);
    if (needs->samples_share > 0) {
        say(text,
            "four times as many would still change %.2g %% of the pixels, by "
            "%.2g steps",
            100 * needs->samples_share, needs->samples_rms);
    } else {
        say(text, "more would change nothing");
    }
}

void needs_explain(const Needs *needs, char *words, size_t size) {
    Text text = {words, size};
    words[0] = 0;
    say_type(&text, needs);
    say_depth(&text, needs);
    say_rest(&text, needs);
    say(&text, ". All this takes %.2g times less than everything on.",
        needs->everything / needs->engines[needs->engine < 2 ? needs->engine : 1].seconds);
}
