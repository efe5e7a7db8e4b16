/**
 * @file
 * @brief Box by slabs, as it is first written down.
 *
 *   t1 = (low - o) / d,  t2 = (high - o) / d,  swapped where t1 > t2; each slab must leave
 * something
 *
 * In the plane of a face, along it, t is 0 / 0: NaN. Every comparison is written as "go on only
 * if", so that NaN means a miss.
 */
#include "lab/methods/box.h"

/**
 * Cuts an interval.
 * @param origin  Of the ray, along an axis.
 * @param low  Where the slab begins.
 * @return Whether anything is left.
 */
static int box_slabs_nan_misses_clip(SlabInterval *interval, real origin, real direction, real low,
                                     real high) {
    real t1 = (low - origin) / direction, t2 = (high - origin) / direction;
    real near = t1 <= t2 ? t1 : t2, far = t1 <= t2 ? t2 : t1;
    interval->near = near <= interval->near ? interval->near : near;
    interval->far = far >= interval->far ? interval->far : far;
    return interval->near <= interval->far;
}

/** Asks it. See #Method.run. */
static void box_slabs_nan_misses_run(const void *input, void *output) {
    const BoxInput *in = input;
    SlabInterval interval = {-INFINITE, INFINITE};
    int is_met =
        box_slabs_nan_misses_clip(&interval, in->origin.x, in->direction.x, in->low.x,
                                  in->high.x) &&
        box_slabs_nan_misses_clip(&interval, in->origin.y, in->direction.y, in->low.y,
                                  in->high.y) &&
        box_slabs_nan_misses_clip(&interval, in->origin.z, in->direction.z, in->low.z, in->high.z);
    *(BoxOutput *)output = is_met ? box_output_of(interval) : (BoxOutput){.distance = INFINITE};
}

const Method box_slabs_nan_misses = {.group = "box-slabs",
                                     .name = "NaN misses",
                                     .label = "NaN misses",
                                     .input_count = NUMBERS_IN(BoxInput),
                                     .output_count = NUMBERS_IN(BoxOutput),
                                     .run = box_slabs_nan_misses_run};
