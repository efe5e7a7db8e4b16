/**
 * @file
 * @brief Tests of pictures on surfaces and in the sky: where on them points lie, and what they show
 *        there, in every engine.
 */
#include "testing.h"

#include "base/encoding.h"

#include <math.h>
#include <stdlib.h>

/** Texels around a map of the earth, to measure errors in. */
#define MAP_WIDTH 4096
/** Half a turn, radians. */
#define SCALAR_PI 3.14159265358979323846L

// --- helpers -------------------------------------------------------------------------------------

/**
 * Adds a picture to a scene.
 * @param texture  The picture; the scene's from now on.
 * @return What materials and the sky call it.
 */
static size_t add_texture(Scene *scene, Texture *texture) {
    char name[32];
    size_t index;
    Error error = {0};
    snprintf(name, sizeof name, "%zu.png", scene->texture_count);
    const SceneFile file = {name, name, "test:1"};
    assert_true(scene_add_texture(scene, &file, &index, &error));
    scene->textures[index].texture = texture;
    return index + 1;
}

/** Makes the next shapes of a scene show a picture, in full light from everywhere. @param texture
 *  The picture; the scene's from now on. */
static void use_texture(Scene *scene, Texture *texture) {
    Error error = {0};
    SceneMaterial material = *(const SceneMaterial *)scene_material_keyword.defaults;
    material.texture_id = add_texture(scene, texture);
    scene->ambient = (Rgbd){1, 1, 1};
    assert_true(scene_add_material(scene, &material, &error));
}

/** @return A picture of 8-bit steps. */
static Texture *encoded_texture(int width, int height, const uint8_t *steps) {
    Texture *texture = texture_create(width, height, false, NULL);
    assert_non_null(texture);
    memcpy(texture_ldr_texels(texture), steps, texture_block_size(texture) - sizeof *texture);
    return texture;
}

/** @return A picture of light. */
static Texture *linear_texture(int width, int height, const float *light) {
    Texture *texture = texture_create(width, height, true, NULL);
    assert_non_null(texture);
    memcpy(texture_hdr_texels(texture), light, texture_block_size(texture) - sizeof *texture);
    return texture;
}

/** @return A picture of two by two texels of red light: 1, 2 above 3, 4. */
static Texture *four_texels(void) {
    static const float light[] = {1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0};
    return linear_texture(2, 2, light);
}

/**
 * @return What an engine answers to one ray.
 * @param from  Where the ray starts.
 */
static RayResult query_ray(const Engine *engine, const Scene *scene, Vec3d from, Vec3d to) {
    RayQueryQuad query = ray_towards(from, to);
    RayResult answer;
    Tracer *tracer = create_tracer(engine, scene);
    engine->intersect(tracer, 1, &query, &answer);
    engine->destroy(tracer);
    return answer;
}

/**
 * Checks where on a picture a ray meets a scene of one shape.
 * @param from  Where the ray starts.
 * @param u  Where it must be.
 * @param v  Where it must be.
 */
static void assert_uv(const Engine *engine, const Scene *scene, Vec3d from, Vec3d to, double u,
                      double v) {
    /** Roundings of the point, of the shape's own numbers and of the angle. */
    const double roundings = 16;
    RayResult answer = query_ray(engine, scene, from, to);
    double bound = fmax(roundings * (double)roundoff(engine), 1e-15);
    assert_int_equal(answer.shape, 0);
    assert_at_most(fabs((double)answer.uv[0] - u), bound, "%s: u is %.9g, not %g", engine->name,
                   (double)answer.uv[0], u);
    assert_at_most(fabs((double)answer.uv[1] - v), bound, "%s: v is %.9g, not %g", engine->name,
                   (double)answer.uv[1], v);
}

/** A place that a ray must find. */
typedef struct UvCase {
    Vec3d from; /**< Where the ray starts. */
    Vec3d to;   /**< Where it goes. */
    double u;   /**< Where on the picture it must be. */
    double v;   /**< Where on the picture it must be. */
} UvCase;

/** Checks places on one shape. */
static void check_uvs(const Engine *engine, const char *name, const void *parameters,
                      const UvCase *cases, size_t count) {
    Scene *scene = create_empty_scene();
    use_texture(scene, four_texels());
    add_shape(scene, name, parameters);
    for (size_t i = 0; i < count; i++) {
        assert_uv(engine, scene, cases[i].from, cases[i].to, cases[i].u, cases[i].v);
    }
    scene_destroy(scene);
}

