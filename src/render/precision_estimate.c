/**
 * @file
 * @brief Forecasting errors from the numbers of a scene.
 *
 * Each cause is a product: half an ulp of float, times how often it happens, times what makes it
 * grow, times how many steps the picture changes with it. The factors were compared with the whole
 * pictures of all scenes (doc/needs.md).
 */
#include "render/precision_estimate.h"

#include "render/shadow_terminator.h"

#include <math.h>
#include <string.h>

/** Half an ulp of 1 in float. */
#define FLOAT_ROUNDOFF 0x1p-24

/** Steps of a picture. */
#define CODE_MAXIMUM 255.0

/** Half ulps that a point may be off, and as far away rays start that leave it. */
#define POSITION_ROUNDINGS 16

/** Half ulps that a direction may be off. */
#define DIRECTION_ROUNDINGS 4

/** Share of a pixel that an edge may be moved by and nobody can tell. */
#define EDGE_TOLERANCE (1.0 / 16)

/** How much farther apart rays go at a curved mirror: four spheres that mirror one another turn
 * them apart by 2.5 in the middle and by 4 in one case of a hundred. */
#define REFLECTION_SPREAD 4

/** The same at a curved surface of glass, which bends less. */
#define REFRACTION_SPREAD 2

/** Steps between neighbouring texels of a picture that is full of detail. */
#define TEXEL_CONTRAST 40.0

/** How much more neighbouring texels differ in pictures of light, which hold the sun itself. */
#define HDR_CONTRAST 4

/** Share of the pixels that may be off. */
#define PIXEL_FRACTION_ALLOWED 1e-4

/** How many times the share of faces in doubt it may become by chance: they come in rows. */
#define TERMINATOR_MARGIN 1.25

/** Walls of glass that are thinner than so many half ulps of their coordinates may be jumped. */
#define WALL_ROUNDINGS 64

/** How deep rays are followed at most where nobody says: a guard, and deeper than eyes can count.
 */
enum { DEPTH_LIMIT = 64 };

/** Turns that are counted with: fewer than one ray in ten thousand makes more on curved mirrors,
 *  even between four that touch. */
enum { BOUNCES_COUNTED = 8 };

/** Transparent shapes whose walls are compared; more are not looked at. */
enum { WALLS_MAXIMUM = 64 };

/** A box in the scene. */
typedef struct Aabbd {
    Vec3d low;  /**< Lowest corner. */
    Vec3d high; /**< Highest corner. */
} Aabbd;

/** What is gathered from the shapes. */
typedef struct SceneMeasures {
    const Scene *scene;          /**< The scene. */
    const Engine *engine;        /**< Who measures. */
    PrecisionEstimate *estimate; /**< What comes of it. */
    int reflective_count;        /**< Curved shapes that mirror. */
    int transparent_count;       /**< Curved shapes that let light through. */
    double max_reflectance;      /**< The largest share that a curved shape mirrors. */
    Aabbd bounds;                /**< A box around all shapes with an end. */
    Vec3d origin;                /**< Where tracers count from. */
    double terminator_fraction; /**< Share of the picture whose faces are lit otherwise in float. */
    double texels_per_radian;   /**< Most texels that a turn of one radian may pass. */
    Aabbd glass_bounds[WALLS_MAXIMUM]; /**< Boxes of transparent shapes. */
    size_t glass_count;                /**< How many. */
} SceneMeasures;

/** @return The largest primary. */
static double rgbd_max(Rgbd color) {
    return fmax(color.red, fmax(color.green, color.blue));
}

/** Keeps a number of steps that float may be off by. */
static void keep_largest_error(PrecisionEstimate *estimate, PrecisionCause cause, double error) {
    estimate->errors[cause] = fmax(estimate->errors[cause], error);
}

/** @return A box around points of a model. */
static Aabbd mesh_bounds_d(const Mesh *mesh) {
    Aabbd box = {mesh->positions[0], mesh->positions[0]};
    for (size_t i = 1; i < mesh->position_count; i++) {
        box.low = vec3d_min(box.low, mesh->positions[i]);
        box.high = vec3d_max(box.high, mesh->positions[i]);
    }
    return box;
}

