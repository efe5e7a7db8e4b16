/**
 * @file
 * @brief Estimate of the rounding errors of a picture from the numbers of its scene.
 *
 * Each cause is a product: half an ulp of float, the number of roundings, the factor that magnifies
 * them, and the change of the picture per unit. The factors were compared with whole pictures of
 * all scenes (doc/needs.md).
 */
#include "render/precision_estimate.h"

#include "base/encoding.h"
#include "render/roundoff.h"
#include "render/shadow_terminator.h"
#include "render/trapped_light.h"

#include <math.h>

/** Error bound of a point, and of the ray offset there, in half ulps. */
#define POSITION_ROUNDINGS 16

/** Error bound of a direction, in half ulps. */
#define DIRECTION_ROUNDINGS 4

/** Displacement of an edge that is not visible, in pixels. */
#define EDGE_TOLERANCE (1.0 / 16)

/** Factor by which a reflection on a curved surface increases the angle between two rays: four
 *  spheres that reflect one another have a median of 2.5, and 4 in one case of a hundred. */
#define REFLECTION_SPREAD 4

/** The same factor for refraction, which bends less. */
#define REFRACTION_SPREAD 2

/** Difference of neighbouring texels of a detailed texture, in 8-bit steps. */
#define TEXEL_CONTRAST 40.0

/** Ratio of that difference in HDR panoramas, which contain the sun. */
#define HDR_CONTRAST 4

/** Margin on the fraction of faces at the shadow terminator: they come in rows. */
#define TERMINATOR_MARGIN 1.25

/** Thickness of glass below which rays may skip a wall, in half ulps of its coordinates. */
#define WALL_ROUNDINGS 64

/** Largest recursion depth that is chosen automatically. */
enum { DEPTH_LIMIT = 64 };

/** Largest number of bounces that count: fewer than one ray in ten thousand has more on curved
 *  mirrors, even between four that touch. */
enum { BOUNCES_COUNTED = 8 };

/** The same in a room of mirrors, where rays come back. */
enum { ROOM_BOUNCES_COUNTED = 16 };

/** Largest number of transparent shapes whose walls are compared. */
enum { WALLS_MAXIMUM = 64 };

/** Quantities accumulated over the shapes. */
typedef struct SceneMeasures {
    const Scene *scene;          /**< The scene. */
    PrecisionEstimate *estimate; /**< The result. */
    int reflective_count;        /**< Number of curved reflective shapes. */
    int transparent_count;       /**< Number of curved transparent shapes. */
    double max_reflectance;      /**< Largest reflectance of a curved shape. */
    double max_transmittance;    /**< Largest transmittance of a curved shape. */
    double room_reflectance;     /**< Largest reflectance of a shape that the camera is in. */
    Vec3d origin;                /**< #scene_local_origin */
    double slant; /**< direction_slant(); 1 if surfaces turn rays in other directions. */
    double terminator_fraction; /**< Fraction of the picture whose faces float lights wrongly. */
    double texels_per_radian;   /**< Largest number of texels per radian of direction. */
    GlassShape glass[WALLS_MAXIMUM];   /**< Transparent shapes. */
    size_t glass_count;                /**< Number of #glass. */
    GlassShape mirrors[WALLS_MAXIMUM]; /**< Curved mirrors. */
    size_t mirror_count;               /**< Number of #mirrors. */
} SceneMeasures;

/** @return The largest channel. */
static double rgbd_max(Rgbd color) {
    return fmax(color.red, fmax(color.green, color.blue));
}

/** Keeps the largest error of a cause, in 8-bit steps. */
static void keep_largest_error(PrecisionEstimate *estimate, PrecisionCause cause, double error) {
    estimate->errors[cause] = fmax(estimate->errors[cause], error);
}

/** @return The distance of a point from a box; 0 inside. */
static double aabbd_distance(const Aabbd *box, Vec3d p) {
    Vec3d away = {fmax(0, fmax(box->low.x - p.x, p.x - box->high.x)),
                  fmax(0, fmax(box->low.y - p.y, p.y - box->high.y)),
                  fmax(0, fmax(box->low.z - p.z, p.z - box->high.z))};
    return vec3d_length(away);
}

/**
 * @return The error of a camera ray's direction across the ray, relative to half an ulp of 1: from
 * 0, along an axis, to 1. Each component is rounded relative to itself. Along an axis, the
 *         components across the ray are as small as the field of view, and so are their errors.
 */