/** How many items an array has. */
#define COUNT(array) (sizeof(array) / sizeof *(array))

// --- places on shapes ----------------------------------------------------------------------------

/** A sphere is a globe: Greenwich in front, east to the right, north up. */
static void check_sphere(const Engine *engine) {
    const SphereParameters sphere = {.radius = 1};
    const Vec3d zero = {0, 0, 0};
    const UvCase cases[] = {{{0, 0, 4}, zero, 0.5, 0.5},   {{4, 0, 0}, zero, 0.75, 0.5},
                            {{-4, 0, 0}, zero, 0.25, 0.5}, {{0, 4, 0}, zero, 0.5, 1},
                            {{0, -4, 0}, zero, 0.5, 0},    {{3, 0, 3}, zero, 0.625, 0.5},
                            {{0, 3, 3}, zero, 0.5, 0.75}};
    check_uvs(engine, "sphere", &sphere, cases, COUNT(cases));
}

/** Every other shape has its picture where the reference says. */
static void check_flat_shapes(const Engine *engine) {
    const QuadParameters quad = {{1, 2, 0}, {2, 0, 0}, {1, 4, 0}};
    const UvCase on_quad[] = {{{1.5, 3, 1}, {1.5, 3, 0}, 0.125, 0.25},
                              {{3.5, 5, 1}, {3.5, 5, 0}, 0.875, 0.75},
                              {{1.5, 3, -1}, {1.5, 3, 0}, 0.125, 0.25}};
    check_uvs(engine, "quad", &quad, on_quad, COUNT(on_quad));
    const DiskParameters disk = {{1, 0, 0}, {0, 1, 0}, 2};
    const UvCase on_disk[] = {{{1, 1, 0}, {1, 0, 0}, 0.5, 0.5},
                              {{2, 1, 0}, {2, 0, 0}, 0.75, 0.5},
                              {{1, 1, -1}, {1, 0, -1}, 0.5, 0.75}};
    check_uvs(engine, "disk", &disk, on_disk, COUNT(on_disk));
    const PlaneParameters floor = {{0, 0, 0}, {0, 1, 0}}, wall = {{1, 1, 0}, {0, 0, 1}};
    const UvCase on_floor[] = {{{0.25, 1, -0.5}, {0.25, 0, -0.5}, 0.25, 0.5},
                               {{-3.75, 1, 2.5}, {-3.75, 0, 2.5}, -3.75, -2.5}};
    const UvCase on_wall[] = {{{3.5, 2, 1}, {3.5, 2, 0}, 2.5, 1}};
    check_uvs(engine, "plane", &floor, on_floor, COUNT(on_floor));
    check_uvs(engine, "plane", &wall, on_wall, COUNT(on_wall));
}

/** Each face of a box shows all of the picture, upright from outside. */
static void check_box(const Engine *engine) {
    const BoxParameters box = {{0, 0, 0}, {2, 4, 8}};
    const UvCase cases[] = {
        {{0.5, 1, 9}, {0.5, 1, 0}, 0.25, 0.25},  {{0.5, 1, -9}, {0.5, 1, 8}, 0.75, 0.25},
        {{9, 1, 2}, {0, 1, 2}, 0.75, 0.25},      {{-9, 1, 2}, {2, 1, 2}, 0.25, 0.25},
        {{0.5, 9, 2}, {0.5, 0, 2}, 0.25, 0.75},  {{0.5, -9, 2}, {0.5, 4, 2}, 0.25, 0.25},
        {{0.5, 1, 4}, {0.5, 1, 99}, 0.25, 0.25},
    };
    check_uvs(engine, "box", &box, cases, COUNT(cases));
}

/** A cylinder has its picture around it, and one on each end. */
static void check_cylinder(const Engine *engine) {
    const CylinderParameters cylinder = {{0, 1, 0}, {0, 5, 0}, 2, true};
    const UvCase cases[] = {
        {{0, 2, 9}, {0, 2, 0}, 0.5, 0.25},   {{9, 4, 0}, {0, 4, 0}, 0.75, 0.75},
        {{-9, 4, 0}, {0, 4, 0}, 0.25, 0.75}, {{5, 3, 5}, {0, 3, 0}, 0.625, 0.5},
        {{1, 9, 0}, {1, 0, 0}, 0.75, 0.5},   {{0, 9, -1}, {0, 0, -1}, 0.5, 0.75},
        {{1, -9, 0}, {1, 9, 0}, 0.75, 0.5},  {{0, -9, 1}, {0, 9, 1}, 0.5, 0.75},
    };
    check_uvs(engine, "cylinder", &cylinder, cases, COUNT(cases));
}

