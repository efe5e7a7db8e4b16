/**
 * @file
 * @brief Merged rays behind many panes of glass, judged by paths that are chosen by chance.
 *
 * The judge follows one path at a time: at each surface, Fresnel's reflectance is the probability
 * that the path is mirrored. It has no tree, no cutoff and no merging, and its errors are known:
 * the standard deviations of its means.
 */
#include "glass_scenes.h"

/** Size of a picture. */
enum { COLUMNS = 16, ROWS = 12, PIXELS = COLUMNS * ROWS, VALUES = 3 * PIXELS };
/** Number of panes. */
enum { PANES = 12 };
/** Paths of the judge per pixel. */
enum { PATHS = 20000 };
/** Index of refraction of the panes. */
static const double glass_ior = 1.5;
/** Share of light that each surface of a pane lets through. */
static const double glass_transparency = 0.95;
/** Where the wall behind the panes is, and where on it dark begins. */
static const double wall_z = -6, dark_x = 0.2;
/** Light of the left part of the wall, of the right one, and from all other directions. */
static const double bright = 0.9, dark = 0.1, sky = 0.4;
/** Where shapes are placed: as given. */
static const Placement here = {1, 0};
/** Camera. */
static const Vec3d eye = {0, 1, 5}, view = {0, -0.1, -1};

/** A pane. */
typedef struct Pane {
    Vec3d low;  /**< Least coordinates. */
    Vec3d high; /**< Greatest coordinates. */
} Pane;

/** @return A number from 0 to 1 for each pane: equal ones, or without pattern. */
static double pane_number(int pane, bool is_regular, double factor) {
    return is_regular ? 0.5 : fmod(pane * factor, 1);
}

/** Makes panes. @param is_regular Whether all are equally thick and equally far apart. */
static void panes_make(bool is_regular, Pane *panes) {
    double z = 2.4;
    for (int i = 0; i < PANES; i++) {
        double thickness = 0.03 + 0.05 * pane_number(i + 1, is_regular, 0.7548);
        z -= 0.3 + 0.1 * pane_number(i + 1, is_regular, 0.618);
        panes[i] = (Pane){{-1.5, 0.1, z}, {1.5, 1.4, z + thickness}};
    }
}

/** @return The scene of panes before a wall. */
static Scene *panes_scene(const Pane *panes) {
    Scene *scene = create_empty_scene();
    scene->sky.horizon = scene->sky.zenith = (Rgbd){sky, sky, sky};
    SceneMaterial glass = glass_material(glass_ior);
    glass.transparency = (Rgbd){glass_transparency, glass_transparency, glass_transparency};
    glass.color = (Rgbd){0, 0, 0};
    use_material(scene, glass);
    for (int i = 0; i < PANES; i++) {
        add_placed_box(scene, here, panes[i].low, panes[i].high);
    }
    use_material(scene, emissive_material((Rgbd){bright, bright, bright}));
    add_placed_quad(scene, here, (Vec3d){-99, -99, wall_z}, (Vec3d){99 + dark_x, 0, 0},
                    (Vec3d){0, 198, 0});
    use_material(scene, emissive_material((Rgbd){dark, dark, dark}));
    add_placed_quad(scene, here, (Vec3d){dark_x, -99, wall_z}, (Vec3d){99, 0, 0},
                    (Vec3d){0, 198, 0});
    set_camera(scene, here, eye, view);
    return scene;
}

/* --- the judge -------------------------------------------------------------------------------- */

/** A path. */
typedef struct Path {
    double at[3];        /**< Where it is. */
    double direction[3]; /**< Where it goes: of length one. */
} Path;

/** Finds where a path enters and leaves a pane, and the axes of the faces there. */
static void pane_clip(const Path *path, const Pane *pane, double *enter, double *leave,
                      int *enter_axis, int *leave_axis) {
    const double *low = &pane->low.x, *high = &pane->high.x;
    *enter = -INFINITY;
    *leave = INFINITY;
    for (int axis = 0; axis < 3; axis++) {
        double a = (low[axis] - path->at[axis]) / path->direction[axis];
        double b = (high[axis] - path->at[axis]) / path->direction[axis];
        if (fmin(a, b) > *enter) {
            *enter = fmin(a, b);
            *enter_axis = axis;
        }
        if (fmax(a, b) < *leave) {
            *leave = fmax(a, b);
            *leave_axis = axis;
        }
    }
}

