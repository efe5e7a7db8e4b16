/**
 * @file
 * @brief Distance fields: how they are put together, and what is known of them.
 *
 * The primitives, and the operations on them, are those of Inigo Quilez (*Distance functions*);
 * what is exact and what a bound is said in doc/scene-reference.md, and tested.
 */
#include "dioptre/field.h"

#include <string.h>

/** Steps that an operation adds at most for each of its fields. */
enum { STEPS_ADDED = 1 };

size_t field_size(int count) {
    return sizeof(Field) + (size_t)count * sizeof(FieldStep);
}

int field_room(const Field *const *fields, int count) {
    int room = 0;
    for (int i = 0; i < count; i++) {
        room += fields[i]->count + STEPS_ADDED;
    }
    return room;
}

/* --- what methods take ------------------------------------------------------------------------ */

const Parameter field_period_row = {.name = "repeat_every",
                                    .type = PARAMETER_VECTOR,
                                    .minimum = 0,
                                    .maximum = LENGTH_MAXIMUM,
                                    .unit = "scene units",
                                    .help = "from one copy to the next; 0: not repeated"};
const Parameter field_count_row = {.name = "count",
                                   .type = PARAMETER_VECTOR,
                                   .minimum = 0,
                                   .maximum = 1000000,
                                   .unit = "copies",
                                   .help = "how many copies; 0: without end"};
const Parameter field_scale_row = {.name = "scale",
                                   .type = PARAMETER_NUMBER,
                                   .minimum = SCALE_MINIMUM,
                                   .maximum = 1 / SCALE_MINIMUM,
                                   .unit = "times",
                                   .help = "how many times as large"};
const Parameter field_round_row = {.name = "round",
                                   .type = PARAMETER_NUMBER,
                                   .minimum = 0,
                                   .maximum = LENGTH_MAXIMUM,
                                   .unit = "scene units",
                                   .help = "how far the surface is moved outwards"};
const Parameter field_radius_row = {.name = "radius",
                                    .type = PARAMETER_NUMBER,
                                    .minimum = LENGTH_MINIMUM,
                                    .maximum = LENGTH_MAXIMUM,
                                    .unit = "scene units",
                                    .help = "how far from both the seam is filled"};

/* --- how they are put together ---------------------------------------------------------------- */

/**
 * Puts a step and its body behind the steps of a field.
 * @param[in,out] out  The field.
 * @param step         The step; its body is filled in.
 * @param body         The body.
 */
static void field_append(Field *out, const FieldStep *step, const Field *body) {
    FieldStep *at = &out->steps[out->count];
    *at = *step;
    at->body = body->count;
    memcpy(at + 1, body->steps, (size_t)body->count * sizeof *at);
    out->count += body->count + 1;
}

/** Makes a field of a step and its body. @param[out] out Room for it. @param step The step.
 *  @param field The body, of which all else stays as it is. @param[out] error What is wrong.
 *  @return false where it is too long or too deep. */
static bool field_wrap(Field *out, const FieldStep *step, const Field *field, Error *error) {
    *out = *field;
    out->count = 0;
    out->depth = field->depth + 1;
    if (out->depth > FIELD_DEPTH_MAXIMUM) {
        return error_set(error, STATUS_SCENE, "fields stand in fields more than %d deep",
                         FIELD_DEPTH_MAXIMUM);
    }
    if (field->count >= FIELD_STEPS_MAXIMUM) {
        return error_set(error, STATUS_SCENE, "a field may be made of %d at most",
                         FIELD_STEPS_MAXIMUM);
    }
    field_append(out, step, field);
    return true;
}

/** @return A point after a matrix. @param m The matrix. @param p The point. */
static Vector3 linear_apply(const double m[3][3], Vector3 p) {
    return (Vector3){m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z,
                     m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z,
                     m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z};
}

/** Puts a box around a box that was transformed. @param[in,out] field What the box belongs to.
 *  @param t The transform. */
