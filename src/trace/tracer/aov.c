/**
 * @file
 * @brief Recording of arbitrary output variables (AOVs).
 */
#include "trace/tracer/aov.h"

#include "trace/tracer/retrace.h"
#include "trace/tracer/tile.h"

#include <string.h>

/** @return The index of the shape, or -1; visible lights are not shapes. */
static int hit_shape_or_none(const Hit *hit, int lane) {
    int shape = integer_lane(hit->shape, lane);
    return shape >= 0 ? shape : -1;
}

/** Records the hits of camera rays. */
static void aov_record_hits(const Packet *packet, const Hit *hits, AovSample *samples) {
    for (int i = 0; i < PACKET_RAYS; i++) {
        const Hit *hit = &hits[i / LANES];
        int lane = i % LANES;
        if (!mask_lane(packet->active[i / LANES], lane)) {
            continue;
        }
        bool is_hit = hit_shape_or_none(hit, lane) >= 0;
        samples[i].shape = is_hit ? hit_shape_or_none(hit, lane) : -1;
        samples[i].distance = (double)real_lane(hit->distance, lane);
        samples[i].normal[0] = is_hit ? (double)real_lane(hit->normal.x, lane) : 0;
        samples[i].normal[1] = is_hit ? (double)real_lane(hit->normal.y, lane) : 0;
        samples[i].normal[2] = is_hit ? (double)real_lane(hit->normal.z, lane) : 0;
    }
}

/** Records texture coordinates of a vector. */
static void aov_record_uv(const TextureUv *uv, mask lanes, AovSample *samples) {
    for (unsigned remaining = mask_bits(lanes); remaining; remaining &= remaining - 1) {
        int lane = __builtin_ctz(remaining);
        samples[lane].uv[0] = (double)real_lane(uv->u, lane);
        samples[lane].uv[1] = (double)real_lane(uv->v, lane);
    }
}

/** Records the texture coordinates of camera rays. */
static void aov_record_uvs(const ShapeSet *shapes, const Packet *packet, const Hit *hits,
                           AovSample *samples) {
    for (int v = 0; v < packet_vector_count(packet); v++) {
        mask remaining = packet->active[v] & (hits[v].shape >= integer_of(0));
        while (any(remaining)) {
            int shape = integer_lane(hits[v].shape, mask_first(remaining));
            mask same = remaining & (hits[v].shape == integer_of(shape));
            TextureUv uv = shape_texture_uv(shapes->shapes[shape], &hits[v], same);
            aov_record_uv(&uv, same, samples + v * LANES);
            remaining &= mask_not(same);
        }
    }
}

/** Records the hit of a secondary ray. @param shape The shape, or -1. */
static void aov_record_secondary(int shape, AovSample *sample) {
    if (sample->secondary_count < AOV_MAX_SECONDARY) {
        sample->secondary_shapes[sample->secondary_count++] = shape;
    }
}

void aov_record_surfaces(const SurfaceHit *surface) {
    const SampleContext *context = &surface->packet->context;
    if (context->bounce == 0) {
        aov_record_hits(surface->packet, surface->hits, context->recorders->aovs);
    }
    for (int i = 0; i < PACKET_RAYS; i++) {
        if (mask_lane(surface->packet->active[i / LANES], i % LANES)) {
            context->recorders->aovs[i].ray_count++;
            if (context->bounce == 1) {
                aov_record_secondary(hit_shape_or_none(&surface->hits[i / LANES], i % LANES),
                                     &context->recorders->aovs[i]);
            }
        }
    }
}

void aov_record_shadows(const SurfaceHit *surface, size_t light_index, const Packet *shadow,
                        const mask *occluded) {
    const SampleContext *context = &surface->packet->context;
    bool is_recorded = context->bounce == 0 && light_index < AOV_MAX_LIGHTS;
    uint64_t bit = is_recorded ? UINT64_C(1) << light_index : 0;
    for (int i = 0; i < PACKET_RAYS; i++) {
        if (mask_lane(shadow->active[i / LANES], i % LANES)) {
            AovSample *sample = &context->recorders->aovs[i];
            sample->ray_count++;
            sample->lights_tested |= bit;
            sample->lights_occluded |= mask_lane(occluded[i / LANES], i % LANES) ? bit : 0;
        }
    }
}

/* --- sphere tracing steps --------------------------------------------------------------------- */

/** The sphere tracing steps of a packet up to its hits. */
typedef struct StepCount {
    const Hit *hits;            /**< The hits. */
    real steps[PACKET_VECTORS]; /**< The steps so far. */
} StepCount;

/** @return How far rays step in a shape. The one that is hit takes all its steps, even if rounding
 *          has put the limit before its surface. */
INLINE real steps_limit(const Shape *shape, const Hit *hit) {
    mask is_hit = hit->shape == integer_of(shape->index);
    return real_select(is_hit, real_of(INFINITE), hit->distance);
}

/** @return A packet whose rays end at their hits. */
static Packet packet_up_to_hits(const Packet *packet, const Hit *hits) {
    Packet limited = *packet;
    for (int v = 0; v < packet_vector_count(packet); v++) {
        limited.limit[v] = hits[v].distance;
    }
    return limited;
}

