/**
 * @file
 * @brief Tests of the formulas of rays: the numbers in the texts obey the laws in another form than
 *        the program computes them, and the sums add up. Labels and leader lines do not meet.
 */
#include "fixtures.h"
#include "load_scene.h"

#include "render/cut_away.h"
#include "render/label_layout.h"
#include "render/ray_formula.h"
#include "render/ray_hit.h"
#include "render/ray_microscope.h"

/** Size of the pictures. */
enum { WIDTH = 64, HEIGHT = 48 };
/** Error of a number of four digits, relative. */
static const double FOUR_DIGITS = 1e-3;

/** The rays of one pixel. */
typedef struct RayFixture {
    Scene *scene;       /**< The scene. */
    Renderer *renderer; /**< Its renderer. */
    RayTree tree;       /**< The rays. */
} RayFixture;

/** Loads a scene. @param engine Name of the engine. */
static void ray_fixture_init(RayFixture *fixture, const char *path, const char *engine) {
    Error error = {0};
    fixture->scene = load_scene(path);
    RenderSettings settings = {.engine = engine_find(engine, &error),
                               .width = WIDTH,
                               .height = HEIGHT,
                               .samples = 1,
                               .threads = 1};
    settings.trace.depth = fixture->scene->image.depth;
    settings.trace.offset = OFFSET_BOUND;
    settings.trace.cutoff = CUTOFF_DEFAULT;
    fixture->renderer = renderer_create(fixture->scene, &settings, &error);
    assert_non_null(fixture->renderer);
    assert_true(
        renderer_start(fixture->renderer, fixture->scene, WIDTH, HEIGHT, NULL, NULL, &error));
}

/** Traces the rays of a pixel. @return What formulas are written of. */
static RayFormulaInput trace(RayFixture *fixture, int x, int y) {
    Error error = {0};
    assert_true(renderer_record_ray_tree(fixture->renderer, x, y, &fixture->tree, &error));
    return (RayFormulaInput){fixture->scene, &fixture->tree, true};
}

/** Frees everything. */
static void ray_fixture_deinit(RayFixture *fixture) {
    ray_tree_deinit(&fixture->tree);
    renderer_destroy(fixture->renderer);
    scene_destroy(fixture->scene);
}

/** @return A formula by its label; NULL: there is none. */
static const char *formula_of(const RayFormulas *formulas, const char *label) {
    for (size_t i = 0; i < formulas->count; i++) {
        if (strcmp(formulas->items[i].label, label) == 0) {
            return formulas->items[i].text;
        }
    }
    return NULL;
}

/** @return Three numbers, or one for all three. */
static Vec3d parse_vector(const char *text) {
    Vec3d v;
    if (sscanf(text, " (%lf, %lf, %lf)", &v.x, &v.y, &v.z) != 3) {
        assert_int_equal(sscanf(text, " %lf", &v.x), 1);
        v.y = v.z = v.x;
    }
    return v;
}

/** @return What a formula gives: all behind its last equals sign. */
static Vec3d result_of(const char *text) {
    const char *equals = strrchr(text, '=');
    return parse_vector(equals ? equals + 1 : text);
}

/** Fails unless two numbers agree to four digits. @param scale Their magnitude. */
static void assert_near(double a, double b, double scale, const char *what) {
    assert_at_most(fabs(a - b), FOUR_DIGITS * fmax(scale, 1e-6), "%s: %g and %g", what, a, b);
}

/** @return The angle between two directions, degrees, by its tangent. */
static double angle_between(Vec3d a, Vec3d b) {
    return atan2(vec3d_length(vec3d_cross(a, b)), vec3d_dot(a, b)) * (180 / M_PI);
}

/* --- laws ------------------------------------------------------------------------------------- */

/** Checks `o + t d = p`. */
static void check_point(const RayFormulas *formulas, const RayTreeNode *ray) {
    const char *text = formula_of(formulas, "point");
    Vec3d origin, direction;
    double t;
    if (!text) {
        return;
    }
    int found = sscanf(text, "o + t d = (%lf, %lf, %lf) + %lf (%lf, %lf, %lf)", &origin.x,
                       &origin.y, &origin.z, &t, &direction.x, &direction.y, &direction.z);
    assert_int_equal(found, 7);
    Vec3d sum = vec3d_add(origin, vec3d_scale(direction, t)), point = result_of(text);
    assert_near(vec3d_length(vec3d_subtract(sum, point)), 0, vec3d_length(origin) + t, "o + t d");
    assert_near(vec3d_length(vec3d_subtract(point, ray->point)), 0, vec3d_length(origin) + t,
                "the point");
}

