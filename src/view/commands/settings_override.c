/**
 * @file
 * @brief Changing how a picture is drawn.
 */
#include "view/commands/settings_override.h"

#include "base/language.h"

#include <math.h>

/** Epsilon is times this with each key. */
static const double EPSILON_STEP = 2;
/** And this with Shift. */
static const double EPSILON_LARGE_STEP = 10;
/** Smallest epsilon, scene units: far below what any scene shows. */
static const double EPSILON_MINIMUM = 1e-15;
/** Largest epsilon, scene units. */
static const double EPSILON_MAXIMUM = 1e6;
/** Most mirrors and refractions that keys ask for. */
enum { KEY_DEPTH_MAXIMUM = 64 };
/** Most samples that keys ask for. */
enum { KEY_SAMPLES_MAXIMUM = 4096 };
/** Offset strategies that there are. */
enum { OFFSET_COUNT = OFFSET_BOUND + 1 };

void settings_override_apply(const SettingsOverride *overrides, RenderSettings *settings) {
    const RenderSettings *values = &overrides->values;
    unsigned mask = overrides->mask;
    settings->engine = mask & SETTING_ENGINE ? values->engine : settings->engine;
    settings->trace.offset = mask & SETTING_OFFSET ? values->trace.offset : settings->trace.offset;
    settings->trace.epsilon =
        mask & SETTING_EPSILON ? values->trace.epsilon : settings->trace.epsilon;
    settings->trace.depth = mask & SETTING_DEPTH ? values->trace.depth : settings->trace.depth;
    settings->samples = mask & SETTING_SAMPLES ? values->samples : settings->samples;
    settings->lighting = mask & SETTING_LIGHT ? values->lighting : settings->lighting;
}

/** @return One of some numbers after another, around. */
static int wrap(int current, int step, int count) {
    return (current + step + count) % count;
}

/** @return The preferred engine of a number type. */
static const Engine *engine_with_mantissa(int bits) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if ((*engine)->mantissa_bits == bits && engine_is_supported(*engine)) {
            return *engine;
        }
    }
    return NULL;
}

/**
 * @return The engine of the next number type: float, double, quad.
 * @param step  1: wider; -1: narrower.
 */
static const Engine *next_number_type(const Engine *engine, int step) {
    static const int types[] = {24, 53, 113};
    enum { TYPE_COUNT = sizeof types / sizeof types[0] };
    int current = 0;
    for (int i = 0; i < TYPE_COUNT; i++) {
        current = engine->mantissa_bits >= types[i] ? i : current;
    }
    const Engine *next = engine_with_mantissa(types[wrap(current, step, TYPE_COUNT)]);
    return next ? next : engine;
}

/** Changes epsilon, which then counts. */
static void override_epsilon(SettingsOverride *overrides, const RenderSettings *current,
                             double factor) {
    double epsilon = current->trace.epsilon * factor;
    overrides->values.trace.epsilon = fmin(fmax(epsilon, EPSILON_MINIMUM), EPSILON_MAXIMUM);
    overrides->values.trace.offset = OFFSET_FIXED;
    overrides->mask |= SETTING_EPSILON | SETTING_OFFSET;
}

/** @return By how much an action changes epsilon. */
static double epsilon_factor(Action action) {
    switch (action) {
    case ACTION_EPSILON_HALF:
        return 1 / EPSILON_STEP;
    case ACTION_EPSILON_TENTH:
        return 1 / EPSILON_LARGE_STEP;
    case ACTION_EPSILON_TWICE:
        return EPSILON_STEP;
    default:
        return EPSILON_LARGE_STEP;
    }
}

/**
 * @return 1: an action goes on; -1: back.
 * @param action  One of two that stand side by side.
 */
static int action_step(Action action, Action first) {
    return action == first ? 1 : -1;
}

void settings_override_change(SettingsOverride *overrides, const RenderSettings *current,
                              Action action) {
    RenderSettings *values = &overrides->values;
    if (action <= ACTION_ENGINE_PREVIOUS) {
        values->engine = next_number_type(current->engine, action_step(action, ACTION_ENGINE_NEXT));
        overrides->mask |= SETTING_ENGINE;
    } else if (action <= ACTION_OFFSET_PREVIOUS) {
        int step = action_step(action, ACTION_OFFSET_NEXT);
        values->trace.offset = (OffsetStrategy)wrap((int)current->trace.offset, step, OFFSET_COUNT);
        overrides->mask |= SETTING_OFFSET;
    } else if (action <= ACTION_EPSILON_TEN_TIMES) {
        override_epsilon(overrides, current, epsilon_factor(action));
    } else if (action <= ACTION_DEPTH_LESS) {
        int depth = current->trace.depth + action_step(action, ACTION_DEPTH_MORE);
        values->trace.depth = depth < 0 ? 0 : depth > KEY_DEPTH_MAXIMUM ? KEY_DEPTH_MAXIMUM : depth;
        overrides->mask |= SETTING_DEPTH;
    } else if (action <= ACTION_SAMPLES_HALF) {
        int samples = action == ACTION_SAMPLES_TWICE ? current->samples * 2 : current->samples / 2;
        values->samples = samples < 1                     ? 1
                          : samples > KEY_SAMPLES_MAXIMUM ? KEY_SAMPLES_MAXIMUM
                                                          : samples;
        overrides->mask |= SETTING_SAMPLES;
    } else {
        int step = action_step(action, ACTION_LIGHT_MODE_NEXT);
        values->lighting = (LightingMode)wrap((int)current->lighting, step, LIGHTING_MODE_COUNT);
        overrides->mask |= SETTING_LIGHT;
    }
}

const char *light_mode_name(LightingMode light) {
    static const char *const names[] = {N_("light and ambient"), N_("light alone"), N_("none")};
    return names[light];
}