/** A triangle has the places of its corners. */
static void check_triangle(const Engine *engine) {
    const TriangleParameters triangle = {.corners = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                                         .uvs = {{0, 1}, {2, 1}, {0, -3}}};
    const UvCase cases[] = {{{1, 1, 1}, {1, 1, 0}, 0.5, 0},
                            {{0, 0, 1}, {0, 0, 0}, 0, 1},
                            {{2, 2, -1}, {2, 2, 0}, 1, -1}};
    check_uvs(engine, "triangle", &triangle, cases, COUNT(cases));
}

/** A mesh has the places of its file, whichever triangle is met. */
static void check_mesh(const Engine *engine) {
    const Vec3d positions[] = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    const MeshTriangle triangles[] = {{{0, 1, 2}}, {{0, 2, 3}}};
    const MeshUv uvs[] = {{0, 0}, {1, 0}, {1, 2}, {0, 2}};
    const Transform *plain = transform_keyword.defaults;
    for (int turned = 0; turned < 2; turned++) {
        Scene *scene = create_empty_scene();
        Error error = {0};
        use_texture(scene, four_texels());
        add_mesh(scene, positions, 4, triangles, 2, 0);
        mesh_release(scene->meshes[0].mesh);
        const Mesh counts = {.position_count = 4, .uv_count = 4, .triangle_count = 2};
        Mesh *mesh = scene->meshes[0].mesh = mesh_create(&counts, &error);
        memcpy(mesh->positions, positions, sizeof positions);
        memcpy(mesh->triangles, triangles, sizeof triangles);
        memcpy(mesh->triangle_uvs, triangles, sizeof triangles);
        memcpy(mesh->uvs, uvs, sizeof uvs);
        mesh_update_bounds(mesh);
        double move = 0;
        if (turned) {
            Transform transform = *plain;
            transform.translate.x = move = 8;
            assert_true(transform_keyword.finish(&transform, 0, &error));
            assert_true(scene_set_last_transform(scene, &transform, &error));
        }
        assert_uv(engine, scene, (Vec3d){3 + move, 1, 2}, (Vec3d){3 + move, 1, 0}, 0.75, 0.5);
        assert_uv(engine, scene, (Vec3d){1 + move, 3, 2}, (Vec3d){1 + move, 3, 0}, 0.25, 1.5);
        scene_destroy(scene);
    }
}

/** A shape that is turned and moved takes its picture with it. */
static void check_transformed(const Engine *engine) {
    const SphereParameters sphere = {.radius = 1};
    Scene *scene = create_empty_scene();
    Error error = {0};
    use_texture(scene, four_texels());
    add_shape(scene, "sphere", &sphere);
    Transform transform = *(const Transform *)transform_keyword.defaults;
    transform.rotate = (Vec3d){0, 90, 0};
    transform.scale = (Vec3d){2, 4, 2};
    transform.translate = (Vec3d){8, 0, 0};
    assert_true(transform_keyword.finish(&transform, 0, &error));
    assert_true(scene_set_last_transform(scene, &transform, &error));
    // What looked to z looks to x now, and what looked to x to -z.
    assert_uv(engine, scene, (Vec3d){16, 0, 0}, (Vec3d){8, 0, 0}, 0.5, 0.5);
    assert_uv(engine, scene, (Vec3d){8, 0, -8}, (Vec3d){8, 0, 0}, 0.75, 0.5);
    assert_uv(engine, scene, (Vec3d){8, 9, 0}, (Vec3d){8, 0, 0}, 0.5, 1);
    scene_destroy(scene);
}

/** All shapes have their pictures where the reference says. */
static void test_uvs(void **state) {
    (void)state;
    for_every_engine(check_sphere);
    for_every_engine(check_flat_shapes);
    for_every_engine(check_box);
    for_every_engine(check_cylinder);
    for_every_engine(check_triangle);
    for_every_engine(check_mesh);
    for_every_engine(check_transformed);
}

// --- how exact they are --------------------------------------------------------------------------

/**
 * A ray from a direction to the middle of a sphere.
 * @param kind  0: from anywhere; 1: near a pole; 2: near the seam.
 * @return The ray; its start is exact in float.
 */
