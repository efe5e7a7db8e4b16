/**
 * @file
 * @brief Changing how a picture is drawn.
 */
#include "view/tuning.h"

#include "dioptre/language.h"

#include <math.h>

/** Epsilon is times this with each key. */
static const double EPSILON_STEP = 2;
/** And this with Shift. */
static const double EPSILON_LEAP = 10;
/** Smallest epsilon, scene units: far below what any scene shows. */
static const double EPSILON_LEAST = 1e-15;
/** Largest epsilon, scene units. */
static const double EPSILON_MOST = 1e6;
/** Most mirrors and refractions that keys ask for. */
enum { DEPTH_MOST = 64 };
/** Most samples that keys ask for. */
enum { SAMPLES_MOST = 4096 };
/** Offset strategies that there are. */
enum { OFFSET_COUNT = OFFSET_BOUND + 1 };

void tuning_apply(const Tuning *tuning, RenderSettings *settings) {
    const RenderSettings *wanted = &tuning->wanted;
    unsigned changed = tuning->changed;
    settings->engine = changed & TUNED_ENGINE ? wanted->engine : settings->engine;
    settings->trace.offset = changed & TUNED_OFFSET ? wanted->trace.offset : settings->trace.offset;
    settings->trace.epsilon =
        changed & TUNED_EPSILON ? wanted->trace.epsilon : settings->trace.epsilon;
    settings->trace.depth = changed & TUNED_DEPTH ? wanted->trace.depth : settings->trace.depth;
    settings->samples = changed & TUNED_SAMPLES ? wanted->samples : settings->samples;
    settings->light = changed & TUNED_LIGHT ? wanted->light : settings->light;
}

/** @return One of some numbers after another, around. @param now One, from 0. @param way 1 or -1.
 *  @param count How many. */
static int around(int now, int way, int count) {
    return (now + way + count) % count;
}

/** @return The preferred engine of a number type. @param bits Its mantissa, bits. */
static const Engine *engine_of(int bits) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if ((*engine)->mantissa_bits == bits && engine_is_supported(*engine)) {
            return *engine;
        }
    }
    return NULL;
}

/** @return The engine of the next number type: float, double, quad. @param engine The engine.
 *  @param way 1: wider; -1: narrower. */
static const Engine *engine_next(const Engine *engine, int way) {
    static const int types[] = {24, 53, 113};
    enum { TYPE_COUNT = sizeof types / sizeof types[0] };
    int now = 0;
    for (int i = 0; i < TYPE_COUNT; i++) {
        now = engine->mantissa_bits >= types[i] ? i : now;
    }
    const Engine *next = engine_of(types[around(now, way, TYPE_COUNT)]);
    return next ? next : engine;
}

/** Changes epsilon, which then counts. @param[in,out] tuning What is changed. @param now The
 *  settings of now. @param factor By how much. */
static void epsilon_change(Tuning *tuning, const RenderSettings *now, double factor) {
    double epsilon = now->trace.epsilon * factor;
    tuning->wanted.trace.epsilon = fmin(fmax(epsilon, EPSILON_LEAST), EPSILON_MOST);
    tuning->wanted.trace.offset = OFFSET_FIXED;
    tuning->changed |= TUNED_EPSILON | TUNED_OFFSET;
}

/** @return By how much an action changes epsilon. @param action The action. */
static double epsilon_factor(Action action) {
    switch (action) {
    case ACTION_EPSILON_HALF:
        return 1 / EPSILON_STEP;
    case ACTION_EPSILON_TENTH:
        return 1 / EPSILON_LEAP;
    case ACTION_EPSILON_TWICE:
        return EPSILON_STEP;
    default:
        return EPSILON_LEAP;
    }
}

/** @return 1: an action goes on; -1: back. @param action One of two that stand side by side.
 *  @param first The first of them. */
static int way_of(Action action, Action first) {
    return action == first ? 1 : -1;
}

void tuning_change(Tuning *tuning, const RenderSettings *now, Action action) {
    RenderSettings *wanted = &tuning->wanted;
    if (action <= ACTION_ENGINE_BACK) {
        wanted->engine = engine_next(now->engine, way_of(action, ACTION_ENGINE));
        tuning->changed |= TUNED_ENGINE;
    } else if (action <= ACTION_OFFSET_BACK) {
        int way = way_of(action, ACTION_OFFSET);
        wanted->trace.offset = (OffsetStrategy)around((int)now->trace.offset, way, OFFSET_COUNT);
        tuning->changed |= TUNED_OFFSET;
    } else if (action <= ACTION_EPSILON_TEN) {
        epsilon_change(tuning, now, epsilon_factor(action));
    } else if (action <= ACTION_DEPTH_BACK) {
        int depth = now->trace.depth + way_of(action, ACTION_DEPTH);
        wanted->trace.depth = depth < 0 ? 0 : depth > DEPTH_MOST ? DEPTH_MOST : depth;
        tuning->changed |= TUNED_DEPTH;
    } else if (action <= ACTION_SAMPLES_BACK) {
        int samples = action == ACTION_SAMPLES ? now->samples * 2 : now->samples / 2;
        wanted->samples = samples < 1 ? 1 : samples > SAMPLES_MOST ? SAMPLES_MOST : samples;
        tuning->changed |= TUNED_SAMPLES;
    } else {
        int way = way_of(action, ACTION_LIGHT_MODE);
        wanted->light = (LightMode)around((int)now->light, way, LIGHT_MODE_COUNT);
        tuning->changed |= TUNED_LIGHT;
    }
}

const char *tuning_light_name(LightMode light) {
    static const char *const names[] = {N_("light and ambient"), N_("light alone"), N_("none")};
    return names[light];
}
