/**
 * @file
 * @brief Wavefronts.
 */
#include "trace/tracer/wavefront.h"

#include <stdlib.h>
#include <string.h>

/** Camera rays that are traced side by side, at most. */
enum { WAVEFRONT_SAMPLES = WAVEFRONT_PACKETS * PACKET_RAYS };

/** Memory of a wavefront, one for each thread that traces; only what is used is ever touched.
 *  Camera rays that need more are traced in smaller groups, so the sizes change the time alone. */
struct Wavefront {
    PathNodes *nodes;      /**< The rays that were traced; owned. */
    unsigned sample_limit; /**< See wavefront_sample_limit(). */
    unsigned sample_count; /**< Number of camera rays that were traced last. */
    bool had_ample_room;   /**< Whether those, and all that was resumed of them, used less than a
                                quarter of each array. */
    int interior_count;    /**< Most shapes that a ray may be inside of. */
    RayQueue level[QUEUE_COUNT]; /**< The rays that are traced now. */
    RayQueue next[QUEUE_COUNT];  /**< The rays of the next level. */
    RayQueue kept[QUEUE_COUNT];  /**< Rays of each #Child for wavefront_resume(), in the order of
                                      their bounces. */
    unsigned kept_end[CHILD_COUNT][DEPTH_MAXIMUM + 2]; /**< Number of those up to each bounce. */
    unsigned bounces;                                  /**< Number of levels that were traced. */
    uint32_t pixel_ids[WAVEFRONT_SAMPLES];             /**< See #SampleContext, per camera ray. */
    unsigned roots[WAVEFRONT_PACKETS][PACKET_VECTORS]; /**< Nodes of the camera rays. */
    unsigned root_lanes[WAVEFRONT_PACKETS][PACKET_VECTORS]; /**< Lanes of camera rays at whose
                                                                 surfaces rays start, as bits: the
                                                                 others need no node. */
    MergeTable merge_table;                                 /**< For merged rays. */
};

/* --- memory ----------------------------------------------------------------------------------- */

Wavefront *wavefront_create(void) {
    Wavefront *wavefront = calloc(1, sizeof *wavefront);
    if (!wavefront) {
        return NULL;
    }
    wavefront->sample_limit = WAVEFRONT_SAMPLES;
    wavefront->nodes = malloc(sizeof *wavefront->nodes);
    bool has_level = ray_queues_init(wavefront->level), has_next = ray_queues_init(wavefront->next),
         has_kept = ray_queues_init(wavefront->kept);
    if (!wavefront->nodes || !has_level || !has_next || !has_kept) {
        wavefront_destroy(wavefront);
        return NULL;
    }
    return wavefront;
}

void wavefront_destroy(Wavefront *wavefront) {
    if (wavefront) {
        free(wavefront->nodes);
        ray_queues_deinit(wavefront->level);
        ray_queues_deinit(wavefront->next);
        ray_queues_deinit(wavefront->kept);
        free(wavefront);
    }
}

unsigned wavefront_sample_limit(const Wavefront *wavefront) {
    return wavefront->sample_limit;
}

/** Lowers #Wavefront.sample_limit, as memory did not suffice. @return false */
static bool wavefront_fail(Wavefront *wavefront) {
    unsigned count = wavefront->sample_count;
    wavefront->sample_limit = count > 1 ? count / 2 : 1;
    wavefront->had_ample_room = false;
    return false;
}

/** Raises #Wavefront.sample_limit if the last camera rays had ample room: at least half as many as
 *  the limit allows used less than a quarter, so twice as many as it allows find room, too. Fewer
 *  rays say nothing. Half of those that found no room use more than that, so the limit does not
 *  swing. */
static void wavefront_raise_limit(Wavefront *wavefront) {
    unsigned limit = wavefront->sample_limit;
    if (wavefront->had_ample_room && 2 * wavefront->sample_count >= limit &&
        limit < WAVEFRONT_SAMPLES) {
        wavefront->sample_limit = 2 * limit < WAVEFRONT_SAMPLES ? 2 * limit : WAVEFRONT_SAMPLES;
    }
}