/** @return A box around a transformed box that ends. */
static Aabbd aabbd_transform(const Transform *t, Aabbd box) {
    Aabbd out = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (int corner = 0; corner < 8; corner++) {
        Vec3d p = {corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                   corner & 4 ? box.high.z : box.low.z};
        p = transform_point(t, p);
        out.low = vec3d_min(out.low, p);
        out.high = vec3d_max(out.high, p);
    }
    return out;
}

/** @return The row of a shape's table with a name and a type; NULL: there is none. */
static const Parameter *shape_parameter(const SceneMeasures *measures, const SceneShape *shape,
                                        const char *name, ParameterType type) {
    const Parameter *row = measures->engine->shape_keywords[shape->class_index]->parameters;
    while (row->name && !(row->type == type && strcmp(row->name, name) == 0)) {
        row++;
    }
    return row->name ? row : NULL;
}

/** @return The value of a row of a shape, by name; NULL: it has none. */
static const void *shape_value(const SceneMeasures *measures, const SceneShape *shape,
                               const char *name, ParameterType type) {
    const Parameter *row = shape_parameter(measures, shape, name, type);
    return row ? (const char *)shape->parameters + row->offset : NULL;
}

/** @return Whether a shape says a word. */
static bool shape_has_choice(const SceneMeasures *measures, const SceneShape *shape,
                             const char *name, const char *choice) {
    const Parameter *row = shape_parameter(measures, shape, name, PARAMETER_CHOICE);
    const int *index = shape_value(measures, shape, name, PARAMETER_CHOICE);
    return row && strcmp(row->choices[*index], choice) == 0;
}

/** @return A shape's box in the scene. */
static Aabbd shape_bounds(const SceneMeasures *measures, const SceneShape *shape,
                          const ShapeMeasure *measure) {
    Aabbd bounds = {measure->low, measure->high};
    const size_t *mesh_index = shape_value(measures, shape, "file", PARAMETER_MESH);
    if (mesh_index && measures->scene->meshes[*mesh_index].mesh) {
        bounds = mesh_bounds_d(measures->scene->meshes[*mesh_index].mesh);
    }
    bool is_bounded = vec3d_max_abs(bounds.low) < HUGE_VAL && vec3d_max_abs(bounds.high) < HUGE_VAL;
    return shape->transform && is_bounded ? aabbd_transform(shape->transform, bounds) : bounds;
}

/** @return How far a point is from a box; 0 inside. */
static double aabbd_distance(const Aabbd *box, Vec3d p) {
    Vec3d away = {fmax(0, fmax(box->low.x - p.x, p.x - box->high.x)),
                  fmax(0, fmax(box->low.y - p.y, p.y - box->high.y)),
                  fmax(0, fmax(box->low.z - p.z, p.z - box->high.z))};
    return vec3d_length(away);
}

/** @return The largest coordinate of a point, as tracers count. */
static double magnitude_from_origin(const SceneMeasures *measures, Vec3d p) {
    return vec3d_max_abs(vec3d_subtract(p, measures->origin));
}

/** Notes how far away a shape is, and how far its coordinates reach. @param box The shape's box,
 *  which ends. */
static void accumulate_bounds(SceneMeasures *measures, const Aabbd *box) {
    PrecisionEstimate *estimate = measures->estimate;
    const SceneCamera *camera = &measures->scene->camera;
    double radius = vec3d_length(vec3d_subtract(box->high, box->low)) / 2;
    double distance = aabbd_distance(box, camera->position);
    if (!(radius > 0)) {
        return;
    }
    estimate->max_distance_in_radii = fmax(estimate->max_distance_in_radii, distance / radius);
    // A thing that is smaller than a pixel is hardly there.
    double radii = fmin(distance / radius, 1 / estimate->pixel_angle);
    keep_largest_error(estimate, PRECISION_DISTANCE,
                       CODE_MAXIMUM * DIRECTION_ROUNDINGS * FLOAT_ROUNDOFF * radii);
    measures->bounds.low = vec3d_min(measures->bounds.low, box->low);
    measures->bounds.high = vec3d_max(measures->bounds.high, box->high);
    double magnitude =
        fmax(magnitude_from_origin(measures, box->low), magnitude_from_origin(measures, box->high));
    magnitude = fmax(magnitude, magnitude_from_origin(measures, camera->position));
    double visible_size =
        fmax(distance, fmin(radius, camera->target_distance)) * estimate->pixel_angle;
    double pixels = POSITION_ROUNDINGS * FLOAT_ROUNDOFF * magnitude / visible_size;
    keep_largest_error(estimate, PRECISION_POSITION,
                       PRECISION_VISIBLE_ERROR * pixels / EDGE_TOLERANCE);
}

