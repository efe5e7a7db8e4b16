/**
 * @file
 * @brief Scenes of glass with known light in closed form, at any scale and position.
 */
#ifndef DIOPTRE_GLASS_SCENES_H
#define DIOPTRE_GLASS_SCENES_H

#include "testing.h"

#include <math.h>
#include <stdlib.h>

/** Scale and position of a scene. */
typedef struct Placement {
    double scale;  /**< Length of one scene unit. */
    double offset; /**< Distance from the origin, in these units. */
} Placement;

/** The placements of the acceptance list. */
static const Placement placements[] = {{1, 0},     {1e-3, 0}, {1e3, 0},    {1, 100},  {1e-3, 100},
                                       {1e3, 100}, {1, 1e4},  {1e-3, 1e4}, {1e3, 1e4}};
/** Number of placements. */
enum { PLACEMENT_COUNT = sizeof placements / sizeof *placements };

/**
 * @return A point of a placed scene.
 * @param p  The point at scale 1 and offset 0.
 */
static inline Vec3d placed_point(Placement placement, Vec3d p) {
    double w = placement.offset;
    return (Vec3d){placement.scale * (p.x + w), placement.scale * (p.y - w),
                   placement.scale * (p.z + w)};
}

/** @return Glass without colour. */
static inline SceneMaterial glass_material(double ior) {
    SceneMaterial material = *(const SceneMaterial *)scene_material_keyword.defaults;
    material.transparency = (Rgbd){1, 1, 1};
    material.ior = ior;
    return material;
}

/** @return A material that only emits light. */
static inline SceneMaterial emissive_material(Rgbd light) {
    SceneMaterial material = *(const SceneMaterial *)scene_material_keyword.defaults;
    material.color = (Rgbd){0, 0, 0};
    material.emission = light;
    return material;
}

/** Adds a material; the next shapes use it. */
static inline void use_material(Scene *scene, SceneMaterial material) {
    Error error = {0};
    assert_true(scene_add_material(scene, &material, &error));
}

/** Adds a sphere. */
static inline void add_placed_sphere(Scene *scene, Placement placement, Vec3d center,
                                     double radius) {
    SphereParameters sphere = {placed_point(placement, center), placement.scale * radius};
    add_shape(scene, "sphere", &sphere);
}

/** Adds a box. */
static inline void add_placed_box(Scene *scene, Placement placement, Vec3d low, Vec3d high) {
    BoxParameters box = {placed_point(placement, low), placed_point(placement, high)};
    add_shape(scene, "box", &box);
}

/** Adds a plane. */
static inline void add_placed_plane(Scene *scene, Placement placement, Vec3d point, Vec3d normal) {
    PlaneParameters plane = {placed_point(placement, point), normal};
    add_shape(scene, "plane", &plane);
}

/** Adds a quad. @param v Its second edge. */
static inline void add_placed_quad(Scene *scene, Placement placement, Vec3d corner, Vec3d u,
                                   Vec3d v) {
    QuadParameters quad = {placed_point(placement, corner), vec3d_scale(u, placement.scale),
                           vec3d_scale(v, placement.scale)};
    add_shape(scene, "quad", &quad);
}

/** Sets the camera. @param direction The direction of view. */
static inline void set_camera(Scene *scene, Placement placement, Vec3d eye, Vec3d direction) {
    SceneCamera *camera = &scene->camera;
    camera->position = placed_point(placement, eye);
    camera->direction = vec3d_normalize(direction);
    Vec3d up = {1, 0, 0};
    double along = vec3d_dot(up, camera->direction);
    if (fabs(along) > 0.9) {
        up = (Vec3d){0, 0, 1};
        along = vec3d_dot(up, camera->direction);
    }
    camera->up = vec3d_normalize(vec3d_subtract(up, vec3d_scale(camera->direction, along)));
}

/**
 * Fresnel reflectance in closed form.
 * @return The reflectance; 1 at total internal reflection.
 * @param sine  Sine of the angle of incidence.
 */
static inline double fresnel_closed_form(Quadruple sine, double from, double to) {
    Quadruple s = sine, n = from, m = to;
    Quadruple inner = 1 - (n * s / m) * (n * s / m);
    if (inner < 0) {
        return 1;
    }
    Quadruple a = quad_sqrt(1 - s * s), b = quad_sqrt(inner);
    Quadruple te = (n * a - m * b) / (n * a + m * b), tm = (m * a - n * b) / (m * a + n * b);
    return (double)((te * te + tm * tm) / 2);
}

/** Settings of a trace. */
typedef struct TraceLimits {
    int depth;     /**< Maximum number of reflections and refractions. */
    double cutoff; /**< #TraceSettings.cutoff, 8-bit steps; 0: #CUTOFF_DEFAULT. */
} TraceLimits;

/** Traces a picture. @return The number of rays. */
static inline RayCounts trace_picture(const Engine *engine, const Scene *scene, TraceLimits limits,
                                      int width, int height, double *rgb) {
    Error error = {0};
    TraceSettings settings = {.depth = limits.depth,
                              .cutoff = limits.cutoff > 0 ? limits.cutoff : CUTOFF_DEFAULT,
                              .offset = OFFSET_BOUND};
    Tracer *tracer = engine->create_tracer(scene, &settings, &error);
    assert_non_null(tracer);
    PixelGrid grid = {.columns = width, .rows = height, .stride = 1};
    RayCounts counts = {0};
    engine->set_view(tracer, scene, width, height);
    engine->trace(tracer, &grid, rgb, &counts);
    engine->destroy(tracer);
    return counts;
}

/**
 * @return The radiance of the central ray of the picture.
 * @param depth  Maximum number of reflections and refractions.
 */
static inline double center_radiance(const Engine *engine, const Scene *scene, int depth) {
    double rgb[3];
    trace_picture(engine, scene, (TraceLimits){depth, 1e-12}, 1, 1, rgb);
    return rgb[0];
}

/** @return Linear light in 8-bit steps of the sRGB curve. */
static inline double srgb_steps(double light) {
    double x = light < 0 ? 0 : light > 1 ? 1 : light;
    return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055);
}

#endif
