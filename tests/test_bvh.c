/**
 * @file
 * @brief The BVH does not change any bit of the results.
 *
 * Scenes with a BVH are compared bitwise with a reference: an engine of one lane that tests every
 * shape without a BVH. Packets, single rays and all widths must agree. Coincident surfaces and
 * closed meshes have known results.
 */
#include "bvh_queries.h"

/* --- BVH against brute force ------------------------------------------------------------------ */

/** Names of the distributions of rays. */
static const char *const ray_kinds[] = {"coherent rays",  "random rays",    "rays along an axis",
                                        "rays in a face", "rays from afar", "rays from a surface"};

/** Shapes that are tested with a BVH and without. */
typedef struct ThingSet {
    const char *name;                    /**< Name in messages. */
    size_t count;                        /**< Number of shapes or triangles. */
    const TriangleSoup *mesh;            /**< The mesh whose triangles are tested; NULL: shapes. */
    void (*add)(Scene *scene, size_t i); /**< Adds shape i, the same in each call. */
} ThingSet;

/** @return A corner whose coordinates other faces share. */
static Vec3d corner_in_scene(uint64_t *state) {
    return (Vec3d){random_face_coordinate(state), random_face_coordinate(state),
                   random_face_coordinate(state)};
}

/** Adds a small closed mesh; half of these meshes are transformed. */
static void add_sphere_mesh(Scene *scene, size_t i, uint64_t *state) {
    TriangleSoup sphere_soup = icosphere_triangles(1);
    Vec3d move = point_in_scene(state);
    for (size_t k = 0; k < sphere_soup.position_count && i % 16 < 8; k++) {
        sphere_soup.positions[k] =
            point_as_float(vec3d_add(vec3d_scale(sphere_soup.positions[k], 0.125), move));
    }
    add_triangle_soup(scene, &sphere_soup, (int)(i / 16 % 3));
    if (i % 16 >= 8) {
        transform_last_shape(scene, state);
    }
    triangle_soup_destroy(&sphere_soup);
}

/** Adds one of many different shapes. @param i Its index; determines the shape. */
static void add_varied_shape(Scene *scene, size_t i) {
    uint64_t seed = i + 1, *state = &seed;
    Vec3d at = point_in_scene(state), corner = corner_in_scene(state);
    SphereParameters sphere = {at, random_float(state, 0.05, 0.4)}, unit = {{0, 0, 0}, 1};
    BoxParameters box = {corner, vec3d_add(corner, (Vec3d){0.25, 0.5, 0.125})};
    QuadParameters sheets[] = {{corner, {0.5, 0, 0}, {0, 0.5, 0}},
                               {corner, {0, 0.5, 0.25}, {0.25, 0, 0.5}}};
    CylinderParameters disk_or_tube = {at, vec3d_add(at, corner), 0.125, i % 3};
    TriangleParameters face = {.corners = {at, corner, point_in_scene(state)}};
    struct {
        Vec3d center, normal; /**< Disk parameters in the layout of the scene language. */
        double radius;        /**< Radius. */
    } disk = {at, {0, i % 2 ? 1 : 0, 1}, 0.3};
    PlaneParameters ground = {{0, -1.75, 0}, {0, 1, 0}};
    const char *const names[] = {"sphere", "box", "quad", "disk", "cylinder", "triangle", "sphere"};
    const void *const parameters[] = {&sphere, &box, &sheets[i % 16 / 8], &disk, &disk_or_tube,
                                      &face,   &unit};
    if (i == 0) {
        add_shape(scene, "plane", &ground);
    } else if (i % 8 == 7) {
        add_sphere_mesh(scene, i, state);
    } else {
        add_shape(scene, names[i % 8], parameters[i % 8]);
    }
    if (i % 8 == 6) {
        transform_last_shape(scene, state);
    }
}

/**
 * Adds a rectangle in the same plane as all others, as a quad or a mesh: they overlap at equal
 * distances.
 * @param i Its index; determines the rectangle.
 */
