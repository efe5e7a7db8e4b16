/**
 * @file
 * @brief Glass besides the sphere: Fresnel's shares, media that nest, touch and overlap, cameras
 *        inside, light through glass.
 */
#include "glass_scenes.h"

/** Where most tests are. */
static const World here = {1, 0};

/* --- Fresnel -----------------------------------------------------------------------------------
 */

/** A pond: what is mirrored comes from a bright ceiling or, seen from below, from a bright ground.
 *  @return The scene. @param ior Index of the water. @param from_above Where the camera is. */
static Scene *pond(double ior, bool from_above) {
    Scene *scene = empty_scene();
    use(scene, glass_of(ior));
    add_plane(scene, here, (Vector3){0, 0, 0}, (Vector3){0, 1, 0});
    use(scene, shining((Color){1, 1, 1}));
    add_plane(scene, here, (Vector3){0, from_above ? 4 : -4, 0}, (Vector3){0, 1, 0});
    return scene;
}

/** @return The share that the pond mirrors. @param engine The engine. @param scene A pond.
 *  @param way Which way the camera looks, one long. */
static double share_seen(const Engine *engine, Scene *scene, Vector3 way) {
    aim(scene, here, vector3_scale(way, -1), way);
    scene->camera.direction = way;
    return light_of(engine, scene, 1);
}

/** @return A direction at an angle to the vertical, downwards or upwards, exact in float. @param
 *  degrees The angle. @param downwards Which of the two. */
static Vector3 slope(double degrees, bool downwards) {
    double angle = degrees * M_PI / 180;
    return (Vector3){as_float(sin(angle)), as_float(downwards ? -cos(angle) : cos(angle)), 0};
}

/** @return The sine of the angle between a direction and the vertical. @param way The direction. */
static Quadruple sine_of(Vector3 way) {
    Quadruple x = way.x, y = way.y;
    return quad_abs(x) / quad_sqrt(x * x + y * y);
}

/** The shares of light mirrored are Fresnel's, from above and from below, also beyond where there
 *  is no refraction; at right angles, and the same both ways. @param engine The engine. */
