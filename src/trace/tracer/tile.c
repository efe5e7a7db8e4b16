/**
 * @file
 * @brief The camera's rays of a grid of pixels, packet by packet.
 */
#include "trace/tracer/tile.h"

#include "trace/tracer/ray_tree_recorder.h"

/**
 * Writes one primary of a vector of rays.
 * @param[out] out  Where the first goes.
 * @param count  How many lanes are within the grid, at most LANES.
 */
INLINE void real_store_lanes(double *out, real channel, int count) {
    if (count == LANES) {
        for (int i = 0; i < LANES; i++) {
            out[i] = (double)real_lane(channel, i);
        }
        return;
    }
    for (int i = 0; i < count; i++) {
        out[i] = (double)real_lane(channel, i);
    }
}

/** Writes the colours of a packet where they belong. @param[out] rgb The colours of the whole grid.
 */
static void colors_write(const Rgb *colors, const PixelGrid *grid, int column, int row,
                         double *rgb) {
    size_t plane = (size_t)grid->columns * (size_t)grid->rows;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        int c = column + v * LANES % PACKET_COLUMNS, r = row + v * LANES / PACKET_COLUMNS;
        int count = grid->columns - c < LANES ? grid->columns - c : LANES;
        if (r < grid->rows) {
            double *out = rgb + (size_t)r * (size_t)grid->columns + (size_t)c;
            real_store_lanes(out, colors[v].red, count);
            real_store_lanes(out + plane, colors[v].green, count);
            real_store_lanes(out + 2 * plane, colors[v].blue, count);
        }
    }
}

/** @return The number of a pixel of a grid, its own in the whole picture. */
static uint32_t pixel_id(const PixelGrid *grid, int column, int row) {
    int x = grid->x + column * grid->stride, y = grid->y + row * grid->stride;
    return hash_u32((uint32_t)y << 16 | (uint32_t)x);
}

/**
 * Follows the camera rays of a packet.
 * @param pixel_ids  Their pixels' numbers; NULL where no lamp asks.
 * @param recorders  What is noted of them; NULL: nothing.
 */
static void trace_camera_packet(const TileTrace *tile, Packet *packet, const uint32_t *pixel_ids,
                                const Recorders *recorders, Rgb *colors) {
    const Dielectrics *dielectrics = &tile->tracer->dielectrics;
    real throughput[PACKET_VECTORS];
    InteriorList interior[PACKET_VECTORS];
    for (int v = 0; v < PACKET_VECTORS; v++) {
        throughput[v] = real_of(1);
    }
    for (int v = 0; dielectrics->iors && v < PACKET_VECTORS; v++) {
        interior[v] = dielectrics->camera_interior;
    }
    for (int i = 0; recorders && recorders->path_hashes && i < PACKET_RAYS; i++) {
        recorders->path_hashes[i] = 0;
    }
    packet->context = (SampleContext){
        .pixel_ids = pixel_ids, .recorders = recorders, .sample = (uint32_t)tile->grid->sample};
    tracer_trace_packet(tile->tracer, packet, dielectrics->iors ? interior : NULL, throughput,
                        tile->tracer->depth, colors, tile->counts);
}

/** As #trace_camera_packet, and notes the rays of the first pixel where they are asked for. */
static void trace_recorded_packet(const TileTrace *tile, Packet *packet, const uint32_t *pixel_ids,
                                  const Recorders *recorders, Rgb *colors) {
    const Tracer *tracer = tile->tracer;
    RayTree *ray_tree = recorders ? recorders->ray_tree : NULL;
    if (ray_tree) {
        Rgb one = {real_of(1), real_of(1), real_of(1)};
        ray_tree_push(ray_tree, RAY_CAMERA, packet, one, real_of(1));
    }
    trace_camera_packet(tile, packet, pixel_ids, recorders, colors);
    if (ray_tree) {
        ray_tree_pop(ray_tree, colors[0]);
        ray_tree_finish(ray_tree, tracer->origin);
    }
}

/**
 * @return What is noted for a grid; NULL: nothing.
 * @param path_hashes  Room for a packet's trails.
 */
static const Recorders *tile_recorders(const PixelGrid *grid, uint64_t *path_hashes,
                                       Recorders *recorders) {
    *recorders = (Recorders){.path_hashes = grid->path_hashes ? path_hashes : NULL,
                             .ray_tree = grid->ray_tree};
    return grid->path_hashes || grid->ray_tree ? recorders : NULL;
}

/** Writes the trails of a packet where they belong. @param grid The grid, which asks for them. */
static void path_hashes_write(const uint64_t *path_hashes, const PixelGrid *grid, int column,
                              int row) {
    for (int i = 0; i < PACKET_RAYS; i++) {
        int c = column + i % PACKET_COLUMNS, r = row + i / PACKET_COLUMNS;
        if (c < grid->columns && r < grid->rows) {
            grid->path_hashes[(size_t)r * (size_t)grid->columns + (size_t)c] = path_hashes[i];
        }
    }
}