static void add_coplanar_rectangle(Scene *scene, size_t i) {
    uint64_t state = i + 1;
    Vec3d corner = {random_face_coordinate(&state), 0, random_face_coordinate(&state)};
    Vec3d u = {0.25 + 2 * random_unit_double(&state), 0, 0},
          v = {0, 0, 0.25 + 2 * random_unit_double(&state)};
    QuadParameters sheet = {corner, point_as_float(u), point_as_float(v)};
    if (i % 2) {
        add_shape(scene, "quad", &sheet);
        return;
    }
    TriangleSoup grid = grid_triangles(1, 0, 2 + i % 5);
    for (size_t k = 0; k < grid.position_count; k++) {
        grid.positions[k] =
            point_as_float(vec3d_add(corner, vec3d_scale(grid.positions[k], u.x / 2)));
    }
    add_triangle_soup(scene, &grid, 2);
    triangle_soup_destroy(&grid);
}

/** @return A scene with each shape or triangle as a separate shape, to be destroyed. */
static Scene *separate_scene(const ThingSet *things) {
    Scene *scene = create_empty_scene();
    for (size_t i = 0; i < things->count; i++) {
        if (things->mesh) {
            const Vec3d corners[3] = {triangle_soup_vertex(things->mesh, i, 0),
                                      triangle_soup_vertex(things->mesh, i, 1),
                                      triangle_soup_vertex(things->mesh, i, 2)};
            const MeshTriangle alone = {{0, 1, 2}};
            add_mesh(scene, corners, 3, &alone, 1, 2);
        } else {
            things->add(scene, i);
        }
    }
    return scene;
}

/** @return The scene for the BVH, to be destroyed: triangles are one mesh. */
static Scene *combined_scene(const ThingSet *things) {
    if (!things->mesh) {
        return separate_scene(things);
    }
    Scene *scene = create_empty_scene();
    add_triangle_soup(scene, things->mesh, 2);
    return scene;
}

/**
 * Tests every shape.
 * @param engine  An engine of one lane.
 * @param tracer  The separate shapes, without a BVH.
 * @param[out] answers  The expected results.
 */
static void query_each_shape(const Engine *engine, const Tracer *tracer, const ThingSet *things,
                             int count, const RayQueryQuad *rays, RayResult *answers) {
    engine->intersect(tracer, (size_t)count, rays, answers);
    for (int i = 0; i < count; i++) {
        assert_true(answers[i].occluded == (answers[i].shape >= 0));
        if (things->mesh && answers[i].shape >= 0) {
            answers[i].shape = 0;
        }
    }
}

/**
 * Compares every engine of a number type with a brute-force test of all shapes.
 * @param reference  The engine of one lane.
 * @param batches  Batches of rays per distribution, in float.
 */
static void compare_bvh_with_list(const Engine *reference, const ThingSet *things, int batches) {
    Scene *together = combined_scene(things), *apart = separate_scene(things);
    Tracer *tracers[ENGINES_MAXIMUM];
    Tracer *list = create_tracer_with_bvh(reference, apart, BVH_NEVER);
    create_tracers(reference, together, tracers);
    RayQueryQuad *rays = calloc(BATCH, sizeof *rays);
    RayResult *wanted = calloc(BATCH, sizeof *wanted);
    assert_true(rays && wanted);
    uint64_t state = 1;
    int count = batch_size(reference);
    long hits = 0;
    for (int n = 0; n < batch_count(reference, batches) * RAY_KINDS; n++) {
        RayKind kind = (RayKind)(n % RAY_KINDS);
        char what[128];
        snprintf(what, sizeof what, "%s, %s", things->name, ray_kinds[kind]);
        fill_rays(kind, &state, rays, count, reference, list);
        query_each_shape(reference, list, things, count, rays, wanted);
        for (int i = 0; i < count; i++) {
            hits += wanted[i].shape >= 0;
        }
        assert_engines_agree(reference, what, tracers, count, rays, wanted);
    }
    // A test without hits would prove nothing.
    assert_true(hits > (long)count * RAY_KINDS / 8);
    reference->destroy(list);
    destroy_tracers(tracers);
    scene_destroy(together);
    scene_destroy(apart);
    free(rays);
    free(wanted);
}

