/**
 * @file
 * @brief The tree changes the time and not one bit of the answer.
 *
 * Scenes with a tree are compared, bit by bit, with lists of the same things so short that they
 * have none: a one-lane engine asks each shape of such a list itself. Packets, single rays and
 * every width must agree; ties, bad triangles and closed meshes have answers that are known.
 */
#include "triangles.h"

#include "render/workers.h"

/** Shapes of the longest list without a tree. */
enum { LIST_SHAPES = 23 };
/** Rays of a packet, in any engine at most. */
enum { TOGETHER = 64 };

#if defined(__SANITIZE_ADDRESS__)
/** A sanitizer makes everything about ten times as slow: so many fewer rays. */
enum { SLOWNESS = 10 };
#else
/** See above. */
enum { SLOWNESS = 1 };
#endif

/* --- answers --------------------------------------------------------------------------------- */

/** @return Whether two numbers are the same bits; NaN is not. @param a One. @param b The other. */
static bool is_same(Quadruple a, Quadruple b) {
    return a == b && signbit((double)a) == signbit((double)b);
}

/** @return Whether two answers are the same bits. @param a One. @param b The other. */
static bool answer_is_same(const RayAnswer *a, const RayAnswer *b) {
    bool same =
        a->shape == b->shape && a->blocked == b->blocked && is_same(a->distance, b->distance);
    for (int i = 0; i < 3; i++) {
        same = same && is_same(a->point[i], b->point[i]) && is_same(a->normal[i], b->normal[i]);
    }
    return same;
}

/** Fails unless answers are the same bits. @param engine Who was asked. @param what What.
 *  @param count How many. @param got What it said. @param wanted What it should say. */
static void assert_same(const Engine *engine, const char *what, int count, const RayAnswer *got,
                        const RayAnswer *wanted) {
    int different = 0, first = -1;
    for (int i = 0; i < count; i++) {
        if (!answer_is_same(&got[i], &wanted[i])) {
            first = first < 0 ? i : first;
            different++;
        }
    }
    if (different > 0) {
        fail_msg("%s in %s: %d of %d rays differ; ray %d: shape %d at %.17g, wanted %d at %.17g",
                 what, engine->name, different, count, first, got[first].shape,
                 (double)got[first].distance, wanted[first].shape, (double)wanted[first].distance);
    }
}

/** A test of one number type. @param reference The engine of one lane. */
typedef void (*TypeTest)(const Engine *reference);

/** Runs a test for every number type. @param test The test. */
static void for_every_type(TypeTest test) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if ((*engine)->lanes == 1) {
            test(*engine);
        }
    }
}

/** @return Whether an engine has the same numbers as another, and this machine can run it.
 *  @param engine It. @param reference The other. */
static bool is_of_type(const Engine *engine, const Engine *reference) {
    return engine->mantissa_bits == reference->mantissa_bits && engine_is_supported(engine);
}

/** @return Batches to ask, at least one. @param reference Whose number type: double takes half as
 *  many, quad two hundredths. @param count For float. */
static int batches_of(const Engine *reference, int count) {
    int slowness = reference->mantissa_bits > 64   ? 200
                   : reference->mantissa_bits > 24 ? 2 * SLOWNESS
                                                   : SLOWNESS;
    return count > slowness ? count / slowness : 1;
}

/** @return Rays of a batch. @param reference Whose number type. */
static int batch_of(const Engine *reference) {
    return reference->mantissa_bits > 64 ? BATCH / 32 : BATCH;
}

/**
 * Asks a scene in every engine of a number type, rays together and a few of them one by one.
 * @param reference  The engine of one lane.
 * @param what       What is asked, for the message.
 * @param tracers    One for each engine of #engine_list.
 * @param count      How many rays.
 * @param rays       The rays.
 * @param wanted     What all must say.
 */
static void assert_all_say(const Engine *reference, const char *what, Tracer *const *tracers,
                           int count, const RayQuery *rays, const RayAnswer *wanted) {
    /** Rays that are asked one by one: a packet for one ray is as long as for all. */
    enum { SINGLE = 512 };
    RayAnswer *answers = calloc((size_t)count, sizeof *answers);
    assert_non_null(answers);
    for (size_t e = 0; engine_list()[e]; e++) {
        const Engine *engine = engine_list()[e];
        if (!is_of_type(engine, reference)) {
            continue;
        }
        engine->intersect(tracers[e], (size_t)count, rays, answers);
        assert_same(engine, what, count, answers, wanted);
        int few = count < SINGLE ? count : SINGLE;
        for (int i = 0; i < few && engine->lanes > 1; i++) {
            engine->intersect(tracers[e], 1, &rays[i], &answers[i]);
        }
        assert_same(engine, what, few, answers, wanted);
    }
    free(answers);
}

/** Engines at most, with the NULL. */
enum { ENGINES_MOST = 16 };

/** Prepares a scene in every engine of a number type. @param reference The engine of one lane.
 *  @param scene The scene. @param[out] tracers One for each of #engine_list, or NULL. */
static void prepare_all(const Engine *reference, const Scene *scene,
                        Tracer *tracers[ENGINES_MOST]) {
    memset(tracers, 0, ENGINES_MOST * sizeof *tracers);
    for (size_t e = 0; engine_list()[e]; e++) {
        assert_true(e < ENGINES_MOST);
        if (is_of_type(engine_list()[e], reference)) {
            tracers[e] = prepare(engine_list()[e], scene);
        }
    }
}

/** Gives tracers back. @param tracers See #prepare_all. */
static void release_all(Tracer *tracers[ENGINES_MOST]) {
    for (size_t e = 0; engine_list()[e]; e++) {
        engine_list()[e]->release(tracers[e]);
    }
}

/* --- rays ------------------------------------------------------------------------------------ */

/** Ways in which rays go. */
typedef enum {
    RAYS_COHERENT, /**< Packets from one point to neighbouring ones. */
    RAYS_RANDOM,   /**< From anywhere to anywhere. */
    RAYS_AXIS,     /**< Along an axis, both other components 0 or -0. */
    RAYS_IN_PLANE, /**< In a plane across an axis, on which faces lie. */
    RAYS_FAR,      /**< From 1e2 and 1e3 away. */
    RAYS_SURFACE,  /**< From where other rays meet something. */
    RAY_KINDS      /**< How many. */
} RayKind;

/** Names of the kinds. */
static const char *const ray_kinds[] = {"coherent rays",  "random rays",    "rays along an axis",
                                        "rays in a face", "rays from afar", "rays from a surface"};

/** Half the side of the box that all test scenes lie in. */
#define SCENE_REACH 2

/** Fills three numbers. @param[in,out] state A generator. @param reach The largest. @param[out] v
 *  The numbers. */
