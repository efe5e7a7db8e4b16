/**
 * @file
 * @brief Intersection methods in cases that are numerically difficult (doc/tour.md): distant
 *        spheres, the ground as a sphere, edges and vertices between quads, rays that touch a box,
 *        grazing planes, coincident surfaces.
 */
#include "triangle_soup.h"

/* --- spheres --------------------------------------------------------------------------------- */

/** @return Distance to a sphere at the origin, in quad. */
static Quadruple sphere_distance(const RayQueryQuad *ray, Quadruple radius) {
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

/**
 * The ground: a sphere of radius 100 to 1e6, seen from 1 above it, where formulas in plain float
 * are wrong by 1e-3 (doc/tour.md).
 */
static void ground_sphere(const Engine *engine) {
    uint64_t state = 1;
    for (double radius = 1e2; radius <= 1e6; radius *= 10) {
        Scene *scene = create_empty_scene();
        SphereParameters ground = {{0, 0, 0}, radius};
        add_shape(scene, "sphere", &ground);
        Tracer *tracer = create_tracer(engine, scene);
        double worst = 0, height = radius + 1;
        for (int n = 0; n < 2000; n++) {
            double azimuth = 2 * M_PI * random_unit_double(&state),
                   down = -0.05 - random_unit_double(&state);
            RayQueryQuad ray = {{(float)(0.6 * height), (float)(0.8 * height), 0},
                                {(float)(0.6 * down - 0.8 * cos(azimuth)),
                                 (float)(0.8 * down + 0.6 * cos(azimuth)), (float)sin(azimuth)}};
            RayResult answer;
            engine->intersect(tracer, 1, &ray, &answer);
            Quadruple truth = sphere_distance(&ray, radius);
            if (answer.shape == 0 && truth > 0) {
                worst = fmax(worst, (double)(quad_abs(answer.distance - truth) / truth));
            }
        }
        assert_at_most(worst, engine->mantissa_bits == 24 ? 2.4e-7 : 1e-9,
                       "ground of radius %g in %s", radius, engine->name);
        engine->destroy(tracer);
        scene_destroy(scene);
    }
}

/**
 * A sphere at a distance of 1e3 to 1e6 radii: no false hits or misses, for rays 0.1 % inside or
 * outside the rim.
 */
static void far_sphere(const Engine *engine) {
    uint64_t state = 2;
    for (double away = 1e3; away <= 1e6; away *= 10) {
        Scene *scene = create_empty_scene();
        SphereParameters sphere = {{0, 0, 0}, 1};
        add_shape(scene, "sphere", &sphere);
        Tracer *tracer = create_tracer(engine, scene);
        int wrong = 0;
        for (int n = 0; n < 4000; n++) {
            // The direction is exact in float: 1 along z, plus the lateral offset.
            double rim = n % 2 ? 0.999 : 1.001, angle = 2 * M_PI * random_unit_double(&state);
            RayQueryQuad ray = {{(float)(rim * cos(angle)), (float)(rim * sin(angle)), away},
                                {0, 0, -1}};
            Quadruple lateral = ray.origin[0] * ray.origin[0] + ray.origin[1] * ray.origin[1];
            RayResult answer;
            engine->intersect(tracer, 1, &ray, &answer);
            wrong += (answer.shape == 0) != (lateral <= 1);
        }
        assert_at_most(wrong, 0, "sphere %g radii away in %s, wrong of 4000", away, engine->name);
        engine->destroy(tracer);
        scene_destroy(scene);
    }
}

/* --- quads ----------------------------------------------------------------------------------- */

/** @return A room of six quads, moved and skewed. */
static Scene *quad_room(void) {
    Scene *scene = create_empty_scene();
    Vec3d a = {-1.25, 0.5, 3.75}, x = {2.5, 0.25, 0.5}, y = {-0.375, 3.125, 0.25},
          z = {0.125, -0.5, 2.25};
    Vec3d far = vec3d_add(a, vec3d_add(x, vec3d_add(y, z)));
    Vec3d minus_x = vec3d_scale(x, -1), minus_y = vec3d_scale(y, -1), minus_z = vec3d_scale(z, -1);
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

/** @return A corner of that room. @param which Index, 0 to 7. */
static Vec3d room_corner(unsigned which) {
    Vec3d p = {-1.25, 0.5, 3.75};
    p = which & 1 ? vec3d_add(p, (Vec3d){2.5, 0.25, 0.5}) : p;
    p = which & 2 ? vec3d_add(p, (Vec3d){-0.375, 3.125, 0.25}) : p;
    return which & 4 ? vec3d_add(p, (Vec3d){0.125, -0.5, 2.25}) : p;
}

/**
 * @return A target: a corner of the room, or a point of one of its edges.
 * @param at_corner  Whether it is a corner.
 */
static Vec3d room_target(uint64_t *state, bool at_corner) {
    unsigned corner = (unsigned)(8 * random_unit_double(state));
    Vec3d from = room_corner(corner);
    if (at_corner) {
        return from;
    }
    unsigned axis = (unsigned)(3 * random_unit_double(state));
    Vec3d to = room_corner(corner ^ (1u << axis));
    return vec3d_add(from, vec3d_scale(vec3d_subtract(to, from), random_unit_double(state)));
}

/**
 * From inside the closed room, every ray to its edges and corners hits it. A million rays each (a
 * hundredth in quad).
 */
static void watertight_quads(const Engine *engine) {
    Scene *scene = quad_room();
    Tracer *tracer = create_tracer(engine, scene);
    RayQueryQuad *rays = calloc(BATCH, sizeof *rays);
    RayResult *answers = calloc(BATCH, sizeof *answers);
    uint64_t state = 3;
    for (int at_corner = 0; at_corner < 2; at_corner++) {
        long leaks = 0, count = ray_count_for(engine, 1000000);
        for (long done = 0; done < count; done += BATCH) {
            for (int i = 0; i < BATCH; i++) {
                Vec3d eye = {random_float(&state, -0.5, 0.5), random_float(&state, 1.5, 2.5),
                             random_float(&state, 4.75, 5.75)};
                rays[i] = ray_towards(eye, room_target(&state, at_corner));
            }
            engine->intersect(tracer, BATCH, rays, answers);
            for (int i = 0; i < BATCH; i++) {
                leaks += answers[i].shape < 0 || !answers[i].occluded;
            }
        }
        assert_at_most(leaks, 0, "leaks at %s in %s of %ld", at_corner ? "corners" : "edges",
                       engine->name, count);
    }
    free(rays);
    free(answers);
    engine->destroy(tracer);
    scene_destroy(scene);
}

/** Of two quads in one plane, the first is hit everywhere. */
static void coincident_quads(const Engine *engine) {
    Scene *scene = create_empty_scene();
    QuadParameters first = {{-1, -1, -3}, {2, 0, 0}, {0, 2, 0}};
    QuadParameters second = {{2, 2, -3}, {-4, 0, 0}, {0, -4, 0}};
    add_shape(scene, "quad", &first);
    add_shape(scene, "quad", &second);
    Tracer *tracer = create_tracer(engine, scene);
    uint64_t state = 4;
    for (int n = 0; n < 20000; n++) {
        Vec3d eye = {random_float(&state, -3, 3), random_float(&state, -3, 3), 0};
        Vec3d aim = {random_float(&state, -0.99, 0.99), random_float(&state, -0.99, 0.99), -3};
        RayQueryQuad ray = ray_towards(eye, aim);
        RayResult answer;
        engine->intersect(tracer, 1, &ray, &answer);
        assert_int_equal(answer.shape, 0);
    }
    engine->destroy(tracer);
    scene_destroy(scene);
}

/* --- planes ---------------------------------------------------------------------------------- */

/**
 * A plane given by a point at a distance of a million, seen from 1 above at 30 to 0.001 degrees.
 * The distance is exact to some ulps divided by the sine of the angle.
 */
static void grazing_plane(const Engine *engine) {
    Scene *scene = create_empty_scene();
    PlaneParameters floor = {{1e6, -1, -1e6}, {0, 1, 0}};
    add_shape(scene, "plane", &floor);
    Tracer *tracer = create_tracer(engine, scene);
    for (double degrees = 30; degrees > 0.0005; degrees /= 10) {
        double sine = (double)(float)sin(degrees * M_PI / 180);
        RayQueryQuad ray = {{0, 0, 0}, {0, -sine, -1}};
        RayResult answer;
        engine->intersect(tracer, 1, &ray, &answer);
        assert_int_equal(answer.shape, 0);
        Quadruple truth = 1 / (Quadruple)sine;
        assert_at_most(quad_abs(answer.distance - truth) / truth / roundoff(engine), 4,
                       "floor at %g degrees in %s, half ulps", degrees, engine->name);
    }
    RayQueryQuad level = {{0, 0, 0}, {0.5, 0, -1}}, in_plane = {{0, -1, 0}, {0.5, 0, -1}};
    RayResult answer;
    engine->intersect(tracer, 1, &level, &answer);
    assert_int_equal(answer.shape, -1);
    engine->intersect(tracer, 1, &in_plane, &answer);
    assert_int_equal(answer.shape, -1);
    engine->destroy(tracer);
    scene_destroy(scene);
}

/* --- boxes ----------------------------------------------------------------------------------- */

/**
 * Rays that exactly touch a box, at corners, along edges and in the planes of its faces, with all
 * signs of zero: none misses.
 */
static void touching_box(const Engine *engine) {
    Scene *scene = create_empty_scene();
    BoxParameters box = {{-1, -1, -1}, {1, 1, 1}};
    add_shape(scene, "box", &box);
    Tracer *tracer = create_tracer(engine, scene);
    uint64_t state = 5;
    long missed = 0, count = ray_count_for(engine, 200000);
    for (long n = 0; n < count; n++) {
        // A point of the surface with one to three coordinates on face planes. The direction to it
        // is exact in float, but its inverse is not: multiples of 1/64, some parallel to axes.
        double point[3], step[3];
        for (int i = 0; i < 3; i++) {
            point[i] = random_unit_double(&state) < 0.6
                           ? (random_unit_double(&state) < 0.5 ? -1 : 1)
                           : 0.25 * (int)(8 * random_unit_double(&state)) - 1;
            step[i] = random_unit_double(&state) < 0.4
                          ? (random_unit_double(&state) < 0.5 ? 0.0 : -0.0)
                          : (int)(257 * random_unit_double(&state)) / 64.0 - 2;
        }
        bool is_on = fabs(point[0]) == 1 || fabs(point[1]) == 1 || fabs(point[2]) == 1;
        bool is_way = step[0] != 0 || step[1] != 0 || step[2] != 0;
        if (is_on && is_way) {
            RayQueryQuad ray = {
                {point[0] - 3 * step[0], point[1] - 3 * step[1], point[2] - 3 * step[2]},
                {step[0], step[1], step[2]}};
            RayResult answer;
            engine->intersect(tracer, 1, &ray, &answer);
            missed += answer.shape != 0 || !answer.occluded;
        }
    }
    assert_at_most(missed, 0, "touching rays missed in %s of %ld", engine->name, count);
    engine->destroy(tracer);
    scene_destroy(scene);
}

/* --- cylinders ------------------------------------------------------------------------------- */

/**
 * A cylinder at a distance of 1e2 to 1e4 radii: no false hits or misses, for rays 0.1 % inside or
 * outside the silhouette.
 */
static void far_cylinder(const Engine *engine) {
    uint64_t state = 7;
    for (double away = 1e2; away <= 1e4; away *= 10) {
        Scene *scene = create_empty_scene();
        CylinderParameters column = {{0, -64, 0}, {0, 64, 0}, 1, true};
        add_shape(scene, "cylinder", &column);
        Tracer *tracer = create_tracer(engine, scene);
        int wrong = 0;
        for (int n = 0; n < 4000; n++) {
            double lateral = (n % 2 ? 0.999 : 1.001) * (n % 4 < 2 ? 1 : -1);
            double rise = random_float(&state, -16, 16);
            RayQueryQuad ray = {{(float)lateral, rise, away}, {0, -rise / away, -1}};
            RayResult answer;
            engine->intersect(tracer, 1, &ray, &answer);
            wrong += (answer.shape == 0) != (fabs(lateral) < 1) ||
                     answer.occluded != (answer.shape == 0);
        }
        assert_at_most(wrong, 0, "cylinder %g radii away in %s, wrong of 4000", away, engine->name);
        engine->destroy(tracer);
        scene_destroy(scene);
    }
}

/**
 * Rays along the axis of a cylinder, exactly and at 1e-4 radians: they hit the ends of a capped
 * cylinder and pass through an open one.
 */
static void cylinder_along_axis(const Engine *engine) {
    for (int capped = 0; capped < 2; capped++) {
        Scene *scene = create_empty_scene();
        CylinderParameters tube = {{0, 0, -1}, {0, 0, 1}, 1, capped};
        add_shape(scene, "cylinder", &tube);
        Tracer *tracer = create_tracer(engine, scene);
        uint64_t state = 8;
        for (int n = 0; n < 2000; n++) {
            double x = random_float(&state, -1.2, 1.2), y = random_float(&state, -1.2, 1.2);
            double lean = n % 3 ? 1e-4 : 0, error = sqrt(x * x + y * y);
            bool starts_inside = n % 2;
            RayQueryQuad ray = {{x, y, starts_inside ? 0 : 3},
                                {(float)lean, n % 5 ? 0.0 : -0.0, -1}};
            RayResult answer;
            engine->intersect(tracer, 1, &ray, &answer);
            if (fabs(error - 1) < 1e-3) {
                continue;
            }
            assert_int_equal(answer.shape == 0, error < 1 && capped);
            if (answer.shape == 0) {
                assert_at_most(quad_abs(answer.distance - (starts_inside ? 1 : 2)), 4e-7,
                               "end of a cylinder in %s", engine->name);
            }
        }
        engine->destroy(tracer);
        scene_destroy(scene);
    }
}

/**
 * From inside a capped cylinder, all of a million rays to its rims hit it (a hundredth in quad).
 */
static void watertight_rim(const Engine *engine) {
    Scene *scene = create_empty_scene();
    CylinderParameters drum = {{1, 2, 3}, {2.5, 2.75, 1.25}, 1.5, true};
    add_shape(scene, "cylinder", &drum);
    Tracer *tracer = create_tracer(engine, scene);
    Vec3d axis = vec3d_normalize(vec3d_subtract(drum.top, drum.base));
    Vec3d across = vec3d_normalize(vec3d_cross(axis, (Vec3d){1, 0, 0}));
    Vec3d other = vec3d_cross(axis, across);
    RayQueryQuad *rays = calloc(BATCH, sizeof *rays);
    RayResult *answers = calloc(BATCH, sizeof *answers);
    uint64_t state = 9;
    long leaks = 0, count = ray_count_for(engine, 1000000);
    for (long done = 0; done < count; done += BATCH) {
        for (int i = 0; i < BATCH; i++) {
            double angle = 2 * M_PI * random_unit_double(&state);
            Vec3d eye = {random_float(&state, 1.5, 2), random_float(&state, 2.2, 2.6),
                         random_float(&state, 1.9, 2.4)};
            Vec3d local = vec3d_add(vec3d_scale(across, 1.5 * cos(angle)),
                                    vec3d_scale(other, 1.5 * sin(angle)));
            rays[i] = ray_towards(eye, vec3d_add(i % 2 ? drum.base : drum.top, local));
        }
        engine->intersect(tracer, BATCH, rays, answers);
        for (int i = 0; i < BATCH; i++) {
            leaks += answers[i].shape < 0 || !answers[i].occluded;
        }
    }
    assert_at_most(leaks, 0, "leaks at rims in %s of %ld", engine->name, count);
    free(rays);
    free(answers);
    engine->destroy(tracer);
    scene_destroy(scene);
}

/* --- triangles ------------------------------------------------------------------------------- */

/** @return Number of rays at a mesh: an engine of one lane tests all triangles per ray. */
static long mesh_rays(const Engine *engine) {
    long count = engine->mantissa_bits > 64 ? 640 : engine->lanes == 1 ? 20032 : 1000000;
    return count / WORKLOAD_DIVISOR;
}

/** From inside a closed mesh, every ray to its edges and vertices hits it; 64 rays per target. */
static void watertight_triangles(const Engine *engine) {
    enum { TOGETHER = 64 };
    TriangleSoup mesh = icosphere_triangles(3);
    Scene *scene = create_empty_scene();
    for (size_t i = 0; i < mesh.triangle_count; i++) {
        TriangleParameters face = {0};
        for (size_t corner = 0; corner < 3; corner++) {
            face.corners[corner] = triangle_soup_vertex(&mesh, i, corner);
        }
        add_shape(scene, "triangle", &face);
    }
    Tracer *tracer = create_tracer(engine, scene);
    uint64_t state = 10;
    RayQueryQuad rays[TOGETHER];
    RayResult answers[TOGETHER];
    for (int at_corner = 0; at_corner < 2; at_corner++) {
        long leaks = 0, count = mesh_rays(engine);
        for (long done = 0; done < count; done += TOGETHER) {
            size_t face = (size_t)((double)mesh.triangle_count * random_unit_double(&state));
            size_t from = (size_t)(3 * random_unit_double(&state));
            Vec3d corner = triangle_soup_vertex(&mesh, face, from);
            Vec3d edge = vec3d_subtract(triangle_soup_vertex(&mesh, face, (from + 1) % 3), corner);
            Vec3d middle = {random_float(&state, -1, 1), random_float(&state, -1, 1),
                            random_float(&state, -1, 1)};
            for (int i = 0; i < TOGETHER; i++) {
                Vec3d eye = {middle.x + random_float(&state, -0.01, 0.01),
                             middle.y + random_float(&state, -0.01, 0.01), middle.z};
                double fraction = at_corner ? 0 : random_unit_double(&state);
                rays[i] = ray_towards(eye, vec3d_add(corner, vec3d_scale(edge, fraction)));
            }
            engine->intersect(tracer, TOGETHER, rays, answers);
            for (int i = 0; i < TOGETHER; i++) {
                leaks += answers[i].shape < 0 || !answers[i].occluded;
            }
        }
        assert_at_most(leaks, 0, "leaks at %s of triangles in %s of %ld",
                       at_corner ? "corners" : "edges", engine->name, count);
    }
    engine->destroy(tracer);
    triangle_soup_destroy(&mesh);
    scene_destroy(scene);
}

/** Checks the hit of a sliver against its vertices. */
static void check_sliver(const Engine *engine, const TriangleParameters *sliver,
                         const RayQueryQuad *ray, const RayResult *answer) {
    const Vec3d *v = sliver->corners, n = {(double)answer->normal[0], (double)answer->normal[1],
                                           (double)answer->normal[2]};
    Vec3d origin = {(double)ray->origin[0], (double)ray->origin[1], (double)ray->origin[2]};
    Vec3d d = {(double)ray->direction[0], (double)ray->direction[1], (double)ray->direction[2]};
    double low = HUGE_VAL, high = -HUGE_VAL, slack = engine->mantissa_bits == 24 ? 1e-6 : 1e-12;
    for (int i = 0; i < 3; i++) {
        double depth = vec3d_dot(vec3d_subtract(v[i], origin), d) / vec3d_dot(d, d);
        low = fmin(low, depth);
        high = fmax(high, depth);
    }
    assert_at_most(low - (double)answer->distance, slack * fabs(low), "sliver in front in %s",
                   engine->name);
    assert_at_most((double)answer->distance - high, slack * fabs(high), "sliver behind in %s",
                   engine->name);
    assert_at_most(fabs(vec3d_length(n) - 1), 1e-6, "normal of a sliver in %s", engine->name);
    assert_true(answer->error > 0);
    // The vertex normals and the plane's normal point up: is the viewer above or below?
    Vec3d flat =
        vec3d_normalize(vec3d_cross(vec3d_subtract(v[1], v[0]), vec3d_subtract(v[2], v[0])));
    double side = vec3d_dot(d, flat) * (flat.y > 0 ? 1 : -1);
    if (fabs(side) > 1e-3 * vec3d_length(d)) {
        if ((vec3d_dot(d, n) > 0) != (side > 0)) {
            fail_msg("normal on the wrong side in %s: %g %g %g, along %g %g %g", engine->name, n.x,
                     n.y, n.z, d.x, d.y, d.z);
        }
    }
}

/** A triangle of length 100, seen at an angle. @param aspect Ratio of length to width. */
static void sliver_triangle(const Engine *engine, double aspect, double degrees, uint64_t *state) {
    Scene *scene = create_empty_scene();
    TriangleParameters sliver = {
        .corners = {{1, 2, -3}, {101, 2.5, -3.25}, {51, 2.25, (float)(-3.125 - 100 / aspect)}},
        .normals = {{0.1, 1, 0}, {-0.1, 1, 0.2}, {0, 1, -5}},
        .is_smooth = degrees < 20};
    const Vec3d *v = sliver.corners;
    add_shape(scene, "triangle", &sliver);
    Tracer *tracer = create_tracer(engine, scene);
    double height = 20 * tan(degrees * M_PI / 180);
    int met = 0;
    for (int n = 0; n < 2000; n++) {
        double a = random_unit_double(state), b = (1 - a) * random_unit_double(state);
        Vec3d aim = vec3d_add(vec3d_scale(v[0], a), vec3d_scale(v[1], b));
        aim = vec3d_add(aim, vec3d_scale(v[2], 1 - a - b));
        Vec3d direction = {random_float(state, -20, 20), n % 2 ? height : -height, 20};
        RayQueryQuad ray = ray_towards(vec3d_add(aim, direction), aim);
        RayResult answer;
        engine->intersect(tracer, 1, &ray, &answer);
        if (answer.shape == 0) {
            met++;
            check_sliver(engine, &sliver, &ray, &answer);
        }
    }
    assert_true(met > 1000 || aspect > 1e4 || degrees < 1);
    engine->destroy(tracer);
    scene_destroy(scene);
}

/**
 * Triangles as narrow as a millionth of their length, seen at 30 to 0.1 degrees. Hits lie between
 * the vertices; normals are not NaN and point to the viewer.
 */
static void sliver_triangles(const Engine *engine) {
    uint64_t state = 11;
    for (double aspect = 1; aspect <= 1e6; aspect *= 10) {
        for (double degrees = 30; degrees > 0.05; degrees /= 17) {
            sliver_triangle(engine, aspect, degrees, &state);
        }
    }
}

/* --- packets --------------------------------------------------------------------------------- */

/** Adds a sphere or cylinder, rotated and unevenly scaled. */
static void add_turned(Scene *scene, int i, uint64_t *state) {
    Error error = {0};
    CylinderParameters tube = {{0, -0.5, 0}, {0, 0.5, 0.25}, 0.375, i % 2};
    SphereParameters sphere = {{0.25, 0, 0}, 0.5};
    Transform how = {{random_float(state, 0.2, 2), -random_float(state, 0.2, 1), 0.5},
                     {random_float(state, 0, 360), random_float(state, 0, 360), 90 * (i % 4)},
                     {random_float(state, -4, 4), random_float(state, -4, 4), 0},
                     {{0}}};
    assert_true(transform_keyword.finish(&how, 0, &error));
    add_shape(scene, i % 3 ? "cylinder" : "sphere", i % 3 ? (void *)&tube : (void *)&sphere);
    assert_true(scene_set_last_transform(scene, &how, &error));
}

/**
 * Two hundred shapes of all kinds: packets find the same hits as single rays, including axis-
 * parallel rays.
 */
static void packets_drop_nothing(const Engine *engine) {
    Scene *scene = create_empty_scene();
    uint64_t state = 6;
    for (int i = 0; i < 50; i++) {
        Vec3d p = {random_float(&state, -4, 4), random_float(&state, -4, 4),
                   random_float(&state, -4, 4)};
        SphereParameters sphere = {p, random_float(&state, 0.1, 0.6)};
        BoxParameters box = {{-p.x, p.y, p.z}, {0.5 - p.x, 0.25 + p.y, 0.75 + p.z}};
        QuadParameters sheet = {{p.y, p.z, p.x}, {0.5, 0, 0}, {0, 0.25, 0.5}};
        add_shape(scene, "sphere", &sphere);
        add_shape(scene, i % 2 ? "box" : "quad", i % 2 ? (void *)&box : (void *)&sheet);
        add_turned(scene, i, &state);
    }
    Tracer *tracer = create_tracer(engine, scene);
    enum { TOGETHER = 64 };
    RayQueryQuad rays[TOGETHER];
    RayResult together[TOGETHER], alone;
    for (long n = 0; n < ray_count_for(engine, 5000) + 50; n++) {
        Vec3d eye = {random_float(&state, -6, 6), random_float(&state, -6, 6), 8};
        Vec3d aim = {random_float(&state, -4, 4), random_float(&state, -4, 4), 0};
        double spread = n % 3 ? 0.1 : 0;
        for (int i = 0; i < TOGETHER; i++) {
            Vec3d to = {aim.x + spread * (i % 8), aim.y + spread * (i / 8), aim.z};
            rays[i] = n % 5 ? ray_towards(eye, to)
                            : (RayQueryQuad){{to.x, to.y, 8}, {i % 2 ? 0.0 : -0.0, 0, -1}};
        }
        engine->intersect(tracer, TOGETHER, rays, together);
        for (int i = 0; i < TOGETHER; i += 7) {
            engine->intersect(tracer, 1, &rays[i], &alone);
            assert_int_equal(together[i].shape, alone.shape);
            assert_int_equal(together[i].occluded, alone.occluded);
            assert_memory_equal(&together[i].distance, &alone.distance, sizeof alone.distance);
        }
    }
    engine->destroy(tracer);
    scene_destroy(scene);
}

/* --- cmocka ---------------------------------------------------------------------------------- */

/** @param state Not used. */
static void test_ground_sphere(void **state) {
    (void)state;
    for_every_engine(ground_sphere);
}

/** @param state Not used. */
static void test_far_sphere(void **state) {
    (void)state;
    for_every_engine(far_sphere);
}

/** @param state Not used. */
static void test_watertight_quads(void **state) {
    (void)state;
    for_every_engine(watertight_quads);
}

/** @param state Not used. */
static void test_coincident_quads(void **state) {
    (void)state;
    for_every_engine(coincident_quads);
}

/** @param state Not used. */
static void test_grazing_plane(void **state) {
    (void)state;
    for_every_engine(grazing_plane);
}

/** @param state Not used. */
static void test_touching_box(void **state) {
    (void)state;
    for_every_engine(touching_box);
}

/** @param state Not used. */
static void test_packets(void **state) {
    (void)state;
    for_every_engine(packets_drop_nothing);
}

/** @param state Not used. */
static void test_far_cylinder(void **state) {
    (void)state;
    for_every_engine(far_cylinder);
}

/** @param state Not used. */
static void test_cylinder_along_axis(void **state) {
    (void)state;
    for_every_engine(cylinder_along_axis);
}

/** @param state Not used. */
static void test_watertight_rim(void **state) {
    (void)state;
    for_every_engine(watertight_rim);
}

/** @param state Not used. */
static void test_watertight_triangles(void **state) {
    (void)state;
    for_every_engine(watertight_triangles);
}

/** @param state Not used. */
static void test_slivers(void **state) {
    (void)state;
    for_every_engine(sliver_triangles);
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
