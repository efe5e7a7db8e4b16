/**
 * @file
 * @brief Dielectrics other than the sphere: Fresnel reflectance, nested, touching and overlapping
 *        media, cameras inside, light through glass.
 */
#include "glass_scenes.h"

/** The placement of most tests. */
static const Placement here = {1, 0};

/* --- Fresnel -----------------------------------------------------------------------------------
 */

/**
 * A water surface. A bright ceiling is reflected or, seen from below, a bright ground.
 * @return The scene.
 * @param ior  Index of the water.
 * @param from_above  Whether the camera is above.
 */
static Scene *pond_scene(double ior, bool from_above) {
    Scene *scene = create_empty_scene();
    use_material(scene, glass_material(ior));
    add_placed_plane(scene, here, (Vec3d){0, 0, 0}, (Vec3d){0, 1, 0});
    use_material(scene, emissive_material((Rgbd){1, 1, 1}));
    add_placed_plane(scene, here, (Vec3d){0, from_above ? 4 : -4, 0}, (Vec3d){0, 1, 0});
    return scene;
}

/**
 * @return The reflectance of the water surface.
 * @param direction  Direction of view, a unit vector.
 */
static double measured_reflectance(const Engine *engine, Scene *scene, Vec3d direction) {
    set_camera(scene, here, vec3d_scale(direction, -1), direction);
    scene->camera.direction = direction;
    return center_radiance(engine, scene, 1);
}

/**
 * @return A direction at an angle to the vertical, rounded to float.
 * @param downwards  Whether it points down instead of up.
 */
static Vec3d slanted_direction(double degrees, bool downwards) {
    double angle = degrees * M_PI / 180;
    return (Vec3d){round_to_float(sin(angle)), round_to_float(downwards ? -cos(angle) : cos(angle)),
                   0};
}

/** @return The sine of the angle between a direction and the vertical. */
static Quadruple sine_of(Vec3d direction) {
    Quadruple x = direction.x, y = direction.y;
    return quad_abs(x) / quad_sqrt(x * x + y * y);
}

/**
 * Reflectances equal Fresnel's, from above and from below, also at total internal reflection and
 * normal incidence; they are symmetric.
 */