/** Notes how much room the rays of a level leave, before it is traced. */
static void wavefront_note_room(Wavefront *wavefront) {
    const unsigned few = RAY_COLUMN_CAPACITY / 4;
    wavefront->had_ample_room =
        wavefront->had_ample_room && wavefront->nodes->count < NODES_MAXIMUM / 4 &&
        ray_queues_count(wavefront->level) < few && ray_queues_count(wavefront->kept) < few;
}

/** @return Whether a packet, and the rays that start at its surfaces, find room. */
static bool wavefront_has_room(const Wavefront *wavefront) {
    const unsigned most = 2 * PACKET_RAYS;
    return wavefront->nodes->count + PACKET_RAYS <= NODES_MAXIMUM &&
           ray_queues_count(wavefront->next) + most <= RAY_COLUMN_CAPACITY &&
           ray_queues_count(wavefront->kept) + most <= RAY_COLUMN_CAPACITY;
}

MergeMemory wavefront_merge_memory(Wavefront *wavefront) {
    return (MergeMemory){&wavefront->level[0], wavefront->next, &wavefront->merge_table};
}

/* --- from packets to the queues --------------------------------------------------------------- */

/** Adds the nodes of camera rays at whose surfaces rays start. @param p Index of the packet.
 *  @param[out] source The nodes. */
static void roots_add(Wavefront *wavefront, int p, const CameraPacket *packet,
                      const ScatteredRays *scattered, PacketSource *source) {
    const Rgb one = {real_of(1), real_of(1), real_of(1)};
    for (int v = 0; v < PACKET_VECTORS; v++) {
        unsigned lanes = mask_bits(scattered->refracted.rays.packet.active[v] |
                                   scattered->reflected.rays.packet.active[v]);
        wavefront->root_lanes[p][v] = lanes;
        if (lanes) {
            wavefront->roots[p][v] = source->nodes[v] =
                path_nodes_add(wavefront->nodes, one, packet->colors[v], packet->losses.dropped[v],
                               packet->losses.guarded[v]);
            source->samples[v] = lane_numbers() + (p * PACKET_RAYS + v * LANES);
        }
    }
}

/** Adds rays to the queues of a level: those inside of a shape, and others. @param lanes Which
 *  lanes, as bits; there is room. */
INLINE void ray_queues_add(RayQueue queues[QUEUE_COUNT], Child child, unsigned lanes,
                           const RayVector *rays, int interior_count) {
    mask is_inside = interior_list_top(&rays->interior) >= integer_of(0);
    unsigned inside = lanes & mask_bits(is_inside);
    if (inside) {
        ray_queue_add(&queues[QUEUE_INSIDE], inside, rays, interior_count);
    }
    if (lanes & ~inside) {
        ray_queue_add(&queues[child], lanes & ~inside, rays, interior_count);
    }
}

/** Notes at their parents that rays are kept. @param kept Of their kind. @param parent The first
 *  node of the vector that they come from. */
INLINE void kept_rays_link(PathNodes *nodes, Child child, unsigned kept, unsigned lanes,
                           unsigned parent) {
    for (; lanes; lanes &= lanes - 1) {
        unsigned node = parent + (unsigned)__builtin_ctz(lanes);
        nodes->children[child][node] = NODE_KEPT_FIRST - (int)kept++;
    }
}

/**
 * Queues the rays of a kind that start at the surfaces of a packet, or keeps them.
 * @param cutoff  Rays of less throughput are kept.
 * @return The number of rays that are queued.
 */
