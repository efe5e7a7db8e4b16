/**
 * @file
 * @brief Every method in the regime where such methods fail (doc/tour.md names them): far spheres
 * and the ground seen from a sphere's surface, edges and corners between quads, rays that just
 *        touch a box, grazing planes, surfaces that coincide.
 */
#include "triangles.h"

/* --- spheres --------------------------------------------------------------------------------- */

/** @return Distance to a sphere at the origin, in quad. @param ray The ray. @param radius Its
 * radius.
 */
static Quadruple sphere_distance(const RayQuery *ray, Quadruple radius) {
    Quadruple a = 0, b = 0, c = -radius * radius;
    for (int i = 0; i < 3; i++) {
        a += ray->direction[i] * ray->direction[i];
        b += ray->origin[i] * ray->direction[i];
        c += ray->origin[i] * ray->origin[i];
    }
    Quadruple root = quad_sqrt(b * b - a * c);
    Quadruple sum = b < 0 ? -b + root : -b - root;
    return b < 0 ? c / sum : sum / a;
}

/** The ground: a sphere of radius 100 to 1e6, seen from 1 above it, where every formula in float
 *  alone is wrong by 1e-3 (doc/tour.md, where float fails). @param engine The engine. */
static void ground_sphere(const Engine *engine) {
    uint64_t state = 1;
    for (double radius = 1e2; radius <= 1e6; radius *= 10) {
        Scene *scene = empty_scene();
        SphereParameters ground = {{0, 0, 0}, radius};
        add_shape(scene, "sphere", &ground);
        Tracer *tracer = prepare(engine, scene);
        double worst = 0, height = radius + 1;
        for (int n = 0; n < 2000; n++) {
            double azimuth = 2 * M_PI * random_share(&state), down = -0.05 - random_share(&state);
            RayQuery ray = {{(float)(0.6 * height), (float)(0.8 * height), 0},
                            {(float)(0.6 * down - 0.8 * cos(azimuth)),
                             (float)(0.8 * down + 0.6 * cos(azimuth)), (float)sin(azimuth)}};
            RayAnswer answer;
            engine->intersect(tracer, 1, &ray, &answer);
            Quadruple truth = sphere_distance(&ray, radius);
            if (answer.shape == 0 && truth > 0) {
                worst = fmax(worst, (double)(quad_abs(answer.distance - truth) / truth));
            }
        }
        assert_at_most(worst, engine->mantissa_bits == 24 ? 2.4e-7 : 1e-9,
                       "ground of radius %g in %s", radius, engine->name);
        engine->release(tracer);
        scene_destroy(scene);
    }
}

/** A sphere 1e3 to 1e6 radii away: none missed, none met that is not there, 0.1 % beside the rim.
 *  @param engine The engine. */
static void far_sphere(const Engine *engine) {
    uint64_t state = 2;
    for (double away = 1e3; away <= 1e6; away *= 10) {
        Scene *scene = empty_scene();
        SphereParameters ball = {{0, 0, 0}, 1};
        add_shape(scene, "sphere", &ball);
        Tracer *tracer = prepare(engine, scene);
        int wrong = 0;
        for (int n = 0; n < 4000; n++) {
            // Aimed with a direction that float holds exactly: 1 away along z, then beside it.
            double rim = n % 2 ? 0.999 : 1.001, angle = 2 * M_PI * random_share(&state);
            RayQuery ray = {{(float)(rim * cos(angle)), (float)(rim * sin(angle)), away},
                            {0, 0, -1}};
            Quadruple beside = ray.origin[0] * ray.origin[0] + ray.origin[1] * ray.origin[1];
            RayAnswer answer;
            engine->intersect(tracer, 1, &ray, &answer);
            wrong += (answer.shape == 0) != (beside <= 1);
        }
        assert_at_most(wrong, 0, "sphere %g radii away in %s, wrong of 4000", away, engine->name);
        engine->release(tracer);
        scene_destroy(scene);
    }
}

/* --- quads ----------------------------------------------------------------------------------- */

