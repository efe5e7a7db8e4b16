/**
 * @file
 * @brief Sets of pixels of a picture: all of them, or a fixed sample.
 */
#ifndef DIOPTRE_LAB_NEEDS_PIXEL_SET_H
#define DIOPTRE_LAB_NEEDS_PIXEL_SET_H

#include "dioptre/engine.h"

/** Some pixels of a picture, in the order of its blocks. */
typedef struct PixelSet {
    int width;         /**< Of the whole picture. */
    int height;        /**< Of the whole picture. */
    size_t tile_count; /**< How many blocks it has. */
    size_t
        *tile_first;  /**< For each block, and once more at the end: how many come before; owned. */
    uint16_t *chosen; /**< See #PixelGrid.selected, block after block; owned. */
    size_t count;     /**< How many in all. */
} PixelSet;

/** Says whether a pixel is in a set. @return Whether it is. */
typedef bool (*PixelTest)(const void *context, int x, int y);

/**
 * Makes a set.
 * @param[out] pixels  The set, to be given back with #pixel_set_deinit.
 * @param width  Of the whole picture.
 * @param height  Of the whole picture.
 * @param test  Which pixels are in it.
 * @param context  Handed to the test.
 * @return false without memory.
 */
bool pixel_set_init(PixelSet *pixels, int width, int height, PixelTest test, const void *context,
                    Error *error);

/** @return Whether any pixel is in the set that holds all: it is. See #PixelTest. */
bool pixel_is_any(const void *context, int x, int y);

/** @return Whether a pixel is the one of its 8 by 8 pixels that is taken: somewhere in them, always
 *  the same. See #PixelTest. */
bool pixel_is_sampled(const void *context, int x, int y);

/**
 * Makes the set of a pilot: a pixel of each 8 by 8, and those where another shape begins; of these
 * not all where they are very many.
 * @param[out] pixels  The set, to be given back with #pixel_set_deinit.
 * @param width  Of the whole picture.
 * @param height  Of the whole picture.
 * @return false without memory.
 */
bool pixel_set_init_sparse(PixelSet *pixels, const Scene *scene, int width, int height,
                           Error *error);

/** Gives a set back. @param pixels The set; may be empty. */
void pixel_set_deinit(PixelSet *pixels);

/** @return The grid of a set's pixels in a block; those of an empty block must not be traced. */
PixelGrid pixel_set_tile_grid(const PixelSet *pixels, size_t block);

#endif
