/**
 * @file
 * @brief Tests of textures on surfaces and in the sky: (u, v) coordinates and colours, in every
 *        engine.
 */
#include "testing.h"

#include "base/encoding.h"

#include <math.h>
#include <stdlib.h>

/** Texels around a map of the earth: the unit of errors. */
#define MAP_WIDTH 4096
/** Pi. */
#define SCALAR_PI 3.14159265358979323846L

// --- helpers -------------------------------------------------------------------------------------

/**
 * Adds a texture to a scene.
 * @param texture  The texture; owned by the scene afterwards.
 * @return Its index for materials and the sky.
 */
static size_t add_texture(Scene *scene, Texture *texture) {
    char name[32];
    size_t index;
    Error error = {0};
    snprintf(name, sizeof name, "%zu.png", scene->texture_count);
    const SceneFile file = {.path = name, .name = name, .location = "test:1"};
    assert_true(scene_add_texture(scene, &file, &index, &error));
    scene->textures[index].texture = texture;
    return index + 1;
}

/**
 * The next shapes of a scene show a texture in full ambient light.
 * @param texture  The texture; owned by the scene afterwards.
 */
static void use_texture(Scene *scene, Texture *texture) {
    Error error = {0};
    SceneMaterial material = *(const SceneMaterial *)scene_material_keyword.defaults;
    material.texture_id = add_texture(scene, texture);
    scene->ambient = (Rgbd){1, 1, 1};
    assert_true(scene_add_material(scene, &material, &error));
}

/** @return A texture of 8-bit values. */
static Texture *encoded_texture(int width, int height, const uint8_t *steps) {
    Texture *texture = texture_create(width, height, false, NULL);
    assert_non_null(texture);
    memcpy(texture_ldr_texels(texture), steps, texture_block_size(texture) - sizeof *texture);
    return texture;
}

/** @return A texture of linear light. */
static Texture *linear_texture(int width, int height, const float *light) {
    Texture *texture = texture_create(width, height, true, NULL);
    assert_non_null(texture);
    memcpy(texture_hdr_texels(texture), light, texture_block_size(texture) - sizeof *texture);
    return texture;
}

/** @return A texture of two by two red texels: 1, 2 above 3, 4. */
static Texture *four_texels(void) {
    static const float light[] = {1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0};
    return linear_texture(2, 2, light);
}

/**
 * @return The hit of one ray.
 * @param from  Its origin.
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
 * Asserts the (u, v) coordinates of a ray's hit in a scene of one shape.
 * @param from  Origin of the ray.
 * @param u  Expected u.
 * @param v  Expected v.
 */
static void assert_uv(const Engine *engine, const Scene *scene, Vec3d from, Vec3d to, double u,
                      double v) {
    /** Rounding errors of the point, of the shape's parameters and of the angle. */
    const double roundings = 16;
    RayResult answer = query_ray(engine, scene, from, to);
    double bound = fmax(roundings * (double)roundoff(engine), 1e-15);
    assert_int_equal(answer.shape, 0);
    assert_at_most(fabs((double)answer.uv[0] - u), bound, "%s: u is %.9g, not %g", engine->name,
                   (double)answer.uv[0], u);
    assert_at_most(fabs((double)answer.uv[1] - v), bound, "%s: v is %.9g, not %g", engine->name,
                   (double)answer.uv[1], v);
}

/** A ray and the expected coordinates. */
typedef struct UvCase {
    Vec3d from; /**< Its origin. */
    Vec3d to;   /**< Its target. */
    double u;   /**< Expected u. */
    double v;   /**< Expected v. */
} UvCase;

/** Checks the coordinates on one shape. */
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

// --- coordinates on shapes -----------------------------------------------------------------------

/** A sphere is mapped like a globe: the prime meridian in front, east to the right, north up. */
static void check_sphere(const Engine *engine) {
    const SphereParameters sphere = {.radius = 1};
    const Vec3d zero = {0, 0, 0};
    const UvCase cases[] = {{{0, 0, 4}, zero, 0.5, 0.5},   {{4, 0, 0}, zero, 0.75, 0.5},
                            {{-4, 0, 0}, zero, 0.25, 0.5}, {{0, 4, 0}, zero, 0.5, 1},
                            {{0, -4, 0}, zero, 0.5, 0},    {{3, 0, 3}, zero, 0.625, 0.5},
                            {{0, 3, 3}, zero, 0.5, 0.75}};
    check_uvs(engine, "sphere", &sphere, cases, COUNT(cases));
}

