/**
 * @file
 * @brief Distance fields that are made of numbers: their keywords and their steps.
 */
#include "dioptre/sdf.h"

/** Largest part of an edge of a sponge's holes that is still told apart: 3^-12. */
enum { MENGER_ITERATIONS_MAXIMUM = 12 };

/** Orbits beyond this distance never return, for every power from 2 on. */
#define BAILOUT_RADIUS 2.0

/**
 * Makes a field of one step.
 * @param is_exact  Whether it is exact.
 * @param half_size  Half the edges of the box around its solid, whose middle is at zero.
 */
static void sdf_from_primitive(Sdf *sdf, bool is_exact, const SdfNode *node, Vec3d half_size) {
    *sdf = (Sdf){.is_exact = is_exact,
                 .bound_slack = 1,
                 .low = vec3d_scale(half_size, -1),
                 .high = half_size,
                 .node_count = 1};
    sdf->nodes[0] = *node;
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
typedef struct SdfSphereParameters {
    double radius; /**< Its radius. */
} SdfSphereParameters;

/** Makes a ball. See #SdfPrimitive.create. */
static void sdf_sphere_create(Sdf *sdf, const void *values) {
    double r = ((const SdfSphereParameters *)values)->radius;
    sdf_from_primitive(sdf, true, &(SdfNode){SDF_SPHERE, 0, {r}}, (Vec3d){r, r, r});
}

/** `distance.sphere` */
static const SdfPrimitive sdf_sphere = {
    .keyword = {.name = "distance.sphere",
                .help = "a ball around zero",
                .parameters = (const Parameter[]){{.name = "radius",
                                                   LENGTH_ROW,
                                                   .offset = offsetof(SdfSphereParameters, radius),
                                                   .help = "its radius"},
                                                  {0}},
                .size = sizeof(SdfSphereParameters),
                .defaults = &(const SdfSphereParameters){1}},
    .create = sdf_sphere_create};

/** What a scene file says of a box, or of a frame. */
typedef struct SdfBoxParameters {
    Vec3d size;  /**< Its edges. */
    double edge; /**< Of a frame: how thick its bars are. */
} SdfBoxParameters;

/** Makes a box. See #SdfPrimitive.create. */
static void sdf_box_create(Sdf *sdf, const void *values) {
    Vec3d h = vec3d_scale(((const SdfBoxParameters *)values)->size, 0.5);
    sdf_from_primitive(sdf, true, &(SdfNode){SDF_BOX, 0, {h.x, h.y, h.z}}, h);
}

/** `distance.box` */
static const SdfPrimitive sdf_box = {
    .keyword = {.name = "distance.box",
                .help = "a box around zero",
                .parameters = (const Parameter[]){{.name = "size",
                                                   EDGES_ROW,
                                                   .offset = offsetof(SdfBoxParameters, size),
                                                   .help = "its whole edges"},
                                                  {0}},
                .size = sizeof(SdfBoxParameters),
                .defaults = &(const SdfBoxParameters){.size = {1, 1, 1}}},
    .create = sdf_box_create};

/** Refuses bars that are thicker than the frame. See #Keyword.finish. @return Whether they fit. */
static bool sdf_box_frame_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const SdfBoxParameters *frame = values;
    double least = fmin(frame->size.x, fmin(frame->size.y, frame->size.z));
    return frame->edge <= least ||
           error_set(error, STATUS_SCENE, "edge must not be thicker than the frame: %g is above %g",
                     frame->edge, least);
}

/** Makes a frame. See #SdfPrimitive.create. */
static void sdf_box_frame_create(Sdf *sdf, const void *values) {
    const SdfBoxParameters *frame = values;
    Vec3d h = vec3d_scale(frame->size, 0.5);
    SdfNode node = {SDF_BOX_FRAME, 0, {h.x, h.y, h.z, 0.5 * frame->edge}};
    sdf_from_primitive(sdf, true, &node, h);
}

/** `distance.box_frame` */
static const SdfPrimitive sdf_box_frame = {
    .keyword = {.name = "distance.box_frame",
                .help = "the edges of a box around zero, as bars",
                .parameters = (const Parameter[]){{.name = "size",
                                                   EDGES_ROW,
                                                   .offset = offsetof(SdfBoxParameters, size),
                                                   .help = "the box's whole edges"},
                                                  {.name = "edge",
                                                   LENGTH_ROW,
                                                   .offset = offsetof(SdfBoxParameters, edge),
                                                   .help = "how thick the bars are"},
                                                  {0}},
                .size = sizeof(SdfBoxParameters),
                .defaults = &(const SdfBoxParameters){.size = {1, 1, 1}, .edge = 0.1},
                .finish = sdf_box_frame_finish},
    .create = sdf_box_frame_create};

/** What a scene file says of a ring. */
typedef struct SdfTorusParameters {
    double major; /**< From zero to the middle of the tube. */
    double minor; /**< Radius of the tube. */
} SdfTorusParameters;

/** Refuses rings without a hole. See #Keyword.finish. @return Whether it has one. */
static bool sdf_torus_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const SdfTorusParameters *torus = values;
    return torus->minor <= torus->major ||
           error_set(error, STATUS_SCENE, "minor must not be larger than major: %g is above %g",
                     torus->minor, torus->major);
}

/** Makes a ring. See #SdfPrimitive.create. */
static void sdf_torus_create(Sdf *sdf, const void *values) {
    const SdfTorusParameters *torus = values;
    double outer = torus->major + torus->minor;
    SdfNode node = {SDF_TORUS, 0, {torus->major, torus->minor}};
    sdf_from_primitive(sdf, true, &node, (Vec3d){outer, torus->minor, outer});
}