static void random_point(uint64_t *state, double reach, Quadruple v[3]) {
    for (int i = 0; i < 3; i++) {
        v[i] = random_float(state, -reach, reach);
    }
}

/** @return A coordinate on which faces of the test scenes lie. @param[in,out] state A generator. */
static double random_level(uint64_t *state) {
    return floor(random_share(state) * 33 - 16) / 8;
}

/** Aims a ray. @param[in,out] ray The ray, its start set. @param target Where to. @param[in,out]
 * state A generator. @param spread How far beside the target at most. */
static void aim(RayQuery *ray, const Quadruple target[3], uint64_t *state, double spread) {
    for (int i = 0; i < 3; i++) {
        ray->direction[i] =
            as_float((double)(target[i] - ray->origin[i]) + random_float(state, -spread, spread));
    }
}

/** Makes rays of one packet, from one point to neighbouring ones. @param[in,out] state A generator.
 *  @param[out] rays The rays. @param away How far away they start. */
static void fill_coherent(uint64_t *state, RayQuery *rays, double away) {
    Quadruple eye[3], target[3];
    random_point(state, away, eye);
    random_point(state, SCENE_REACH, target);
    double spread = 0.5 * random_share(state);
    for (int i = 0; i < TOGETHER; i++) {
        memcpy(rays[i].origin, eye, sizeof eye);
        aim(&rays[i], target, state, spread);
    }
}

/** Makes rays along an axis, all the same way or not. @param[in,out] state A generator.
 *  @param[out] rays The rays. */
static void fill_axis(uint64_t *state, RayQuery *rays) {
    bool is_coherent = random_share(state) < 0.5;
    int ways = (int)(24 * random_share(state));
    for (int i = 0; i < TOGETHER; i++) {
        int way = is_coherent ? ways : (int)(24 * random_share(state)), axis = way / 8;
        random_point(state, SCENE_REACH, rays[i].origin);
        for (int k = 0; k < 3; k++) {
            double sign = way >> k & 1 ? -1 : 1;
            rays[i].direction[k] = k == axis ? sign * random_float(state, 0.5, 2) : sign * 0.0;
            if (k == axis) {
                rays[i].origin[k] = -sign * random_float(state, -1, 4);
            } else if (random_share(state) < 0.5) {
                rays[i].origin[k] = random_level(state);
            }
        }
    }
}

/** Makes rays that run in a plane in which faces lie. @param[in,out] state A generator.
 *  @param[out] rays The rays. */
static void fill_in_plane(uint64_t *state, RayQuery *rays) {
    int axis = (int)(3 * random_share(state));
    double level = random_level(state);
    fill_coherent(state, rays, 2 * SCENE_REACH);
    for (int i = 0; i < TOGETHER; i++) {
        rays[i].origin[axis] = level;
        rays[i].direction[axis] = random_share(state) < 0.5 ? 0.0 : -0.0;
    }
}

/** Makes rays from points that other rays met. @param[in,out] state A generator. @param[out] rays
 *  The rays. @param engine Who finds the points. @param tracer What they lie on. */
static void fill_surface(uint64_t *state, RayQuery *rays, const Engine *engine,
                         const Tracer *tracer) {
    RayAnswer answers[TOGETHER];
    fill_coherent(state, rays, 2 * SCENE_REACH);
    engine->intersect(tracer, TOGETHER, rays, answers);
    for (int i = 0; i < TOGETHER; i++) {
        for (int k = 0; k < 3 && answers[i].shape >= 0; k++) {
            rays[i].origin[k] = answers[i].point[k];
        }
        random_point(state, 1, rays[i].direction);
    }
}

/** Makes a batch of rays. @param kind How they go. @param[in,out] state A generator. @param[out]
 * rays The rays. @param engine Who finds points on the scene. @param tracer The scene. */
static void rays_fill(RayKind kind, uint64_t *state, RayQuery *rays, const Engine *engine,
                      const Tracer *tracer) {
    for (int i = 0; i < BATCH; i += TOGETHER) {
        if (kind == RAYS_AXIS) {
            fill_axis(state, rays + i);
        } else if (kind == RAYS_IN_PLANE) {
            fill_in_plane(state, rays + i);
        } else if (kind == RAYS_SURFACE) {
            fill_surface(state, rays + i, engine, tracer);
        } else if (kind == RAYS_COHERENT) {
            fill_coherent(state, rays + i, 2 * SCENE_REACH);
        } else {
            for (int k = i; k < i + TOGETHER && kind == RAYS_RANDOM; k++) {
                random_point(state, 2 * SCENE_REACH, rays[k].origin);
                random_point(state, 1, rays[k].direction);
            }
            if (kind == RAYS_FAR) {
                fill_coherent(state, rays + i, i / TOGETHER % 2 ? 1e2 : 1e3);
            }
        }
    }
}

/* --- tree against brute force ---------------------------------------------------------------- */

/** Things that are asked all together, with a tree, and in short lists, without. */
typedef struct World {
    const char *name;      /**< For the messages. */
    size_t count;          /**< How many things. */
    const Triangles *mesh; /**< They are the triangles of this mesh; NULL: shapes. */
} World;

/** @return A point rounded to float. @param v It. */
static Vector3 rounded(Vector3 v) {
    return (Vector3){as_float(v.x), as_float(v.y), as_float(v.z)};
}

/** @return A point of the test scenes. @param[in,out] state A generator. */
static Vector3 point_in_scene(uint64_t *state) {
    return (Vector3){random_float(state, -1.6, 1.6), random_float(state, -1.6, 1.6),
                     random_float(state, -1.6, 1.6)};
}

/** @return A corner on whose coordinates other faces lie, too. @param[in,out] state A generator. */
static Vector3 corner_in_scene(uint64_t *state) {
    return (Vector3){random_level(state), random_level(state), random_level(state)};
}

/** Turns, stretches and moves the newest shape. @param scene The scene. @param[in,out] state A
 *  generator. */
static void turn_newest(Scene *scene, uint64_t *state) {
    Error error = {0};
    Transform how = {{random_float(state, 0.2, 0.6), -random_float(state, 0.2, 0.4), 0.25},
                     {random_float(state, 0, 360), random_float(state, 0, 360), 90},
                     point_in_scene(state),
                     {{0}}};
    assert_true(transform_keyword.finish(&how, 0, &error));
    assert_true(scene_transform_shape(scene, &how, &error));
}

/** Adds a small closed mesh, half of them transformed. @param scene The scene. @param i Its number.
 *  @param[in,out] state A generator. */
