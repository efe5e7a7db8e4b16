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
        recorders->ray_tree->count = recorders->ray_tree->step_count = 0;
        recorders->ray_tree->is_truncated = false;
        recorders->ray_tree->merged_light = (Rgbd){0, 0, 0};
        ray_tree_push(recorders->ray_tree, RAY_CAMERA, rays, one);
    }
}

/** Traces the active rays of a packet once. @param cutoff Rays of less throughput end. @return
 *  Whether the losses are set; otherwise there are none. */
static bool trace_pass(const Tracer *tracer, scalar cutoff, const RayState *rays, Rgb *colors,
                       Losses *losses, RayCounts *counts) {
    const TraceContext context = {.tracer = tracer, .counts = counts, .cutoff = cutoff};
    RayTree *ray_tree = sample_context_ray_tree(&rays->packet.context);
    if (rays->packet.context.recorders) {
        recorders_begin(rays);
    }
    bool may_lose = tracer->methods ? report_trace_camera_packet(&context, rays, colors, losses)
                                    : trace_packet(&context, rays, colors, losses);
    if (ray_tree) {
        ray_tree_pop(ray_tree, colors[0]);
    }
    return may_lose;
}

/* --- losses ----------------------------------------------------------------------------------- */

/** @return The sum of the throughputs that were ended. @param v Which vector of rays. */
INLINE Rgb lost_throughput(const Losses *losses, int v) {
    return rgb_add(losses->dropped[v], losses->guarded[v]);
}

/** Finds the rays that may lack more light than the budget. @param[out] open Those.
 *  @return Whether there is any. */
static bool find_open_rays(const Tracer *tracer, const RayState *rays, const Rgb *colors,
                           const Losses *losses, mask *open) {
    bool is_any_open = false;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        open[v] = rays->packet.active[v] &
                  loss_budget_exceeded(&tracer->loss_budget, lost_throughput(losses, v), colors[v]);
        is_any_open = is_any_open || any(open[v]);
    }
    return is_any_open;
}

/** @return Whether any active ray lacks anything: seldom, where nothing is reflected. */
static bool losses_are_any(const RayState *rays, const Losses *losses) {
    mask lost = mask_of(false);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        lost |= rays->packet.active[v] & (rgb_max(lost_throughput(losses, v)) > 0);
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
    bool is_any_left = false;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        open[v] &=
            mask_not(loss_budget_exceeded(&tracer->loss_budget, losses->guarded[v], colors[v]));
        real further = rgb_max(losses->dropped[v]) * (SURFACES_PER_PATH / next_cutoff);
        open[v] &= losses->rays[v] + further <= real_of(RAYS_PER_SAMPLE_MAXIMUM);
        is_any_left = is_any_left || any(open[v]);
    }
    return is_any_left;
}

/** @return The largest error of a channel of a ray, 8-bit steps. @param lost Throughput ended. */
static double missing_steps(const Tracer *tracer, real lost, real color, int lane) {
    const LossBudget *budget = &tracer->loss_budget;
    const Encoding encoding = budget->is_linear ? ENCODING_LINEAR : ENCODING_SRGB;
    double has = (double)real_lane(color, lane);
    double full = has + (double)real_lane(lost, lane) * (double)budget->radiance_bound;
    return encoding_encode(encoding, fmin(full, 1)) - encoding_encode(encoding, fmin(has, 1));
}

/** Counts the rays that lack too much light, and their largest possible error. */
static void count_unresolved(const Tracer *tracer, const mask *open, const Rgb *colors,
                             const Losses *losses, RayCounts *counts) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Rgb lost = lost_throughput(losses, v);
        for (unsigned remaining = mask_bits(open[v]); remaining; remaining &= remaining - 1) {
            int lane = __builtin_ctz(remaining);
            double steps = fmax(missing_steps(tracer, lost.red, colors[v].red, lane),
                                fmax(missing_steps(tracer, lost.green, colors[v].green, lane),
                                     missing_steps(tracer, lost.blue, colors[v].blue, lane)));
            counts->unresolved++;
            counts->unresolved_steps =
                steps > counts->unresolved_steps ? steps : counts->unresolved_steps;
        }
    }
}

/** @return A channel with an estimate of the light that it lacks: that of what was not ended, in
 *          proportion to the throughput, and at most as much again. */
INLINE real with_missing_light(real color, real lost) {
    return color / (1 - real_min(lost, real_of((scalar)0.5f)));
}