/**
 * Shapes of all kinds, with transformed ones and meshes: the BVH against a list.
 * @param reference  The engine of one lane.
 */
static void check_shapes(const Engine *reference) {
    const ThingSet things = {"many shapes", 66, NULL, add_varied_shape};
    compare_bvh_with_list(reference, &things, 10);
}

/**
 * Many shapes in one plane: at equal distances the first shape is hit, whatever the order of
 * traversal.
 * @param reference  The engine of one lane.
 */
static void check_coplanar(const Engine *reference) {
    const ThingSet things = {"a plane of shapes", 66, NULL, add_coplanar_rectangle};
    compare_bvh_with_list(reference, &things, 3);
}

/**
 * @return Mixed triangles: loose ones, a sphere and flat grids; to be destroyed.
 * @param loose  Number of loose triangles.
 */
static TriangleSoup mixed_triangles(size_t loose) {
    uint64_t state = 3;
    TriangleSoup parts[] = {triangle_soup_create(loose), icosphere_triangles(0),
                            grid_triangles(0, 0.5, 2), grid_triangles(1, -1, 2),
                            grid_triangles(2, 0, 2)};
    size_t count = 0;
    for (size_t i = 0; i < 3 * loose; i++) {
        Vec3d near = point_in_scene(&state);
        Vec3d first = parts[0].positions[i - i % 3];
        parts[0].positions[i] =
            i % 3 ? point_as_float(vec3d_add(first, vec3d_scale(near, 0.25))) : near;
    }
    for (size_t n = 0; n < sizeof parts / sizeof *parts; n++) {
        count += parts[n].triangle_count;
    }
    TriangleSoup all = triangle_soup_create(count);
    Vec3d *next = all.positions;
    for (size_t n = 0; n < sizeof parts / sizeof *parts; n++) {
        for (size_t i = 0; i < 3 * parts[n].triangle_count; i++) {
            *next++ = triangle_soup_vertex(&parts[n], i / 3, i % 3);
        }
        triangle_soup_destroy(&parts[n]);
    }
    return all;
}

/**
 * Small and large meshes: the mesh against its separate triangles.
 * @param reference  The engine of one lane.
 */
static void check_meshes(const Engine *reference) {
    TriangleSoup few = mixed_triangles(2), many = mixed_triangles(140);
    const ThingSet worlds[] = {{"a small mesh", few.triangle_count, &few, NULL},
                               {"a mesh", many.triangle_count, &many, NULL}};
    compare_bvh_with_list(reference, &worlds[0], 8);
    compare_bvh_with_list(reference, &worlds[1], 1);
    triangle_soup_destroy(&few);
    triangle_soup_destroy(&many);
}

/* --- coincident surfaces ---------------------------------------------------------------------- */

/**
 * Tests scenes of coincident surfaces: all engines agree, and the first shape is hit.
 * @param reference  The engine of one lane.
 */
static void check_ties(const Engine *reference, const char *what, const Scene *scene) {
    Tracer *tracers[ENGINES_MAXIMUM];
    create_tracers(reference, scene, tracers);
    size_t one = 0;
    while (engine_list()[one] != reference) {
        one++;
    }
    RayQueryQuad *rays = calloc(BATCH, sizeof *rays);
    RayResult *wanted = calloc(BATCH, sizeof *wanted);
    assert_true(rays && wanted);
    uint64_t state = 5;
    int count = batch_size(reference), met = 0;
    for (int n = 0; n < batch_count(reference, 1) * RAY_KINDS; n++) {
        RayKind kind = (RayKind)(n % RAY_KINDS);
        fill_rays(kind, &state, rays, count, reference, tracers[one]);
        reference->intersect(tracers[one], (size_t)count, rays, wanted);
        for (int i = 0; i < count; i++) {
            // From far away, the silhouettes of different triangulations differ by rounding.
            assert_true(wanted[i].shape <= 0 || kind == RAYS_FAR);
            assert_true(wanted[i].occluded == (wanted[i].shape >= 0));
            met += wanted[i].shape == 0;
        }
        assert_engines_agree(reference, what, tracers, count, rays, wanted);
    }
    assert_true(met > count / 8);
    destroy_tracers(tracers);
    free(rays);
    free(wanted);
}