/** The coordinates on flat shapes are those of the scene reference. */
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

/** Each face of a box shows the whole texture, upright from outside. */
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

/** A cylinder has the texture around its wall, and one on each end. */
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

/** A triangle interpolates the coordinates of its vertices. */
static void check_triangle(const Engine *engine) {
    const TriangleParameters triangle = {.corners = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                                         .uvs = {{0, 1}, {2, 1}, {0, -3}}};
    const UvCase cases[] = {{{1, 1, 1}, {1, 1, 0}, 0.5, 0},
                            {{0, 0, 1}, {0, 0, 0}, 0, 1},
                            {{2, 2, -1}, {2, 2, 0}, 1, -1}};
    check_uvs(engine, "triangle", &triangle, cases, COUNT(cases));
}

/** A mesh has the coordinates of its file. */
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

/** A transformed shape keeps its coordinates. */
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
    // The rotation moves z to x, and x to -z.
    assert_uv(engine, scene, (Vec3d){16, 0, 0}, (Vec3d){8, 0, 0}, 0.5, 0.5);
    assert_uv(engine, scene, (Vec3d){8, 0, -8}, (Vec3d){8, 0, 0}, 0.75, 0.5);
    assert_uv(engine, scene, (Vec3d){8, 9, 0}, (Vec3d){8, 0, 0}, 0.5, 1);
    scene_destroy(scene);
}

/** The coordinates on all shapes are those of the scene reference. */
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

// --- accuracy ------------------------------------------------------------------------------------

/**
 * A ray from a random direction to the centre of a sphere.
 * @param kind  0: any direction; 1: near a pole; 2: near the seam.
 * @return The ray; its origin is exact in float.
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

/** Largest errors of a sphere's coordinates, texels of a map. */
typedef struct UvErrors {
    double horizontal; /**< To the right, as a length on the sphere: a degree is shorter near the
                            poles. */
    double vertical;   /**< Up. */
} UvErrors;

/** Compares a result with the closed form. */
static void measure_uv_error(const RayQueryQuad *query, const RayResult *answer, UvErrors *worst) {
    long double x = (long double)query->origin[0], y = (long double)query->origin[1];
    long double z = (long double)query->origin[2], across = hypotl(x, z);
    long double u = atan2l(x, z) / (2 * SCALAR_PI) + 0.5L, v = 1 - atan2l(across, y) / SCALAR_PI;
    long double difference = fabsl((long double)answer->uv[0] - u);
    difference = fminl(difference, fabsl(difference - 1)); // 0 and 1 are the same meridian.
    worst->horizontal =
        fmax(worst->horizontal, (double)(difference * MAP_WIDTH * across / hypotl(across, y)));
    worst->vertical =
        fmax(worst->vertical, (double)fabsl((long double)answer->uv[1] - v) * MAP_WIDTH / 2);
    assert_true(answer->uv[0] >= 0 && answer->uv[0] <= 1); // False for NaN.
    assert_true(answer->uv[1] >= 0 && answer->uv[1] <= 1);
}

