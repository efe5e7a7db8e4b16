/**
 * @file
 * @brief Queries of the BVH tests, and random rays: all engines of a number type must return
 *        identical bits.
 */
#ifndef TESTS_BVH_QUERIES_H
#define TESTS_BVH_QUERIES_H

#include "triangle_soup.h"
#include "workload.h"

/** Largest number of rays of a packet in any engine. */
enum { RAYS_PER_QUERY = 64 };

/* --- results ---------------------------------------------------------------------------------- */

/** @return Whether two numbers are bitwise equal; false for NaN. */
static inline bool same_bits(Quadruple a, Quadruple b) {
    return a == b && signbit((double)a) == signbit((double)b);
}

/** @return Whether two results are bitwise equal. */
static inline bool same_result(const RayResult *a, const RayResult *b) {
    bool same =
        a->shape == b->shape && a->occluded == b->occluded && same_bits(a->distance, b->distance);
    for (int i = 0; i < 3; i++) {
        same = same && same_bits(a->point[i], b->point[i]) && same_bits(a->normal[i], b->normal[i]);
    }
    return same;
}

/** Fails unless results are bitwise equal. */
static inline void assert_same_results(const Engine *engine, const char *what, int count,
                                       const RayResult *got, const RayResult *wanted) {
    int different = 0, first = -1;
    for (int i = 0; i < count; i++) {
        if (!same_result(&got[i], &wanted[i])) {
            first = first < 0 ? i : first;
            different++;
        }
    }
    if (different > 0) {
        fail_msg("%s in %s: %d of %d rays differ; ray %d: shape %d at %.17g, wanted %d at %.17g",
                 what, engine->name, different, count, first, got[first].shape,
                 (double)got[first].distance, wanted[first].shape, (double)wanted[first].distance);
    }
}

/** A test of one number type. @param reference The engine with one lane. */
typedef void (*TypeTest)(const Engine *reference);

/** Runs a test for every number type. */
static inline void for_every_type(TypeTest test) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if ((*engine)->lanes == 1) {
            test(*engine);
        }
    }
}

/** @return Whether an engine has the number type of another and can run on this machine. */
static inline bool engine_matches_type(const Engine *engine, const Engine *reference) {
    return engine->mantissa_bits == reference->mantissa_bits && engine_is_supported(engine);
}

/**
 * @return Number of batches, at least one.
 * @param reference  The engine; double has half as many, quad one in two hundred.
 */
static inline int batch_count(const Engine *reference, int count) {
    int slowness = reference->mantissa_bits > 64   ? 200
                   : reference->mantissa_bits > 24 ? 2 * WORKLOAD_DIVISOR
                                                   : WORKLOAD_DIVISOR;
    return count > slowness ? count / slowness : 1;
}

/** @return Number of rays in a batch. */
static inline int batch_size(const Engine *reference) {
    return reference->mantissa_bits > 64 ? BATCH / 32 : BATCH;
}

/**
 * Queries a scene in every engine of a number type: all rays together, and a few of them singly.
 * @param reference  The engine with one lane.
 * @param what  Name of the query in the message.
 * @param tracers  One per engine of #engine_list.
 */
static inline void assert_engines_agree(const Engine *reference, const char *what,
                                        Tracer *const *tracers, int count, const RayQueryQuad *rays,
                                        const RayResult *wanted) {
    /** Number of rays queried singly: one ray takes as long as a packet. */
    enum { SINGLE = 512 };
    RayResult *answers = calloc((size_t)count, sizeof *answers);
    assert_non_null(answers);
    for (size_t e = 0; engine_list()[e]; e++) {
        const Engine *engine = engine_list()[e];
        if (!engine_matches_type(engine, reference)) {
            continue;
        }
        engine->intersect(tracers[e], (size_t)count, rays, answers);
        assert_same_results(engine, what, count, answers, wanted);
        int few = count < SINGLE ? count : SINGLE;
        for (int i = 0; i < few && engine->lanes > 1; i++) {
            engine->intersect(tracers[e], 1, &rays[i], &answers[i]);
        }
        assert_same_results(engine, what, few, answers, wanted);
    }
    free(answers);
}