/** @return A room of six quads, moved and not square. */
static Scene *quad_room(void) {
    Scene *scene = empty_scene();
    Vector3 a = {-1.25, 0.5, 3.75}, x = {2.5, 0.25, 0.5}, y = {-0.375, 3.125, 0.25},
            z = {0.125, -0.5, 2.25};
    Vector3 far = vector3_add(a, vector3_add(x, vector3_add(y, z)));
    Vector3 minus_x = vector3_scale(x, -1), minus_y = vector3_scale(y, -1),
            minus_z = vector3_scale(z, -1);
    QuadParameters walls[] = {{a, x, y},
                              {a, y, z},
                              {a, z, x},
                              {far, minus_x, minus_y},
                              {far, minus_y, minus_z},
                              {far, minus_z, minus_x}};
    for (size_t i = 0; i < sizeof walls / sizeof *walls; i++) {
        add_shape(scene, "quad", &walls[i]);
    }
    return scene;
}

/** @return A corner of that room, 0 to 7. @param which Which. */
static Vector3 room_corner(unsigned which) {
    Vector3 p = {-1.25, 0.5, 3.75};
    p = which & 1 ? vector3_add(p, (Vector3){2.5, 0.25, 0.5}) : p;
    p = which & 2 ? vector3_add(p, (Vector3){-0.375, 3.125, 0.25}) : p;
    return which & 4 ? vector3_add(p, (Vector3){0.125, -0.5, 2.25}) : p;
}

/** @return A target: a corner of the room, or a point of one of its edges.
 *  @param[in,out] state A generator. @param at_corner Which of the two. */
static Vector3 room_target(uint64_t *state, bool at_corner) {
    unsigned corner = (unsigned)(8 * random_share(state));
    Vector3 from = room_corner(corner);
    if (at_corner) {
        return from;
    }
    unsigned axis = (unsigned)(3 * random_share(state));
    Vector3 to = room_corner(corner ^ (1u << axis));
    return vector3_add(from, vector3_scale(vector3_subtract(to, from), random_share(state)));
}

/** From inside the closed room, rays aimed at its edges and corners: not one gets out. A million of
 *  each (a hundredth in quad). @param engine The engine. */
static void watertight_quads(const Engine *engine) {
    Scene *scene = quad_room();
    Tracer *tracer = prepare(engine, scene);
    RayQuery *rays = calloc(BATCH, sizeof *rays);
    RayAnswer *answers = calloc(BATCH, sizeof *answers);
    uint64_t state = 3;
    for (int at_corner = 0; at_corner < 2; at_corner++) {
        long leaks = 0, count = scaled(engine, 1000000);
        for (long done = 0; done < count; done += BATCH) {
            for (int i = 0; i < BATCH; i++) {
                Vector3 eye = {random_float(&state, -0.5, 0.5), random_float(&state, 1.5, 2.5),
                               random_float(&state, 4.75, 5.75)};
                rays[i] = ray_towards(eye, room_target(&state, at_corner));
            }
            engine->intersect(tracer, BATCH, rays, answers);
            for (int i = 0; i < BATCH; i++) {
                leaks += answers[i].shape < 0 || !answers[i].blocked;
            }
        }
        assert_at_most(leaks, 0, "leaks at %s in %s of %ld", at_corner ? "corners" : "edges",
                       engine->name, count);
    }
    free(rays);
    free(answers);
    engine->release(tracer);
    scene_destroy(scene);
}

/** Two quads in one plane: the first is seen everywhere, no speckles. @param engine The engine. */
static void coincident_quads(const Engine *engine) {
    Scene *scene = empty_scene();
    QuadParameters first = {{-1, -1, -3}, {2, 0, 0}, {0, 2, 0}};
    QuadParameters second = {{2, 2, -3}, {-4, 0, 0}, {0, -4, 0}};
    add_shape(scene, "quad", &first);
    add_shape(scene, "quad", &second);
    Tracer *tracer = prepare(engine, scene);
    uint64_t state = 4;
    for (int n = 0; n < 20000; n++) {
        Vector3 eye = {random_float(&state, -3, 3), random_float(&state, -3, 3), 0};
        Vector3 aim = {random_float(&state, -0.99, 0.99), random_float(&state, -0.99, 0.99), -3};
        RayQuery ray = ray_towards(eye, aim);
        RayAnswer answer;
        engine->intersect(tracer, 1, &ray, &answer);
        assert_int_equal(answer.shape, 0);
    }
    engine->release(tracer);
    scene_destroy(scene);
}