/** Checks Snell's law, by angles that are measured between the rays. */
static void check_snell(const RayFormulas *formulas, const RayTreeNode *ray,
                        const RayTreeNode *parent) {
    double n1, a, n2, b, sine;
    const char *text = formula_of(formulas, "refraction");
    assert_non_null(text);
    if (parent->surface.is_overridden) {
        assert_null(strchr(text, '='));
        return;
    }
    int found = sscanf(text, "n1 sin a = n2 sin b: %lf × sin %lf° = %lf × sin %lf° = %lf", &n1, &a,
                       &n2, &b, &sine);
    assert_int_equal(found, 5);
    Vec3d inwards = vec3d_scale(ray_front_normal(parent), -1);
    assert_near(a, angle_between(parent->direction, inwards), 90, "angle a");
    assert_near(b, angle_between(ray->direction, inwards), 90, "angle b");
    assert_near(n1 * sin(a * (M_PI / 180)), n2 * sin(b * (M_PI / 180)), n2, "Snell");
    assert_near(sine, n1 * sin(a * (M_PI / 180)), n2, "Snell's product");
}

/** Checks that the shares in percent and the chain to the weights are those of the rays that
 * follow: what is not mirrored, refracted or its own is nothing. */
static void check_shares(const RayFormulas *formulas, const RayTreeSurface *surface) {
    double mirrored, refracted, own = 0;
    const char *text = formula_of(formulas, "result");
    assert_non_null(text);
    assert_true(sscanf(text, "%lf %% are mirrored, %lf %% refracted, %lf", &mirrored, &refracted,
                       &own) >= 2);
    assert_at_most(fabs(mirrored + refracted + own - 100), 0.3, "all shares");
    Vec3d weight = result_of(formula_of(formulas, "mirrored"));
    assert_near(weight.y, surface->reflect_weight.green, 1, "weight of the mirrored ray");
    weight = result_of(formula_of(formulas, "refracted"));
    assert_near(weight.y, surface->refract_weight.green, 1, "weight of the refracted ray");
}

/** Checks Fresnel's share by his own form, with sines and tangents of sums of the angles. */
static void check_fresnel(const RayFormulas *formulas, const RayTreeNode *ray) {
    const RayTreeSurface *surface = &ray->surface;
    double mirrored, rest;
    const char *text = formula_of(formulas, "Fresnel");
    double a = acos(fmin(1, surface->cosine)),
           b = asin(surface->ior_from / surface->ior_to * sin(a));
    if (!surface->is_transparent || surface->is_overridden) {
        return;
    }
    assert_non_null(text);
    if (surface->is_total) {
        assert_non_null(strstr(text, "all is mirrored"));
        return;
    }
    assert_int_equal(
        sscanf(text, "R = (r_s² + r_p²) / 2 = %lf is mirrored, 1 − R = %lf", &mirrored, &rest), 2);
    if (a > 0.01 && surface->ior_from != surface->ior_to) {
        double across = sin(a - b) / sin(a + b), along = tan(a - b) / tan(a + b);
        assert_near(mirrored, (across * across + along * along) / 2, 1, "Fresnel");
        assert_near(fabs(result_of(formula_of(formulas, "r_s")).x), fabs(across), 1, "r_s");
        assert_near(fabs(result_of(formula_of(formulas, "r_p")).x), fabs(along), 1, "r_p");
    }
    assert_near(mirrored + rest, 1, 1, "both shares");
    check_shares(formulas, surface);
}

/** Checks the law of reflection: equal angles, in one plane. */
static void check_reflection(const RayFormulas *formulas, const RayTreeNode *parent) {
    const char *text = formula_of(formulas, "reflection");
    assert_non_null(text);
    Vec3d r = result_of(text), n = parent->normal, d = parent->direction;
    assert_near(vec3d_length(r), 1, 1, "length of r");
    assert_near(vec3d_dot(r, n), -vec3d_dot(d, n), 1, "angle of r");
    assert_near(vec3d_dot(r, vec3d_cross(d, n)), 0, 1, "plane of r");
}