static RayQueryQuad ray_to_middle(uint64_t *state, int kind) {
    double across = kind == 1 ? pow(10, -8 * random_unit_double(state)) : 1;
    double x = across * (random_unit_double(state) - 0.5),
           z = across * (random_unit_double(state) - 0.5);
    double y =
        kind == 1 ? copysign(1, random_unit_double(state) - 0.5) : random_unit_double(state) - 0.5;
    if (kind == 2) {
        x *= pow(10, -9 * random_unit_double(state));
        z = -fabs(z) - 0.1;
    }
    Vec3d from = vec3d_scale(vec3d_normalize((Vec3d){x, y, z}), 3);
    from = (Vec3d){round_to_float(from.x), round_to_float(from.y), round_to_float(from.z)};
    return ray_towards(from, (Vec3d){0, 0, 0});
}

/** Worst errors of a sphere's places, texels of a map. */
typedef struct UvErrors {
    double horizontal; /**< To the right, on the ground: a degree is shorter near the poles. */
    double vertical;   /**< Upwards. */
} UvErrors;

/** Measures an answer against the closed form. */
static void measure_uv_error(const RayQueryQuad *query, const RayResult *answer, UvErrors *worst) {
    long double x = (long double)query->origin[0], y = (long double)query->origin[1];
    long double z = (long double)query->origin[2], across = hypotl(x, z);
    long double u = atan2l(x, z) / (2 * SCALAR_PI) + 0.5L, v = 1 - atan2l(across, y) / SCALAR_PI;
    long double difference = fabsl((long double)answer->uv[0] - u);
    difference = fminl(difference, fabsl(difference - 1)); // 0 and 1 are the same place.
    worst->horizontal =
        fmax(worst->horizontal, (double)(difference * MAP_WIDTH * across / hypotl(across, y)));
    worst->vertical =
        fmax(worst->vertical, (double)fabsl((long double)answer->uv[1] - v) * MAP_WIDTH / 2);
    assert_true(answer->uv[0] >= 0 && answer->uv[0] <= 1); // False for NaN.
    assert_true(answer->uv[1] >= 0 && answer->uv[1] <= 1);
}

/** Places on a sphere are no number nowhere, and right to a thousandth of a texel. */
static void check_sphere_exactness(const Engine *engine) {
    /** Texels of a map that a place may be off. */
    const double float_bound = 1e-3, double_bound = 1e-12;
    const SphereParameters sphere = {.radius = 1};
    Scene *scene = create_empty_scene();
    RayQueryQuad queries[BATCH];
    RayResult answers[BATCH];
    add_shape(scene, "sphere", &sphere);
    Tracer *tracer = create_tracer(engine, scene);
    for (int kind = 0; kind < 3; kind++) {
        UvErrors worst = {0};
        uint64_t state = 7;
        for (long done = 0; done < ray_count_for(engine, 100000); done += BATCH) {
            for (int i = 0; i < BATCH; i++) {
                queries[i] = ray_to_middle(&state, kind);
            }
            engine->intersect(tracer, BATCH, queries, answers);
            for (int i = 0; i < BATCH; i++) {
                measure_uv_error(&queries[i], &answers[i], &worst);
            }
        }
        static const char *const names[] = {"anywhere", "near the poles", "near the seam"};
        print_message("  %s %s: off by %.2g texels across, %.2g up\n", engine->name, names[kind],
                      worst.horizontal, worst.vertical);
        double bound = engine->mantissa_bits == 24 ? float_bound : double_bound;
        assert_at_most(worst.horizontal, bound, "%s %s across", engine->name, names[kind]);
        assert_at_most(worst.vertical, bound, "%s %s up", engine->name, names[kind]);
    }
    engine->destroy(tracer);
    scene_destroy(scene);
}

/** Places on a sphere are exact. */
static void test_sphere_exactness(void **state) {
    (void)state;
    for_every_engine(check_sphere_exactness);
}

// --- what pictures show --------------------------------------------------------------------------

/** @return What a picture on a quad shows. */
static void sample_quad_texture(const Engine *engine, Texture *texture, double u, double v,
                                double rgb[3]) {
    Scene *scene = create_empty_scene();
    const QuadParameters quad = {{-u, -v, -1}, {1, 0, 0}, {0, 1, 0}};
    use_texture(scene, texture);
    add_shape(scene, "quad", &quad);
    trace_pixel(engine, scene, rgb);
    scene_destroy(scene);
}