/* --- planes ---------------------------------------------------------------------------------- */

/** A floor whose point lies a million away, seen at 30 to 0.001 degrees from 1 above: the distance
 * is right to some ulps over the sine of the angle. @param engine The engine. */
static void grazing_plane(const Engine *engine) {
    Scene *scene = empty_scene();
    PlaneParameters floor = {{1e6, -1, -1e6}, {0, 1, 0}};
    add_shape(scene, "plane", &floor);
    Tracer *tracer = prepare(engine, scene);
    for (double degrees = 30; degrees > 0.0005; degrees /= 10) {
        double sine = (double)(float)sin(degrees * M_PI / 180);
        RayQuery ray = {{0, 0, 0}, {0, -sine, -1}};
        RayAnswer answer;
        engine->intersect(tracer, 1, &ray, &answer);
        assert_int_equal(answer.shape, 0);
        Quadruple truth = 1 / (Quadruple)sine;
        assert_at_most(quad_abs(answer.distance - truth) / truth / roundoff(engine), 4,
                       "floor at %g degrees in %s, half ulps", degrees, engine->name);
    }
    RayQuery level = {{0, 0, 0}, {0.5, 0, -1}}, in_plane = {{0, -1, 0}, {0.5, 0, -1}};
    RayAnswer answer;
    engine->intersect(tracer, 1, &level, &answer);
    assert_int_equal(answer.shape, -1);
    engine->intersect(tracer, 1, &in_plane, &answer);
    assert_int_equal(answer.shape, -1);
    engine->release(tracer);
    scene_destroy(scene);
}

/* --- boxes ----------------------------------------------------------------------------------- */

/** Rays that truly touch a box, at corners, along edges and in the planes of its faces, with every
 *  sign of zero: none is missed. @param engine The engine. */
static void touching_box(const Engine *engine) {
    Scene *scene = empty_scene();
    BoxParameters box = {{-1, -1, -1}, {1, 1, 1}};
    add_shape(scene, "box", &box);
    Tracer *tracer = prepare(engine, scene);
    uint64_t state = 5;
    long missed = 0, count = scaled(engine, 200000);
    for (long n = 0; n < count; n++) {
        // A point of the surface with one to three coordinates on their planes, and a way to it
        // that float holds exactly, but not its inverse: 64ths, and parallel to some axes.
        double point[3], step[3];
        for (int i = 0; i < 3; i++) {
            point[i] = random_share(&state) < 0.6 ? (random_share(&state) < 0.5 ? -1 : 1)
                                                  : 0.25 * (int)(8 * random_share(&state)) - 1;
            step[i] = random_share(&state) < 0.4 ? (random_share(&state) < 0.5 ? 0.0 : -0.0)
                                                 : (int)(257 * random_share(&state)) / 64.0 - 2;
        }
        bool is_on = fabs(point[0]) == 1 || fabs(point[1]) == 1 || fabs(point[2]) == 1;
        bool is_way = step[0] != 0 || step[1] != 0 || step[2] != 0;
        if (is_on && is_way) {
            RayQuery ray = {
                {point[0] - 3 * step[0], point[1] - 3 * step[1], point[2] - 3 * step[2]},
                {step[0], step[1], step[2]}};
            RayAnswer answer;
            engine->intersect(tracer, 1, &ray, &answer);
            missed += answer.shape != 0 || !answer.blocked;
        }
    }
    assert_at_most(missed, 0, "touching rays missed in %s of %ld", engine->name, count);
    engine->release(tracer);
    scene_destroy(scene);
}

/* --- cylinders ------------------------------------------------------------------------------- */

/** A cylinder 1e2 to 1e4 radii away: none missed, none met that is not there, 0.1 % beside its
 *  outline. @param engine The engine. */
