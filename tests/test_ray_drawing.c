/**
 * @file
 * @brief Tests of the drawn rays of a pixel: from where the second camera sees them, and what is
 *        drawn beside them.
 */
#include "fixtures.h"
#include "fontconfig_leak.h"
#include "load_scene.h"
#include "pictures.h"

#include "render/ray_drawing.h"
#include "render/ray_pane.h"

/** Size of the second camera's picture: wide and low, as beside the words of a lesson. */
enum { VIEW_WIDTH = 480, VIEW_HEIGHT = 250 };

/** The rays of a pixel. */
typedef struct Rays {
    Scene *scene;       /**< The scene. */
    Renderer *renderer; /**< Draws it. */
    RayTree tree;       /**< The rays. */
    OrbitCamera orbit;  /**< The second camera. */
    RayDrawing drawing; /**< The drawn rays. */
} Rays;

/** Traces the rays of a pixel. @param x Fraction of the picture's width. @param hidden See
 *  #orbit_camera_fit. */
static void rays_init(Rays *rays, const char *path, double x, double y, unsigned hidden) {
    Error error = {0};
    *rays = (Rays){.scene = load_scene(path)};
    RenderSettings settings = small_settings(rays->scene, "f64x1", 1);
    rays->renderer = create_renderer(rays->scene, &settings);
    assert_true(renderer_record_ray_tree(rays->renderer, (int)(x * WIDTH), (int)(y * HEIGHT),
                                         &rays->tree, &error));
    CutAway cut = {0};
    cut_away_begin(&cut, rays->scene, &rays->tree);
    rays->orbit = orbit_camera_fit(rays->renderer, rays->scene, &cut, &rays->tree, hidden,
                                   VIEW_WIDTH, VIEW_HEIGHT);
    cut_away_deinit(&cut);
    rays->drawing =
        (RayDrawing){.tree = &rays->tree,
                     .orbit = &rays->orbit,
                     .view = orbit_camera_project(&rays->orbit, VIEW_WIDTH, VIEW_HEIGHT),
                     .hidden_kinds = hidden};
}

/** Frees all. */
static void rays_deinit(Rays *rays) {
    ray_tree_deinit(&rays->tree);
    renderer_destroy(rays->renderer);
    scene_destroy(rays->scene);
}

/** @return The first ray of a kind; fails without any. */
static size_t first_of(const Rays *rays, RayType kind) {
    size_t i = 0;
    while (i < rays->tree.count && rays->tree.nodes[i].kind != kind) {
        i++;
    }
    assert_true(i < rays->tree.count);
    return i;
}

/** @return The angle in the drawing between a ray and the one that it comes from, degrees. */
static double drawn_angle(const Rays *rays, size_t ray) {
    ProjectedRay to, from;
    assert_true(ray_drawing_project(&rays->drawing, (size_t)rays->tree.nodes[ray].parent, &from));
    assert_true(ray_drawing_project(&rays->drawing, ray, &to));
    double back = atan2(from.y[0] - from.y[1], from.x[0] - from.x[1]);
    double on = atan2(to.y[1] - to.y[0], to.x[1] - to.x[0]);
    return fabs(remainder(back - on, 2 * M_PI)) * (180 / M_PI);
}

/** @return The angle between a ray and the way back along the one that it comes from, degrees. */
static double true_angle(const Rays *rays, size_t ray) {
    const RayTreeNode *node = &rays->tree.nodes[ray];
    double cosine = -vec3d_dot(node->direction, rays->tree.nodes[node->parent].direction);
    return acos(fmin(fmax(cosine, -1), 1)) * (180 / M_PI);
}

/** @return Pixels of a ray in the drawing. */
static double drawn_length(const Rays *rays, size_t ray) {
    ProjectedRay line;
    assert_true(ray_drawing_project(&rays->drawing, ray, &line));
    return hypot(line.x[1] - line.x[0], line.y[1] - line.y[0]);
}

/** The second camera looks from where rays lie apart: mirrored ones from those that come in, shadow
 *  rays from those of the eye. The narrower the angle, the easier it is hidden. */