static double direction_slant(const SceneCamera *camera) {
    const Vec3d d = vec3d_normalize(camera->direction);
    const double axes[] = {d.x, d.y, d.z};
    double slant = tan(camera->fov / 2 * (M_PI / 180));
    for (int axis = 0; axis < 3; axis++) {
        // The part of this component's error that is across the ray; 1/2 at most.
        slant += 2 * fabs(axes[axis]) * sqrt(fmax(0, 1 - axes[axis] * axes[axis]));
    }
    return fmin(1, slant);
}

/** @return Whether camera rays meet a shape as exactly as their direction is known: primitives are
 *  solved relative to the ray's origin or in double. */
static bool is_primitive(const ShapeFacts *facts) {
    return !facts->mesh && !facts->sdf;
}

/**
 * @return The largest coordinate of a point relative to the origin of tracers, as far as camera
 * rays show its rounding: errors along a ray are not seen.
 * @param slant  1: rays of all directions show it.
 */
static double visible_magnitude(const SceneMeasures *measures, Vec3d p, double slant) {
    const SceneCamera *camera = &measures->scene->camera;
    Vec3d from_origin = vec3d_subtract(p, measures->origin);
    Vec3d d = vec3d_normalize(camera->direction);
    const double axes[] = {d.x, d.y, d.z},
                 coordinates[] = {from_origin.x, from_origin.y, from_origin.z};
    double field = tan(camera->fov / 2 * (M_PI / 180)), largest = 0;
    for (int axis = 0; axis < 3; axis++) {
        double across = fmin(1, field + sqrt(fmax(0, 1 - axes[axis] * axes[axis])));
        largest = fmax(largest, fabs(coordinates[axis]) * (slant < 1 ? across : 1));
    }
    return largest;
}

/** Accumulates the distance and the coordinates of a bounded shape.
 *  @param slant See direction_slant(). */
static void accumulate_bounds(SceneMeasures *measures, const Aabbd *box, double slant) {
    PrecisionEstimate *estimate = measures->estimate;
    const SceneCamera *camera = &measures->scene->camera;
    double radius = vec3d_length(vec3d_subtract(box->high, box->low)) / 2;
    double distance = aabbd_distance(box, camera->position);
    if (!(radius > 0)) {
        return;
    }
    estimate->max_distance_in_radii = fmax(estimate->max_distance_in_radii, distance / radius);
    // A shape smaller than a pixel is hardly visible.
    double radii = fmin(distance / radius, 1 / estimate->pixel_angle);
    keep_largest_error(estimate, PRECISION_DISTANCE,
                       ENCODING_CODE_MAXIMUM * DIRECTION_ROUNDINGS * FLOAT_ROUNDOFF * slant *
                           radii);
    double magnitude = fmax(visible_magnitude(measures, box->low, slant),
                            visible_magnitude(measures, box->high, slant));
    magnitude = fmax(magnitude, visible_magnitude(measures, camera->position, slant));
    double visible_size =
        fmax(distance, fmin(radius, camera->target_distance)) * estimate->pixel_angle;
    double pixels = POSITION_ROUNDINGS * FLOAT_ROUNDOFF * magnitude / visible_size;
    keep_largest_error(estimate, PRECISION_POSITION,
                       PRECISION_VISIBLE_ERROR * pixels / EDGE_TOLERANCE);
}

/** Accumulates a texture on an unbounded shape. At the angle a below the horizon, a camera at
 * height h sees a direction's change by e as h e / a^2. The horizon passes at any distance from the
 *  middles of pixels: #PRECISION_FRACTION_ALLOWED of a picture's rows are nearer to it than a. */
static void accumulate_horizon(SceneMeasures *measures, const SceneShape *shape,
                               const Texture *texture) {
    const PrecisionEstimate *estimate = measures->estimate;
    double scale = shape->transform ? vec3d_max_abs(shape->transform->scale) : 1;
    double height = measures->scene->camera.target_distance;
    double rows = fmin(1, PRECISION_FRACTION_ALLOWED * measures->scene->image.height);
    double error =
        DIRECTION_ROUNDINGS * FLOAT_ROUNDOFF * height / pow(rows * estimate->pixel_angle, 2);
    double texels = error * texture->width / scale;
    keep_largest_error(measures->estimate, PRECISION_HORIZON, TEXEL_CONTRAST * fmin(1, texels));
}

