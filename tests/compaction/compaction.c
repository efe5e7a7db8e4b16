/**
 * @file
 * @brief The compaction of wavefronts, checked at one number type and width: the Makefile compiles
 *        this file for each engine, with the engine's flags.
 */
#include "compaction.h"

#include "trace/tracer/ray_merge.h"

/** What the rooms of columns hold that nothing was stored in. */
#define UNTOUCHED 7777

/** Number of columns of shapes that rays are inside of; the test uses all. */
enum { INTERIORS = INTERIOR_LIST_CAPACITY };

/** Nothing is wrong. */
static const CompactionFault none = {NULL, 0, 0};

/** @return The value that a test ray has in a column: whole, so that every type holds it. @param
 * ray Its number. @param column The column's number. */
static int value_of(unsigned ray, int column) {
    return (int)(ray * 64 % 60000) + column;
}

/** @return A vector of test rays. @param first The number of the first; they count on. */
static RayVector rays_from(unsigned first) {
    RayVector rays;
    for (int lane = 0; lane < LANES; lane++) {
        unsigned ray = first + (unsigned)lane;
        for (int i = 0; i < RAY_COLUMN_GROUP_COUNT * 3; i++) {
            real_set_lane(&rays.numbers[i / 3][i % 3], lane, (scalar)value_of(ray, i));
        }
        integer_set_lane(&rays.turns, lane, value_of(ray, 20));
        integer_set_lane(&rays.link, lane, (int)ray);
        integer_set_lane(&rays.sample, lane, value_of(ray, 21));
        for (int i = 0; i < INTERIORS; i++) {
            integer_set_lane(&rays.interior.shapes[i], lane, value_of(ray, 22 + i));
        }
    }
    return rays;
}

/** @return Whether the ray in a lane is a test ray with all its numbers. */
static bool is_ray(const RayVector *rays, int lane, unsigned ray) {
    bool is_equal = integer_lane(rays->turns, lane) == value_of(ray, 20) &&
                    integer_lane(rays->link, lane) == (int)ray &&
                    integer_lane(rays->sample, lane) == value_of(ray, 21);
    for (int i = 0; i < RAY_COLUMN_GROUP_COUNT * 3; i++) {
        is_equal &= real_lane(rays->numbers[i / 3][i % 3], lane) == (scalar)value_of(ray, i);
    }
    for (int i = 0; i < INTERIORS; i++) {
        is_equal &= integer_lane(rays->interior.shapes[i], lane) == value_of(ray, 22 + i);
    }
    return is_equal;
}

static CompactionFault check_patterns(uint64_t seed) {
    (void)seed;
    for (unsigned bits = 0; bits <= ALL_LANES; bits++) {
        scalar numbers[3 * LANES];
        integer_scalar integers[3 * LANES];
        wide_scalar wides[3 * LANES];
        unsigned count = 0;
        for (int i = 0; i < 3 * LANES; i++) {
            numbers[i] = (scalar)UNTOUCHED;
            integers[i] = UNTOUCHED;
            wides[i] = UNTOUCHED;
        }
        real lanes = real_of(0);
        for (int lane = 0; lane < LANES; lane++) {
            real_set_lane(&lanes, lane, (scalar)lane);
        }
        real_compress(&numbers[LANES], lanes, bits);
        integer_compress(&integers[LANES], lane_numbers(), bits);
        const wide wide_lanes = widen(lanes);
        wide_compress(&wides[LANES], &wide_lanes, bits);
        for (int lane = 0; lane < LANES; lane++) {
            if (bits >> lane & 1) {
                if (numbers[LANES + count] != (scalar)lane || integers[LANES + count] != lane ||
                    wides[LANES + count] != (wide_scalar)lane) {
                    return (CompactionFault){"a chosen lane", bits, count};
                }
                count++;
            }
        }
        for (unsigned i = 0; i < LANES; i++) {
            if (numbers[i] != (scalar)UNTOUCHED || numbers[2 * LANES + i] != (scalar)UNTOUCHED ||
                integers[i] != UNTOUCHED || integers[2 * LANES + i] != UNTOUCHED ||
                wides[i] != UNTOUCHED || wides[2 * LANES + i] != UNTOUCHED) {
                return (CompactionFault){"a room that is not the vector's", bits, i};
            }
        }
    }
    return none;
}

