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

/** Cuts an interval. @param[in,out] inside The interval. @param origin Of the ray, along an axis.
 *  @param direction Of the ray. @param low Where the slab begins. @param high Where it ends. */
static void cut(Slab *inside, real origin, real direction, real low, real high) {
    const real gamma = 3 * ROUNDOFF / (1 - 3 * ROUNDOFF);
    real inverse = 1 / direction;
    real enter = ((inverse < 0 ? high : low) - origin) * inverse;
    real leave = ((inverse < 0 ? low : high) - origin) * inverse * (1 + 2 * gamma);
    inside->near = enter > inside->near ? enter : inside->near;
    inside->far = leave < inside->far ? leave : inside->far;
}

/** Asks it. See #Method.run. @param question A #BoxQuestion. @param[out] answer A #BoxAnswer. */
static void run(const void *question, void *answer) {
    const BoxQuestion *q = question;
    Slab inside = {-INFINITE, INFINITE};
    cut(&inside, q->origin.x, q->direction.x, q->low.x, q->high.x);
    cut(&inside, q->origin.y, q->direction.y, q->low.y, q->high.y);
    cut(&inside, q->origin.z, q->direction.z, q->low.z, q->high.z);
    *(BoxAnswer *)answer = box_answer(inside);
}

const Method box_slabs_robust = {.family = "box-slabs",
                                 .name = "far(1+2g3)",
                                 .label = "far(1+2g3)",
                                 .inputs = NUMBERS_OF(BoxQuestion),
                                 .outputs = NUMBERS_OF(BoxAnswer),
                                 .run = run};

const Method box_cube_slabs = {.family = "box-cube",
                               .name = "slabs",
                               .label = "slabs",
                               .inputs = NUMBERS_OF(BoxQuestion),
                               .outputs = NUMBERS_OF(BoxAnswer),
                               .run = run};