/** Checks the light of a lamp that falls off with the square of the distance. */
static void check_falloff(const RayFormulas *formulas, const RayFormulaInput *input,
                          const RayTreeNode *ray, const RayTreeNode *parent) {
    const SceneLight *light = &input->scene->lights[ray->light];
    const char *text = formula_of(formulas, "f");
    double distance;
    if (text && sscanf(text, "1 / d² = 1 / %lf²", &distance) == 1) {
        double expected = vec3d_length(vec3d_subtract(light->position, parent->point));
        assert_near(distance, expected, expected, "distance of a lamp");
        assert_near(result_of(text).x, 1 / (expected * expected), ray->falloff, "1 / d²");
    }
}

/** Checks that the terms of a sum make its last entry, and that this is the ray's colour. */
static void check_sum(const RayFormulaInput *input, size_t index) {
    RayFormulas sum;
    Vec3d total = {0};
    Rgbd color = input->tree->nodes[index].color;
    ray_sum_write(input, index, &sum);
    if (sum.omitted > 0) {
        return;
    }
    for (size_t i = 0; i + 1 < sum.count; i++) {
        total = vec3d_add(total, result_of(sum.items[i].text));
    }
    Vec3d result = result_of(sum.items[sum.count - 1].text);
    double scale = fmax(result.x, fmax(result.y, result.z));
    assert_near(result.x, color.red, scale, "result of a sum");
    assert_near(result.z, color.blue, scale, "result of a sum");
    assert_near(vec3d_length(vec3d_subtract(total, result)), 0, 2 * scale, "terms of a sum");
}

/** Checks the formulas of a ray. */
static void check_ray(const RayFormulaInput *input, size_t index) {
    const RayTreeNode *ray = &input->tree->nodes[index];
    const RayTreeNode *parent = index > 0 ? &input->tree->nodes[ray->parent] : NULL;
    RayFormulas formulas;
    ray_formulas_write(input, index, &formulas);
    assert_int_equal(formulas.omitted, 0);
    check_point(&formulas, ray);
    check_sum(input, index);
    if (ray->kind == RAY_SHADOW && !ray->is_hit) {
        check_falloff(&formulas, input, ray, parent);
    }
    if (ray->kind == RAY_REFRACTION) {
        check_snell(&formulas, ray, parent);
    } else if (ray->kind == RAY_REFLECTION) {
        check_reflection(&formulas, parent);
    }
    if (ray->kind != RAY_SHADOW && ray->shape >= 0) {
        check_fresnel(&formulas, ray);
    }
    if (parent && ray->kind != RAY_SHADOW) {
        assert_near(result_of(formula_of(&formulas, "weight")).x, ray->throughput, ray->throughput,
                    "weight");
    }
}

/** All laws hold in all formulas of scenes with mirrors, glass, fields and lamps of each kind. */
static void test_formulas(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/box.lua", "scenes/glass-sphere.lua",
                                         "scenes/lamps.lua", "scenes/chess.lua",
                                         "scenes/glass-teapot.lua"};
    const char *const engines[] = {"auto", "f64x1"};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        for (size_t e = 0; e < 2; e++) {
            RayFixture fixture = {0};
            ray_fixture_init(&fixture, scenes[i], engines[e]);
            for (int pixel = 0; pixel < 24; pixel++) {
                RayFormulaInput input =
                    trace(&fixture, (pixel * 29 + 7) % WIDTH, (pixel * 17 + 5) % HEIGHT);
                for (size_t ray = 0; ray < input.tree->count; ray++) {
                    check_ray(&input, ray);
                }
            }
            ray_fixture_deinit(&fixture);
        }
    }
}

/** The refracted ray through the middle of the glass sphere has a formula with its numbers. */
static void test_texts(void **state) {
    (void)state;
    RayFixture fixture = {0};
    RayFormulas formulas;
    ray_fixture_init(&fixture, "scenes/glass-sphere.lua", "f64x1");
    RayFormulaInput input = trace(&fixture, WIDTH / 2 + 4, HEIGHT / 2 + 2);
    size_t ray = 0;
    while (ray < input.tree->count && input.tree->nodes[ray].kind != RAY_REFRACTION) {
        ray++;
    }
    assert_true(ray < input.tree->count);
    ray_formulas_write(&input, ray, &formulas);
    assert_non_null(strstr(formula_of(&formulas, "refraction"), "n1 sin a = n2 sin b: 1 × sin "));
    assert_non_null(strstr(formula_of(&formulas, "weight"), "parent's × share = 1 × 0.9"));
    ray_formulas_write(&input, 0, &formulas);
    assert_non_null(formula_of(&formulas, "Fresnel"));
    ray_fixture_deinit(&fixture);
}

