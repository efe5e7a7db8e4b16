/**
 * @file
 * @brief Shafts, checked at one number type and width: the Makefile compiles this file for each
 *        engine, with the engine's flags.
 */
#include "shafts.h"

#include "../random_scalar.h"
#include "../src/trace/shapes/aabb.c"
#include "../src/trace/shapes/box.c"
#include "../src/trace/shapes/cone.c"
#include "../src/trace/shapes/cylinder.c"
#include "../src/trace/shapes/disk.c"
#include "../src/trace/shapes/plane.c"
#include "../src/trace/shapes/sphere.c"
#include "../src/trace/shapes/transformed.c"
#include "../src/trace/shapes/triangle.c"
#include "../src/trace/tracer/packet.c"
#include "../src/trace/tracer/shaft.c"

#if LANES > 1

enum {
    CASES = 20000,               /**< Number of random cases. */
    MOST_CASES = CASES * 9 / 10, /**< Nearly all of them. */
    SHAPES_CHECKED = 240,        /**< Number of shapes whose support is checked. */
    SHAPE_KINDS = 6,             /**< Number of classes with a support, without transforms. */
    RIM_POINTS = 2048            /**< Points of a circle that stand for it. */
};

/** @return A random vector; its coordinates are -1 to 1. */
static Vec3s random_vector(uint64_t *seed) {
    scalar x = 2 * random_scalar(seed) - 1, y = 2 * random_scalar(seed) - 1;
    return (Vec3s){x, y, 2 * random_scalar(seed) - 1};
}

/** @return The part of a vector at a right angle to another, of a length. */
static Vec3s vector_across(Vec3s v, Vec3s other, scalar length) {
    Vec3s across = vec3s_add(v, vec3s_scale(other, -vec3s_dot(v, other) / vec3s_dot(other, other)));
    return vec3s_scale(across, length / SCALAR_SQRT(vec3s_dot(across, across)));
}

/** @return A random beam of one to a thousand pixels. */
static Beam random_beam(uint64_t *seed) {
    const scalar pixels = (scalar)(1 << (int)(11 * random_scalar(seed)));
    Beam beam = {.origin = random_vector(seed), .axis = random_vector(seed)};
    scalar width = pixels / 8192 * SCALAR_SQRT(vec3s_dot(beam.axis, beam.axis));
    beam.across = vector_across(random_vector(seed), beam.axis, width);
    Vec3sw up = vec3sw_cross(vec3s_widen(beam.axis), vec3s_widen(beam.across));
    beam.up = vector_across(vec3s_narrow(up), beam.axis, width / 2);
    return beam;
}

/** @return The centre of a sphere beside a point of a side of a beam. @param distance From the
 *  side, outwards. */
static Vec3sw sphere_beside(uint64_t *seed, const Beam *beam, scalar distance) {
    const bool is_up = random_scalar(seed) < (scalar)0.5;
    const scalar sign = random_scalar(seed) < (scalar)0.5 ? -1 : 1;
    Vec3s edge = vec3s_add(beam->axis, vec3s_scale(is_up ? beam->up : beam->across, sign));
    Vec3s along = vec3s_scale(is_up ? beam->across : beam->up, 2 * random_scalar(seed) - 1);
    Vec3s point = vec3s_add(
        beam->origin, vec3s_scale(vec3s_add(edge, along), 8 * (random_scalar(seed) + (scalar)0.1)));
    Vec3sw normal = vec3sw_cross(vec3s_widen(edge), vec3s_widen(is_up ? beam->across : beam->up));
    bool is_inwards = vec3sw_dot(normal, vec3s_widen(beam->axis)) > 0;
    Vec3sw inwards = vec3sw_scale(vec3sw_normalize(normal), is_inwards ? 1 : -1);
    return vec3sw_subtract(vec3s_widen(point), vec3sw_scale(inwards, (wide_scalar)distance));
}

/** A sphere in an engine. */
static Sphere sphere_at(Vec3sw center, wide_scalar radius) {
    Sphere sphere = {.base = {.class = &sphere_class}};
    const SphereParameters parameters = {vec3d_of(center), (double)radius};
    sphere_init(&sphere.base, &parameters);
    return sphere;
}

