/**
 * @file
 * @brief The camera's rays of a grid of pixels, packet by packet.
 */
#include "trace/grid.h"

#include "trace/probe.h"

/**
 * Writes one primary of a vector of rays.
 * @param[out] place  Where the first goes.
 * @param light  The primary.
 * @param count  How many lanes are within the grid, at most LANES.
 */
INLINE void lanes_write(double *place, real light, int count) {
    if (count == LANES) {
        for (int i = 0; i < LANES; i++) {
            place[i] = (double)real_lane(light, i);
        }
        return;
    }
    for (int i = 0; i < count; i++) {
        place[i] = (double)real_lane(light, i);
    }
}

/**
 * Writes the colours of a packet where they belong.
 * @param colors  The colours.
 * @param grid    The grid.
 * @param column  The packet's first column.
 * @param row     The packet's first row.
 * @param[out] rgb  The colours of the whole grid.
 */
static void colors_write(const Light3 *colors, const PixelGrid *grid, int column, int row,
                         double *rgb) {
    size_t plane = (size_t)grid->columns * (size_t)grid->rows;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        int c = column + v * LANES % PACKET_COLUMNS, r = row + v * LANES / PACKET_COLUMNS;
        int count = grid->columns - c < LANES ? grid->columns - c : LANES;
        if (r < grid->rows) {
            double *place = rgb + (size_t)r * (size_t)grid->columns + (size_t)c;
            lanes_write(place, colors[v].red, count);
            lanes_write(place + plane, colors[v].green, count);
            lanes_write(place + 2 * plane, colors[v].blue, count);
        }
    }
}

/** @return The number of a pixel of a grid, its own in the whole picture. @param grid The grid.
 *  @param column Its column. @param row Its row. */
static uint32_t pixel_number(const PixelGrid *grid, int column, int row) {
    int x = grid->x + column * grid->stride, y = grid->y + row * grid->stride;
    return sequence_hash((uint32_t)y << 16 | (uint32_t)x);
}

/** Follows the camera rays of a packet. @param trace The grid. @param packet The rays.
 *  @param pixels Their pixels' numbers; NULL where no lamp asks. @param notes What is noted of
 *  them; NULL: nothing. @param[out] colors Their colours. */
static void packet_follow(const GridTrace *trace, Packet *packet, const uint32_t *pixels,
                          const Notes *notes, Light3 *colors) {
    const Glass *glass = &trace->tracer->glass;
    real weight[PACKET_VECTORS];
    Media media[PACKET_VECTORS];
    for (int v = 0; v < PACKET_VECTORS; v++) {
        weight[v] = real_of(1);
    }
    for (int v = 0; glass->indices && v < PACKET_VECTORS; v++) {
        media[v] = glass->at_eye;
    }
    for (int i = 0; notes && notes->trails && i < PACKET_RAYS; i++) {
        notes->trails[i] = 0;
    }
    packet->lineage =
        (Lineage){.pixels = pixels, .notes = notes, .sample = (uint32_t)trace->grid->sample};
    tracer_follow(trace->tracer, packet, glass->indices ? media : NULL, weight,
                  trace->tracer->depth, colors, trace->counts);
}

/** As #packet_follow, and notes the rays of the first pixel where they are asked for. @param trace
 *  See there. @param packet See there. @param pixels See there. @param notes See there.
 *  @param[out] colors See there. */
static void packet_trace(const GridTrace *trace, Packet *packet, const uint32_t *pixels,
                         const Notes *notes, Light3 *colors) {
    const Tracer *tracer = trace->tracer;
    Probe *probe = notes ? notes->probe : NULL;
    if (probe) {
        Light3 all = {real_of(1), real_of(1), real_of(1)};
        probe_send(probe, PROBE_CAMERA, packet, all, real_of(1));
    }
    packet_follow(trace, packet, pixels, notes, colors);
    if (probe) {
        probe_return(probe, colors[0]);
        probe_finish(probe, tracer->origin, tracer->lamps, tracer->lamp_count);
    }
}

/** @return What is noted for a grid; NULL: nothing. @param grid It. @param trails Room for a
 *  packet's trails. @param[out] notes Room for it. */
static const Notes *grid_notes(const PixelGrid *grid, uint64_t *trails, Notes *notes) {
    *notes = (Notes){.trails = grid->trails ? trails : NULL, .probe = grid->probe};
    return grid->trails || grid->probe ? notes : NULL;
}

/** Writes the trails of a packet where they belong. @param trails The trails. @param grid The grid,
 *  which asks for them. @param column The packet's first column. @param row Its first row. */
static void trails_write(const uint64_t *trails, const PixelGrid *grid, int column, int row) {
    for (int i = 0; i < PACKET_RAYS; i++) {
        int c = column + i % PACKET_COLUMNS, r = row + i / PACKET_COLUMNS;
        if (c < grid->columns && r < grid->rows) {
            grid->trails[(size_t)r * (size_t)grid->columns + (size_t)c] = trails[i];
        }
    }
}