static void far_cylinder(const Engine *engine) {
    uint64_t state = 7;
    for (double away = 1e2; away <= 1e4; away *= 10) {
        Scene *scene = empty_scene();
        CylinderParameters column = {{0, -64, 0}, {0, 64, 0}, 1, true};
        add_shape(scene, "cylinder", &column);
        Tracer *tracer = prepare(engine, scene);
        int wrong = 0;
        for (int n = 0; n < 4000; n++) {
            double beside = (n % 2 ? 0.999 : 1.001) * (n % 4 < 2 ? 1 : -1);
            double rise = random_float(&state, -16, 16);
            RayQuery ray = {{(float)beside, rise, away}, {0, -rise / away, -1}};
            RayAnswer answer;
            engine->intersect(tracer, 1, &ray, &answer);
            wrong +=
                (answer.shape == 0) != (fabs(beside) < 1) || answer.blocked != (answer.shape == 0);
        }
        assert_at_most(wrong, 0, "cylinder %g radii away in %s, wrong of 4000", away, engine->name);
        engine->release(tracer);
        scene_destroy(scene);
    }
}

/** Along the axis of a cylinder, exactly and 1e-4 radians beside: a capped one is met at its ends,
 * a pipe lets through what goes through. @param engine The engine. */
static void cylinder_along_axis(const Engine *engine) {
    for (int capped = 0; capped < 2; capped++) {
        Scene *scene = empty_scene();
        CylinderParameters tube = {{0, 0, -1}, {0, 0, 1}, 1, capped};
        add_shape(scene, "cylinder", &tube);
        Tracer *tracer = prepare(engine, scene);
        uint64_t state = 8;
        for (int n = 0; n < 2000; n++) {
            double x = random_float(&state, -1.2, 1.2), y = random_float(&state, -1.2, 1.2);
            double lean = n % 3 ? 1e-4 : 0, off = sqrt(x * x + y * y);
            bool starts_inside = n % 2;
            RayQuery ray = {{x, y, starts_inside ? 0 : 3}, {(float)lean, n % 5 ? 0.0 : -0.0, -1}};
            RayAnswer answer;
            engine->intersect(tracer, 1, &ray, &answer);
            if (fabs(off - 1) < 1e-3) {
                continue;
            }
            assert_int_equal(answer.shape == 0, off < 1 && capped);
            if (answer.shape == 0) {
                assert_at_most(quad_abs(answer.distance - (starts_inside ? 1 : 2)), 4e-7,
                               "end of a cylinder in %s", engine->name);
            }
        }
        engine->release(tracer);
        scene_destroy(scene);
    }
}

/** From inside a capped cylinder, a million rays aimed at its rims (a hundredth in quad): not one
 *  gets out. @param engine The engine. */
static void watertight_rim(const Engine *engine) {
    Scene *scene = empty_scene();
    CylinderParameters drum = {{1, 2, 3}, {2.5, 2.75, 1.25}, 1.5, true};
    add_shape(scene, "cylinder", &drum);
    Tracer *tracer = prepare(engine, scene);
    Vector3 axis = vector3_normalize(vector3_subtract(drum.top, drum.base));
    Vector3 across = vector3_normalize(vector3_cross(axis, (Vector3){1, 0, 0}));
    Vector3 other = vector3_cross(axis, across);
    RayQuery *rays = calloc(BATCH, sizeof *rays);
    RayAnswer *answers = calloc(BATCH, sizeof *answers);
    uint64_t state = 9;
    long leaks = 0, count = scaled(engine, 1000000);
    for (long done = 0; done < count; done += BATCH) {
        for (int i = 0; i < BATCH; i++) {
            double angle = 2 * M_PI * random_share(&state);
            Vector3 eye = {random_float(&state, 1.5, 2), random_float(&state, 2.2, 2.6),
                           random_float(&state, 1.9, 2.4)};
            Vector3 arm = vector3_add(vector3_scale(across, 1.5 * cos(angle)),
                                      vector3_scale(other, 1.5 * sin(angle)));
            rays[i] = ray_towards(eye, vector3_add(i % 2 ? drum.base : drum.top, arm));
        }
        engine->intersect(tracer, BATCH, rays, answers);
        for (int i = 0; i < BATCH; i++) {
            leaks += answers[i].shape < 0 || !answers[i].blocked;
        }
    }
    assert_at_most(leaks, 0, "leaks at rims in %s of %ld", engine->name, count);
    free(rays);
    free(answers);
    engine->release(tracer);
    scene_destroy(scene);
}

/* --- triangles ------------------------------------------------------------------------------- */

