/**
 * @file
 * @brief A cube as six quads: reports C's and D's way (rows C1, D1).
 *
 * Each quad decides by its own rounded point whether it is met. At an edge both neighbours may say
 * no, and the ray leaks, or both yes.
 */
#include "lab/methods/box.h"

/** A face of a box, its own axis first: the others follow in a circle. */
typedef struct Face {
    real origin[3];    /**< Where the ray starts. */
    real direction[3]; /**< Which way. */
    real low[3];       /**< Lowest corner of the box. */
    real high[3];      /**< Highest corner. */
} Face;

/** Asks a face. @param face The face. @param at Where it is along its axis. @param[in,out] found
 *  The answer. */
static void meet(const Face *face, real at, BoxAnswer *found) {
    real t = (at - face->origin[0]) / face->direction[0];
    real u = face->origin[1] + face->direction[1] * t;
    real v = face->origin[2] + face->direction[2] * t;
    int is_inside =
        u >= face->low[1] && u <= face->high[1] && v >= face->low[2] && v <= face->high[2];
    if (is_inside && t > 0) {
        found->count += 1;
        found->distance = real_min(t, found->distance);
    }
}

/** Asks it. See #Method.run. @param question A #BoxQuestion. @param[out] answer A #BoxAnswer. */
static void run(const void *question, void *answer) {
    const BoxQuestion *q = question;
    const Vector *o = &q->origin, *d = &q->direction, *low = &q->low, *high = &q->high;
    const Face faces[] = {{{o->x, o->y, o->z},
                           {d->x, d->y, d->z},
                           {low->x, low->y, low->z},
                           {high->x, high->y, high->z}},
                          {{o->y, o->z, o->x},
                           {d->y, d->z, d->x},
                           {low->y, low->z, low->x},
                           {high->y, high->z, high->x}},
                          {{o->z, o->x, o->y},
                           {d->z, d->x, d->y},
                           {low->z, low->x, low->y},
                           {high->z, high->x, high->y}}};
    BoxAnswer *found = answer;
    *found = (BoxAnswer){.distance = INFINITE};
    for (int i = 0; i < 3; i++) {
        meet(&faces[i], faces[i].low[0], found);
        meet(&faces[i], faces[i].high[0], found);
    }
}

const Method box_quads = {.family = "box-cube",
                          .name = "six quads",
                          .label = "six quads",
                          .inputs = NUMBERS_OF(BoxQuestion),
                          .outputs = NUMBERS_OF(BoxAnswer),
                          .run = run};
