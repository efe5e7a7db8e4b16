/**
 * @file
 * @brief What the steps of distance fields do.
 *
 * A lane's answer never depends on the other lanes: what a step leaves out for want of a lane that
 * needs it changes no lane.
 */
#include "trace/field_machine.h"

/** Runs steps one after the other. @param machine What they work on. @param codes The steps.
 *  @param count How many. */
static void field_run(FieldMachine *machine, const FieldCode *codes, int count) {
    for (const FieldCode *code = codes; code < codes + count; code += 1 + code->body) {
        code->run(machine, code);
    }
}

/* --- operations on one field ------------------------------------------------------------------ */

/** Moves the surface outwards. See #FieldCode.run. @param m See there. @param code See there. */
static void round_run(FieldMachine *m, const FieldCode *code) {
    m->sample.distance = m->sample.distance - code->numbers[0];
}

/** @return Three rows of a matrix with a vector. @param rows The matrix. @param v Vectors. */
INLINE Vector rows_apply(const scalar *rows, Vector v) {
    return (Vector){rows[0] * v.x + rows[1] * v.y + rows[2] * v.z,
                    rows[3] * v.x + rows[4] * v.y + rows[5] * v.z,
                    rows[6] * v.x + rows[7] * v.y + rows[8] * v.z};
}

/** @return The same with its columns. @param rows The matrix. @param v Vectors. */
INLINE Vector columns_apply(const scalar *rows, Vector v) {
    return (Vector){rows[0] * v.x + rows[3] * v.y + rows[6] * v.z,
                    rows[1] * v.x + rows[4] * v.y + rows[7] * v.z,
                    rows[2] * v.x + rows[5] * v.y + rows[8] * v.z};
}

/** Scales, turns and moves: the point goes the other way. See #FieldCode.run. @param m See there.
 *  @param code See there. */
static void place_run(FieldMachine *m, const FieldCode *code) {
    const Vector outside = m->point;
    const scalar *n = code->numbers;
    m->point = rows_apply(n, vector_subtract(outside, vector_from(n + 9)));
    field_run(m, code + 1, code->body);
    m->point = outside;
    m->sample.distance = m->sample.distance * n[12];
    if (m->derives) {
        m->sample.gradient = vector_scale(columns_apply(n, m->sample.gradient), real_of(n[12]));
    }
}

/**
 * @return How far points are beside a box, along the axis where it is most; negative inside.
 * @param corners  The box: three lowest coordinates, three highest.
 * @param p        Points.
 */
INLINE real box_beside(const scalar *corners, Vector p) {
    real x = real_max(corners[0] - p.x, p.x - corners[3]);
    real y = real_max(corners[1] - p.y, p.y - corners[4]);
    real z = real_max(corners[2] - p.z, p.z - corners[5]);
    return real_max(x, real_max(y, z));
}

/** @return Distances that are at least those to the field's box: both are bounds of it.
 *  @param distance Distances. @param beside What box_beside() says. */
INLINE real at_least_beside(real distance, real beside) {
    return real_select(beside > 0, real_max(distance, beside), distance);
}

/** The cells of a repeated field around LANES points, along one axis. */
typedef struct Cells {
    real own;    /**< Number of the cell that each is in. */
    real side;   /**< 1 or -1: on which side of its middle. */
    real period; /**< From one to the next; 0: there is one only. */
    real limit;  /**< Number of the last one. */
    int count;   /**< How many are to be asked. */
} Cells;

/** @return The cells around points. @param x Coordinates. @param numbers Those of the step for
 *  this axis: every third. */
INLINE Cells cells_of(real x, const scalar *numbers) {
    real half = real_of(numbers[3]), limit = real_of(numbers[6]);
    if (!(numbers[0] > 0)) {
        return (Cells){real_of(0), real_of(1), real_of(0), real_of(0), 1};
    }
    real own = real_floor(x / real_of(numbers[0]) + ((scalar)0.5f - half)) + half;
    own = real_max(-limit, real_min(own, limit));
    return (Cells){own, sign_of(x - own * numbers[0]), real_of(numbers[0]), limit,
                   1 + (int)numbers[9]};
}

