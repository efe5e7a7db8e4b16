/**
 * @file
 * @brief Choosing pixels.
 */
#include "lab/needs/pixel_set.h"

#include "render/render_pass.h"

#include <stdlib.h>

/** Pixels along a side of a cell of which one is sampled: one in 64 is enough for a pilot. */
enum { SAMPLING_CELL = 8 };

bool pixel_is_any(const void *context, int x, int y) {
    (void)context;
    (void)x;
    (void)y;
    return true;
}

bool pixel_is_sampled(const void *context, int x, int y) {
    (void)context;
    uint64_t z =
        ((uint64_t)(y / SAMPLING_CELL) << 32 | (uint64_t)(x / SAMPLING_CELL)) + 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
    return x % SAMPLING_CELL == (int)(z % SAMPLING_CELL) &&
           y % SAMPLING_CELL == (int)(z / SAMPLING_CELL % SAMPLING_CELL);
}

/** Adds the pixels of a block. */
static void add_tile_pixels(PixelSet *pixels, size_t block, PixelTest test, const void *context) {
    PixelGrid grid = tile_at(pixels->width, pixels->height, block);
    pixels->tile_first[block] = pixels->count;
    for (int index = 0; index < grid.rows * grid.columns; index++) {
        if (test(context, grid.x + index % grid.columns, grid.y + index / grid.columns)) {
            pixels->chosen[pixels->count++] = (uint16_t)index;
        }
    }
    pixels->tile_first[block + 1] = pixels->count;
}

bool pixel_set_init(PixelSet *pixels, int width, int height, PixelTest test, const void *context,
                    Error *error) {
    size_t all = (size_t)width * (size_t)height;
    *pixels = (PixelSet){.width = width, .height = height, .tile_count = tile_count(width, height)};
    pixels->tile_first = calloc(pixels->tile_count + 1, sizeof *pixels->tile_first);
    pixels->chosen = malloc(all * sizeof *pixels->chosen);
    if (!pixels->tile_first || !pixels->chosen) {
        pixel_set_deinit(pixels);
        return error_set(error, STATUS_FAILED, "no memory for %zu pixels", all);
    }
    for (size_t block = 0; block < pixels->tile_count; block++) {
        add_tile_pixels(pixels, block, test, context);
    }
    return true;
}

/** Where shapes end in a picture. */
typedef struct ShapeEdges {
    const int *shapes; /**< What each pixel shows. */
    int width;         /**< Of the picture. */
    int height;        /**< Of the picture. */
    size_t stride;     /**< Of the pixels where shapes end, one of so many is taken. */
} ShapeEdges;

/** @return Whether another shape begins below a pixel or on its right. */
static bool pixel_is_on_shape_edge(const ShapeEdges *ends, int x, int y) {
    const int *here = ends->shapes + (size_t)y * (size_t)ends->width + x;
    return (x + 1 < ends->width && here[1] != *here) ||
           (y + 1 < ends->height && here[ends->width] != *here);
}

/** @return Whether a pixel is in a pilot's set. See #PixelTest. */
static bool pixel_is_in_sparse_set(const void *context, int x, int y) {
    const ShapeEdges *ends = context;
    return pixel_is_sampled(NULL, x, y) ||
           (((size_t)x + 31 * (size_t)y) % ends->stride == 0 && pixel_is_on_shape_edge(ends, x, y));
}

/** Makes the set of a pilot of what each pixel shows. @return false without memory. */
static bool choose_sparse_pixels(PixelSet *pixels, ShapeEdges *ends, Error *error) {
    size_t count = 0,
           limit = (size_t)ends->width * (size_t)ends->height / (SAMPLING_CELL * SAMPLING_CELL);
    for (int y = 0; y < ends->height; y++) {
        for (int x = 0; x < ends->width; x++) {
            count += pixel_is_on_shape_edge(ends, x, y);
        }
    }
    ends->stride = count / (limit + 1) + 1;
    return pixel_set_init(pixels, ends->width, ends->height, pixel_is_in_sparse_set, ends, error);
}

bool pixel_set_init_sparse(PixelSet *pixels, const Scene *scene, int width, int height,
                           Error *error) {
    const Engine *engine = engine_find("auto", NULL);
    const TraceSettings settings = {.samples = 1, .offset = OFFSET_BOUND};
    size_t count = (size_t)width * (size_t)height;
    int *shapes = malloc(count * sizeof *shapes);
    double *distances = malloc(count * sizeof *distances);
    bool has_room = shapes && distances, is_made = false;
    Tracer *tracer = has_room ? engine->create_tracer(scene, &settings, error) : NULL;
    if (tracer) {
        PixelGrid all = {.columns = width, .rows = height, .stride = 1};
        engine->set_view(tracer, scene, width, height);
        engine->trace_primary(tracer, &all, shapes, distances);
        engine->destroy(tracer);
        is_made = choose_sparse_pixels(pixels, &(ShapeEdges){shapes, width, height, 1}, error);
    } else if (!has_room) {
        error_set(error, STATUS_FAILED, "no memory for %zu pixels", count);
    }
    free(shapes);
    free(distances);
    return is_made;
}

void pixel_set_deinit(PixelSet *pixels) {
    free(pixels->tile_first);
    free(pixels->chosen);
    *pixels = (PixelSet){0};
}

PixelGrid pixel_set_tile_grid(const PixelSet *pixels, size_t block) {
    PixelGrid grid = tile_at(pixels->width, pixels->height, block);
    grid.selected = pixels->chosen + pixels->tile_first[block];
    grid.selected_count = pixels->tile_first[block + 1] - pixels->tile_first[block];
    return grid;
}