/** Notes a picture on a shape without end. Near the horizon, rows of pixels are h / p^2 apart from
 *  a height h, and so much larger are roundings of the way. */
static void accumulate_horizon(SceneMeasures *measures, const SceneShape *shape,
                               const Texture *texture) {
    const PrecisionEstimate *estimate = measures->estimate;
    double scale = shape->transform ? vec3d_max_abs(shape->transform->scale) : 1;
    double height = measures->scene->camera.target_distance;
    double error = DIRECTION_ROUNDINGS * FLOAT_ROUNDOFF * height / pow(estimate->pixel_angle, 2);
    double texels = error * texture->width / scale;
    keep_largest_error(measures->estimate, PRECISION_HORIZON, TEXEL_CONTRAST * fmin(1, texels));
}

/** Notes the fractals in a shape's field: their normals turn within a tolerance. */
static void accumulate_sdf(SceneMeasures *measures, const SceneShape *shape) {
    const Sdf *const *sdf = shape_value(measures, shape, "field", PARAMETER_SDF);
    const double *tolerance = shape_value(measures, shape, "tolerance", PARAMETER_NUMBER);
    for (int i = 0; sdf && tolerance && i < (*sdf)->node_count; i++) {
        const SdfNode *node = &(*sdf)->nodes[i];
        if (node->op == SDF_MANDELBULB) {
            double power = node->operands[0], iterations = node->operands[1];
            double detail = fmax(*tolerance, pow(power, 1 - iterations));
            keep_largest_error(measures->estimate, PRECISION_FRACTAL,
                               CODE_MAXIMUM * POSITION_ROUNDINGS * FLOAT_ROUNDOFF / detail);
        }
    }
}

/** Adds the faces of a model that float lights otherwise. */
static void accumulate_shadow_terminator(SceneMeasures *measures, const SceneShape *shape,
                                         const Aabbd *box) {
    const size_t *mesh_index = shape_value(measures, shape, "file", PARAMETER_MESH);
    const Scene *scene = measures->scene;
    const Mesh *mesh = mesh_index ? scene->meshes[*mesh_index].mesh : NULL;
    if (!mesh || shape_has_choice(measures, shape, "normals", "flat")) {
        return;
    }
    double magnitude =
        fmax(magnitude_from_origin(measures, box->low), magnitude_from_origin(measures, box->high));
    MeshInstance instance = {scene, mesh, shape->transform,
                             POSITION_ROUNDINGS * FLOAT_ROUNDOFF * magnitude};
    // A model fills about as much of the picture as a ball between those in and around its box.
    double size = vec3d_length(vec3d_subtract(box->high, box->low)) / 3.2;
    Vec3d middle = vec3d_scale(vec3d_add(box->low, box->high), 0.5);
    double distance = vec3d_length(vec3d_subtract(middle, scene->camera.position));
    double pixels = M_PI * pow(size / fmax(distance, size) / measures->estimate->pixel_angle, 2);
    double picture = (double)scene->image.width * scene->image.height;
    measures->terminator_fraction +=
        fmin(1, pixels / picture) * shadow_terminator_fraction(&instance);
}