/** @return Coordinates as seen from a cell. @param cells The cells. @param x Coordinates.
 *  @param which 0: the own one, 1: the nearer neighbour, 2: the farther. */
INLINE real cell_local(const Cells *cells, real x, int which) {
    const scalar steps[3] = {0, 1, -1};
    real number = cells->own + cells->side * steps[which];
    number = real_max(-cells->limit, real_min(number, cells->limit));
    return x - number * cells->period;
}

/**
 * Takes a copy of a repeated field into account, if it can be nearer than those so far.
 * @param m        The machine, at the copy's own point.
 * @param code     The step.
 * @param nearest  The nearest so far.
 */
INLINE void copy_run(FieldMachine *m, const FieldCode *code, FieldSample *nearest) {
    const mask all = m->active;
    real beside = box_beside(code->numbers + 12, m->point);
    m->active = all & mask_not((beside > 0) & (beside >= nearest->distance));
    if (any(m->active)) {
        field_run(m, code + 1, code->body);
        real distance = at_least_beside(m->sample.distance, beside);
        mask is_nearer = m->active & (distance < nearest->distance);
        nearest->distance = real_select(is_nearer, distance, nearest->distance);
        if (m->derives) {
            nearest->gradient = vector_select(is_nearer, m->sample.gradient, nearest->gradient);
        }
    }
    m->active = all;
}

/** Repeats a field: the nearest of the copies in the cells around. See #FieldCode.run. @param m See
 *  there. @param code See there. */
static void repeat_run(FieldMachine *m, const FieldCode *code) {
    const Vector p = m->point;
    const real none = real_of(0);
    Cells x = cells_of(p.x, code->numbers), y = cells_of(p.y, code->numbers + 1),
          z = cells_of(p.z, code->numbers + 2);
    FieldSample nearest = {real_of(INFINITE), {none, none, none}};
    for (int i = 0; i < x.count * y.count * z.count; i++) {
        m->point =
            (Vector){cell_local(&x, p.x, i % x.count), cell_local(&y, p.y, i / x.count % y.count),
                     cell_local(&z, p.z, i / x.count / y.count)};
        copy_run(m, code, &nearest);
    }
    m->point = p;
    m->sample = nearest;
}

/* --- operations on two fields ----------------------------------------------------------------- */

/**
 * Runs a body only where it can change something.
 * @param m        The machine.
 * @param code     The step.
 * @param[in,out] matters  Lanes where it may; afterwards those that count.
 * @param beside   How far the points are beside its box.
 * @param[out] body  What it says.
 * @return Whether it was run.
 */
INLINE bool body_run(FieldMachine *m, const FieldCode *code, mask *matters, real beside,
                     FieldSample *body) {
    const mask all = m->active;
    *matters = *matters & all;
    if (!any(*matters)) {
        return false;
    }
    m->active = *matters;
    field_run(m, code + 1, code->body);
    m->active = all;
    *body = m->sample;
    body->distance = at_least_beside(body->distance, beside);
    return true;
}

/** The nearer of two fields. See #FieldCode.run. @param m See there. @param code See there. */
static void union_run(FieldMachine *m, const FieldCode *code) {
    FieldSample first = m->sample, second;
    real beside = box_beside(code->numbers, m->point);
    mask matters = mask_not((beside > 0) & (beside >= first.distance));
    if (body_run(m, code, &matters, beside, &second)) {
        second.distance = real_select(matters, second.distance, first.distance);
        second = sample_nearer(first, second, m->derives);
    } else {
        second = first;
    }
    m->sample = second;
}

/** The nearer of two fields, whose seam is filled. See #FieldCode.run. @param m See there.
 *  @param code See there. */