static void check_fresnel(const Engine *engine) {
    const double u = fmax((double)roundoff(engine), 0x1p-53);
    double worst = 0;
    for (int i = 0; i < 90; i++) {
        for (int below = 0; below < 2; below++) {
            double ior = i % 2 ? 1.5 : 1.33203125;
            Scene *scene = pond_scene(ior, !below);
            Vec3d direction = slanted_direction(i, !below);
            Quadruple sine = sine_of(direction);
            double cosine = cos(i * M_PI / 180);
            double truth =
                below ? fresnel_closed_form(sine, ior, 1) : fresnel_closed_form(sine, 1, ior);
            double fraction = measured_reflectance(engine, scene, direction);
            // The direction is rounded, and near 90 degrees the reflectance is steep: 1 / cosine.
            double steep = truth < 1 ? fresnel_closed_form(sine, 1, ior) / cosine : 0;
            steep = below && truth < 1 ? 1 / sqrt(1 - ior * ior * (double)(sine * sine)) : steep;
            worst = fmax(worst, fabs(fraction - truth) / (1 + steep));
            scene_destroy(scene);
        }
    }
    printf("Fresnel in %s: off by %.2g half ulps\n", engine->name, worst / u);
    assert_at_most(worst, 4 * u, "Fresnel's shares in %s", engine->name);
    Scene *scene = pond_scene(1.5, true);
    Vec3d down = {0, -1, 0};
    assert_at_most(fabs(measured_reflectance(engine, scene, down) - 0.04), 4 * u, "R(0) in %s",
                   engine->name);
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_fresnel(void **state) {
    (void)state;
    for_every_engine(check_fresnel);
}

/* --- media -------------------------------------------------------------------------------------
 */

/** Size of the pictures. */
enum { SIZE = 24, NUMBERS = 3 * SIZE * SIZE };

/** Builds a scene in one of several ways. */
typedef void (*Builder)(Scene *scene, Placement world);

/** A chequered background and a light around the built shapes. @return The scene. */
static Scene *glass_test_scene(Placement placement, Builder build) {
    Scene *scene = create_empty_scene();
    scene->sky.horizon = (Rgbd){0.4, 0.5, 0.6};
    scene->sky.zenith = (Rgbd){0.1, 0.8, 0.3};
    use_material(scene, emissive_material((Rgbd){0.7, 0.5, 0.1}));
    for (int i = 0; i < 3; i++) {
        Vec3d corner = {-6, -4 + 3 * i, -6};
        add_placed_quad(scene, placement, corner, (Vec3d){12, 0, 0}, (Vec3d){0, 1, 0});
    }
    build(scene, placement);
    set_camera(scene, placement, (Vec3d){0.7, 0.9, 3.5}, (Vec3d){-0.7, -0.9, -3.5});
    return scene;
}

/**
 * Fails unless two builders give the same picture.
 * @return Pixels that differ by more than one step.
 */
static int scene_difference(const Engine *engine, Placement placement, Builder a, Builder b) {
    static double rgb[2][NUMBERS];
    const Builder both[] = {a, b};
    for (int i = 0; i < 2; i++) {
        Scene *scene = glass_test_scene(placement, both[i]);
        trace_picture(engine, scene, (TraceLimits){40, 0}, SIZE, SIZE, rgb[i]);
        scene_destroy(scene);
    }
    int different = 0;
    for (int i = 0; i < NUMBERS; i++) {
        different += !(fabs(srgb_steps(rgb[0][i]) - srgb_steps(rgb[1][i])) <= 1);
    }
    return different;
}

/** A box of liquid. */
static void build_liquid(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_placed_box(scene, placement, (Vec3d){-1, -1, -1}, (Vec3d){1, 1, 1});
}

/** The same with a sphere of equal index inside. */
static void build_ball_in_liquid(Scene *scene, Placement placement) {
    build_liquid(scene, placement);
    add_placed_sphere(scene, placement, (Vec3d){0.1, 0.2, 0}, 0.6);
}

/** The same, with the sphere first. */
static void build_ball_before_liquid(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_placed_sphere(scene, placement, (Vec3d){0.1, 0.2, 0}, 0.6);
    build_liquid(scene, placement);
}

/** The same in two touching halves. */
static void build_two_halves(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_placed_box(scene, placement, (Vec3d){-1, -1, -1}, (Vec3d){1.0 / 3, 1, 1});
    add_placed_box(scene, placement, (Vec3d){1.0 / 3, -1, -1}, (Vec3d){1, 1, 1});
}

/** The same in four quarters around one edge, in another order. */
static void build_four_quarters(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_placed_box(scene, placement, (Vec3d){0.3, -1, -1}, (Vec3d){1, 1, 0.2});
    add_placed_box(scene, placement, (Vec3d){-1, -1, 0.2}, (Vec3d){0.3, 1, 1});
    add_placed_box(scene, placement, (Vec3d){-1, -1, -1}, (Vec3d){0.3, 1, 0.2});
    add_placed_box(scene, placement, (Vec3d){0.3, -1, 0.2}, (Vec3d){1, 1, 1});
}

/** The same in two overlapping boxes. */
static void build_two_overlapping(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_placed_box(scene, placement, (Vec3d){-1, -1, -1}, (Vec3d){0.5, 1, 1});
    add_placed_box(scene, placement, (Vec3d){-0.5, -1, -1}, (Vec3d){1, 1, 1});
}

/** The same box twice. */
static void build_twice(Scene *scene, Placement placement) {
    build_liquid(scene, placement);
    build_liquid(scene, placement);
}

/** The same, and a box of another index that a later one overrides. */
static void build_hidden(Scene *scene, Placement placement) {
    use_material(scene, glass_material(2.4));
    scene->materials[scene->material_count - 1].transparency = (Rgbd){0.5, 0.3, 0.1};
    scene->materials[scene->material_count - 1].reflectivity = (Rgbd){0.1, 0.2, 0.3};
    add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 0.9);
    build_liquid(scene, placement);
}

/**
 * A hollow glass sphere filled with water: the surface of the water coincides with that of the
 * hole.
 */
static void build_filled_hole(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 1);
    use_material(scene, glass_material(1));
    add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 0.8);
    use_material(scene, glass_material(1.33));
    add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 0.8);
}

/** The same without the hole. */
static void build_filled(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 1);
    use_material(scene, glass_material(1.33));
    add_placed_sphere(scene, placement, (Vec3d){0, 0, 0}, 0.8);
}