static void add_ball_mesh(Scene *scene, size_t i, uint64_t *state) {
    Triangles ball = icosphere(1);
    Vector3 move = point_in_scene(state);
    for (size_t k = 0; k < ball.position_count && i % 16 < 8; k++) {
        ball.positions[k] = rounded(vector3_add(vector3_scale(ball.positions[k], 0.125), move));
    }
    add_triangles(scene, &ball, (int)(i / 16 % 3));
    if (i % 16 >= 8) {
        turn_newest(scene, state);
    }
    triangles_release(&ball);
}

/** Adds one of many different shapes. @param scene The scene. @param i Which; always the same. */
static void add_one_of_many(Scene *scene, size_t i) {
    uint64_t seed = i + 1, *state = &seed;
    Vector3 at = point_in_scene(state), corner = corner_in_scene(state);
    SphereParameters ball = {at, random_float(state, 0.05, 0.4)}, unit = {{0, 0, 0}, 1};
    BoxParameters box = {corner, vector3_add(corner, (Vector3){0.25, 0.5, 0.125})};
    QuadParameters sheets[] = {{corner, {0.5, 0, 0}, {0, 0.5, 0}},
                               {corner, {0, 0.5, 0.25}, {0.25, 0, 0.5}}};
    CylinderParameters disk_or_tube = {at, vector3_add(at, corner), 0.125, i % 3};
    TriangleParameters face = {.corners = {at, corner, point_in_scene(state)}};
    struct {
        Vector3 center, normal; /**< As the scene language says a disk. */
        double radius;          /**< The same. */
    } disk = {at, {0, i % 2 ? 1 : 0, 1}, 0.3};
    PlaneParameters ground = {{0, -1.75, 0}, {0, 1, 0}};
    const char *const names[] = {"sphere", "box", "quad", "disk", "cylinder", "triangle", "sphere"};
    const void *const parameters[] = {&ball, &box, &sheets[i % 16 / 8], &disk, &disk_or_tube,
                                      &face, &unit};
    if (i == 0) {
        add_shape(scene, "plane", &ground);
    } else if (i % 8 == 7) {
        add_ball_mesh(scene, i, state);
    } else {
        add_shape(scene, names[i % 8], parameters[i % 8]);
    }
    if (i % 8 == 6) {
        turn_newest(scene, state);
    }
}

/** @return Some of a world's things as shapes of their own, to be given back. @param world The
 *  world. @param first The first. @param count How many at most. */
static Scene *world_part(const World *world, size_t first, size_t count) {
    Scene *scene = empty_scene();
    for (size_t i = first; i < first + count && i < world->count; i++) {
        if (world->mesh) {
            const Vector3 corners[3] = {triangles_corner(world->mesh, i, 0),
                                        triangles_corner(world->mesh, i, 1),
                                        triangles_corner(world->mesh, i, 2)};
            const MeshTriangle alone = {{0, 1, 2}};
            add_mesh(scene, corners, 3, &alone, 1, 2);
        } else {
            add_one_of_many(scene, i);
        }
    }
    return scene;
}

/** @return All of a world at once, to be given back. @param world The world. */
static Scene *world_whole(const World *world) {
    if (!world->mesh) {
        return world_part(world, 0, world->count);
    }
    Scene *scene = empty_scene();
    add_triangles(scene, world->mesh, 2);
    return scene;
}

/** Short lists. */
typedef struct Lists {
    const Engine *engine;  /**< Who is asked. */
    Tracer *tracers[64];   /**< One a list. */
    size_t count;          /**< How many. */
    bool is_of_triangles;  /**< Whether all things are triangles of the same shape. */
    RayAnswer said[BATCH]; /**< What the list said that was asked last. */
} Lists;

/** @return A world as short lists, to be given back. @param engine Who is asked.
 *  @param world The world. */
static Lists *lists_create(const Engine *engine, const World *world) {
    Lists *lists = calloc(1, sizeof *lists);
    assert_non_null(lists);
    lists->engine = engine;
    lists->is_of_triangles = world->mesh != NULL;
    for (size_t first = 0; first < world->count; first += LIST_SHAPES) {
        Scene *scene = world_part(world, first, LIST_SHAPES);
        assert_true(lists->count < sizeof lists->tracers / sizeof *lists->tracers);
        lists->tracers[lists->count++] = prepare(engine, scene);
        scene_destroy(scene);
    }
    return lists;
}

/** Gives lists back. @param lists The lists. */
static void lists_destroy(Lists *lists) {
    for (size_t i = 0; i < lists->count; i++) {
        lists->engine->release(lists->tracers[i]);
    }
    free(lists);
}

/** Asks one list after the other; of all answers, the nearest counts, of those the first.
 *  @param lists The lists. @param count How many rays. @param rays The rays. @param[out] answers
 *  What all lists say together. */
static void lists_ask(Lists *lists, int count, const RayQuery *rays, RayAnswer *answers) {
    for (size_t n = 0; n < lists->count; n++) {
        RayAnswer *said = n == 0 ? answers : lists->said;
        lists->engine->intersect(lists->tracers[n], (size_t)count, rays, said);
        for (int i = 0; i < count; i++) {
            bool blocked = answers[i].blocked || said[i].blocked;
            if (said[i].shape >= 0) {
                said[i].shape = lists->is_of_triangles ? 0 : said[i].shape + (int)(n * LIST_SHAPES);
            }
            if (said[i].distance < answers[i].distance) {
                answers[i] = said[i];
            }
            answers[i].blocked = blocked;
        }
    }
}

/** Compares a world in every engine of a number type with its lists. @param reference The engine of
 *  one lane. @param world The world. @param batches Batches of rays of each kind, in float. */
static void compare_with_lists(const Engine *reference, const World *world, int batches) {
    Scene *scene = world_whole(world);
    Tracer *tracers[ENGINES_MOST];
    prepare_all(reference, scene, tracers);
    Lists *lists = lists_create(reference, world);
    RayQuery *rays = calloc(BATCH, sizeof *rays);
    RayAnswer *wanted = calloc(BATCH, sizeof *wanted);
    assert_true(rays && wanted);
    uint64_t state = 1;
    int count = batch_of(reference);
    long hits = 0;
    for (int n = 0; n < batches_of(reference, batches) * RAY_KINDS; n++) {
        RayKind kind = (RayKind)(n % RAY_KINDS);
        char what[128];
        snprintf(what, sizeof what, "%s, %s", world->name, ray_kinds[kind]);
        rays_fill(kind, &state, rays, reference, lists->tracers[n % (int)lists->count]);
        lists_ask(lists, count, rays, wanted);
        for (int i = 0; i < count; i++) {
            assert_true(wanted[i].blocked == (wanted[i].shape >= 0));
            hits += wanted[i].shape >= 0;
        }
        assert_all_say(reference, what, tracers, count, rays, wanted);
    }
    // Rays that meet nothing would prove nothing.
    assert_true(hits > (long)count * RAY_KINDS / 8);
    lists_destroy(lists);
    release_all(tracers);
    scene_destroy(scene);
    free(rays);
    free(wanted);
}