static void smooth_union_run(FieldMachine *m, const FieldCode *code) {
    FieldSample first = m->sample, second;
    const real radius = real_of(code->numbers[6]), zero = real_of(0);
    real beside = box_beside(code->numbers, m->point);
    mask matters = mask_not((beside > 0) & (beside >= first.distance + radius));
    if (!body_run(m, code, &matters, beside, &second)) {
        m->sample = first;
        return;
    }
    real apart = real_abs(first.distance - second.distance);
    real share = real_max(radius - apart, zero) / radius;
    FieldSample melted = sample_nearer(first, second, m->derives);
    melted.distance = melted.distance - share * share * radius * (scalar)0.25f;
    if (m->derives) {
        // The farther one has half the share.
        mask is_second = second.distance < first.distance;
        Vector far = vector_select(is_second, first.gradient, second.gradient);
        Vector near = vector_scale(melted.gradient, 1 - (scalar)0.5f * share);
        melted.gradient = vector_add(near, vector_scale(far, (scalar)0.5f * share));
    }
    m->sample.distance = real_select(matters, melted.distance, first.distance);
    if (m->derives) {
        m->sample.gradient = vector_select(matters, melted.gradient, first.gradient);
    }
}

/** @return The farther of two samples. @param a A sample. @param b Another. @param derives Whether
 *  gradients are wanted. */
INLINE FieldSample sample_farther(FieldSample a, FieldSample b, bool derives) {
    FieldSample farther = {.distance = real_max(b.distance, a.distance)};
    if (derives) {
        farther.gradient = vector_select(b.distance > a.distance, b.gradient, a.gradient);
    }
    return farther;
}

/** What is in both of two fields. See #FieldCode.run. @param m See there. @param code See there. */
static void intersection_run(FieldMachine *m, const FieldCode *code) {
    FieldSample first = m->sample;
    field_run(m, code + 1, code->body);
    m->sample = sample_farther(first, m->sample, m->derives);
}

/** What is in one field and not in the other. See #FieldCode.run. @param m See there.
 *  @param code See there. */
static void difference_run(FieldMachine *m, const FieldCode *code) {
    FieldSample first = m->sample, second;
    real beside = box_beside(code->numbers, m->point);
    mask matters = mask_not((beside > 0) & (first.distance >= -beside));
    if (body_run(m, code, &matters, beside, &second)) {
        second.distance = real_select(matters, -second.distance, first.distance);
        second.gradient = m->derives ? vector_scale(second.gradient, real_of(-1)) : first.gradient;
        first = sample_farther(first, second, m->derives);
    }
    m->sample = first;
}

/* --- tapes ------------------------------------------------------------------------------------ */

void field_code(FieldCode *codes, const Field *field) {
    static void (*const runs[])(FieldMachine *,
                                const FieldCode *) = {[FIELD_SPHERE] = field_sphere_run,
                                                      [FIELD_BOX] = field_box_run,
                                                      [FIELD_BOX_FRAME] = field_box_frame_run,
                                                      [FIELD_TORUS] = field_torus_run,
                                                      [FIELD_MENGER] = field_menger_run,
                                                      [FIELD_MANDELBULB] = field_mandelbulb_run,
                                                      [FIELD_ROUND] = round_run,
                                                      [FIELD_PLACE] = place_run,
                                                      [FIELD_REPEAT] = repeat_run,
                                                      [FIELD_UNION] = union_run,
                                                      [FIELD_SMOOTH_UNION] = smooth_union_run,
                                                      [FIELD_INTERSECTION] = intersection_run,
                                                      [FIELD_DIFFERENCE] = difference_run};
    for (int i = 0; i < field->count; i++) {
        const FieldStep *step = &field->steps[i];
        codes[i].run = runs[step->operation];
        codes[i].body = step->body;
        for (int n = 0; n < FIELD_NUMBERS; n++) {
            codes[i].numbers[n] = (scalar)step->numbers[n];
        }
    }
}

/** @return What a tape says of points. @param codes The tape. @param count How many steps.
 *  @param point The points. @param active The lanes that count. @param derives Whether gradients
 *  are wanted. */
static FieldSample tape_run(const FieldCode *codes, int count, Vector point, mask active,
                            bool derives) {
    const real zero = real_of(0);
    FieldMachine machine = {
        .point = point, .sample = {zero, {zero, zero, zero}}, .active = active, .derives = derives};
    field_run(&machine, codes, count);
    return machine.sample;
}

real field_distance(const FieldCode *codes, int count, Vector point, mask active) {
    return tape_run(codes, count, point, active, false).distance;
}

FieldSample field_sample(const FieldCode *codes, int count, Vector point, mask active) {
    return tape_run(codes, count, point, active, true);
}