/* --- the microscope --------------------------------------------------------------------------- */

/** Heights over a sphere equal those of its equation, in float and in double. */
static void test_microscope(void **state) {
    (void)state;
    const char *const engines[] = {"auto", "f64x1"};
    for (size_t e = 0; e < 2; e++) {
        RayFixture fixture = {0};
        ray_fixture_init(&fixture, "scenes/glass-sphere.lua", engines[e]);
        RayFormulaInput input = trace(&fixture, WIDTH / 2 + 4, HEIGHT / 2 + 2);
        const RayTreeNode *ray = &input.tree->nodes[0];
        const SphereParameters *sphere = fixture.scene->shapes[ray->shape].parameters;
        Error error = {0};
        const Engine *engine = engine_find(engines[e], &error);
        RayMicroscope hit = ray_microscope_measure(engine, fixture.scene, input.tree, 0);
        assert_true(hit.is_valid && hit.next_count >= 2);
        assert_true(hit.ulp == ldexp(1, 1 - engine->mantissa_bits) ||
                    hit.ulp == ldexp(1, -engine->mantissa_bits));
        for (size_t i = 0; i <= hit.next_count; i++) {
            const Vec3d *p = i < hit.next_count ? &input.tree->nodes[hit.next[i].ray].engine_origin
                                                : &ray->engine_point;
            long double x = (long double)p->x - (long double)sphere->center.x,
                        y = (long double)p->y - (long double)sphere->center.y,
                        z = (long double)p->z - (long double)sphere->center.z;
            long double r = (long double)sphere->radius, squared = x * x + y * y + z * z;
            double height = (double)((squared - r * r) / (sqrtl(squared) + r)) / hit.ulp;
            double measured = i < hit.next_count ? hit.next[i].height : hit.height;
            assert_at_most(fabs(measured - height), 0.01 * fmax(1, fabs(height)), "a height");
        }
        ray_fixture_deinit(&fixture);
    }
}

/** The widest number type has nothing to be measured in, and a shadow ray no hit to magnify. */
static void test_no_microscope(void **state) {
    (void)state;
    RayFixture fixture = {0};
    Error error = {0};
    ray_fixture_init(&fixture, "scenes/box.lua", "f64x1");
    RayFormulaInput input = trace(&fixture, WIDTH / 2, HEIGHT / 2);
    const Engine *quad = engine_find("f128x1", &error), *engine = engine_find("f64x1", &error);
    assert_false(ray_microscope_measure(quad, fixture.scene, input.tree, 0).is_valid);
    for (size_t i = 0; i < input.tree->count; i++) {
        bool is_shadow = input.tree->nodes[i].kind == RAY_SHADOW;
        assert_false(is_shadow &&
                     ray_microscope_measure(engine, fixture.scene, input.tree, i).is_valid);
    }
    ray_fixture_deinit(&fixture);
}

/* --- sphere tracing --------------------------------------------------------------------------- */

/** The steps of a march go forwards to the hit; there the field gives next to nothing. */
static void test_march(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/menger-sponge.lua", "scenes/mandelbulb.lua"};
    for (size_t i = 0; i < 2; i++) {
        RayFixture fixture = {0};
        size_t marched = 0;
        ray_fixture_init(&fixture, scenes[i], "f64x1");
        for (int pixel = 0; pixel < 40; pixel++) {
            RayFormulaInput input =
                trace(&fixture, (pixel * 29 + 7) % WIDTH, (pixel * 17 + 5) % HEIGHT);
            const RayTreeNode *ray = &input.tree->nodes[0];
            const RayMarchStep *steps = input.tree->steps + ray->first_step;
            bool is_field =
                ray->shape >= 0 && strcmp(ray_hit_keyword(fixture.scene, ray), "sdf") == 0;
            assert_true(!is_field || ray->step_count > 0);
            for (size_t step = 1; is_field && step < ray->step_count; step++) {
                // A relaxed step that was too long is taken back to the end of the safe one.
                bool is_back = steps[step].distance <= steps[step - 1].distance;
                assert_true(!is_back || step > 1);
                if (is_back) {
                    const RayMarchStep *safe = &steps[step - 2];
                    assert_at_most(fabs(steps[step].distance - safe->distance - safe->radius), 1e-6,
                                   "end of a safe step");
                }
            }
            if (is_field) {
                const RayMarchStep *last = &steps[ray->step_count - 1];
                assert_at_most(fabs(last->distance - ray->distance), 0.02, "end of the march");
                assert_at_most(last->radius, 0.02, "free distance at the hit");
                assert_true(steps[0].radius > last->radius);
                marched++;
            }
        }
        assert_true(marched > 5);
        ray_fixture_deinit(&fixture);
    }
}