/** See #SHAFT_BEAM. */
static const char *check_beam(uint64_t seed) {
    const scalar little = 256 * NARROW_BEAM_SLACK;
    size_t missed = 0;
    for (size_t i = 0; i < CASES; i++) {
        const Beam beam = random_beam(&seed);
        const wide_scalar radius = (wide_scalar)random_scalar(&seed) + (wide_scalar)0.01;
        const Sphere touching = sphere_at(
                         sphere_beside(&seed, &beam, (scalar)radius * (1 - 4 * ROUNDOFF)), radius),
                     beyond =
                         sphere_at(sphere_beside(&seed, &beam, (scalar)radius + little), radius);
        Shaft shaft;
        beam_shaft(&beam, &shaft);
        if (shaft_misses(&shaft, &touching.base)) {
            return "a sphere is missed";
        }
        missed += shaft_misses(&shaft, &beyond.base);
    }
    return missed > CASES / 2 ? NULL : "spheres beside beams are not missed";
}

/** Rays from a box to a point. */
typedef struct RaysToPoint {
    Vec3s middle; /**< The middle of the box. */
    Vec3s half;   /**< Half its size. */
    Vec3s target; /**< The point. */
} RaysToPoint;

/** @return Random rays to a point; some have all one origin. @param offset How far they are from
 *  zero. */
static RaysToPoint random_rays_to_point(uint64_t *seed, scalar offset) {
    const scalar size = random_scalar(seed) < (scalar)0.25 ? 0 : random_scalar(seed) / 4;
    const scalar x = random_scalar(seed), y = random_scalar(seed);
    const Vec3s half = {size * x, size * y, size * random_scalar(seed)}, far = {offset, 0, 0};
    return (RaysToPoint){vec3s_add(random_vector(seed), far), half,
                         vec3s_add(vec3s_scale(random_vector(seed), 8), far)};
}

/** @return The intervals of rays from a box to a point. */
static PacketIntervals intervals_of(const RaysToPoint *rays) {
    const Vec3 target = vec3_splat(rays->target), middle = vec3_splat(rays->middle),
               half = vec3_splat(rays->half);
    return intervals_to_point(vec3_subtract(middle, half), vec3_add(middle, half), &target, 1);
}

/** A sphere. */
typedef struct Ball {
    Vec3sw center;      /**< Its centre. */
    wide_scalar radius; /**< Its radius. */
} Ball;

/** @return A sphere that a ray to a point touches, hardly: a corner of the box is the origin. */
static Ball ball_at_ray(uint64_t *seed, const RaysToPoint *rays) {
    const scalar x = random_scalar(seed) < (scalar)0.5 ? 1 : -1,
                 y = random_scalar(seed) < (scalar)0.5 ? 1 : -1,
                 size =
                     (random_scalar(seed) + (scalar)0.01) / (1 << (int)(20 * random_scalar(seed)));
    Vec3s corner = {rays->half.x * x, rays->half.y * y, rays->half.z};
    Vec3sw target = vec3s_widen(rays->target),
           to_origin = vec3sw_subtract(vec3s_widen(vec3s_add(rays->middle, corner)), target),
           to_point = vec3sw_scale(to_origin, (wide_scalar)(1 + 15 * random_scalar(seed)) / 16),
           side = vec3sw_cross(to_origin, vec3s_widen(random_vector(seed))),
           beside = vec3sw_scale(vec3sw_normalize(side), (wide_scalar)size),
           center = vec3sw_subtract(target, vec3sw_subtract(beside, to_point)),
           across = vec3sw_cross(vec3sw_subtract(center, target), to_origin);
    // The distance between ray and centre, as this is rounded.
    wide_scalar distance = WIDE_SQRT(vec3sw_dot(across, across) / vec3sw_dot(to_origin, to_origin));
    return (Ball){center, distance * (1 + 4 * (wide_scalar)ROUNDOFF)};
}

/** @return The centre of a sphere beside the cone around the ball around the origins. @param
 *  distance From the cone, outwards. */
