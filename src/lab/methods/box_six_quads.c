/**
 * @file
 * @brief A cube as six quads: reports C's and D's way (rows C1, D1).
 *
 * Each quad decides by its own rounded point whether it is met. At an edge both neighbours may say
 * no, and the ray leaks, or both yes.
 */
#include "lab/methods/box.h"

/** A face of a box, its own axis first: the others follow in a circle. */
typedef struct BoxFace {
    real origin[3];    /**< Where the ray starts. */
    real direction[3]; /**< Which way. */
    real low[3];       /**< Lowest corner of the box. */
    real high[3];      /**< Highest corner. */
} BoxFace;

/** Asks a face. @param plane Where it is along its axis. */
static void box_face_intersect(const BoxFace *face, real plane, BoxOutput *out) {
    real t = (plane - face->origin[0]) / face->direction[0];
    real u = face->origin[1] + face->direction[1] * t;
    real v = face->origin[2] + face->direction[2] * t;
    int is_inside =
        u >= face->low[1] && u <= face->high[1] && v >= face->low[2] && v <= face->high[2];
    if (is_inside && t > 0) {
        out->count += 1;
        out->distance = real_min(t, out->distance);
    }
}

/** Asks it. See #Method.run. */
static void box_six_quads_run(const void *input, void *output) {
    const BoxInput *in = input;
    const Vec3 *o = &in->origin, *d = &in->direction, *low = &in->low, *high = &in->high;
    const BoxFace faces[] = {{{o->x, o->y, o->z},
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
    BoxOutput *out = output;
    *out = (BoxOutput){.distance = INFINITE};
    for (int i = 0; i < 3; i++) {
        box_face_intersect(&faces[i], faces[i].low[0], out);
        box_face_intersect(&faces[i], faces[i].high[0], out);
    }
}

const Method box_six_quads = {.group = "box-cube",
                              .name = "six quads",
                              .label = "six quads",
                              .input_count = NUMBERS_IN(BoxInput),
                              .output_count = NUMBERS_IN(BoxOutput),
                              .run = box_six_quads_run};
