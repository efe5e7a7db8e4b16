/**
 * @file
 * @brief Saying in a paragraph what a scene needs, and why.
 */
#include "dioptre/needs.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/** A text that grows. */
typedef struct Text {
    char *words; /**< It. */
    size_t size; /**< Bytes there is room for. */
} Text;

/** Adds to a text. @param[in,out] text The text. @param format What, as for printf. */
static void say(Text *text, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void say(Text *text, const char *format, ...) {
    size_t length = strlen(text->words);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text->words + length, text->size - length, format, arguments);
    va_end(arguments);
}

/** @return What an engine computes with. @param engine The engine. */
static const char *type_name(const Engine *engine) {
    return engine->mantissa_bits < 53 ? "float" : engine->mantissa_bits == 53 ? "double" : "quad";
}

/** @return A number's ordinal ending. @param n The number, at least 0. */
static const char *ending(int n) {
    static const char *const endings[] = {"th", "st", "nd", "rd"};
    int last = n % 10;
    return n / 10 % 10 == 1 || last > 3 ? "th" : endings[last];
}

/** Says why float is forecast to be enough, or not. @param[in,out] text The text.
 *  @param forecast The forecast. @param is_enough Whether it is. */
static void say_cause(Text *text, const Forecast *forecast, bool is_enough) {
    if (is_enough && forecast->radii > 0) {
        say(text, "the farthest thing is %.3g of its radii away", forecast->radii);
        return;
    }
    static const char *const causes[FORECAST_COUNT] = {
        [FORECAST_DISTANCE] = "the farthest thing is too many of its radii away",
        [FORECAST_PIXEL] = "a pixel is hardly wider than an ulp of a ray's direction",
        [FORECAST_PLACE] = "coordinates are so large that an ulp of them is seen",
        [FORECAST_TURNS] = "curved mirrors and glass drive rays apart at each turn",
        [FORECAST_HORIZON] = "towards the horizon the texels of a picture crowd in a pixel",
        [FORECAST_FRACTAL] = "a fractal turns its normals within a tolerance",
        [FORECAST_WALL] = "walls of glass are as thin as roundings of their coordinates"};
    say(text, "%s",
        is_enough ? "no length of the scene is large against another" : causes[forecast->cause]);
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
    int next = needs->depth + 1;
    say(text, ". Depth %d: the %d%s turn of a ray is worth %.2g steps at most", needs->depth, next,
        ending(next), needs->at_depth.worst);
    if (needs->depth > 0) {
        say(text, ", the %d%s still %.2g", needs->depth, ending(needs->depth),
            needs->shallower.worst);
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
    say(text, ". %d ray%s a pixel: ", needs->samples, needs->samples == 1 ? "" : "s");
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