INLINE unsigned secondary_rays_queue(Wavefront *wavefront, scalar cutoff, Child child,
                                     const PacketSource *source, const SecondaryRays *secondary) {
    const int interior_count = wavefront->interior_count;
    RayQueue *kept = &wavefront->kept[child];
    unsigned count = 0;
    for (int v = 0; v < packet_vector_count(&secondary->rays.packet); v++) {
        unsigned lanes = mask_bits(secondary->rays.packet.active[v]);
        if (lanes == 0) {
            continue;
        }
        mask is_heavy = rgb_max(secondary->rays.throughput[v]) >= cutoff;
        unsigned heavy = lanes & mask_bits(is_heavy), light = lanes & ~heavy;
        integer links = node_link(lane_numbers() + (int)source->nodes[v], child);
        RayVector rays =
            ray_vector_of(&secondary->rays, v, secondary->weights[v], links, source->samples[v]);
        ray_queues_add(wavefront->next, child, heavy, &rays, interior_count);
        count += (unsigned)__builtin_popcount(heavy);
        if (light) {
            kept_rays_link(wavefront->nodes, child, kept->count, light, source->nodes[v]);
            ray_queue_add(kept, light, &rays, interior_count);
        }
    }
    return count;
}

/** Queues the rays that start at the surfaces of a packet. See secondary_rays_queue(). */
static void scattered_rays_queue(Wavefront *wavefront, scalar cutoff, const PacketSource *source,
                                 const ScatteredRays *scattered, RayCounts *counts) {
    counts->reflection +=
        secondary_rays_queue(wavefront, cutoff, CHILD_REFLECTED, source, &scattered->reflected);
    counts->refraction +=
        secondary_rays_queue(wavefront, cutoff, CHILD_REFRACTED, source, &scattered->refracted);
}

/* --- from the queues to packets --------------------------------------------------------------- */

/** Sets what identifies the samples of a packet. @param context Of the camera rays. */
static void packet_set_context(const Wavefront *wavefront, const SampleContext *context,
                               unsigned bounce, GatheredPacket *gathered) {
    Packet *packet = &gathered->rays.packet;
    packet->context = *context;
    packet->context.bounce = bounce;
    if (!context->pixel_ids) {
        return;
    }
    packet->context.pixel_ids = gathered->pixel_ids;
    for (int v = 0; v < packet_vector_count(packet); v++) {
        for (int lane = 0; lane < LANES && any(packet->active[v]); lane++) {
            int sample = integer_at(&gathered->source.samples[v], lane);
            gathered->pixel_ids[v * LANES + lane] = wavefront->pixel_ids[sample];
        }
    }
}

/** Adds nodes for the rays of a packet. */
static void nodes_add(PathNodes *nodes, GatheredPacket *gathered, const Rgb *colors,
                      const Losses *losses) {
    for (int v = 0; v < packet_vector_count(&gathered->rays.packet); v++) {
        unsigned lanes = mask_bits(gathered->rays.packet.active[v]);
        unsigned first = path_nodes_add(nodes, gathered->weights[v], colors[v], losses->dropped[v],
                                        losses->guarded[v]);
        gathered->source.nodes[v] = first;
        for (unsigned lane = 0; lane < LANES && lanes >> lane & 1; lane++) {
            path_nodes_set_child(nodes, integer_at(&gathered->links[v], (int)lane),
                                 (int)(first + lane));
        }
    }
}

/**
 * Traces a packet of queued rays, and queues the rays that start at its surfaces.
 * @param cutoff  Rays of less throughput are kept.
 * @param context  Its cutoff is the least throughput of rays that are kept.
 */
static __attribute__((noinline)) void wavefront_trace_packet(Wavefront *wavefront, scalar cutoff,
                                                             const TraceContext *context,
                                                             GatheredPacket *gathered) {
    ScatteredRays scattered;
    Rgb colors[PACKET_VECTORS];
    Losses losses;
    bool is_scattered = shade_and_scatter(context, &gathered->rays, &scattered, colors, &losses);
    if (!is_scattered) {
        losses_clear(&losses, packet_vector_count(&gathered->rays.packet));
    }
    nodes_add(wavefront->nodes, gathered, colors, &losses);
    if (is_scattered) {
        scattered_rays_queue(wavefront, cutoff, &gathered->source, &scattered, context->counts);
    }
}