/** Accumulates the fractals in a distance field: their normals change within a tolerance. */
static void accumulate_sdf(SceneMeasures *measures, const Sdf *sdf, double tolerance) {
    for (int i = 0; i < sdf->node_count; i++) {
        const SdfNode *node = &sdf->nodes[i];
        if (node->op == SDF_MANDELBULB) {
            double power = node->operands[0], iterations = node->operands[1];
            double detail = fmax(tolerance, pow(power, 1 - iterations));
            keep_largest_error(measures->estimate, PRECISION_FRACTAL,
                               ENCODING_CODE_MAXIMUM * POSITION_ROUNDINGS * FLOAT_ROUNDOFF /
                                   detail);
        }
    }
}

/** Adds the faces of a smooth mesh that float lights differently. */
static void accumulate_shadow_terminator(SceneMeasures *measures, const SceneShape *shape,
                                         const Mesh *mesh, const Aabbd *box) {
    const Scene *scene = measures->scene;
    double magnitude = fmax(magnitude_from(measures->origin, box->low),
                            magnitude_from(measures->origin, box->high));
    MeshInstance instance = {scene, mesh, shape->transform,
                             POSITION_ROUNDINGS * FLOAT_ROUNDOFF * magnitude};
    // A mesh covers about as many pixels as a sphere between those inside and around its box.
    double size = vec3d_length(vec3d_subtract(box->high, box->low)) / 3.2;
    Vec3d middle = vec3d_scale(vec3d_add(box->low, box->high), 0.5);
    double distance = vec3d_length(vec3d_subtract(middle, scene->camera.position));
    double pixels = M_PI * pow(size / fmax(distance, size) / measures->estimate->pixel_angle, 2);
    double picture = (double)scene->image.width * scene->image.height;
    measures->terminator_fraction +=
        fmin(1, pixels / picture) * shadow_terminator_fraction(&instance);
}

/** Keeps a bounded shape if it is transparent, or a curved mirror. */
static void accumulate_glass(SceneMeasures *measures, const SceneShape *shape,
                             const ShapeFacts *facts, const SceneMaterial *material) {
    const GlassShape glass = {.bounds = facts->bounds,
                              .is_flat = facts->is_flat,
                              .class_index = shape->class_index,
                              .ior = material->ior,
                              .transmittance = rgbd_max(material->transparency),
                              .reflectance = rgbd_max(material->reflectivity),
                              .ray_growth = facts->ray_growth};
    bool is_mirror = glass.transmittance <= 0 && glass.reflectance > 0 && !glass.is_flat;
    if (glass.transmittance > 0 && measures->glass_count < WALLS_MAXIMUM) {
        measures->glass[measures->glass_count++] = glass;
    } else if (is_mirror && measures->mirror_count < WALLS_MAXIMUM) {
        measures->mirrors[measures->mirror_count++] = glass;
    }
}