static void field_place_box(Field *field, const Transform *t) {
    Vector3 corners[2] = {field->low, field->high};
    bool is_turned = t->rotate.x != 0 || t->rotate.y != 0 || t->rotate.z != 0;
    if (!is_turned) {
        field->low = vector3_add(vector3_scale(corners[0], t->scale.x), t->translate);
        field->high = vector3_add(vector3_scale(corners[1], t->scale.x), t->translate);
        return;
    }
    field->low = (Vector3){HUGE_VAL, HUGE_VAL, HUGE_VAL};
    field->high = vector3_scale(field->low, -1);
    if (!isfinite(vector3_largest(corners[0])) || !isfinite(vector3_largest(corners[1]))) {
        field->low = field->high;
        field->high = vector3_scale(field->low, -1);
        return;
    }
    for (int i = 0; i < 8; i++) {
        Vector3 corner = {corners[i & 1].x, corners[i >> 1 & 1].y, corners[i >> 2].z};
        corner = vector3_add(linear_apply(t->linear, corner), t->translate);
        field->low = vector3_lowest(field->low, corner);
        field->high = vector3_highest(field->high, corner);
    }
}

/** Refuses what has become too small or too large for the engines' numbers: nothing of it would be
 *  seen. @param field A field. @param[out] error What is wrong. @return Whether it is not. */
static bool field_check_size(const Field *field, Error *error) {
    double reach = fmax(vector3_largest(field->low), vector3_largest(field->high));
    double edge = vector3_largest(vector3_subtract(field->high, field->low));
    return (edge >= LENGTH_MINIMUM && reach <= LENGTH_MAXIMUM) || !isfinite(reach) ||
           error_set(error, STATUS_SCENE,
                     "the field becomes %g long and reaches %g from zero; it must be at least %g "
                     "and at most %g",
                     edge, reach, LENGTH_MINIMUM, LENGTH_MAXIMUM);
}

/** Notes the box of the body of a #FIELD_PLACE step. @param[in,out] step The step. @param low
 * Lowest corner. @param high Highest. */
static void place_box(FieldStep *step, Vector3 low, Vector3 high) {
    const double box[6] = {low.x, low.y, low.z, high.x, high.y, high.z};
    memcpy(step->numbers + 13, box, sizeof box);
}

bool field_place(Field *out, const Field *field, const Transform *t, Error *error) {
    // The inverse of s R is its transpose over s^2.
    double s = t->scale.x, per_square = 1 / (s * s);
    FieldStep step = {.operation = FIELD_PLACE};
    for (int i = 0; i < 9; i++) {
        step.numbers[i] = t->linear[i % 3][i / 3] * per_square;
    }
    step.numbers[9] = t->translate.x;
    step.numbers[10] = t->translate.y;
    step.numbers[11] = t->translate.z;
    step.numbers[12] = s;
    place_box(&step, field->low, field->high);
    if (!field_wrap(out, &step, field, error)) {
        return false;
    }
    field_place_box(out, t);
    return field_check_size(out, error);
}

/** @return Whether a step works on what stands before it and on its body, both where the step
 *          itself stands; its first numbers are the body's box. @param operation The step. */
static bool is_join(FieldOperation operation) {
    return operation == FIELD_UNION || operation == FIELD_SMOOTH_UNION ||
           operation == FIELD_INTERSECTION || operation == FIELD_DIFFERENCE;
}

/** Moves three numbers. @param[in,out] numbers They. @param way How far. */
static void numbers_move(double *numbers, Vector3 way) {
    numbers[0] += way.x;
    numbers[1] += way.y;
    numbers[2] += way.z;
}

/**
 * Puts a step that works on zero behind the steps of a field, as the body of one that moves it.
 * @param[in,out] out  The field.
 * @param step         The step, with its body behind it.
 * @param way          How far.
 */
static void step_place(Field *out, const FieldStep *step, Vector3 way) {
    int size = 1 + step->body;
    out->steps[out->count++] =
        (FieldStep){FIELD_PLACE, size, {1, 0, 0, 0, 1, 0, 0, 0, 1, way.x, way.y, way.z, 1}};
    memcpy(out->steps + out->count, step, (size_t)size * sizeof *step);
    out->count += size;
}

/**
 * Puts steps, moved, behind those of a field.
 * @param[in,out] out  The field.
 * @param steps        The steps.
 * @param count        How many.
 * @param way          How far.
 */