static void test_clear_view(void **state) {
    (void)state;
    static const struct {
        const char *path; /**< The scene. */
        double x, y;      /**< The pixel. */
        RayType kind;     /**< The ray that is looked at. */
    } cases[] = {{"scenes/lessons/mirror-and-ball.lua", 0.39, 0.56, RAY_REFLECTION},
                 {"scenes/lessons/mirror-and-ball.lua", 0.58, 0.56, RAY_REFLECTION},
                 {"scenes/lessons/mirror-and-ball.lua", 0.5, 0.5, RAY_REFLECTION},
                 {"scenes/figure-c4.lua", 0.2, 0.8, RAY_SHADOW},
                 {"scenes/figure-c4.lua", 0.6, 0.9, RAY_SHADOW},
                 {"scenes/box.lua", 0.55, 0.92, RAY_SHADOW},
                 {"scenes/glass-sphere.lua", 0.63, 0.46, RAY_REFRACTION}};
    for (size_t i = 0; i < COUNT(cases); i++) {
        Rays rays;
        rays_init(&rays, cases[i].path, cases[i].x, cases[i].y, 0);
        const size_t ray = first_of(&rays, cases[i].kind);
        double angle = true_angle(&rays, ray), drawn = drawn_angle(&rays, ray);
        // Refracted rays go on: what they are bent by counts.
        angle = fmin(angle, 180 - angle);
        drawn = fmin(drawn, 180 - drawn);
        if (drawn < 0.6 * angle) {
            fail_msg("%s at %g %g: %g degrees are drawn as %g", cases[i].path, cases[i].x,
                     cases[i].y, angle, drawn);
        }
        rays_deinit(&rays);
    }
}

/** The lamp that a blocked shadow ray was sent to is in the picture, and the way to it is drawn. */
static void test_blocked(void **state) {
    (void)state;
    Rays rays;
    double x, y;
    rays_init(&rays, "scenes/figure-c4.lua", 0.2, 0.8, 0);
    const size_t shadow = first_of(&rays, RAY_SHADOW);
    assert_true(rays.tree.nodes[shadow].is_hit);
    assert_true(projected_view_point(&rays.drawing.view, rays.scene->lights[0].position, &x, &y));
    assert_true(x > 0 && x < VIEW_WIDTH && y > 0 && y < VIEW_HEIGHT);
    rays_deinit(&rays);
}

/** Rays that are hidden need no room: the others are larger. */
static void test_hidden_kinds(void **state) {
    (void)state;
    Rays all, some;
    rays_init(&all, "scenes/lessons/mirror-and-ball.lua", 0.58, 0.56, 0);
    rays_init(&some, "scenes/lessons/mirror-and-ball.lua", 0.58, 0.56, 1U << RAY_SHADOW);
    assert_true(drawn_length(&some, 0) > 1.1 * drawn_length(&all, 0));
    rays_deinit(&all);
    rays_deinit(&some);
}

/** The second camera comes nearer to a point and back again; what is there comes to the middle. */
static void test_zoom(void **state) {
    (void)state;
    Rays rays;
    rays_init(&rays, "scenes/glass-sphere.lua", 0.63, 0.46, 0);
    const size_t inside = first_of(&rays, RAY_REFRACTION);
    const Vec3d focus = orbit_camera_ray_middle(&rays.orbit, &rays.tree.nodes[inside]);
    const OrbitCamera first = rays.orbit;
    const double before = drawn_length(&rays, inside);
    orbit_camera_zoom(&rays.orbit, 3, focus);
    rays.drawing.view = orbit_camera_project(&rays.orbit, VIEW_WIDTH, VIEW_HEIGHT);
    assert_true(drawn_length(&rays, inside) > 2.5 * before);
    orbit_camera_zoom(&rays.orbit, 1 / 3.0, focus);
    assert_true(fabs(rays.orbit.zoom - first.zoom) < 1e-12);
    assert_true(vec3d_length(vec3d_subtract(rays.orbit.target, first.target)) < 1e-12);
    rays_deinit(&rays);
}

/** @return Whether anything is drawn at a point of the scene. */
static bool is_drawn_at(const RayDrawing *drawing, Vec3d point) {
    cairo_surface_t *image =
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, VIEW_WIDTH, VIEW_HEIGHT);
    RayDrawing target = *drawing;
    double x, y;
    bool is_drawn = false;
    assert_true(projected_view_point(&drawing->view, point, &x, &y));
    assert_true(x > 2 && x < VIEW_WIDTH - 3 && y > 2 && y < VIEW_HEIGHT - 3);
    target.cairo = cairo_create(image);
    ray_drawing_rays(&target);
    cairo_surface_flush(image);
    const unsigned char *data = cairo_image_surface_get_data(image);
    for (int row = (int)y - 2; row <= (int)y + 2; row++) {
        for (int column = (int)x - 2; column <= (int)x + 2; column++) {
            is_drawn |= data[row * cairo_image_surface_get_stride(image) + 4 * column + 3] > 0;
        }
    }
    cairo_destroy(target.cairo);
    cairo_surface_destroy(image);
    return is_drawn;
}

