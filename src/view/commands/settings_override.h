/**
 * @file
 * @brief What the user has changed of how a picture is drawn: engine, offset, depth and so on.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_SETTINGS_OVERRIDE_H
#define DIOPTRE_VIEW_COMMANDS_SETTINGS_OVERRIDE_H

#include "dioptre/renderer.h"
#include "view/commands/action.h"

/** What may be changed, as bits. */
typedef enum {
    SETTING_ENGINE = 1,   /**< The engine. */
    SETTING_OFFSET = 2,   /**< The offset strategy. */
    SETTING_EPSILON = 4,  /**< Its epsilon. */
    SETTING_DEPTH = 8,    /**< The depth. */
    SETTING_SAMPLES = 16, /**< The samples. */
    SETTING_LIGHT = 32    /**< The light. */
} SettingsMask;

/** What the user has changed. Starts as `{0}`: nothing. */
typedef struct SettingsOverride {
    unsigned mask;         /**< What: #SettingsMask. */
    RenderSettings values; /**< To what; only what was changed counts. */
} SettingsOverride;

/** Puts what was changed into settings. @param[in,out] settings As asked for otherwise. */
void settings_override_apply(const SettingsOverride *overrides, RenderSettings *settings);

/** Changes something. @param[in,out] overrides What is changed so far. */
void settings_override_change(SettingsOverride *overrides, const RenderSettings *current,
                              Action action);

/** @return What to call which light there is, in English. */
const char *light_mode_name(LightingMode light);

#endif