/* --- cutting away ----------------------------------------------------------------------------- */

/** From outside a closed room a wall is left out, and the path can be seen; the shapes that rays
 *  meet, but for walls, stay. */
static void test_cut_away(void **state) {
    (void)state;
    RayFixture fixture = {0};
    CutAway cut = {0};
    ray_fixture_init(&fixture, "scenes/lamps.lua", "f64x1");
    RayFormulaInput input = trace(&fixture, WIDTH / 2, HEIGHT / 2);
    assert_true(cut_away_begin(&cut, fixture.scene, input.tree));
    assert_int_equal(cut_away_scene(&cut, fixture.scene).shape_count, fixture.scene->shape_count);
    Vec3d point = input.tree->nodes[0].point, eye = vec3d_add(point, (Vec3d){100, 30, 0});
    assert_true(cut_away_update(&cut, fixture.renderer, fixture.scene, input.tree, eye));
    assert_false(cut_away_update(&cut, fixture.renderer, fixture.scene, input.tree, eye));
    Scene left = cut_away_scene(&cut, fixture.scene);
    assert_true(left.shape_count < fixture.scene->shape_count && left.shape_count > 0);
    Error error = {0};
    const Engine *engine = engine_find("f64x1", &error);
    Tracer *tracer = engine->create_tracer(&left, &(TraceSettings){.samples = 1}, &error);
    Vec3d to = vec3d_subtract(point, eye);
    RayQuery ray = {{eye.x, eye.y, eye.z}, {to.x, to.y, to.z}};
    int shape;
    double distance;
    engine->closest_hits(tracer, 1, &ray, &shape, &distance);
    assert_true(distance > 0.99);
    engine->destroy(tracer);
    cut_away_deinit(&cut);
    ray_fixture_deinit(&fixture);
}

/* --- labels ----------------------------------------------------------------------------------- */

/** @return The next pseudo-random number, 0 to 1. */
static double next_random(uint64_t *state) {
    *state = *state * 6364136223846793005U + 1442695040888963407U;
    return (double)(*state >> 40) / (1 << 24);
}

/** Checks that labels lie inside, and that neither they nor their lines meet. @return How many are
 *  placed. */
static size_t check_labels(const LabelBox *boxes, size_t count, double width, double height) {
    size_t placed = 0;
    for (size_t i = 0; i < count; i++) {
        const LabelBox *box = &boxes[i];
        placed += box->is_placed;
        assert_true(!box->is_placed || (box->x >= 0 && box->x + box->width <= width &&
                                        box->y >= 0 && box->y + box->height <= height));
        for (size_t j = 0; box->is_placed && j < i; j++) {
            assert_false(boxes[j].is_placed && labels_meet(box, &boxes[j]));
        }
    }
    return placed;
}

/** Labels do not meet, wherever their lines are; on lines across the picture most find room. */
static void test_labels(void **state) {
    (void)state;
    enum { LABELS = 20, SETS = 200 };
    uint64_t random = 1;
    size_t placed = 0;
    for (int set = 0; set < SETS; set++) {
        LabelBox boxes[LABELS];
        double length = set % 2 * 300;
        for (size_t i = 0; i < LABELS; i++) {
            boxes[i] = (LabelBox){.from_x = 200 + 60 * next_random(&random),
                                  .from_y = 200 + 60 * next_random(&random),
                                  .width = 10 + (double)(i % 3) * 8,
                                  .height = 16};
            boxes[i].to_x = boxes[i].from_x + length * (next_random(&random) - 0.5);
            boxes[i].to_y = boxes[i].from_y + length * (next_random(&random) - 0.5);
        }
        labels_place(boxes, LABELS, 640, 480);
        assert_true(boxes[0].is_placed);
        size_t count = check_labels(boxes, LABELS, 640, 480);
        placed += set % 2 ? count : 0;
    }
    assert_true(placed > (size_t)SETS / 2 * LABELS * 3 / 4);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_formulas),   cmocka_unit_test(test_texts),
        cmocka_unit_test(test_microscope), cmocka_unit_test(test_no_microscope),
        cmocka_unit_test(test_march),      cmocka_unit_test(test_cut_away),
        cmocka_unit_test(test_labels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
