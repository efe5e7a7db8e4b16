/**
 * @file
 * @brief Rectangle and cylinder lights: their irradiance against numerical integrals; their
 *        visibility; they occlude nothing.
 */
#include "light_samples.h"

#include "scene/lights/cylinder_light.h"
#include "scene/lights/rectangle_light.h"

/* --- numerical integrals ---------------------------------------------------------------------- */

/** Steps of an integral in each of its two directions. */
enum { STEPS = 1200 };

/** Steps of an interval, denser near a point: s = peak + width * sinh(x), x in equal steps. */
typedef struct Steps {
    double at[STEPS];     /**< Centre of each step. */
    double length[STEPS]; /**< Length of each step. */
} Steps;

/** @return The steps of an interval. */
static Steps *steps_between(Steps *steps, double begin, double end, double peak, double width) {
    double first = asinh((begin - peak) / width), last = asinh((end - peak) / width);
    for (int i = 0; i < STEPS; i++) {
        double x = first + (last - first) * (i + 0.5) / STEPS, dx = (last - first) / STEPS;
        steps->at[i] = peak + width * sinh(x);
        steps->length[i] = width * cosh(x) * dx;
    }
    return steps;
}

/**
 * @return Irradiance at the origin, whose normal is y, from a piece of an emitter, per unit of area
 *         and radiance.
 * @param normal Normal of the emitter.
 */
static double piece_irradiance(const SceneLight *light, Vec3d point, Vec3d normal, bool two_sided) {
    double distance = vec3d_length(point), cosine = point.y / distance;
    double emitted = -vec3d_dot(point, normal) / distance;
    emitted = two_sided ? fabs(emitted) : emitted;
    double falloff = light->falloff == FALLOFF_INVERSE_SQUARE ? 1 / (distance * distance)
                     : light->falloff == FALLOFF_INVERSE_LINEAR
                         ? 1 / (light->falloff_constant + distance)
                         : 1;
    return fmax(0, cosine) * fmax(0, emitted) * falloff;
}

/** @return Irradiance at the origin from a rectangle light of intensity 1. */
static double rectangle_irradiance(const SceneLight *light) {
    static Steps along_u, along_v;
    const RectangleLightFields *own = scene_light_own(light);
    Vec3d u = vec3d_normalize(own->u), v = vec3d_normalize(own->v), cross = vec3d_cross(u, v);
    Vec3d normal = vec3d_normalize(cross), corner = light->position;
    double sine = vec3d_length(cross), sum = 0;
    double u_length = vec3d_length(own->u), v_length = vec3d_length(own->v);
    // Projection of the origin onto the rectangle's plane, in lengths along u and v.
    double height = fabs(vec3d_dot(corner, normal)), cosine = vec3d_dot(u, v);
    double at_u = -vec3d_dot(corner, u), at_v = -vec3d_dot(corner, v);
    double foot_v = (at_v - cosine * at_u) / (sine * sine);
    double width = fmax(height, 1e-9 * (u_length + v_length));
    steps_between(&along_v, 0, v_length, foot_v, width);
    for (int j = 0; j < STEPS; j++) {
        Vec3d row = vec3d_add(corner, vec3d_scale(v, along_v.at[j]));
        double foot_u = -vec3d_dot(row, u);
        Vec3d to_line = vec3d_add(row, vec3d_scale(u, foot_u));
        steps_between(&along_u, 0, u_length, foot_u, fmax(vec3d_length(to_line), width));
        for (int i = 0; i < STEPS; i++) {
            Vec3d point = vec3d_add(row, vec3d_scale(u, along_u.at[i]));
            sum += piece_irradiance(light, point, normal, own->two_sided) * along_u.length[i] *
                   along_v.length[j] * sine;
        }
    }
    return sum / (u_length * v_length * sine);
}

