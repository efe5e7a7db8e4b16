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

/** Largest part of an edge of a sponge's holes that is still told apart: 3^-12. */
enum { MENGER_ITERATIONS_MAXIMUM = 12 };

/** Orbits beyond this distance never return, for every power from 2 on. */
#define ORBIT_RADIUS 2.0

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

/* --- those that are made of numbers ----------------------------------------------------------- */

/**
 * Makes a field of one step.
 * @param[out] field  Room for it.
 * @param kind        Its kind.
 * @param step        The step.
 * @param reach       Half the edges of the box around its solid, whose middle is at zero.
 */
static void field_single(Field *field, const FieldKind *kind, const FieldStep *step,
                         Vector3 reach) {
    *field = (Field){.is_exact = kind->is_exact,
                     .slack = 1,
                     .low = vector3_scale(reach, -1),
                     .high = reach,
                     .count = 1};
    field->steps[0] = *step;
}

/** Says what a radius or an edge may be. */
#define LENGTH_ROW                                                                                 \
    .type = PARAMETER_NUMBER, .minimum = LENGTH_MINIMUM, .maximum = LENGTH_MAXIMUM,                \
    .unit = "scene units"

/** Says what the edges of a box may be. */
#define EDGES_ROW                                                                                  \
    .type = PARAMETER_VECTOR, .minimum = LENGTH_MINIMUM, .maximum = LENGTH_MAXIMUM,                \
    .unit = "scene units"

/** What a scene file says of a ball. */
typedef struct SphereField {
    double radius; /**< Its radius. */
} SphereField;

static const FieldKind sphere_kind, box_kind, box_frame_kind, torus_kind, menger_kind,
    mandelbulb_kind;

/** Makes a ball. See #FieldKind.make. @param[out] field Room for it. @param values A #SphereField.
 */
static void sphere_make(Field *field, const void *values) {
    double r = ((const SphereField *)values)->radius;
    field_single(field, &sphere_kind, &(FieldStep){FIELD_SPHERE, 0, {r}}, (Vector3){r, r, r});
}

static const FieldKind sphere_kind = {
    .keyword = {.name = "distance.sphere",
                .help = "a ball around zero",
                .parameters = (const Parameter[]){{.name = "radius",
                                                   LENGTH_ROW,
                                                   .offset = offsetof(SphereField, radius),
                                                   .help = "its radius"},
                                                  {0}},
                .size = sizeof(SphereField),
                .defaults = &(const SphereField){1}},
    .is_exact = true,
    .make = sphere_make};

/** What a scene file says of a box, or of a frame. */
typedef struct BoxField {
    Vector3 size; /**< Its edges. */
    double edge;  /**< Of a frame: how thick its bars are. */
} BoxField;

/** Makes a box. See #FieldKind.make. @param[out] field Room for it. @param values A #BoxField. */
static void box_make(Field *field, const void *values) {
    Vector3 h = vector3_scale(((const BoxField *)values)->size, 0.5);
    field_single(field, &box_kind, &(FieldStep){FIELD_BOX, 0, {h.x, h.y, h.z}}, h);
}

static const FieldKind box_kind = {
    .keyword = {.name = "distance.box",
                .help = "a box around zero",
                .parameters = (const Parameter[]){{.name = "size",
                                                   EDGES_ROW,
                                                   .offset = offsetof(BoxField, size),
                                                   .help = "its whole edges"},
                                                  {0}},
                .size = sizeof(BoxField),
                .defaults = &(const BoxField){.size = {1, 1, 1}}},
    .is_exact = true,
    .make = box_make};

/** Refuses bars that are thicker than the frame. See #Keyword.finish. @param[in,out] values A
 *  #BoxField. @param given Not looked at. @param[out] error What is wrong. @return Whether they
 *  fit. */
static bool box_frame_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const BoxField *frame = values;
    double least = fmin(frame->size.x, fmin(frame->size.y, frame->size.z));
    return frame->edge <= least ||
           error_set(error, STATUS_SCENE, "edge must not be thicker than the frame: %g is above %g",
                     frame->edge, least);
}

/** Makes a frame. See #FieldKind.make. @param[out] field Room for it. @param values A #BoxField. */
static void box_frame_make(Field *field, const void *values) {
    const BoxField *frame = values;
    Vector3 h = vector3_scale(frame->size, 0.5);
    FieldStep step = {FIELD_BOX_FRAME, 0, {h.x, h.y, h.z, 0.5 * frame->edge}};
    field_single(field, &box_frame_kind, &step, h);
}

static const FieldKind box_frame_kind = {
    .keyword = {.name = "distance.box_frame",
                .help = "the edges of a box around zero, as bars",
                .parameters = (const Parameter[]){{.name = "size",
                                                   EDGES_ROW,
                                                   .offset = offsetof(BoxField, size),
                                                   .help = "the box's whole edges"},
                                                  {.name = "edge",
                                                   LENGTH_ROW,
                                                   .offset = offsetof(BoxField, edge),
                                                   .help = "how thick the bars are"},
                                                  {0}},
                .size = sizeof(BoxField),
                .defaults = &(const BoxField){.size = {1, 1, 1}, .edge = 0.1},
                .finish = box_frame_finish},
    .is_exact = true,
    .make = box_frame_make};

/** What a scene file says of a ring. */
typedef struct TorusField {
    double major; /**< From zero to the middle of the tube. */
    double minor; /**< Radius of the tube. */
} TorusField;

/** Refuses rings without a hole. See #Keyword.finish. @param[in,out] values A #TorusField.
 *  @param given Not looked at. @param[out] error What is wrong. @return Whether it has one. */
static bool torus_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const TorusField *torus = values;
    return torus->minor <= torus->major ||
           error_set(error, STATUS_SCENE, "minor must not be larger than major: %g is above %g",
                     torus->minor, torus->major);
}

