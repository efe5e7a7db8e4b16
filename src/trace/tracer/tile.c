/**
 * @file
 * @brief Tracing of tiles.
 */
#include "trace/tracer/tile.h"

#include "trace/math/sobol.h"
#include "trace/tracer/plain_packet.h"
#include "trace/tracer/ray_tree_recorder.h"
#include "trace/tracer/retrace.h"

#include <string.h>

/* --- output ----------------------------------------------------------------------------------- */

/** Writes the first lanes. @param count How many; all of them is the fast case. */
INLINE void real_store_lanes(double *out, real x, int count) {
#if LANES > 1
    if (count == LANES) {
        // Of engines with several lanes, the wider type is double.
        wide numbers = widen(x);
        memcpy(out, &numbers, sizeof numbers);
        return;
    }
#endif
    for (int i = 0; i < count; i++) {
        out[i] = (double)real_lane(x, i);
    }
}

/** Writes the colours of a packet. @param[out] rgb Those of the grid: red, then green, then blue.
 */
static void colors_write(const Rgb *colors, const PixelGrid *grid, int index, double *rgb) {
    size_t plane = grid_ray_count(grid), columns = (size_t)grid->columns;
    if (LANES == 1) { // Packets are pixels, in the same order.
        real_store_lanes(rgb + index, colors[0].red, 1);
        real_store_lanes(rgb + plane + index, colors[0].green, 1);
        real_store_lanes(rgb + 2 * plane + index, colors[0].blue, 1);
        return;
    }
    GridPosition first = grid_packet_position(grid, index);
    if (!grid->selected && grid_has_whole_packet(grid, first)) {
        double *target = rgb + (size_t)first.row * columns + (size_t)first.column;
        for (int v = 0; v < PACKET_VECTORS; v++) {
            GridPosition position = grid_vector_position((GridPosition){0}, v);
            double *out = target + (size_t)position.row * columns + (size_t)position.column;
            real_store_lanes(out, colors[v].red, LANES);
            real_store_lanes(out + plane, colors[v].green, LANES);
            real_store_lanes(out + 2 * plane, colors[v].blue, LANES);
        }
        return;
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        OutputRange range = output_range(grid, index, v);
        double *out = rgb + range.first;
        real_store_lanes(out, colors[v].red, range.count);
        real_store_lanes(out + plane, colors[v].green, range.count);
        real_store_lanes(out + 2 * plane, colors[v].blue, range.count);
    }
}

/** Writes the path hashes of a packet. */
static void path_hashes_write(const uint64_t *path_hashes, const PixelGrid *grid, int index) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        OutputRange range = output_range(grid, index, v);
        memcpy(grid->path_hashes + range.first, path_hashes + v * LANES,
               (size_t)range.count * sizeof *path_hashes);
    }
}

/* --- camera rays ------------------------------------------------------------------------------ */

/** Sets a number for each ray, unique to its pixel: a hash of the pixel's position in the image. */
static void pixel_ids_set(const PixelGrid *grid, int index, uint32_t *pixel_ids) {
    memset(pixel_ids, 0, PACKET_RAYS * sizeof *pixel_ids);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        OutputRange range = output_range(grid, index, v);
        for (int i = 0; i < range.count; i++) {
            size_t output = range.first + (size_t)i;
            int pixel = grid->selected ? grid->selected[output] : (int)output;
            int x = grid->x + pixel % grid->columns * grid->stride;
            int y = grid->y + pixel / grid->columns * grid->stride;
            pixel_ids[v * LANES + i] = hash_u32((uint32_t)y << 16 | (uint32_t)x);
        }
    }
}

