/**
 * @file
 * @brief What the user has changed of how a picture is drawn: engine, offset, depth and so on.
 */
#ifndef DIOPTRE_VIEW_TUNING_H
#define DIOPTRE_VIEW_TUNING_H

#include "dioptre/renderer.h"
#include "view/action.h"

/** What may be changed, as bits. */
typedef enum {
    TUNED_ENGINE = 1,   /**< The engine. */
    TUNED_OFFSET = 2,   /**< The offset strategy. */
    TUNED_EPSILON = 4,  /**< Its epsilon. */
    TUNED_DEPTH = 8,    /**< The depth. */
    TUNED_SAMPLES = 16, /**< The samples. */
    TUNED_LIGHT = 32    /**< The light. */
} Tuned;

/** What the user has changed. Starts as `{0}`: nothing. */
typedef struct Tuning {
    unsigned changed;      /**< What: #Tuned. */
    RenderSettings wanted; /**< To what; only what was changed counts. */
} Tuning;

/** Puts what was changed into settings. @param tuning What. @param[in,out] settings As asked for
 *  otherwise. */
void tuning_apply(const Tuning *tuning, RenderSettings *settings);

/**
 * Changes something.
 * @param[in,out] tuning  What is changed so far.
 * @param now             The settings of now.
 * @param action          What: see #action_is_tuning.
 */
void tuning_change(Tuning *tuning, const RenderSettings *now, Action action);

/** @return What to call which light there is, in English. @param light The light. */
const char *tuning_light_name(LightMode light);

#endif
