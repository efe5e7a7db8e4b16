/**
 * @file
 * @brief Compares our tracer with Embree: time and memory on one mesh, with identical rays, one
 *        thread each.
 *
 * Both run alternately, so that other load affects both. The result is the best of several rounds,
 * in processor time. Embree runs in its robust mode, because our tests are always watertight.
 * Camera rays form packets of eight with the coherent flag; other rays are single. Preparation that
 * is free for our tracer is free for Embree: its rays are stored in its own format, and its memory
 * and build time are those of the BVH alone. For camera and random rays both compute the hit and
 * its distance. Embree also writes (u, v) and the triangle's normal, which result from its test.
 *
 * Usage: `peer-embree SCENE FOLDER ENGINE`: a scene of one mesh, the folder of its mesh file, and
 * our engine. Prints one line per measurement: name, ours, Embree's, the ratio by the best rounds
 * and by the median, unit. For comparisons it prints: name, number of different results, and how
 * many of them are wrong in ours and in Embree.
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
/** Columns and rows of a tile of our engine. */
enum { TILE = 64 };
/** Rays per tile. */
enum { TILE_RAYS = TILE * TILE };
/** All rays. */
enum { RAYS = SIZE * SIZE };
/** Rays per packet of Embree: eight neighbours of a row. */
enum { PACKET = 8 };
/** Number of rounds. */
enum { ROUNDS = 9 };

/** The input rays. */
typedef struct RayBatch {
    RayQuery *plain;                /**< The rays for our engine, exact in float. */
    struct RTCRay *single;          /**< The same rays for Embree. */
    float (*directions)[3][PACKET]; /**< Their directions, packet by packet. */
} RayBatch;

/** The results. */
typedef struct RayResults {
    int *shapes;             /**< Ours: the index of the shape hit, or -1. */
    double *distances;       /**< Ours: distances. */
    float *embree_distances; /**< Embree's: distances, or infinity. */
    bool *occluded;          /**< Ours: whether the ray is occluded. */
    bool *embree_occluded;   /**< The same from Embree. */
} RayResults;

/** Both tracers and their rays. */
typedef struct BenchmarkScene {
    Scene *scene;         /**< The scene of one mesh. */
    const Engine *engine; /**< Our engine. */
    Tracer *tracer;       /**< Our tracer. */
    size_t bytes;         /**< Memory of our tracer, bytes. */
    RTCDevice device;     /**< The Embree device. */
    RTCScene embree;      /**< Its scene. */
    float *positions;     /**< Vertex positions in Embree's format. */
    ssize_t embree_bytes; /**< Memory of Embree, bytes, as counted by its device. */
    RayBatch rays;        /**< The rays. */
    RayResults answers;   /**< The results of both. */
} BenchmarkScene;

/** Prints an error and ends the program. */
static _Noreturn void fail(const char *what) {
    fprintf(stderr, "peer-embree: %s\n", what);
    exit(EXIT_FAILURE);
}

/** @return Zeroed memory; the program ends if there is none. */
static void *allocate_or_exit(size_t count, size_t size) {
    /** Alignment for the widest vectors of either, bytes. */
    const size_t alignment = 64;
    size_t bytes = (count * size + alignment - 1) / alignment * alignment;
    void *memory = aligned_alloc(alignment, bytes);
    return memory ? memset(memory, 0, bytes) : (fail("no memory"), NULL);
}

/**
 * @return Processor time of this process in seconds, over all its threads. Other processes do not
 *         count; extra threads would.
 */
static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** @return Memory that this process has allocated, bytes. */
static size_t bytes_held(void) {
    struct mallinfo2 heap = mallinfo2();
    return heap.uordblks + heap.hblkhd;
}

// --- building ------------------------------------------------------------------------------------

/** Creates our tracer. @return Seconds. */
static double build_dioptre(BenchmarkScene *bench) {
    const TraceSettings settings = {.depth = 1, .offset = OFFSET_BOUND};
    Error error = {0};
    if (bench->tracer) {
        bench->engine->destroy(bench->tracer);
    }
    size_t before = bytes_held();
    double start = seconds();
    bench->tracer = bench->engine->create_tracer(bench->scene, &settings, &error);
    double end = seconds();
    bench->bytes = bytes_held() - before;
    return bench->tracer ? end - start : (fail(error.message), 0);
}