/** @return The distance to the next surface of a pane; infinity: there is none. @param[out] axis
 *  Along its normal. @param[out] is_inside Whether it is left there. */
static double panes_hit(const Path *path, const Pane *panes, int *axis, bool *is_inside) {
    const double least = 1e-9;
    double nearest = INFINITY;
    for (int i = 0; i < PANES; i++) {
        double enter, leave;
        int enter_axis = 0, leave_axis = 0;
        pane_clip(path, &panes[i], &enter, &leave, &enter_axis, &leave_axis);
        if (enter > leave || leave < least) {
            continue;
        }
        bool is_leaving = enter < least;
        double distance = is_leaving ? leave : enter;
        if (distance < nearest) {
            nearest = distance;
            *axis = is_leaving ? leave_axis : enter_axis;
            *is_inside = is_leaving;
        }
    }
    return nearest;
}

/** @return The light at the end of a path outside of all panes. */
static double path_end(const Path *path) {
    double distance = (wall_z - path->at[2]) / path->direction[2];
    if (!(distance > 0)) {
        return sky;
    }
    double x = path->at[0] + distance * path->direction[0];
    return x < dark_x ? bright : dark;
}

/** Mirrors or refracts a path at a surface. @param axis Along its normal. */
static void path_turn(Path *path, int axis, bool is_inside, uint64_t *seed) {
    double eta = is_inside ? glass_ior : 1 / glass_ior;
    double cosine = fabs(path->direction[axis]), sign = path->direction[axis] < 0 ? -1 : 1;
    double squared = 1 - eta * eta * (1 - cosine * cosine);
    double beyond = sqrt(fmax(squared, 0));
    double across = (eta * cosine - beyond) / (eta * cosine + beyond);
    double along = (cosine - eta * beyond) / (cosine + eta * beyond);
    double reflectance = squared > 0 ? (across * across + along * along) / 2 : 1;
    if (random_unit_double(seed) < reflectance) {
        path->direction[axis] = -path->direction[axis];
        return;
    }
    for (int i = 0; i < 3; i++) {
        path->direction[i] *= eta;
    }
    path->direction[axis] = sign * beyond;
}

/** @return The light of a path by chance. */
static double path_light(Path path, const Pane *panes, uint64_t *seed) {
    const double least_weight = 1e-7;
    double weight = 1;
    int axis = 0;
    bool is_inside = false;
    while (weight > least_weight) {
        double distance = panes_hit(&path, panes, &axis, &is_inside);
        if (isinf(distance)) {
            return weight * path_end(&path);
        }
        weight *= glass_transparency;
        for (int i = 0; i < 3; i++) {
            path.at[i] += distance * path.direction[i];
        }
        path_turn(&path, axis, is_inside, seed);
    }
    return 0;
}

/** @return The mean of many paths. @param[out] deviation Its standard deviation. */
static double judged_light(const Path *camera_ray, const Pane *panes, uint64_t *seed,
                           double *deviation) {
    double sum = 0, squares = 0;
    for (int i = 0; i < PATHS; i++) {
        double light = path_light(*camera_ray, panes, seed);
        sum += light;
        squares += light * light;
    }
    double mean = sum / PATHS;
    *deviation = sqrt(fmax(squares / PATHS - mean * mean, 0) / PATHS);
    return mean;
}

/** @return The ray of a pixel: through its centre. */
static Path pixel_ray(const SceneCamera *camera, int column, int row) {
    double half = tan(camera->fov / 2 * acos(-1) / 180);
    Vec3d right = vec3d_cross(camera->direction, camera->up);
    double x = (2 * column + 1 - COLUMNS) * half / COLUMNS;
    double y = -(2 * row + 1 - ROWS) * half / COLUMNS;
    Vec3d d =
        vec3d_add(camera->direction, vec3d_add(vec3d_scale(right, x), vec3d_scale(camera->up, y)));
    d = vec3d_normalize(d);
    return (Path){{eye.x, eye.y, eye.z}, {d.x, d.y, d.z}};
}

