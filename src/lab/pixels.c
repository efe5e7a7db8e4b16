/**
 * @file
 * @brief Choosing pixels.
 */
#include "lab/pixels.h"

#include "render/drawing.h"

#include <stdlib.h>

/** Pixels along a side of a cell of which one is sampled: one in 64 is enough for a pilot. */
enum { CELL = 8 };

bool pixel_is_any(const void *context, int x, int y) {
    (void)context;
    (void)x;
    (void)y;
    return true;
}

bool pixel_is_sampled(const void *context, int x, int y) {
    (void)context;
    uint64_t z = ((uint64_t)(y / CELL) << 32 | (uint64_t)(x / CELL)) + 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
    return x % CELL == (int)(z % CELL) && y % CELL == (int)(z / CELL % CELL);
}

/** Adds the pixels of a block. @param[in,out] pixels The set. @param block Which block.
 *  @param test Which pixels. @param context Handed to it. */
static void block_choose(Pixels *pixels, size_t block, PixelTest test, const void *context) {
    PixelGrid grid = drawing_block(pixels->width, pixels->height, block);
    pixels->first[block] = pixels->count;
    for (int place = 0; place < grid.rows * grid.columns; place++) {
        if (test(context, grid.x + place % grid.columns, grid.y + place / grid.columns)) {
            pixels->chosen[pixels->count++] = (uint16_t)place;
        }
    }
    pixels->first[block + 1] = pixels->count;
}

bool pixels_make(Pixels *pixels, int width, int height, PixelTest test, const void *context,
                 Error *error) {
    size_t all = (size_t)width * (size_t)height;
    *pixels = (Pixels){.width = width, .height = height, .blocks = drawing_blocks(width, height)};
    pixels->first = calloc(pixels->blocks + 1, sizeof *pixels->first);
    pixels->chosen = malloc(all * sizeof *pixels->chosen);
    if (!pixels->first || !pixels->chosen) {
        pixels_release(pixels);
        return error_set(error, STATUS_FAILED, "no memory for %zu pixels", all);
    }
    for (size_t block = 0; block < pixels->blocks; block++) {
        block_choose(pixels, block, test, context);
    }
    return true;
}

/** Where shapes end in a picture. */
typedef struct Ends {
    const int *shapes; /**< What each pixel shows. */
    int width;         /**< Of the picture. */
    int height;        /**< Of the picture. */
    size_t every;      /**< Of the pixels where shapes end, one of so many is taken. */
} Ends;

/** @return Whether another shape begins below a pixel or on its right. @param ends The picture.
 *  @param x Its column. @param y Its row. */
static bool pixel_is_end(const Ends *ends, int x, int y) {
    const int *here = ends->shapes + (size_t)y * (size_t)ends->width + x;
    return (x + 1 < ends->width && here[1] != *here) ||
           (y + 1 < ends->height && here[ends->width] != *here);
}

/** @return Whether a pixel is in a pilot's set. See #PixelTest. @param context The #Ends.
 *  @param x Its column. @param y Its row. */
static bool pixel_is_piloted(const void *context, int x, int y) {
    const Ends *ends = context;
    return pixel_is_sampled(NULL, x, y) ||
           (((size_t)x + 31 * (size_t)y) % ends->every == 0 && pixel_is_end(ends, x, y));
}

/** Makes the set of a pilot of what each pixel shows. @param[out] pixels The set. @param ends The
 *  picture. @param[out] error What is wrong. @return false without memory. */
static bool ends_choose(Pixels *pixels, Ends *ends, Error *error) {
    size_t count = 0, most = (size_t)ends->width * (size_t)ends->height / (CELL * CELL);
    for (int y = 0; y < ends->height; y++) {
        for (int x = 0; x < ends->width; x++) {
            count += pixel_is_end(ends, x, y);
        }
    }
    ends->every = count / (most + 1) + 1;
    return pixels_make(pixels, ends->width, ends->height, pixel_is_piloted, ends, error);
}

bool pixels_make_pilot(Pixels *pixels, const Scene *scene, int width, int height, Error *error) {
    const Engine *engine = engine_find("auto", NULL);
    const TraceSettings settings = {.samples = 1, .offset = OFFSET_BOUND};
    size_t count = (size_t)width * (size_t)height;
    int *shapes = malloc(count * sizeof *shapes);
    double *distances = malloc(count * sizeof *distances);
    bool has_room = shapes && distances, is_made = false;
    Tracer *tracer = has_room ? engine->prepare(scene, &settings, error) : NULL;
    if (tracer) {
        PixelGrid all = {.columns = width, .rows = height, .stride = 1};
        engine->look(tracer, scene, width, height);
        engine->cast(tracer, &all, shapes, distances);
        engine->release(tracer);
        is_made = ends_choose(pixels, &(Ends){shapes, width, height, 1}, error);
    } else if (!has_room) {
        error_set(error, STATUS_FAILED, "no memory for %zu pixels", count);
    }
    free(shapes);
    free(distances);
    return is_made;
}

void pixels_release(Pixels *pixels) {
    free(pixels->first);
    free(pixels->chosen);
    *pixels = (Pixels){0};
}

PixelGrid pixels_grid(const Pixels *pixels, size_t block) {
    PixelGrid grid = drawing_block(pixels->width, pixels->height, block);
    grid.chosen = pixels->chosen + pixels->first[block];
    grid.chosen_count = pixels->first[block + 1] - pixels->first[block];
    return grid;
}