/** @return The triangles as an Embree geometry, which shares the scene's memory. */
static RTCGeometry geometry_make(const BenchmarkScene *bench) {
    const Mesh *mesh = bench->scene->meshes[0].mesh;
    RTCGeometry geometry = rtcNewGeometry(bench->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               bench->positions, 0, 3 * sizeof(float), mesh->position_count);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               mesh->triangles, 0, sizeof *mesh->triangles, mesh->triangle_count);
    return geometry;
}

/** Builds Embree's BVH. @return Seconds. */
static double build_embree(BenchmarkScene *bench) {
    if (bench->embree) {
        rtcReleaseScene(bench->embree);
    }
    bench->embree_bytes = 0;
    bench->embree = rtcNewScene(bench->device);
    rtcSetSceneFlags(bench->embree, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = geometry_make(bench);
    double start = seconds();
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(bench->embree, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(bench->embree);
    double end = seconds();
    return rtcGetDeviceError(bench->device) ? (fail("Embree builds nothing"), 0) : end - start;
}

/**
 * Counts Embree's memory. See RTCMemoryMonitorFunction.
 * @return true: the allocation is allowed.
 */
static bool count_embree_memory(void *context, ssize_t bytes, bool is_after) {
    (void)is_after;
    ((BenchmarkScene *)context)->embree_bytes += bytes;
    return true;
}

/** @return The vertex positions of a scene's mesh, rounded to float for both. */
static float *positions_round(const Scene *scene) {
    Mesh *mesh = scene->meshes[0].mesh;
    float *positions = allocate_or_exit(3 * mesh->position_count + 1, sizeof *positions);
    for (size_t i = 0; i < mesh->position_count; i++) {
        Vec3d *at = &mesh->positions[i];
        float *to = positions + 3 * i;
        to[0] = (float)at->x;
        to[1] = (float)at->y;
        to[2] = (float)at->z;
        *at = (Vec3d){(double)to[0], (double)to[1], (double)to[2]};
    }
    return positions;
}

// --- the rays ------------------------------------------------------------------------------------

/** Stores a ray in both formats. */
static void set_ray(RayBatch *rays, size_t i, const float origin[3], const float direction[3]) {
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

/** Rounds a vector to float. */
static void vector_round(Vec3d v, float to[3]) {
    to[0] = (float)v.x;
    to[1] = (float)v.y;
    to[2] = (float)v.z;
}

/**
 * Computes the ray of a pixel with the same bits as our engines; #distance_bound checks that.
 * @param[out] direction  The direction.
 */
static void pixel_direction(const SceneCamera *camera, int column, int row, float direction[3]) {
    double half_pixel = tan(camera->fov / 2 * (M_PI / 180)) / SIZE;
    float right[3], up[3], forward[3], square = 0;
    vector_round(vec3d_scale(scene_camera_right(camera), half_pixel), right);
    vector_round(vec3d_scale(camera->up, half_pixel), up);
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

/**
 * Points the camera at the centre of the mesh.
 * @param distance Distance, in halves of the diagonal of its box.
 */
static void aim_camera(BenchmarkScene *bench, double distance) {
    SceneCamera *camera = &bench->scene->camera;
    Vec3d low, high;
    bench->engine->bounds(bench->tracer, &low, &high);
    double away = distance * vec3d_length(vec3d_subtract(high, low)) / 2;
    Vec3d middle = vec3d_scale(vec3d_add(low, high), 0.5);
    camera->position = vec3d_add(middle, vec3d_scale(camera->direction, -away));
    bench->engine->set_view(bench->tracer, bench->scene, SIZE, SIZE);
}

/** Makes the rays of all pixels, tile by tile, in the order of our engine. */
static void rays_of_picture(BenchmarkScene *bench) {
    float origin[3], direction[3];
    vector_round(bench->scene->camera.position, origin);
    for (size_t i = 0; i < RAYS; i++) {
        int tile = (int)(i / TILE_RAYS), within = (int)(i % TILE_RAYS);
        int column = tile % (SIZE / TILE) * TILE + within % TILE;
        int row = tile / (SIZE / TILE) * TILE + within / TILE;
        pixel_direction(&bench->scene->camera, column, row, direction);
        set_ray(&bench->rays, i, origin, direction);
    }
}

/** Makes the rays of a picture that contains the whole mesh. */
static void rays_of_whole(BenchmarkScene *bench) {
    aim_camera(bench, 2.5);
    rays_of_picture(bench);
}

/** Makes the rays of a picture that the mesh fills. */
static void rays_of_close(BenchmarkScene *bench) {
    aim_camera(bench, 0.9);
    rays_of_picture(bench);
}

/**
 * @return A random number, uniform in 0 to 1 (Steele, Lea, Flood, *Fast Splittable Pseudorandom
 *         Number Generators*, 2014: splitmix64).
 */
static double random_uniform(uint64_t *state) {
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/** Makes rays between random points of the mesh's box. */
static void rays_at_random(BenchmarkScene *bench) {
    uint64_t state = 1;
    Vec3d low, high;
    bench->engine->bounds(bench->tracer, &low, &high);
    for (size_t i = 0; i < RAYS; i++) {
        double height = 2 * random_uniform(&state) - 1, angle = 2 * M_PI * random_uniform(&state);
        double across = sqrt(1 - height * height);
        Vec3d from = {low.x + (high.x - low.x) * random_uniform(&state),
                      low.y + (high.y - low.y) * random_uniform(&state),
                      low.z + (high.z - low.z) * random_uniform(&state)};
        float origin[3], direction[3];
        vector_round(from, origin);
        vector_round((Vec3d){across * cos(angle), height, across * sin(angle)}, direction);
        set_ray(&bench->rays, i, origin, direction);
    }
}

// --- tracing -------------------------------------------------------------------------------------

/** Traces a picture with our engine. @return Seconds. */
static double trace_dioptre(BenchmarkScene *bench) {
    const RayResults *answers = &bench->answers;
    double start = seconds();
    for (int i = 0; i < RAYS / TILE_RAYS; i++) {
        PixelGrid tile = {.x = i % (SIZE / TILE) * TILE,
                          .y = i / (SIZE / TILE) * TILE,
                          .columns = TILE,
                          .rows = TILE,
                          .stride = 1};
        bench->engine->trace_primary(bench->tracer, &tile, answers->shapes + (size_t)i * TILE_RAYS,
                                     answers->distances + (size_t)i * TILE_RAYS);
    }
    return seconds() - start;
}

/** @return Eight Embree rays from the camera, without directions. */
static struct RTCRayHit8 packet_begin(const RayBatch *rays) {
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

/** Traces a picture with Embree's packets. @return Seconds. */
static double trace_embree(BenchmarkScene *bench) {
    /** All rays of a packet are active. */
    static const _Alignas(32) int valid[PACKET] = {-1, -1, -1, -1, -1, -1, -1, -1};
    _Alignas(32) struct RTCRayHit8 packet = packet_begin(&bench->rays);
    struct RTCIntersectContext context;
    double start = seconds();
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    for (size_t p = 0; p < RAYS / PACKET; p++) {
        memcpy(packet.ray.dir_x, bench->rays.directions[p][0], sizeof packet.ray.dir_x);
        memcpy(packet.ray.dir_y, bench->rays.directions[p][1], sizeof packet.ray.dir_y);
        memcpy(packet.ray.dir_z, bench->rays.directions[p][2], sizeof packet.ray.dir_z);
        for (int i = 0; i < PACKET; i++) {
            packet.ray.tfar[i] = INFINITY;
            packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect8(valid, bench->embree, &context, &packet);
        memcpy(bench->answers.embree_distances + p * PACKET, packet.ray.tfar,
               sizeof packet.ray.tfar);
    }
    return seconds() - start;
}

/** Finds the nearest hits of single rays with our engine. @return Seconds. */
static double closest_hits_dioptre(BenchmarkScene *bench) {
    double start = seconds();
    bench->engine->closest_hits(bench->tracer, RAYS, bench->rays.plain, bench->answers.shapes,
                                bench->answers.distances);
    return seconds() - start;
}

/** Finds the nearest hits of single rays with Embree. @return Seconds. */
static double closest_hits_embree(BenchmarkScene *bench) {
    struct RTCIntersectContext context;
    struct RTCRayHit query = {0};
    double start = seconds();
    rtcInitIntersectContext(&context);
    for (size_t i = 0; i < RAYS; i++) {
        query.ray = bench->rays.single[i];
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(bench->embree, &context, &query);
        bench->answers.embree_distances[i] = query.ray.tfar;
    }
    return seconds() - start;
}

/** Tests single rays for occlusion with our engine. @return Seconds. */
static double occluded_dioptre(BenchmarkScene *bench) {
    double start = seconds();
    bench->engine->occluded(bench->tracer, RAYS, bench->rays.plain, bench->answers.occluded);
    return seconds() - start;
}

/** Tests single rays for occlusion with Embree. @return Seconds. */
static double occluded_embree(BenchmarkScene *bench) {
    struct RTCIntersectContext context;
    double start = seconds();
    rtcInitIntersectContext(&context);
    for (size_t i = 0; i < RAYS; i++) {
        struct RTCRay ray = bench->rays.single[i];
        rtcOccluded1(bench->embree, &context, &ray);
        bench->answers.embree_occluded[i] = ray.tfar < 0;
    }
    return seconds() - start;
}

// --- comparison ----------------------------------------------------------------------------------

/** The differences of two sets of results. */
typedef struct Agreement {
    size_t different;    /**< Rays with different results. */
    size_t dioptre_only; /**< Those of them that are wrong in ours. */
    size_t embree_only;  /**< Those of them that are wrong in Embree. */
} Agreement;

/**
 * @return Whether two distances agree, or both are misses.
 * @param bound  Allowed difference.
 */
static bool is_same(double a, double b, double bound) {
    return isfinite(a) && isfinite(b) ? fabs(a - b) <= bound : isfinite(a) == isfinite(b);
}

/**
 * Computes the allowed error of a distance: our engine's error bound of the point, divided by the
 * sine of the ray's angle to the surface.
 * @param distance  Our distance; a second query must reproduce it, or the rays differ.
 * @return The bound, in lengths of the direction; undefined for a miss.
 */
static double distance_bound(const BenchmarkScene *bench, size_t i, double distance) {
    const RayQuery *ray = &bench->rays.plain[i];
    RayQueryQuad query;
    RayResult answer;
    double slant = 0;
    for (int axis = 0; axis < 3; axis++) {
        query.origin[axis] = (Quadruple)ray->origin[axis];
        query.direction[axis] = (Quadruple)ray->direction[axis];
    }
    bench->engine->intersect(bench->tracer, 1, &query, &answer);
    if (answer.shape >= 0 ? (double)answer.distance != distance : isfinite(distance)) {
        fail("the rays are not the same");
    }
    for (int axis = 0; axis < 3; axis++) {
        slant += ray->direction[axis] * (double)answer.normal[axis];
    }
    return (double)answer.error / fabs(slant);
}

/**
 * Decides with a more precise engine which result of a ray is wrong.
 * @param exact  That engine and its tracer.
 * @param bound  Allowed error of distances.
 */
static void decide_by_wider_engine(const BenchmarkScene *bench, const BenchmarkScene *exact,
                                   size_t i, double bound, Agreement *agreement) {
    int shape;
    double truth;
    exact->engine->closest_hits(exact->tracer, 1, &bench->rays.plain[i], &shape, &truth);
    agreement->different++;
    agreement->dioptre_only += !is_same(bench->answers.distances[i], truth, bound);
    agreement->embree_only += !is_same((double)bench->answers.embree_distances[i], truth, bound);
}

/**
 * @return The distances that differ by more than both error bounds.
 * @param exact  A more precise engine and its tracer.
 */
static Agreement compare_distances(const BenchmarkScene *bench, const BenchmarkScene *exact) {
    Agreement agreement = {0};
    for (size_t i = 0; i < RAYS; i++) {
        double dioptre = bench->answers.distances[i];
        double bound = distance_bound(bench, i, dioptre);
        if (!is_same(dioptre, (double)bench->answers.embree_distances[i], 2 * bound)) {
            decide_by_wider_engine(bench, exact, i, bound, &agreement);
        }
    }
    return agreement;
}

/** @return The differing occlusion results. */
static Agreement compare_shadows(const BenchmarkScene *bench, const BenchmarkScene *exact) {
    Agreement agreement = {0};
    for (size_t i = 0; i < RAYS; i++) {
        bool truth, dioptre = bench->answers.occluded[i],
                    embree = bench->answers.embree_occluded[i];
        if (dioptre != embree) {
            exact->engine->occluded(exact->tracer, 1, &bench->rays.plain[i], &truth);
            agreement.different++;
            agreement.dioptre_only += dioptre != truth;
            agreement.embree_only += embree != truth;
        }
    }
    return agreement;
}

// --- benchmark cases -----------------------------------------------------------------------------

/** A benchmark case of both tracers. */
typedef struct BenchmarkCase {
    const char *name;                             /**< Name in the table. */
    void (*prepare)(BenchmarkScene *arena);       /**< Makes the rays; NULL: not needed. */
    double (*run_dioptre)(BenchmarkScene *arena); /**< Runs ours; returns seconds. */
    double (*run_embree)(BenchmarkScene *arena);  /**< Runs Embree; returns seconds. */
    Agreement (*compare)(const BenchmarkScene *,
                         const BenchmarkScene *); /**< Compares the results; NULL: no comparison. */
} BenchmarkCase;

/** All benchmark cases. */
static const BenchmarkCase benchmark_cases[] = {
    {"build", NULL, build_dioptre, build_embree, NULL},
    {"primary", rays_of_whole, trace_dioptre, trace_embree, compare_distances},
    {"close", rays_of_close, trace_dioptre, trace_embree, compare_distances},
    {"random", rays_at_random, closest_hits_dioptre, closest_hits_embree, compare_distances},
    {"shadow", rays_at_random, occluded_dioptre, occluded_embree, compare_shadows}};

/** @return Order of two doubles, for qsort. */
static int compare_doubles(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/** Runs both alternately and prints the times. */
static void benchmark_case_run(BenchmarkScene *bench, const BenchmarkCase *benchmark) {
    double dioptre = HUGE_VAL, embree = HUGE_VAL, ratios[ROUNDS];
    for (int round = 0; round < ROUNDS; round++) {
        double our_time = benchmark->run_dioptre(bench), their_time = benchmark->run_embree(bench);
        dioptre = fmin(dioptre, our_time);
        embree = fmin(embree, their_time);
        ratios[round] = their_time / our_time;
    }
    qsort(ratios, ROUNDS, sizeof *ratios, compare_doubles);
    bool has_rays = benchmark->prepare != NULL;
    printf("%-14s %9.2f %9.2f %7.2f %7.2f  %s\n", benchmark->name,
           has_rays ? 1e-6 * RAYS / dioptre : 1e3 * dioptre,
           has_rays ? 1e-6 * RAYS / embree : 1e3 * embree, embree / dioptre, ratios[ROUNDS / 2],
           has_rays ? "Mrays/s" : "ms");
    fflush(stdout);
}

/** Runs all cases and prints the results. @param exact A more precise engine and its tracer. */
static void benchmark_run_all(BenchmarkScene *bench, const BenchmarkScene *exact) {
    for (size_t i = 0; i < sizeof benchmark_cases / sizeof *benchmark_cases; i++) {
        if (benchmark_cases[i].prepare) {
            benchmark_cases[i].prepare(bench);
        }
        benchmark_case_run(bench, &benchmark_cases[i]);
        if (benchmark_cases[i].compare) {
            Agreement agreement = benchmark_cases[i].compare(bench, exact);
            printf("%s-differ %zu %zu %zu\n", benchmark_cases[i].name, agreement.different,
                   agreement.dioptre_only, agreement.embree_only);
        }
    }
    double triangles = (double)bench->scene->meshes[0].mesh->triangle_count;
    double dioptre = (double)bench->bytes / triangles,
           embree = (double)bench->embree_bytes / triangles;
    printf("%-14s %9.2f %9.2f %7.2f %7.2f  %s\n", "memory", dioptre, embree, embree / dioptre,
           embree / dioptre, "bytes a triangle");
}

// --- setup ---------------------------------------------------------------------------------------

/**
 * @return The scene, slightly rotated so that no ray is parallel to an axis.
 * @param folder  The folder of its mesh file.
 */
static Scene *scene_load(const char *path, const char *folder) {
    Error error = {0};
    const ScriptRequest request = {.path = path,
                                   .base_dir = folder,
                                   .time_limit = SCRIPT_TIME_LIMIT,
                                   .memory_limit = SCRIPT_MEMORY_LIMIT};
    Scene *scene = script_load(&request, &error);
    if (!scene) {
        fail(error.message);
    }
    if (scene->mesh_count != 1 || scene->shape_count != 1) {
        fail("a scene of one mesh is needed");
    }
    scene_camera_rotate(&scene->camera, (Vec3d){0, 1, 0}, 25, -15);
    return scene;
}

/** Initialises a benchmark: both tracers, without BVHs. */
static void benchmark_scene_init(BenchmarkScene *bench, Scene *scene, const char *engine) {
    Error error = {0};
    *bench = (BenchmarkScene){.scene = scene, .engine = engine_find(engine, &error)};
    if (!bench->engine) {
        fail(error.message);
    }
    bench->device = rtcNewDevice("threads=1,start_threads=1,set_affinity=0");
    if (!bench->device) {
        fail("Embree cannot be started");
    }
    rtcSetDeviceMemoryMonitorFunction(bench->device, count_embree_memory, bench);
    bench->positions = positions_round(scene);
    RayBatch *rays = &bench->rays;
    rays->plain = allocate_or_exit(RAYS, sizeof *rays->plain);
    rays->single = allocate_or_exit(RAYS, sizeof *rays->single);
    rays->directions = allocate_or_exit(RAYS / PACKET, sizeof *rays->directions);
    RayResults *answers = &bench->answers;
    answers->shapes = allocate_or_exit(RAYS, sizeof *answers->shapes);
    answers->distances = allocate_or_exit(RAYS, sizeof *answers->distances);
    answers->embree_distances = allocate_or_exit(RAYS, sizeof *answers->embree_distances);
    answers->occluded = allocate_or_exit(RAYS, sizeof *answers->occluded);
    answers->embree_occluded = allocate_or_exit(RAYS, sizeof *answers->embree_occluded);
}

/** Releases all of a benchmark but the scene. */
static void benchmark_scene_deinit(BenchmarkScene *bench) {
    bench->engine->destroy(bench->tracer);
    rtcReleaseScene(bench->embree);
    rtcReleaseDevice(bench->device);
    free(bench->positions);
    free(bench->rays.plain);
    free(bench->rays.single);
    free(bench->rays.directions);
    free(bench->answers.shapes);
    free(bench->answers.distances);
    free(bench->answers.embree_distances);
    free(bench->answers.occluded);
    free(bench->answers.embree_occluded);
}

/**
 * Times both on a scene.
 * @param arguments  The program, the scene, the folder of its mesh file, our engine.
 * @return 0, or 1 on failure.
 */
int main(int count, char **arguments) {
    if (count != 4) {
        fail("usage: peer-embree SCENE FOLDER ENGINE");
    }
    Scene *scene = scene_load(arguments[1], arguments[2]);
    BenchmarkScene bench, exact = {.scene = scene, .engine = engine_find("f64x4", NULL)};
    benchmark_scene_init(&bench, scene, arguments[3]);
    build_dioptre(&exact);
    benchmark_run_all(&bench, &exact);
    exact.engine->destroy(exact.tracer);
    benchmark_scene_deinit(&bench);
    scene_destroy(scene);
    return EXIT_SUCCESS;
}