void camera_rays_init(const Tracer *tracer, const PixelGrid *grid, PixelJitter jitter, int index,
                      CameraRun *run, const Recorders *recorders, CameraRays *rays) {
    const Dielectrics *dielectrics = &tracer->dielectrics;
    const Rgb one = {real_of(1), real_of(1), real_of(1)};
    RayState *state = &rays->state;
    camera_generate_rays(&tracer->camera, grid, jitter, index, run, &state->packet);
    state->packet.context =
        (SampleContext){.recorders = recorders, .sample = (uint32_t)grid->sample};
    for (int v = 0; v < PACKET_VECTORS; v++) {
        state->throughput[v] = one;
        state->turns[v] = integer_of(0);
    }
    state->interior = NULL;
    if (dielectrics->iors) {
        for (int v = 0; v < PACKET_VECTORS; v++) {
            rays->interior[v] = dielectrics->camera_interior;
        }
        state->interior = rays->interior;
    }
    if (tracer->has_soft_shadows) {
        pixel_ids_set(grid, index, rays->pixel_ids);
        state->packet.context.pixel_ids = rays->pixel_ids;
    }
}

/* --- tiles ------------------------------------------------------------------------------------ */

/** What the camera rays of a tile may meet. */
typedef struct TileSight {
    bool is_known;             /**< Whether the rest is set. */
    Beam beam;                 /**< A beam that holds all rays. */
    BeamCandidates candidates; /**< The shapes that they may meet. */
} TileSight;

/** @return What the rays of a grid may meet. */
static TileSight tile_sight_of(const Tracer *tracer, const PixelGrid *grid) {
    // The reports' formulas hit beside their shapes: only the box of each hides that.
    TileSight sight = {.is_known = shape_set_is_list(&tracer->shapes) && !grid->selected &&
                                   !tracer->methods};
    if (sight.is_known) {
        sight.beam = camera_beam(&tracer->camera, grid, pixel_jitter_of(grid->sample));
        shape_set_find_in_beam(&tracer->shapes, &sight.beam, &sight.candidates);
    }
    return sight;
}

/** @return Whether all rays of a grid see the same light of the sky, and nothing else. */
static bool tile_is_background(const Tracer *tracer, const PixelGrid *grid,
                               const TileSight *sight) {
    return sight->is_known && sight->candidates.count == 0 && !tracer->sky.is_gradient &&
           !tracer->textures.sky && tracer->emitters.count == 0 && !grid->path_hashes &&
           !grid->ray_tree;
}

/** @return Whether the rays of a grid are no longer needed. */
static bool grid_is_stopped(const PixelGrid *grid) {
    return grid->is_stopped && grid->is_stopped(grid->stop_context);
}

/** Traces a grid of pixels as wavefronts. */
static __attribute__((noinline)) void trace_tile_wavefronts(const Tracer *tracer,
                                                            const PixelGrid *grid,
                                                            Wavefront *wavefront, double *rgb,
                                                            RayCounts *counts) {
    const PixelJitter jitter = pixel_jitter_of(grid->sample);
    int packet_count = grid_packet_count(grid);
    for (int first = 0; first < packet_count && !grid_is_stopped(grid);
         first += WAVEFRONT_PACKETS) {
        CameraRays rays[WAVEFRONT_PACKETS];
        Rgb colors[WAVEFRONT_PACKETS][PACKET_VECTORS];
        CameraPacket packets[WAVEFRONT_PACKETS];
        int left = packet_count - first,
            count = left < WAVEFRONT_PACKETS ? left : WAVEFRONT_PACKETS;
        for (int i = 0; i < count; i++) {
            camera_rays_init(tracer, grid, jitter, first + i, NULL, NULL, &rays[i]);
            packets[i].rays = &rays[i].state;
            packets[i].colors = colors[i];
        }
        trace_camera_packets(tracer, wavefront, packets, count, counts);
        for (int i = 0; i < count; i++) {
            colors_write(colors[i], grid, first + i, rgb);
        }
    }
}