/** @return Irradiance at the origin from the wall of a cylinder light of intensity 1. */
static double cylinder_irradiance(const SceneLight *light) {
    static Steps along, around;
    const CylinderLightFields *own = scene_light_own(light);
    Vec3d to_top = vec3d_subtract(own->top, light->position), axis = vec3d_normalize(to_top);
    double length = vec3d_length(to_top), radius = light->radius, sum = 0;
    double foot = -vec3d_dot(light->position, axis);
    Vec3d to_axis = vec3d_add(light->position, vec3d_scale(axis, foot));
    double distance = vec3d_length(to_axis);
    // On the axis, any direction is valid.
    Vec3d front = distance > 0 ? vec3d_scale(to_axis, -1 / distance)
                               : vec3d_normalize(vec3d_cross(axis, (Vec3d){0.3, 0.5, 0.7}));
    Vec3d side = vec3d_cross(axis, front);
    double height = fmax(fabs(distance - radius), 1e-9 * radius);
    steps_between(&along, 0, length, foot, height);
    steps_between(&around, -M_PI, M_PI, 0, height / radius);
    for (int i = 0; i < STEPS; i++) {
        double c = cos(around.at[i]), s = sin(around.at[i]);
        Vec3d normal = vec3d_add(vec3d_scale(front, c), vec3d_scale(side, s));
        Vec3d line = vec3d_add(light->position, vec3d_scale(normal, radius));
        for (int j = 0; j < STEPS; j++) {
            Vec3d point = vec3d_add(line, vec3d_scale(axis, along.at[j]));
            sum += piece_irradiance(light, point, normal, false) * radius * around.length[i] *
                   along.length[j];
        }
    }
    return sum / (2 * radius * length);
}

/* --- irradiance ------------------------------------------------------------------------------- */

/** Largest standard deviation of the mean of 64 samples, relative to the integral. */
#define AREA_LIGHT_NOISE 0.02

/** A light, and the origin as the lit point. The floor's normal is y. */
typedef struct AreaLightCase {
    const char *name; /**< Its property. */
    Vec3d position;   /**< Corner of a rectangle, or base of a cylinder. */
    Vec3d u;          /**< Edge of a rectangle; of a cylinder: from base to top. */
    Vec3d v;          /**< Second edge of a rectangle. */
    double radius;    /**< Radius of a cylinder; 0: a rectangle. */
    bool two_sided;   /**< See #RectangleLightFields. */
    int falloff;      /**< A #Falloff. */
} AreaLightCase;

