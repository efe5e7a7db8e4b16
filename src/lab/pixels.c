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