void grid_follow(const GridTrace *trace, int column, int row, const Notes *notes, Light3 *colors) {
    Packet packet;
    uint32_t pixels[PACKET_RAYS];
    bool is_soft = trace->tracer->is_soft;
    for (int i = 0; is_soft && i < PACKET_RAYS; i++) {
        pixels[i] =
            pixel_number(trace->grid, column + i % PACKET_COLUMNS, row + i / PACKET_COLUMNS);
    }
    eye_aim(&trace->tracer->eye, trace->grid, trace->place, column, row, &packet);
    packet_trace(trace, &packet, is_soft ? pixels : NULL, notes, colors);
}

/** Traces a packet of a grid. @param trace The grid. @param column The packet's first column.
 *  @param row Its first row. */
static void block_trace(const GridTrace *trace, int column, int row) {
    Light3 colors[PACKET_VECTORS];
    uint64_t trails[PACKET_RAYS];
    Notes notes;
    grid_follow(trace, column, row, grid_notes(trace->grid, trails, &notes), colors);
    if (trace->grid->trails) {
        trails_write(trails, trace->grid, column, row);
    }
    colors_write(colors, trace->grid, column, row, trace->rgb);
}

/** Traces some of the chosen pixels of a grid. @param trace The grid. @param first Which of the
 *  chosen is the first. */
static void chosen_trace(const GridTrace *trace, size_t first) {
    Packet packet;
    Light3 colors[PACKET_VECTORS];
    uint32_t pixels[PACKET_RAYS] = {0};
    const PixelGrid *grid = trace->grid;
    size_t left = grid->chosen_count - first, count = left < PACKET_RAYS ? left : PACKET_RAYS;
    for (size_t i = 0; trace->tracer->is_soft && i < count; i++) {
        int pixel = grid->chosen[first + i];
        pixels[i] = pixel_number(grid, pixel % grid->columns, pixel / grid->columns);
    }
    eye_aim_chosen(&trace->tracer->eye, grid, trace->place, first, &packet);
    uint64_t trails[PACKET_RAYS];
    Notes notes;
    packet_trace(trace, &packet, trace->tracer->is_soft ? pixels : NULL,
                 grid_notes(grid, trails, &notes), colors);
    for (size_t i = 0; grid->trails && i < count; i++) {
        grid->trails[first + i] = trails[i];
    }
    double *red = trace->rgb + first, *green = red + grid->chosen_count;
    double *blue = green + grid->chosen_count;
    for (size_t i = 0; i < count; i++) {
        const Light3 *color = &colors[i / LANES];
        red[i] = (double)real_lane(color->red, (int)(i % LANES));
        green[i] = (double)real_lane(color->green, (int)(i % LANES));
        blue[i] = (double)real_lane(color->blue, (int)(i % LANES));
    }
}

void grid_trace(const Tracer *tracer, const PixelGrid *grid, double *rgb, RayCounts *counts) {
    GridTrace trace = {tracer, grid, eye_sample(grid->sample), rgb, counts};
    if (grid->chosen) {
        for (size_t first = 0; first < grid->chosen_count; first += PACKET_RAYS) {
            chosen_trace(&trace, first);
        }
        counts->camera += grid->chosen_count;
        return;
    }
    for (int row = 0; row < grid->rows; row += PACKET_ROWS) {
        for (int column = 0; column < grid->columns; column += PACKET_COLUMNS) {
            block_trace(&trace, column, row);
        }
    }
    counts->camera += (uint64_t)grid->columns * (uint64_t)grid->rows;
}

/**
 * Writes what a vector of rays has met.
 * @param hit     What it met.
 * @param count   How many lanes are within the grid, at most LANES.
 * @param[out] shapes     Where the first shape goes.
 * @param[out] distances  Where the first distance goes.
 */
INLINE void hits_write(const Hit *hit, int count, int *shapes, double *distances) {
    lanes_write(distances, hit->distance, count);
    for (int i = 0; i < count; i++) {
        shapes[i] = integer_lane(hit->shape, i);
    }
}

void grid_cast(const Tracer *tracer, const PixelGrid *grid, int *shapes, double *distances) {
    SamplePlace place = eye_sample(grid->sample);
    for (int row = 0; row < grid->rows; row += PACKET_ROWS) {
        for (int column = 0; column < grid->columns; column += PACKET_COLUMNS) {
            Packet packet;
            Hit hits[PACKET_VECTORS];
            eye_aim(&tracer->eye, grid, place, column, row, &packet);
            packet.wants_points = false;
            shape_list_nearest(&tracer->list, &packet, hits);
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