/** @return How many rays at a mesh: without packets each asks all of its triangles.
 *  @param engine The engine. */
static long mesh_rays(const Engine *engine) {
    return engine->mantissa_bits > 64 ? 640 : engine->lanes == 1 ? 20032 : 1000000;
}

/** From inside a closed mesh, rays aimed at its edges and corners, 64 at one of them: not one gets
 *  out. @param engine The engine. */
static void watertight_triangles(const Engine *engine) {
    enum { TOGETHER = 64 };
    Triangles mesh = icosphere(3);
    Scene *scene = empty_scene();
    for (size_t i = 0; i < mesh.triangle_count; i++) {
        TriangleParameters face = {0};
        for (size_t corner = 0; corner < 3; corner++) {
            face.corners[corner] = triangles_corner(&mesh, i, corner);
        }
        add_shape(scene, "triangle", &face);
    }
    Tracer *tracer = prepare(engine, scene);
    uint64_t state = 10;
    RayQuery rays[TOGETHER];
    RayAnswer answers[TOGETHER];
    for (int at_corner = 0; at_corner < 2; at_corner++) {
        long leaks = 0, count = mesh_rays(engine);
        for (long done = 0; done < count; done += TOGETHER) {
            size_t face = (size_t)((double)mesh.triangle_count * random_share(&state));
            size_t from = (size_t)(3 * random_share(&state));
            Vector3 corner = triangles_corner(&mesh, face, from);
            Vector3 edge = vector3_subtract(triangles_corner(&mesh, face, (from + 1) % 3), corner);
            Vector3 middle = {random_float(&state, -1, 1), random_float(&state, -1, 1),
                              random_float(&state, -1, 1)};
            for (int i = 0; i < TOGETHER; i++) {
                Vector3 eye = {middle.x + random_float(&state, -0.01, 0.01),
                               middle.y + random_float(&state, -0.01, 0.01), middle.z};
                double share = at_corner ? 0 : random_share(&state);
                rays[i] = ray_towards(eye, vector3_add(corner, vector3_scale(edge, share)));
            }
            engine->intersect(tracer, TOGETHER, rays, answers);
            for (int i = 0; i < TOGETHER; i++) {
                leaks += answers[i].shape < 0 || !answers[i].blocked;
            }
        }
        assert_at_most(leaks, 0, "leaks at %s of triangles in %s of %ld",
                       at_corner ? "corners" : "edges", engine->name, count);
    }
    engine->release(tracer);
    triangles_release(&mesh);
    scene_destroy(scene);
}

/**
 * Holds what a sliver answered against its corners.
 * @param engine  The engine.
 * @param sliver  The triangle.
 * @param ray     The ray.
 * @param answer  The answer: a hit.
 */
static void check_sliver(const Engine *engine, const TriangleParameters *sliver,
                         const RayQuery *ray, const RayAnswer *answer) {
    const Vector3 *v = sliver->corners, n = {(double)answer->normal[0], (double)answer->normal[1],
                                             (double)answer->normal[2]};
    Vector3 origin = {(double)ray->origin[0], (double)ray->origin[1], (double)ray->origin[2]};
    Vector3 d = {(double)ray->direction[0], (double)ray->direction[1], (double)ray->direction[2]};
    double low = HUGE_VAL, high = -HUGE_VAL, slack = engine->mantissa_bits == 24 ? 1e-6 : 1e-12;
    for (int i = 0; i < 3; i++) {
        double depth = vector3_dot(vector3_subtract(v[i], origin), d) / vector3_dot(d, d);
        low = fmin(low, depth);
        high = fmax(high, depth);
    }
    assert_at_most(low - (double)answer->distance, slack * fabs(low), "sliver in front in %s",
                   engine->name);
    assert_at_most((double)answer->distance - high, slack * fabs(high), "sliver behind in %s",
                   engine->name);
    assert_at_most(fabs(vector3_length(n) - 1), 1e-6, "normal of a sliver in %s", engine->name);
    assert_true(answer->error > 0);
    // The normals of all corners look up, and so does the plane's: seen from above or from below.
    Vector3 flat = vector3_normalize(
        vector3_cross(vector3_subtract(v[1], v[0]), vector3_subtract(v[2], v[0])));
    double side = vector3_dot(d, flat) * (flat.y > 0 ? 1 : -1);
    if (fabs(side) > 1e-3 * vector3_length(d)) {
        if ((vector3_dot(d, n) > 0) != (side > 0)) {
            fail_msg("normal on the wrong side in %s: %g %g %g, along %g %g %g", engine->name, n.x,
                     n.y, n.z, d.x, d.y, d.z);
        }
    }
}