/** Checks what four texels show. */
static void assert_red(const Engine *engine, double u, double v, double red) {
    double rgb[3];
    sample_quad_texture(engine, four_texels(), u, v, rgb);
    assert_at_most(fabs(rgb[0] - red), 8 * fmax((double)roundoff(engine), 1e-16),
                   "%s at %g, %g: %g, not %g", engine->name, u, v, rgb[0], red);
    assert_true(rgb[1] == 0 && rgb[2] == 0);
}

/** Between texels the light is between theirs; at edges that end it is the last's. */
static void check_bilinear(const Engine *engine) {
    assert_red(engine, 0.25, 0.75, 1); // The middles of texels: what they are.
    assert_red(engine, 0.75, 0.75, 2);
    assert_red(engine, 0.25, 0.25, 3);
    assert_red(engine, 0.75, 0.25, 4);
    assert_red(engine, 0.5, 0.5, 2.5); // The mean of all.
    assert_red(engine, 0.375, 0.5, 2.25);
    assert_red(engine, 0.5, 0.375, 3);
    assert_red(engine, 0.625, 0.625, 1 + 0.75 + 2 * 0.25);
    assert_red(engine, 0.015625, 0.984375, 1); // At the corners there is no other.
    assert_red(engine, 0.984375, 0.015625, 4);
}

/** 8-bit steps are decoded by the exact curve, and light stays as it is. */
static void check_steps(const Engine *engine) {
    double rgb[3];
    for (int step = 0; step<256; step += engine->mantissa_bits> 64 ? 51 : 1) {
        const uint8_t steps[] = {(uint8_t)step, (uint8_t)(255 - step), 128};
        sample_quad_texture(engine, encoded_texture(1, 1, steps), 0.3, 0.6, rgb);
        for (int i = 0; i < 3; i++) {
            double light = encoding_decode(ENCODING_SRGB, steps[i]);
            double wanted = engine->mantissa_bits == 24 ? round_to_float(light) : light;
            assert_true(rgb[i] == wanted);
        }
    }
    const float bright[] = {1000, 0.5F, 1e-6F};
    sample_quad_texture(engine, linear_texture(1, 1, bright), 0.5, 0.5, rgb);
    assert_true(rgb[0] == 1000 && rgb[1] == 0.5 && rgb[2] == (double)1e-6F);
}

/** A picture that is repeated has no seam: also left of zero, and far away. */
static void check_repeated(const Engine *engine) {
    static const double far[] = {0, -1, 5, -1024};
    for (size_t i = 0; i < COUNT(far); i++) {
        const struct {
            double u;   /**< Where. */
            double red; /**< What must be seen. */
        } cases[] = {{0.25, 1}, {0.75, 2}, {0.5, 1.5}, {0, 1.5}, {0.125, 1.25}, {0.875, 1.75}};
        for (size_t k = 0; k < COUNT(cases); k++) {
            double rgb[3], u = cases[k].u + far[i];
            Scene *scene = create_empty_scene();
            const PlaneParameters wall = {{-u, -0.75 - far[i], -1}, {0, 0, 1}};
            use_texture(scene, four_texels());
            add_shape(scene, "plane", &wall);
            trace_pixel(engine, scene, rgb);
            assert_at_most(fabs(rgb[0] - cases[k].red),
                           4096 * fmax((double)roundoff(engine), 1e-16), "%s at %g: %g",
                           engine->name, u, rgb[0]);
            scene_destroy(scene);
        }
    }
}

/** A material's picture multiplies its colour, and nothing else. */
static void check_multiplied(const Engine *engine) {
    static const float half[] = {0.5F, 0.25F, 0.125F};
    Scene *scene = create_empty_scene();
    Error error = {0};
    double rgb[3];
    SceneMaterial material = *(const SceneMaterial *)scene_material_keyword.defaults;
    (void)add_texture(scene, four_texels()); // Another one, that nobody shows.
    material.texture_id = add_texture(scene, linear_texture(1, 1, half));
    material.color = (Rgbd){0.5, 1, 1};
    material.emission = (Rgbd){0, 0, 4};
    scene->ambient = (Rgbd){1, 1, 1};
    assert_true(scene_add_material(scene, &material, &error));
    const SphereParameters sphere = {{0, 0, -3}, 1};
    add_shape(scene, "sphere", &sphere);
    trace_pixel(engine, scene, rgb);
    assert_true(rgb[0] == 0.25 && rgb[1] == 0.25 && rgb[2] == 4.125);
    scene_destroy(scene);
}