/** Moves the last refracted rays, too few for a packet, to the front of the reflected ones.
 *  @return How many they are. */
static unsigned level_join(Wavefront *wavefront) {
    RayQueue *refracted = &wavefront->level[CHILD_REFRACTED];
    unsigned rest = refracted->count % PACKET_RAYS;
    ray_columns_copy(refracted->columns, RAY_COLUMN_FIRST + refracted->count - rest,
                     wavefront->level[CHILD_REFLECTED].columns, RAY_COLUMN_FIRST - rest, rest,
                     wavefront->interior_count);
    refracted->count -= rest;
    return rest;
}

/** What all packets of a level have in common. */
typedef struct Level {
    const TraceContext *context;         /**< Its cutoff is the least throughput of kept rays. */
    const SampleContext *sample_context; /**< Of the camera rays. */
    scalar cutoff;                       /**< Rays of less throughput are kept. */
    unsigned bounce;                     /**< See #SampleContext. */
} Level;

/** Traces rays in columns. @param first Place of the first. @param count Number of rays. @return
 *  Whether memory sufficed. */
static bool wavefront_trace_columns(Wavefront *wavefront, const Level *level,
                                    const RayColumns *columns, unsigned first, unsigned count) {
    for (unsigned done = 0; done < count; done += PACKET_RAYS) {
        GatheredPacket gathered;
        if (!wavefront_has_room(wavefront)) {
            return wavefront_fail(wavefront);
        }
        packet_gather(columns, wavefront->interior_count, first + done,
                      count - done < PACKET_RAYS ? count - done : PACKET_RAYS, &gathered);
        packet_set_context(wavefront, level->sample_context, level->bounce, &gathered);
        wavefront_trace_packet(wavefront, level->cutoff, level->context, &gathered);
    }
    return true;
}

/** Traces the rays of the current level: neighbours stay together. @return Whether memory
 *  sufficed. */
static bool wavefront_trace_level(Wavefront *wavefront, const Level *level) {
    const RayQueue *inside = &wavefront->level[QUEUE_INSIDE],
                   *refracted = &wavefront->level[CHILD_REFRACTED],
                   *reflected = &wavefront->level[CHILD_REFLECTED];
    wavefront_note_room(wavefront);
    unsigned rest = level_join(wavefront);
    return wavefront_trace_columns(wavefront, level, inside->columns, RAY_COLUMN_FIRST,
                                   inside->count) &&
           wavefront_trace_columns(wavefront, level, refracted->columns, RAY_COLUMN_FIRST,
                                   refracted->count) &&
           wavefront_trace_columns(wavefront, level, reflected->columns, RAY_COLUMN_FIRST - rest,
                                   rest + reflected->count);
}

/** Makes the next level the current one. */
static void wavefront_advance(Wavefront *wavefront) {
    for (int i = 0; i < QUEUE_COUNT; i++) {
        RayQueue done = wavefront->level[i];
        done.count = 0;
        wavefront->level[i] = wavefront->next[i];
        wavefront->next[i] = done;
    }
}

/* --- results ---------------------------------------------------------------------------------- */

/** Sets the results of the camera rays of a packet that have nodes. @param p Its index. */
static void camera_packet_set_results(const Wavefront *wavefront, int p, CameraPacket *packet) {
    const PathNodes *nodes = wavefront->nodes;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        if (wavefront->root_lanes[p][v] == 0) {
            continue;
        }
        unsigned root = wavefront->roots[p][v];
        mask lanes = packet->lanes[v] & mask_of_bits(wavefront->root_lanes[p][v]);
        Losses *losses = &packet->losses;
        packet->colors[v] =
            rgb_select(lanes, path_nodes_color(nodes, NODE_SUM, root), packet->colors[v]);
        losses->dropped[v] =
            rgb_select(lanes, path_nodes_color(nodes, NODE_SUM_DROPPED, root), losses->dropped[v]);
        losses->guarded[v] =
            rgb_select(lanes, path_nodes_color(nodes, NODE_SUM_GUARDED, root), losses->guarded[v]);
        losses->rays[v] = real_select(lanes, real_load(&nodes->rays[root]), losses->rays[v]);
    }
}