/** Shapes of all kinds, transformed ones and meshes among them: the tree against lists without.
 *  @param reference The engine of one lane. */
static void shapes_against_lists(const Engine *reference) {
    const World world = {"many shapes", 3 * LIST_SHAPES - 3, NULL};
    compare_with_lists(reference, &world, 10);
}

/** @return A mesh with everything in it: loose triangles, a ball, flat grids; to be given back.
 *  @param loose How many loose triangles. */
static Triangles mixed_mesh(size_t loose) {
    uint64_t state = 3;
    Triangles parts[] = {triangles_create(loose), icosphere(0), grid_of(0, 0.5, 2),
                         grid_of(1, -1, 2), grid_of(2, 0, 2)};
    size_t count = 0;
    for (size_t i = 0; i < 3 * loose; i++) {
        Vector3 near = point_in_scene(&state);
        Vector3 first = parts[0].positions[i - i % 3];
        parts[0].positions[i] =
            i % 3 ? rounded(vector3_add(first, vector3_scale(near, 0.25))) : near;
    }
    for (size_t n = 0; n < sizeof parts / sizeof *parts; n++) {
        count += parts[n].triangle_count;
    }
    Triangles all = triangles_create(count);
    Vector3 *next = all.positions;
    for (size_t n = 0; n < sizeof parts / sizeof *parts; n++) {
        for (size_t i = 0; i < 3 * parts[n].triangle_count; i++) {
            *next++ = triangles_corner(&parts[n], i / 3, i % 3);
        }
        triangles_release(&parts[n]);
    }
    return all;
}

/** The triangles of meshes, few and many: the mesh against each triangle by itself.
 *  @param reference The engine of one lane. */
static void meshes_against_lists(const Engine *reference) {
    Triangles few = mixed_mesh(2), many = mixed_mesh(140);
    const World worlds[] = {{"a small mesh", few.triangle_count, &few},
                            {"a mesh", many.triangle_count, &many}};
    compare_with_lists(reference, &worlds[0], 8);
    compare_with_lists(reference, &worlds[1], 1);
    triangles_release(&few);
    triangles_release(&many);
}

/* --- ties ------------------------------------------------------------------------------------ */

/** Asks scenes whose surfaces coincide: all engines say the same, and the first shape is met.
 *  @param reference The engine of one lane. @param what For the messages. @param scene The scene.
 */
static void ask_ties(const Engine *reference, const char *what, const Scene *scene) {
    Tracer *tracers[ENGINES_MOST];
    prepare_all(reference, scene, tracers);
    size_t one = 0;
    while (engine_list()[one] != reference) {
        one++;
    }
    RayQuery *rays = calloc(BATCH, sizeof *rays);
    RayAnswer *wanted = calloc(BATCH, sizeof *wanted);
    assert_true(rays && wanted);
    uint64_t state = 5;
    int count = batch_of(reference), met = 0;
    for (int n = 0; n < batches_of(reference, 2) * RAY_KINDS; n++) {
        RayKind kind = (RayKind)(n % RAY_KINDS);
        rays_fill(kind, &state, rays, reference, tracers[one]);
        reference->intersect(tracers[one], (size_t)count, rays, wanted);
        for (int i = 0; i < count; i++) {
            assert_true(wanted[i].shape <= 0);
            assert_true(wanted[i].blocked == (wanted[i].shape >= 0));
            met += wanted[i].shape == 0;
        }
        assert_all_say(reference, what, tracers, count, rays, wanted);
    }
    assert_true(met > count / 8);
    release_all(tracers);
    free(rays);
    free(wanted);
}

/** Three flat grids in one plane, of 4, 8 and 16 cells a side: the distances are equal, the boxes
 *  are not (research/bvh.md, pitfalls). @param reference The engine of one lane. */
static void coplanar_grids(const Engine *reference) {
    for (int axis = 0; axis < 3; axis++) {
        Scene *scene = empty_scene();
        for (size_t cells = 4; cells <= 16; cells *= 2) {
            Triangles grid = grid_of(axis, as_float(0.3), cells);
            add_triangles(scene, &grid, 2);
            triangles_release(&grid);
        }
        ask_ties(reference, "three grids in a plane", scene);
        scene_destroy(scene);
    }
}

/** Everything three times, as meshes and, with a tree over them, as many. @param reference The
 * engine of one lane. */
static void repeated_meshes(const Engine *reference) {
    Triangles ball = icosphere(2);
    for (int times = 3; times <= LIST_SHAPES + 7; times += LIST_SHAPES + 4) {
        Scene *scene = empty_scene();
        for (int i = 0; i < times; i++) {
            add_triangles(scene, &ball, 1 + i % 2);
        }
        ask_ties(reference, times > LIST_SHAPES ? "thirty equal meshes" : "three equal meshes",
                 scene);
        scene_destroy(scene);
    }
    triangles_release(&ball);
}

/** @return A grid across y, each triangle twice, once turned over; to be given back. Of the two,
 * the first faces up where the sum of the cell's places is even. @param cells Cells a side. */
static Triangles two_sided_grid(size_t cells) {
    Triangles once = grid_of(1, 0, cells), twice = triangles_create(2 * once.triangle_count);
    for (size_t i = 0; i < once.triangle_count; i++) {
        size_t cell = i / 2, far = twice.triangle_count - 1 - i;
        bool is_up = (cell % cells + cell / cells) % 2 == 0;
        for (size_t k = 0; k < 3; k++) {
            // The same first corner, so that the planes are the same to the last bit.
            size_t up = k, down = (3 - k) % 3;
            twice.positions[3 * i + (is_up ? up : down)] = triangles_corner(&once, i, k);
            twice.positions[3 * far + (is_up ? down : up)] = triangles_corner(&once, i, k);
        }
    }
    triangles_release(&once);
    return twice;
}

/** Of triangles that coincide within a mesh, the first is met: its normal says which.
 *  @param engine The engine. */