static void steps_move(Field *out, const FieldStep *steps, int count, Vector3 way) {
    for (const FieldStep *step = steps; step < steps + count; step += 1 + step->body) {
        FieldStep *at = &out->steps[out->count];
        if (step->operation == FIELD_PLACE) {
            memcpy(at, step, (size_t)(1 + step->body) * sizeof *step);
            numbers_move(at->numbers + 9, way);
            out->count += 1 + step->body;
        } else if (is_join(step->operation)) {
            *at = *step;
            numbers_move(at->numbers, way);
            numbers_move(at->numbers + 3, way);
            int first = ++out->count;
            steps_move(out, step + 1, step->body, way);
            at->body = out->count - first;
        } else if (step->operation == FIELD_ROUND) {
            out->steps[out->count++] = *step;
        } else {
            step_place(out, step, way);
        }
    }
}

void field_move(Field *out, const Field *field, Vector3 way) {
    *out = *field;
    out->count = 0;
    out->depth = field->depth + 1;
    out->low = vector3_add(field->low, way);
    out->high = vector3_add(field->high, way);
    steps_move(out, field->steps, field->count, way);
    // Only of a step that is all of the field, the box is asked for: that is the field's.
    bool was_placed = field->steps[0].operation == FIELD_PLACE;
    if (!was_placed && out->steps[0].body == out->count - 1) {
        place_box(out->steps, field->low, field->high);
    }
}

/** Moves a box outwards. @param[in,out] field What it belongs to. @param by How far. */
static void field_grow(Field *field, double by) {
    Vector3 outwards = {by, by, by};
    field->low = vector3_subtract(field->low, outwards);
    field->high = vector3_add(field->high, outwards);
}

void field_round(Field *out, const Field *field, double radius) {
    memcpy(out, field, field_size(field->count));
    out->steps[out->count++] = (FieldStep){FIELD_ROUND, 0, {radius}};
    field_grow(out, radius * field->slack);
}

/** How a field is repeated along one axis. */
typedef struct AxisRepeat {
    double period; /**< From one copy to the next; 0: not repeated. */
    double half;   /**< 0.5 where there is a gap in the middle of an even number of copies. */
    double limit;  /**< Number of the last copy, counted from the middle. */
    double reach;  /**< Cells that are asked: 0: its own, 1: the nearer neighbour too, 2: both. */
} AxisRepeat;

/**
 * Repeats along one axis.
 * @param[out] axis   What is needed of it.
 * @param low         Where the field begins; afterwards where all copies begin.
 * @param high        Where it ends.
 * @param period      From one copy to the next.
 * @param count       How many copies; 0: without end.
 * @param is_exact    Whether the field is exact: then the nearer neighbour decides.
 * @param[out] error  What is wrong.
 * @return false where copies overlap more than their neighbours.
 */
static bool axis_repeat(AxisRepeat *axis, double *low, double *high, double period, double count,
                        bool is_exact, Error *error) {
    *axis = (AxisRepeat){0};
    if (period == 0 || count == 1) {
        return true;
    }
    double reach = fmax(-*low, *high);
    if (reach > period) {
        return error_set(error, STATUS_SCENE,
                         "copies every %g overlap more than their neighbours: the field reaches %g "
                         "from zero",
                         period, reach);
    }
    axis->period = period;
    axis->half = count > 0 && fmod(count, 2) == 0 ? 0.5 : 0;
    axis->limit = count > 0 ? 0.5 * (count - 1) : HUGE_VAL;
    axis->reach = reach > 0.5 * period || !is_exact ? 2 : 1;
    *low -= axis->limit * period;
    *high += axis->limit * period;
    return true;
}

bool field_repeat(Field *out, const Field *field, const FieldRepeat *repeat, Error *error) {
    Field box = *field;
    AxisRepeat x, y, z;
    Vector3 p = repeat->period, n = repeat->count, low = field->low, high = field->high;
    if (n.x != floor(n.x) || n.y != floor(n.y) || n.z != floor(n.z)) {
        return error_set(error, STATUS_SCENE, "count must be whole numbers");
    }
    if (!axis_repeat(&x, &box.low.x, &box.high.x, p.x, n.x, field->is_exact, error) ||
        !axis_repeat(&y, &box.low.y, &box.high.y, p.y, n.y, field->is_exact, error) ||
        !axis_repeat(&z, &box.low.z, &box.high.z, p.z, n.z, field->is_exact, error)) {
        return false;
    }
    FieldStep step = {FIELD_REPEAT,
                      0,
                      {x.period, y.period, z.period, x.half, y.half, z.half, x.limit, y.limit,
                       z.limit, x.reach, y.reach, z.reach, low.x, low.y, low.z, high.x, high.y,
                       high.z}};
    if (!field_wrap(out, &step, field, error)) {
        return false;
    }
    out->low = box.low;
    out->high = box.high;
    return true;
}