/** Coordinates of any size show something, and no number of theirs is beyond a picture's end. */
static void check_far_away(const Engine *engine) {
    static const double far[] = {1e6, -1e9, 1e15, -1e15};
    for (size_t i = 0; i < COUNT(far); i++) {
        double rgb[3];
        Scene *scene = create_empty_scene();
        const TriangleParameters triangle = {
            .corners = {{-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}},
            .uvs = {{far[i], -far[i]}, {-far[i], far[i]}, {far[i], far[i]}}};
        use_texture(scene, four_texels());
        add_shape(scene, "triangle", &triangle);
        trace_pixel(engine, scene, rgb);
        assert_true(rgb[0] >= 1 && rgb[0] <= 4);
        scene_destroy(scene);
    }
}

/** Pictures show what they should. */
static void test_samples(void **state) {
    (void)state;
    for_every_engine(check_bilinear);
    for_every_engine(check_steps);
    for_every_engine(check_repeated);
    for_every_engine(check_multiplied);
    for_every_engine(check_far_away);
}

// --- the sky -------------------------------------------------------------------------------------

/**
 * @return What is seen of a panorama: eight columns of red light, 0 to 7, and rows of green, 0 to 3
 *         from the top.
 * @param direction  Which way one looks.
 * @param rotate  How far it is turned, degrees.
 */
static void sample_panorama(const Engine *engine, Vec3d direction, double rotate, double rgb[3]) {
    float light[4 * 8 * 3] = {0};
    for (int i = 0; i < 4 * 8; i++) {
        light[3 * i] = (float)(i % 8);
        light[3 * i + 1] = (float)(i / 8);
    }
    Scene *scene = create_empty_scene();
    (void)add_texture(scene, four_texels()); // Another one, that nobody shows.
    scene->sky.texture_id = add_texture(scene, linear_texture(8, 4, light));
    scene->sky.rotate = rotate;
    bool is_steep = fabs(direction.y) > 0.9 * vec3d_length(direction);
    Vec3d ahead = vec3d_normalize(direction);
    Vec3d up = is_steep ? (Vec3d){0, 0, 1} : (Vec3d){0, 1, 0};
    up = vec3d_subtract(up, vec3d_scale(ahead, vec3d_dot(up, ahead)));
    scene->camera.direction = ahead;
    scene->camera.up = vec3d_normalize(up);
    trace_pixel(engine, scene, rgb);
    scene_destroy(scene);
}

/** Checks a direction. */
static void assert_sky(const Engine *engine, Vec3d direction, double rotate, double red,
                       double green) {
    double rgb[3], bound = 64 * fmax((double)roundoff(engine), 1e-15);
    sample_panorama(engine, direction, rotate, rgb);
    assert_at_most(fabs(rgb[0] - red), bound, "%s: red is %g, not %g", engine->name, rgb[0], red);
    assert_at_most(fabs(rgb[1] - green), bound, "%s: green is %g, not %g", engine->name, rgb[1],
                   green);
}

/** The middle of a panorama is ahead, its right half to the right, its seam behind. */
static void check_sky(const Engine *engine) {
    assert_sky(engine, (Vec3d){0, 0, -1}, 0, 3.5, 1.5);
    assert_sky(engine, (Vec3d){1, 0, 0}, 0, 5.5, 1.5);
    assert_sky(engine, (Vec3d){-1, 0, 0}, 0, 1.5, 1.5);
    assert_sky(engine, (Vec3d){0, 0, 1}, 0, 3.5, 1.5);   // The mean of its last and first column.
    assert_sky(engine, (Vec3d){-1, 0, 0}, 90, 3.5, 1.5); // Turned to the left.
    assert_sky(engine, (Vec3d){0, 0, -1}, -90, 1.5, 1.5);
    assert_sky(engine, (Vec3d){1, 0, 0}, 36000, 5.5, 1.5);
    assert_sky(engine, (Vec3d){0, 1, -1}, 0, 3.5, 0.5);
    assert_sky(engine, (Vec3d){0, -1, -1}, 0, 3.5, 2.5);
    double rgb[3];
    sample_panorama(engine, (Vec3d){0, 1, 0}, 0, rgb);
    assert_true(rgb[1] == 0 && rgb[0] >= 0 && rgb[0] <= 7);
    sample_panorama(engine, (Vec3d){0, -1, 0}, 0, rgb);
    assert_true(rgb[1] == 3 && rgb[0] >= 0 && rgb[0] <= 7);
}