/** `distance.torus` */
static const SdfPrimitive sdf_torus = {
    .keyword = {.name = "distance.torus",
                .help = "a ring around the y axis",
                .parameters = (const Parameter[]){{.name = "major",
                                                   LENGTH_ROW,
                                                   .offset = offsetof(SdfTorusParameters, major),
                                                   .help = "from zero to the middle of its tube"},
                                                  {.name = "minor",
                                                   LENGTH_ROW,
                                                   .offset = offsetof(SdfTorusParameters, minor),
                                                   .help = "radius of its tube"},
                                                  {0}},
                .size = sizeof(SdfTorusParameters),
                .defaults = &(const SdfTorusParameters){1, 0.2},
                .finish = sdf_torus_finish},
    .create = sdf_torus_create};

/** What a scene file says of a sponge. */
typedef struct SdfMengerParameters {
    double size;    /**< Its edge. */
    int iterations; /**< How often holes are cut. */
} SdfMengerParameters;

/** Makes a sponge. See #SdfPrimitive.create. */
static void sdf_menger_create(Sdf *sdf, const void *values) {
    const SdfMengerParameters *menger = values;
    double h = 0.5 * menger->size;
    SdfNode node = {SDF_MENGER, 0, {h, menger->iterations}};
    sdf_from_primitive(sdf, false, &node, (Vec3d){h, h, h});
}

/** `distance.menger` */
static const SdfPrimitive sdf_menger = {
    .keyword = {.name = "distance.menger",
                .help = "a Menger sponge around zero",
                .parameters =
                    (const Parameter[]){{.name = "size",
                                         LENGTH_ROW,
                                         .offset = offsetof(SdfMengerParameters, size),
                                         .help = "its edge"},
                                        {.name = "iterations",
                                         .type = PARAMETER_INTEGER,
                                         .offset = offsetof(SdfMengerParameters, iterations),
                                         .minimum = 0,
                                         .maximum = MENGER_ITERATIONS_MAXIMUM,
                                         .unit = "times",
                                         .help = "how often holes are cut, each a third as wide"},
                                        {0}},
                .size = sizeof(SdfMengerParameters),
                .defaults = &(const SdfMengerParameters){1, 4}},
    .create = sdf_menger_create};

/** What a scene file says of a Mandelbulb. */
typedef struct SdfMandelbulbParameters {
    int power;      /**< Of its formula. */
    int iterations; /**< How often the formula is applied. */
} SdfMandelbulbParameters;

/** @return Beyond this distance no point is in a Mandelbulb: its second iterate, at least r^n - r
 *  away from zero, is beyond #BAILOUT_RADIUS. */
static double mandelbulb_bounding_radius(int power) {
    double low = 1, high = BAILOUT_RADIUS;
    for (int i = 0; i < 60; i++) {
        double r = 0.5 * (low + high);
        *(pow(r, power) - r > BAILOUT_RADIUS ? &high : &low) = r;
    }
    return high;
}

/**
 * Makes a Mandelbulb: the points c from which z^n + c stays near zero. Its distance is estimated by
 * the potential, log |z| |z| / |z'|, times a factor: the derivative is one number and not a matrix,
 * and near the poles it is too small. So the estimate is a bound up to four iterations only.
 * Numbers: power, iterations, the ball around it, the factor, the radius where orbits are given up,
 * and log 2 / n^iterations, the potential of its surface.
 */
static void sdf_mandelbulb_create(Sdf *sdf, const void *values) {
    /** Half of the usual one; how often it is too much is tested (tests/test_sdf_functions.c). */
    const double factor = 0.25;
    /** Its power of n is still a float. */
    const double overflow = 0x1p100;
    const SdfMandelbulbParameters *bulb = values;
    int n = bulb->power;
    double r = bulb->iterations > 1 ? mandelbulb_bounding_radius(n) : BAILOUT_RADIUS;
    double escape = fmin(256, pow(overflow, 1.0 / n));
    double rest = log(BAILOUT_RADIUS) / pow(n, bulb->iterations - 1);
    SdfNode node = {SDF_MANDELBULB, 0, {n, bulb->iterations, r, factor, escape, rest}};
    sdf_from_primitive(sdf, false, &node, (Vec3d){r, r, r});
}

/** `distance.mandelbulb` */
static const SdfPrimitive sdf_mandelbulb = {
    .keyword = {.name = "distance.mandelbulb",
                .help = "a Mandelbulb around zero, its poles on the y axis",
                .parameters =
                    (const Parameter[]){{.name = "power",
                                         .type = PARAMETER_INTEGER,
                                         .offset = offsetof(SdfMandelbulbParameters, power),
                                         .minimum = 2,
                                         .maximum = 16,
                                         .unit = "exponent",
                                         .help = "of its formula"},
                                        {.name = "iterations",
                                         .type = PARAMETER_INTEGER,
                                         .offset = offsetof(SdfMandelbulbParameters, iterations),
                                         .minimum = 1,
                                         .maximum = 32,
                                         .unit = "times",
                                         .help = "how often the formula is applied"},
                                        {0}},
                .size = sizeof(SdfMandelbulbParameters),
                .defaults = &(const SdfMandelbulbParameters){8, 8}},
    .create = sdf_mandelbulb_create};

const SdfPrimitive *const sdf_primitives[] = {
    &sdf_sphere, &sdf_box, &sdf_box_frame, &sdf_torus, &sdf_menger, &sdf_mandelbulb, NULL};