/** Adds the steps that a shape takes. See #ShapeVisitor. */
static void shape_count_steps(const Shape *shape, const Packet *packet, int v, mask active,
                              void *found) {
    StepCount *step_count = found;
    if (!shape_has_steps(shape)) {
        return;
    }
    real steps = shape->class->extension->count_steps(
        shape, &packet->rays[v], active, steps_limit(shape, &step_count->hits[v]), NULL);
    step_count->steps[v] += real_select(active, steps, real_of(0));
}

/** Records the steps of camera rays up to their hits. */
static void aov_record_steps(const ShapeSet *shapes, const Packet *packet, const Hit *hits,
                             AovSample *samples) {
    const Packet limited = packet_up_to_hits(packet, hits);
    StepCount step_count = {.hits = hits};
    for (int v = 0; v < PACKET_VECTORS; v++) {
        step_count.steps[v] = real_of(0);
    }
    shape_set_visit(shapes, &limited, shape_count_steps, &step_count);
    for (int i = 0; i < PACKET_RAYS; i++) {
        samples[i].step_count = (uint32_t)real_lane(step_count.steps[i / LANES], i % LANES);
    }
}

/* --- operations on distances ------------------------------------------------------------------ */

/** The operations of a packet up to its hits. */
typedef struct OperationCount {
    const Hit *hits;    /**< The hits. */
    AovSample *samples; /**< Per ray: gets them. */
} OperationCount;

/** Adds the operations of a shape, ray by ray: what other rays need does not count. See
 *  #ShapeVisitor. */
static void shape_count_operations(const Shape *shape, const Packet *packet, int v, mask active,
                                   void *found) {
    OperationCount *count = found;
    if (!shape_has_steps(shape)) {
        return;
    }
    const Ray *rays = &packet->rays[v];
    real limit = steps_limit(shape, &count->hits[v]);
    for (unsigned bits = mask_bits(active); bits; bits &= bits - 1) {
        int i = __builtin_ctz(bits);
        const Ray ray = {vec3_splat_lane(&rays->origin, i), vec3_splat_lane(&rays->direction, i),
                         vec3_splat_lane(&rays->inverse_direction, i)};
        MarchLog log = {0};
        shape->class->extension->count_steps(shape, &ray, mask_of_bits(1),
                                             real_of(real_lane(limit, i)), &log);
        count->samples[v * LANES + i].operation_count += log.operations;
    }
}

/** Records the operations on distances of camera rays up to their hits. */
static void aov_record_operations(const ShapeSet *shapes, const Packet *packet, const Hit *hits,
                                  AovSample *samples) {
    const Packet limited = packet_up_to_hits(packet, hits);
    OperationCount count = {hits, samples};
    shape_set_visit(shapes, &limited, shape_count_operations, &count);
}

/* --- grids ------------------------------------------------------------------------------------ */

/** Records a packet of camera rays, without secondary rays. */
static void aov_trace_packet(const Tracer *tracer, const Packet *packet, unsigned flags,
                             AovSample *samples) {
    Hit hits[PACKET_VECTORS];
    shape_set_closest_hits(&tracer->shapes, packet, hits);
    if (tracer->emitters.count > 0) {
        emitters_closest_hits(&tracer->emitters, packet, hits);
    }
    aov_record_hits(packet, hits, samples);
    if (flags & AOV_UV) {
        aov_record_uvs(&tracer->shapes, packet, hits, samples);
    }
    if (flags & AOV_STEPS) {
        aov_record_steps(&tracer->shapes, packet, hits, samples);
    }
    if (flags & AOV_OPERATIONS) {
        aov_record_operations(&tracer->shapes, packet, hits, samples);
    }
}

/** Adds the colours of a packet to its samples. */
static void aov_samples_set_colors(const Rgb *colors, AovSample *samples) {
    for (int i = 0; i < PACKET_RAYS; i++) {
        samples[i].color[0] = (double)real_lane(colors[i / LANES].red, i % LANES);
        samples[i].color[1] = (double)real_lane(colors[i / LANES].green, i % LANES);
        samples[i].color[2] = (double)real_lane(colors[i / LANES].blue, i % LANES);
    }
}

/** Copies the samples of a packet to those of its grid. */
static void aov_samples_write(const AovSample *packet_samples, const PixelGrid *grid, int index,
                              AovSample *samples) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        OutputRange range = output_range(grid, index, v);
        memcpy(samples + range.first, packet_samples + v * LANES,
               (size_t)range.count * sizeof *samples);
    }
}

void aov_trace(const Tracer *tracer, const PixelGrid *grid, unsigned flags, AovSample *samples,
               RayCounts *counts) {
    const PixelJitter jitter = pixel_jitter_of(grid->sample);
    int packet_count = grid_packet_count(grid);
    for (int index = 0; index < packet_count; index++) {
        AovSample packet_samples[PACKET_RAYS] = {0};
        const Recorders recorders = {.aovs = packet_samples};
        CameraRays rays;
        camera_rays_init(tracer, grid, jitter, index, NULL, &recorders, &rays);
        if (flags & AOV_RADIANCE) {
            Rgb colors[PACKET_VECTORS];
            trace_camera_rays(tracer, &rays.state, colors, counts);
            aov_samples_set_colors(colors, packet_samples);
        }
        if (flags != AOV_RADIANCE) {
            aov_trace_packet(tracer, &rays.state.packet, flags, packet_samples);
        }
        aov_samples_write(packet_samples, grid, index, samples);
    }
    counts->camera += grid_ray_count(grid);
}