static void first_triangle(const Engine *engine) {
    enum { CELLS = 16 };
    Triangles grid = two_sided_grid(CELLS);
    Scene *scene = empty_scene();
    add_triangles(scene, &grid, 2);
    Tracer *tracer = prepare(engine, scene);
    uint64_t state = 6;
    for (int n = 0; n < 200; n++) {
        RayQuery rays[TOGETHER];
        RayAnswer answers[TOGETHER];
        fill_coherent(&state, rays, 2 * SCENE_REACH);
        // All of a packet at once, or one by one.
        for (int i = 0; i < TOGETHER; i += n % 2 ? 1 : TOGETHER) {
            engine->intersect(tracer, n % 2 ? 1 : TOGETHER, &rays[i], &answers[i]);
        }
        for (int i = 0; i < TOGETHER; i++) {
            double x = CELLS * ((double)answers[i].point[0] + 2) / 4,
                   z = CELLS * ((double)answers[i].point[2] + 2) / 4;
            bool is_on_edge = fabs(x - round(x)) < 1e-3 || fabs(z - round(z)) < 1e-3;
            if (answers[i].shape == 0 && !is_on_edge) {
                bool is_up = ((int)x + (int)z) % 2 == 0;
                assert_true(answers[i].normal[1] == (is_up ? 1 : -1));
            }
        }
    }
    engine->release(tracer);
    scene_destroy(scene);
    triangles_release(&grid);
}

/* --- closed meshes --------------------------------------------------------------------------- */

/** Half ulps that a normal's length may be off. */
#define NORMAL_ERROR 4

/** Checks a normal's length and side. @param engine The engine. @param ray The ray.
 *  @param answer What it met. @param outwards 1: the ray leaves the mesh; -1: it enters it. */