/**
 * Three flat grids in one plane, of 4, 8 and 16 cells per side. Distances are equal, boxes are not
 * (research/bvh.md, pitfalls).
 * @param reference  The engine of one lane.
 */
static void check_coplanar_grids(const Engine *reference) {
    for (int axis = 0; axis < 3; axis++) {
        Scene *scene = create_empty_scene();
        for (size_t cells = 4; cells <= 16; cells *= 2) {
            TriangleSoup grid = grid_triangles(axis, axis == 1 ? round_to_float(0.3) : 0, cells);
            add_triangle_soup(scene, &grid, 2);
            triangle_soup_destroy(&grid);
        }
        check_ties(reference, "three grids in a plane", scene);
        scene_destroy(scene);
    }
}

/**
 * Each surface three times: as meshes, and as so many that they get a BVH.
 * @param reference  The engine of one lane.
 */
static void check_repeated_meshes(const Engine *reference) {
    TriangleSoup sphere_soup = icosphere_triangles(2);
    for (int times = 3; times <= 24; times += 21) {
        Scene *scene = create_empty_scene();
        for (int i = 0; i < times; i++) {
            add_triangle_soup(scene, &sphere_soup, 1 + i % 2);
        }
        check_ties(reference, times > 3 ? "many equal meshes" : "three equal meshes", scene);
        scene_destroy(scene);
    }
    triangle_soup_destroy(&sphere_soup);
}

/**
 * @return A grid perpendicular to y, each triangle in both orientations; to be destroyed. The first
 *         of the two faces up where the sum of the cell's indices is even.
 */
static TriangleSoup two_sided_grid_triangles(size_t cells) {
    TriangleSoup once = grid_triangles(1, 0, cells),
                 twice = triangle_soup_create(2 * once.triangle_count);
    for (size_t i = 0; i < once.triangle_count; i++) {
        size_t cell = i / 2, far = twice.triangle_count - 1 - i;
        bool is_up = (cell % cells + cell / cells) % 2 == 0;
        for (size_t k = 0; k < 3; k++) {
            // The first vertex is the same, so that the planes are bitwise equal.
            size_t up = k, down = (3 - k) % 3;
            twice.positions[3 * i + (is_up ? up : down)] = triangle_soup_vertex(&once, i, k);
            twice.positions[3 * far + (is_up ? down : up)] = triangle_soup_vertex(&once, i, k);
        }
    }
    triangle_soup_destroy(&once);
    return twice;
}

/** Of coincident triangles within a mesh, the first is hit: its normal shows which. */
static void check_first_triangle(const Engine *engine) {
    enum { CELLS = 16 };
    TriangleSoup grid = two_sided_grid_triangles(CELLS);
    Scene *scene = create_empty_scene();
    add_triangle_soup(scene, &grid, 2);
    Tracer *tracer = create_tracer(engine, scene);
    uint64_t state = 6;
    for (int n = 0; n < 200; n++) {
        RayQueryQuad rays[RAYS_PER_QUERY];
        RayResult answers[RAYS_PER_QUERY];
        fill_coherent(&state, rays, 2 * SCENE_REACH);
        // As one packet, or singly.
        for (int i = 0; i < RAYS_PER_QUERY; i += n % 2 ? 1 : RAYS_PER_QUERY) {
            engine->intersect(tracer, n % 2 ? 1 : RAYS_PER_QUERY, &rays[i], &answers[i]);
        }
        for (int i = 0; i < RAYS_PER_QUERY; i++) {
            double x = CELLS * ((double)answers[i].point[0] + 2) / 4,
                   z = CELLS * ((double)answers[i].point[2] + 2) / 4;
            bool is_on_edge = fabs(x - round(x)) < 1e-3 || fabs(z - round(z)) < 1e-3;
            if (answers[i].shape == 0 && !is_on_edge) {
                bool is_up = ((int)x + (int)z) % 2 == 0;
                assert_true(answers[i].normal[1] == (is_up ? 1 : -1));
            }
        }
    }
    engine->destroy(tracer);
    scene_destroy(scene);
    triangle_soup_destroy(&grid);
}