static Vec3sw sphere_at_cone(uint64_t *seed, const RaysToPoint *rays, scalar distance) {
    const Vec3s axis = vec3s_add(rays->middle, vec3s_scale(rays->target, -1));
    const scalar length = SCALAR_SQRT(vec3s_dot(axis, axis)),
                 ball = SCALAR_SQRT(vec3s_dot(rays->half, rays->half)), sine = ball / length,
                 cosine = SCALAR_SQRT(1 - sine * sine);
    const Vec3s forward = vec3s_scale(axis, 1 / length),
                across = vector_across(random_vector(seed), axis, 1);
    const Vec3s side = vec3s_add(vec3s_scale(forward, cosine), vec3s_scale(across, sine)),
                outwards = vec3s_add(vec3s_scale(forward, -sine), vec3s_scale(across, cosine));
    const Vec3s from_target =
        vec3s_add(vec3s_scale(side, length * random_scalar(seed)), vec3s_scale(outwards, distance));
    return vec3s_widen(vec3s_add(rays->target, from_target));
}

/** See #SHAFT_CONE. */
static const char *check_cone(uint64_t seed) {
    const scalar little = 128 * COSINE_SLACK, offset = (scalar)(REAL_BITS == 32 ? 0x1p10 : 0x1p40);
    size_t missed = 0;
    for (size_t i = 0; i < CASES; i++) {
        const RaysToPoint rays = random_rays_to_point(&seed, i % 2 ? offset : 0);
        const PacketIntervals intervals = intervals_of(&rays);
        const Ball touched = ball_at_ray(&seed, &rays);
        if (intervals_miss_sphere(&intervals, touched.center, touched.radius)) {
            return "a sphere in the way of rays to a point is missed";
        }
        const RaysToPoint near = random_rays_to_point(&seed, 0);
        const PacketIntervals near_intervals = intervals_of(&near);
        const scalar radius = random_scalar(&seed) + (scalar)0.01;
        Vec3sw beyond = sphere_at_cone(&seed, &near, radius + little);
        missed += intervals_miss_sphere(&near_intervals, beyond, (wide_scalar)radius);
    }
    return missed > MOST_CASES ? NULL : "spheres beside rays to a point are not missed";
}

/** Two of the three coordinates. */
typedef struct Axes {
    int u; /**< The first. */
    int v; /**< The second. */
} Axes;

/**
 * Finds a line from the point to a corner of the box, as two coordinates show it, that has all
 * other corners on one side.
 * @param[out] corner   From the point to that corner.
 * @param[out] outwards A unit vector across the line, to the other side.
 * @return Whether there is one.
 */
static bool find_tangent(const RaysToPoint *rays, Axes axes, double corner[3], double outwards[3]) {
    const Vec3s m = rays->middle, h = rays->half, t = rays->target;
    const double middle[3] = {(double)m.x - (double)t.x, (double)m.y - (double)t.y,
                              (double)m.z - (double)t.z};
    const double half[3] = {(double)h.x, (double)h.y, (double)h.z};
    for (int i = 0; i < 8; i++) { // Four corners, two sides of the line to each.
        const double u = middle[axes.u] + (i & 1 ? half[axes.u] : -half[axes.u]),
                     v = middle[axes.v] + (i & 2 ? half[axes.v] : -half[axes.v]),
                     length = sqrt(u * u + v * v), sign = i & 4 ? 1 : -1;
        memset(corner, 0, 3 * sizeof *corner);
        memset(outwards, 0, 3 * sizeof *outwards);
        corner[axes.u] = u;
        corner[axes.v] = v;
        outwards[axes.u] = sign * v / length;
        outwards[axes.v] = -sign * u / length;
        const double highest =
            middle[axes.u] * outwards[axes.u] + fabs(outwards[axes.u]) * half[axes.u] +
            middle[axes.v] * outwards[axes.v] + fabs(outwards[axes.v]) * half[axes.v];
        if (highest <= 1e-12 * length) {
            return true;
        }
    }
    return false;
}

/** @return A tiny sphere just before the point, on a ray whose direction is rounded. */
static Sphere sphere_at_end(uint64_t *seed, const RaysToPoint *rays) {
    const Vec3s half = rays->half;
    const Vec3s origin =
        vec3s_add(rays->middle, random_scalar(seed) < (scalar)0.5 ? half : vec3s_scale(half, -1));
    const Vec3s direction = vec3s_add(rays->target, vec3s_scale(origin, -1));
    const Vec3sw along =
        vec3sw_scale(vec3s_widen(direction), 1 - (wide_scalar)(random_scalar(seed) * ROUNDOFF));
    return sphere_at(vec3sw_subtract(along, vec3s_widen(vec3s_scale(origin, -1))),
                     (wide_scalar)(ROUNDOFF * ROUNDOFF));
}