/** One triangle, a hundred long, seen at an angle. @param engine The engine. @param aspect How many
 *  times as long as wide. @param degrees The angle. @param[in,out] state A generator. */
static void one_sliver(const Engine *engine, double aspect, double degrees, uint64_t *state) {
    Scene *scene = empty_scene();
    TriangleParameters sliver = {
        .corners = {{1, 2, -3}, {101, 2.5, -3.25}, {51, 2.25, (float)(-3.125 - 100 / aspect)}},
        .normals = {{0.1, 1, 0}, {-0.1, 1, 0.2}, {0, 1, -5}},
        .is_smooth = degrees < 20};
    const Vector3 *v = sliver.corners;
    add_shape(scene, "triangle", &sliver);
    Tracer *tracer = prepare(engine, scene);
    double height = 20 * tan(degrees * M_PI / 180);
    int met = 0;
    for (int n = 0; n < 2000; n++) {
        double a = random_share(state), b = (1 - a) * random_share(state);
        Vector3 aim = vector3_add(vector3_scale(v[0], a), vector3_scale(v[1], b));
        aim = vector3_add(aim, vector3_scale(v[2], 1 - a - b));
        Vector3 way = {random_float(state, -20, 20), n % 2 ? height : -height, 20};
        RayQuery ray = ray_towards(vector3_add(aim, way), aim);
        RayAnswer answer;
        engine->intersect(tracer, 1, &ray, &answer);
        if (answer.shape == 0) {
            met++;
            check_sliver(engine, &sliver, &ray, &answer);
        }
    }
    assert_true(met > 1000 || aspect > 1e4 || degrees < 1);
    engine->release(tracer);
    scene_destroy(scene);
}

/** Triangles as narrow as a millionth of their length, seen at 30 to 0.1 degrees: what is met lies
 *  between their corners, and the normal is a number and on the right side. @param engine The
 *  engine. */
static void slivers(const Engine *engine) {
    uint64_t state = 11;
    for (double aspect = 1; aspect <= 1e6; aspect *= 10) {
        for (double degrees = 30; degrees > 0.05; degrees /= 17) {
            one_sliver(engine, aspect, degrees, &state);
        }
    }
}

/* --- packets --------------------------------------------------------------------------------- */

/** Adds a round shape, turned and unevenly scaled. @param scene The scene. @param i Its number.
 *  @param[in,out] state A generator. */
static void add_turned(Scene *scene, int i, uint64_t *state) {
    Error error = {0};
    CylinderParameters tube = {{0, -0.5, 0}, {0, 0.5, 0.25}, 0.375, i % 2};
    SphereParameters ball = {{0.25, 0, 0}, 0.5};
    Transform how = {{random_float(state, 0.2, 2), -random_float(state, 0.2, 1), 0.5},
                     {random_float(state, 0, 360), random_float(state, 0, 360), 90 * (i % 4)},
                     {random_float(state, -4, 4), random_float(state, -4, 4), 0},
                     {{0}}};
    assert_true(transform_keyword.finish(&how, 0, &error));
    add_shape(scene, i % 3 ? "cylinder" : "sphere", i % 3 ? (void *)&tube : (void *)&ball);
    assert_true(scene_transform_shape(scene, &how, &error));
}

/** Two hundred shapes of all kinds, packets and single rays: the intervals of a packet drop
 * nothing, axis-parallel rays included. @param engine The engine. */