/* --- closed meshes --------------------------------------------------------------------------- */

/** Tolerance of a normal's length, half ulps. */
#define NORMAL_ERROR 4

/**
 * Checks the length and the side of a normal.
 * @param outwards 1: the ray leaves the mesh; -1: it enters it.
 */
static void assert_normal(const Engine *engine, const RayQueryQuad *ray, const RayResult *answer,
                          int outwards) {
    Quadruple squared = 0, along = 0;
    for (int i = 0; i < 3; i++) {
        squared += answer->normal[i] * answer->normal[i];
        along += answer->normal[i] * ray->direction[i];
    }
    // NaN fails, too.
    assert_at_most(quad_abs(squared - 1) / roundoff(engine), 2 * NORMAL_ERROR,
                   "squared length of a normal in %s, half ulps", engine->name);
    if (!(along * outwards > 0)) {
        fail_msg("a normal in %s is seen from behind: %g", engine->name, (double)along);
    }
}

/**
 * Points a packet from inside a mesh at a vertex of a face and at its edges.
 * @param at_corner Whether all rays go to the vertex.
 */
static void fill_edges(const TriangleSoup *mesh, uint64_t *state, bool at_corner,
                       RayQueryQuad *rays) {
    double middle[3];
    size_t face = (size_t)((double)mesh->triangle_count * random_unit_double(state));
    for (int k = 0; k < 3; k++) {
        middle[k] = random_float(state, -0.9, 0.9);
    }
    for (size_t i = 0; i < RAYS_PER_QUERY; i++) {
        Vec3d from = triangle_soup_vertex(mesh, face, i % 3);
        Vec3d edge = vec3d_subtract(triangle_soup_vertex(mesh, face, (i + 1) % 3), from);
        double fraction = at_corner ? 0 : random_unit_double(state);
        Vec3d eye = {middle[0] + random_float(state, -0.01, 0.01), middle[1], middle[2]};
        rays[i] = ray_towards(eye, vec3d_add(from, vec3d_scale(edge, fraction)));
    }
}

/** @return Number of rays at the edges of one mesh. */
static long edge_rays(const Engine *engine) {
    return (engine->mantissa_bits > 64 ? 4000
            : engine->lanes == 1       ? 50000
                                       : 250000) /
           WORKLOAD_DIVISOR;
}

/**
 * From inside a closed mesh, every ray to its edges and vertices hits it, and normals are valid.
 */
static void check_edges(const Engine *engine, const TriangleSoup *mesh, int normals) {
    Scene *scene = create_empty_scene();
    add_triangle_soup(scene, mesh, normals);
    Tracer *tracer = create_tracer(engine, scene);
    uint64_t state = 7;
    for (int at_corner = 0; at_corner < 2; at_corner++) {
        long leaks = 0;
        for (long done = 0; done < edge_rays(engine); done += RAYS_PER_QUERY) {
            RayQueryQuad rays[RAYS_PER_QUERY];
            RayResult answers[RAYS_PER_QUERY];
            fill_edges(mesh, &state, at_corner, rays);
            engine->intersect(tracer, RAYS_PER_QUERY, rays, answers);
            for (int i = 0; i < RAYS_PER_QUERY; i++) {
                leaks += answers[i].shape != 0 || !answers[i].occluded;
            }
            assert_normal(engine, &rays[0], &answers[0], 1);
        }
        assert_at_most(leaks, 0, "leaks at %s of %zu triangles in %s of %ld",
                       at_corner ? "corners" : "edges", mesh->triangle_count, engine->name,
                       edge_rays(engine));
    }
    engine->destroy(tracer);
    scene_destroy(scene);
}