void trace_tile_packet_colors(const TileTrace *tile, int column, int row,
                              const Recorders *recorders, Rgb *colors) {
    Packet packet;
    uint32_t pixel_ids[PACKET_RAYS];
    bool is_soft = tile->tracer->has_soft_shadows;
    for (int i = 0; is_soft && i < PACKET_RAYS; i++) {
        pixel_ids[i] = pixel_id(tile->grid, column + i % PACKET_COLUMNS, row + i / PACKET_COLUMNS);
    }
    camera_generate_rays(&tile->tracer->camera, tile->grid, tile->jitter, column, row, &packet);
    trace_recorded_packet(tile, &packet, is_soft ? pixel_ids : NULL, recorders, colors);
}

/** Traces a packet of a grid. */
static void trace_tile_packet(const TileTrace *tile, int column, int row) {
    Rgb colors[PACKET_VECTORS];
    uint64_t path_hashes[PACKET_RAYS];
    Recorders recorders;
    trace_tile_packet_colors(tile, column, row, tile_recorders(tile->grid, path_hashes, &recorders),
                             colors);
    if (tile->grid->path_hashes) {
        path_hashes_write(path_hashes, tile->grid, column, row);
    }
    colors_write(colors, tile->grid, column, row, tile->rgb);
}

/** Traces some of the chosen pixels of a grid. @param first Which of the chosen is the first. */
static void trace_selected_packet(const TileTrace *tile, size_t first) {
    Packet packet;
    Rgb colors[PACKET_VECTORS];
    uint32_t pixel_ids[PACKET_RAYS] = {0};
    const PixelGrid *grid = tile->grid;
    size_t remaining = grid->selected_count - first,
           count = remaining < PACKET_RAYS ? remaining : PACKET_RAYS;
    for (size_t i = 0; tile->tracer->has_soft_shadows && i < count; i++) {
        int pixel = grid->selected[first + i];
        pixel_ids[i] = pixel_id(grid, pixel % grid->columns, pixel / grid->columns);
    }
    camera_generate_selected_rays(&tile->tracer->camera, grid, tile->jitter, first, &packet);
    uint64_t path_hashes[PACKET_RAYS];
    Recorders recorders;
    trace_recorded_packet(tile, &packet, tile->tracer->has_soft_shadows ? pixel_ids : NULL,
                          tile_recorders(grid, path_hashes, &recorders), colors);
    for (size_t i = 0; grid->path_hashes && i < count; i++) {
        grid->path_hashes[first + i] = path_hashes[i];
    }
    double *red = tile->rgb + first, *green = red + grid->selected_count;
    double *blue = green + grid->selected_count;
    for (size_t i = 0; i < count; i++) {
        const Rgb *color = &colors[i / LANES];
        red[i] = (double)real_lane(color->red, (int)(i % LANES));
        green[i] = (double)real_lane(color->green, (int)(i % LANES));
        blue[i] = (double)real_lane(color->blue, (int)(i % LANES));
    }
}

void trace_tile(const Tracer *tracer, const PixelGrid *grid, double *rgb, RayCounts *counts) {
    TileTrace tile = {tracer, grid, pixel_jitter_of(grid->sample), rgb, counts};
    if (grid->selected) {
        for (size_t first = 0; first < grid->selected_count; first += PACKET_RAYS) {
            trace_selected_packet(&tile, first);
        }
        counts->camera += grid->selected_count;
        return;
    }
    for (int row = 0; row < grid->rows; row += PACKET_ROWS) {
        for (int column = 0; column < grid->columns; column += PACKET_COLUMNS) {
            trace_tile_packet(&tile, column, row);
        }
    }
    counts->camera += (uint64_t)grid->columns * (uint64_t)grid->rows;
}

/**
 * Writes what a vector of rays has met.
 * @param count  How many lanes are within the grid, at most LANES.
 * @param[out] shapes  Where the first shape goes.
 * @param[out] distances  Where the first distance goes.
 */
INLINE void hits_write(const Hit *hit, int count, int *shapes, double *distances) {
    real_store_lanes(distances, hit->distance, count);
    for (int i = 0; i < count; i++) {
        shapes[i] = integer_lane(hit->shape, i);
    }
}

void trace_tile_primary(const Tracer *tracer, const PixelGrid *grid, int *shapes,
                        double *distances) {
    PixelJitter jitter = pixel_jitter_of(grid->sample);
    for (int row = 0; row < grid->rows; row += PACKET_ROWS) {
        for (int column = 0; column < grid->columns; column += PACKET_COLUMNS) {
            Packet packet;
            Hit hits[PACKET_VECTORS];
            camera_generate_rays(&tracer->camera, grid, jitter, column, row, &packet);
            packet.wants_points = false;
            shape_set_closest_hits(&tracer->shapes, &packet, hits);
            for (int v = 0; v < PACKET_VECTORS; v++) {
                int c = column + v * LANES % PACKET_COLUMNS, r = row + v * LANES / PACKET_COLUMNS;
                int count = grid->columns - c < LANES ? grid->columns - c : LANES;
                if (r < grid->rows) {
                    size_t at = (size_t)r * (size_t)grid->columns + (size_t)c;
                    hits_write(&hits[v], count, shapes + at, distances + at);
                }
            }
        }
    }
}