/** See #SHAFT_POINT. */
static const char *check_point(uint64_t seed) {
    const scalar little = 1024 * REGION_SLACK, offset = (scalar)(REAL_BITS == 32 ? 0x1p10 : 0x1p40);
    size_t beside = 0, missed = 0;
    for (size_t i = 0; i < CASES; i++) {
        const RaysToPoint rays = random_rays_to_point(&seed, i % 2 ? offset : 0);
        const PacketIntervals intervals = intervals_of(&rays);
        const Ball ball = ball_at_ray(&seed, &rays);
        const Sphere touched = sphere_at(ball.center, ball.radius),
                     at_end = sphere_at_end(&seed, &rays);
        Shaft shaft;
        intervals_shaft(&intervals, &shaft);
        if (shaft_misses(&shaft, &touched.base)) {
            return "a sphere in the way of rays to a point is missed";
        }
        if (shaft_misses(&shaft, &at_end.base)) {
            return "a sphere at the end of a ray is missed";
        }
        const RaysToPoint near = random_rays_to_point(&seed, 0);
        const PacketIntervals near_intervals = intervals_of(&near);
        const Axes axes = {(int)(i % 3), (int)((i + 1) % 3)};
        const double along = (double)random_scalar(&seed),
                     radius = (double)random_scalar(&seed) + 0.01;
        double corner[3], outwards[3];
        if (find_tangent(&near, axes, corner, outwards)) {
            const double distance = radius + (double)little;
            const Vec3d from_target = {along * corner[0] + distance * outwards[0],
                                       along * corner[1] + distance * outwards[1],
                                       along * corner[2] + distance * outwards[2]};
            const Sphere beyond =
                sphere_at(vec3sw_of(vec3d_add(vec3d_of(vec3s_widen(near.target)), from_target)),
                          (wide_scalar)radius);
            intervals_shaft(&near_intervals, &shaft);
            missed += shaft_misses(&shaft, &beyond.base);
            beside++;
        }
    }
    return beside < CASES / 2         ? "there are no tangents"
           : 10 * missed < 9 * beside ? "spheres beside rays to a point are not missed"
                                      : NULL;
}

/** See #SHAFT_PLANE. */
static const char *check_plane(uint64_t seed) {
    size_t missed = 0;
    for (size_t i = 0; i < CASES; i++) {
        const scalar offset = i % 2 ? (scalar)0x1p10 : 0;
        const RaysToPoint rays = random_rays_to_point(&seed, offset);
        const PacketIntervals intervals = intervals_of(&rays);
        // Through the target or a point near it, the plane has the box on one side or cuts it.
        const Vec3s away = vec3s_scale(random_vector(&seed), random_scalar(&seed));
        Plane plane = {.base = {.class = &plane_class}};
        const PlaneParameters parameters = {
            vec3d_of(vec3s_widen(vec3s_add(i % 4 < 2 ? rays.target : rays.middle, away))),
            vec3d_of(vec3s_widen(random_vector(&seed)))};
        plane_init(&plane.base, &parameters);
        const bool is_missed = plane_equation_misses_region(&plane.equation, &intervals.region);
        missed += is_missed;
        for (int corner = 0; is_missed && corner < 8; corner++) {
            const Vec3s toward = {corner & 1 ? rays.half.x : -rays.half.x,
                                  corner & 2 ? rays.half.y : -rays.half.y,
                                  corner & 4 ? rays.half.z : -rays.half.z};
            const Vec3 origin = vec3_splat(vec3s_add(rays.middle, toward));
            const Ray ray = ray_of(origin, vec3_subtract(vec3_splat(rays.target), origin));
            if (any(plane_is_occluding(&plane.base, &ray, mask_of(true), real_of(1)))) {
                return "a plane in the way of rays to a point is missed";
            }
        }
    }
    return missed > CASES / 8 ? NULL : "planes beside rays to a point are not missed";
}

/* --- supports --------------------------------------------------------------------------------- */