/** Meshes of 1,280 and 20,480 triangles, flat and smooth. */
static void check_closed_meshes(const Engine *engine) {
    for (int times = 3; times <= 5; times += 2) {
        TriangleSoup mesh = icosphere_triangles(times);
        check_edges(engine, &mesh, 1);
        check_edges(engine, &mesh, 2);
        triangle_soup_destroy(&mesh);
    }
}

/**
 * Rays that hit a smooth mesh near its silhouette: no interpolated normal points away from the
 * viewer, although some vertex normals do.
 */
static void check_outline_normals(const Engine *engine) {
    TriangleSoup mesh = icosphere_triangles(1);
    Scene *scene = create_empty_scene();
    add_triangle_soup(scene, &mesh, 1);
    Tracer *tracer = create_tracer(engine, scene);
    uint64_t state = 8;
    int met = 0;
    for (int n = 0; n < (engine->mantissa_bits > 64 ? 2000 : 20000); n++) {
        double angle = 2 * M_PI * random_unit_double(&state);
        double lateral = ICOSPHERE_RADIUS * (0.8 + 0.2 * random_unit_double(&state));
        RayQueryQuad ray = {
            {round_to_float(lateral * cos(angle)), round_to_float(lateral * sin(angle)), -4},
            {random_float(&state, -0.02, 0.02), random_float(&state, -0.02, 0.02), 1}};
        RayResult answer;
        engine->intersect(tracer, 1, &ray, &answer);
        if (answer.shape == 0) {
            met++;
            assert_normal(engine, &ray, &answer, -1);
        }
    }
    assert_true(met > 500);
    engine->destroy(tracer);
    scene_destroy(scene);
    triangle_soup_destroy(&mesh);
}

/* --- shadows, bounding boxes, instances ------------------------------------------------------- */

/** Pixels per side of the pictures. */
enum { SIDE = 48 };

/**
 * Traces a picture of a scene.
 * @param bvh_use  Whether its shapes get a BVH.
 * @return The number of rays.
 */
static RayCounts draw_scene(const Engine *engine, const Scene *scene, BvhMode bvh_use,
                            double rgb[3 * SIDE * SIDE]) {
    PixelGrid grid = {.columns = SIDE, .rows = SIDE, .stride = 1};
    RayCounts counts = {0};
    Tracer *tracer = create_tracer_with_bvh(engine, scene, bvh_use);
    engine->set_view(tracer, scene, SIDE, SIDE);
    engine->trace(tracer, &grid, rgb, &counts);
    engine->destroy(tracer);
    return counts;
}

/** Adds a point light. */
static void add_point_light(Scene *scene, Vec3d position) {
    Error error = {0};
    SceneLight light = *(const SceneLight *)scene_light_keyword.defaults;
    light.position = position;
    assert_true(scene_add_light(scene, &light, &error));
}

/** @return Reflective shapes with two lights among them; to be destroyed. */
static Scene *lit_scene(void) {
    Error error = {0};
    Scene *scene = create_empty_scene();
    SceneMaterial mirror = *(const SceneMaterial *)scene_material_keyword.defaults;
    mirror.reflectivity = (Rgbd){0.5, 0.25, 0.125};
    assert_true(scene_add_material(scene, &mirror, &error));
    scene->camera.position = (Vec3d){0, 0, 5};
    for (size_t i = 0; i < 30; i++) {
        add_varied_shape(scene, i);
    }
    add_point_light(scene, (Vec3d){0.3, 0.6, 0.2});
    add_point_light(scene, (Vec3d){-3, 4, 2});
    return scene;
}

/**
 * A picture with reflections and shadows is bitwise equal with a BVH and without. This covers
 * shadow rays, which end at a light.
 */
static void check_same_pictures(const Engine *engine) {
    Scene *scene = lit_scene();
    static double list[3 * SIDE * SIDE], tree[3 * SIDE * SIDE];
    RayCounts a = draw_scene(engine, scene, BVH_NEVER, list);
    RayCounts b = draw_scene(engine, scene, BVH_ALWAYS, tree);
    assert_memory_equal(list, tree, sizeof list);
    assert_memory_equal(&a, &b, sizeof a);
    assert_true(a.reflection > 0 && a.shadow > 0);
    scene_destroy(scene);
}

