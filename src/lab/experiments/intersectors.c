/**
 * @file
 * @brief Experiments on shapes of shaders from far away: disk, cone, ellipsoid, torus, capsule.
 */
#include "base/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/sample_writer.h"

#include <string.h>

/** Reaches of the shape. */
static const double distances[] = {2, 10, 1e2, 1e3, 1e4};

/** Index of the direction and of the ray's end among the inputs. */
enum { INPUT_DIRECTION = 3, INPUT_SHAPE = 6 };

/** A shape, as the methods take it; all numbers are exact in float. */
typedef struct IntersectorShape {
    const char *family; /**< Whose methods are run. */
    Vec3q a;            /**< Centre, or first end. */
    Vec3q b;            /**< Normal, half-axes or second end. */
    double radii[2];    /**< Its radii. */
    double reach;       /**< No point is farther from #a. */
} IntersectorShape;

/** A disk. */
static const IntersectorShape disk_shape = {"disk", {0, 0, 0}, {0.6015625, 0.796875, 0}, {1, 0}, 1};
/** A cone between two circles. */
static const IntersectorShape cone_shape = {
    "cone", {0, -0.5, 0.25}, {0.25, 0.5, 0}, {0.75, 0.25}, 1.5};
/** An ellipsoid. */
static const IntersectorShape ellipsoid_shape = {"ellipsoid", {0, 0, 0}, {1, 0.5, 0.25}, {0, 0}, 1};
/** A torus. */
static const IntersectorShape torus_shape = {"torus", {0, 0, 0}, {0, 0, 0}, {0.75, 0.25}, 1};
/** A capsule. */
static const IntersectorShape capsule_shape = {
    "capsule", {-0.25, -0.5, 0}, {0.25, 0.5, 0.125}, {0.25, 0}, 1.5};

/**
 * @return The distance by the second method in quad, which starts near the shape.
 * @param inputs  Of the sample. The direction is scaled to length 1, which the methods take for
 *                granted; the distance is in lengths of the one that was given.
 */
static Quadruple intersector_expected(const char *family_name, const Quadruple *inputs) {
    Quadruple exact[METHOD_NUMBERS_MAXIMUM], distance;
    const NumberType *const *widest = number_types();
    while (widest[1]) {
        widest++;
    }
    Vec3q direction = vec3q_from_array(inputs + INPUT_DIRECTION);
    memcpy(exact, inputs, sizeof exact);
    SampleWriter writer = {*widest, exact + INPUT_DIRECTION};
    sample_writer_vec3(&writer, vec3q_normalize(direction));
    const MethodFamily *family = number_type_family(*widest, family_name);
    (*widest)->evaluate(family, family->methods + 1, 1, exact, &distance);
    return distance < QUAD_NO_HIT ? distance / vec3q_length(direction) : QUAD_NO_HIT;
}

/** Generates a ray to a shape, from so many reaches away. */
static void generate_intersector_ray(const ExperimentSetup *setup, const IntersectorShape *shape,
                                     Random *random, ExperimentSample *sample) {
    SampleWriter writer = {setup->type, sample->inputs};
    Vec3q outwards = random_direction(random);
    Vec3q position = vec3q_add(shape->a, vec3q_scale(outwards, shape->reach * setup->level));
    Vec3q origin = sample_writer_vec3(&writer, position);
    Vec3q aim = random_in_disc(random, outwards, shape->reach);
    Vec3q target = vec3q_add(shape->a, aim);
    sample_writer_vec3(&writer, vec3q_normalize(vec3q_subtract(target, origin)));
    sample_writer_vec3(&writer, shape->a);
    sample_writer_vec3(&writer, shape->b);
    sample_writer_number(&writer, shape->radii[0]);
    sample_writer_number(&writer, shape->radii[1]);
    sample_writer_number(&writer, shape->reach);
    sample->expected[0] = intersector_expected(shape->family, sample->inputs);
}

/** Is an #Experiment.create_scene. */
static Scene *scene_disk(const ExperimentSetup *setup, Error *error) {
    (void)setup;
    FixtureValue values[] = {{.name = "center"}, {.name = "normal"}, {"radius", {1}}, {0}};
    vec3q_to_doubles(disk_shape.a, values[0].components);
    vec3q_to_doubles(disk_shape.b, values[1].components);
    return scene_fixture_with_shape("disk", values, error);
}

/** Defines the experiment of a shape. @param words Its title. @param scene Its
 *  #Experiment.create_scene, or NULL. */
#define INTERSECTOR_EXPERIMENT(shape, words, scene)                                                \
    static void generate_##shape(const ExperimentSetup *setup, Random *random,                     \
                                 ExperimentSample *sample) {                                       \
        generate_intersector_ray(setup, &shape##_shape, random, sample);                           \
    }                                                                                              \
    const Experiment shape##_distance_experiment = {                                               \
        .name = #shape "-distance",                                                                \
        .title = words,                                                                            \
        .family = #shape,                                                                          \
        .difficulty = N_("distance / size"),                                                       \
        .error_label = N_("error of the distance t, relative to t"),                               \
        .is_relative = true,                                                                       \
        .levels = distances,                                                                       \
        .level_count = COUNT_OF(distances),                                                        \
        .sample_count = 5000,                                                                      \
        .queries_per_sample = 1,                                                                   \
        .timed_level = 1e2,                                                                        \
        .generate = generate_##shape,                                                              \
        .score_sample = score_expected_distance,                                                   \
        .create_scene = scene,                                                                     \
    };

INTERSECTOR_EXPERIMENT(disk, N_("A disk, seen from far away"), scene_disk)
INTERSECTOR_EXPERIMENT(cone, N_("A cone between two circles, seen from far away"), NULL)
INTERSECTOR_EXPERIMENT(ellipsoid, N_("An ellipsoid, seen from far away"), NULL)
INTERSECTOR_EXPERIMENT(torus, N_("A torus, seen from far away"), NULL)
INTERSECTOR_EXPERIMENT(capsule, N_("A capsule, seen from far away"), NULL)
