/**
 * @file
 * @brief What is noted of the rays of pixels.
 */
#include "trace/tracer/aov.h"

#include "trace/tracer/tile.h"

/** @return Place of a shape, or -1: a lamp that is seen is none. */
static int hit_shape_or_none(const Hit *hit, int lane) {
    int shape = integer_lane(hit->shape, lane);
    return shape >= 0 ? shape : -1;
}

/** Notes what the camera's rays have met. @param[in,out] samples What is known of them. */
static void aov_record_hits(const Packet *packet, const Hit *hits, AovSample *samples) {
    for (int i = 0; i < PACKET_RAYS; i++) {
        const Hit *hit = &hits[i / LANES];
        int lane = i % LANES;
        bool is_hit =
            mask_lane(packet->active[i / LANES], lane) && hit_shape_or_none(hit, lane) >= 0;
        samples[i].shape = is_hit ? hit_shape_or_none(hit, lane) : -1;
        samples[i].distance = (double)real_lane(hit->distance, lane);
        samples[i].normal[0] = is_hit ? (double)real_lane(hit->normal.x, lane) : 0;
        samples[i].normal[1] = is_hit ? (double)real_lane(hit->normal.y, lane) : 0;
        samples[i].normal[2] = is_hit ? (double)real_lane(hit->normal.z, lane) : 0;
    }
}

/** Notes where on a picture rays have met a shape. @param[in,out] samples What is known of the
 *  rays. */
static void aov_record_uv(const TextureUv *uv, mask lanes, AovSample *samples) {
    for (unsigned remaining = mask_bits(lanes); remaining; remaining &= remaining - 1) {
        int lane = __builtin_ctz(remaining);
        samples[lane].uv[0] = (double)real_lane(uv->u, lane);
        samples[lane].uv[1] = (double)real_lane(uv->v, lane);
    }
}

/** Notes where on pictures the camera's rays have met shapes. @param[in,out] samples What is known
 *  of them. */
static void aov_record_uvs(const ShapeSet *shapes, const Packet *packet, const Hit *hits,
                           AovSample *samples) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
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

/** Notes what a ray that goes on has met. @param shape The shape, or -1. @param[in,out] sample What
 *  is known of its pixel. */
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

/* --- marching steps --------------------------------------------------------------------------- */

/** Marches to where rays have met anything, and their steps. */
typedef struct StepCount {
    const Hit *hits;            /**< What they have met. */
    real steps[PACKET_VECTORS]; /**< The steps so far. */
} StepCount;

/** Adds the steps of a shape. See #ShapeVisitor. */
static void shape_count_steps(const Shape *shape, const Packet *packet, int v, mask active,
                              void *found) {
    StepCount *step_count = found;
    const Hit *hit = &step_count->hits[v];
    const ShapeExtension *extension = shape->class->extension;
    if (!extension || !extension->count_steps) {
        return;
    }
    // The shape that was met is marched to its surface, wherever roundings put the limit.
    mask is_hit = hit->shape == integer_of(shape->index);
    real limit = real_select(is_hit, real_of(INFINITE), hit->distance);
    real steps = extension->count_steps(shape, &packet->rays[v], active, limit);
    step_count->steps[v] += real_select(active, steps, real_of(0));
}

/** Counts the steps of the camera's rays to what they met. @param[in,out] samples What is known of
 *  them. */
static void aov_record_steps(const ShapeSet *shapes, const Packet *packet, const Hit *hits,
                             AovSample *samples) {
    Packet limited = *packet;
    StepCount step_count = {.hits = hits};
    for (int v = 0; v < PACKET_VECTORS; v++) {
        limited.limit[v] = hits[v].distance;
        step_count.steps[v] = real_of(0);
    }
    shape_set_visit(shapes, &limited, shape_count_steps, &step_count);
    for (int i = 0; i < PACKET_RAYS; i++) {
        samples[i].step_count = (uint32_t)real_lane(step_count.steps[i / LANES], i % LANES);
    }
}

/* --- pixels ----------------------------------------------------------------------------------- */

/** Surveys a packet by its camera's rays alone. @param[in,out] samples What is known of them. */
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
}

/**
 * Puts what is known of a packet where it belongs.
 * @param colors  Its colours; NULL: nobody asked.
 * @param samples  What is known of it.
 * @param[out] out  What is known of the grid.
 */
static void aov_samples_write(const Rgb *colors, const PixelGrid *grid, int column, int row,
                              AovSample *samples, AovSample *out) {
    for (int i = 0; i < PACKET_RAYS; i++) {
        int c = column + i % PACKET_COLUMNS, r = row + i / PACKET_COLUMNS;
        if (colors) {
            samples[i].color[0] = (double)real_lane(colors[i / LANES].red, i % LANES);
            samples[i].color[1] = (double)real_lane(colors[i / LANES].green, i % LANES);
            samples[i].color[2] = (double)real_lane(colors[i / LANES].blue, i % LANES);
        }
        if (c < grid->columns && r < grid->rows) {
            out[(size_t)r * (size_t)grid->columns + (size_t)c] = samples[i];
        }
    }
}

void aov_trace(const Tracer *tracer, const PixelGrid *grid, unsigned flags, AovSample *samples,
               RayCounts *counts) {
    bool wants_radiance = flags & AOV_RADIANCE;
    TileTrace tile = {tracer, grid, pixel_jitter_of(grid->sample), NULL, counts};
    for (int row = 0; row < grid->rows; row += PACKET_ROWS) {
        for (int column = 0; column < grid->columns; column += PACKET_COLUMNS) {
            AovSample packet_samples[PACKET_RAYS] = {0};
            Packet packet;
            Rgb colors[PACKET_VECTORS];
            if (wants_radiance) {
                trace_tile_packet_colors(&tile, column, row, &(Recorders){.aovs = packet_samples},
                                         colors);
            }
            if (!wants_radiance || (flags & ~(unsigned)AOV_RADIANCE)) {
                camera_generate_rays(&tracer->camera, grid, tile.jitter, column, row, &packet);
                aov_trace_packet(tracer, &packet, flags, packet_samples);
            }
            aov_samples_write(wants_radiance ? colors : NULL, grid, column, row, packet_samples,
                              samples);
        }
    }
    counts->camera += (uint64_t)grid->columns * (uint64_t)grid->rows;
}