/** The step of each join. */
static const FieldOperation join_steps[] = {[FIELD_JOIN_UNION] = FIELD_UNION,
                                            [FIELD_JOIN_INTERSECTION] = FIELD_INTERSECTION,
                                            [FIELD_JOIN_DIFFERENCE] = FIELD_DIFFERENCE,
                                            [FIELD_JOIN_SMOOTH] = FIELD_SMOOTH_UNION};

/** Takes what is known of one more field of a union. @param[in,out] out What is known so far.
 *  @param next The field. */
static void unite_box(Field *out, const Field *next) {
    out->low = vector3_lowest(out->low, next->low);
    out->high = vector3_highest(out->high, next->high);
    out->slack = fmax(out->slack, next->slack);
}

/** Takes what is known of one more field of an intersection. @param[in,out] out What is known so
 *  far. @param next The field. @param[out] error What is wrong. @return false where nothing is
 *  left. */
static bool intersect_box(Field *out, const Field *next, Error *error) {
    Vector3 low = out->low = vector3_highest(out->low, next->low);
    Vector3 high = out->high = vector3_lowest(out->high, next->high);
    // A point is beside the common box by at most sqrt(3) times the larger of the two distances.
    out->slack = fmax(out->slack, next->slack) * sqrt(3);
    return (low.x <= high.x && low.y <= high.y && low.z <= high.z) ||
           error_set(error, STATUS_SCENE, "the fields lie apart: there is nothing in all of them");
}

/**
 * Puts one more field to those that were joined so far.
 * @param[in,out] out  Those so far.
 * @param join         How.
 * @param next         The field.
 * @param radius       Of the seam.
 * @param[out] error   What is wrong.
 * @return false where nothing is left.
 */
static bool join_one(Field *out, FieldJoin join, const Field *next, double radius, Error *error) {
    Vector3 low = next->low, high = next->high;
    FieldStep step = {join_steps[join], 0, {low.x, low.y, low.z, high.x, high.y, high.z, radius}};
    field_append(out, &step, next);
    out->depth = out->depth > next->depth ? out->depth : next->depth + 1;
    out->is_exact = join == FIELD_JOIN_UNION && out->is_exact && next->is_exact;
    if (join == FIELD_JOIN_INTERSECTION) {
        return intersect_box(out, next, error);
    }
    if (join != FIELD_JOIN_DIFFERENCE) {
        unite_box(out, next);
    }
    if (join == FIELD_JOIN_SMOOTH) {
        // The seam is filled by at most a quarter of its radius.
        field_grow(out, 0.25 * radius * out->slack);
    }
    return true;
}

/** @return Which of some fields is the deepest. @param fields The fields. @param count How many. */
static int deepest_field(const Field *const *fields, int count) {
    int deepest = 0;
    for (int i = 1; i < count; i++) {
        deepest = fields[i]->depth > fields[deepest]->depth ? i : deepest;
    }
    return deepest;
}

bool field_join(Field *out, FieldJoin join, const Field *const *fields, int count, double radius,
                Error *error) {
    if (field_room(fields, count) > FIELD_STEPS_MAXIMUM) {
        return error_set(error, STATUS_SCENE, "a field may be made of %d at most",
                         FIELD_STEPS_MAXIMUM);
    }
    // The deepest first: a chain of unions, however long, then stays flat.
    int first = join == FIELD_JOIN_DIFFERENCE ? 0 : deepest_field(fields, count);
    memcpy(out, fields[first], field_size(fields[first]->count));
    bool is_joined = true;
    for (int i = 0; i < count && is_joined; i++) {
        is_joined = i == first || join_one(out, join, fields[i], radius, error);
    }
    return is_joined && (out->depth <= FIELD_DEPTH_MAXIMUM ||
                         error_set(error, STATUS_SCENE, "fields stand in fields more than %d deep",
                                   FIELD_DEPTH_MAXIMUM));
}
