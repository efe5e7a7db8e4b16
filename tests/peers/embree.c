/**
 * @file
 * @brief Times our tracer beside Embree on a model, on the very same rays, one thread each.
 *
 * Both take turns, so that a slow moment of the machine hits both, and what counts is the best of
 * several rounds, in processor time. Embree is robust, as ours always is; its packets are of eight
 * rays with the coherent flag, its other rays single. What costs nothing for us costs nothing for
 * Embree either: its rays lie ready in its own form, and its memory and its building are those of
 * the tree alone. Of camera and random rays both answer what is met and how far away; that Embree
 * writes (u, v) and the triangle's normal besides falls out of its way of finding it.
 *
 * Usage: `peer-embree SCENE FOLDER ENGINE`: a scene of one mesh, the folder of its model, and which
 * of our engines. Prints, a line each: name, ours, Embree's, how many times as good ours is by the
 * best of the rounds and by their median, unit; or name, rays that are answered differently, and
 * how many of them ours and Embree answer wrongly.
 */
#include "dioptre/engine.h"
#include "dioptre/script.h"

#include <embree3/rtcore.h>
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/** Columns and rows of the picture. */
enum { SIZE = 1024 };
/** Columns and rows that our engine casts at a time. */
enum { TILE = 64 };
/** Rays of a tile. */
enum { TILE_RAYS = TILE * TILE };
/** All rays. */
enum { RAYS = SIZE * SIZE };
/** Rays of a packet of Embree's: eight neighbours of a row. */
enum { PACKET = 8 };
/** How often each is timed. */
enum { ROUNDS = 9 };

/** What the two are asked. */
typedef struct Rays {
    PlainRay *plain;                /**< The rays as ours are asked; all in float. */
    struct RTCRay *single;          /**< The same for Embree. */
    float (*directions)[3][PACKET]; /**< Their directions, packet by packet. */
} Rays;

/** What was answered. */
typedef struct Answers {
    int *shapes;            /**< Ours: what each ray meets, or -1. */
    double *distances;      /**< Ours: how far. */
    float *their_distances; /**< Embree's: how far, or infinity. */
    bool *shadowed;         /**< Ours: whether anything is met. */
    bool *their_shadowed;   /**< Embree's. */
} Answers;

/** The two, and what they are asked. */
typedef struct Arena {
    Scene *scene;         /**< The scene: a mesh. */
    const Engine *engine; /**< Our engine. */
    Tracer *tracer;       /**< Ours. */
    size_t bytes;         /**< What ours takes. */
    RTCDevice device;     /**< Embree. */
    RTCScene embree;      /**< Its scene. */
    float *positions;     /**< The mesh's, as Embree takes them. */
    ssize_t their_bytes;  /**< What Embree takes: counted by its device. */
    Rays rays;            /**< The rays. */
    Answers answers;      /**< What both said. */
} Arena;

/** Ends the program. @param what What is wrong. */
static _Noreturn void fail(const char *what) {
    fprintf(stderr, "peer-embree: %s\n", what);
    exit(EXIT_FAILURE);
}

/** @return Memory, zero; without it the program ends. @param count How many. @param size Bytes of
 *  each. */
static void *allocate(size_t count, size_t size) {
    /** Bytes: what the widest vectors of either want. */
    const size_t alignment = 64;
    size_t bytes = (count * size + alignment - 1) / alignment * alignment;
    void *memory = aligned_alloc(alignment, bytes);
    return memory ? memset(memory, 0, bytes) : (fail("no memory"), NULL);
}

/** @return Seconds of processor time that this program has taken, all its threads together: other
 * programs do not count, nor would threads that one of the two should not have. */
static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** @return Bytes that this program holds. */
static size_t bytes_held(void) {
    struct mallinfo2 heap = mallinfo2();
    return heap.uordblks + heap.hblkhd;
}

// --- building ------------------------------------------------------------------------------------

/** Builds our tracer. @param arena The arena. @return Seconds. */
static double build_ours(Arena *arena) {
    const TraceSettings settings = {.depth = 1, .offset = OFFSET_BOUND};
    Error error = {0};
    if (arena->tracer) {
        arena->engine->release(arena->tracer);
    }
    size_t before = bytes_held();
    double start = seconds();
    arena->tracer = arena->engine->prepare(arena->scene, &settings, &error);
    double end = seconds();
    arena->bytes = bytes_held() - before;
    return arena->tracer ? end - start : (fail(error.message), 0);
}