/** The cases, easy and hard. The emitting side of a rectangle is that of u x v. */
static const AreaLightCase area_light_cases[] = {
    {"over it", {-0.5, 2, -0.5}, {1, 0, 0}, {0, 0, 1}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"over it, no falloff", {-0.5, 2, -0.5}, {1, 0, 0}, {0, 0, 1}, 0, false, FALLOFF_NONE},
    {"over it, linear", {-0.5, 2, -0.5}, {1, 0, 0}, {0, 0, 1}, 0, false, FALLOFF_INVERSE_LINEAR},
    {"skew, linear", {-0.5, 3, -0.5}, {1, 0, 0}, {0.8, 0, 0.6}, 0, false, FALLOFF_INVERSE_LINEAR},
    {"near it", {-0.5, 1e-3, -0.3}, {1, 0, 0}, {0, 0, 1}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"nearer", {-0.5, 1e-5, -0.3}, {1, 0, 0}, {0, 0, 1}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"beside it", {0.05, 0.02, -0.5}, {1, 0, 0}, {0, 0, 1}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"at its edge", {0, 0.01, -0.5}, {1, 0, 0}, {0, 0, 1}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"a wall", {1, 0, -1}, {0, 0, 2}, {0, 1, 0}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"half below", {1, -2, -1}, {0, 0, 2}, {0, 3, 0}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"huge", {-1e4, 1, -9e3}, {2e4, 0, 0}, {0, 0, 2e4}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"tiny", {-5e-7, 1, 0}, {1e-6, 0, 0}, {0, 0, 1e-6}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"far", {3e4, 1e4, 0}, {1, 0, 0}, {0, 0, 1}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"skew", {-0.5, 0.1, -0.5}, {1, 0, 0}, {0.8, 0, 0.6}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"tilted", {-1, 0.5, 0}, {1, 0.5, 0}, {0, 0.2, 1}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"long", {-50, 0.2, 0}, {100, 0, 0}, {0, 0, 0.01}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"from behind", {-0.5, 2, -0.5}, {0, 0, 1}, {1, 0, 0}, 0, false, FALLOFF_INVERSE_SQUARE},
    {"both sides", {-0.5, 2, -0.5}, {0, 0, 1}, {1, 0, 0}, 0, true, FALLOFF_INVERSE_SQUARE},
    {"in its plane", {1, 0, 0}, {1, 1, 0}, {1, -1, 0}, 0, true, FALLOFF_INVERSE_SQUARE},
    {"tube over it", {-0.5, 1, 0}, {1, 0, 0}, {0, 0, 0}, 0.05, false, FALLOFF_INVERSE_SQUARE},
    {"tube, no falloff", {-0.5, 1, 0}, {1, 0, 0}, {0, 0, 0}, 0.05, false, FALLOFF_NONE},
    {"tube, linear", {-0.5, 1, 0}, {1, 0, 0}, {0, 0, 0}, 0.05, false, FALLOFF_INVERSE_LINEAR},
    {"far tube, linear", {2e4, 1e4, 0}, {0, 0, 3}, {0, 0, 0}, 0.5, false, FALLOFF_INVERSE_LINEAR},
    {"tube near", {-0.9, 0.051, 0}, {2, 0, 0}, {0, 0, 0}, 0.05, false, FALLOFF_INVERSE_SQUARE},
    {"tube nearer", {-0.9, 0.050001, 0}, {2, 0, 0}, {0, 0, 0}, 0.05, false, FALLOFF_INVERSE_SQUARE},
    {"thick tube", {-1, 1.01, 0}, {3, 0, 0}, {0, 0, 0}, 1, false, FALLOFF_INVERSE_SQUARE},
    {"standing tube", {1, 0.5, 0.5}, {0, 2, 0}, {0, 0, 0}, 0.3, false, FALLOFF_INVERSE_SQUARE},
    {"half below, tube", {1, -1, 0}, {0, 2, 0}, {0, 0, 0}, 0.2, false, FALLOFF_INVERSE_SQUARE},
    {"under its end", {0, 0.1, 0}, {0, 2, 0}, {0, 0, 0}, 0.2, false, FALLOFF_INVERSE_SQUARE},
    {"beside its end", {0.25, 0.1, 0}, {0, 2, 0}, {0, 0, 0}, 0.2, false, FALLOFF_INVERSE_SQUARE},
    {"beyond its end", {1, 0.2, 0}, {2, 0.1, 0}, {0, 0, 0}, 0.1, false, FALLOFF_INVERSE_SQUARE},
    {"endless tube", {-1e4, 0.3, 0}, {3e4, 0, 0}, {0, 0, 0}, 0.02, false, FALLOFF_INVERSE_SQUARE},
    {"thin tube", {-1, 0.5, 0}, {2, 0, 0}, {0, 0, 0}, 1e-6, false, FALLOFF_INVERSE_SQUARE},
    {"far tube", {2e4, 1e4, 0}, {0, 0, 3}, {0, 0, 0}, 0.5, false, FALLOFF_INVERSE_SQUARE},
};

/** @return The light of a case. */
static SceneLight light_of_case(const AreaLightCase *test) {
    SceneLight light = light_of_kind(test->radius > 0 ? "cylinder_light" : "rectangle_light");
    light.position = test->position;
    light.falloff = test->falloff;
    light.radius = test->radius;
    RectangleLightFields edges = {test->u, test->v, test->two_sided};
    CylinderLightFields ends = {vec3d_add(test->position, test->u)};
    if (test->radius > 0) {
        memcpy(light.own, &ends, sizeof ends);
    } else {
        memcpy(light.own, &edges, sizeof edges);
    }
    return light;
}

/** @return A floor, with a camera so near to it that no light is between them. */
static Scene *floor_scene(const SceneLight *light) {
    Scene *scene = create_empty_scene();
    aim_camera(scene, (Vec3d){-2e-7, 3e-7, 1e-7}, (Vec3d){0, 0, 0});
    add_shape(scene, "plane", &(PlaneParameters){{0, 0, 0}, {0, 1, 0}});
    add_light(scene, *light);
    return scene;
}