/** Upper bound of the number of engines, with the final NULL. */
enum { ENGINES_MAXIMUM = 16 };

/**
 * Creates the tracers of a scene in every engine of a number type.
 * @param reference  The engine with one lane.
 * @param[out] tracers  One per engine of #engine_list, or NULL.
 */
static inline void create_tracers(const Engine *reference, const Scene *scene,
                                  Tracer *tracers[ENGINES_MAXIMUM]) {
    memset(tracers, 0, ENGINES_MAXIMUM * sizeof *tracers);
    for (size_t e = 0; engine_list()[e]; e++) {
        assert_true(e < ENGINES_MAXIMUM);
        if (engine_matches_type(engine_list()[e], reference)) {
            tracers[e] = create_tracer_with_bvh(engine_list()[e], scene, BVH_ALWAYS);
        }
    }
}

/** Destroys tracers. */
static inline void destroy_tracers(Tracer *tracers[ENGINES_MAXIMUM]) {
    for (size_t e = 0; engine_list()[e]; e++) {
        engine_list()[e]->destroy(tracers[e]);
    }
}

/* --- rays ------------------------------------------------------------------------------------ */

/** Distributions of rays. */
typedef enum {
    RAYS_COHERENT, /**< Packets from one point to neighbouring points. */
    RAYS_RANDOM,   /**< From random points to random points. */
    RAYS_AXIS,     /**< Along an axis; the other two components are 0 or -0. */
    RAYS_IN_PLANE, /**< In a plane perpendicular to an axis, which contains faces. */
    RAYS_FAR,      /**< From distances of 1e3 and 1e6. */
    RAYS_SURFACE,  /**< From hit points of other rays. */
    RAY_KINDS      /**< Number of distributions. */
} RayKind;

/** Half the side of the cube that contains all test scenes. */
#define SCENE_REACH 2

/** Sets three random coordinates. */
static inline void random_point(uint64_t *state, double extent, Quadruple v[3]) {
    for (int i = 0; i < 3; i++) {
        v[i] = random_float(state, -extent, extent);
    }
}

/** @return A coordinate that faces of the test scenes have. */
static inline double random_face_coordinate(uint64_t *state) {
    return floor(random_unit_double(state) * 33 - 16) / 8;
}

/**
 * Sets the direction of a ray towards a target.
 * @param[in,out] ray  The ray, with its origin.
 * @param spread  Largest random offset from the target.
 */
static inline void aim_ray(RayQueryQuad *ray, const Quadruple target[3], uint64_t *state,
                           double spread) {
    for (int i = 0; i < 3; i++) {
        ray->direction[i] = round_to_float((double)(target[i] - ray->origin[i]) +
                                           random_float(state, -spread, spread));
    }
}

/**
 * Makes the rays of one packet, from one point to neighbouring points.
 * @param away Distance of the origin.
 */
static inline void fill_coherent(uint64_t *state, RayQueryQuad *rays, double away) {
    Quadruple eye[3], target[3];
    random_point(state, away, eye);
    random_point(state, SCENE_REACH, target);
    double spread = 0.5 * random_unit_double(state);
    for (int i = 0; i < RAYS_PER_QUERY; i++) {
        memcpy(rays[i].origin, eye, sizeof eye);
        aim_ray(&rays[i], target, state, spread);
    }
}