/** Sets the results of all camera rays that are traced. */
static void wavefront_set_results(Wavefront *wavefront, CameraPacket *packets, int count) {
    const RayColumns *const kept[CHILD_COUNT] = {wavefront->kept[CHILD_REFLECTED].columns,
                                                 wavefront->kept[CHILD_REFRACTED].columns};
    wavefront_note_room(wavefront);
    path_nodes_add_up(wavefront->nodes, kept);
    for (int p = 0; p < count; p++) {
        camera_packet_set_results(wavefront, p, &packets[p]);
    }
}

/* --- passes ----------------------------------------------------------------------------------- */

/** Begins the trees of the camera rays of packets. */
static void wavefront_begin(Wavefront *wavefront, const Dielectrics *dielectrics,
                            const CameraPacket *packets, int count) {
    wavefront_raise_limit(wavefront);
    wavefront->interior_count = ray_columns_interior_count(dielectrics);
    wavefront->sample_count = 0;
    wavefront->had_ample_room = true;
    wavefront->nodes->count = 0;
    ray_queues_clear(wavefront->level);
    ray_queues_clear(wavefront->next);
    ray_queues_clear(wavefront->kept);
    memset(wavefront->root_lanes, 0, sizeof wavefront->root_lanes);
    for (int p = 0; p < count; p++) {
        wavefront->sample_count += camera_packet_count(&packets[p]);
        const uint32_t *pixel_ids = packets[p].rays->packet.context.pixel_ids;
        for (int i = 0; i < PACKET_RAYS; i++) {
            wavefront->pixel_ids[p * PACKET_RAYS + i] = pixel_ids ? pixel_ids[i] : 0;
        }
    }
}

/** Notes that all rays of a bounce that are kept have been. */
static void wavefront_end_bounce(Wavefront *wavefront, unsigned bounce) {
    for (int child = 0; child < CHILD_COUNT; child++) {
        wavefront->kept_end[child][bounce] = wavefront->kept[child].count;
    }
    wavefront->bounces = bounce;
}

/** Traces the camera rays of a packet, and queues the rays that start at their surfaces. @param p
 *  Its index. See wavefront_trace_packet(). */
static __attribute__((noinline)) void camera_packet_trace(Wavefront *wavefront, scalar cutoff,
                                                          const TraceContext *context, int p,
                                                          CameraPacket *packet) {
    ScatteredRays scattered;
    Rgb colors[PACKET_VECTORS];
    Losses losses;
    RayState *rays = packet->rays;
    mask active[PACKET_VECTORS];
    memcpy(active, rays->packet.active, sizeof active);
    memcpy(rays->packet.active, packet->lanes, sizeof active);
    if (packet_active_count(&rays->packet) > 0) {
        bool is_scattered = shade_and_scatter(context, rays, &scattered, colors, &losses);
        if (!is_scattered) {
            losses_clear(&losses, PACKET_VECTORS);
        }
        results_replace(packet->lanes, colors, &losses, packet->colors, &packet->losses);
        if (is_scattered) {
            PacketSource source;
            roots_add(wavefront, p, packet, &scattered, &source);
            scattered_rays_queue(wavefront, cutoff, &source, &scattered, context->counts);
        }
    }
    memcpy(rays->packet.active, active, sizeof active);
}

