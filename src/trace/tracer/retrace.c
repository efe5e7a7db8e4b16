/**
 * @file
 * @brief Passes over camera rays.
 */
#include "trace/tracer/retrace.h"

#include "base/encoding.h"
#include "trace/tracer/ray_tree_recorder.h"
#include "trace/tracer/report_methods.h"

#include <string.h>

/** How many times smaller the throughput is at which rays end in the next pass. */
#define PASS_FACTOR ((scalar)8)

/** Surfaces that the light of an ended ray is taken to meet before it leaves: what was ended splits
 *  into at most throughput / cutoff rays at a time, and each meets so many. */
#define SURFACES_PER_PATH ((scalar)8)

/* --- recorders -------------------------------------------------------------------------------- */

/** Empties the records of the active rays of a packet, and begins a ray tree. */
static void recorders_begin(const RayState *rays) {
    const Recorders *recorders = rays->packet.context.recorders;
    const Rgb one = {real_of(1), real_of(1), real_of(1)};
    for (int i = 0; i < PACKET_RAYS; i++) {
        if (!mask_lane(rays->packet.active[i / LANES], i % LANES)) {
            continue;
        }
        if (recorders->path_hashes) {
            recorders->path_hashes[i] = 0;
        }
        if (recorders->aovs) {
            recorders->aovs[i] = (AovSample){0};
        }
    }
    if (recorders->ray_tree) {
        recorders->ray_tree->count = 0;
        recorders->ray_tree->is_truncated = false;
        ray_tree_push(recorders->ray_tree, RAY_CAMERA, rays, one);
    }
}

/** Traces the active rays of a packet once. @param cutoff Rays of less throughput end. */
static void trace_pass(const Tracer *tracer, scalar cutoff, const RayState *rays, Rgb *colors,
                       Losses *losses, RayCounts *counts) {
    const TraceContext context = {.tracer = tracer, .counts = counts, .cutoff = cutoff};
    RayTree *ray_tree = sample_context_ray_tree(&rays->packet.context);
    if (rays->packet.context.recorders) {
        recorders_begin(rays);
    }
    if (tracer->methods) {
        report_trace_camera_packet(&context, rays, colors, losses);
    } else {
        trace_packet(&context, rays, colors, losses);
    }
    if (ray_tree) {
        ray_tree_pop(ray_tree, colors[0]);
    }
}

/* --- losses ----------------------------------------------------------------------------------- */

/** @return The light that rays may lack. @param v Which vector of rays. */
INLINE real missing_radiance(const Tracer *tracer, const Losses *losses, int v) {
    return (losses->dropped[v] + losses->guarded[v]) * tracer->loss_budget.radiance_bound;
}

/** Finds the rays that may lack more light than the budget. @param[out] open Those.
 *  @return Whether there is any. */
static bool find_open_rays(const Tracer *tracer, const RayState *rays, const Rgb *colors,
                           const Losses *losses, mask *open) {
    bool is_any_open = false;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real budget = loss_budget_radiance(&tracer->loss_budget, colors[v]);
        open[v] = rays->packet.active[v] & (missing_radiance(tracer, losses, v) > budget);
        is_any_open = is_any_open || any(open[v]);
    }
    return is_any_open;
}

/** @return Whether any active ray lacks anything: seldom, where nothing is reflected. */
static bool losses_are_any(const RayState *rays, const Losses *losses) {
    mask lost = mask_of(false);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        lost |= rays->packet.active[v] & ((losses->dropped[v] > 0) | (losses->guarded[v] > 0));
    }
    return any(lost);
}

/**
 * Keeps the rays for which another pass can help: what the guard of the recursion ended is within
 * the budget, and the pass is not too much work.
 * @param next_cutoff  Rays of less throughput would end in that pass.
 * @param[in,out] open  The rays that lack too much light.
 * @return Whether any is left.
 */
static bool find_curable_rays(const Tracer *tracer, scalar next_cutoff, const Rgb *colors,
                              const Losses *losses, mask *open) {
    const scalar bound = tracer->loss_budget.radiance_bound;
    bool is_any_left = false;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real budget = loss_budget_radiance(&tracer->loss_budget, colors[v]);
        open[v] &= losses->guarded[v] * bound <= budget;
        real further = losses->dropped[v] * (SURFACES_PER_PATH / next_cutoff);
        open[v] &= losses->rays[v] + further <= real_of(RAYS_PER_SAMPLE_MAXIMUM);
        is_any_left = is_any_left || any(open[v]);
    }
    return is_any_left;
}

