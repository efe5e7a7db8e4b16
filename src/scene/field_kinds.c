/**
 * @file
 * @brief Distance fields that are made of numbers: their keywords and their steps.
 */
#include "dioptre/field.h"

/** Largest part of an edge of a sponge's holes that is still told apart: 3^-12. */
enum { MENGER_ITERATIONS_MAXIMUM = 12 };

/** Orbits beyond this distance never return, for every power from 2 on. */
#define ORBIT_RADIUS 2.0

/**
 * Makes a field of one step.
 * @param[out] field  Room for it.
 * @param is_exact    Whether it is exact.
 * @param step        The step.
 * @param reach       Half the edges of the box around its solid, whose middle is at zero.
 */
static void field_single(Field *field, bool is_exact, const FieldStep *step, Vector3 reach) {
    *field = (Field){.is_exact = is_exact,
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

/** Makes a ball. See #FieldKind.make. @param[out] field Room for it. @param values A #SphereField.
 */
static void sphere_make(Field *field, const void *values) {
    double r = ((const SphereField *)values)->radius;
    field_single(field, true, &(FieldStep){FIELD_SPHERE, 0, {r}}, (Vector3){r, r, r});
}

/** `distance.sphere` */
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
    .make = sphere_make};

/** What a scene file says of a box, or of a frame. */
typedef struct BoxField {
    Vector3 size; /**< Its edges. */
    double edge;  /**< Of a frame: how thick its bars are. */
} BoxField;

/** Makes a box. See #FieldKind.make. @param[out] field Room for it. @param values A #BoxField. */
static void box_make(Field *field, const void *values) {
    Vector3 h = vector3_scale(((const BoxField *)values)->size, 0.5);
    field_single(field, true, &(FieldStep){FIELD_BOX, 0, {h.x, h.y, h.z}}, h);
}

/** `distance.box` */
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
    field_single(field, true, &step, h);
}

/** `distance.box_frame` */
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
    field_single(field, true, &step, (Vector3){outer, torus->minor, outer});
}

/** `distance.torus` */
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
    field_single(field, false, &step, (Vector3){h, h, h});
}

/** `distance.menger` */
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
    field_single(field, false, &step, (Vector3){r, r, r});
}

/** `distance.mandelbulb` */
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