/* --- the tests -------------------------------------------------------------------------------- */

/** What the judge says of a picture. */
typedef struct Verdict {
    double light[PIXELS];     /**< The mean of its paths. */
    double deviation[PIXELS]; /**< The standard deviation of that. */
} Verdict;

/** Makes a scene of panes, and finds the light of all its pixels by chance. @param is_regular See
 *  panes_make(). @return The scene. */
static Scene *judged_scene(bool is_regular, Verdict *verdict) {
    Pane panes[PANES];
    uint64_t seed = 1;
    panes_make(is_regular, panes);
    Scene *scene = panes_scene(panes);
    for (int i = 0; i < PIXELS; i++) {
        Path ray = pixel_ray(&scene->camera, i % COLUMNS, i / COLUMNS);
        verdict->light[i] = judged_light(&ray, panes, &seed, &verdict->deviation[i]);
    }
    return scene;
}

/** Traces a picture and compares it: each pixel is right to half a step and the judge's noise, and
 *  the picture is not darker. @return The rays. */
static RayCounts check_picture(EngineRole role, const Scene *scene, double cutoff,
                               const Verdict *verdict) {
    double rgb[VALUES], sum = 0, noise = 0;
    const Engine *engine = engine_with_role(role);
    RayCounts counts =
        trace_picture(engine, scene, (TraceLimits){DEPTH_MAXIMUM, cutoff}, COLUMNS, ROWS, rgb);
    for (int i = 0; i < PIXELS; i++) {
        double truth = srgb_steps(verdict->light[i]);
        double deviation = srgb_steps(verdict->light[i] + verdict->deviation[i]) - truth;
        double steps = srgb_steps(rgb[i]) - truth;
        assert_at_most(fabs(steps), 0.5 + 4 * deviation, "pixel %d in %s", i, engine->name);
        sum += steps;
        noise += deviation * deviation;
    }
    print_message("%s: %.3f steps brighter than the judge, whose noise is %.3f; %d of %d camera "
                  "rays lack light, of at most %.2f steps\n",
                  engine->name, sum / PIXELS, sqrt(noise) / PIXELS, (int)counts.unresolved, PIXELS,
                  counts.unresolved_steps);
    assert_at_most(fabs(sum) / PIXELS, 4 * sqrt(noise) / PIXELS, "mean in %s", engine->name);
    return counts;
}

/** Equal panes; also with a finer cutoff, which merges no fewer rays. */
static void test_equal_panes(void **state) {
    (void)state;
    Verdict verdict;
    Scene *scene = judged_scene(true, &verdict);
    RayCounts single = check_picture(ENGINE_FASTEST, scene, CUTOFF_DEFAULT, &verdict);
    RayCounts fine = check_picture(ENGINE_DOUBLE, scene, CUTOFF_DEFAULT / 10, &verdict);
    assert_true(single.unresolved <= PIXELS / 50);
    assert_at_most(fine.unresolved_steps, 0.5, "light missing at a fine cutoff");
    scene_destroy(scene);
}

/** Panes of all thicknesses and distances. */
static void test_other_panes(void **state) {
    (void)state;
    Verdict verdict;
    Scene *scene = judged_scene(false, &verdict);
    check_picture(ENGINE_FASTEST, scene, CUTOFF_DEFAULT, &verdict);
    check_picture(ENGINE_DOUBLE, scene, CUTOFF_DEFAULT, &verdict);
    scene_destroy(scene);
}