/**
 * The mean of many samples equals the integral, within five standard errors and rounding errors.
 * The noise of 64 samples is low.
 */
static void test_integrals(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof area_light_cases / sizeof *area_light_cases; i++) {
        const AreaLightCase *test = &area_light_cases[i];
        SceneLight light = light_of_case(test);
        Scene *scene = floor_scene(&light);
        double truth =
            test->radius > 0 ? cylinder_irradiance(&light) : rectangle_irradiance(&light);
        for (const Engine *const *engine = engine_list(); *engine; engine++) {
            if (!engine_is_supported(*engine)) {
                continue;
            }
            int samples = (*engine)->mantissa_bits > 64 ? 4 : 64;
            LightStatistics found = sample_soft_light(*engine, scene, samples, truth);
            double allowed = 5 * found.rms / PIXELS + 3e-4 * truth + 1e-12;
            assert_at_most(fabs(found.mean - truth), allowed, "%s in %s", test->name,
                           (*engine)->name);
            if (samples == 64) {
                assert_at_most(found.rms, AREA_LIGHT_NOISE * truth + 1e-12, "noise of %s in %s",
                               test->name, (*engine)->name);
            }
        }
        scene_destroy(scene);
    }
}

/**
 * Far away, and with one sample at the centre, area lights equal point lights, times the cosine or
 * sine at the emitter.
 */
static void check_far_and_center(const Engine *engine) {
    for (int i = 0; i < 4; i++) {
        double rgb[3];
        AreaLightCase test = {"", {-0.5, 8, 5.5}, {1, 0, 0}, {0, 0, 1}, 0, 0, 1};
        Vec3d middle = {0, 8, 6};
        // For a cylinder: sine of the angle to the axis, which is along x: 1.
        double cosine = 0.8, truth;
        if (i % 2) {
            test.position = (Vec3d){-0.5, 8, 6};
            test.radius = 0.01;
            cosine = 1;
        }
        truth = 0.8 * cosine / vec3d_dot(middle, middle);
        SceneLight light = light_of_case(&test);
        Scene *scene = floor_scene(&light);
        if (i < 2) {
            trace_pixel(engine, scene, rgb);
            assert_at_most(fabs(rgb[0] / truth - 1), 1e-6, "from the middle, %d in %s", i,
                           engine->name);
        } else {
            LightStatistics found = sample_soft_light(engine, scene, 4, truth);
            assert_at_most(fabs(found.mean / truth - 1), 0.01, "far, %d in %s", i, engine->name);
        }
        scene_destroy(scene);
    }
}

/** See #check_far_and_center. */
static void test_far_and_center(void **state) {
    (void)state;
    for_every_engine(check_far_and_center);
}

/**
 * At points in a light, on it and near it, even for the strongest lights, colours are finite. None
 * exceeds the colour right beside the light.
 */
static void check_finite(const Engine *engine) {
    for (int i = 0; i < 24; i++) {
        double height = (double[]){0, 1e-30, 1e-12, 1e-6, 1e-3, 0.1}[i % 6];
        bool is_tube = i / 6 % 2, is_strong = i / 12;
        AreaLightCase test = {"", {-0.5, height, -0.5}, {1, 0, 0}, {0, 0, 1}, 0, true, 1};
        if (is_tube) {
            test.position = (Vec3d){-0.5, height, 0};
            test.radius = 0.1;
        }
        SceneLight light = light_of_case(&test);
        light.intensity = is_strong ? INTENSITY_MAXIMUM : 1;
        light.color = (Rgbd){is_strong ? INTENSITY_MAXIMUM : 1, 0, 1};
        Scene *scene = floor_scene(&light);
        scene->materials[0].specular = 1;
        for (int samples = 1; samples <= 16; samples += 15) {
            LightStatistics found = sample_soft_light(engine, scene, samples, 0);
            double most = is_strong ? 1e32 : 4 * M_PI / (is_tube ? 0.2 : 1);
            assert_at_most(found.rms, most, "%g high, %d, %d samples in %s", height, i, samples,
                           engine->name);
        }
        scene_destroy(scene);
    }
}

/** See #check_finite. */
static void test_finite(void **state) {
    (void)state;
    for_every_engine(check_finite);
}