/** The next of a sequence of random numbers (Knuth's linear congruential generator). */
static unsigned random_bits(uint64_t *state) {
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(*state >> 40);
}

/** Fills a queue with the chosen lanes of many vectors. @param[out] chosen Their numbers. */
static void fill_queue(RayQueue *queue, uint64_t seed, unsigned *chosen) {
    for (unsigned first = 0; queue->count + LANES <= RAY_COLUMN_CAPACITY; first += LANES) {
        RayVector rays = rays_from(first);
        // Few lanes, half of them, most of them: as ever fewer rays go on.
        unsigned bits = random_bits(&seed) & ALL_LANES, sparse = first / LANES % 3;
        bits = sparse == 0   ? bits & random_bits(&seed)
               : sparse == 1 ? bits
                             : bits | random_bits(&seed);
        bits &= ALL_LANES;
        for (unsigned lane = 0, at = queue->count; lane < LANES; lane++) {
            if (bits >> lane & 1) {
                chosen[at++] = first + lane;
            }
        }
        ray_queue_add(queue, bits, &rays, INTERIORS);
    }
}

/** Numbers of the rays that a queue holds. */
static unsigned chosen[RAY_COLUMN_CAPACITY];

static CompactionFault check_streams(uint64_t seed) {
    RayQueue queues[QUEUE_COUNT];
    CompactionFault fault = none;
    if (!ray_queues_init(queues)) {
        return (CompactionFault){"memory", 0, 0};
    }
    ray_queues_clear(queues);
    fill_queue(&queues[CHILD_REFRACTED], seed, chosen);
    for (unsigned i = 0; i < queues[CHILD_REFRACTED].count; i++) {
        RayVector rays =
            ray_columns_load(queues[CHILD_REFRACTED].columns, RAY_COLUMN_FIRST + i, INTERIORS);
        if (!is_ray(&rays, 0, chosen[i])) {
            fault = (CompactionFault){"a queued ray", 0, i};
            break;
        }
    }
    ray_queues_deinit(queues);
    return fault;
}

/** @return Whether lane and vector of a packet hold a test ray. */
static bool packet_has_ray(const GatheredPacket *gathered, unsigned index, unsigned ray) {
    unsigned v = index / LANES;
    int lane = (int)(index % LANES);
    const Ray *of = &gathered->rays.packet.rays[v];
    return real_lane(of->origin.x, lane) == (scalar)value_of(ray, 0) &&
           real_lane(of->direction.z, lane) == (scalar)value_of(ray, 5) &&
           real_lane(gathered->rays.throughput[v].green, lane) == (scalar)value_of(ray, 7) &&
           real_lane(gathered->weights[v].blue, lane) == (scalar)value_of(ray, 11) &&
           integer_lane(gathered->rays.turns[v], lane) == value_of(ray, 20) &&
           integer_lane(gathered->links[v], lane) == (int)ray &&
           integer_lane(gathered->source.samples[v], lane) == value_of(ray, 21) &&
           integer_lane(gathered->interior[v].shapes[0], lane) == value_of(ray, 22);
}

/** Checks a packet of some rays of a queue, whose numbers count from 0. */
static CompactionFault check_packet(const RayColumns *columns, unsigned first, unsigned count) {
    static GatheredPacket gathered;
    packet_gather(columns, INTERIORS, first, count, &gathered);
    for (unsigned i = 0; i < PACKET_RAYS; i++) {
        const Packet *packet = &gathered.rays.packet;
        // Vectors behind the last ray are not there: what is left of other packets stays in them.
        bool is_active = (int)(i / LANES) < packet_vector_count(packet) &&
                         mask_lane(packet->active[i / LANES], (int)(i % LANES));
        unsigned ray = first - RAY_COLUMN_FIRST + i;
        if (is_active != (i < count)) {
            return (CompactionFault){"an active lane", count, i};
        }
        if (is_active && !packet_has_ray(&gathered, i, ray)) {
            return (CompactionFault){"a ray of a packet", count, i};
        }
        // What is left of the last vector is computed, too: with copies of its first ray.
        bool is_rest = !is_active && i / LANES * LANES < count;
        if (is_rest && !packet_has_ray(&gathered, i, ray - i % LANES)) {
            return (CompactionFault){"an unused lane", count, i};
        }
    }
    return none;
}