static void packets_drop_nothing(const Engine *engine) {
    Scene *scene = empty_scene();
    uint64_t state = 6;
    for (int i = 0; i < 50; i++) {
        Vector3 p = {random_float(&state, -4, 4), random_float(&state, -4, 4),
                     random_float(&state, -4, 4)};
        SphereParameters ball = {p, random_float(&state, 0.1, 0.6)};
        BoxParameters box = {{-p.x, p.y, p.z}, {0.5 - p.x, 0.25 + p.y, 0.75 + p.z}};
        QuadParameters sheet = {{p.y, p.z, p.x}, {0.5, 0, 0}, {0, 0.25, 0.5}};
        add_shape(scene, "sphere", &ball);
        add_shape(scene, i % 2 ? "box" : "quad", i % 2 ? (void *)&box : (void *)&sheet);
        add_turned(scene, i, &state);
    }
    Tracer *tracer = prepare(engine, scene);
    enum { TOGETHER = 64 };
    RayQuery rays[TOGETHER];
    RayAnswer together[TOGETHER], alone;
    for (long n = 0; n < scaled(engine, 5000) + 50; n++) {
        Vector3 eye = {random_float(&state, -6, 6), random_float(&state, -6, 6), 8};
        Vector3 aim = {random_float(&state, -4, 4), random_float(&state, -4, 4), 0};
        double spread = n % 3 ? 0.1 : 0;
        for (int i = 0; i < TOGETHER; i++) {
            Vector3 to = {aim.x + spread * (i % 8), aim.y + spread * (i / 8), aim.z};
            rays[i] = n % 5 ? ray_towards(eye, to)
                            : (RayQuery){{to.x, to.y, 8}, {i % 2 ? 0.0 : -0.0, 0, -1}};
        }
        engine->intersect(tracer, TOGETHER, rays, together);
        for (int i = 0; i < TOGETHER; i += 7) {
            engine->intersect(tracer, 1, &rays[i], &alone);
            assert_int_equal(together[i].shape, alone.shape);
            assert_int_equal(together[i].blocked, alone.blocked);
            assert_memory_equal(&together[i].distance, &alone.distance, sizeof alone.distance);
        }
    }
    engine->release(tracer);
    scene_destroy(scene);
}

/* --- cmocka ---------------------------------------------------------------------------------- */

/** @param state Not used. */
static void test_ground_sphere(void **state) {
    (void)state;
    in_every_engine(ground_sphere);
}

/** @param state Not used. */
static void test_far_sphere(void **state) {
    (void)state;
    in_every_engine(far_sphere);
}

/** @param state Not used. */
static void test_watertight_quads(void **state) {
    (void)state;
    in_every_engine(watertight_quads);
}

/** @param state Not used. */
static void test_coincident_quads(void **state) {
    (void)state;
    in_every_engine(coincident_quads);
}

/** @param state Not used. */
static void test_grazing_plane(void **state) {
    (void)state;
    in_every_engine(grazing_plane);
}

/** @param state Not used. */
static void test_touching_box(void **state) {
    (void)state;
    in_every_engine(touching_box);
}

/** @param state Not used. */
static void test_packets(void **state) {
    (void)state;
    in_every_engine(packets_drop_nothing);
}

/** @param state Not used. */
static void test_far_cylinder(void **state) {
    (void)state;
    in_every_engine(far_cylinder);
}

/** @param state Not used. */
static void test_cylinder_along_axis(void **state) {
    (void)state;
    in_every_engine(cylinder_along_axis);
}

/** @param state Not used. */
static void test_watertight_rim(void **state) {
    (void)state;
    in_every_engine(watertight_rim);
}

/** @param state Not used. */
static void test_watertight_triangles(void **state) {
    (void)state;
    in_every_engine(watertight_triangles);
}

/** @param state Not used. */
static void test_slivers(void **state) {
    (void)state;
    in_every_engine(slivers);
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ground_sphere),
        cmocka_unit_test(test_far_sphere),
        cmocka_unit_test(test_watertight_quads),
        cmocka_unit_test(test_coincident_quads),
        cmocka_unit_test(test_grazing_plane),
        cmocka_unit_test(test_touching_box),
        cmocka_unit_test(test_packets),
        cmocka_unit_test(test_far_cylinder),
        cmocka_unit_test(test_cylinder_along_axis),
        cmocka_unit_test(test_watertight_rim),
        cmocka_unit_test(test_watertight_triangles),
        cmocka_unit_test(test_slivers),
    };
    return cmocka_run_group_tests_name("failures", tests, NULL, NULL);
}