/** Makes rays along an axis, all in the same direction or not. */
static inline void fill_axis(uint64_t *state, RayQueryQuad *rays) {
    bool is_coherent = random_unit_double(state) < 0.5;
    int ways = (int)(24 * random_unit_double(state));
    for (int i = 0; i < RAYS_PER_QUERY; i++) {
        int way = is_coherent ? ways : (int)(24 * random_unit_double(state)), axis = way / 8;
        random_point(state, SCENE_REACH, rays[i].origin);
        for (int k = 0; k < 3; k++) {
            double sign = way >> k & 1 ? -1 : 1;
            rays[i].direction[k] = k == axis ? sign * random_float(state, 0.5, 2) : sign * 0.0;
            if (k == axis) {
                rays[i].origin[k] = -sign * random_float(state, -1, 4);
            } else if (random_unit_double(state) < 0.5) {
                rays[i].origin[k] = random_face_coordinate(state);
            }
        }
    }
}

/** Makes rays in a plane that contains faces. */
static inline void fill_in_plane(uint64_t *state, RayQueryQuad *rays) {
    int axis = (int)(3 * random_unit_double(state));
    double level = random_face_coordinate(state);
    fill_coherent(state, rays, 2 * SCENE_REACH);
    for (int i = 0; i < RAYS_PER_QUERY; i++) {
        rays[i].origin[axis] = level;
        rays[i].direction[axis] = random_unit_double(state) < 0.5 ? 0.0 : -0.0;
    }
}

/** Makes rays from hit points of other rays. @param engine Finds the hit points. */
static inline void fill_surface(uint64_t *state, RayQueryQuad *rays, const Engine *engine,
                                const Tracer *tracer) {
    RayResult answers[RAYS_PER_QUERY];
    fill_coherent(state, rays, 2 * SCENE_REACH);
    engine->intersect(tracer, RAYS_PER_QUERY, rays, answers);
    for (int i = 0; i < RAYS_PER_QUERY; i++) {
        for (int k = 0; k < 3 && answers[i].shape >= 0; k++) {
            rays[i].origin[k] = answers[i].point[k];
        }
        random_point(state, 1, rays[i].direction);
    }
}

/** Makes a batch of rays. @param engine Finds hit points in the scene. */
static inline void fill_rays(RayKind kind, uint64_t *state, RayQueryQuad *rays, int count,
                             const Engine *engine, const Tracer *tracer) {
    for (int i = 0; i < count; i += RAYS_PER_QUERY) {
        if (kind == RAYS_AXIS) {
            fill_axis(state, rays + i);
        } else if (kind == RAYS_IN_PLANE) {
            fill_in_plane(state, rays + i);
        } else if (kind == RAYS_SURFACE) {
            fill_surface(state, rays + i, engine, tracer);
        } else if (kind == RAYS_COHERENT) {
            fill_coherent(state, rays + i, 2 * SCENE_REACH);
        } else {
            for (int k = i; k < i + RAYS_PER_QUERY && kind == RAYS_RANDOM; k++) {
                random_point(state, 2 * SCENE_REACH, rays[k].origin);
                random_point(state, 1, rays[k].direction);
            }
            if (kind == RAYS_FAR) {
                fill_coherent(state, rays + i, i / RAYS_PER_QUERY % 2 ? 1e3 : 1e6);
            }
        }
    }
}

/** @return A point rounded to float. */
static inline Vec3d point_as_float(Vec3d v) {
    return (Vec3d){round_to_float(v.x), round_to_float(v.y), round_to_float(v.z)};
}

/** @return A random point of the test scenes. */
static inline Vec3d point_in_scene(uint64_t *state) {
    return (Vec3d){random_float(state, -1.6, 1.6), random_float(state, -1.6, 1.6),
                   random_float(state, -1.6, 1.6)};
}

/** Rotates, scales and moves the newest shape. */
static inline void transform_last_shape(Scene *scene, uint64_t *state) {
    Error error = {0};
    Transform how = {{random_float(state, 0.2, 0.6), -random_float(state, 0.2, 0.4), 0.25},
                     {random_float(state, 0, 360), random_float(state, 0, 360), 90},
                     point_in_scene(state),
                     {{0}}};
    assert_true(transform_keyword.finish(&how, 0, &error));
    assert_true(scene_set_last_transform(scene, &how, &error));
}

#endif