/** Glass and water that touch. */
static void build_glass_and_water(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_placed_box(scene, placement, (Vec3d){-1, -1, -1}, (Vec3d){0.3, 1, 1});
    use_material(scene, glass_material(1.33));
    add_placed_box(scene, placement, (Vec3d){0.3, -1, -1}, (Vec3d){1, 1, 1});
}

/** The same in the other order; the glass extends into the water. */
static void build_water_over_glass(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_placed_box(scene, placement, (Vec3d){-1, -1, -1}, (Vec3d){1, 1, 1});
    use_material(scene, glass_material(1.33));
    add_placed_box(scene, placement, (Vec3d){0.3, -1, -1}, (Vec3d){1, 1, 1});
}

/** Adds a rotated glass box. */
static void add_turned_box(Scene *scene, Placement placement, Vec3d low, Vec3d high) {
    Error error = {0};
    Transform transform = *(const Transform *)transform_keyword.defaults;
    transform.rotate = (Vec3d){20, 30, 40};
    transform.translate = placed_point(placement, (Vec3d){0, 0, 0});
    assert_true(transform_keyword.finish(&transform, 0, &error));
    BoxParameters box = {vec3d_scale(low, placement.scale), vec3d_scale(high, placement.scale)};
    add_shape(scene, "box", &box);
    assert_true(scene_set_last_transform(scene, &transform, &error));
}

/** A rotated box. */
static void build_turned(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_turned_box(scene, placement, (Vec3d){-1, -1, -1}, (Vec3d){1, 1, 1});
}

/** The same in two halves. */
static void build_turned_halves(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_turned_box(scene, placement, (Vec3d){-1, -1, -1}, (Vec3d){1, 1.0 / 3, 1});
    add_turned_box(scene, placement, (Vec3d){-1, 1.0 / 3, -1}, (Vec3d){1, 1, 1});
}

/** Adds an opaque floor at the height 0. */
static void add_floor(Scene *scene, Placement placement) {
    use_material(scene, emissive_material((Rgbd){0.1, 0.6, 0.2}));
    add_placed_plane(scene, placement, (Vec3d){0, -1.0 / 3, 0}, (Vec3d){0, 1, 0});
}

/** A glass box that goes through an opaque floor. */
static void build_sunk(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_placed_box(scene, placement, (Vec3d){-1, -1, -1}, (Vec3d){1, 1, 1});
    add_floor(scene, placement);
}

/** The same box, which stands on the floor: the part below it is not seen. */
static void build_standing(Scene *scene, Placement placement) {
    use_material(scene, glass_material(1.5));
    add_placed_box(scene, placement, (Vec3d){-1, -1.0 / 3, -1}, (Vec3d){1, 1, 1});
    add_floor(scene, placement);
}

/** The same with the floor first in the scene. */
static void build_floor_and_box(Scene *scene, Placement placement) {
    add_floor(scene, placement);
    use_material(scene, glass_material(1.5));
    add_placed_box(scene, placement, (Vec3d){-1, -1.0 / 3, -1}, (Vec3d){1, 1, 1});
}

/** Two equivalent builders. */
typedef struct EquivalentScenes {
    const char *name; /**< Name. */
    Builder one;      /**< The first. */
    Builder other;    /**< The second. */
} EquivalentScenes;

/** The equivalent builders. */
static const EquivalentScenes pairs[] = {
    {"a ball in liquid of its index", build_liquid, build_ball_in_liquid},
    {"a ball before liquid of its index", build_liquid, build_ball_before_liquid},
    {"two halves that touch", build_liquid, build_two_halves},
    {"four quarters that touch", build_liquid, build_four_quarters},
    {"two that overlap", build_liquid, build_two_overlapping},
    {"twice the same", build_liquid, build_twice},
    {"one that a later one hides", build_liquid, build_hidden},
    {"a hole filled with water", build_filled, build_filled_hole},
    {"water over glass", build_glass_and_water, build_water_over_glass},
    {"turned halves that touch", build_turned, build_turned_halves},
    {"a box that stands on a floor", build_sunk, build_standing},
    {"the same, the floor first", build_sunk, build_floor_and_box}};

