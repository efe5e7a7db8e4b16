/**
 * @file
 * @brief Changing render settings step by step.
 */
#include "view/state/settings_override.h"

#include "base/language.h"

#include <math.h>

/** Smallest epsilon, scene units: far below any visible effect. */
static const double EPSILON_MINIMUM = 1e-15;
/** Largest epsilon, scene units. */
static const double EPSILON_MAXIMUM = 1e6;
/** Bits of the mantissa of each #NumberType. */
static const int mantissa_bits[NUMBER_TYPE_COUNT] = {24, 53, 113};
/** Number of offset strategies. */
enum { OFFSET_COUNT = OFFSET_BOUND + 1 };

void settings_override_apply(const SettingsOverride *overrides, RenderSettings *settings) {
    const RenderSettings *values = &overrides->values;
    unsigned mask = overrides->mask;
    if (mask & SETTING_METHODS) {
        method_set_apply(values->method_set, settings);
    }
    settings->engine = mask & SETTING_ENGINE ? values->engine : settings->engine;
    settings->trace.offset = mask & SETTING_OFFSET ? values->trace.offset : settings->trace.offset;
    settings->trace.epsilon =
        mask & SETTING_EPSILON ? values->trace.epsilon : settings->trace.epsilon;
    settings->trace.depth = mask & SETTING_DEPTH ? values->trace.depth : settings->trace.depth;
    settings->samples = mask & SETTING_SAMPLES ? values->samples : settings->samples;
    settings->lighting = mask & SETTING_LIGHT ? values->lighting : settings->lighting;
    settings->trace.pixel_point =
        mask & SETTING_PIXEL ? values->trace.pixel_point : settings->trace.pixel_point;
}

unsigned settings_difference(const RenderSettings *a, const RenderSettings *b) {
    const struct {
        bool is_other;        /**< Whether it differs. */
        SettingsMask setting; /**< The setting. */
    } settings[] = {{a->engine != b->engine, SETTING_ENGINE},
                    {a->trace.offset != b->trace.offset, SETTING_OFFSET},
                    {a->trace.epsilon != b->trace.epsilon, SETTING_EPSILON},
                    {a->trace.depth != b->trace.depth, SETTING_DEPTH},
                    {a->samples != b->samples, SETTING_SAMPLES},
                    {a->lighting != b->lighting, SETTING_LIGHT},
                    {a->trace.pixel_point != b->trace.pixel_point, SETTING_PIXEL},
                    {a->method_set != b->method_set, SETTING_METHODS}};
    unsigned mask = 0;
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++) {
        mask |= settings[i].is_other ? (unsigned)settings[i].setting : 0;
    }
    return mask;
}

void settings_override_rebase(SettingsOverride *overrides, const RenderSettings *from,
                              const RenderSettings *to) {
    RenderSettings wanted = *from, given = *to;
    settings_override_apply(overrides, &wanted);
    // Methods bring an offset of their own: what else was changed is found with them.
    SettingsOverride changed = {.mask = overrides->mask & SETTING_METHODS, .values = wanted};
    settings_override_apply(&changed, &given);
    changed.mask |= settings_difference(&wanted, &given);
    *overrides = changed;
}

/** @return A number below a count, some steps after another, cyclically. */
static int wrap(int current, int step, int count) {
    return (current + step + count) % count;
}

/** @return The preferred engine of a number type; NULL: this processor has none. */
static const Engine *engine_with_mantissa(int bits) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if ((*engine)->mantissa_bits == bits && engine_is_supported(*engine)) {
            return *engine;
        }
    }
    return NULL;
}

NumberType number_type_of(const Engine *engine) {
    NumberType type = NUMBER_FLOAT;
    while (type + 1 < NUMBER_TYPE_COUNT && engine->mantissa_bits >= mantissa_bits[type + 1]) {
        type++;
    }
    return type;
}

/**
 * @return The engine of the next number type: float, double, quad.
 * @param step  1: wider; -1: narrower.
 */
static const Engine *next_number_type(const Engine *engine, int step) {
    int next_type = wrap((int)number_type_of(engine), step, NUMBER_TYPE_COUNT);
    const Engine *next = engine_with_mantissa(mantissa_bits[next_type]);
    return next ? next : engine;
}

void settings_override_engine(SettingsOverride *overrides, const RenderSettings *current,
                              int step) {
    overrides->values.engine = next_number_type(current->engine, step);
    overrides->mask |= SETTING_ENGINE;
}

void settings_override_offset(SettingsOverride *overrides, const RenderSettings *current,
                              int step) {
    overrides->values.trace.offset =
        (OffsetStrategy)wrap((int)current->trace.offset, step, OFFSET_COUNT);
    overrides->mask |= SETTING_OFFSET;
}

void settings_override_epsilon(SettingsOverride *overrides, const RenderSettings *current,
                               int step) {
    double factor = step > 0 ? step : 1.0 / -step;
    double epsilon = current->trace.epsilon * factor;
    overrides->values.trace.epsilon = fmin(fmax(epsilon, EPSILON_MINIMUM), EPSILON_MAXIMUM);
    overrides->values.trace.offset = OFFSET_FIXED;
    overrides->mask |= SETTING_EPSILON | SETTING_OFFSET;
}

/** @return A number within limits. */
static int clamp(int number, int minimum, int maximum) {
    return number < minimum ? minimum : number > maximum ? maximum : number;
}

void settings_override_depth(SettingsOverride *overrides, const RenderSettings *current, int step) {
    int depth = clamp(current->trace.depth, 0, KEY_DEPTH_MAXIMUM + (step < 0)) + step;
    overrides->values.trace.depth = depth > KEY_DEPTH_MAXIMUM ? DEPTH_MAXIMUM
                                    : depth < 0               ? 0
                                                              : depth;
    overrides->mask |= SETTING_DEPTH;
}

void settings_override_samples(SettingsOverride *overrides, const RenderSettings *current,
                               int step) {
    int samples = step > 0 ? current->samples * 2 : current->samples / 2;
    overrides->values.samples = clamp(samples, 1, KEY_SAMPLES_MAXIMUM);
    overrides->mask |= SETTING_SAMPLES;
}

void settings_override_lighting(SettingsOverride *overrides, const RenderSettings *current,
                                int step) {
    overrides->values.lighting =
        (LightingMode)wrap((int)current->lighting, step, LIGHTING_MODE_COUNT);
    overrides->mask |= SETTING_LIGHT;
}

void settings_override_pixel(SettingsOverride *overrides, const RenderSettings *current, int step) {
    (void)step;
    overrides->values.trace.pixel_point =
        current->trace.pixel_point == PIXEL_CENTER ? PIXEL_CORNER : PIXEL_CENTER;
    overrides->mask |= SETTING_PIXEL;
}

void settings_override_methods(SettingsOverride *overrides, const RenderSettings *current,
                               int step) {
    overrides->values.method_set = (MethodSet)wrap((int)current->method_set, step, METHODS_COUNT);
    overrides->mask |= SETTING_METHODS;
    overrides->mask &= ~(unsigned)(SETTING_OFFSET | SETTING_EPSILON);
}

const char *light_mode_name(LightingMode light) {
    static const char *const names[] = {N_("light and ambient"), N_("light alone"), N_("none")};
    return names[light];
}