/** All lanes merge the same rays. */
static void test_lanes(void **state) {
    (void)state;
    const char *const names[][3] = {{"f32x1", "f32x8", "f32x16"}, {"f64x1", "f64x4", "f64x4"}};
    for (int i = 0; i < 2; i++) {
        Pane panes[PANES];
        double one[VALUES], other[VALUES];
        Error error = {0};
        panes_make(false, panes);
        Scene *scene = panes_scene(panes);
        TraceLimits limits = {DEPTH_MAXIMUM, 0};
        RayCounts ones =
            trace_picture(engine_find(names[i][0], &error), scene, limits, COLUMNS, ROWS, one);
        for (int k = 1; k < 3; k++) {
            const Engine *engine = engine_find(names[i][k], &error);
            if (engine) {
                RayCounts others = trace_picture(engine, scene, limits, COLUMNS, ROWS, other);
                assert_memory_equal(one, other, sizeof one);
                assert_true(ones.unresolved == others.unresolved);
            }
        }
        scene_destroy(scene);
    }
}

/** Rays between spheres go different ways: what cannot be merged is given up soon. */
static void test_spheres(void **state) {
    (void)state;
    double rgb[VALUES];
    Scene *scene = create_empty_scene();
    const Engine *engine = engine_with_role(ENGINE_DOUBLE);
    scene->sky.horizon = scene->sky.zenith = (Rgbd){sky, sky, sky};
    for (int i = 0; i < PANES; i++) {
        use_material(scene, glass_material(i % 2 ? 1 : glass_ior));
        add_placed_sphere(scene, here, (Vec3d){0.1 * cos(i), 0.8 + 0.1 * sin(i), 0.02 * i},
                          0.9 - 0.05 * i);
    }
    set_camera(scene, here, eye, view);
    RayCounts counts =
        trace_picture(engine, scene, (TraceLimits){DEPTH_MAXIMUM, 0}, COLUMNS, ROWS, rgb);
    assert_true(counts.unresolved > 0);
    double rays = (double)(counts.reflection + counts.refraction);
    assert_at_most(rays, 2.0 * RAYS_PER_SAMPLE_MAXIMUM * PIXELS / 4, "rays of %d pixels", PIXELS);
    scene_destroy(scene);
}

/** How often tracing was asked to go on, and may. */
typedef struct Patience {
    int asked; /**< So far. */
    int limit; /**< Then it is to stop. */
} Patience;

/** See #PixelGrid.is_stopped. */
static bool is_impatient(const void *context) {
    Patience *patience = (Patience *)(uintptr_t)context;
    return ++patience->asked > patience->limit;
}

/** @return The rays below the pixels of a tile. @param patience Until when it is traced. */
static double tile_rays(const Engine *engine, const Scene *scene, Patience *patience) {
    enum { TILE_WIDTH = 64, TILE_HEIGHT = 16 };
    static double rgb[3 * TILE_WIDTH * TILE_HEIGHT];
    Error error = {0};
    TraceSettings settings = {
        .depth = DEPTH_MAXIMUM, .cutoff = CUTOFF_DEFAULT, .offset = OFFSET_BOUND};
    Tracer *tracer = engine->create_tracer(scene, &settings, &error);
    assert_non_null(tracer);
    const PixelGrid grid = {.columns = TILE_WIDTH,
                            .rows = TILE_HEIGHT,
                            .stride = 1,
                            .is_stopped = is_impatient,
                            .stop_context = patience};
    RayCounts counts = {0};
    engine->set_view(tracer, scene, TILE_WIDTH, TILE_HEIGHT);
    engine->trace(tracer, &grid, rgb, &counts);
    engine->destroy(tracer);
    return (double)counts.refraction;
}

/** A tile behind panes takes seconds: it can be stopped in the middle. */
static void test_stop(void **state) {
    (void)state;
    const Engine *engine = engine_with_role(ENGINE_FASTEST);
    Pane panes[PANES];
    panes_make(true, panes);
    Scene *scene = panes_scene(panes);
    Patience endless = {0, INT32_MAX}, short_one = {0, 1};
    double all = tile_rays(engine, scene, &endless);
    double first = tile_rays(engine, scene, &short_one);
    assert_true(endless.asked >= 4);
    assert_int_equal(short_one.asked, 2);
    assert_at_most(first, all / 2, "rays in %s", engine->name);
    scene_destroy(scene);
}

/** @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_equal_panes), cmocka_unit_test(test_other_panes),
        cmocka_unit_test(test_lanes), cmocka_unit_test(test_spheres), cmocka_unit_test(test_stop)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