/** Queues test rays. @param first The number of the first. @param count A multiple of LANES. */
static void queue_rays(RayQueue *queue, unsigned first, unsigned count) {
    for (unsigned done = 0; done < count; done += LANES) {
        RayVector rays = rays_from(first + done);
        ray_queue_add(queue, ALL_LANES, &rays, INTERIORS);
    }
}

static CompactionFault check_packets(uint64_t seed) {
    (void)seed;
    RayQueue queues[QUEUE_COUNT];
    CompactionFault fault = none;
    if (!ray_queues_init(queues)) {
        return (CompactionFault){"memory", 0, 0};
    }
    ray_queues_clear(queues);
    queue_rays(&queues[CHILD_REFLECTED], 0, 3 * PACKET_RAYS);
    for (unsigned count = 1; count <= PACKET_RAYS && !fault.what; count++) {
        fault = check_packet(queues[CHILD_REFLECTED].columns, RAY_COLUMN_FIRST + count, count);
    }
    ray_queues_deinit(queues);
    return fault;
}

static CompactionFault check_joins(uint64_t seed) {
    (void)seed;
    RayQueue queues[QUEUE_COUNT];
    CompactionFault fault = none;
    if (!ray_queues_init(queues)) {
        return (CompactionFault){"memory", 0, 0};
    }
    for (unsigned rest = 0; rest < PACKET_RAYS && !fault.what; rest++) {
        ray_queues_clear(queues);
        queue_rays(&queues[CHILD_REFRACTED], 0, PACKET_RAYS);
        queue_rays(&queues[CHILD_REFLECTED], PACKET_RAYS, PACKET_RAYS);
        ray_columns_copy(queues[CHILD_REFRACTED].columns, RAY_COLUMN_FIRST + PACKET_RAYS - rest,
                         queues[CHILD_REFLECTED].columns, RAY_COLUMN_FIRST - rest, rest, INTERIORS);
        for (unsigned i = 0; i < rest + PACKET_RAYS && !fault.what; i++) {
            RayVector rays = ray_columns_load(queues[CHILD_REFLECTED].columns,
                                              RAY_COLUMN_FIRST - rest + i, INTERIORS);
            if (!is_ray(&rays, 0, PACKET_RAYS - rest + i)) {
                fault = (CompactionFault){"a joined ray", rest, i};
            }
        }
    }
    ray_queues_deinit(queues);
    return fault;
}

/** The rays of a group, near each other. */
typedef enum MergeVariant {
    MERGE_BASE,          /**< A ray. */
    MERGE_NEAR,          /**< A heavier one that nearly coincides with it. */
    MERGE_OTHER_START,   /**< This and the next start or go elsewhere, */
    MERGE_OTHER_WAY,     /**< or have another history: they coincide with none. */
    MERGE_OTHER_TURNS,   /**< See there. */
    MERGE_OTHER_SHAPE,   /**< See there. */
    MERGE_HEAVY,         /**< This and the next coincide, but weigh too much. */
    MERGE_HEAVY_AGAIN,   /**< See there. */
    MERGE_VARIANT_COUNT, /**< How many there are. */
    MERGE_KEPT_COUNT = MERGE_VARIANT_COUNT - 1 /**< How many are left. */
} MergeVariant;

/** Groups of rays, far apart. */
enum { MERGE_GROUPS = 2000, MERGE_RAYS = MERGE_GROUPS * MERGE_VARIANT_COUNT };
/** Which rays are merged. */
static const MergeLimits merge_limits = {1.0 / 16, 1.0 / 16, (scalar)50, INTERIORS};
/** How far apart the rays of a group are that nearly coincide, and those that do not. */
static const scalar merge_near = (scalar)(1.0 / 64), merge_far = (scalar)(1.0 / 8);