static void fresnel_table(const Engine *engine) {
    const double u = fmax((double)roundoff(engine), 0x1p-53);
    double worst = 0;
    for (int i = 0; i < 90; i++) {
        for (int below = 0; below < 2; below++) {
            double ior = i % 2 ? 1.5 : 1.33203125;
            Scene *scene = pond(ior, !below);
            Vector3 way = slope(i, !below);
            Quadruple sine = sine_of(way);
            double cosine = cos(i * M_PI / 180);
            double truth = below ? fresnel(sine, ior, 1) : fresnel(sine, 1, ior);
            double share = share_seen(engine, scene, way);
            // The direction itself is rounded, and near 90 degrees the share is steep: 1 / cosine.
            double steep = truth < 1 ? fresnel(sine, 1, ior) / cosine : 0;
            steep = below && truth < 1 ? 1 / sqrt(1 - ior * ior * (double)(sine * sine)) : steep;
            worst = fmax(worst, fabs(share - truth) / (1 + steep));
            scene_destroy(scene);
        }
    }
    printf("Fresnel in %s: off by %.2g half ulps\n", engine->name, worst / u);
    assert_at_most(worst, 4 * u, "Fresnel's shares in %s", engine->name);
    Scene *scene = pond(1.5, true);
    Vector3 down = {0, -1, 0};
    assert_at_most(fabs(share_seen(engine, scene, down) - 0.04), 4 * u, "R(0) in %s", engine->name);
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_fresnel(void **state) {
    (void)state;
    in_every_engine(fresnel_table);
}

/* --- media -------------------------------------------------------------------------------------
 */

/** Size of the pictures. */
enum { SIZE = 24, NUMBERS = 3 * SIZE * SIZE };

/** A scene, built one way or the other. */
typedef void (*Builder)(Scene *scene, World world);

/** A checkered background and a lamp around what is built. @return The scene. @param world Where.
 *  @param build Builds glass. */
static Scene *stage(World world, Builder build) {
    Scene *scene = empty_scene();
    scene->sky.horizon = (Color){0.4, 0.5, 0.6};
    scene->sky.zenith = (Color){0.1, 0.8, 0.3};
    use(scene, shining((Color){0.7, 0.5, 0.1}));
    for (int i = 0; i < 3; i++) {
        Vector3 corner = {-6, -4 + 3 * i, -6};
        add_panel(scene, world, corner, (Vector3){12, 0, 0}, (Vector3){0, 1, 0});
    }
    build(scene, world);
    aim(scene, world, (Vector3){0.7, 0.9, 3.5}, (Vector3){-0.7, -0.9, -3.5});
    return scene;
}

/** Fails unless two ways to build glass look the same. @return Pixels that differ by more than one
 *  step. @param engine The engine. @param world Where. @param a One way. @param b The other. */
static int difference(const Engine *engine, World world, Builder a, Builder b) {
    static double rgb[2][NUMBERS];
    const Builder both[] = {a, b};
    for (int i = 0; i < 2; i++) {
        Scene *scene = stage(world, both[i]);
        trace_picture(engine, scene, (Fineness){40, 0}, SIZE, SIZE, rgb[i]);
        scene_destroy(scene);
    }
    int off = 0;
    for (int i = 0; i < NUMBERS; i++) {
        off += !(fabs(steps_of(rgb[0][i]) - steps_of(rgb[1][i])) <= 1);
    }
    return off;
}

/** A box of liquid. @param scene The scene. @param world Where. */
static void liquid(Scene *scene, World world) {
    use(scene, glass_of(1.5));
    add_block(scene, world, (Vector3){-1, -1, -1}, (Vector3){1, 1, 1});
}

/** The same with a ball of the same index in it. @param scene The scene. @param world Where. */
static void ball_in_liquid(Scene *scene, World world) {
    liquid(scene, world);
    add_ball(scene, world, (Vector3){0.1, 0.2, 0}, 0.6);
}

/** The same, the ball first. @param scene The scene. @param world Where. */
static void ball_before_liquid(Scene *scene, World world) {
    use(scene, glass_of(1.5));
    add_ball(scene, world, (Vector3){0.1, 0.2, 0}, 0.6);
    liquid(scene, world);
}

/** The same, in two halves that touch. @param scene The scene. @param world Where. */
static void two_halves(Scene *scene, World world) {
    use(scene, glass_of(1.5));
    add_block(scene, world, (Vector3){-1, -1, -1}, (Vector3){1.0 / 3, 1, 1});
    add_block(scene, world, (Vector3){1.0 / 3, -1, -1}, (Vector3){1, 1, 1});
}

/** The same, in four quarters around one edge, in another order. @param scene The scene.
 *  @param world Where. */
static void four_quarters(Scene *scene, World world) {
    use(scene, glass_of(1.5));
    add_block(scene, world, (Vector3){0.3, -1, -1}, (Vector3){1, 1, 0.2});
    add_block(scene, world, (Vector3){-1, -1, 0.2}, (Vector3){0.3, 1, 1});
    add_block(scene, world, (Vector3){-1, -1, -1}, (Vector3){0.3, 1, 0.2});
    add_block(scene, world, (Vector3){0.3, -1, 0.2}, (Vector3){1, 1, 1});
}

/** The same, in two that overlap. @param scene The scene. @param world Where. */
static void two_overlapping(Scene *scene, World world) {
    use(scene, glass_of(1.5));
    add_block(scene, world, (Vector3){-1, -1, -1}, (Vector3){0.5, 1, 1});
    add_block(scene, world, (Vector3){-0.5, -1, -1}, (Vector3){1, 1, 1});
}

/** The same twice, in the same place. @param scene The scene. @param world Where. */
static void twice(Scene *scene, World world) {
    liquid(scene, world);
    liquid(scene, world);
}

/** The same, and one of another index that a later one hides. @param scene The scene.
 *  @param world Where. */
static void hidden(Scene *scene, World world) {
    use(scene, glass_of(2.4));
    scene->materials[scene->material_count - 1].transparency = (Color){0.5, 0.3, 0.1};
    scene->materials[scene->material_count - 1].reflectivity = (Color){0.1, 0.2, 0.3};
    add_ball(scene, world, (Vector3){0, 0, 0}, 0.9);
    liquid(scene, world);
}

/** A ball of glass, hollow, with water that fills the hole: the water's wall is the hole's.
 *  @param scene The scene. @param world Where. */
static void filled_hole(Scene *scene, World world) {
    use(scene, glass_of(1.5));
    add_ball(scene, world, (Vector3){0, 0, 0}, 1);
    use(scene, glass_of(1));
    add_ball(scene, world, (Vector3){0, 0, 0}, 0.8);
    use(scene, glass_of(1.33));
    add_ball(scene, world, (Vector3){0, 0, 0}, 0.8);
}

/** The same without the hole. @param scene The scene. @param world Where. */
static void filled(Scene *scene, World world) {
    use(scene, glass_of(1.5));
    add_ball(scene, world, (Vector3){0, 0, 0}, 1);
    use(scene, glass_of(1.33));
    add_ball(scene, world, (Vector3){0, 0, 0}, 0.8);
}

/** Glass beside water that touches it. @param scene The scene. @param world Where. */
static void glass_and_water(Scene *scene, World world) {
    use(scene, glass_of(1.5));
    add_block(scene, world, (Vector3){-1, -1, -1}, (Vector3){0.3, 1, 1});
    use(scene, glass_of(1.33));
    add_block(scene, world, (Vector3){0.3, -1, -1}, (Vector3){1, 1, 1});
}

/** The same, the other first, and the glass reaches under the water. @param scene The scene.
 *  @param world Where. */
static void water_over_glass(Scene *scene, World world) {
    use(scene, glass_of(1.5));
    add_block(scene, world, (Vector3){-1, -1, -1}, (Vector3){1, 1, 1});
    use(scene, glass_of(1.33));
    add_block(scene, world, (Vector3){0.3, -1, -1}, (Vector3){1, 1, 1});
}

/** A glass box turned. @param scene The scene. @param world Where. @param low Its lowest corner.
 *  @param high Its highest. */
static void turned_block(Scene *scene, World world, Vector3 low, Vector3 high) {
    Error error = {0};
    Transform transform = *(const Transform *)transform_keyword.defaults;
    transform.rotate = (Vector3){20, 30, 40};
    transform.translate = place_in(world, (Vector3){0, 0, 0});
    assert_true(transform_keyword.finish(&transform, 0, &error));
    BoxParameters box = {vector3_scale(low, world.scale), vector3_scale(high, world.scale)};
    add_shape(scene, "box", &box);
    assert_true(scene_transform_shape(scene, &transform, &error));
}

/** A turned box. @param scene The scene. @param world Where. */
static void turned(Scene *scene, World world) {
    use(scene, glass_of(1.5));
    turned_block(scene, world, (Vector3){-1, -1, -1}, (Vector3){1, 1, 1});
}

/** The same in two halves. @param scene The scene. @param world Where. */
static void turned_halves(Scene *scene, World world) {
    use(scene, glass_of(1.5));
    turned_block(scene, world, (Vector3){-1, -1, -1}, (Vector3){1, 1.0 / 3, 1});
    turned_block(scene, world, (Vector3){-1, 1.0 / 3, -1}, (Vector3){1, 1, 1});
}

/** Two ways to build the same. */
typedef struct SameLook {
    const char *name; /**< What. */
    Builder one;      /**< One way. */
    Builder other;    /**< The other. */
} SameLook;

/** What must look the same. */
static const SameLook pairs[] = {{"a ball in liquid of its index", liquid, ball_in_liquid},
                                 {"a ball before liquid of its index", liquid, ball_before_liquid},
                                 {"two halves that touch", liquid, two_halves},
                                 {"four quarters that touch", liquid, four_quarters},
                                 {"two that overlap", liquid, two_overlapping},
                                 {"twice the same", liquid, twice},
                                 {"one that a later one hides", liquid, hidden},
                                 {"a hole filled with water", filled, filled_hole},
                                 {"water over glass", glass_and_water, water_over_glass},
                                 {"turned halves that touch", turned, turned_halves}};

/** Glass that is built in another way looks the same, within a step. @param engine The engine. */
static void media_pairs(const Engine *engine) {
    for (size_t p = 0; p < sizeof pairs / sizeof *pairs; p++) {
        for (int w = 0; w < WORLDS; w++) {
            World world = worlds[w];
            if (engine->mantissa_bits > 64 && w > 0) {
                continue;
            }
            int off = difference(engine, world, pairs[p].one, pairs[p].other);
            printf("%-34s %-7s scale %-6g offset %-6g %4d\n", pairs[p].name, engine->name,
                   world.scale, world.offset, off);
            assert_at_most(off, 0, "%s in %s, scale %g, offset %g", pairs[p].name, engine->name,
                           world.scale, world.offset);
        }
    }
}

/** @param state Not used. */
static void test_media(void **state) {
    (void)state;
    in_every_engine(media_pairs);
}

/** Air in air bends nothing, to the last bit: the sky, which only asks which way a ray goes.
 *  @param engine The engine. */
static void air_is_exact(const Engine *engine) {
    static double rgb[2][NUMBERS];
    for (int w = 0; w < WORLDS; w++) {
        Scene *scene = empty_scene();
        scene->sky.horizon = (Color){0.4, 0.5, 0.6};
        scene->sky.zenith = (Color){0.1, 0.8, 0.3};
        aim(scene, worlds[w], (Vector3){0, 0, 3}, (Vector3){0, 0.5, -3});
        trace_picture(engine, scene, (Fineness){8, 0}, SIZE, SIZE, rgb[0]);
        use(scene, glass_of(1));
        add_ball(scene, worlds[w], (Vector3){0, 0, 0}, 1);
        trace_picture(engine, scene, (Fineness){8, 0}, SIZE, SIZE, rgb[1]);
        assert_memory_equal(rgb[0], rgb[1], sizeof rgb[0]);
        scene_destroy(scene);
    }
}

/** @param state Not used. */
static void test_air_is_exact(void **state) {
    (void)state;
    in_every_engine(air_is_exact);
}

/** From glass into water that touches it there is no air between: past the critical angle to air,
 *  light goes on. @param engine The engine. */
static void no_air_between(const Engine *engine) {
    for (int w = 0; w < WORLDS; w++) {
        Scene *scene = empty_scene();
        glass_and_water(scene, worlds[w]);
        use(scene, shining((Color){1, 1, 1}));
        add_plane(scene, worlds[w], (Vector3){0.9, 0, 0}, (Vector3){-1, 0, 0});
        // 50 degrees: in air, nothing would go on from 42 degrees. The camera is in the glass.
        Vector3 way = {as_float(cos(50 * M_PI / 180)), as_float(sin(50 * M_PI / 180)), 0};
        aim(scene, worlds[w], (Vector3){0, -0.4, 0}, way);
        double sine = way.y / sqrt(way.x * way.x + way.y * way.y), rgb[3];
        double truth = 1 - fresnel(sine, 1.5, 1.33);
        RayCounts counts = trace_picture(engine, scene, (Fineness){1, 0}, 1, 1, rgb);
        assert_int_equal((int)counts.total, 0);
        assert_at_most(fabs(rgb[0] - truth), 1e-5, "glass to water in %s, offset %g", engine->name,
                       worlds[w].offset);
        scene_destroy(scene);
    }
}

/** @param state Not used. */
static void test_no_air_between(void **state) {
    (void)state;
    in_every_engine(no_air_between);
}

/** From inside a box, light goes out up to the critical angle and no farther; from the middle of a
 *  ball in all directions. @param engine The engine. */
static void camera_inside(const Engine *engine) {
    for (int w = 0; w < WORLDS; w++) {
        for (int degrees = 1; degrees < 45; degrees += 4) {
            double angle = degrees * M_PI / 180, rgb[3];
            Vector3 way = {sin(angle), 0, -cos(angle)};
            Scene *scene = empty_scene();
            use(scene, glass_of(1.5));
            add_block(scene, worlds[w], (Vector3){-4, -4, -1}, (Vector3){4, 4, 1});
            aim(scene, worlds[w], (Vector3){0, 0, 0}, way);
            RayCounts counts = trace_picture(engine, scene, (Fineness){1, 0}, 1, 1, rgb);
            assert_int_equal((int)counts.total, 1.5 * sin(angle) > 1);
            scene_destroy(scene);
            scene = empty_scene();
            scene->sky.horizon = scene->sky.zenith = (Color){1, 1, 1};
            use(scene, glass_of(1.5));
            add_ball(scene, worlds[w], (Vector3){0, 0, 0}, 1);
            aim(scene, worlds[w], (Vector3){0, 0, 0}, way);
            assert_at_most(fabs(light_of(engine, scene, 1) - 0.96), 1e-6, "from a ball's middle");
            scene_destroy(scene);
        }
    }
}

/** @param state Not used. */
static void test_camera_inside(void **state) {
    (void)state;
    in_every_engine(camera_inside);
}

/** Whoever leaves a shape was in it, even if nothing told so: the back of a pane is glass.
 *  @param engine The engine. */
static void back_of_a_pane(const Engine *engine) {
    double rgb[3];
    Scene *scene = empty_scene();
    use(scene, glass_of(1.5));
    add_panel(scene, here, (Vector3){-1, 0, -1}, (Vector3){2, 0, 0}, (Vector3){0, 0, 2});
    for (int side = -1; side <= 1; side += 2) {
        // Its normal is -y. From so far beside it, no ray along an axis meets it.
        aim(scene, here, (Vector3){-3, side, 0}, (Vector3){3, -side, 0});
        RayCounts counts = trace_picture(engine, scene, (Fineness){1, 0}, 1, 1, rgb);
        assert_int_equal((int)counts.total, side > 0);
    }
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_back_of_a_pane(void **state) {
    (void)state;
    in_every_engine(back_of_a_pane);
}

/** More balls in one another than a ray remembers (8). */
enum { MEDIA_MANY = 10 };

/** More shapes in one another than a ray remembers: those that come last count, and nothing is
 *  lost. @param engine The engine. */
static void onion(const Engine *engine) {
    Scene *scene = empty_scene();
    scene->sky.horizon = scene->sky.zenith = (Color){1, 1, 1};
    for (int i = 0; i < MEDIA_MANY; i++) {
        use(scene, glass_of(1.5));
        add_ball(scene, here, (Vector3){0, 0, 0}, 1 - 0.05 * i);
    }
    aim(scene, here, (Vector3){0, 0.1, 3}, (Vector3){0, 0, -1});
    // Long ways: to and fro between shapes that are there and such that are forgotten.
    double rgb[3];
    trace_picture(engine, scene, (Fineness){160, 1e-5}, 1, 1, rgb);
    assert_at_most(fabs(rgb[0] - 1), 1e-3, "onion in %s", engine->name);
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_onion(void **state) {
    (void)state;
    in_every_engine(onion);
}

/* --- light through glass -----------------------------------------------------------------------
 */

/** What is between a lamp and the floor below it. */
typedef struct Between {
    const char *name; /**< What. */
    int surfaces;     /**< How many tinted surfaces the light crosses. */
    int balls;        /**< Balls. */
    int panels;       /**< Quads. */
    bool is_opaque;   /**< Whether something opaque is there too. */
    double cover;     /**< Radius of a clear ball after the lowest one, above 0. */
    double above;     /**< How far above its middle. */
} Between;

/** The rows. */
static const Between betweens[] = {{"nothing", 0, 0, 0, false, 0, 0},
                                   {"a ball", 2, 1, 0, false, 0, 0},
                                   {"a pane", 1, 0, 1, false, 0, 0},
                                   {"three balls", 6, 3, 0, false, 0, 0},
                                   {"all", 5, 2, 1, false, 0, 0},
                                   {"and a board", 0, 1, 1, true, 0, 0},
                                   {"a ball that a later one hides", 0, 1, 0, false, 0.7, 0},
                                   {"a ball whose upper half is hidden", 1, 1, 0, false, 0.4, 0.5},
                                   {"one whose middle is hidden", 2, 1, 0, false, 0.3, 0}};

/** @return A floor under a lamp, and what is between. @param world Where. @param row What.
 *  @param specular Weight of the floor's highlight. */
static Scene *lamp_scene(World world, const Between *row, double specular) {
    Error error = {0};
    Scene *scene = empty_scene();
    Light light = *(const Light *)light_keyword.defaults;
    light.position = place_in(world, (Vector3){0, 8, 0});
    assert_true(scene_add_light(scene, &light, &error));
    Material matt = *(const Material *)material_keyword.defaults;
    matt.specular = specular;
    use(scene, matt);
    add_plane(scene, world, (Vector3){0, 0, 0}, (Vector3){0, 1, 0});
    if (row->is_opaque) {
        add_panel(scene, world, (Vector3){-1, 4, -1}, (Vector3){2, 0, 0}, (Vector3){0, 0, 2});
    }
    Material tinted = glass_of(1.5);
    tinted.transparency = (Color){0.5, 0.75, 0.125};
    use(scene, tinted);
    for (int i = 0; i < row->balls; i++) {
        add_ball(scene, world, (Vector3){0, 2 + 1.25 * i, 0}, 0.5);
    }
    for (int i = 0; i < row->panels; i++) {
        add_panel(scene, world, (Vector3){-1, 1, -1}, (Vector3){2, 0, 0}, (Vector3){0, 0, 2});
    }
    if (row->cover > 0) {
        use(scene, glass_of(1.25));
        add_ball(scene, world, (Vector3){0, 2 + row->above, 0}, row->cover);
    }
    aim(scene, world, (Vector3){-0.8, 0.25, 0}, (Vector3){0.8, -0.25, 0});
    return scene;
}

/** A lamp's light loses its share at each surface, in each colour, matt and in highlights.
 *  @param engine The engine. */
static void filtered_light(const Engine *engine) {
    static const double tint[] = {0.5, 0.75, 0.125};
    for (size_t r = 0; r < sizeof betweens / sizeof *betweens; r++) {
        for (int w = 0; w < WORLDS; w++) {
            for (int specular = 0; specular < 2; specular++) {
                double rgb[3], plain[3];
                Scene *scene = lamp_scene(worlds[w], &betweens[r], specular);
                trace_pixel(engine, scene, rgb);
                scene_destroy(scene);
                scene = lamp_scene(worlds[w], &betweens[0], specular);
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
    in_every_engine(filtered_light);
}

/* --- depth -------------------------------------------------------------------------------------
 */

/** As deep as a scene may ask for, on the stack that a thread has: a stack of panes, then mirrors.
 *  @param engine The engine. */
static void deepest(const Engine *engine) {
#ifdef __SANITIZE_ADDRESS__
    const int depth = 64; // Its frames are three times as large.
#else
    const int depth = DEPTH_MAXIMUM;
#endif
    static double rgb[3 * 16 * 16];
    Scene *scene = empty_scene();
    scene->sky.horizon = scene->sky.zenith = (Color){1, 1, 1};
    use(scene, glass_of(1));
    for (int i = 0; i < depth; i++) {
        add_panel(scene, here, (Vector3){-99, -99, -1 - 0.25 * i}, (Vector3){198, 0, 0},
                  (Vector3){0, 198, 0});
    }
    RayCounts counts = trace_picture(engine, scene, (Fineness){depth, 0}, 16, 16, rgb);
    assert_int_equal((int)counts.refract, 256 * depth);
    assert_true(rgb[0] == 1);
    trace_picture(engine, scene, (Fineness){depth - 1, 0}, 16, 16, rgb);
    assert_true(rgb[0] == 0);
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_deepest(void **state) {
    (void)state;
    in_every_engine(deepest);
}

/** @return How many tests failed. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fresnel),        cmocka_unit_test(test_media),
        cmocka_unit_test(test_no_air_between), cmocka_unit_test(test_camera_inside),
        cmocka_unit_test(test_back_of_a_pane), cmocka_unit_test(test_onion),
        cmocka_unit_test(test_air_is_exact),   cmocka_unit_test(test_filtered_light),
        cmocka_unit_test(test_deepest)};
    return cmocka_run_group_tests_name("media", tests, NULL, NULL);
}