/** Inside a closed, transformed mesh, a light inside lights everything, and one outside nothing. */
static void check_shadow_distance(const Engine *engine) {
    Error error = {0};
    static double rgb[3 * SIDE * SIDE];
    TriangleSoup mesh = icosphere_triangles(2);
    for (int n = 0; n < 4; n++) {
        Scene *scene = create_empty_scene();
        SceneMaterial bright = *(const SceneMaterial *)scene_material_keyword.defaults;
        bright.ambient = 0;
        bright.emission = (Rgbd){0, 0, 0};
        assert_true(scene_add_material(scene, &bright, &error));
        Transform how = {{1.5, 2, 1}, {30, 40, 50}, {0.25, 0.125, 0}, {{0}}};
        assert_true(transform_keyword.finish(&how, 0, &error));
        add_triangle_soup(scene, &mesh, 2);
        assert_true(n < 2 || scene_set_last_transform(scene, &how, &error));
        add_point_light(scene, n % 2 ? (Vec3d){0, 0, 9} : (Vec3d){0.5, 0.25, 1.25});
        draw_scene(engine, scene, BVH_AUTO, rgb);
        for (int i = 0; i < SIDE * SIDE; i++) {
            assert_true(n % 2 ? rgb[i] == 0 : rgb[i] > 0);
        }
        scene_destroy(scene);
    }
    triangle_soup_destroy(&mesh);
}

/** The bounding box of all shapes contains all hits, and is not larger than necessary. */
static void check_bounds(const Engine *engine) {
    TriangleSoup sphere_soup = icosphere_triangles(2);
    for (int many = 0; many < 2; many++) {
        Scene *scene = create_empty_scene();
        Error error = {0};
        Transform how = {{1, 2, 0.5}, {0, 0, 0}, {10, 20, 30}, {{0}}};
        assert_true(transform_keyword.finish(&how, 0, &error));
        add_triangle_soup(scene, &sphere_soup, 2);
        assert_true(scene_set_last_transform(scene, &how, &error));
        for (int i = 0; i < (many ? 300 : 1); i++) {
            SphereParameters small = {{9, 19, 30}, 0.5};
            add_shape(scene, "sphere", &small);
        }
        Tracer *tracer = create_tracer(engine, scene);
        Vec3d low, high;
        engine->bounds(tracer, &low, &high);
        const double got[] = {low.x, low.y, low.z, high.x, high.y, high.z};
        double wanted[] = {8, 16, 29, 12, 24, 31}, room = 1e-4;
        for (size_t i = 0; i < sphere_soup.position_count; i++) {
            // The mesh is slightly smaller than its circumscribed sphere.
            wanted[0] = fmin(i == 0 ? 99 : wanted[0], sphere_soup.positions[i].x + 10);
            wanted[3] = fmax(i == 0 ? -99 : wanted[3], sphere_soup.positions[i].x + 10);
            wanted[1] = fmin(i == 0 ? 99 : wanted[1], 2 * sphere_soup.positions[i].y + 20);
            wanted[4] = fmax(i == 0 ? -99 : wanted[4], 2 * sphere_soup.positions[i].y + 20);
            wanted[2] = fmin(i == 0 ? 99 : wanted[2], 0.5 * sphere_soup.positions[i].z + 30);
            wanted[5] = fmax(i == 0 ? -99 : wanted[5], 0.5 * sphere_soup.positions[i].z + 30);
        }
        for (int i = 0; i < 6; i++) {
            assert_at_most(i < 3 ? got[i] - wanted[i] : wanted[i] - got[i], 0, "box in %s",
                           engine->name);
            assert_at_most(fabs(got[i] - wanted[i]), room, "box in %s", engine->name);
        }
        engine->destroy(tracer);
        scene_destroy(scene);
    }
    triangle_soup_destroy(&sphere_soup);
}

