/**
 * @file
 * @brief What the user has changed of the render settings: engine, offset, depth and so on.
 */
#ifndef DIOPTRE_VIEW_STATE_SETTINGS_OVERRIDE_H
#define DIOPTRE_VIEW_STATE_SETTINGS_OVERRIDE_H

#include "dioptre/renderer.h"

/** Largest depth that keys set; beyond it, none is set: #DEPTH_MAXIMUM. */
enum { KEY_DEPTH_MAXIMUM = 64 };
/** Most samples that keys set. */
enum { KEY_SAMPLES_MAXIMUM = 4096 };

/** The number types that keys choose from. */
typedef enum { NUMBER_FLOAT, NUMBER_DOUBLE, NUMBER_QUAD, NUMBER_TYPE_COUNT } NumberType;

/** The settings that can be changed, as bits. */
typedef enum {
    SETTING_ENGINE = 1,   /**< The engine. */
    SETTING_OFFSET = 2,   /**< The offset strategy. */
    SETTING_EPSILON = 4,  /**< Its epsilon. */
    SETTING_DEPTH = 8,    /**< The depth. */
    SETTING_SAMPLES = 16, /**< The samples. */
    SETTING_LIGHT = 32,   /**< The lighting mode. */
    SETTING_PIXEL = 64,   /**< The point of a pixel that its ray goes through. */
    SETTING_METHODS = 128 /**< Whose methods. */
} SettingsMask;

/** What the user has changed. Starts as `{0}`: nothing. */
typedef struct SettingsOverride {
    unsigned mask;         /**< Which settings are overridden, see #SettingsMask. */
    RenderSettings values; /**< Their values; only those in #mask are valid. */
} SettingsOverride;

/** Overwrites the settings that the user has changed. */
void settings_override_apply(const SettingsOverride *overrides, RenderSettings *settings);

/** @return Which settings differ, see #SettingsMask. */
unsigned settings_difference(const RenderSettings *a, const RenderSettings *b);

/** The settings without the user's changes are others now: changes what the user has changed, so
 *  that the settings in force stay. @param from What they were. @param to What they are. */
void settings_override_rebase(SettingsOverride *overrides, const RenderSettings *from,
                              const RenderSettings *to);

/**
 * Changes one setting.
 * @param[in,out] overrides  What is changed so far.
 * @param current  The settings in force.
 * @param step     How far; see each function.
 */
typedef void SettingsChangeFn(SettingsOverride *overrides, const RenderSettings *current, int step);

/** @return The widest number type that an engine's mantissa holds. */
NumberType number_type_of(const Engine *engine);

/** Changes the number type. @param step 1: float, double, quad, float; -1: backwards. */
void settings_override_engine(SettingsOverride *overrides, const RenderSettings *current, int step);

/** Changes the offset strategy. @param step 1: none, fixed, bound, none; -1: backwards. */
void settings_override_offset(SettingsOverride *overrides, const RenderSettings *current, int step);

/** Scales epsilon, and makes the offset strategy `fixed`. @param step Factor; negative: divisor. */
void settings_override_epsilon(SettingsOverride *overrides, const RenderSettings *current,
                               int step);

/** Changes the depth, within its limits. @param step How much it grows. */
void settings_override_depth(SettingsOverride *overrides, const RenderSettings *current, int step);

/** Doubles or halves the samples, within their limits. @param step 1: twice; -1: half. */
void settings_override_samples(SettingsOverride *overrides, const RenderSettings *current,
                               int step);

/** Changes the lighting mode. @param step 1: the next; -1: the previous. */
void settings_override_lighting(SettingsOverride *overrides, const RenderSettings *current,
                                int step);

/** Changes between the centre and the corner of pixels. @param step Ignored. */
void settings_override_pixel(SettingsOverride *overrides, const RenderSettings *current, int step);

/** Changes whose methods the picture is traced with; offset and epsilon become theirs. @param step
 *  1: own, report A, B, C, D, own; -1: backwards. */
void settings_override_methods(SettingsOverride *overrides, const RenderSettings *current,
                               int step);

/** @return Name of a lighting mode, in English. */
const char *light_mode_name(LightingMode light);

#endif