/** Adds an estimate of the light that rays lack. @param open Those rays. */
static void add_missing_light(const mask *open, const Losses *losses, Rgb *colors) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Rgb lost = lost_throughput(losses, v);
        Rgb full = {with_missing_light(colors[v].red, lost.red),
                    with_missing_light(colors[v].green, lost.green),
                    with_missing_light(colors[v].blue, lost.blue)};
        colors[v] = rgb_select(open[v], full, colors[v]);
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
    if (!trace_pass(tracer, cutoff, rays, new_colors, &new_losses, counts)) {
        losses_clear(&new_losses, PACKET_VECTORS);
    }
    results_replace(lanes, new_colors, &new_losses, colors, losses);
}

/** Replaces the colour and losses of a ray by those of merged rays, if less is lost there. */
static void merged_light_use(const MergedLight *light, int index, Rgb *colors, Losses *losses) {
    const int v = index / LANES, lane = index % LANES;
    real *const color[3] = {&colors[v].red, &colors[v].green, &colors[v].blue};
    Rgb *dropped = &losses->dropped[v], *guarded = &losses->guarded[v];
    real *const dropped_channels[3] = {&dropped->red, &dropped->green, &dropped->blue},
                *const guarded_channels[3] = {&guarded->red, &guarded->green, &guarded->blue};
    scalar before = real_lane(rgb_max(lost_throughput(losses, v)), lane), after = 0;
    for (int i = 0; i < 3; i++) {
        scalar lost = light->dropped[i] + light->guarded[i];
        after = lost > after ? lost : after;
    }
    for (int i = 0; i < 3 && after < before; i++) {
        real_set_lane(color[i], lane, light->color[i]);
        real_set_lane(dropped_channels[i], lane, light->dropped[i]);
        real_set_lane(guarded_channels[i], lane, light->guarded[i]);
    }
}

/** Traces rays once more, one by one, with merged rays below. @param open Those that lack too much
 *  light. */
static __attribute__((noinline)) void merge_open_rays(const Tracer *tracer, Wavefront *wavefront,
                                                      const RayState *rays, const mask *open,
                                                      Rgb *colors, Losses *losses,
                                                      RayCounts *counts) {
    const MergeMemory memory = wavefront_merge_memory(wavefront);
    for (int i = 0; i < PACKET_RAYS; i++) {
        MergedLight light;
        if (mask_lane(open[i / LANES], i % LANES) &&
            trace_merged_rays(tracer, &memory, rays, i, counts, &light)) {
            merged_light_use(&light, i, colors, losses);
        }
    }
}

/** Finds the light that rays still lack by merged rays, or estimates and counts it. @param
 *  wavefront Memory; NULL: rays are not merged. */
static __attribute__((noinline)) void settle_losses(const Tracer *tracer, Wavefront *wavefront,
                                                    const RayState *rays, Losses *losses,
                                                    Rgb *colors, RayCounts *counts) {
    mask open[PACKET_VECTORS];
    bool is_any_open = find_open_rays(tracer, rays, colors, losses, open);
    if (is_any_open && wavefront && tracer->loss_budget.cutoff > 0) {
        merge_open_rays(tracer, wavefront, rays, open, colors, losses, counts);
        is_any_open = find_open_rays(tracer, rays, colors, losses, open);
    }
    if (is_any_open) {
        count_unresolved(tracer, open, colors, losses, counts);
        add_missing_light(open, losses, colors);
    }
}

/** Calls settle_losses() with memory from the tracer's pool. */
static void settle_pooled_losses(const Tracer *tracer, const RayState *rays, Losses *losses,
                                 Rgb *colors, RayCounts *counts) {
    Wavefront *wavefront = tracer->wavefronts ? wavefront_pool_take(tracer->wavefronts) : NULL;
    settle_losses(tracer, wavefront, rays, losses, colors, counts);
    if (wavefront) {
        wavefront_pool_give_back(tracer->wavefronts, wavefront);
    }
}

/** Settles the losses of a packet. A ray tree shows the rays of the last pass: merged rays are not
 *  recorded, only their light; nor do they count, as the counts are those of the tree. */