/** Accumulates the material of a shape. */
static void accumulate_material(SceneMeasures *measures, const SceneShape *shape,
                                const ShapeFacts *facts) {
    const SceneMaterial *material = &measures->scene->materials[shape->material_index];
    double reflectance = rgbd_max(material->reflectivity),
           transmittance = rgbd_max(material->transparency);
    bool is_bounded = aabbd_is_bounded(facts->bounds), is_flat = facts->is_flat;
    measures->estimate->max_secondary_weight =
        fmax(measures->estimate->max_secondary_weight, fmin(1, reflectance + transmittance));
    measures->reflective_count += !is_flat && reflectance > 0;
    measures->transparent_count += !is_flat && transmittance > 0;
    measures->max_reflectance =
        !is_flat ? fmax(measures->max_reflectance, reflectance) : measures->max_reflectance;
    measures->max_transmittance =
        !is_flat ? fmax(measures->max_transmittance, transmittance) : measures->max_transmittance;
    if (is_bounded && aabbd_distance(&facts->bounds, measures->scene->camera.position) == 0) {
        measures->room_reflectance = fmax(measures->room_reflectance, reflectance);
    }
    if (transmittance > 0 && facts->is_smooth && measures->estimate->smooth_glass_line == 0) {
        measures->estimate->smooth_glass_line = shape->origin.line;
    }
    if (is_bounded) {
        accumulate_glass(measures, shape, facts, material);
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

/** Accumulates a shape. */
static void accumulate_shape(SceneMeasures *measures, const SceneShape *shape) {
    ShapeFacts facts = scene_shape_facts(measures->scene, shape);
    double slant = is_primitive(&facts) ? measures->slant : 1;
    if (aabbd_is_bounded(facts.bounds)) {
        accumulate_bounds(measures, &facts.bounds, slant);
        if (facts.mesh && facts.is_smooth) {
            accumulate_shadow_terminator(measures, shape, facts.mesh, &facts.bounds);
        }
    } else {
        // The visible part of an unbounded shape extends until a pixel cannot resolve it.
        keep_largest_error(measures->estimate, PRECISION_DISTANCE,
                           ENCODING_CODE_MAXIMUM * DIRECTION_ROUNDINGS * FLOAT_ROUNDOFF * slant /
                               measures->estimate->pixel_angle);
    }
    if (facts.sdf) {
        accumulate_sdf(measures, facts.sdf, facts.tolerance);
    }
    accumulate_material(measures, shape, &facts);
}

/**
 * @return The smaller of a gap and the distance of two walls. Two walls that coincide except for
 *         roundings of the scene's own numbers count as one.
 * @param distance   Signed distance of the walls.
 * @param magnitude  Largest coordinate.
 */
static double narrow_gap(double gap, double distance, double magnitude) {
    /** Roundings of a few operations in double. */
    const double tolerance = 0x1p-40;
    return fabs(distance) > tolerance * magnitude ? fmin(gap, fabs(distance)) : gap;
}

/** Accumulates the smallest distance between the walls of two transparent shapes. */
static void accumulate_wall_pair(SceneMeasures *measures, const Aabbd *a, const Aabbd *b) {
    double magnitude = fmax(magnitude_from(measures->origin, a->low),
                            magnitude_from(measures->origin, a->high)),
           gap = HUGE_VAL;
    Vec3d low = vec3d_subtract(a->low, b->low), high = vec3d_subtract(a->high, b->high);
    const double distances[] = {low.x, low.y, low.z, high.x, high.y, high.z};
    for (size_t i = 0; i < sizeof distances / sizeof *distances; i++) {
        gap = narrow_gap(gap, distances[i], magnitude);
    }
    keep_largest_error(measures->estimate, PRECISION_THIN_GLASS,
                       PRECISION_VISIBLE_ERROR * WALL_ROUNDINGS * FLOAT_ROUNDOFF * magnitude / gap);
}

/**
 * @return The growth of the distance between rays in a room of mirrors, weighed by the light that
 *         they keep: its walls send rays back to curved shapes again and again (Sinai's billiard).
 *  @param depth Recursion depth.
 */
static double room_growth(const SceneMeasures *measures, int depth) {
    double kept = fmax(measures->max_reflectance, measures->max_transmittance);
    double spread = REFLECTION_SPREAD * kept * measures->room_reflectance;
    return spread > 1 ? pow(spread, fmin(depth, ROOM_BOUNCES_COUNTED)) : 0;
}

/** Estimates the divergence of rays on curved mirrors and glass, after all shapes are accumulated.
 *  @param depth Recursion depth. */
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
    double growth = fmax(fmax(reflection_growth, refraction_growth), room_growth(measures, depth));
    double error = FLOAT_ROUNDOFF * growth * fmax(1, measures->texels_per_radian);
    keep_largest_error(estimate, PRECISION_RAY_DIVERGENCE,
                       estimate->bounces > 0 ? ENCODING_CODE_MAXIMUM * error : 0);
}

/** @return The recursion depth at which the weight of a ray falls below the cutoff of tracers.
 *  @param weight Largest reflectance or transmittance of a surface. */
static int depth_needed(double weight) {
    if (weight <= 0) {
        return 0;
    }
    double depth = weight < 1 ? ceil(log(THROUGHPUT_CUTOFF) / log(weight)) : DEPTH_LIMIT;
    return depth < DEPTH_LIMIT ? (int)depth : DEPTH_LIMIT;
}

/** Accumulates the walls of all pairs of transparent shapes. */
static void accumulate_walls(SceneMeasures *measures) {
    for (size_t i = 0; i < measures->glass_count; i++) {
        for (size_t k = 0; k < i; k++) {
            accumulate_wall_pair(measures, &measures->glass[i].bounds, &measures->glass[k].bounds);
        }
    }
}

/** Accumulates the texels of the sky. */
static void accumulate_sky(SceneMeasures *measures) {
    const Scene *scene = measures->scene;
    if (scene->sky.texture_id) {
        const Texture *panorama = scene->textures[scene->sky.texture_id - 1].texture;
        double contrast = panorama->is_hdr ? HDR_CONTRAST : 1;
        measures->texels_per_radian =
            fmax(measures->texels_per_radian, contrast * panorama->width / (2 * M_PI));
    }
}

/** Keeps the errors of fractions of the picture that are wrong by any number of steps, after all
 *  shapes are accumulated. */
static void accumulate_fractions(SceneMeasures *measures) {
    PrecisionEstimate *estimate = measures->estimate;
    const double error_per_fraction = PRECISION_VISIBLE_ERROR / PRECISION_FRACTION_ALLOWED;
    // A mirror shows the meshes once more.
    double images = estimate->max_secondary_weight > 0 ? 2 : 1;
    keep_largest_error(estimate, PRECISION_SHADOW_TERMINATOR,
                       error_per_fraction * TERMINATOR_MARGIN * images *
                           measures->terminator_fraction);
    estimate->z_fighting = z_fighting_of(measures->scene);
    keep_largest_error(estimate, PRECISION_Z_FIGHTING,
                       error_per_fraction * estimate->z_fighting.fraction);
}

/** Accumulates what grows with the number of turns, after all shapes are accumulated. */
static void accumulate_turns(SceneMeasures *measures) {
    PrecisionEstimate *estimate = measures->estimate;
    const Scene *scene = measures->scene;
    estimate->depth = depth_needed(estimate->max_secondary_weight);
    int depth = scene->image.depth >= 0 ? scene->image.depth : estimate->depth;
    accumulate_ray_divergence(measures, depth);
    GlassView view = {.position = scene->camera.position,
                      .pixel_angle = estimate->pixel_angle,
                      .pixels = (double)scene->image.width * scene->image.height,
                      .depth = depth};
    keep_largest_error(estimate, PRECISION_TRAPPED_LIGHT,
                       trapped_light_error(measures->glass, measures->glass_count, &view));
    keep_largest_error(estimate, PRECISION_TRAPPED_LIGHT,
                       mirrored_light_error(measures->glass, measures->glass_count,
                                            measures->mirrors, measures->mirror_count, &view));
    estimate->chaotic_fraction = chaotic_light_fraction(
        measures->glass, measures->glass_count, measures->mirrors, measures->mirror_count, &view);
}

/** @return The cause with the largest error. */
static PrecisionCause largest_cause(const double *errors) {
    PrecisionCause largest = 0;
    for (PrecisionCause cause = 0; cause < PRECISION_CAUSE_COUNT; cause++) {
        largest = errors[cause] > errors[largest] ? cause : largest;
    }
    return largest;
}

/** @return The cause to be named. Both sides of a thin wall of glass are near to each other: where
 *  the wall is visible, it says more than that. */
static PrecisionCause cause_to_name(const double *errors) {
    PrecisionCause largest = largest_cause(errors);
    bool is_wall =
        largest == PRECISION_Z_FIGHTING && errors[PRECISION_THIN_GLASS] >= PRECISION_VISIBLE_ERROR;
    return is_wall ? PRECISION_THIN_GLASS : largest;
}

PrecisionEstimate precision_estimate_of(const Scene *scene) {
    PrecisionEstimate estimate = {.pixel_angle = 2 * tan(scene->camera.fov / 2 * (M_PI / 180)) /
                                                 scene->image.width};
    SceneMeasures measures = {
        .scene = scene, .estimate = &estimate, .origin = scene_local_origin(scene), .slant = 1};
    if (!scene_has_secondary_rays(scene)) {
        measures.slant = direction_slant(&scene->camera);
    }
    for (size_t i = 0; i < scene->shape_count; i++) {
        accumulate_shape(&measures, &scene->shapes[i]);
    }
    accumulate_walls(&measures);
    accumulate_sky(&measures);
    double shift = DIRECTION_ROUNDINGS * FLOAT_ROUNDOFF * measures.slant / estimate.pixel_angle;
    keep_largest_error(&estimate, PRECISION_PIXEL_ANGLE,
                       PRECISION_VISIBLE_ERROR * shift / EDGE_TOLERANCE);
    accumulate_fractions(&measures);
    accumulate_turns(&measures);
    estimate.cause = cause_to_name(estimate.errors);
    return estimate;
}

double precision_estimate_error(const PrecisionEstimate *estimate) {
    return estimate->errors[largest_cause(estimate->errors)];
}

const Engine *precision_estimate_engine(const PrecisionEstimate *estimate) {
    bool is_visible = precision_estimate_error(estimate) >= PRECISION_VISIBLE_ERROR;
    return engine_with_role(is_visible ? ENGINE_DOUBLE : ENGINE_FASTEST);
}
