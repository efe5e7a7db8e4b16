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

/** Cuts an interval. @param[in,out] inside The interval. @param origin Of the ray, along an axis.
 *  @param direction Of the ray. @param low Where the slab begins. @param high Where it ends.
 *  @return Whether anything is left. */
static int cut(Slab *inside, real origin, real direction, real low, real high) {
    real t1 = (low - origin) / direction, t2 = (high - origin) / direction;
    real near = t1 <= t2 ? t1 : t2, far = t1 <= t2 ? t2 : t1;
    inside->near = near <= inside->near ? inside->near : near;
    inside->far = far >= inside->far ? inside->far : far;
    return inside->near <= inside->far;
}

/** Asks it. See #Method.run. @param question A #BoxQuestion. @param[out] answer A #BoxAnswer. */
static void run(const void *question, void *answer) {
    const BoxQuestion *q = question;
    Slab inside = {-INFINITE, INFINITE};
    int is_met = cut(&inside, q->origin.x, q->direction.x, q->low.x, q->high.x) &&
                 cut(&inside, q->origin.y, q->direction.y, q->low.y, q->high.y) &&
                 cut(&inside, q->origin.z, q->direction.z, q->low.z, q->high.z);
    *(BoxAnswer *)answer = is_met ? box_answer(inside) : (BoxAnswer){.distance = INFINITE};
}

const Method box_slabs_rejecting = {.family = "box-slabs",
                                    .name = "NaN misses",
                                    .label = "NaN misses",
                                    .inputs = NUMBERS_OF(BoxQuestion),
                                    .outputs = NUMBERS_OF(BoxAnswer),
                                    .run = run};