/* --- shadows ------------------------------------------------------------------------------------
 */

/**
 * Shadows ignore a ceiling in the plane of a rectangle, shapes in a cylinder light and other
 * lights. A shape in front of the light casts a shadow.
 */
static void check_shadows(const Engine *engine) {
    for (int i = 0; i < 8; i++) {
        bool is_tube = i % 2, is_soft = i / 2 % 2, is_hidden = i / 4;
        AreaLightCase test = {"", {-0.1, 2.7, -0.1}, {0.2, 0, 0}, {0, 0, 0.2}, 0, 0, 1};
        if (is_tube) {
            test.position = (Vec3d){-0.2, 2.7, 0};
            test.radius = 0.1;
        }
        SceneLight light = light_of_case(&test), dark = light;
        Scene *scene = floor_scene(&light);
        dark.position.y = 1.3;
        dark.intensity = 0;
        ((double *)dark.own)[1] -= is_tube ? 1.4 : 0;
        add_light(scene, dark);
        if (is_tube) {
            add_shape(scene, "cylinder",
                      &(CylinderParameters){{-0.2, 2.7, 0}, {0.2, 2.7, 0}, 0.09, true});
        } else {
            add_shape(scene, "plane", &(PlaneParameters){{0, 2.7, 0}, {0, -1, 0}});
        }
        if (is_hidden) {
            add_shape(scene, "quad", &(QuadParameters){{-3, 2, -3}, {6, 0, 0}, {0, 0, 6}});
        }
        double truth = is_tube ? cylinder_irradiance(&light) : rectangle_irradiance(&light);
        LightStatistics found = sample_soft_light(engine, scene, is_soft ? 16 : 1, truth);
        if (is_hidden) {
            assert_at_most(found.mean, 0, "a shadow, %d in %s", i, engine->name);
        } else {
            assert_at_most(fabs(found.mean / truth - 1), 0.05, "no shadow, %d in %s", i,
                           engine->name);
            assert_at_most(found.rms / truth, 0.1, "no shadow anywhere, %d in %s", i, engine->name);
        }
        scene_destroy(scene);
    }
}

/** See #check_shadows. */
static void test_shadows(void **state) {
    (void)state;
    for_every_engine(check_shadows);
}

/* --- visibility ------------------------------------------------------------------------------- */

/**
 * Lights are visible in their colour, directly and in a mirror. A one-sided rectangle is invisible
 * from behind; shapes occlude it; moves are visible.
 */
static void check_visible(const Engine *engine) {
    for (int i = 0; i < 3; i++) {
        double rgb[3];
        AreaLightCase test = {"", {-1, -1, -5}, {2, 0, 0}, {0, 2, 0}, 0, i == 1, 1};
        if (i == 2) {
            test.position = (Vec3d){-1, 0, -5};
            test.radius = 0.5;
        }
        SceneLight light = light_of_case(&test);
        light.color = (Rgbd){0.25, 0.5, 2};
        light.intensity = 2;
        Scene *scene = create_empty_scene();
        add_light(scene, light);
        trace_pixel(engine, scene, rgb);
        assert_true(rgb[0] == 0.5 && rgb[1] == 1 && rgb[2] == 4);
        aim_camera(scene, (Vec3d){0, 0, -10}, (Vec3d){0, 0, -5});
        trace_pixel(engine, scene, rgb);
        assert_true(rgb[0] == (i == 0 ? 0 : 0.5));
        // A mirror behind the camera, which reflects half of the light.
        aim_camera(scene, (Vec3d){0, 0, 0}, (Vec3d){0, 0, 5});
        add_shape(scene, "plane", &(PlaneParameters){{0, 0, 4}, {0, 0, 1}});
        scene->materials[0].reflectivity = (Rgbd){0.5, 0.5, 0.5};
        scene->materials[0].color = (Rgbd){0, 0, 0};
        trace_pixel(engine, scene, rgb);
        assert_at_most(fabs(rgb[0] - 0.25), 8 * 0x1p-24, "mirrored, %d in %s", i, engine->name);
        scene_light_move(&scene->lights[0], (Vec3d){5, 0, 0}, 1);
        trace_pixel(engine, scene, rgb);
        assert_true(rgb[0] == 0);
        scene_destroy(scene);
    }
}

