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

/** Cuts an interval. @param[in,out] inside The interval. @param origin Of the ray, along an axis.
 *  @param direction Of the ray. @param low Where the slab begins. @param high Where it ends. */
static void cut(Slab *inside, real origin, real direction, real low, real high) {
    real inverse = 1 / direction;
    real enter = ((inverse < 0 ? high : low) - origin) * inverse;
    real leave = ((inverse < 0 ? low : high) - origin) * inverse;
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

const Method box_slabs_dropping = {.family = "box-slabs",
                                   .name = "NaN drops out",
                                   .label = "NaN drops out",
                                   .inputs = NUMBERS_OF(BoxQuestion),
                                   .outputs = NUMBERS_OF(BoxAnswer),
                                   .run = run};