/** Takes a shape's surface into account. @param is_flat Whether it is flat. */
static void accumulate_material(SceneMeasures *measures, const SceneShape *shape, const Aabbd *box,
                                bool is_flat) {
    const SceneMaterial *material = &measures->scene->materials[shape->material_index];
    double reflectance = rgbd_max(material->reflectivity),
           transmittance = rgbd_max(material->transparency);
    bool is_bounded = vec3d_max_abs(box->high) < HUGE_VAL && vec3d_max_abs(box->low) < HUGE_VAL;
    measures->estimate->max_secondary_weight =
        fmax(measures->estimate->max_secondary_weight, fmin(1, reflectance + transmittance));
    measures->reflective_count += !is_flat && reflectance > 0;
    measures->transparent_count += !is_flat && transmittance > 0;
    measures->max_reflectance =
        !is_flat ? fmax(measures->max_reflectance, reflectance) : measures->max_reflectance;
    if (transmittance > 0 && is_bounded && measures->glass_count < WALLS_MAXIMUM) {
        measures->glass_bounds[measures->glass_count++] = *box;
    }
    if (material->texture_id) {
        const Texture *texture = measures->scene->textures[material->texture_id - 1].texture;
        measures->texels_per_radian =
            fmax(measures->texels_per_radian, texture->width / (2 * M_PI));
        if (!is_bounded) {
            accumulate_horizon(measures, shape, texture);
        }
    }
}

/** Takes a shape into account. */
static void accumulate_shape(SceneMeasures *measures, const SceneShape *shape) {
    ShapeMeasure measure = measures->engine->measure(shape);
    Aabbd box = shape_bounds(measures, shape, &measure);
    if (vec3d_max_abs(box.low) < HUGE_VAL && vec3d_max_abs(box.high) < HUGE_VAL) {
        accumulate_bounds(measures, &box);
        accumulate_shadow_terminator(measures, shape, &box);
    } else {
        // Without end: as far as the eye can tell things apart.
        keep_largest_error(measures->estimate, PRECISION_DISTANCE,
                           CODE_MAXIMUM * DIRECTION_ROUNDINGS * FLOAT_ROUNDOFF /
                               measures->estimate->pixel_angle);
    }
    accumulate_sdf(measures, shape);
    accumulate_material(measures, shape, &box, measure.is_flat);
}

/**
 * @return The smaller of a gap and the distance of two walls; the gap where they are in one place
 *         but for roundings of the scene's own numbers: then they are one.
 * @param distance  From one wall to the other.
 */
static double narrow_gap(double gap, double distance, double magnitude) {
    /** Roundings of a few operations in double. */
    const double tolerance = 0x1p-40;
    return fabs(distance) > tolerance * magnitude ? fmin(gap, fabs(distance)) : gap;
}

/** Notes how near the walls of two things of glass are to each other. */
static void accumulate_wall_pair(SceneMeasures *measures, const Aabbd *a, const Aabbd *b) {
    double magnitude = fmax(magnitude_from_origin(measures, a->low),
                            magnitude_from_origin(measures, a->high)),
           gap = HUGE_VAL;
    Vec3d low = vec3d_subtract(a->low, b->low), high = vec3d_subtract(a->high, b->high);
    const double distances[] = {low.x, low.y, low.z, high.x, high.y, high.z};
    for (size_t i = 0; i < sizeof distances / sizeof *distances; i++) {
        gap = narrow_gap(gap, distances[i], magnitude);
    }
    keep_largest_error(measures->estimate, PRECISION_THIN_GLASS,
                       PRECISION_VISIBLE_ERROR * WALL_ROUNDINGS * FLOAT_ROUNDOFF * magnitude / gap);
}

/** Forecasts what curved mirrors and glass make of roundings. @param[in,out] measures The survey,
 * all shapes seen. @param depth How deep rays are followed. */
static void accumulate_ray_divergence(SceneMeasures *measures, int depth) {
    PrecisionEstimate *estimate = measures->estimate;
    double spread = REFLECTION_SPREAD * measures->max_reflectance, reflection_growth = 1;
    int max_bounces = measures->reflective_count > 1 ? BOUNCES_COUNTED : measures->reflective_count;
    int bounces = max_bounces < depth ? max_bounces : depth;
    for (int i = 0; i < bounces && spread > 1; i++) {
        reflection_growth *= spread;
    }
    int refractions =
        2 * measures->transparent_count < depth ? 2 * measures->transparent_count : depth;
    double refraction_growth = pow(REFRACTION_SPREAD, refractions);
    estimate->bounces = reflection_growth > refraction_growth ? bounces : refractions;
    double error = FLOAT_ROUNDOFF * fmax(reflection_growth, refraction_growth) *
                   fmax(1, measures->texels_per_radian);
    keep_largest_error(estimate, PRECISION_RAY_DIVERGENCE,
                       estimate->bounces > 0 ? CODE_MAXIMUM * error : 0);
}