/** @return A point at the normal where a ray ends, some pixels away from the surface. */
static Vec3d at_normal(const Rays *rays, size_t ray, double pixels) {
    const RayTreeNode *node = &rays->tree.nodes[ray];
    const double units = pixels / projected_view_scale(&rays->drawing.view, node->point);
    return vec3d_add(node->point, vec3d_scale(node->normal, units));
}

/** The normal is drawn where the selected ray starts and ends: at glass on both sides. */
static void test_normals(void **state) {
    (void)state;
    static const double outside = 0.15 * VIEW_HEIGHT, inside = -0.15 * VIEW_HEIGHT;
    Rays mirror, glass;
    rays_init(&mirror, "scenes/lessons/mirror-and-ball.lua", 0.58, 0.56, 1U << RAY_SHADOW);
    mirror.drawing.selected = RAY_DRAWING_UNSELECTED;
    assert_false(is_drawn_at(&mirror.drawing, at_normal(&mirror, 0, outside)));
    mirror.drawing.selected = 0;
    assert_true(is_drawn_at(&mirror.drawing, at_normal(&mirror, 0, outside)));
    assert_false(is_drawn_at(&mirror.drawing, at_normal(&mirror, 0, inside)));
    mirror.drawing.selected = first_of(&mirror, RAY_REFLECTION);
    assert_true(is_drawn_at(&mirror.drawing, at_normal(&mirror, 0, outside)));
    rays_deinit(&mirror);
    rays_init(&glass, "scenes/glass-sphere.lua", 0.63, 0.46,
              1U << RAY_SHADOW | 1U << RAY_REFLECTION);
    glass.drawing.selected = 0;
    assert_true(is_drawn_at(&glass.drawing, at_normal(&glass, 0, outside)));
    assert_true(is_drawn_at(&glass.drawing, at_normal(&glass, 0, inside)));
    rays_deinit(&glass);
}

/** @return Whether anything is drawn right of a drawing beside the rays. @param width Of the
 * drawing. */
static bool is_drawn_beside(const Rays *rays, RayPane pane, int width) {
    enum { TEXT_SIZE = 20 };
    cairo_surface_t *image =
        cairo_image_surface_create(CAIRO_FORMAT_ARGB32, VIEW_WIDTH, VIEW_HEIGHT);
    Error error = {0};
    RayPaneInput input = {rays->renderer, rays->scene, engine_find("f64x1", &error), rays->drawing,
                          TEXT_SIZE};
    bool is_drawn = false;
    input.drawing.cairo = cairo_create(image);
    ray_pane_draw(pane, &input, width, VIEW_HEIGHT);
    cairo_surface_flush(image);
    const unsigned char *data = cairo_image_surface_get_data(image);
    for (int row = 0; row < VIEW_HEIGHT; row++) {
        for (int column = width; column < VIEW_WIDTH; column++) {
            is_drawn |= data[row * cairo_image_surface_get_stride(image) + 4 * column + 3] > 0;
        }
    }
    cairo_destroy(input.drawing.cairo);
    cairo_surface_destroy(image);
    return is_drawn;
}

/** Words of a narrow drawing are broken into lines: none is cut. */
static void test_narrow_drawings(void **state) {
    (void)state;
    Rays rays;
    rays_init(&rays, "scenes/glass-sphere.lua", 0.5, 0.38, 0);
    rays.drawing.selected = first_of(&rays, RAY_REFLECTION);
    assert_true(rays.tree.nodes[rays.drawing.selected].shape < 0);
    for (RayPane pane = RAY_PANE_PLAN; pane < RAY_PANE_COUNT; pane++) {
        assert_false(is_drawn_beside(&rays, pane, 160));
        rays.drawing.selected = 0;
        assert_false(is_drawn_beside(&rays, pane, 160));
    }
    rays_deinit(&rays);
    rays_init(&rays, "scenes/turned-frame.lua", 0.5, 0.5, 0);
    rays.drawing.selected = 0;
    assert_false(is_drawn_beside(&rays, RAY_PANE_MARCH, 160));
    rays_deinit(&rays);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_clear_view),   cmocka_unit_test(test_blocked),
        cmocka_unit_test(test_hidden_kinds), cmocka_unit_test(test_zoom),
        cmocka_unit_test(test_normals),      cmocka_unit_test(test_narrow_drawings),
    };
    return cmocka_run_group_tests_name("ray drawing", tests, NULL, NULL);
}