/**
 * Two shapes of the same mesh file, one of them scaled and moved: hits equal those of explicitly
 * transformed triangles.
 */
static void check_instances(const Engine *engine) {
    Error error = {0};
    TriangleSoup sphere_soup = icosphere_triangles(2);
    Scene *shared = create_empty_scene(), *apart = create_empty_scene();
    MeshShapeParameters row = {0, 2};
    Transform how = {{2, 2, 2}, {0, 0, 0}, {5, 0, 0}, {{0}}};
    assert_true(transform_keyword.finish(&how, 0, &error));
    add_triangle_soup(shared, &sphere_soup, 2);
    add_shape(shared, "mesh", &row);
    assert_true(scene_set_last_transform(shared, &how, &error));
    add_triangle_soup(apart, &sphere_soup, 2);
    for (size_t i = 0; i < sphere_soup.position_count; i++) {
        sphere_soup.positions[i] =
            vec3d_add(vec3d_scale(sphere_soup.positions[i], 2), (Vec3d){5, 0, 0});
    }
    add_triangle_soup(apart, &sphere_soup, 2);
    Tracer *tracers[] = {create_tracer(engine, shared), create_tracer(engine, apart)};
    uint64_t state = 11;
    RayQueryQuad rays[RAYS_PER_QUERY];
    RayResult answers[2][RAYS_PER_QUERY];
    int second = 0;
    for (int n = 0; n < 50; n++) {
        fill_coherent(&state, rays, 4 * SCENE_REACH);
        for (int i = 0; i < 2; i++) {
            engine->intersect(tracers[i], RAYS_PER_QUERY, rays, answers[i]);
        }
        for (int i = 0; i < RAYS_PER_QUERY; i++) {
            assert_int_equal(answers[0][i].shape, answers[1][i].shape);
            second += answers[0][i].shape == 1;
            if (answers[0][i].shape >= 0) {
                assert_at_most(quad_abs(answers[0][i].distance - answers[1][i].distance), 1e-5,
                               "instance in %s", engine->name);
            }
        }
    }
    assert_true(second > 50);
    engine->destroy(tracers[0]);
    engine->destroy(tracers[1]);
    scene_destroy(shared);
    scene_destroy(apart);
    triangle_soup_destroy(&sphere_soup);
}

/* --- test cases ------------------------------------------------------------------------------- */

/** See #check_shapes. */
static void test_shapes(void **state) {
    (void)state;
    for_every_type(check_shapes);
}

/** See #check_meshes. */
static void test_meshes(void **state) {
    (void)state;
    for_every_type(check_meshes);
}

/** See #check_coplanar_grids. */
static void test_ties(void **state) {
    (void)state;
    for_every_type(check_coplanar);
    for_every_type(check_coplanar_grids);
    for_every_type(check_repeated_meshes);
}

/** See #check_first_triangle. */
static void test_first_triangle(void **state) {
    (void)state;
    for_every_engine(check_first_triangle);
}

/** See #check_closed_meshes. */
static void test_closed_meshes(void **state) {
    (void)state;
    for_every_engine(check_closed_meshes);
}

/** See #check_outline_normals. */
static void test_outline(void **state) {
    (void)state;
    for_every_engine(check_outline_normals);
}

/** See #check_same_pictures. */
static void test_shadows(void **state) {
    (void)state;
    for_every_engine(check_same_pictures);
    for_every_engine(check_shadow_distance);
}

/** See #check_bounds. */
static void test_bounds(void **state) {
    (void)state;
    for_every_engine(check_bounds);
}

/** See #check_instances. */
static void test_instances(void **state) {
    (void)state;
    for_every_engine(check_instances);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shapes),        cmocka_unit_test(test_meshes),
        cmocka_unit_test(test_ties),          cmocka_unit_test(test_first_triangle),
        cmocka_unit_test(test_closed_meshes), cmocka_unit_test(test_outline),
        cmocka_unit_test(test_shadows),       cmocka_unit_test(test_bounds),
        cmocka_unit_test(test_instances),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