/** Equivalent dielectrics give the same picture, within a step. */
static void check_equivalent_scenes(const Engine *engine) {
    for (size_t p = 0; p < sizeof pairs / sizeof *pairs; p++) {
        for (int w = 0; w < PLACEMENT_COUNT; w++) {
            Placement placement = placements[w];
            if (engine->mantissa_bits > 64 && w > 0) {
                continue;
            }
            int different = scene_difference(engine, placement, pairs[p].one, pairs[p].other);
            printf("%-34s %-7s scale %-6g offset %-6g %4d\n", pairs[p].name, engine->name,
                   placement.scale, placement.offset, different);
            assert_at_most(different, 0, "%s in %s, scale %g, offset %g", pairs[p].name,
                           engine->name, placement.scale, placement.offset);
        }
    }
}

/** @param state Not used. */
static void test_equivalent_scenes(void **state) {
    (void)state;
    for_every_engine(check_equivalent_scenes);
}

/* --- neighbours --------------------------------------------------------------------------------
 */

/** Glass with all kinds of things in it, at its wall and beside it: bubbles, opaque balls, a rod
 *  that sticks out, a floor that touches, another glass that overlaps. */
static void build_crowd(Scene *scene, Placement placement) {
    const SceneMaterial glass = glass_material(1.5);
    add_floor(scene, placement);
    use_material(scene, glass);
    add_placed_sphere(scene, placement, (Vec3d){0, 1.0 / 3, 0}, 2.0 / 3);
    add_placed_sphere(scene, placement, (Vec3d){0.9, 0.4, 0.3}, 0.5);
    add_placed_box(scene, placement, (Vec3d){-1.5, -0.3, -0.5}, (Vec3d){-0.7, 0.7, 0.8});
    use_material(scene, glass_material(1));
    add_placed_sphere(scene, placement, (Vec3d){0.1, 0.5, 0.2}, 0.25);
    use_material(scene, emissive_material((Rgbd){0.8, 0.1, 0.3}));
    for (int i = 0; i < 5; i++) {
        Vec3d at = {-1.2 + 0.45 * i, 0.2 + 0.15 * (i % 3), 0.3 - 0.2 * (i % 2)};
        add_placed_sphere(scene, placement, at, 0.08 + 0.02 * i);
    }
    CylinderParameters rod = {placed_point(placement, (Vec3d){-1, 0.1, 0}),
                              placed_point(placement, (Vec3d){0.5, 1.2, 0.2}),
                              placement.scale * 0.06, true};
    add_shape(scene, "cylinder", &rod);
    use_material(scene, glass);
    add_turned_box(scene, placement, (Vec3d){-0.3, -0.2, -0.9}, (Vec3d){0.4, 0.1, 0.9});
}

/** The same, and so many specks below the floor that no neighbours are looked for. They lie within
 *  the bounds of the scene, so its coordinates stay. */
static void build_crowd_of_many(Scene *scene, Placement placement) {
    build_crowd(scene, placement);
    for (int i = 0; i < 600; i++) {
        add_placed_sphere(scene, placement, (Vec3d){-5.9 + 0.019 * i, -3.9, -5.9}, 1e-4);
    }
}

/** @return The numbers that differ in two pictures, bit for bit. */
static int different_numbers(const double *a, const double *b) {
    int count = 0;
    for (int i = 0; i < NUMBERS; i++) {
        count += memcmp(&a[i], &b[i], sizeof a[i]) != 0;
    }
    return count;
}

/** Rays in glass that are tested against its neighbours alone hit what they hit among all shapes,
 *  bit for bit. */
static void check_neighbours(const Engine *engine) {
    static double rgb[2][NUMBERS];
    const Builder both[] = {build_crowd, build_crowd_of_many};
    for (int w = 0; w < PLACEMENT_COUNT && engine->mantissa_bits <= 64; w++) {
        RayCounts counts[2];
        for (int i = 0; i < 2; i++) {
            Scene *scene = glass_test_scene(placements[w], both[i]);
            counts[i] =
                trace_picture(engine, scene, (TraceLimits){12, 0x1p-12}, SIZE, SIZE, rgb[i]);
            scene_destroy(scene);
        }
        assert_at_most(different_numbers(rgb[0], rgb[1]), 0,
                       "neighbours in %s, scale %g, offset %g", engine->name, placements[w].scale,
                       placements[w].offset);
        assert_true(counts[0].refraction > SIZE * SIZE);
        assert_true(counts[0].refraction == counts[1].refraction);
    }
}

/** @param state Not used. */
static void test_neighbours(void **state) {
    (void)state;
    for_every_engine(check_neighbours);
}