/** Traces a grid of pixels packet by packet. */
static void trace_tile_packets(const Tracer *tracer, const PixelGrid *grid, const TileSight *sight,
                               double *rgb, RayCounts *counts) {
    const PixelJitter jitter = pixel_jitter_of(grid->sample);
    uint64_t path_hashes[PACKET_RAYS];
    const Recorders recorders = {.path_hashes = grid->path_hashes ? path_hashes : NULL,
                                 .ray_tree = grid->ray_tree};
    bool is_recorded = grid->path_hashes || grid->ray_tree;
    PlainTile plain = {.is_possible = false};
    const Shape *only_shape = NULL;
    if (LANES > 1 && sight->is_known) {
        plain_tile_find(tracer, grid, &sight->beam, &sight->candidates, &plain);
    }
    int packet_count = grid_packet_count(grid);
    CameraRun run = {0};
    for (int index = 0; index < packet_count; index++) {
        CameraRays rays;
        Rgb colors[PACKET_VECTORS];
        if (LANES > 1 && plain.is_possible &&
            plain_packet_shade(tracer, &plain, grid, jitter, index, colors, counts, &only_shape)) {
            colors_write(colors, grid, index, rgb);
            continue;
        }
        camera_rays_init(tracer, grid, jitter, index, &run, is_recorded ? &recorders : NULL, &rays);
        rays.state.packet.only_shape = only_shape;
        trace_camera_rays(tracer, &rays.state, colors, counts);
        if (grid->ray_tree) {
            ray_tree_finish(grid->ray_tree, tracer->origin);
        }
        if (grid->path_hashes) {
            path_hashes_write(path_hashes, grid, index);
        }
        colors_write(colors, grid, index, rgb);
    }
}

/** Fills a grid with the light of the sky. */
static void tile_fill_background(const Tracer *tracer, const PixelGrid *grid, double *rgb) {
    const Rgb *sky = &tracer->sky.horizon;
    const double colors[3] = {(double)real_lane(sky->red, 0), (double)real_lane(sky->green, 0),
                              (double)real_lane(sky->blue, 0)};
    size_t plane = grid_ray_count(grid);
    for (size_t channel = 0; channel < 3; channel++) {
        for (size_t i = 0; i < plane; i++) {
            rgb[channel * plane + i] = colors[channel];
        }
    }
}

void trace_tile(const Tracer *tracer, const PixelGrid *grid, double *rgb, RayCounts *counts) {
    counts->camera += grid_ray_count(grid);
    const TileSight sight = tile_sight_of(tracer, grid);
    if (tile_is_background(tracer, grid, &sight)) {
        tile_fill_background(tracer, grid, rgb);
        return;
    }
    // Recorders identify rays by their lanes.
    bool has_wavefront = tracer->wavefronts && !grid->path_hashes && !grid->ray_tree;
    Wavefront *wavefront = has_wavefront ? wavefront_pool_take(tracer->wavefronts) : NULL;
    // Without memory for wavefronts, the recursion does the same more slowly, but for merged rays.
    if (wavefront) {
        trace_tile_wavefronts(tracer, grid, wavefront, rgb, counts);
        wavefront_pool_give_back(tracer->wavefronts, wavefront);
    } else {
        trace_tile_packets(tracer, grid, &sight, rgb, counts);
    }
}

void trace_tile_primary(const Tracer *tracer, const PixelGrid *grid, int *shapes,
                        double *distances) {
    const PixelJitter jitter = pixel_jitter_of(grid->sample);
    int packet_count = grid_packet_count(grid);
    CameraRun run = {0};
    for (int index = 0; index < packet_count; index++) {
        Packet packet;
        Hit hits[PACKET_VECTORS];
        camera_generate_rays(&tracer->camera, grid, jitter, index, &run, &packet);
        packet.wants_points = false;
        shape_set_closest_hits(&tracer->shapes, &packet, hits);
        for (int v = 0; v < PACKET_VECTORS; v++) {
            OutputRange range = output_range(grid, index, v);
            real_store_lanes(distances + range.first, hits[v].distance, range.count);
            for (int i = 0; i < range.count; i++) {
                shapes[range.first + (size_t)i] = integer_lane(hits[v].shape, i);
            }
        }
    }
}