/** @return Embree's triangles: it only looks at the scene's memory. @param arena The arena. */
static RTCGeometry geometry_make(const Arena *arena) {
    const Mesh *mesh = arena->scene->meshes[0].mesh;
    RTCGeometry geometry = rtcNewGeometry(arena->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               arena->positions, 0, 3 * sizeof(float), mesh->position_count);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh->triangles, 0, sizeof *mesh->triangles, mesh->triangle_count);
    return geometry;
}

/** Builds Embree's tree. @param arena The arena. @return Seconds. */
static double build_theirs(Arena *arena) {
    if (arena->embree) {
        rtcReleaseScene(arena->embree);
    }
    arena->their_bytes = 0;
    arena->embree = rtcNewScene(arena->device);
    rtcSetSceneFlags(arena->embree, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = geometry_make(arena);
    double start = seconds();
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(arena->embree, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(arena->embree);
    double end = seconds();
    return rtcGetDeviceError(arena->device) ? (fail("Embree builds nothing"), 0) : end - start;
}

/** Counts what Embree takes. See RTCMemoryMonitorFunction. @param context The arena. @param bytes
 *  How much more. @param is_after Not used. @return That it may. */
static bool count_theirs(void *context, ssize_t bytes, bool is_after) {
    (void)is_after;
    ((Arena *)context)->their_bytes += bytes;
    return true;
}

/** @return The positions of a scene's mesh, rounded to float in both peers. @param scene The scene.
 */
static float *positions_round(const Scene *scene) {
    Mesh *mesh = scene->meshes[0].mesh;
    float *positions = allocate(3 * mesh->position_count + 1, sizeof *positions);
    for (size_t i = 0; i < mesh->position_count; i++) {
        Vector3 *at = &mesh->positions[i];
        float *to = positions + 3 * i;
        to[0] = (float)at->x;
        to[1] = (float)at->y;
        to[2] = (float)at->z;
        *at = (Vector3){(double)to[0], (double)to[1], (double)to[2]};
    }
    return positions;
}

// --- the rays ------------------------------------------------------------------------------------

/** Puts a ray where both find it. @param rays The rays. @param i Its place. @param origin Where it
 *  starts. @param direction Which way. */
static void rays_put(Rays *rays, size_t i, const float origin[3], const float direction[3]) {
    rays->single[i] = (struct RTCRay){.org_x = origin[0],
                                      .org_y = origin[1],
                                      .org_z = origin[2],
                                      .dir_x = direction[0],
                                      .dir_y = direction[1],
                                      .dir_z = direction[2],
                                      .tfar = INFINITY,
                                      .mask = UINT32_MAX};
    for (int axis = 0; axis < 3; axis++) {
        rays->plain[i].origin[axis] = (double)origin[axis];
        rays->plain[i].direction[axis] = (double)direction[axis];
        rays->directions[i / PACKET][axis][i % PACKET] = direction[axis];
    }
}

/** Rounds a vector to float. @param v The vector. @param[out] to Its parts. */
static void vector_round(Vector3 v, float to[3]) {
    to[0] = (float)v.x;
    to[1] = (float)v.y;
    to[2] = (float)v.z;
}

/** Makes the ray of a pixel, to the bit as our engines do: whether it is, #compare finds out.
 *  @param camera The camera. @param column The pixel's. @param row The pixel's. @param[out]
 *  direction Which way it goes. */
static void pixel_direction(const Camera *camera, int column, int row, float direction[3]) {
    double half_pixel = tan(camera->fov / 2 * (M_PI / 180)) / SIZE;
    float right[3], up[3], forward[3], square = 0;
    vector_round(vector3_scale(camera_right(camera), half_pixel), right);
    vector_round(vector3_scale(camera->up, half_pixel), up);
    vector_round(camera->direction, forward);
    float x = (float)(2 * column + 1 - SIZE), y = (float)(SIZE - 2 * row - 1);
    for (int axis = 0; axis < 3; axis++) {
        direction[axis] = right[axis] * x + up[axis] * y + forward[axis];
        square += direction[axis] * direction[axis];
    }
    float inverse = 1 / sqrtf(square);
    for (int axis = 0; axis < 3; axis++) {
        direction[axis] *= inverse;
    }
}

/** Looks at the middle of the model. @param arena The arena. @param distance From how far, in
 *  halves of the diagonal of its box. */
static void look(Arena *arena, double distance) {
    Camera *camera = &arena->scene->camera;
    Vector3 low, high;
    arena->engine->bounds(arena->tracer, &low, &high);
    double away = distance * vector3_length(vector3_subtract(high, low)) / 2;
    Vector3 middle = vector3_scale(vector3_add(low, high), 0.5);
    camera->position = vector3_add(middle, vector3_scale(camera->direction, -away));
    arena->engine->look(arena->tracer, arena->scene, SIZE, SIZE);
}

/** Makes the rays of all pixels, tile by tile as our engine answers them. @param arena The arena.
 */
static void rays_of_picture(Arena *arena) {
    float origin[3], direction[3];
    vector_round(arena->scene->camera.position, origin);
    for (size_t i = 0; i < RAYS; i++) {
        int tile = (int)(i / TILE_RAYS), within = (int)(i % TILE_RAYS);
        int column = tile % (SIZE / TILE) * TILE + within % TILE;
        int row = tile / (SIZE / TILE) * TILE + within / TILE;
        pixel_direction(&arena->scene->camera, column, row, direction);
        rays_put(&arena->rays, i, origin, direction);
    }
}

/** Makes the rays of a picture that shows the whole model. @param arena The arena. */
static void rays_of_whole(Arena *arena) {
    look(arena, 2.5);
    rays_of_picture(arena);
}

/** Makes the rays of a picture that the model fills. @param arena The arena. */
static void rays_of_close(Arena *arena) {
    look(arena, 0.9);
    rays_of_picture(arena);
}

/**
 * @return A number, uniform in 0 to 1 (Steele, Lea, Flood, *Fast Splittable Pseudorandom Number
 *         Generators*, 2014: splitmix64).
 * @param[in,out] state  The generator.
 */
static double random_uniform(uint64_t *state) {
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/** Makes rays from anywhere in the model's box to anywhere. @param arena The arena. */
static void rays_at_random(Arena *arena) {
    uint64_t state = 1;
    Vector3 low, high;
    arena->engine->bounds(arena->tracer, &low, &high);
    for (size_t i = 0; i < RAYS; i++) {
        double height = 2 * random_uniform(&state) - 1, angle = 2 * M_PI * random_uniform(&state);
        double across = sqrt(1 - height * height);
        Vector3 from = {low.x + (high.x - low.x) * random_uniform(&state),
                        low.y + (high.y - low.y) * random_uniform(&state),
                        low.z + (high.z - low.z) * random_uniform(&state)};
        float origin[3], direction[3];
        vector_round(from, origin);
        vector_round((Vector3){across * cos(angle), height, across * sin(angle)}, direction);
        rays_put(&arena->rays, i, origin, direction);
    }
}

// --- asking --------------------------------------------------------------------------------------

/** Casts a picture. @param arena The arena. @return Seconds. */
static double cast_ours(Arena *arena) {
    const Answers *answers = &arena->answers;
    double start = seconds();
    for (int i = 0; i < RAYS / TILE_RAYS; i++) {
        PixelGrid tile = {.x = i % (SIZE / TILE) * TILE,
                          .y = i / (SIZE / TILE) * TILE,
                          .columns = TILE,
                          .rows = TILE,
                          .stride = 1};
        arena->engine->cast(arena->tracer, &tile, answers->shapes + (size_t)i * TILE_RAYS,
                            answers->distances + (size_t)i * TILE_RAYS);
    }
    return seconds() - start;
}

/** @return Eight rays of Embree's from the camera, without directions. @param rays The rays. */
static struct RTCRayHit8 packet_begin(const Rays *rays) {
    struct RTCRayHit8 packet = {0};
    for (int i = 0; i < PACKET; i++) {
        packet.ray.org_x[i] = rays->single[0].org_x;
        packet.ray.org_y[i] = rays->single[0].org_y;
        packet.ray.org_z[i] = rays->single[0].org_z;
        packet.ray.mask[i] = UINT32_MAX;
        packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    return packet;
}

/** Casts a picture by Embree's packets. @param arena The arena. @return Seconds. */
static double cast_theirs(Arena *arena) {
    /** Which rays of a packet are there: all. */
    static const _Alignas(32) int valid[PACKET] = {-1, -1, -1, -1, -1, -1, -1, -1};
    _Alignas(32) struct RTCRayHit8 packet = packet_begin(&arena->rays);
    struct RTCIntersectContext context;
    double start = seconds();
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (size_t p = 0; p < RAYS / PACKET; p++) {
        memcpy(packet.ray.dir_x, arena->rays.directions[p][0], sizeof packet.ray.dir_x);
        memcpy(packet.ray.dir_y, arena->rays.directions[p][1], sizeof packet.ray.dir_y);
        memcpy(packet.ray.dir_z, arena->rays.directions[p][2], sizeof packet.ray.dir_z);
        for (int i = 0; i < PACKET; i++) {
            packet.ray.tfar[i] = INFINITY;
            packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect8(valid, arena->embree, &context, &packet);
        memcpy(arena->answers.their_distances + p * PACKET, packet.ray.tfar,
               sizeof packet.ray.tfar);
    }
    return seconds() - start;
}

/** Asks for the nearest hits of any rays. @param arena The arena. @return Seconds. */
static double nearest_ours(Arena *arena) {
    double start = seconds();
    arena->engine->nearest(arena->tracer, RAYS, arena->rays.plain, arena->answers.shapes,
                           arena->answers.distances);
    return seconds() - start;
}

/** Asks Embree for the nearest hits of any rays. @param arena The arena. @return Seconds. */
static double nearest_theirs(Arena *arena) {
    struct RTCIntersectContext context;
    struct RTCRayHit query = {0};
    double start = seconds();
    rtcInitIntersectContext(&context);
    for (size_t i = 0; i < RAYS; i++) {
        query.ray = arena->rays.single[i];
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(arena->embree, &context, &query);
        arena->answers.their_distances[i] = query.ray.tfar;
    }
    return seconds() - start;
}

/** Asks whether any rays meet anything. @param arena The arena. @return Seconds. */
static double shadowed_ours(Arena *arena) {
    double start = seconds();
    arena->engine->shadowed(arena->tracer, RAYS, arena->rays.plain, arena->answers.shadowed);
    return seconds() - start;
}

/** Asks Embree whether any rays meet anything. @param arena The arena. @return Seconds. */
static double shadowed_theirs(Arena *arena) {
    struct RTCIntersectContext context;
    double start = seconds();
    rtcInitIntersectContext(&context);
    for (size_t i = 0; i < RAYS; i++) {
        struct RTCRay ray = arena->rays.single[i];
        rtcOccluded1(arena->embree, &context, &ray);
        arena->answers.their_shadowed[i] = ray.tfar < 0;
    }
    return seconds() - start;
}

// --- comparing -----------------------------------------------------------------------------------

/** How two sets of answers differ. */
typedef struct Verdict {
    size_t differ; /**< Rays that are answered differently. */
    size_t ours;   /**< Those of them that ours answers wrongly. */
    size_t theirs; /**< Those of them that Embree answers wrongly. */
} Verdict;

/** @return Whether two distances, or both misses, are the same. @param a One. @param b The other.
 *  @param bound How far apart they may be. */
static bool is_same(double a, double b, double bound) {
    return isfinite(a) && isfinite(b) ? fabs(a - b) <= bound : isfinite(a) == isfinite(b);
}

/**
 * Finds how far a distance may be off: as far as the point off the surface, by our engine's bound,
 * along a ray that meets the surface at a slant.
 * @param arena     The arena.
 * @param i         The ray.
 * @param distance  Ours; the same must come out again, or the rays are not the same.
 * @return How far, in lengths of the direction; any number where nothing is met.
 */
static double distance_bound(const Arena *arena, size_t i, double distance) {
    const PlainRay *ray = &arena->rays.plain[i];
    RayQuery query;
    RayAnswer answer;
    double slant = 0;
    for (int axis = 0; axis < 3; axis++) {
        query.origin[axis] = (Quadruple)ray->origin[axis];
        query.direction[axis] = (Quadruple)ray->direction[axis];
    }
    arena->engine->intersect(arena->tracer, 1, &query, &answer);
    if (answer.shape >= 0 ? (double)answer.distance != distance : isfinite(distance)) {
        fail("the rays are not the same");
    }
    for (int axis = 0; axis < 3; axis++) {
        slant += ray->direction[axis] * (double)answer.normal[axis];
    }
    return (double)answer.error / fabs(slant);
}

/** Asks an engine of more digits who is right about a ray. @param arena The arena. @param exact
 *  It, and its tracer. @param i The ray. @param bound How far distances may be off. @param[in,out]
 *  verdict The counts. */
static void settle(const Arena *arena, const Arena *exact, size_t i, double bound,
                   Verdict *verdict) {
    int shape;
    double truth;
    exact->engine->nearest(exact->tracer, 1, &arena->rays.plain[i], &shape, &truth);
    verdict->differ++;
    verdict->ours += !is_same(arena->answers.distances[i], truth, bound);
    verdict->theirs += !is_same((double)arena->answers.their_distances[i], truth, bound);
}

/** @return How the distances differ, by more than both may be off. @param arena The arena. @param
 *  exact An engine of more digits, and its tracer. */
static Verdict compare_distances(const Arena *arena, const Arena *exact) {
    Verdict verdict = {0};
    for (size_t i = 0; i < RAYS; i++) {
        double ours = arena->answers.distances[i];
        double bound = distance_bound(arena, i, ours);
        if (!is_same(ours, (double)arena->answers.their_distances[i], 2 * bound)) {
            settle(arena, exact, i, bound, &verdict);
        }
    }
    return verdict;
}

/** @return How the shadows differ. @param arena The arena. @param exact See #compare_distances. */
static Verdict compare_shadows(const Arena *arena, const Arena *exact) {
    Verdict verdict = {0};
    for (size_t i = 0; i < RAYS; i++) {
        bool truth, ours = arena->answers.shadowed[i], theirs = arena->answers.their_shadowed[i];
        if (ours != theirs) {
            exact->engine->shadowed(exact->tracer, 1, &arena->rays.plain[i], &truth);
            verdict.differ++;
            verdict.ours += ours != truth;
            verdict.theirs += theirs != truth;
        }
    }
    return verdict;
}

// --- bouts ---------------------------------------------------------------------------------------

/** Something that both do in turn. */
typedef struct Bout {
    const char *name;                                 /**< For the table. */
    void (*ready)(Arena *arena);                      /**< Makes the rays; NULL: it has none. */
    double (*ours)(Arena *arena);                     /**< Ours; says how long. */
    double (*theirs)(Arena *arena);                   /**< Embree's. */
    Verdict (*compare)(const Arena *, const Arena *); /**< Compares; NULL: nothing to compare. */
} Bout;

/** All of them. */
static const Bout bouts[] = {
    {"build", NULL, build_ours, build_theirs, NULL},
    {"primary", rays_of_whole, cast_ours, cast_theirs, compare_distances},
    {"close", rays_of_close, cast_ours, cast_theirs, compare_distances},
    {"random", rays_at_random, nearest_ours, nearest_theirs, compare_distances},
    {"shadow", rays_at_random, shadowed_ours, shadowed_theirs, compare_shadows}};

/** @return Order of two doubles, for qsort. @param a One. @param b The other. */
static int compare_doubles(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/** Lets both do something in turn, and prints how long it took. @param arena The arena. @param bout
 *  What they do. */
static void bout_run(Arena *arena, const Bout *bout) {
    double ours = HUGE_VAL, theirs = HUGE_VAL, ratios[ROUNDS];
    for (int round = 0; round < ROUNDS; round++) {
        double our_time = bout->ours(arena), their_time = bout->theirs(arena);
        ours = fmin(ours, our_time);
        theirs = fmin(theirs, their_time);
        ratios[round] = their_time / our_time;
    }
    qsort(ratios, ROUNDS, sizeof *ratios, compare_doubles);
    bool has_rays = bout->ready != NULL;
    printf("%-14s %9.2f %9.2f %7.2f %7.2f  %s\n", bout->name,
           has_rays ? 1e-6 * RAYS / ours : 1e3 * ours,
           has_rays ? 1e-6 * RAYS / theirs : 1e3 * theirs, theirs / ours, ratios[ROUNDS / 2],
           has_rays ? "Mrays/s" : "ms");
    fflush(stdout);
}

/** Lets both do everything, and prints how they did. @param arena The arena, without trees. @param
 *  exact An engine of more digits, and its tracer. */
static void bouts_run(Arena *arena, const Arena *exact) {
    for (size_t i = 0; i < sizeof bouts / sizeof *bouts; i++) {
        if (bouts[i].ready) {
            bouts[i].ready(arena);
        }
        bout_run(arena, &bouts[i]);
        if (bouts[i].compare) {
            Verdict verdict = bouts[i].compare(arena, exact);
            printf("%s-differ %zu %zu %zu\n", bouts[i].name, verdict.differ, verdict.ours,
                   verdict.theirs);
        }
    }
    double triangles = (double)arena->scene->meshes[0].mesh->triangle_count;
    double ours = (double)arena->bytes / triangles, theirs = (double)arena->their_bytes / triangles;
    printf("%-14s %9.2f %9.2f %7.2f %7.2f  %s\n", "memory", ours, theirs, theirs / ours,
           theirs / ours, "bytes a triangle");
}

// --- the arena -----------------------------------------------------------------------------------

/** @return The scene, turned a little so that no ray runs along an axis. @param path The scene
 *  file. @param folder The folder of its model. */
static Scene *scene_load(const char *path, const char *folder) {
    Error error = {0};
    const ScriptRequest request = {.path = path,
                                   .base_dir = folder,
                                   .seconds = SCRIPT_SECONDS,
                                   .memory = SCRIPT_MEMORY,
                                   .shape_keywords = engine_find("auto", &error)->shape_keywords};
    Scene *scene = script_load(&request, &error);
    if (!scene) {
        fail(error.message);
    }
    if (scene->mesh_count != 1 || scene->shape_count != 1) {
        fail("a scene of one mesh is needed");
    }
    camera_turn(&scene->camera, (Vector3){0, 1, 0}, 25, -15);
    return scene;
}

/** Begins an arena: both are there, without trees. @param[out] arena The arena. @param scene The
 *  scene. @param engine Our engine. */
static void arena_begin(Arena *arena, Scene *scene, const char *engine) {
    Error error = {0};
    *arena = (Arena){.scene = scene, .engine = engine_find(engine, &error)};
    if (!arena->engine) {
        fail(error.message);
    }
    arena->device = rtcNewDevice("threads=1,start_threads=1,set_affinity=0");
    if (!arena->device) {
        fail("Embree cannot be started");
    }
    rtcSetDeviceMemoryMonitorFunction(arena->device, count_theirs, arena);
    arena->positions = positions_round(scene);
    Rays *rays = &arena->rays;
    rays->plain = allocate(RAYS, sizeof *rays->plain);
    rays->single = allocate(RAYS, sizeof *rays->single);
    rays->directions = allocate(RAYS / PACKET, sizeof *rays->directions);
    Answers *answers = &arena->answers;
    answers->shapes = allocate(RAYS, sizeof *answers->shapes);
    answers->distances = allocate(RAYS, sizeof *answers->distances);
    answers->their_distances = allocate(RAYS, sizeof *answers->their_distances);
    answers->shadowed = allocate(RAYS, sizeof *answers->shadowed);
    answers->their_shadowed = allocate(RAYS, sizeof *answers->their_shadowed);
}

/** Gives back what an arena holds but the scene. @param arena The arena. */
static void arena_end(Arena *arena) {
    arena->engine->release(arena->tracer);
    rtcReleaseScene(arena->embree);
    rtcReleaseDevice(arena->device);
    free(arena->positions);
    free(arena->rays.plain);
    free(arena->rays.single);
    free(arena->rays.directions);
    free(arena->answers.shapes);
    free(arena->answers.distances);
    free(arena->answers.their_distances);
    free(arena->answers.shadowed);
    free(arena->answers.their_shadowed);
}

/**
 * Times both on a scene.
 * @param count      4.
 * @param arguments  The program, the scene, the folder of its model, our engine.
 * @return 0, or 1 when something is missing.
 */
int main(int count, char **arguments) {
    if (count != 4) {
        fail("usage: peer-embree SCENE FOLDER ENGINE");
    }
    Scene *scene = scene_load(arguments[1], arguments[2]);
    Arena arena, exact = {.scene = scene, .engine = engine_find("f64x4", NULL)};
    arena_begin(&arena, scene, arguments[3]);
    build_ours(&exact);
    bouts_run(&arena, &exact);
    exact.engine->release(exact.tracer);
    arena_end(&arena);
    scene_destroy(scene);
    return EXIT_SUCCESS;
}