bool wavefront_trace(Wavefront *wavefront, const TraceContext *context, scalar least_throughput,
                     CameraPacket *packets, int count) {
    TraceContext keeping = *context;
    keeping.cutoff = least_throughput;
    Level level = {&keeping, &packets[0].rays->packet.context, context->cutoff, 0};
    wavefront_begin(wavefront, &context->tracer->dielectrics, packets, count);
    for (int p = 0; p < count; p++) {
        camera_packet_trace(wavefront, context->cutoff, &keeping, p, &packets[p]);
    }
    while (ray_queues_count(wavefront->next) > 0) {
        wavefront_end_bounce(wavefront, ++level.bounce);
        wavefront_advance(wavefront);
        if (!wavefront_trace_level(wavefront, &level)) {
            return false;
        }
    }
    wavefront_end_bounce(wavefront, level.bounce + 1);
    wavefront_set_results(wavefront, packets, count);
    return true;
}

/** @return Whether a camera ray is traced. @param sample Its index. */
static bool is_sample_traced(const CameraPacket *packets, unsigned sample) {
    unsigned i = sample % PACKET_RAYS;
    return mask_lane(packets[sample / PACKET_RAYS].lanes[i / LANES], (int)(i % LANES));
}

/** @return The rays of a vector whose camera rays are traced, as bits. @param count How many of the
 *          lanes hold rays. */
static unsigned resumed_lanes(const CameraPacket *packets, const integer *samples, unsigned count) {
    unsigned lanes = 0;
    for (unsigned lane = 0; lane < LANES && lane < count; lane++) {
        bool is_traced = is_sample_traced(packets, (unsigned)integer_at(samples, (int)lane));
        lanes |= (unsigned)is_traced << lane;
    }
    return lanes;
}

/** Queues rays that were kept. @param first Index of the first. @param end One more than that of
 *  the last. @return Their number. */
static unsigned kept_rays_queue(Wavefront *wavefront, const CameraPacket *packets, Child child,
                                unsigned first, unsigned end) {
    unsigned count = 0;
    for (; first < end; first += LANES) {
        RayVector rays = ray_columns_load(wavefront->kept[child].columns, RAY_COLUMN_FIRST + first,
                                          wavefront->interior_count);
        unsigned lanes = resumed_lanes(packets, &rays.sample, end - first);
        ray_queues_add(wavefront->level, child, lanes, &rays, wavefront->interior_count);
        count += (unsigned)__builtin_popcount(lanes);
    }
    return count;
}

/** Queues the rays of a bounce that were kept. @return Whether they found room. */
static bool wavefront_queue_kept(Wavefront *wavefront, const CameraPacket *packets, unsigned bounce,
                                 RayCounts *counts) {
    uint64_t *const numbers[CHILD_COUNT] = {&counts->reflection, &counts->refraction};
    for (int child = 0; child < CHILD_COUNT; child++) {
        const unsigned *kept_end = wavefront->kept_end[child];
        unsigned first = bounce > 1 ? kept_end[bounce - 1] : 0, end = kept_end[bounce];
        if (ray_queues_count(wavefront->level) + (end - first) > RAY_COLUMN_CAPACITY) {
            return wavefront_fail(wavefront);
        }
        *numbers[child] += kept_rays_queue(wavefront, packets, (Child)child, first, end);
    }
    return true;
}

bool wavefront_resume(Wavefront *wavefront, const TraceContext *context, CameraPacket *packets,
                      int count) {
    const unsigned kept_bounces = wavefront->bounces;
    Level level = {context, &packets[0].rays->packet.context, context->cutoff, 1};
    ray_queues_clear(wavefront->next);
    for (; level.bounce <= kept_bounces || ray_queues_count(wavefront->next) > 0; level.bounce++) {
        wavefront_advance(wavefront);
        if (level.bounce <= kept_bounces &&
            !wavefront_queue_kept(wavefront, packets, level.bounce, context->counts)) {
            return false;
        }
        if (!wavefront_trace_level(wavefront, &level)) {
            return false;
        }
    }
    wavefront_set_results(wavefront, packets, count);
    return true;
}