/* --- exactness ---------------------------------------------------------------------------------
 */

/** Index 1 does not change directions, bit for bit. The sky shows the direction of a ray. */
static void check_air_is_exact(const Engine *engine) {
    static double rgb[2][NUMBERS];
    for (int w = 0; w < PLACEMENT_COUNT; w++) {
        Scene *scene = create_empty_scene();
        scene->sky.horizon = (Rgbd){0.4, 0.5, 0.6};
        scene->sky.zenith = (Rgbd){0.1, 0.8, 0.3};
        set_camera(scene, placements[w], (Vec3d){0, 0, 3}, (Vec3d){0, 0.5, -3});
        trace_picture(engine, scene, (TraceLimits){8, 0}, SIZE, SIZE, rgb[0]);
        use_material(scene, glass_material(1));
        add_placed_sphere(scene, placements[w], (Vec3d){0, 0, 0}, 1);
        trace_picture(engine, scene, (TraceLimits){8, 0}, SIZE, SIZE, rgb[1]);
        assert_memory_equal(rgb[0], rgb[1], sizeof rgb[0]);
        scene_destroy(scene);
    }
}

/** @param state Not used. */
static void test_air_is_exact(void **state) {
    (void)state;
    for_every_engine(check_air_is_exact);
}

/**
 * Between touching glass and water there is no air: beyond the critical angle to air, light is
 * transmitted.
 */
static void check_touching_dielectrics(const Engine *engine) {
    for (int w = 0; w < PLACEMENT_COUNT; w++) {
        Scene *scene = create_empty_scene();
        build_glass_and_water(scene, placements[w]);
        use_material(scene, emissive_material((Rgbd){1, 1, 1}));
        add_placed_plane(scene, placements[w], (Vec3d){0.9, 0, 0}, (Vec3d){-1, 0, 0});
        // The angle is 50 degrees; to air, the critical angle is 42 degrees. The camera is in the
        // glass.
        Vec3d direction = {round_to_float(cos(50 * M_PI / 180)),
                           round_to_float(sin(50 * M_PI / 180)), 0};
        set_camera(scene, placements[w], (Vec3d){0, -0.4, 0}, direction);
        double sine = direction.y / sqrt(direction.x * direction.x + direction.y * direction.y),
               rgb[3];
        double truth = 1 - fresnel_closed_form(sine, 1.5, 1.33);
        RayCounts counts = trace_picture(engine, scene, (TraceLimits){1, 0}, 1, 1, rgb);
        assert_int_equal((int)counts.total_reflection, 0);
        assert_at_most(fabs(rgb[0] - truth), 1e-5, "glass to water in %s, offset %g", engine->name,
                       placements[w].offset);
        scene_destroy(scene);
    }
}

/** @param state Not used. */
static void test_no_air_between(void **state) {
    (void)state;
    for_every_engine(check_touching_dielectrics);
}

/**
 * From inside a box, light is transmitted up to the critical angle only; from the centre of a
 * sphere in all directions.
 */
static void check_camera_inside(const Engine *engine) {
    for (int w = 0; w < PLACEMENT_COUNT; w++) {
        for (int degrees = 1; degrees < 45; degrees += 4) {
            double angle = degrees * M_PI / 180, rgb[3];
            Vec3d direction = {sin(angle), 0, -cos(angle)};
            Scene *scene = create_empty_scene();
            use_material(scene, glass_material(1.5));
            add_placed_box(scene, placements[w], (Vec3d){-4, -4, -1}, (Vec3d){4, 4, 1});
            set_camera(scene, placements[w], (Vec3d){0, 0, 0}, direction);
            RayCounts counts = trace_picture(engine, scene, (TraceLimits){1, 0}, 1, 1, rgb);
            assert_int_equal((int)counts.total_reflection, 1.5 * sin(angle) > 1);
            scene_destroy(scene);
            scene = create_empty_scene();
            scene->sky.horizon = scene->sky.zenith = (Rgbd){1, 1, 1};
            use_material(scene, glass_material(1.5));
            add_placed_sphere(scene, placements[w], (Vec3d){0, 0, 0}, 1);
            set_camera(scene, placements[w], (Vec3d){0, 0, 0}, direction);
            assert_at_most(fabs(center_radiance(engine, scene, 1) - 0.96), 1e-6,
                           "from a ball's middle");
            scene_destroy(scene);
        }
    }
}

