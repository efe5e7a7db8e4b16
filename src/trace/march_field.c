/**
 * @file
 * @brief Marching: how a field is made ready for rays. What it is placed by, and how it is
 *        repeated, is taken off its tape: a ray is brought to the tape once, and not at each step.
 */
#include "trace/march.h"

/** A tape that is taken apart from its beginning. */
typedef struct Peeling {
    const Field *field; /**< The field. */
    int at;             /**< The first step that is left. */
    Vector3 low;        /**< Lowest corner of a box around the solid of what is left. */
    Vector3 high;       /**< Highest corner. */
} Peeling;

/** @return The first step that is left, if it is of a kind and all others are its body; else NULL.
 *  @param peeling What is left. @param operation The kind. */
static const FieldStep *peeling_step(const Peeling *peeling, FieldOperation operation) {
    const FieldStep *step = &peeling->field->steps[peeling->at];
    bool is_whole =
        step->operation == operation && step->body == peeling->field->count - peeling->at - 1;
    return is_whole ? step : NULL;
}

/** Goes on to the body of a step. @param[in,out] peeling What is left. @param box Six numbers of
 *  the step: the box of its body. */
static void peeling_open(Peeling *peeling, const double *box) {
    peeling->at++;
    peeling->low = (Vector3){box[0], box[1], box[2]};
    peeling->high = (Vector3){box[3], box[4], box[5]};
}

/** @return Where what is left stands; it is taken off. @param[in,out] peeling What is left. */
static Placing peeling_place(Peeling *peeling) {
    Placing placing = placing_none();
    const FieldStep *step;
    while ((step = peeling_step(peeling, FIELD_PLACE))) {
        placing_append(&placing, step->numbers);
        peeling_open(peeling, step->numbers + 13);
    }
    return placing;
}

/** @return Whether copies stay within their cells. @param numbers Those of a #FIELD_REPEAT step. */
static bool copies_stay(const double *numbers) {
    bool stays = true;
    for (int axis = 0; axis < 3; axis++) {
        double half = 0.5 * numbers[axis], reach = fmax(-numbers[12 + axis], numbers[15 + axis]);
        stays = stays && (numbers[axis] == 0 || reach <= half);
    }
    return stays;
}

/** @return How what is left is repeated; it is taken off where copies stay within their cells.
 *  @param[in,out] peeling What is left. */
static Lattice peeling_repeat(Peeling *peeling) {
    Lattice lattice = {.is_any = false};
    const FieldStep *step = peeling_step(peeling, FIELD_REPEAT);
    if (!step || !copies_stay(step->numbers)) {
        return lattice;
    }
    lattice.is_any = true;
    for (int axis = 0; axis < 3; axis++) {
        lattice.period[axis] = (scalar)step->numbers[axis];
        lattice.half[axis] = (scalar)step->numbers[3 + axis];
        lattice.limit[axis] = (scalar)step->numbers[6 + axis];
    }
    peeling_open(peeling, step->numbers + 12);
    return lattice;
}

/** Puts a ball around the copies of a lattice. @param[in,out] lattice The lattice. @param inner
 *  Where copies stand. @param low Lowest corner of the copy's box. @param high Highest. */
static void lattice_measure(Lattice *lattice, const Placing *inner, Vector3 low, Vector3 high) {
    Vector3 half = vector3_scale(vector3_subtract(high, low), 0.5);
    double radius = vector3_length(half) * (double)inner->scale;
    lattice->radius = INFINITE;
    if (radius < HUGE_VAL) {
        WidePoint middle = wide_point_of(vector3_add(low, half)), zero = {0, 0, 0};
        WidePoint back = wide_point_subtract(zero, placing_turn_back_one(inner, middle));
        lattice->middle = point_narrow(wide_point_subtract(inner->move, back));
        lattice->radius = (scalar)radius;
    }
}

/** @return The largest coordinate of a box that ends. @param box The box. */
static scalar bounds_reach(const Bounds *box) {
    scalar reach = 0;
    for (int axis = 0; axis < 3; axis++) {
        reach = box->high[axis] < INFINITE && box->high[axis] > reach ? box->high[axis] : reach;
        reach = -box->low[axis] < INFINITE && -box->low[axis] > reach ? -box->low[axis] : reach;
    }
    return reach;
}

/** @return A box moved out on all sides. @param box The box. @param by How far. */
static Bounds bounds_grown(Bounds box, scalar by) {
    for (int axis = 0; axis < 3; axis++) {
        box.low[axis] -= by;
        box.high[axis] += by;
    }
    return box;
}

/** @return A box for each lane. @param box The box. */
static BoundsBlock bounds_block(Bounds box) {
    BoundsBlock block;
    for (int axis = 0; axis < 3; axis++) {
        block.planes[axis] = real_of(box.low[axis]);
        block.planes[axis + 3] = real_of(box.high[axis]);
    }
    return block;
}

void marching_init(Marching *marching, const Field *field, Bounds *bounds) {
    Peeling peeling = {field, 0, field->low, field->high};
    *bounds = bounds_around(field->low, field->high);
    scalar roundings = FIELD_ERROR * ROUNDOFF * bounds_reach(bounds);
    marching->tolerance = marching->tolerance > roundings ? marching->tolerance : roundings;
    // So much larger than the field's that where a ray enters a box is outside.
    scalar margin = ERROR_TOLERANCES * (scalar)field->slack * marching->tolerance;
    *bounds = bounds_grown(*bounds, margin);
    marching->outer = peeling_place(&peeling);
    scalar scale = (scalar)marching->outer.scale;
    Bounds all = bounds_around(peeling.low, peeling.high);
    marching->around = bounds_block(bounds_grown(all, margin / scale));
    marching->lattice = peeling_repeat(&peeling);
    marching->inner = placing_none();
    if (marching->lattice.is_any) {
        marching->inner = peeling_place(&peeling);
        lattice_measure(&marching->lattice, &marching->inner, peeling.low, peeling.high);
    }
    marching->scale = scale * (scalar)marching->inner.scale;
    Bounds one = bounds_around(peeling.low, peeling.high);
    marching->box = bounds_block(bounds_grown(one, margin / marching->scale));
    marching->slack = (scalar)field->slack;
    field_code(marching->codes, field);
    marching->codes += peeling.at;
    marching->count = field->count - peeling.at;
}

