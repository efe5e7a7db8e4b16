/**
 * @file
 * @brief Scenes of glass whose light is known in closed form, at any size and place.
 */
#ifndef DIOPTRE_GLASS_SCENES_H
#define DIOPTRE_GLASS_SCENES_H

#include "testing.h"

#include <math.h>
#include <stdlib.h>

/** How large a scene is, and where. */
typedef struct World {
    double scale;  /**< Length of 1. */
    double offset; /**< How far from the origin, in lengths of 1. */
} World;

/** The sizes and places of the acceptance list. */
static const World worlds[] = {{1, 0},     {1e-3, 0}, {1e3, 0},    {1, 100},  {1e-3, 100},
                               {1e3, 100}, {1, 1e4},  {1e-3, 1e4}, {1e3, 1e4}};
/** How many there are. */
enum { WORLDS = sizeof worlds / sizeof *worlds };

/** @return A point of a world. @param world The world. @param p The point, were it at the origin
 *  and of size 1. */
static inline Vector3 place_in(World world, Vector3 p) {
    double w = world.offset;
    return (Vector3){world.scale * (p.x + w), world.scale * (p.y - w), world.scale * (p.z + w)};
}

/** @return Glass without colour. @param ior Its index. */
static inline Material glass_of(double ior) {
    Material material = *(const Material *)material_keyword.defaults;
    material.transparency = (Color){1, 1, 1};
    material.ior = ior;
    return material;
}

/** @return Something that only shines. @param light How bright. */
static inline Material shining(Color light) {
    Material material = *(const Material *)material_keyword.defaults;
    material.color = (Color){0, 0, 0};
    material.emission = light;
    return material;
}

/** Adds a material, that of the next shapes. @param scene The scene. @param material It. */
static inline void use(Scene *scene, Material material) {
    Error error = {0};
    assert_true(scene_add_material(scene, &material, &error));
}

/** Adds a sphere. @param scene The scene. @param world Where. @param center Its centre.
 *  @param radius Its radius. */
static inline void add_ball(Scene *scene, World world, Vector3 center, double radius) {
    SphereParameters ball = {place_in(world, center), world.scale * radius};
    add_shape(scene, "sphere", &ball);
}

/** Adds a box. @param scene The scene. @param world Where. @param low Its lowest corner.
 *  @param high Its highest. */
static inline void add_block(Scene *scene, World world, Vector3 low, Vector3 high) {
    BoxParameters box = {place_in(world, low), place_in(world, high)};
    add_shape(scene, "box", &box);
}

/** Adds a plane. @param scene The scene. @param world Where. @param point A point of it.
 *  @param normal Its normal. */
static inline void add_plane(Scene *scene, World world, Vector3 point, Vector3 normal) {
    PlaneParameters plane = {place_in(world, point), normal};
    add_shape(scene, "plane", &plane);
}

/** Adds a quad. @param scene The scene. @param world Where. @param corner A corner. @param u To the
 *  next. @param v To the other next. */
static inline void add_panel(Scene *scene, World world, Vector3 corner, Vector3 u, Vector3 v) {
    QuadParameters quad = {place_in(world, corner), vector3_scale(u, world.scale),
                           vector3_scale(v, world.scale)};
    add_shape(scene, "quad", &quad);
}

/** Turns the camera. @param scene The scene. @param world Where. @param eye Where it is.
 *  @param direction Which way it looks. */
static inline void aim(Scene *scene, World world, Vector3 eye, Vector3 direction) {
    Camera *camera = &scene->camera;
    camera->position = place_in(world, eye);
    camera->direction = vector3_normalize(direction);
    Vector3 aside = {1, 0, 0};
    double along = vector3_dot(aside, camera->direction);
    if (fabs(along) > 0.9) {
        aside = (Vector3){0, 0, 1};
        along = vector3_dot(aside, camera->direction);
    }
    camera->up =
        vector3_normalize(vector3_subtract(aside, vector3_scale(camera->direction, along)));
}

/** Fresnel's share in closed form, and the angle behind. @return 1 where there is none.
 *  @param sine Of the angle of incidence. @param from Index there. @param to Index behind. */
static inline double fresnel(Quadruple sine, double from, double to) {
    Quadruple s = sine, n = from, m = to;
    Quadruple inner = 1 - (n * s / m) * (n * s / m);
    if (inner < 0) {
        return 1;
    }
    Quadruple a = quad_sqrt(1 - s * s), b = quad_sqrt(inner);
    Quadruple te = (n * a - m * b) / (n * a + m * b), tm = (m * a - n * b) / (m * a + n * b);
    return (double)((te * te + tm * tm) / 2);
}

/** How finely a picture is traced. */
typedef struct Fineness {
    int depth;     /**< How often rays are mirrored or refracted. */
    double cutoff; /**< Weight below which they end. */
} Fineness;

/** Traces a picture. @param engine The engine. @param scene The scene. @param fine How finely.
 *  @param width Pixels. @param height Pixels. @param[out] rgb Its light. @return The rays. */
static inline RayCounts trace_picture(const Engine *engine, const Scene *scene, Fineness fine,
                                      int width, int height, double *rgb) {
    Error error = {0};
    TraceSettings settings = {.depth = fine.depth, .cutoff = fine.cutoff, .offset = OFFSET_BOUND};
    Tracer *tracer = engine->prepare(scene, &settings, &error);
    assert_non_null(tracer);
    PixelGrid grid = {.columns = width, .rows = height, .stride = 1};
    RayCounts counts = {0};
    engine->look(tracer, scene, width, height);
    engine->trace(tracer, &grid, rgb, &counts);
    engine->release(tracer);
    return counts;
}

/** @return The light of the ray in the middle of the picture. @param engine The engine.
 *  @param scene The scene. @param depth How often it is mirrored or refracted. */
static inline double light_of(const Engine *engine, const Scene *scene, int depth) {
    double rgb[3];
    trace_picture(engine, scene, (Fineness){depth, 1e-12}, 1, 1, rgb);
    return rgb[0];
}

/** @return A picture's number in steps of 255 of the sRGB curve. @param light Linear light. */
static inline double steps_of(double light) {
    double x = light < 0 ? 0 : light > 1 ? 1 : light;
    return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055);
}

#endif