/** Makes a ring. See #FieldKind.make. @param[out] field Room for it. @param values A #TorusField.
 */
static void torus_make(Field *field, const void *values) {
    const TorusField *torus = values;
    double outer = torus->major + torus->minor;
    FieldStep step = {FIELD_TORUS, 0, {torus->major, torus->minor}};
    field_single(field, &torus_kind, &step, (Vector3){outer, torus->minor, outer});
}

static const FieldKind torus_kind = {
    .keyword = {.name = "distance.torus",
                .help = "a ring around the y axis",
                .parameters = (const Parameter[]){{.name = "major",
                                                   LENGTH_ROW,
                                                   .offset = offsetof(TorusField, major),
                                                   .help = "from zero to the middle of its tube"},
                                                  {.name = "minor",
                                                   LENGTH_ROW,
                                                   .offset = offsetof(TorusField, minor),
                                                   .help = "radius of its tube"},
                                                  {0}},
                .size = sizeof(TorusField),
                .defaults = &(const TorusField){1, 0.2},
                .finish = torus_finish},
    .is_exact = true,
    .make = torus_make};

/** What a scene file says of a sponge. */
typedef struct MengerField {
    double size;    /**< Its edge. */
    int iterations; /**< How often holes are cut. */
} MengerField;

/** Makes a sponge. See #FieldKind.make. @param[out] field Room for it. @param values A
 * #MengerField. */
static void menger_make(Field *field, const void *values) {
    const MengerField *menger = values;
    double h = 0.5 * menger->size;
    FieldStep step = {FIELD_MENGER, 0, {h, menger->iterations}};
    field_single(field, &menger_kind, &step, (Vector3){h, h, h});
}

static const FieldKind menger_kind = {
    .keyword = {.name = "distance.menger",
                .help = "a Menger sponge around zero",
                .parameters =
                    (const Parameter[]){{.name = "size",
                                         LENGTH_ROW,
                                         .offset = offsetof(MengerField, size),
                                         .help = "its edge"},
                                        {.name = "iterations",
                                         .type = PARAMETER_INTEGER,
                                         .offset = offsetof(MengerField, iterations),
                                         .minimum = 0,
                                         .maximum = MENGER_ITERATIONS_MAXIMUM,
                                         .unit = "times",
                                         .help = "how often holes are cut, each a third as wide"},
                                        {0}},
                .size = sizeof(MengerField),
                .defaults = &(const MengerField){1, 4}},
    .make = menger_make};

/** What a scene file says of a Mandelbulb. */
typedef struct MandelbulbField {
    int power;      /**< Of its formula. */
    int iterations; /**< How often the formula is applied. */
} MandelbulbField;

/** @return Beyond this distance no point is in a Mandelbulb: its second iterate, at least r^n - r
 *          away from zero, is beyond #ORBIT_RADIUS. @param power Its power, n. */
static double mandelbulb_reach(int power) {
    double low = 1, high = ORBIT_RADIUS;
    for (int i = 0; i < 60; i++) {
        double r = 0.5 * (low + high);
        *(pow(r, power) - r > ORBIT_RADIUS ? &high : &low) = r;
    }
    return high;
}

/**
 * Makes a Mandelbulb: the points c from which z^n + c stays near zero. Its distance is estimated by
 * the potential, log |z| |z| / |z'|, times a factor: the derivative is one number and not a matrix,
 * and near the poles it is too small. So the estimate is a bound up to four iterations only.
 * Numbers: power, iterations, the ball around it, the factor, the radius where orbits are given up,
 * and log 2 / n^iterations, the potential of its surface.
 * @param[out] field  Room for it.
 * @param values      A #MandelbulbField.
 */
static void mandelbulb_make(Field *field, const void *values) {
    /** Half of the usual one; how often it is too much is tested (tests/test_field.c). */
    const double factor = 0.25;
    /** Its power of n is still a float. */
    const double overflow = 0x1p100;
    const MandelbulbField *bulb = values;
    int n = bulb->power;
    double r = bulb->iterations > 1 ? mandelbulb_reach(n) : ORBIT_RADIUS;
    double escape = fmin(256, pow(overflow, 1.0 / n));
    double rest = log(ORBIT_RADIUS) / pow(n, bulb->iterations - 1);
    FieldStep step = {FIELD_MANDELBULB, 0, {n, bulb->iterations, r, factor, escape, rest}};
    field_single(field, &mandelbulb_kind, &step, (Vector3){r, r, r});
}

static const FieldKind mandelbulb_kind = {
    .keyword = {.name = "distance.mandelbulb",
                .help = "a Mandelbulb around zero, its poles on the y axis",
                .parameters = (const Parameter[]){{.name = "power",
                                                   .type = PARAMETER_INTEGER,
                                                   .offset = offsetof(MandelbulbField, power),
                                                   .minimum = 2,
                                                   .maximum = 16,
                                                   .unit = "exponent",
                                                   .help = "of its formula"},
                                                  {.name = "iterations",
                                                   .type = PARAMETER_INTEGER,
                                                   .offset = offsetof(MandelbulbField, iterations),
                                                   .minimum = 1,
                                                   .maximum = 32,
                                                   .unit = "times",
                                                   .help = "how often the formula is applied"},
                                                  {0}},
                .size = sizeof(MandelbulbField),
                .defaults = &(const MandelbulbField){8, 8}},
    .make = mandelbulb_make};

const FieldKind *const field_kinds[] = {
    &sphere_kind, &box_kind, &box_frame_kind, &torus_kind, &menger_kind, &mandelbulb_kind, NULL};

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
    if (!field_wrap(out, &step, field, error)) {
        return false;
    }
    field_place_box(out, t);
    return true;
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