/** Points of a surface; the farthest of them is about the farthest of all. */
typedef struct SurfacePoints {
    Vec3d points[2 * RIM_POINTS]; /**< The points. */
    size_t count;                 /**< How many. */
    Vec3d axis;                   /**< An axis of the shape: directions near it are checked, too. */
} SurfacePoints;

/** Adds points of a circle. @param axis Of any length. */
static void add_circle(SurfacePoints *surface, Vec3d center, Vec3d axis, double radius) {
    const Vec3d other = fabs(axis.x) < fabs(axis.y) ? (Vec3d){1, 0, 0} : (Vec3d){0, 1, 0};
    const Vec3d u = vec3d_normalize(vec3d_cross(axis, other)),
                v = vec3d_normalize(vec3d_cross(axis, u));
    for (int i = 0; i < RIM_POINTS; i++) {
        const double angle = 2 * M_PI * i / RIM_POINTS;
        surface->points[surface->count++] =
            vec3d_add(center, vec3d_add(vec3d_scale(u, radius * cos(angle)),
                                        vec3d_scale(v, radius * sin(angle))));
    }
}

/** Adds points of a sphere, equally dense (Swinbank, Purser, *Fibonacci Grids*, 2006). */
static void add_sphere(SurfacePoints *surface, Vec3d center, double radius) {
    const double golden_angle = M_PI * (3 - sqrt(5));
    for (int i = 0; i < 2 * RIM_POINTS; i++) {
        const double z = 1 - (i + 0.5) / RIM_POINTS, across = sqrt(1 - z * z),
                     angle = golden_angle * i;
        surface->points[surface->count++] = vec3d_add(
            center, vec3d_scale((Vec3d){across * cos(angle), across * sin(angle), z}, radius));
    }
}

/** A shape of any of the classes with a support. */
typedef union AnyShape {
    Shape base;        /**< Its base. */
    Sphere sphere;     /**< Any of these. */
    Box box;           /**< See above. */
    Cylinder cylinder; /**< See above. */
    Cone cone;         /**< See above. */
    Disk disk;         /**< See above. */
    Triangle triangle; /**< See above. */
} AnyShape;

/** Initialises a shape. */
static void any_shape_init(AnyShape *shape, const ShapeClass *class, const void *parameters) {
    shape->base = (Shape){.class = class};
    class->init(&shape->base, parameters);
}

/** @return A random vector in double. @param size Its largest coordinate, at most. */
static Vec3d random_vec3d(uint64_t *seed, double size) {
    return vec3d_scale(vec3d_of(vec3s_widen(random_vector(seed))), size);
}

/** Makes a random shape and points of its surface. @param kind 0 to #SHAPE_KINDS - 1. */
static void random_shape(uint64_t *seed, int kind, AnyShape *shape, SurfacePoints *surface) {
    const Vec3d a = random_vec3d(seed, 2), b = random_vec3d(seed, 2), c = random_vec3d(seed, 2);
    const double radius = (double)random_scalar(seed) + 0.01,
                 other_radius = (double)random_scalar(seed);
    surface->count = 0;
    surface->axis = kind == 4 ? b : vec3d_subtract(b, a);
    if (kind == 0) {
        any_shape_init(shape, &sphere_class, &(SphereParameters){a, radius});
        add_sphere(surface, a, radius);
    } else if (kind == 1) {
        const Vec3d high = {a.x + fabs(b.x), a.y + fabs(b.y), a.z + fabs(b.z)};
        any_shape_init(shape, &box_class, &(BoxParameters){a, high});
        for (int i = 0; i < 8; i++) {
            surface->points[surface->count++] =
                (Vec3d){i & 1 ? high.x : a.x, i & 2 ? high.y : a.y, i & 4 ? high.z : a.z};
        }
    } else if (kind == 2) {
        any_shape_init(shape, &cylinder_class, &(CylinderParameters){a, b, radius, true});
        add_circle(surface, a, vec3d_subtract(b, a), radius);
        add_circle(surface, b, vec3d_subtract(b, a), radius);
    } else if (kind == 3) {
        any_shape_init(shape, &cone_class, &(ConeParameters){a, b, radius, other_radius, true});
        add_circle(surface, a, vec3d_subtract(b, a), radius);
        add_circle(surface, b, vec3d_subtract(b, a), other_radius);
    } else if (kind == 4) {
        any_shape_init(shape, &disk_class, &(DiskParameters){a, b, radius});
        add_circle(surface, a, b, radius);
    } else {
        any_shape_init(shape, &triangle_class, &(TriangleParameters){.corners = {a, b, c}});
        surface->points[0] = a;
        surface->points[1] = b;
        surface->points[2] = c;
        surface->count = 3;
    }
}

