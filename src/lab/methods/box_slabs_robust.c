/**
 * @file
 * @brief Box by slabs, a little longer than they come out (Ize, *Robust BVH Ray Traversal*, JCGT
 *        2013). The tracer's way.
 *
 *   far (1 + 2 gamma_3),  gamma_3 = 3 u / (1 - 3 u)
 *
 * t is a difference, an inverse and a product: three roundings. So much longer, far is never below
 * a near that it must not be below.
 */
#include "lab/methods/box.h"

/**
 * Cuts an interval.
 * @param origin  Of the ray, along an axis.
 * @param low  Where the slab begins.
 */
static void box_slabs_robust_clip(SlabInterval *interval, real origin, real direction, real low,
                                  real high) {
    const real gamma = 3 * ROUNDOFF / (1 - 3 * ROUNDOFF);
    real inverse = 1 / direction;
    real enter = ((inverse < 0 ? high : low) - origin) * inverse;
    real leave = ((inverse < 0 ? low : high) - origin) * inverse * (1 + 2 * gamma);
    interval->near = enter > interval->near ? enter : interval->near;
    interval->far = leave < interval->far ? leave : interval->far;
}

/** Asks it. See #Method.run. */
static void box_slabs_robust_run(const void *input, void *output) {
    const BoxInput *in = input;
    SlabInterval interval = {-INFINITE, INFINITE};
    box_slabs_robust_clip(&interval, in->origin.x, in->direction.x, in->low.x, in->high.x);
    box_slabs_robust_clip(&interval, in->origin.y, in->direction.y, in->low.y, in->high.y);
    box_slabs_robust_clip(&interval, in->origin.z, in->direction.z, in->low.z, in->high.z);
    *(BoxOutput *)output = box_output_of(interval);
}

const Method box_slabs_robust = {.group = "box-slabs",
                                 .name = "far(1+2g3)",
                                 .label = "far(1+2g3)",
                                 .input_count = NUMBERS_IN(BoxInput),
                                 .output_count = NUMBERS_IN(BoxOutput),
                                 .run = box_slabs_robust_run};

const Method box_cube_slabs = {.group = "box-cube",
                               .name = "slabs",
                               .label = "slabs",
                               .input_count = NUMBERS_IN(BoxInput),
                               .output_count = NUMBERS_IN(BoxOutput),
                               .run = box_slabs_robust_run};
