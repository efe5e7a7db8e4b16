/**
 * @file
 * @brief Primitives of distance fields: their keywords and their nodes.
 */
#include "dioptre/sdf.h"

/** Orbits beyond this radius diverge, for every power from 2 on. */
#define BAILOUT_RADIUS 2.0

/**
 * Creates a field of one node.
 * @param[out] sdf   The field.
 * @param is_exact   Whether it is exact.
 * @param node       The node.
 * @param half_size  Half the edges of its bounding box, which is centred at zero.
 */
static void sdf_from_primitive(Sdf *sdf, bool is_exact, const SdfNode *node, Vec3d half_size) {
    *sdf = (Sdf){.is_exact = is_exact,
                 .bound_slack = 1,
                 .low = vec3d_scale(half_size, -1),
                 .high = half_size,
                 .node_count = 1};
    sdf->nodes[0] = *node;
}

/** Range of a radius or an edge. */
#define LENGTH_ROW                                                                                 \
    .type = PARAMETER_NUMBER, .minimum = LENGTH_MINIMUM, .maximum = LENGTH_MAXIMUM,                \
    .unit = "scene units"

/** Range of the edges of a box. */
#define EDGES_ROW                                                                                  \
    .type = PARAMETER_VECTOR, .minimum = LENGTH_MINIMUM, .maximum = LENGTH_MAXIMUM,                \
    .unit = "scene units"

/** Parameters of `distance.sphere`. */
typedef struct SdfSphereParameters {
    double radius; /**< Radius. */
} SdfSphereParameters;

/** Creates a sphere. See #SdfPrimitive.create. */
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

/** Parameters of `distance.box` and `distance.box_frame`. */
typedef struct SdfBoxParameters {
    Vec3d size;  /**< Edges. */
    double edge; /**< Thickness of the edges of a frame. */
} SdfBoxParameters;

/** Creates a box. See #SdfPrimitive.create. */
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

/**
 * Rejects edges thicker than the frame. See #Keyword.finish.
 * @return Whether the thickness is valid.
 */
static bool sdf_box_frame_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const SdfBoxParameters *frame = values;
    double least = fmin(frame->size.x, fmin(frame->size.y, frame->size.z));
    return frame->edge <= least ||
           error_set(error, STATUS_SCENE, "edge must not be thicker than the frame: %g is above %g",
                     frame->edge, least);
}

/** Creates a frame. See #SdfPrimitive.create. */
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

/** Parameters of `distance.torus`. */
typedef struct SdfTorusParameters {
    double major; /**< Major radius, to the centre of the tube. */
    double minor; /**< Minor radius, that of the tube. */
} SdfTorusParameters;

/** Rejects a torus without a hole. See #Keyword.finish. @return Whether it has one. */
static bool sdf_torus_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const SdfTorusParameters *torus = values;
    return torus->minor <= torus->major ||
           error_set(error, STATUS_SCENE, "minor must not be larger than major: %g is above %g",
                     torus->minor, torus->major);
}

/** Creates a torus. See #SdfPrimitive.create. */
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

/** Parameters of `distance.menger`. */
typedef struct SdfMengerParameters {
    double size;    /**< Edge. */
    int iterations; /**< Number of iterations. */
} SdfMengerParameters;

/** Creates a Menger sponge. See #SdfPrimitive.create. */
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
                                         .maximum = SDF_MENGER_ITERATIONS_MAXIMUM,
                                         .unit = "times",
                                         .help = "how often holes are cut, each a third as wide"},
                                        {0}},
                .size = sizeof(SdfMengerParameters),
                .defaults = &(const SdfMengerParameters){1, 4}},
    .create = sdf_menger_create};

/** Parameters of `distance.mandelbulb`. */
typedef struct SdfMandelbulbParameters {
    int power;      /**< Power n. */
    int iterations; /**< Number of iterations. */
} SdfMandelbulbParameters;

/**
 * @return Radius of a sphere around a Mandelbulb. Outside, the second iterate, at least r^n - r
 *         from zero, is beyond #BAILOUT_RADIUS.
 * @param power  The power n.
 */
static double mandelbulb_bounding_radius(int power) {
    double low = 1, high = BAILOUT_RADIUS;
    for (int i = 0; i < 60; i++) {
        double r = 0.5 * (low + high);
        *(pow(r, power) - r > BAILOUT_RADIUS ? &high : &low) = r;
    }
    return high;
}

/**
 * Creates a Mandelbulb: the points c for which z^n + c stays bounded. Its distance is estimated by
 * the potential, log |z| |z| / |z'|, times a factor. The derivative is one number instead of a
 * matrix, and too small near the poles: the estimate is a bound up to four iterations only.
 * Operands: power, iterations, radius of the bounding sphere, factor, bailout radius, and log 2 /
 * n^iterations, the potential of its surface.
 */
static void sdf_mandelbulb_create(Sdf *sdf, const void *values) {
    /** Half the usual factor; tests/test_sdf_functions.c counts where the estimate is too large. */
    const double factor = 0.25;
    /** The n-th power of a radius, of which float holds the square, too, with room for c. */
    const double largest_power = 0x1p62;
    const SdfMandelbulbParameters *bulb = values;
    int n = bulb->power;
    double r = bulb->iterations > 1 ? mandelbulb_bounding_radius(n) : BAILOUT_RADIUS;
    double escape = fmin(256, pow(largest_power, 1.0 / n));
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
                                         .maximum = SDF_BULB_POWER_MAXIMUM,
                                         .unit = "exponent",
                                         .help = "of its formula"},
                                        {.name = "iterations",
                                         .type = PARAMETER_INTEGER,
                                         .offset = offsetof(SdfMandelbulbParameters, iterations),
                                         .minimum = 1,
                                         .maximum = SDF_BULB_ITERATIONS_MAXIMUM,
                                         .unit = "times",
                                         .help = "how often the formula is applied"},
                                        {0}},
                .size = sizeof(SdfMandelbulbParameters),
                .defaults = &(const SdfMandelbulbParameters){8, 8}},
    .create = sdf_mandelbulb_create};

const SdfPrimitive *const sdf_primitives[] = {
    &sdf_sphere, &sdf_box, &sdf_box_frame, &sdf_torus, &sdf_menger, &sdf_mandelbulb, NULL};