/** @return What is wrong with the support of a shape; NULL: nothing is. @param size Of the shape.
 */
static const char *check_reach(uint64_t *seed, const Shape *shape, const SurfacePoints *surface,
                               double size) {
    const Vec3s from = vec3s_scale(random_vector(seed), random_scalar(seed) < (scalar)0.5 ? 2 : 64);
    const Vec3d origin = vec3d_of(vec3s_widen(from));
    const scalar tilt = 2 * SCALAR_SQRT(ROUNDOFF) * random_scalar(seed);
    Vec3 directions;
    Vec3d direction[LANES];
    for (int lane = 0; lane < LANES; lane++) {
        // Also near the axis, where the root of a circle is near 0, and along those of the scene.
        const int kind = (int)(6 * random_scalar(seed));
        Vec3s d = random_vector(seed);
        Vec3sw near_axis =
            vec3sw_subtract(vec3sw_of(surface->axis), vec3s_widen(vec3s_scale(d, tilt)));
        d = kind == 0 ? (Vec3s){1, 0, 0} : kind < 3 ? vec3s_narrow(near_axis) : d;
        real_set_lane(&directions.x, lane, d.x);
        real_set_lane(&directions.y, lane, d.y);
        real_set_lane(&directions.z, lane, d.z);
        direction[lane] = vec3d_of(vec3s_widen(d));
    }
    const real reach = shape->class->support(shape, from, directions);
    for (int lane = 0; lane < LANES; lane++) {
        double farthest = -HUGE_VAL;
        for (size_t i = 0; i < surface->count; i++) {
            farthest = fmax(farthest,
                            vec3d_dot(direction[lane], vec3d_subtract(surface->points[i], origin)));
        }
        const double found = (double)real_lane(reach, lane);
        if (!(found >= farthest)) {
            return "a shape reaches farther";
        }
        if (found > farthest + (0.002 * size + 0.001 * vec3d_length(origin)) *
                                   vec3d_length(direction[lane])) {
            return "a shape does not reach as far";
        }
    }
    return NULL;
}

/** See #SHAFT_SUPPORT. */
static const char *check_support(uint64_t seed) {
    static SurfacePoints surface;
    const char *fault = NULL;
    for (int i = 0; i < SHAPES_CHECKED && !fault; i++) {
        AnyShape shape;
        random_shape(&seed, i % SHAPE_KINDS, &shape, &surface);
        fault = check_reach(&seed, &shape.base, &surface, 10);
        Transform transform = {.scale = {1, 1, 1}, .translate = random_vec3d(&seed, 4)};
        for (int row = 0; row < 3; row++) {
            const Vec3d numbers = random_vec3d(&seed, 3);
            const double row_numbers[3] = {numbers.x, numbers.y, numbers.z};
            memcpy(transform.matrix[row], row_numbers, sizeof row_numbers);
            transform.matrix[row][row] += 4; // So that it has an inverse.
        }
        for (size_t p = 0; p < surface.count; p++) {
            surface.points[p] = transform_point(&transform, surface.points[p]);
        }
        TransformedShape transformed = {.base = {.class = &transformed_class}};
        transformed_init(&transformed.base, &(TransformedParameters){&transform, &shape.base});
        fault = fault ? fault : check_reach(&seed, &transformed.base, &surface, 100);
    }
    return fault;
}

#endif

extern const ShaftChecks CHECKS;
const ShaftChecks CHECKS = {{
#if LANES > 1
    [SHAFT_SUPPORT] = check_support,
    [SHAFT_BEAM] = check_beam,
    [SHAFT_POINT] = check_point,
    [SHAFT_CONE] = check_cone,
    [SHAFT_PLANE] = check_plane,
#else
    [SHAFT_SUPPORT] = NULL, // No method of beams.
#endif
}};