/** A panorama is where it should be. */
static void test_sky(void **state) {
    (void)state;
    for_every_engine(check_sky);
}

// --- all float engines the same ------------------------------------------------------------------

/** Asks random rays about textured shapes. */
static void query_random_rays(const Engine *engine, RayResult *answers) {
    Scene *scene = create_empty_scene();
    uint64_t state = 11;
    RayQueryQuad queries[BATCH];
    use_texture(scene, four_texels());
    const SphereParameters sphere = {{0.1, 0, -3}, 1};
    const CylinderParameters cylinder = {{2, -1, -3}, {2.3, 1, -3.2}, 0.7, true};
    const DiskParameters disk = {{-2, 0.3, -3}, {0.2, 0.5, 1}, 0.8};
    const PlaneParameters floor = {{0, -1, 0}, {0.1, 1, 0.2}};
    add_shape(scene, "sphere", &sphere);
    add_shape(scene, "cylinder", &cylinder);
    add_shape(scene, "disk", &disk);
    add_shape(scene, "plane", &floor);
    for (int i = 0; i < BATCH; i++) {
        Vec3d to = {random_float(&state, -3, 3), random_float(&state, -1.5, 1.5), -3};
        queries[i] = ray_towards((Vec3d){0, 0, 0}, to);
    }
    Tracer *tracer = create_tracer(engine, scene);
    engine->intersect(tracer, BATCH, queries, answers);
    engine->destroy(tracer);
    scene_destroy(scene);
}

/** Lanes make no difference to places, to the bit. */
static void test_same_bits(void **state) {
    (void)state;
    static RayResult first[BATCH], other[BATCH];
    for (const Engine *const *a = engine_list(); *a; a++) {
        for (const Engine *const *b = a + 1; *b; b++) {
            if ((*a)->mantissa_bits != (*b)->mantissa_bits || !engine_is_supported(*a) ||
                !engine_is_supported(*b)) {
                continue;
            }
            query_random_rays(*a, first);
            query_random_rays(*b, other);
            for (int i = 0; i < BATCH; i++) {
                assert_true(first[i].uv[0] == other[i].uv[0] && first[i].uv[1] == other[i].uv[1]);
            }
        }
    }
}

// --- textures themselves -------------------------------------------------------------------------

/** What no light can be is put right. */
static void test_sanitize(void **state) {
    (void)state;
    const float light[] = {NAN, -1, INFINITY, -INFINITY, 1e30F, 0.25F};
    Texture *texture = linear_texture(2, 1, light);
    texture_sanitize(texture);
    const float *tamed = texture_hdr_texels(texture);
    assert_true(tamed[0] == 0 && tamed[1] == 0 && tamed[3] == 0 && tamed[5] == 0.25F);
    assert_true(tamed[2] == (float)INTENSITY_MAXIMUM && tamed[4] == (float)INTENSITY_MAXIMUM);
    texture_release(texture);
}

/** A texture lives as long as anybody holds it. */
static void test_owners(void **state) {
    (void)state;
    double rgb[3];
    PixelGrid grid = {.columns = 1, .rows = 1, .stride = 1};
    RayCounts counts = {0};
    Scene *scene = create_empty_scene();
    const float light[] = {0.5F, 0.25F, 8};
    scene->sky.texture_id = add_texture(scene, linear_texture(1, 1, light));
    const Engine *engine = engine_find("f32x1", NULL);
    Tracer *tracer = create_tracer(engine, scene);
    engine->set_view(tracer, scene, 1, 1);
    scene_destroy(scene);
    engine->trace(tracer, &grid, rgb, &counts);
    assert_true(rgb[0] == 0.5 && rgb[1] == 0.25 && rgb[2] == 8);
    engine->destroy(tracer);
    assert_null(texture_retain(NULL));
    texture_release(NULL);
}

/** Runs the tests. @return How many failed. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_uvs),       cmocka_unit_test(test_sphere_exactness),
        cmocka_unit_test(test_samples),   cmocka_unit_test(test_sky),
        cmocka_unit_test(test_same_bits), cmocka_unit_test(test_sanitize),
        cmocka_unit_test(test_owners),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