static void settle_packet_losses(const Tracer *tracer, const RayState *rays, Losses *losses,
                                 Rgb *colors, RayCounts *counts) {
    RayTree *ray_tree = sample_context_ray_tree(&rays->packet.context);
    if (!ray_tree) {
        settle_pooled_losses(tracer, rays, losses, colors, counts);
        return;
    }
    RayState unrecorded = *rays;
    RayCounts merged = {0};
    unrecorded.packet.context.recorders = NULL;
    settle_pooled_losses(tracer, &unrecorded, losses, colors, &merged);
    counts->unresolved += merged.unresolved;
    counts->unresolved_steps = fmax(counts->unresolved_steps, merged.unresolved_steps);
    ray_tree_set_pixel(ray_tree, colors[0]);
}

/**
 * Traces camera rays again until all are within the budget, or cannot be.
 * @param cutoff  At which throughput rays ended so far.
 * @param first_counts  The rays before the first pass, for a ray tree: only those of the last pass
 *                      count. NULL: those of all passes do.
 */
static __attribute__((noinline)) void retrace_open_rays(const Tracer *tracer, scalar cutoff,
                                                        const RayCounts *first_counts,
                                                        RayState *rays, Rgb *colors, Losses *losses,
                                                        RayCounts *counts) {
    mask active[PACKET_VECTORS], curable[PACKET_VECTORS];
    memcpy(active, rays->packet.active, sizeof active);
    while (tracer->loss_budget.cutoff > 0 &&
           find_open_rays(tracer, rays, colors, losses, curable) &&
           find_curable_rays(tracer, cutoff / PASS_FACTOR, colors, losses, curable)) {
        if (first_counts) {
            *counts = *first_counts;
        }
        cutoff /= PASS_FACTOR;
        retrace(tracer, cutoff, curable, rays, colors, losses, counts);
        memcpy(rays->packet.active, active, sizeof active);
    }
}

/** Traces camera rays in as many passes as it takes. @param first_counts See retrace_open_rays().
 */
INLINE void camera_rays_trace(const Tracer *tracer, const RayCounts *first_counts, RayState *rays,
                              Rgb *colors, RayCounts *counts) {
    Losses losses;
    bool may_lose =
        trace_pass(tracer, tracer->loss_budget.throughput, rays, colors, &losses, counts);
    // The reports have rules of their own for where rays end.
    if (may_lose && !tracer->methods && losses_are_any(rays, &losses)) {
        retrace_open_rays(tracer, tracer->loss_budget.throughput, first_counts, rays, colors,
                          &losses, counts);
        settle_packet_losses(tracer, rays, &losses, colors, counts);
    }
}

void trace_camera_rays(const Tracer *tracer, RayState *rays, Rgb *colors, RayCounts *counts) {
    if (sample_context_ray_tree(&rays->packet.context)) {
        const RayCounts first_counts = *counts;
        camera_rays_trace(tracer, &first_counts, rays, colors, counts);
    } else {
        camera_rays_trace(tracer, NULL, rays, colors, counts);
    }
}

/* --- passes of wavefronts --------------------------------------------------------------------- */

/** Some packets of camera rays that are traced as one wavefront. */
typedef struct CameraGroup {
    const Tracer *tracer;  /**< The tracer. */
    Wavefront *wavefront;  /**< Memory for the rays. */
    CameraPacket *packets; /**< The packets. */
    int count;             /**< Number of packets. */
    RayCounts *counts;     /**< The rays traced are added to this. */
} CameraGroup;

static void camera_group_trace(const CameraGroup *group, scalar cutoff);

/** @return The number of rays of a group that are traced. */
static unsigned camera_group_count(const CameraGroup *group) {
    unsigned count = 0;
    for (int p = 0; p < group->count; p++) {
        count += camera_packet_count(&group->packets[p]);
    }
    return count;
}

/** Removes rays of a packet. @param first Index of the first to keep, among the
 * #CameraPacket.lanes.
 *  @param count Number of those to keep. */
static void camera_packet_keep(CameraPacket *packet, unsigned first, unsigned count) {
    unsigned index = 0;
    for (int i = 0; i < PACKET_RAYS; i++) {
        if (mask_lane(packet->lanes[i / LANES], i % LANES)) {
            mask_set_lane(&packet->lanes[i / LANES], i % LANES,
                          index >= first && index - first < count);
            index++;
        }
    }
}