static void assert_normal(const Engine *engine, const RayQuery *ray, const RayAnswer *answer,
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

/** Aims a packet from inside a mesh at the corner of a face and at its edges. @param mesh The mesh.
 *  @param[in,out] state A generator. @param at_corner Whether at the corner alone.
 *  @param[out] rays The rays. */
static void fill_edges(const Triangles *mesh, uint64_t *state, bool at_corner, RayQuery *rays) {
    double middle[3];
    size_t face = (size_t)((double)mesh->triangle_count * random_share(state));
    for (int k = 0; k < 3; k++) {
        middle[k] = random_float(state, -0.9, 0.9);
    }
    for (size_t i = 0; i < TOGETHER; i++) {
        Vector3 from = triangles_corner(mesh, face, i % 3);
        Vector3 edge = vector3_subtract(triangles_corner(mesh, face, (i + 1) % 3), from);
        double share = at_corner ? 0 : random_share(state);
        Vector3 eye = {middle[0] + random_float(state, -0.01, 0.01), middle[1], middle[2]};
        rays[i] = ray_towards(eye, vector3_add(from, vector3_scale(edge, share)));
    }
}

/** @return Rays to aim at the edges of one mesh. @param engine The engine. */
static long edge_rays(const Engine *engine) {
    return (engine->mantissa_bits > 64 ? 4000 : engine->lanes == 1 ? 50000 : 250000) / SLOWNESS;
}

/** From inside a closed mesh, rays aimed at its edges and corners: not one gets out, and normals
 * are good. @param engine The engine. @param mesh The mesh. @param normals See #MeshRow. */
static void ask_edges(const Engine *engine, const Triangles *mesh, int normals) {
    Scene *scene = empty_scene();
    add_triangles(scene, mesh, normals);
    Tracer *tracer = prepare(engine, scene);
    uint64_t state = 7;
    for (int at_corner = 0; at_corner < 2; at_corner++) {
        long leaks = 0;
        for (long done = 0; done < edge_rays(engine); done += TOGETHER) {
            RayQuery rays[TOGETHER];
            RayAnswer answers[TOGETHER];
            fill_edges(mesh, &state, at_corner, rays);
            engine->intersect(tracer, TOGETHER, rays, answers);
            for (int i = 0; i < TOGETHER; i++) {
                leaks += answers[i].shape != 0 || !answers[i].blocked;
            }
            assert_normal(engine, &rays[0], &answers[0], 1);
        }
        assert_at_most(leaks, 0, "leaks at %s of %zu triangles in %s of %ld",
                       at_corner ? "corners" : "edges", mesh->triangle_count, engine->name,
                       edge_rays(engine));
    }
    engine->release(tracer);
    scene_destroy(scene);
}

/** Meshes of 1,280 and 20,480 triangles, flat and smooth. @param engine The engine. */
static void closed_meshes(const Engine *engine) {
    for (int times = 3; times <= 5; times += 2) {
        Triangles mesh = icosphere(times);
        ask_edges(engine, &mesh, 1);
        ask_edges(engine, &mesh, 2);
        triangles_release(&mesh);
    }
}

/** Rays that meet a smooth mesh near its outline: no normal is seen from behind, although some of
 *  those at the corners are. @param engine The engine. */
static void outline(const Engine *engine) {
    Triangles mesh = icosphere(1);
    Scene *scene = empty_scene();
    add_triangles(scene, &mesh, 1);
    Tracer *tracer = prepare(engine, scene);
    uint64_t state = 8;
    int met = 0;
    for (int n = 0; n < (engine->mantissa_bits > 64 ? 2000 : 20000); n++) {
        double angle = 2 * M_PI * random_share(&state);
        double beside = ICOSPHERE_RADIUS * (0.8 + 0.2 * random_share(&state));
        RayQuery ray = {{as_float(beside * cos(angle)), as_float(beside * sin(angle)), -4},
                        {random_float(&state, -0.02, 0.02), random_float(&state, -0.02, 0.02), 1}};
        RayAnswer answer;
        engine->intersect(tracer, 1, &ray, &answer);
        if (answer.shape == 0) {
            met++;
            assert_normal(engine, &ray, &answer, -1);
        }
    }
    assert_true(met > 500);
    engine->release(tracer);
    scene_destroy(scene);
    triangles_release(&mesh);
}

/* --- the builder ----------------------------------------------------------------------------- */

/** Makes the corners of a case. @param[in,out] state A generator. @param i Which triangle.
 *  @param count How many. @param[out] corners Three. */
typedef void (*Layout)(uint64_t *state, size_t i, size_t count, Vector3 *corners);

/** Makes a small triangle somewhere. See #Layout. @param state See there. @param middle Where.
 *  @param size How large. @param corners See there. */
static void triangle_at(uint64_t *state, Vector3 middle, double size, Vector3 *corners) {
    for (int k = 0; k < 3; k++) {
        Vector3 beside = {random_float(state, -1, 1), random_float(state, -1, 1),
                          random_float(state, -1, 1)};
        corners[k] = vector3_add(middle, vector3_scale(beside, size));
    }
}

/** All the same. See #Layout. @param state Not used. @param i Not used. @param count Not used.
 *  @param corners See there. */
static void lay_identical(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    (void)state, (void)i, (void)count;
    corners[0] = (Vector3){0, 0, 1};
    corners[1] = (Vector3){1, 0, 0};
    corners[2] = (Vector3){0, 1, 0};
}

/** One inside the other, the middles of all boxes the same. See #Layout. @param state Not used.
 *  @param i See there. @param count See there. @param corners See there. */
static void lay_nested(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    (void)state;
    double size = (double)(i + 1) / (double)count;
    corners[0] = (Vector3){-size, -size, -size};
    corners[1] = (Vector3){size, size, size};
    corners[2] = (Vector3){size, -size, size};
}

/** Anywhere. See #Layout. @param state See there. @param i Not used. @param count Not used.
 *  @param corners See there. */
static void lay_randomly(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    (void)i, (void)count;
    triangle_at(state, point_in_scene(state), 0.02, corners);
}

/** One huge, the others tiny. See #Layout. @param state See there. @param i See there. @param count
 *  See there. @param corners See there. */
static void lay_one_huge(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    (void)count;
    triangle_at(state, point_in_scene(state), i == 77 ? 1e4 : 1e-3, corners);
}

/** Along a line, in order. See #Layout. @param state See there. @param i See there. @param count
 *  See there. @param corners See there. */
static void lay_along_a_line(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    double along = 4 * (double)i / (double)count - 2;
    triangle_at(state, (Vector3){along, along / 2, -along}, 0.01, corners);
}

/** Anywhere, all of it tiny. See #Layout. @param state See there. @param i Not used. @param count
 *  Not used. @param corners See there. */
static void lay_tiny(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    lay_randomly(state, i, count, corners);
    for (int k = 0; k < 3; k++) {
        corners[k] = vector3_scale(corners[k], 1e-12);
    }
}

/** Anywhere, all of it huge. See #Layout. @param state See there. @param i Not used. @param count
 *  Not used. @param corners See there. */
static void lay_huge(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    lay_randomly(state, i, count, corners);
    for (int k = 0; k < 3; k++) {
        corners[k] = vector3_scale(corners[k], 1e12);
    }
}

/** From the largest number there is to the smallest, by powers of two: bins split off a few
 *  triangles at a time, and binary trees of such become as deep as there are powers. See #Layout.
 *  @param state See there. @param i See there. @param count See there. @param corners See there. */
static void lay_at_powers(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    double size = exp2(48 - 1100 * (double)i / (double)count);
    triangle_at(state, (Vector3){size, 0, 0}, 0.2 * size, corners);
}

/** A flat mesh whose corners are a little off the plane: less than any number that has a finite
 *  inverse. See #Layout. @param state See there. @param i See there. @param count See there.
 *  @param corners See there. */
static void lay_nearly_flat(uint64_t *state, size_t i, size_t count, Vector3 *corners) {
    lay_randomly(state, i, count, corners);
    for (int k = 0; k < 3; k++) {
        corners[k].x = (double)(i % 3) * 1e-41;
    }
}

/** A case of the builder. */
typedef struct BuilderCase {
    const char *name; /**< For messages. */
    Layout lay;       /**< How its triangles lie. */
    size_t count;     /**< How many. */
    int packets;      /**< Packets of rays to ask. */
} BuilderCase;

/** The cases. */
static const BuilderCase builder_cases[] = {
    {"one triangle", lay_randomly, 1, 16},
    {"equal triangles", lay_identical, 10000, 2},
    {"triangles with one middle", lay_nested, 3000, 4},
    {"one huge triangle", lay_one_huge, 5000, 16},
    {"tiny triangles", lay_tiny, 5000, 16},
    {"huge triangles", lay_huge, 5000, 16},
    {"triangles along a line", lay_along_a_line, 20000 / SLOWNESS, 16},
    {"random triangles", lay_randomly, 100000 / SLOWNESS, 16},
    {"triangles at powers of two", lay_at_powers, 100000 / SLOWNESS, 16},
    {"nearly flat triangles", lay_nearly_flat, 2000, 16},
};

/** Does what a crew is asked to. See #Crew.run. @param workers The threads. @param count See there.
 *  @param job See there. @param context See there. */
static void crew_do(void *workers, size_t count, void (*job)(void *, size_t), void *context) {
    workers_run(workers, count, job, context);
}

/** @return A tracer that several threads prepared, to be given back. @param engine The engine.
 *  @param scene The scene. @param threads How many. */
static Tracer *prepare_with(const Engine *engine, const Scene *scene, int threads) {
    Error error = {0};
    Workers *workers = workers_create(threads, &error);
    assert_non_null(workers);
    TraceSettings settings = {
        .depth = 1, .offset = OFFSET_BOUND, .crew = {workers, threads, crew_do}};
    Tracer *tracer = engine->prepare(scene, &settings, &error);
    assert_non_null(tracer);
    workers_destroy(workers);
    return tracer;
}

/** @return The largest coordinate of a triangle. @param corners Its corners. */
static double largest_of(const Vector3 *corners) {
    double largest = 0;
    for (int k = 0; k < 3; k++) {
        largest = fmax(largest, vector3_largest(corners[k]));
    }
    return largest;
}

/** Aims a ray at the middle of a triangle, from about above it. @param corners The triangle.
 *  @param[in,out] state A generator. @param[out] ray The ray. */
static void aim_at_triangle(const Vector3 *corners, uint64_t *state, RayQuery *ray) {
    double size = largest_of(corners);
    Vector3 sides[2], middle = {0, 0, 0};
    for (int k = 0; k < 3; k++) {
        middle = vector3_add(middle, vector3_scale(corners[k], 1.0 / 3));
    }
    for (int k = 0; k < 2; k++) {
        sides[k] = vector3_scale(vector3_subtract(corners[k + 1], corners[0]), 1 / size);
    }
    Vector3 away = vector3_normalize(vector3_cross(sides[0], sides[1]));
    away =
        vector3_add(away, (Vector3){random_float(state, -0.3, 0.3), random_float(state, -0.3, 0.3),
                                    random_float(state, -0.3, 0.3)});
    Vector3 eye = rounded(vector3_add(middle, vector3_scale(away, size)));
    *ray = ray_towards(eye, rounded(middle));
    for (int k = 0; k < 3; k++) {
        ray->direction[k] = as_float((double)ray->direction[k]);
    }
}

/** Fills a packet: the first ray, or all of them, aimed at triangles. @param mesh The triangles.
 *  @param[in,out] state A generator. @param is_coherent Whether the others go beside the first.
 *  @param[out] rays The rays. */
static void fill_aimed(const Triangles *mesh, uint64_t *state, bool is_coherent, RayQuery *rays) {
    for (int i = 0; i < TOGETHER; i++) {
        const Vector3 *corners;
        do {
            size_t which = (size_t)((double)mesh->triangle_count * random_share(state));
            corners = &mesh->positions[3 * which];
            // Products of smaller ones are no floats any more.
        } while (largest_of(corners) < 1e-13);
        if (i == 0 || !is_coherent) {
            aim_at_triangle(corners, state, &rays[i]);
            continue;
        }
        rays[i] = rays[0];
        for (int k = 0; k < 3; k++) {
            rays[i].direction[k] =
                as_float((double)rays[0].direction[k] * random_float(state, 0.9, 1.1));
        }
    }
}

/** Checks a case in all engines of a number type: what is aimed at is met or hidden, and all say
 * the same, whoever built the tree. @param reference The engine of one lane. @param builder The
 * case.
 *  @param mesh Its triangles. @param scene The scene. */
static void ask_case(const Engine *reference, const BuilderCase *builder, const Triangles *mesh,
                     const Scene *scene) {
    Tracer *tracers[ENGINES_MOST], *alone = prepare(reference, scene);
    uint64_t state = 9;
    RayQuery rays[16][TOGETHER];
    RayAnswer wanted[16][TOGETHER];
    for (int n = 0; n < builder->packets; n++) {
        fill_aimed(mesh, &state, n % 2, rays[n]);
        reference->intersect(alone, TOGETHER, rays[n], wanted[n]);
        for (int i = 0; i < (n % 2 ? 1 : TOGETHER); i++) {
            assert_int_equal(wanted[n][i].shape, 0);
            assert_at_most(wanted[n][i].distance, 1 + 1e-4, "%s in %s", builder->name,
                           reference->name);
        }
    }
    reference->release(alone);
    const int threads[] = {1, 2, 7};
    const size_t step = builder->count < 50000 ? 1 : 2;
    for (size_t t = 0; t < sizeof threads / sizeof *threads; t += step) {
        for (size_t e = 0; engine_list()[e]; e++) {
            tracers[e] = is_of_type(engine_list()[e], reference)
                             ? prepare_with(engine_list()[e], scene, threads[t])
                             : NULL;
        }
        assert_all_say(reference, builder->name, tracers, builder->packets * TOGETHER, rays[0],
                       wanted[0]);
        release_all(tracers);
    }
}

/** Triangles that are hard to split. @param reference The engine of one lane. */
static void bad_triangles(const Engine *reference) {
    /** What the reference engine builds in a second. */
    const size_t few = 10000;
    for (size_t n = 0; n < sizeof builder_cases / sizeof *builder_cases; n++) {
        const BuilderCase *builder = &builder_cases[n];
        if (reference->mantissa_bits > 64 && builder->count >= few) {
            continue;
        }
        uint64_t state = 10;
        Triangles mesh = triangles_create(builder->count);
        for (size_t i = 0; i < builder->count; i++) {
            builder->lay(&state, i, builder->count, &mesh.positions[3 * i]);
        }
        Scene *scene = empty_scene();
        add_triangles(scene, &mesh, 2);
        ask_case(reference, builder, &mesh, scene);
        scene_destroy(scene);
        triangles_release(&mesh);
    }
}

/* --- shadows, boxes, instances --------------------------------------------------------------- */

/** Pixels a side of the pictures. */
enum { SIDE = 48 };

/** Draws a scene. @param engine The engine. @param scene The scene. @param[out] rgb Its colours.
 *  @return The rays that it took. */
static RayCounts draw(const Engine *engine, const Scene *scene, double rgb[3 * SIDE * SIDE]) {
    PixelGrid grid = {.columns = SIDE, .rows = SIDE, .stride = 1};
    RayCounts counts = {0};
    Tracer *tracer = prepare(engine, scene);
    engine->look(tracer, scene, SIDE, SIDE);
    engine->trace(tracer, &grid, rgb, &counts);
    engine->release(tracer);
    return counts;
}

/** Adds a lamp. @param scene The scene. @param position Where it is. */
static void add_lamp(Scene *scene, Vector3 position) {
    Error error = {0};
    Light light = *(const Light *)light_keyword.defaults;
    light.position = position;
    assert_true(scene_add_light(scene, &light, &error));
}

/** @return Shapes that mirror, with two lamps among them. @param extras How many spheres that
 *          nobody sees; to be given back. */
static Scene *lit_scene(int extras) {
    Error error = {0};
    Scene *scene = empty_scene();
    Material mirror = *(const Material *)material_keyword.defaults;
    mirror.reflectivity = (Color){0.5, 0.25, 0.125};
    assert_true(scene_add_material(scene, &mirror, &error));
    scene->camera.position = (Vector3){0, 0, 5};
    for (size_t i = 0; i < LIST_SHAPES - 1; i++) {
        add_one_of_many(scene, i);
    }
    for (int i = 0; i < extras; i++) {
        SphereParameters speck = {{i, 300, 700}, 1e-4};
        add_shape(scene, "sphere", &speck);
    }
    add_lamp(scene, (Vector3){0.3, 0.6, 0.2});
    add_lamp(scene, (Vector3){-3, 4, 2});
    return scene;
}

/** A picture with mirrors and shadows is the same, bit by bit, with a tree and without: also for
 *  shadow rays, which end at a lamp. @param engine The engine. */
static void pictures_are_the_same(const Engine *engine) {
    Scene *without = lit_scene(0), *with = lit_scene(20);
    static double list[3 * SIDE * SIDE], tree[3 * SIDE * SIDE];
    RayCounts a = draw(engine, without, list), b = draw(engine, with, tree);
    assert_memory_equal(list, tree, sizeof list);
    assert_memory_equal(&a, &b, sizeof a);
    assert_true(a.mirror > 0 && a.shadow > 0);
    scene_destroy(without);
    scene_destroy(with);
}

/** Inside a closed mesh, transformed, everything is lit by a lamp inside and dark by one outside.
 *  @param engine The engine. */
static void shadows_end_at_the_lamp(const Engine *engine) {
    Error error = {0};
    static double rgb[3 * SIDE * SIDE];
    Triangles mesh = icosphere(2);
    for (int n = 0; n < 4; n++) {
        Scene *scene = empty_scene();
        Material bright = *(const Material *)material_keyword.defaults;
        bright.ambient = 0;
        bright.emission = (Color){0, 0, 0};
        assert_true(scene_add_material(scene, &bright, &error));
        Transform how = {{1.5, 2, 1}, {30, 40, 50}, {0.25, 0.125, 0}, {{0}}};
        assert_true(transform_keyword.finish(&how, 0, &error));
        add_triangles(scene, &mesh, 2);
        assert_true(n < 2 || scene_transform_shape(scene, &how, &error));
        add_lamp(scene, n % 2 ? (Vector3){0, 0, 9} : (Vector3){0.5, 0.25, 1.25});
        draw(engine, scene, rgb);
        for (int i = 0; i < SIDE * SIDE; i++) {
            assert_true(n % 2 ? rgb[i] == 0 : rgb[i] > 0);
        }
        scene_destroy(scene);
    }
    triangles_release(&mesh);
}

/** The box of all shapes holds all that is met, and is no larger than it must be. @param engine The
 * engine. */
static void box_of_all(const Engine *engine) {
    Triangles ball = icosphere(2);
    for (int many = 0; many < 2; many++) {
        Scene *scene = empty_scene();
        Error error = {0};
        Transform how = {{1, 2, 0.5}, {0, 0, 0}, {10, 20, 30}, {{0}}};
        assert_true(transform_keyword.finish(&how, 0, &error));
        add_triangles(scene, &ball, 2);
        assert_true(scene_transform_shape(scene, &how, &error));
        for (int i = 0; i < (many ? 2 * LIST_SHAPES : 1); i++) {
            SphereParameters small = {{9, 19, 30}, 0.5};
            add_shape(scene, "sphere", &small);
        }
        Tracer *tracer = prepare(engine, scene);
        Vector3 low, high;
        engine->bounds(tracer, &low, &high);
        const double got[] = {low.x, low.y, low.z, high.x, high.y, high.z};
        double wanted[] = {8, 16, 29, 12, 24, 31}, room = 1e-4;
        for (size_t i = 0; i < ball.position_count; i++) {
            // The mesh is a little smaller than the sphere around it.
            wanted[0] = fmin(i == 0 ? 99 : wanted[0], ball.positions[i].x + 10);
            wanted[3] = fmax(i == 0 ? -99 : wanted[3], ball.positions[i].x + 10);
            wanted[1] = fmin(i == 0 ? 99 : wanted[1], 2 * ball.positions[i].y + 20);
            wanted[4] = fmax(i == 0 ? -99 : wanted[4], 2 * ball.positions[i].y + 20);
            wanted[2] = fmin(i == 0 ? 99 : wanted[2], 0.5 * ball.positions[i].z + 30);
            wanted[5] = fmax(i == 0 ? -99 : wanted[5], 0.5 * ball.positions[i].z + 30);
        }
        for (int i = 0; i < 6; i++) {
            assert_at_most(i < 3 ? got[i] - wanted[i] : wanted[i] - got[i], 0, "box in %s",
                           engine->name);
            assert_at_most(fabs(got[i] - wanted[i]), room, "box in %s", engine->name);
        }
        engine->release(tracer);
        scene_destroy(scene);
    }
    triangles_release(&ball);
}

/** Two shapes of the same file, one of them twice as large and elsewhere: each is met where the
 * same triangles would be, made so by hand. @param engine The engine. */
static void instances(const Engine *engine) {
    Error error = {0};
    Triangles ball = icosphere(2);
    Scene *shared = empty_scene(), *apart = empty_scene();
    MeshRow row = {0, 2};
    Transform how = {{2, 2, 2}, {0, 0, 0}, {5, 0, 0}, {{0}}};
    assert_true(transform_keyword.finish(&how, 0, &error));
    add_triangles(shared, &ball, 2);
    add_shape(shared, "mesh", &row);
    assert_true(scene_transform_shape(shared, &how, &error));
    add_triangles(apart, &ball, 2);
    for (size_t i = 0; i < ball.position_count; i++) {
        ball.positions[i] = vector3_add(vector3_scale(ball.positions[i], 2), (Vector3){5, 0, 0});
    }
    add_triangles(apart, &ball, 2);
    Tracer *tracers[] = {prepare(engine, shared), prepare(engine, apart)};
    uint64_t state = 11;
    RayQuery rays[TOGETHER];
    RayAnswer answers[2][TOGETHER];
    int second = 0;
    for (int n = 0; n < 50; n++) {
        fill_coherent(&state, rays, 4 * SCENE_REACH);
        for (int i = 0; i < 2; i++) {
            engine->intersect(tracers[i], TOGETHER, rays, answers[i]);
        }
        for (int i = 0; i < TOGETHER; i++) {
            assert_int_equal(answers[0][i].shape, answers[1][i].shape);
            second += answers[0][i].shape == 1;
            if (answers[0][i].shape >= 0) {
                assert_at_most(quad_abs(answers[0][i].distance - answers[1][i].distance), 1e-5,
                               "instance in %s", engine->name);
            }
        }
    }
    assert_true(second > 50);
    engine->release(tracers[0]);
    engine->release(tracers[1]);
    scene_destroy(shared);
    scene_destroy(apart);
    triangles_release(&ball);
}

/* --- all of them ----------------------------------------------------------------------------- */

/** See #shapes_against_lists. @param state Not used. */
static void test_shapes(void **state) {
    (void)state;
    for_every_type(shapes_against_lists);
}

/** See #meshes_against_lists. @param state Not used. */
static void test_meshes(void **state) {
    (void)state;
    for_every_type(meshes_against_lists);
}

/** See #coplanar_grids. @param state Not used. */
static void test_ties(void **state) {
    (void)state;
    for_every_type(coplanar_grids);
    for_every_type(repeated_meshes);
}

/** See #first_triangle. @param state Not used. */
static void test_first_triangle(void **state) {
    (void)state;
    in_every_engine(first_triangle);
}

/** See #closed_meshes. @param state Not used. */
static void test_closed_meshes(void **state) {
    (void)state;
    in_every_engine(closed_meshes);
}

/** See #outline. @param state Not used. */
static void test_outline(void **state) {
    (void)state;
    in_every_engine(outline);
}

/** See #bad_triangles. @param state Not used. */
static void test_builder(void **state) {
    (void)state;
    for_every_type(bad_triangles);
}

/** See #pictures_are_the_same. @param state Not used. */
static void test_shadows(void **state) {
    (void)state;
    in_every_engine(pictures_are_the_same);
    in_every_engine(shadows_end_at_the_lamp);
}

/** See #box_of_all. @param state Not used. */
static void test_bounds(void **state) {
    (void)state;
    in_every_engine(box_of_all);
}

/** See #instances. @param state Not used. */
static void test_instances(void **state) {
    (void)state;
    in_every_engine(instances);
}

/** Runs the tests. @return How many failed. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_shapes),        cmocka_unit_test(test_meshes),
        cmocka_unit_test(test_ties),          cmocka_unit_test(test_first_triangle),
        cmocka_unit_test(test_closed_meshes), cmocka_unit_test(test_outline),
        cmocka_unit_test(test_builder),       cmocka_unit_test(test_shadows),
        cmocka_unit_test(test_bounds),        cmocka_unit_test(test_instances),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
