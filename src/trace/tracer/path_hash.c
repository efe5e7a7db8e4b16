/**
 * @file
 * @brief Path hashes.
 */
#include "trace/tracer/path_hash.h"

#include "trace/math/hash.h"

/** Quantization steps per unit of a normal's component, or of a transmittance. With
 *  #QUANTIZE_OFFSET, no step is at a value that is common in scenes, such as 0 or 1. */
#define QUANTIZE_SCALE 3.71
/** Offset of the quantization, in steps. */
#define QUANTIZE_OFFSET 4.63

/** @return A number, coarsely quantized: rounding errors rarely change it, an edge does.
 *  @param x A number from -1 to 1. */
static uint64_t quantize(scalar x) {
    double level = (double)x * QUANTIZE_SCALE + QUANTIZE_OFFSET;
    return level > 0 && level < 16 ? (uint64_t)level : 15;
}

/** @return Three numbers of a lane, quantized. */
static uint64_t quantize_lanes(real x, real y, real z, int i) {
    return quantize(real_lane(x, i)) << 8 | quantize(real_lane(y, i)) << 4 |
           quantize(real_lane(z, i));
}

void path_hash_add_surfaces(const SurfaceHit *surface) {
    const SampleContext *context = &surface->packet->context;
    for (int i = 0; i < PACKET_RAYS; i++) {
        const Vec3 *normal = &surface->n_front[i / LANES];
        int lane = i % LANES;
        if (!mask_lane(surface->packet->active[i / LANES], lane)) {
            continue;
        }
        uint64_t event = (uint64_t)context->bounce << 48;
        if (mask_lane(surface->is_hit[i / LANES], lane)) {
            uint64_t shape = (uint64_t)integer_lane(surface->hits[i / LANES].shape, lane) + 1;
            event |= shape << 12 | quantize_lanes(normal->x, normal->y, normal->z, lane);
        }
        uint64_t *path_hash = &context->recorders->path_hashes[i];
        *path_hash = hash_combine_u64(*path_hash, event);
    }
}

void path_hash_add_shadows(const SurfaceHit *surface, const Packet *shadow, const mask *occluded,
                           const Rgb *transmittance) {
    for (int i = 0; i < PACKET_RAYS; i++) {
        int v = i / LANES, lane = i % LANES;
        if (!mask_lane(shadow->active[v], lane)) {
            continue;
        }
        bool is_occluded = mask_lane(occluded[v], lane);
        uint64_t event = is_occluded ? UINT64_C(1) << 40 : UINT64_C(1) << 41;
        if (!is_occluded && transmittance) {
            event |= quantize_lanes(transmittance[v].red, transmittance[v].green,
                                    transmittance[v].blue, lane);
        }
        uint64_t *path_hash = &surface->packet->context.recorders->path_hashes[i];
        *path_hash = hash_combine_u64(*path_hash, event);
    }
}
