/**
 * @file
 * @brief Box by slabs with a minimum and a maximum that drop NaN.
 *
 *   near = max(near, min(t1, t2)),  far = min(far, max(t1, t2)), t by the inverse of the direction
 *
 * A ray along a face is between its planes now. But near and far are rounded each by itself: at
 * edges and corners, and where a box is flat, near may come out larger than far.
 */
#include "lab/methods/box.h"

/**
 * Cuts an interval.
 * @param origin  Of the ray, along an axis.
 * @param low  Where the slab begins.
 */
static void box_slabs_nan_ignored_clip(SlabInterval *interval, real origin, real direction,
                                       real low, real high) {
    real inverse = 1 / direction;
    real enter = ((inverse < 0 ? high : low) - origin) * inverse;
    real leave = ((inverse < 0 ? low : high) - origin) * inverse;
    interval->near = enter > interval->near ? enter : interval->near;
    interval->far = leave < interval->far ? leave : interval->far;
}

/** Asks it. See #Method.run. */
static void box_slabs_nan_ignored_run(const void *input, void *output) {
    const BoxInput *in = input;
    SlabInterval interval = {-INFINITE, INFINITE};
    box_slabs_nan_ignored_clip(&interval, in->origin.x, in->direction.x, in->low.x, in->high.x);
    box_slabs_nan_ignored_clip(&interval, in->origin.y, in->direction.y, in->low.y, in->high.y);
    box_slabs_nan_ignored_clip(&interval, in->origin.z, in->direction.z, in->low.z, in->high.z);
    *(BoxOutput *)output = box_output_of(interval);
}

const Method box_slabs_nan_ignored = {.group = "box-slabs",
                                      .name = "NaN drops out",
                                      .label = "NaN drops out",
                                      .input_count = NUMBERS_IN(BoxInput),
                                      .output_count = NUMBERS_IN(BoxOutput),
                                      .run = box_slabs_nan_ignored_run};