/** Traces the camera rays of a packet recursively. @param cutoff Of the first pass. */
static void camera_packet_trace_recursively(const CameraGroup *group, scalar cutoff,
                                            CameraPacket *packet) {
    Rgb colors[PACKET_VECTORS];
    Losses losses;
    RayState *rays = packet->rays;
    mask active[PACKET_VECTORS];
    memcpy(active, rays->packet.active, sizeof active);
    memcpy(rays->packet.active, packet->lanes, sizeof active);
    if (!trace_pass(group->tracer, cutoff, rays, colors, &losses, group->counts)) {
        losses_clear(&losses, PACKET_VECTORS);
    }
    retrace_open_rays(group->tracer, cutoff, NULL, rays, colors, &losses, group->counts);
    results_replace(packet->lanes, colors, &losses, packet->colors, &packet->losses);
    memcpy(rays->packet.active, active, sizeof active);
}

/** Traces camera rays in two smaller groups, as the memory does not suffice for all. */
static __attribute__((noinline)) void camera_group_split(const CameraGroup *group, scalar cutoff) {
    CameraGroup half = *group;
    unsigned rays = camera_packet_count(&group->packets[0]);
    if (group->count > 1) {
        half.count = group->count / 2;
        camera_group_trace(&half, cutoff);
        half.packets += half.count;
        half.count = group->count - half.count;
        camera_group_trace(&half, cutoff);
    } else if (rays > 1) {
        CameraPacket *packet = group->packets, other = *packet;
        camera_packet_keep(packet, 0, rays / 2);
        camera_group_trace(group, cutoff);
        memcpy(packet->lanes, other.lanes, sizeof packet->lanes);
        camera_packet_keep(packet, rays / 2, rays - rays / 2);
        camera_group_trace(group, cutoff);
    } else if (rays == 1) {
        camera_packet_trace_recursively(group, cutoff, group->packets);
    }
}

/** Finds the camera rays that lack too much light, if a further pass can help: they are left in
 *  #CameraPacket.lanes. @return Whether there is any. */
static bool camera_group_find_curable(const CameraGroup *group, scalar next_cutoff) {
    bool is_any_left = false;
    for (int p = 0; p < group->count; p++) {
        CameraPacket *packet = &group->packets[p];
        mask open[PACKET_VECTORS] = {0};
        if (losses_are_any(packet->rays, &packet->losses)) {
            find_open_rays(group->tracer, packet->rays, packet->colors, &packet->losses, open);
        }
        for (int v = 0; v < PACKET_VECTORS; v++) {
            packet->lanes[v] &= open[v];
        }
        is_any_left |= find_curable_rays(group->tracer, next_cutoff, packet->colors,
                                         &packet->losses, packet->lanes);
    }
    return is_any_left;
}

/** Traces the camera rays of a group in as many passes as it takes. @param cutoff Of the first. */
static void camera_group_trace(const CameraGroup *group, scalar cutoff) {
    TraceContext context = {.tracer = group->tracer, .counts = group->counts};
    bool has_passes = group->tracer->loss_budget.cutoff > 0;
    bool is_any_left = true;
    unsigned rays = camera_group_count(group);
    if (rays > 1 && rays > wavefront_sample_limit(group->wavefront)) {
        camera_group_split(group, cutoff);
        return;
    }
    while (is_any_left) {
        scalar next = has_passes ? cutoff / PASS_FACTOR : cutoff;
        context.cutoff = cutoff;
        if (!wavefront_trace(group->wavefront, &context, next, group->packets, group->count)) {
            camera_group_split(group, cutoff);
            return;
        }
        if (!has_passes || !camera_group_find_curable(group, next)) {
            return;
        }
        context.cutoff = next;
        if (!wavefront_resume(group->wavefront, &context, group->packets, group->count)) {
            camera_group_split(group, next);
            return;
        }
        cutoff = next / PASS_FACTOR;
        is_any_left = camera_group_find_curable(group, cutoff);
    }
}

void trace_camera_packets(const Tracer *tracer, Wavefront *wavefront, CameraPacket *packets,
                          int count, RayCounts *counts) {
    const CameraGroup group = {tracer, wavefront, packets, count, counts};
    for (int p = 0; p < count; p++) {
        memcpy(packets[p].lanes, packets[p].rays->packet.active, sizeof packets[p].lanes);
    }
    camera_group_trace(&group, tracer->loss_budget.throughput);
    for (int p = 0; p < count; p++) {
        settle_losses(tracer, wavefront, packets[p].rays, &packets[p].losses, packets[p].colors,
                      counts);
    }
}