/** @return How deep rays must be followed until none can change 8 bits, whatever they meet: a share
 *          of so many factors is below the weight where rays end. @param weight The largest share
 *          that a surface sends on. */
static int depth_needed(double weight) {
    /** As the tracer has it (src/trace/tracer/engine.c). */
    const double cutoff = 1.5e-4;
    if (weight <= 0) {
        return 0;
    }
    double depth = weight < 1 ? ceil(log(cutoff) / log(weight)) : DEPTH_LIMIT;
    return depth < DEPTH_LIMIT ? (int)depth : DEPTH_LIMIT;
}

/**
 * Looks at all shapes.
 * @param origin  Where tracers count from.
 * @return What was gathered.
 */
static SceneMeasures accumulate_scene(const Scene *scene, Vec3d origin,
                                      PrecisionEstimate *estimate) {
    SceneMeasures measures = {
        .scene = scene,
        .engine = engine_with_role(ENGINE_DOUBLE),
        .estimate = estimate,
        .bounds = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}},
        .origin = origin};
    *estimate = (PrecisionEstimate){.pixel_angle = 2 * tan(scene->camera.fov / 2 * (M_PI / 180)) /
                                                   scene->image.width};
    for (size_t i = 0; i < scene->shape_count; i++) {
        accumulate_shape(&measures, &scene->shapes[i]);
    }
    return measures;
}

PrecisionEstimate precision_estimate_of(const Scene *scene) {
    /** As far away, in sizes, tracers move there (src/trace/rebase.c). */
    const double far_sizes = 4;
    PrecisionEstimate estimate;
    SceneMeasures measures = accumulate_scene(scene, (Vec3d){0, 0, 0}, &estimate);
    Vec3d middle = vec3d_scale(vec3d_add(measures.bounds.low, measures.bounds.high), 0.5);
    double size = vec3d_max_abs(vec3d_subtract(measures.bounds.high, measures.bounds.low));
    if (vec3d_max_abs(middle) > far_sizes * size) {
        measures = accumulate_scene(scene, middle, &estimate);
    }
    for (size_t i = 0; i < measures.glass_count; i++) {
        for (size_t k = 0; k < i; k++) {
            accumulate_wall_pair(&measures, &measures.glass_bounds[i], &measures.glass_bounds[k]);
        }
    }
    if (scene->sky.texture_id) {
        const Texture *panorama = scene->textures[scene->sky.texture_id - 1].texture;
        double contrast = panorama->is_hdr ? HDR_CONTRAST : 1;
        measures.texels_per_radian =
            fmax(measures.texels_per_radian, contrast * panorama->width / (2 * M_PI));
    }
    double shift = DIRECTION_ROUNDINGS * FLOAT_ROUNDOFF / estimate.pixel_angle;
    keep_largest_error(&estimate, PRECISION_PIXEL_ANGLE,
                       PRECISION_VISIBLE_ERROR * shift / EDGE_TOLERANCE);
    estimate.depth = depth_needed(estimate.max_secondary_weight);
    // What mirrors shows the models once more.
    double images = estimate.max_secondary_weight > 0 ? 2 : 1;
    keep_largest_error(&estimate, PRECISION_SHADOW_TERMINATOR,
                       PRECISION_VISIBLE_ERROR * TERMINATOR_MARGIN * images *
                           measures.terminator_fraction / PIXEL_FRACTION_ALLOWED);
    accumulate_ray_divergence(&measures,
                              scene->image.depth >= 0 ? scene->image.depth : estimate.depth);
    for (int cause = 0; cause < PRECISION_CAUSE_COUNT; cause++) {
        bool is_more = estimate.errors[cause] > estimate.errors[estimate.cause];
        estimate.cause = is_more ? (PrecisionCause)cause : estimate.cause;
    }
    return estimate;
}

const Engine *precision_estimate_engine(const PrecisionEstimate *estimate) {
    bool is_visible = precision_estimate_error(estimate) >= PRECISION_VISIBLE_ERROR;
    return engine_with_role(is_visible ? ENGINE_DOUBLE : ENGINE_FASTEST);
}
