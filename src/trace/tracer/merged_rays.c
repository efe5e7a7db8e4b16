/**
 * @file
 * @brief Merged rays.
 */
#include "trace/tracer/merged_rays.h"

/** How far apart the starts of merged rays may be along each axis, in pixels as seen at the first
 *  hit; and how much their directions may differ, in pixels. */
#define MERGE_PIXELS 0.25

/** Most rays that are traced below a camera ray, merged ones counted once. */
enum { MERGED_RAYS_MAXIMUM = 4 * RAYS_PER_SAMPLE_MAXIMUM };

/** Rays of less throughput end, in throughputs at which the first pass ends rays. Light between
 *  twelve panes lacks a tenth of the budget then (measured). */
#define MERGED_CUTOFF_FACTOR ((scalar)(1.0 / 512))

/** Each time that a quarter of #MERGED_RAYS_MAXIMUM is used up, rays end at so many times the
 *  throughput: what is traced of a tree that is too large is its heaviest rays. */
#define MERGED_CUTOFF_GROWTH ((scalar)8)

/** After so many rays of little throughput it is known whether merging helps. */
enum { MERGE_TRIAL_RAYS = 512 };
/** Where one of so many of them was merged, it does. Between panes that are turned against each
 *  other it is one in ten, between spheres none in 10,000 (measured). */
enum { MERGE_TRIAL_SHARE = 32 };

/** Rays that are being merged. */
typedef struct Merging {
    const MergeMemory *memory;       /**< The rays. */
    MergeLimits limits;              /**< Which rays are merged. */
    MergeCounts merge_counts;        /**< How many were. */
    SampleContext context;           /**< Of the rays of a level. */
    uint32_t pixel_ids[PACKET_RAYS]; /**< See #SampleContext: that of the pixel, for each ray. */
    unsigned traced_count;           /**< Number of rays that were traced. */
    wide_scalar color[3];            /**< See #MergedLight. */
    wide_scalar dropped[3];          /**< See #MergedLight. */
    wide_scalar guarded[3];          /**< See #MergedLight. */
} Merging;

/** Makes the next level the current one, and merges its rays: first the reflected ones. */
static void level_merge(Merging *merging) {
    const MergeMemory *memory = merging->memory;
    merge_begin_level(memory->table, memory->level);
    for (int child = 0; child < CHILD_COUNT; child++) {
        ray_queue_merge(memory->table, &merging->limits, &memory->next[child], memory->level,
                        &merging->merge_counts);
    }
    ray_queues_clear(memory->next);
}

/** Adds a lane of colours to sums. */
static void sums_add(wide_scalar *sums, const Rgb *color, int lane) {
    sums[0] += (wide_scalar)real_lane(color->red, lane);
    sums[1] += (wide_scalar)real_lane(color->green, lane);
    sums[2] += (wide_scalar)real_lane(color->blue, lane);
}

/** Adds what the rays of a packet saw, ray by ray. @param count Number of rays. @param losses What
 *  ended at their surfaces; NULL: nothing. */
static void packet_add_light(Merging *merging, const GatheredPacket *gathered, unsigned count,
                             const Rgb *colors, const Losses *losses) {
    for (unsigned i = 0; i < count; i++) {
        int v = (int)i / LANES, lane = (int)i % LANES;
        Rgb light = rgb_multiply(gathered->rays.throughput[v], colors[v]);
        sums_add(merging->color, &light, lane);
        if (losses) {
            sums_add(merging->dropped, &losses->dropped[v], lane);
            sums_add(merging->guarded, &losses->guarded[v], lane);
        }
    }
}

/** @return A vector of rays for the queue: merged rays have no nodes. */
INLINE RayVector merging_vector(const RayState *rays, int v) {
    const Rgb no_weight = {real_of(0), real_of(0), real_of(0)};
    return ray_vector_of(rays, v, no_weight, integer_of(0), integer_of(0));
}

/** Queues the rays of a kind that start at the surfaces of a packet. @return Their number. */
static unsigned merging_queue(const Merging *merging, Child child, const RayState *rays) {
    RayQueue *next = &merging->memory->next[child];
    unsigned before = next->count;
    for (int v = 0; v < packet_vector_count(&rays->packet); v++) {
        unsigned lanes = mask_bits(rays->packet.active[v]);
        if (lanes) {
            RayVector vector = merging_vector(rays, v);
            ray_queue_add(next, lanes, &vector, merging->limits.interior_count);
        }
    }
    return next->count - before;
}

/** Traces some rays of the current level. @param first Index of the first. @param count Their
 *  number, at most #PACKET_RAYS. */
static __attribute__((noinline)) void merging_trace_packet(Merging *merging,
                                                           const TraceContext *context,
                                                           unsigned first, unsigned count) {
    GatheredPacket gathered;
    ScatteredRays scattered;
    Rgb colors[PACKET_VECTORS];
    Losses losses;
    packet_gather(merging->memory->level->columns, merging->limits.interior_count,
                  RAY_COLUMN_FIRST + first, count, &gathered);
    gathered.rays.packet.context = merging->context;
    bool is_scattered = shade_and_scatter(context, &gathered.rays, &scattered, colors, &losses);
    packet_add_light(merging, &gathered, count, colors, is_scattered ? &losses : NULL);
    if (is_scattered) {
        context->counts->reflection +=
            merging_queue(merging, CHILD_REFLECTED, &scattered.reflected.rays);
        context->counts->refraction +=
            merging_queue(merging, CHILD_REFRACTED, &scattered.refracted.rays);
    }
}