/** @param state Not used. */
static void test_camera_inside(void **state) {
    (void)state;
    for_every_engine(check_camera_inside);
}

/**
 * A ray that exits a shape was inside it, even if its interior list lacks the shape: the back of a
 * pane refracts.
 */
static void check_exit_of_pane(const Engine *engine) {
    double rgb[3];
    Scene *scene = create_empty_scene();
    use_material(scene, glass_material(1.5));
    add_placed_quad(scene, here, (Vec3d){-1, 0, -1}, (Vec3d){2, 0, 0}, (Vec3d){0, 0, 2});
    for (int side = -1; side <= 1; side += 2) {
        // Its normal is -y. The camera is so far aside that no ray along an axis hits it.
        set_camera(scene, here, (Vec3d){-3, side, 0}, (Vec3d){3, -side, 0});
        RayCounts counts = trace_picture(engine, scene, (TraceLimits){1, 0}, 1, 1, rgb);
        assert_int_equal((int)counts.total_reflection, side > 0);
    }
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_back_of_a_pane(void **state) {
    (void)state;
    for_every_engine(check_exit_of_pane);
}

/** More nested spheres than an interior list holds (8). */
enum { NESTED_SPHERES = 10 };

/**
 * With more nested shapes than an interior list holds, the last ones count, and no light is lost.
 */
static void check_nesting_overflow(const Engine *engine) {
    Scene *scene = create_empty_scene();
    scene->sky.horizon = scene->sky.zenith = (Rgbd){1, 1, 1};
    for (int i = 0; i < NESTED_SPHERES; i++) {
        use_material(scene, glass_material(1.5));
        add_placed_sphere(scene, here, (Vec3d){0, 0, 0}, 1 - 0.05 * i);
    }
    set_camera(scene, here, (Vec3d){0, 0.1, 3}, (Vec3d){0, 0, -1});
    // Deep recursion: rays between shapes in the list and others that did not fit.
    double rgb[3];
    trace_picture(engine, scene, (TraceLimits){160, 1e-5}, 1, 1, rgb);
    assert_at_most(fabs(rgb[0] - 1), 1e-3, "onion in %s", engine->name);
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_onion(void **state) {
    (void)state;
    for_every_engine(check_nesting_overflow);
}

/* --- light through glass -----------------------------------------------------------------------
 */

/** The shapes between a light and the floor below it. */
typedef struct ShadowFilterCase {
    const char *name;    /**< Name. */
    int surfaces;        /**< Number of tinted surfaces on the way of the light. */
    int spheres;         /**< Number of spheres. */
    int quads;           /**< Number of quads. */
    bool is_opaque;      /**< Whether there is an opaque shape, too. */
    double clear_radius; /**< Radius of a clear sphere after the lowest one, above 0. */
    double clear_height; /**< Height above its centre. */
} ShadowFilterCase;

/** The cases. */
static const ShadowFilterCase betweens[] = {
    {"nothing", 0, 0, 0, false, 0, 0},
    {"a ball", 2, 1, 0, false, 0, 0},
    {"a pane", 1, 0, 1, false, 0, 0},
    {"three balls", 6, 3, 0, false, 0, 0},
    {"all", 5, 2, 1, false, 0, 0},
    {"and a board", 0, 1, 1, true, 0, 0},
    {"a ball that a later one hides", 0, 1, 0, false, 0.7, 0},
    {"a ball whose upper half is hidden", 1, 1, 0, false, 0.4, 0.5},
    {"one whose middle is hidden", 2, 1, 0, false, 0.3, 0}};

/**
 * @return A floor below a light, and the shapes between them.
 * @param specular  Specular coefficient of the floor.
 */
static Scene *light_scene(Placement placement, const ShadowFilterCase *row, double specular) {
    Error error = {0};
    Scene *scene = create_empty_scene();
    SceneLight light = *(const SceneLight *)scene_light_keyword.defaults;
    light.position = placed_point(placement, (Vec3d){0, 8, 0});
    assert_true(scene_add_light(scene, &light, &error));
    SceneMaterial matt = *(const SceneMaterial *)scene_material_keyword.defaults;
    matt.specular = specular;
    use_material(scene, matt);
    add_placed_plane(scene, placement, (Vec3d){0, 0, 0}, (Vec3d){0, 1, 0});
    if (row->is_opaque) {
        add_placed_quad(scene, placement, (Vec3d){-1, 4, -1}, (Vec3d){2, 0, 0}, (Vec3d){0, 0, 2});
    }
    SceneMaterial tinted = glass_material(1.5);
    tinted.transparency = (Rgbd){0.5, 0.75, 0.125};
    use_material(scene, tinted);
    for (int i = 0; i < row->spheres; i++) {
        add_placed_sphere(scene, placement, (Vec3d){0, 2 + 1.25 * i, 0}, 0.5);
    }
    for (int i = 0; i < row->quads; i++) {
        add_placed_quad(scene, placement, (Vec3d){-1, 1, -1}, (Vec3d){2, 0, 0}, (Vec3d){0, 0, 2});
    }
    if (row->clear_radius > 0) {
        use_material(scene, glass_material(1.25));
        add_placed_sphere(scene, placement, (Vec3d){0, 2 + row->clear_height, 0},
                          row->clear_radius);
    }
    set_camera(scene, placement, (Vec3d){-0.8, 0.25, 0}, (Vec3d){0.8, -0.25, 0});
    return scene;
}

/**
 * Each surface multiplies the light by its transmittance, per channel, for diffuse reflection and
 * highlights.
 */
static void check_shadow_transmittance(const Engine *engine) {
    static const double tint[] = {0.5, 0.75, 0.125};
    for (size_t r = 0; r < sizeof betweens / sizeof *betweens; r++) {
        for (int w = 0; w < PLACEMENT_COUNT; w++) {
            for (int specular = 0; specular < 2; specular++) {
                double rgb[3], plain[3];
                Scene *scene = light_scene(placements[w], &betweens[r], specular);
                trace_pixel(engine, scene, rgb);
                scene_destroy(scene);
                scene = light_scene(placements[w], &betweens[0], specular);
                trace_pixel(engine, scene, plain);
                scene_destroy(scene);
                for (int i = 0; i < 3; i++) {
                    double left = betweens[r].is_opaque ? 0 : pow(tint[i], betweens[r].surfaces);
                    assert_at_most(fabs(rgb[i] - left * plain[i]), 1e-6, "light through %s in %s",
                                   betweens[r].name, engine->name);
                    assert_true(plain[i] > 0.9);
                }
            }
        }
    }
}

/** @param state Not used. */
static void test_filtered_light(void **state) {
    (void)state;
    for_every_engine(check_shadow_transmittance);
}

/* --- depth ------------------------------------------------------------------------------------ */

/** The largest depth of a scene fits the stack of a thread: a stack of panes, then mirrors. */
static void check_maximum_depth(const Engine *engine) {
#ifdef __SANITIZE_ADDRESS__
    const int depth = 64; // Its stack frames are three times as large.
#else
    const int depth = DEPTH_MAXIMUM;
#endif
    static double rgb[3 * 16 * 16];
    Scene *scene = create_empty_scene();
    scene->sky.horizon = scene->sky.zenith = (Rgbd){1, 1, 1};
    use_material(scene, glass_material(1));
    for (int i = 0; i < depth; i++) {
        add_placed_quad(scene, here, (Vec3d){-99, -99, -1 - 0.25 * i}, (Vec3d){198, 0, 0},
                        (Vec3d){0, 198, 0});
    }
    RayCounts counts = trace_picture(engine, scene, (TraceLimits){depth, 0}, 16, 16, rgb);
    assert_int_equal((int)counts.refraction, 256 * depth);
    assert_true(rgb[0] == 1);
    trace_picture(engine, scene, (TraceLimits){depth - 1, 0}, 16, 16, rgb);
    assert_true(rgb[0] == 0);
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_deepest(void **state) {
    (void)state;
    for_every_engine(check_maximum_depth);
}

/** @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fresnel),        cmocka_unit_test(test_equivalent_scenes),
        cmocka_unit_test(test_no_air_between), cmocka_unit_test(test_camera_inside),
        cmocka_unit_test(test_back_of_a_pane), cmocka_unit_test(test_onion),
        cmocka_unit_test(test_neighbours),     cmocka_unit_test(test_air_is_exact),
        cmocka_unit_test(test_filtered_light), cmocka_unit_test(test_deepest)};
    return cmocka_run_group_tests_name("media", tests, NULL, NULL);
}