/** Coordinates on a sphere are never NaN, and exact to a thousandth of a texel. */
static void check_sphere_exactness(const Engine *engine) {
    /** Tolerance in texels of a map. */
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

/** Coordinates on a sphere are exact. */
static void test_sphere_exactness(void **state) {
    (void)state;
    for_every_engine(check_sphere_exactness);
}

// --- sampling ------------------------------------------------------------------------------------

/** Samples a texture by a ray to a quad. @param[out] rgb The colour. */
static void sample_quad_texture(const Engine *engine, Texture *texture, double u, double v,
                                double rgb[3]) {
    Scene *scene = create_empty_scene();
    const QuadParameters quad = {{-u, -v, -1}, {1, 0, 0}, {0, 1, 0}};
    use_texture(scene, texture);
    add_shape(scene, "quad", &quad);
    trace_pixel(engine, scene, rgb);
    scene_destroy(scene);
}

/** Checks a sample of the four texels. */
static void assert_red(const Engine *engine, double u, double v, double red) {
    double rgb[3];
    sample_quad_texture(engine, four_texels(), u, v, rgb);
    assert_at_most(fabs(rgb[0] - red), 8 * fmax((double)roundoff(engine), 1e-16),
                   "%s at %g, %g: %g, not %g", engine->name, u, v, rgb[0], red);
    assert_true(rgb[1] == 0 && rgb[2] == 0);
}

/** Samples are interpolated bilinearly, and clamped at edges that do not repeat. */
static void check_bilinear(const Engine *engine) {
    assert_red(engine, 0.25, 0.75, 1); // At the centres of texels: their values.
    assert_red(engine, 0.75, 0.75, 2);
    assert_red(engine, 0.25, 0.25, 3);
    assert_red(engine, 0.75, 0.25, 4);
    assert_red(engine, 0.5, 0.5, 2.5); // The mean of all.
    assert_red(engine, 0.375, 0.5, 2.25);
    assert_red(engine, 0.5, 0.375, 3);
    assert_red(engine, 0.625, 0.625, 1 + 0.75 + 2 * 0.25);
    assert_red(engine, 0.015625, 0.984375, 1); // At the corners: the value of the corner texel.
    assert_red(engine, 0.984375, 0.015625, 4);
}

/** 8-bit values are decoded by the exact sRGB curve; linear light is unchanged. */
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

/** A repeated texture has no seam, also at negative and at large coordinates. */
static void check_repeated(const Engine *engine) {
    static const double far[] = {0, -1, 5, -1024};
    for (size_t i = 0; i < COUNT(far); i++) {
        const struct {
            double u;   /**< Coordinate. */
            double red; /**< Expected red. */
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

/** A material's texture multiplies its colour, and nothing else. */
static void check_multiplied(const Engine *engine) {
    static const float half[] = {0.5F, 0.25F, 0.125F};
    Scene *scene = create_empty_scene();
    Error error = {0};
    double rgb[3];
    SceneMaterial material = *(const SceneMaterial *)scene_material_keyword.defaults;
    (void)add_texture(scene, four_texels()); // An unused texture.
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

/** Coordinates of any size are valid; indices stay inside the texture. */
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

/** Samples of textures equal the expected values. */
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
 * Samples a panorama of eight columns of red light, 0 to 7, and four rows of green, 0 to 3 from the
 * top.
 * @param direction  Direction of view.
 * @param rotate  Rotation of the panorama, degrees.
 * @param[out] rgb  The colour.
 */
static void sample_panorama(const Engine *engine, Vec3d direction, double rotate, double rgb[3]) {
    float light[4 * 8 * 3] = {0};
    for (int i = 0; i < 4 * 8; i++) {
        light[3 * i] = (float)(i % 8);
        light[3 * i + 1] = (float)(i / 8);
    }
    Scene *scene = create_empty_scene();
    (void)add_texture(scene, four_texels()); // An unused texture.
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

/** Asserts the colour of a direction. */
static void assert_sky(const Engine *engine, Vec3d direction, double rotate, double red,
                       double green) {
    double rgb[3], bound = 64 * fmax((double)roundoff(engine), 1e-15);
    sample_panorama(engine, direction, rotate, rgb);
    assert_at_most(fabs(rgb[0] - red), bound, "%s: red is %g, not %g", engine->name, rgb[0], red);
    assert_at_most(fabs(rgb[1] - green), bound, "%s: green is %g, not %g", engine->name, rgb[1],
                   green);
}

/** The centre of a panorama is ahead, its right half to the right, its seam behind. */
static void check_sky(const Engine *engine) {
    assert_sky(engine, (Vec3d){0, 0, -1}, 0, 3.5, 1.5);
    assert_sky(engine, (Vec3d){1, 0, 0}, 0, 5.5, 1.5);
    assert_sky(engine, (Vec3d){-1, 0, 0}, 0, 1.5, 1.5);
    assert_sky(engine, (Vec3d){0, 0, 1}, 0, 3.5, 1.5);   // The mean of last and first column.
    assert_sky(engine, (Vec3d){-1, 0, 0}, 90, 3.5, 1.5); // Rotated to the left.
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

/** A panorama has the right orientation. */
static void test_sky(void **state) {
    (void)state;
    for_every_engine(check_sky);
}

// --- equal bits ----------------------------------------------------------------------------------

/** Traces random rays at textured shapes. */
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

/** Coordinates are bitwise equal for any number of lanes. */
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

// --- the class Texture ---------------------------------------------------------------------------

/** Values that are no light, such as NaN, are corrected. */
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

/** A texture exists while it has owners. */
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

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_uvs),       cmocka_unit_test(test_sphere_exactness),
        cmocka_unit_test(test_samples),   cmocka_unit_test(test_sky),
        cmocka_unit_test(test_same_bits), cmocka_unit_test(test_sanitize),
        cmocka_unit_test(test_owners),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