/** Replaces the results of rays. */
static void results_replace(const mask *lanes, const Rgb *new_colors, const Losses *new_losses,
                            Rgb *colors, Losses *losses) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask m = lanes[v];
        colors[v] = rgb_select(m, new_colors[v], colors[v]);
        losses->dropped[v] = real_select(m, new_losses->dropped[v], losses->dropped[v]);
        losses->guarded[v] = real_select(m, new_losses->guarded[v], losses->guarded[v]);
        losses->rays[v] = real_select(m, new_losses->rays[v], losses->rays[v]);
    }
}

/** Counts the rays that lack too much light, and their largest possible error. */
static void count_unresolved(const Tracer *tracer, const mask *open, const Rgb *colors,
                             const Losses *losses, RayCounts *counts) {
    const Encoding encoding = tracer->loss_budget.is_linear ? ENCODING_LINEAR : ENCODING_SRGB;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real missing = missing_radiance(tracer, losses, v);
        real darkest = real_min(colors[v].red, real_min(colors[v].green, colors[v].blue));
        for (unsigned remaining = mask_bits(open[v]); remaining; remaining &= remaining - 1) {
            int lane = __builtin_ctz(remaining);
            double color = (double)real_lane(darkest, lane);
            double full = color + (double)real_lane(missing, lane);
            double steps = encoding_encode(encoding, full < 1 ? full : 1) -
                           encoding_encode(encoding, color < 1 ? color : 1);
            counts->unresolved++;
            counts->unresolved_steps =
                steps > counts->unresolved_steps ? steps : counts->unresolved_steps;
        }
    }
}

/** Adds an estimate of the light that rays lack: that of what was not ended, in proportion to the
 *  throughput, and at most as much again. */
static void add_missing_light(const mask *open, const Losses *losses, Rgb *colors) {
    const real most = real_of((scalar)0.5f);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real lost = real_min(losses->dropped[v] + losses->guarded[v], most);
        colors[v] = rgb_select(open[v], rgb_scale(colors[v], 1 / (1 - lost)), colors[v]);
    }
}

/* --- passes ----------------------------------------------------------------------------------- */

/**
 * Traces some camera rays of a packet once more.
 * @param lanes  Those.
 * @param[in,out] colors  Replaced in those lanes.
 */
static __attribute__((noinline)) void retrace(const Tracer *tracer, scalar cutoff,
                                              const mask *lanes, RayState *rays, Rgb *colors,
                                              Losses *losses, RayCounts *counts) {
    Rgb new_colors[PACKET_VECTORS];
    Losses new_losses;
    memcpy(rays->packet.active, lanes, sizeof rays->packet.active);
    trace_pass(tracer, cutoff, rays, new_colors, &new_losses, counts);
    results_replace(lanes, new_colors, &new_losses, colors, losses);
}

/** Traces camera rays again until all are within the budget, or cannot be.
 *  @param first_counts The rays before the first pass. */
static __attribute__((noinline)) void retrace_open_rays(const Tracer *tracer,
                                                        const RayCounts *first_counts,
                                                        RayState *rays, Rgb *colors, Losses *losses,
                                                        RayCounts *counts) {
    mask active[PACKET_VECTORS], open[PACKET_VECTORS], curable[PACKET_VECTORS];
    scalar cutoff = tracer->loss_budget.throughput;
    memcpy(active, rays->packet.active, sizeof active);
    while (find_open_rays(tracer, rays, colors, losses, open)) {
        memcpy(curable, open, sizeof curable);
        if (tracer->loss_budget.cutoff <= 0 ||
            !find_curable_rays(tracer, cutoff / PASS_FACTOR, colors, losses, curable)) {
            break;
        }
        if (sample_context_ray_tree(&rays->packet.context)) {
            *counts = *first_counts;
        }
        cutoff /= PASS_FACTOR;
        retrace(tracer, cutoff, curable, rays, colors, losses, counts);
        memcpy(rays->packet.active, active, sizeof active);
    }
    count_unresolved(tracer, open, colors, losses, counts);
    add_missing_light(open, losses, colors);
}

void trace_camera_rays(const Tracer *tracer, RayState *rays, Rgb *colors, RayCounts *counts) {
    const RayCounts first_counts = *counts;
    Losses losses;
    trace_pass(tracer, tracer->loss_budget.throughput, rays, colors, &losses, counts);
    // The reports have rules of their own for where rays end.
    if (!tracer->methods && losses_are_any(rays, &losses)) {
        retrace_open_rays(tracer, &first_counts, rays, colors, &losses, counts);
    }
}