/** See #check_visible. */
static void test_visible(void **state) {
    (void)state;
    for_every_engine(check_visible);
}

/**
 * All points of a light move. Positions are copied only to a light of the same class. The reference
 * point is the centre.
 */
static void test_moves(void **state) {
    (void)state;
    SceneLight tube = light_of_kind("cylinder_light"), other = tube, sun = light_of_kind("sun");
    Vec3d center;
    scene_light_move(&tube, (Vec3d){1, 2, 3}, 5);
    assert_true(scene_light_center(&tube, &center));
    assert_true(center.x == 1 && center.y == 3.9 && center.z == 3);
    scene_light_copy_position(&other, &sun);
    assert_true(other.position.x == -0.5);
    scene_light_copy_position(&other, &tube);
    assert_true(other.position.x == 0.5 && other.own[0] == 1.5 && other.own[2] == 3);
    assert_false(scene_light_center(&sun, &center));
    SceneLight panel = light_of_kind("rectangle_light"), small = panel;
    small.own[0] = 0.5;
    scene_light_move(&panel, (Vec3d){1, 0, 0}, 5);
    scene_light_copy_position(&small, &panel);
    assert_true(small.position.x == 0.5 && small.own[0] == 0.5);
    Vec3d outline[SCENE_LIGHT_OUTLINE_POINTS];
    assert_int_equal(scene_light_outline(&panel, outline), 5);
    assert_true(outline[2].x == 1.5 && outline[2].y == 1.9 && outline[2].z == 0.5);
    assert_int_equal(scene_light_outline(&sun, outline), 0);
}

/** @return A scene with both kinds of lights, a mirror, and edges. */
static Scene *area_light_scene(void) {
    Scene *scene = create_empty_scene();
    scene->camera.position = (Vec3d){0, 0, 4};
    scene->materials[0].reflectivity = (Rgbd){0.3, 0.3, 0.3};
    scene->materials[0].specular = 0.5;
    AreaLightCase panel = {"", {-1.4, 1, 0.2}, {1, 0.2, 0}, {0, 0, 1}, 0, true, 1};
    AreaLightCase tube = {"", {0.6, 0.2, -1}, {0.8, 0.8, 0.3}, {0, 0, 0}, 0.06, false, 1};
    add_light(scene, light_of_case(&panel));
    add_light(scene, light_of_case(&tube));
    add_shape(scene, "plane", &(PlaneParameters){{0, -1, 0}, {0, 1, 0}});
    add_shape(scene, "sphere", &(SphereParameters){{0, -0.4, 0}, 0.6});
    add_shape(scene, "box", &(BoxParameters){{-1.5, -1, -1}, {-0.8, 0, -0.3}});
    return scene;
}

/** Pictures are bitwise equal for any number of lanes and threads. */
static void test_same_bits(void **state) {
    (void)state;
    Scene *scene = area_light_scene();
    for (int bits = 32; bits <= 64; bits *= 2) {
        RenderSettings settings = small_settings(scene, bits == 32 ? "f32x1" : "f64x1", 1);
        settings.samples = 6;
        Picture narrow = draw_picture(scene, &settings);
        for (const Engine *const *engine = engine_list(); *engine; engine++) {
            bool is_other = ((*engine)->mantissa_bits == 24) == (bits == 32);
            if (engine_is_supported(*engine) && is_other && (*engine)->mantissa_bits < 64) {
                settings.engine = *engine;
                settings.threads = 3;
                assert_same_picture(&narrow, draw_picture(scene, &settings));
            }
        }
        picture_deinit(&narrow);
    }
    scene_destroy(scene);
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_integrals), cmocka_unit_test(test_far_and_center),
        cmocka_unit_test(test_finite),    cmocka_unit_test(test_shadows),
        cmocka_unit_test(test_visible),   cmocka_unit_test(test_moves),
        cmocka_unit_test(test_same_bits),
    };
    return cmocka_run_group_tests_name("area lights", tests, NULL, NULL);
}