/** @return A ray of a group, in all lanes. */
static RayVector merge_ray(int group, MergeVariant variant) {
    const scalar throughputs[MERGE_VARIANT_COUNT] = {1, 2, 1, 1, 1, 1, 100, 100};
    RayVector rays = {.turns = integer_of(3 + (variant == MERGE_OTHER_TURNS))};
    rays.numbers[RAY_COLUMN_ORIGIN][0] =
        real_of((scalar)group + (variant == MERGE_NEAR ? merge_near : 0));
    rays.numbers[RAY_COLUMN_ORIGIN][1] = real_of(variant == MERGE_OTHER_START ? merge_far : 0);
    rays.numbers[RAY_COLUMN_DIRECTION][2] = real_of(variant == MERGE_OTHER_WAY ? 1 - merge_far : 1);
    for (int i = 0; i < 3; i++) {
        rays.numbers[RAY_COLUMN_THROUGHPUT][i] = real_of(throughputs[variant]);
    }
    rays.interior = interior_list_empty();
    rays.interior.shapes[INTERIORS - 1] = integer_of(variant == MERGE_OTHER_SHAPE ? 7 : -1);
    return rays;
}

/** Queues the rays of all groups in any order. */
static void merge_rays_queue(uint64_t seed, RayQueue *queue) {
    int order[MERGE_RAYS];
    for (int i = 0; i < MERGE_RAYS; i++) {
        // Fisher and Yates's shuffle.
        int other = (int)(random_bits(&seed) % (unsigned)(i + 1));
        order[i] = order[other];
        order[other] = i;
    }
    for (int i = 0; i < MERGE_RAYS; i++) {
        RayVector rays = merge_ray(order[i] / MERGE_VARIANT_COUNT,
                                   (MergeVariant)(order[i] % MERGE_VARIANT_COUNT));
        ray_queue_add(queue, 1, &rays, INTERIORS);
    }
}

/** Checks rays that were merged. */
static CompactionFault check_merged(const RayQueue *level, const MergeCounts *counts) {
    unsigned whole = 0, heavy = 0;
    if (level->count != MERGE_GROUPS * MERGE_KEPT_COUNT || counts->merged != MERGE_GROUPS ||
        counts->light != MERGE_GROUPS * (MERGE_VARIANT_COUNT - 2)) {
        return (CompactionFault){"the number of merged rays", counts->merged, level->count};
    }
    for (unsigned i = 0; i < level->count; i++) {
        RayVector rays = ray_columns_load(level->columns, RAY_COLUMN_FIRST + i, INTERIORS);
        scalar throughput = real_lane(rays.numbers[RAY_COLUMN_THROUGHPUT][1], 0);
        scalar x = real_lane(rays.numbers[RAY_COLUMN_ORIGIN][0], 0);
        bool is_near = x - (scalar)(int)x == merge_near;
        if (is_near != (throughput == 3)) {
            return (CompactionFault){"a merged ray", 0, i};
        }
        whole += is_near;
        heavy += throughput == 100;
    }
    return whole == MERGE_GROUPS && heavy == 2 * MERGE_GROUPS
               ? none
               : (CompactionFault){"the throughput of merged rays", heavy, whole};
}

static CompactionFault check_merges(uint64_t seed) {
    static MergeTable table;
    RayQueue queues[QUEUE_COUNT];
    CompactionFault fault = none;
    if (!ray_queues_init(queues)) {
        return (CompactionFault){"memory", 0, 0};
    }
    // Several levels: what the table had before is forgotten.
    for (int level = 0; level < 4 && !fault.what; level++) {
        MergeCounts counts = {0};
        ray_queues_clear(queues);
        merge_rays_queue(seed + (uint64_t)level, &queues[0]);
        merge_begin_level(&table, &queues[1]);
        ray_queue_merge(&table, &merge_limits, &queues[0], &queues[1], &counts);
        fault = check_merged(&queues[1], &counts);
    }
    ray_queues_deinit(queues);
    return fault;
}

extern const CompactionChecks CHECKS;
const CompactionChecks CHECKS = {{[COMPACTION_PATTERNS] = check_patterns,
                                  [COMPACTION_STREAMS] = check_streams,
                                  [COMPACTION_PACKETS] = check_packets,
                                  [COMPACTION_JOINS] = check_joins,
                                  [COMPACTION_MERGES] = check_merges}};