/** Traces the rays of the current level. */
static void merging_trace_level(Merging *merging, const TraceContext *context) {
    unsigned count = merging->memory->level->count;
    for (unsigned done = 0; done < count; done += PACKET_RAYS) {
        unsigned left = count - done;
        merging_trace_packet(merging, context, done, left < PACKET_RAYS ? left : PACKET_RAYS);
    }
    merging->traced_count += count;
}

/** Sets how near rays must be to be merged. The first rays below the camera ray start at its hit.
 */
static void merging_set_sizes(Merging *merging, const Camera *camera) {
    const RayQueue *next = merging->memory->next;
    const RayColumns *columns = next[next[CHILD_REFLECTED].count == 0].columns,
                     *camera_columns = merging->memory->level->columns;
    double square = 0;
    if (ray_queues_count(next) == 0) {
        return;
    }
    for (int axis = 0; axis < 3; axis++) {
        double way = (double)columns->numbers[RAY_COLUMN_ORIGIN][axis][RAY_COLUMN_FIRST] -
                     (double)camera_columns->numbers[RAY_COLUMN_ORIGIN][axis][RAY_COLUMN_FIRST];
        square += way * way;
    }
    double half_pixel = (double)real_lane(real_sqrt(vec3_dot(camera->up, camera->up)), 0);
    merging->limits.direction_size = 2 * half_pixel * MERGE_PIXELS;
    merging->limits.start_size = merging->limits.direction_size * sqrt(square);
}

/** Makes a camera ray the only ray of the current level. */
static void merging_begin(Merging *merging, const RayState *camera_rays, int index) {
    const SampleContext *context = &camera_rays->packet.context;
    RayQueue *level = merging->memory->level;
    RayVector vector = merging_vector(camera_rays, index / LANES);
    level->count = 0;
    ray_queue_add(level, 1u << index % LANES, &vector, merging->limits.interior_count);
    ray_queues_clear(merging->memory->next);
    merging->context = *context;
    merging->context.recorders = NULL;
    if (context->pixel_ids) {
        for (int i = 0; i < PACKET_RAYS; i++) {
            merging->pixel_ids[i] = context->pixel_ids[index];
        }
        merging->context.pixel_ids = merging->pixel_ids;
    }
}

/** @return Whether the rays of the current level may be traced, and those that start there find
 *          room. */
static bool merging_has_room(const Merging *merging) {
    unsigned count = merging->memory->level->count;
    return CHILD_COUNT * count <= RAY_COLUMN_CAPACITY &&
           merging->traced_count + count <= MERGED_RAYS_MAXIMUM;
}

/** @return Whether enough rays coincide, as far as is known. */
static bool merging_is_promising(const Merging *merging) {
    return merging->merge_counts.light < MERGE_TRIAL_RAYS ||
           merging->merge_counts.merged >= merging->merge_counts.light / MERGE_TRIAL_SHARE;
}

/** Counts the rays of the current level as dropped. */
static void merging_drop_level(Merging *merging) {
    const RayQueue *level = merging->memory->level;
    for (unsigned i = 0; i < level->count; i++) {
        for (int channel = 0; channel < 3; channel++) {
            merging->dropped[channel] +=
                (wide_scalar)
                    level->columns->numbers[RAY_COLUMN_THROUGHPUT][channel][RAY_COLUMN_FIRST + i];
        }
    }
}

/** @return At which throughput rays end, in those at which the first pass ends them. @param
 *  traced_count Number of rays so far. */
static scalar merged_cutoff(unsigned traced_count) {
    scalar cutoff = MERGED_CUTOFF_FACTOR;
    for (unsigned used = traced_count; used >= MERGED_RAYS_MAXIMUM / 4;
         used -= MERGED_RAYS_MAXIMUM / 4) {
        cutoff *= MERGED_CUTOFF_GROWTH;
    }
    return cutoff;
}

bool trace_merged_rays(const Tracer *tracer, const MergeMemory *memory, const RayState *camera_rays,
                       int index, RayCounts *counts, MergedLight *light) {
    const scalar first_cutoff = tracer->loss_budget.throughput;
    TraceContext context = {.tracer = tracer, .counts = counts};
    Merging merging = {
        .memory = memory,
        .limits = {.interior_count = ray_columns_interior_count(&tracer->dielectrics),
                   .light_throughput = tracer->loss_budget.merged}};
    merging_begin(&merging, camera_rays, index);
    while (memory->level->count > 0 && merging_has_room(&merging)) {
        context.cutoff = first_cutoff * merged_cutoff(merging.traced_count);
        merging_trace_level(&merging, &context);
        if (merging.context.bounce++ == 0) {
            merging_set_sizes(&merging, &tracer->camera);
        }
        level_merge(&merging);
        if (!merging_is_promising(&merging)) {
            return false;
        }
    }
    merging_drop_level(&merging);
    for (int channel = 0; channel < 3; channel++) {
        light->color[channel] = (scalar)merging.color[channel];
        light->dropped[channel] = (scalar)merging.dropped[channel];
        light->guarded[channel] = (scalar)merging.guarded[channel];
    }
    return true;
}
