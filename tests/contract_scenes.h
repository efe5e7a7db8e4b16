/**
 * @file
 * @brief Scenes and rays of the contract tests: each shape alone, and random rays near it.
 */
#ifndef TESTS_CONTRACT_SCENES_H
#define TESTS_CONTRACT_SCENES_H

#include "contract_shapes.h"
#include "sdf_builders.h"

/** Computes the matrices of the transforms. @return 0 */
static inline int init_transforms(void **state) {
    (void)state;
    Transform *const transforms[] = {&ellipsoid_transform, &tilted_transform, &squeezed_transform,
                                     &scaled_transform};
    for (size_t i = 0; i < sizeof transforms / sizeof *transforms; i++) {
        Error error = {0};
        assert_true(transform_keyword.finish(transforms[i], 0, &error));
    }
    return 0;
}

/** Adds a box as a mesh of twelve triangles. */
static inline void add_box_mesh(Scene *scene, const BoxSpec *box) {
    static const MeshTriangle triangles[] = {{{0, 2, 3}}, {{0, 3, 1}}, {{4, 5, 7}}, {{4, 7, 6}},
                                             {{0, 1, 5}}, {{0, 5, 4}}, {{2, 6, 7}}, {{2, 7, 3}},
                                             {{0, 4, 6}}, {{0, 6, 2}}, {{1, 3, 7}}, {{1, 7, 5}}};
    enum { CORNERS = 8, TRIANGLES = sizeof triangles / sizeof *triangles };
    Vec3d corners[CORNERS];
    for (int i = 0; i < CORNERS; i++) {
        corners[i] = (Vec3d){i & 1 ? box->high[0] : box->low[0], i & 2 ? box->high[1] : box->low[1],
                             i & 4 ? box->high[2] : box->low[2]};
    }
    add_mesh(scene, corners, CORNERS, triangles, TRIANGLES, 2);
}

/** Adds a sphere as a distance field. */
static inline void add_sphere_sdf(Scene *scene, const SphereSpec *sphere) {
    const double *c = sphere->center;
    Sdf *field = translate_sdf(make_sdf("sphere", &sphere->radius), c[0], c[1], c[2]);
    add_sdf(scene, (SdfShapeParameters){field, CONTRACT_TOLERANCE, 512});
    free(field);
}

/** @return A scene with one shape, to be freed. */
static inline Scene *scene_with(const ContractShape *shape) {
    Error error = {0};
    Scene *scene = create_empty_scene();
    if (strcmp(shape->keyword, "mesh") == 0) {
        add_box_mesh(scene, shape->parameters);
    } else if (strcmp(shape->keyword, "sdf") == 0) {
        add_sphere_sdf(scene, shape->parameters);
    } else {
        add_shape(scene, shape->keyword, shape->parameters);
    }
    assert_true(!shape->transform || scene_set_last_transform(scene, shape->transform, &error));
    return scene;
}

/** @return A tracer with one shape. */
static inline Tracer *tracer_with(const Engine *engine, const ContractShape *shape) {
    Scene *scene = scene_with(shape);
    Tracer *tracer = create_tracer(engine, scene);
    scene_destroy(scene);
    return tracer;
}

/**
 * @return A random ray near a shape, towards points near its centre.
 * @param distance  Distance of its origin, in sizes.
 * @param spread  Largest offset of its target from the centre, in sizes.
 */
static inline RayQueryQuad random_ray(const ContractShape *shape, uint64_t *state, double distance,
                                      double spread) {
    RayQueryQuad ray = {0};
    for (int i = 0; i < 3; i++) {
        double far = distance * shape->size, lateral = spread * shape->size;
        ray.origin[i] = (double)(float)(shape->center[i] + random_float(state, -far, far));
        double target = shape->center[i] + random_float(state, -lateral, lateral);
        ray.direction[i] = (double)(float)(target - (double)ray.origin[i]);
    }
    return ray;
}

#endif
