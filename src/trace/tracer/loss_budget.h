/**
 * @file
 * @brief The budget of losses: how much light a camera ray may lack because rays below it ended.
 *
 * The theory is in doc/cutoff.md.
 */
#ifndef DIOPTRE_TRACE_TRACER_LOSS_BUDGET_H
#define DIOPTRE_TRACE_TRACER_LOSS_BUDGET_H

#include "trace/tracer/packet.h"

/** What may be ended below a camera ray. */
typedef struct LossBudget {
    double *texture_peaks; /**< The #texture_peak of each texture of the scene; owned. */
    Rgbd ambient;          /**< Ambient light of the scene. */
    double cutoff;         /**< #TraceSettings.cutoff */
    scalar fraction;       /**< The cutoff as a fraction of the range of the encoded picture. */
    scalar radiance_bound; /**< No ray brings back more light. */
    scalar throughput;     /**< Rays of less throughput end in the first pass. */
    scalar merged;         /**< Rays of less throughput may be merged. */
    bool is_linear;        /**< Whether the encoding is linear. */
} LossBudget;

/**
 * Begins a budget; loss_budget_set_view() completes it.
 * @param scene  The scene; its lights may move later.
 * @return Whether memory sufficed.
 */
bool loss_budget_init(LossBudget *budget, const Scene *scene, const TraceSettings *settings);

/** Frees a budget. */
void loss_budget_deinit(LossBudget *budget);

/** Finds the brightest light from where the lights are. @param light_count Those that shine. */
void loss_budget_set_view(LossBudget *budget, const Scene *scene, size_t light_count);

/** @return The light that a channel of rays may lack, at least. @param color The light it has. */
INLINE real loss_budget_channel(const LossBudget *budget, real color) {
    // 1 / slope of the sRGB curve: 1 / 12.92 in the dark, then c^(7/12) 2.4 / 1.055, of which
    // c^(5/8), by square roots, is a lower bound.
    const scalar in_the_dark = (scalar)(1 / 12.92), factor = (scalar)(2.4 / 1.055);
    real root = real_sqrt(real_min(real_max(color, real_of(0)), real_of(1)));
    real eighth_root = real_sqrt(real_sqrt(root));
    real inverse_slope = real_max(factor * root * eighth_root, real_of(in_the_dark));
    return budget->fraction * (budget->is_linear ? real_of(1) : inverse_slope);
}

/** @return The rays that may lack more light in any channel than they may.
 *  @param lost  Sum of the throughputs that were ended.
 *  @param color  The light they have. */
INLINE mask loss_budget_exceeded(const LossBudget *budget, Rgb lost, Rgb color) {
    const scalar bound = budget->radiance_bound;
    mask red = lost.red * bound > loss_budget_channel(budget, color.red);
    mask green = lost.green * bound > loss_budget_channel(budget, color.green);
    mask blue = lost.blue * bound > loss_budget_channel(budget, color.blue);
    return red | green | blue;
}

#endif
