/**
 * @file
 * @brief Wavefronts.
 */
#include "trace/tracer/wavefront.h"

#include "trace/tracer/secondary_rays.h"

#include <stdlib.h>
#include <string.h>

/** Camera rays that are traced side by side, at most. */
enum { WAVEFRONT_SAMPLES = WAVEFRONT_PACKETS * PACKET_RAYS };

/* Memory of a wavefront, one for each thread that traces; only what is used is ever touched. Camera
   rays that need more are traced in smaller groups, so the sizes change the time alone. */

/** Most nodes: the rays below all camera rays of a wavefront. */
enum { NODES_MAXIMUM = 1 << 17 };
/** Most rays of one level. */
enum { QUEUE_MAXIMUM = 1 << 14 };
/** Most rays that are kept for wavefront_resume(). */
enum { KEPT_MAXIMUM = 1 << 15 };

/** A ray that waits to be traced. */
typedef struct QueuedRay {
    Vec3s origin;                             /**< Its origin. */
    Vec3s direction;                          /**< Its unit direction. */
    Rgbs throughput;                          /**< See #RayState. */
    int32_t interior[INTERIOR_LIST_CAPACITY]; /**< The shapes that it is inside of. */
    int32_t turns;                            /**< See #RayState. */
    uint32_t node;                            /**< Where its colour goes. */
    uint16_t sample;                          /**< Index of its camera ray. */
    uint16_t bounce;                          /**< See #SampleContext. */
    bool is_refracted;                        /**< Whether it is refracted, not reflected. */
} QueuedRay;

/** Instead of the index of a node: there is none. */
static const uint32_t NODE_NONE = UINT32_MAX;

/** A ray in the tree of its camera ray. Rays that go straight on at an overridden surface stay in
 *  one node. Nodes come after their parents, and the reflected ray after the refracted one. Camera
 *  rays below which nothing is traced have no node. */
typedef struct PathNode {
    Rgbs weight;      /**< The factor of its colour in that of its parent. */
    Rgbs local_color; /**< The colour of its surface alone; black where it was not traced. */
    Rgbs dropped;     /**< What ended at its surface: see #Losses. Its own throughput, where it was
                           not traced. */
    Rgbs guarded;     /**< See #Losses. */
    scalar rays;      /**< Rays in this node beyond the first; -1 where it was not traced. */
    scalar sum_rays;  /**< #rays, and those below. */
    Rgbs sum_color;   /**< Its colour, with that of the rays below. */
    Rgbs sum_dropped; /**< #dropped, with that of the rays below. */
    Rgbs sum_guarded; /**< #guarded, with that of the rays below. */
    uint32_t parent;  /**< Index of its parent; #NODE_NONE for a camera ray. */
} PathNode;

/** The rays of a level. Refracted rays fill it from the front, reflected ones from the back:
 *  neighbours stay together. */
typedef struct RayQueue {
    QueuedRay *rays; /**< #QUEUE_MAXIMUM rays; owned. */
    unsigned front;  /**< Number of rays at the front. */
    unsigned back;   /**< Number of rays at the back. */
} RayQueue;

struct Wavefront {
    PathNode *nodes;       /**< The nodes; owned. */
    unsigned node_count;   /**< Number of nodes. */
    unsigned sample_limit; /**< See wavefront_sample_limit(). */
    unsigned sample_count; /**< Number of camera rays that were traced last. */
    bool had_ample_room;   /**< Whether those, and all that was resumed of them, used less than a
                                quarter of each array. */
    RayQueue level;        /**< The rays that are traced now. */
    RayQueue next;         /**< The rays of the next level. */
    QueuedRay *kept;     /**< Rays for wavefront_resume(), in the order of their bounces; owned. */
    unsigned kept_count; /**< Number of those. */
    uint32_t pixel_ids[WAVEFRONT_SAMPLES]; /**< See #SampleContext, per camera ray. */
    uint32_t roots[WAVEFRONT_SAMPLES];     /**< Nodes of the camera rays, or #NODE_NONE. */
    unsigned root_lanes[WAVEFRONT_PACKETS][PACKET_VECTORS]; /**< Lanes of camera rays with a node,
                                                                 as bits. */
};

/* --- memory ----------------------------------------------------------------------------------- */

Wavefront *wavefront_create(void) {
    Wavefront *wavefront = malloc(sizeof *wavefront);
    if (!wavefront) {
        return NULL;
    }
    wavefront->sample_limit = WAVEFRONT_SAMPLES;
    wavefront->sample_count = 0;
    wavefront->had_ample_room = false;
    wavefront->nodes = malloc(NODES_MAXIMUM * sizeof *wavefront->nodes);
    wavefront->level.rays = malloc(QUEUE_MAXIMUM * sizeof *wavefront->level.rays);
    wavefront->next.rays = malloc(QUEUE_MAXIMUM * sizeof *wavefront->next.rays);
    wavefront->kept = malloc(KEPT_MAXIMUM * sizeof *wavefront->kept);
    if (!wavefront->nodes || !wavefront->level.rays || !wavefront->next.rays || !wavefront->kept) {
        wavefront_destroy(wavefront);
        return NULL;
    }
    return wavefront;
}

void wavefront_destroy(Wavefront *wavefront) {
    if (wavefront) {
        free(wavefront->nodes);
        free(wavefront->level.rays);
        free(wavefront->next.rays);
        free(wavefront->kept);
        free(wavefront);
    }
}

unsigned wavefront_sample_limit(const Wavefront *wavefront) {
    return wavefront->sample_limit;
}

/** @return The number of rays of a level. */
static unsigned ray_queue_count(const RayQueue *queue) {
    return queue->front + queue->back;
}

/** @return The place of a ray of a level. @param index Below ray_queue_count(). */
static const QueuedRay *ray_queue_at(const RayQueue *queue, unsigned index) {
    return &queue->rays[index < queue->front ? index : QUEUE_MAXIMUM - 1 - (index - queue->front)];
}

/** @return The place of a new ray. @param at_front Whether it comes to the front. */
static QueuedRay *ray_queue_add(RayQueue *queue, bool at_front) {
    return &queue->rays[at_front ? queue->front++ : QUEUE_MAXIMUM - 1 - queue->back++];
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
    wavefront->had_ample_room = wavefront->had_ample_room &&
                                wavefront->node_count < NODES_MAXIMUM / 4 &&
                                ray_queue_count(&wavefront->level) < QUEUE_MAXIMUM / 4 &&
                                wavefront->kept_count < KEPT_MAXIMUM / 4;
}

/** @return Whether the rays that start at the surfaces of a packet find room. */
static bool wavefront_has_room(const Wavefront *wavefront) {
    const unsigned most = 2 * PACKET_RAYS;
    return wavefront->node_count + most <= NODES_MAXIMUM &&
           ray_queue_count(&wavefront->next) + most <= QUEUE_MAXIMUM &&
           wavefront->kept_count + most <= KEPT_MAXIMUM;
}

/* --- from packets to the queue ---------------------------------------------------------------- */

/** The rays of a packet in the wavefront. */
typedef struct PacketSource {
    uint32_t nodes[PACKET_RAYS];   /**< Their nodes. */
    uint16_t samples[PACKET_RAYS]; /**< Their camera rays. */
} PacketSource;

/** @return One lane of a vector in memory. */
INLINE Vec3s vec3_at(const Vec3 *v, int lane) {
    return (Vec3s){real_at(&v->x, lane), real_at(&v->y, lane), real_at(&v->z, lane)};
}

/** @return One lane of a colour in memory. */
INLINE Rgbs rgb_at(const Rgb *c, int lane) {
    return (Rgbs){real_at(&c->red, lane), real_at(&c->green, lane), real_at(&c->blue, lane)};
}

/** Adds a colour to a sum. */
INLINE void rgbs_add_to(Rgbs *sum, Rgbs c) {
    sum->red += c.red;
    sum->green += c.green;
    sum->blue += c.blue;
}

/** Sets one lane of a colour in memory. */
INLINE void rgb_set_lane(Rgb *c, int lane, Rgbs value) {
    real_set_lane(&c->red, lane, value.red);
    real_set_lane(&c->green, lane, value.green);
    real_set_lane(&c->blue, lane, value.blue);
}

/** @return A new node. */
static uint32_t node_add(Wavefront *wavefront, uint32_t parent, Rgbs weight) {
    uint32_t index = wavefront->node_count++;
    PathNode *node = &wavefront->nodes[index];
    // The sums come later. One by one: gcc clears a whole node by a slow string instruction.
    node->weight = weight;
    node->local_color = node->dropped = node->guarded = (Rgbs){0};
    node->rays = 0;
    node->parent = parent;
    return index;
}

/** Adds the nodes of camera rays at whose surfaces rays start. @param first Index of the first
 *  camera ray of the packet. @param[out] source The nodes. */
static void roots_add(Wavefront *wavefront, unsigned first, const CameraPacket *packet,
                      const ScatteredRays *scattered, PacketSource *source) {
    unsigned *root_lanes = wavefront->root_lanes[first / PACKET_RAYS];
    for (int v = 0; v < PACKET_VECTORS; v++) {
        root_lanes[v] = mask_bits(scattered->refracted.rays.packet.active[v] |
                                  scattered->reflected.rays.packet.active[v]);
        for (unsigned left = root_lanes[v]; left; left &= left - 1) {
            int lane = __builtin_ctz(left), i = v * LANES + lane;
            uint32_t index = node_add(wavefront, NODE_NONE, (Rgbs){0});
            PathNode *node = &wavefront->nodes[index];
            node->local_color = rgb_at(&packet->colors[v], lane);
            node->dropped = rgb_at(&packet->losses.dropped[v], lane);
            node->guarded = rgb_at(&packet->losses.guarded[v], lane);
            wavefront->roots[first + (unsigned)i] = source->nodes[i] = index;
            source->samples[i] = (uint16_t)(first + (unsigned)i);
        }
    }
}

/** Stores what the rays of a packet saw, without the rays that start there. */
static void nodes_store(Wavefront *wavefront, const Packet *packet, const PacketSource *source,
                        const Rgb *colors, const Losses *losses) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        for (unsigned left = mask_bits(packet->active[v]); left; left &= left - 1) {
            int lane = __builtin_ctz(left);
            PathNode *node = &wavefront->nodes[source->nodes[v * LANES + lane]];
            node->local_color = rgb_at(&colors[v], lane);
            rgbs_add_to(&node->dropped, rgb_at(&losses->dropped[v], lane));
            rgbs_add_to(&node->guarded, rgb_at(&losses->guarded[v], lane));
        }
    }
}

/** Stores a ray. */
INLINE void queued_ray_store(QueuedRay *ray, const SecondaryRays *secondary, int v, int lane,
                             uint32_t node, uint16_t sample) {
    const RayState *rays = &secondary->rays;
    ray->origin = vec3_at(&rays->packet.rays[v].origin, lane);
    ray->direction = vec3_at(&rays->packet.rays[v].direction, lane);
    ray->throughput = rgb_at(&rays->throughput[v], lane);
    for (int i = 0; i < INTERIOR_LIST_CAPACITY; i++) {
        ray->interior[i] = integer_at(&rays->interior[v].shapes[i], lane);
    }
    ray->turns = integer_at(&rays->turns[v], lane);
    ray->node = node;
    ray->sample = sample;
    ray->bounce = (uint16_t)rays->packet.context.bounce;
    ray->is_refracted = secondary->type == RAY_REFRACTION;
}

/**
 * Queues the rays that start at the surfaces of a packet, or keeps them.
 * @param cutoff  Rays of less throughput are kept.
 * @param turns  The turns of the rays that hit the surfaces.
 */
static void secondary_rays_queue(Wavefront *wavefront, scalar cutoff, const PacketSource *source,
                                 const integer *turns, const SecondaryRays *secondary,
                                 RayCounts *counts) {
    const RayState *rays = &secondary->rays;
    bool is_refracted = secondary->type == RAY_REFRACTION;
    uint64_t *count = is_refracted ? &counts->refraction : &counts->reflection;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        unsigned left = mask_bits(rays->packet.active[v]);
        // Only overridden surfaces count no turn; the weight is 1 there, and the colour black.
        unsigned passing = left & mask_bits(rays->turns[v] == turns[v]);
        unsigned heavy = mask_bits(rgb_max(rays->throughput[v]) >= cutoff);
        for (; left; left &= left - 1) {
            int lane = __builtin_ctz(left), i = v * LANES + lane;
            uint32_t node = source->nodes[i];
            if (passing >> lane & 1) {
                wavefront->nodes[node].rays++;
            } else {
                node = node_add(wavefront, node, rgb_at(&secondary->weights[v], lane));
            }
            QueuedRay *ray;
            if (heavy >> lane & 1) {
                ray = ray_queue_add(&wavefront->next, is_refracted);
                ++*count;
            } else {
                ray = &wavefront->kept[wavefront->kept_count++];
                wavefront->nodes[node].dropped = rgb_at(&rays->throughput[v], lane);
                wavefront->nodes[node].rays = -1;
            }
            queued_ray_store(ray, secondary, v, lane, node, source->samples[i]);
        }
    }
}

/** Queues the rays that start at the surfaces of a packet. See secondary_rays_queue(). */
static void scattered_rays_queue(Wavefront *wavefront, scalar cutoff, const PacketSource *source,
                                 const RayState *rays, const ScatteredRays *scattered,
                                 RayCounts *counts) {
    secondary_rays_queue(wavefront, cutoff, source, rays->turns, &scattered->refracted, counts);
    secondary_rays_queue(wavefront, cutoff, source, rays->turns, &scattered->reflected, counts);
}

/**
 * Traces a packet of queued rays, and queues the rays that start at its surfaces.
 * @param cutoff  Rays of less throughput are kept.
 * @param context  Its cutoff is the least throughput of rays that are kept.
 */
static __attribute__((noinline)) void wavefront_trace_packet(Wavefront *wavefront, scalar cutoff,
                                                             const TraceContext *context,
                                                             const RayState *rays,
                                                             const PacketSource *source) {
    ScatteredRays scattered;
    Rgb colors[PACKET_VECTORS];
    Losses losses;
    losses_clear(&losses);
    bool is_scattered = shade_and_scatter(context, rays, &scattered, colors, &losses);
    nodes_store(wavefront, &rays->packet, source, colors, &losses);
    if (is_scattered) {
        scattered_rays_queue(wavefront, cutoff, source, rays, &scattered, context->counts);
    }
}

/* --- from the queue to packets ---------------------------------------------------------------- */

/** A packet made of queued rays. */
typedef struct GatheredPacket {
    RayState rays;                         /**< The rays. */
    InteriorList interior[PACKET_VECTORS]; /**< The shapes that they are inside of. */
    uint32_t pixel_ids[PACKET_RAYS];       /**< See #SampleContext. */
    PacketSource source;                   /**< Their nodes. */
} GatheredPacket;

/** Loads a ray. */
INLINE void queued_ray_load(const QueuedRay *ray, GatheredPacket *gathered, int v, int lane) {
    RayState *rays = &gathered->rays;
    Ray *to = &rays->packet.rays[v];
    real_set_lane(&to->origin.x, lane, ray->origin.x);
    real_set_lane(&to->origin.y, lane, ray->origin.y);
    real_set_lane(&to->origin.z, lane, ray->origin.z);
    real_set_lane(&to->direction.x, lane, ray->direction.x);
    real_set_lane(&to->direction.y, lane, ray->direction.y);
    real_set_lane(&to->direction.z, lane, ray->direction.z);
    rgb_set_lane(&rays->throughput[v], lane, ray->throughput);
    integer_set_lane(&rays->turns[v], lane, ray->turns);
    for (int i = 0; i < INTERIOR_LIST_CAPACITY; i++) {
        integer_set_lane(&gathered->interior[v].shapes[i], lane, ray->interior[i]);
    }
}

/**
 * Makes a packet of rays of the current level. Unused lanes of the last vector get a copy of a ray,
 * which is safe to compute with.
 * @param first  Index of the first ray.
 * @param count  Number of rays, 1 to #PACKET_RAYS.
 */
static void packet_gather(const Wavefront *wavefront, unsigned first, unsigned count,
                          GatheredPacket *gathered) {
    Packet *packet = &gathered->rays.packet;
    for (unsigned v = 0; v < PACKET_VECTORS; v++) {
        unsigned done = v * LANES, fill = count <= done ? 0 : count - done;
        packet->active[v] = fill >= LANES ? mask_of(true) : mask_of_bits((1u << fill) - 1);
        packet->limit[v] = real_of(INFINITE);
        gathered->rays.turns[v] = integer_of(0); // Counted on in unused vectors, too.
        for (unsigned lane = 0; lane < LANES && fill > 0; lane++) {
            unsigned i = done + lane;
            const QueuedRay *ray =
                ray_queue_at(&wavefront->level, first + (lane < fill ? i : done));
            queued_ray_load(ray, gathered, (int)v, (int)lane);
            gathered->source.nodes[i] = ray->node;
            gathered->source.samples[i] = ray->sample;
            gathered->pixel_ids[i] = wavefront->pixel_ids[ray->sample];
        }
        if (fill > 0) {
            packet->rays[v] = ray_of(packet->rays[v].origin, packet->rays[v].direction);
        }
    }
}

/** Traces the rays of the current level. @param bounce See #SampleContext. @return Whether memory
 *  sufficed. */
static bool wavefront_trace_level(Wavefront *wavefront, scalar cutoff, const TraceContext *context,
                                  const SampleContext *sample_context, unsigned bounce) {
    unsigned total = ray_queue_count(&wavefront->level);
    wavefront_note_room(wavefront);
    for (unsigned first = 0; first < total; first += PACKET_RAYS) {
        GatheredPacket gathered;
        Packet *packet = &gathered.rays.packet;
        if (!wavefront_has_room(wavefront)) {
            return wavefront_fail(wavefront);
        }
        packet_gather(wavefront, first, total - first < PACKET_RAYS ? total - first : PACKET_RAYS,
                      &gathered);
        gathered.rays.interior = gathered.interior;
        packet->wants_points = true;
        packet->context = *sample_context;
        packet->context.pixel_ids = sample_context->pixel_ids ? gathered.pixel_ids : NULL;
        packet->context.bounce = bounce;
        wavefront_trace_packet(wavefront, cutoff, context, &gathered.rays, &gathered.source);
    }
    return true;
}

/** Makes the next level the current one. */
static void wavefront_advance(Wavefront *wavefront) {
    RayQueue done = wavefront->level;
    done.front = done.back = 0;
    wavefront->level = wavefront->next;
    wavefront->next = done;
}

/* --- sums ------------------------------------------------------------------------------------- */

/** Adds up colours and losses, from the leaves to the camera rays. */
static void nodes_add_up(PathNode *nodes, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        PathNode *node = &nodes[i];
        node->sum_color = node->local_color;
        node->sum_dropped = node->dropped;
        node->sum_guarded = node->guarded;
        node->sum_rays = node->rays;
    }
    for (unsigned i = count; i-- > 0;) {
        const PathNode *node = &nodes[i];
        if (node->parent == NODE_NONE) {
            continue;
        }
        PathNode *parent = &nodes[node->parent];
        parent->sum_color.red += node->weight.red * node->sum_color.red;
        parent->sum_color.green += node->weight.green * node->sum_color.green;
        parent->sum_color.blue += node->weight.blue * node->sum_color.blue;
        rgbs_add_to(&parent->sum_dropped, node->sum_dropped);
        rgbs_add_to(&parent->sum_guarded, node->sum_guarded);
        parent->sum_rays += node->sum_rays + 1;
    }
}

/** Sets the results of the camera rays of a packet that have nodes. @param p Its index. */
static void camera_packet_set_results(const Wavefront *wavefront, int p, CameraPacket *packet) {
    const uint32_t *roots = wavefront->roots + p * PACKET_RAYS;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        unsigned left = mask_bits(packet->lanes[v]) & wavefront->root_lanes[p][v];
        for (; left; left &= left - 1) {
            int lane = __builtin_ctz(left);
            const PathNode *node = &wavefront->nodes[roots[v * LANES + lane]];
            rgb_set_lane(&packet->colors[v], lane, node->sum_color);
            rgb_set_lane(&packet->losses.dropped[v], lane, node->sum_dropped);
            rgb_set_lane(&packet->losses.guarded[v], lane, node->sum_guarded);
            real_set_lane(&packet->losses.rays[v], lane, node->sum_rays);
        }
    }
}

/** Sets the results of all camera rays that are traced. */
static void wavefront_set_results(Wavefront *wavefront, CameraPacket *packets, int count) {
    wavefront_note_room(wavefront);
    nodes_add_up(wavefront->nodes, wavefront->node_count);
    for (int p = 0; p < count; p++) {
        camera_packet_set_results(wavefront, p, &packets[p]);
    }
}

/* --- passes ----------------------------------------------------------------------------------- */

/** Begins the trees of the camera rays of packets. */
static void wavefront_begin(Wavefront *wavefront, const CameraPacket *packets, int count) {
    wavefront_raise_limit(wavefront);
    wavefront->sample_count = 0;
    wavefront->had_ample_room = true;
    wavefront->node_count = 0;
    wavefront->kept_count = 0;
    wavefront->level.front = wavefront->level.back = 0;
    wavefront->next.front = wavefront->next.back = 0;
    memset(wavefront->root_lanes, 0, sizeof wavefront->root_lanes);
    for (int p = 0; p < count; p++) {
        wavefront->sample_count += camera_packet_count(&packets[p]);
        const uint32_t *pixel_ids = packets[p].rays->packet.context.pixel_ids;
        for (int i = 0; i < PACKET_RAYS; i++) {
            wavefront->pixel_ids[p * PACKET_RAYS + i] = pixel_ids ? pixel_ids[i] : 0;
        }
    }
}

/** Traces the camera rays of a packet, and queues the rays that start at their surfaces.
 *  @param first Index of the first. See wavefront_trace_packet(). */
static __attribute__((noinline)) void camera_packet_trace(Wavefront *wavefront, scalar cutoff,
                                                          const TraceContext *context,
                                                          unsigned first, CameraPacket *packet) {
    ScatteredRays scattered;
    Rgb colors[PACKET_VECTORS];
    Losses losses;
    RayState *rays = packet->rays;
    mask active[PACKET_VECTORS];
    memcpy(active, rays->packet.active, sizeof active);
    memcpy(rays->packet.active, packet->lanes, sizeof active);
    if (packet_active_count(&rays->packet) > 0) {
        losses_clear(&losses);
        bool is_scattered = shade_and_scatter(context, rays, &scattered, colors, &losses);
        results_replace(packet->lanes, colors, &losses, packet->colors, &packet->losses);
        if (is_scattered) {
            PacketSource source;
            roots_add(wavefront, first, packet, &scattered, &source);
            scattered_rays_queue(wavefront, cutoff, &source, rays, &scattered, context->counts);
        }
    }
    memcpy(rays->packet.active, active, sizeof active);
}

bool wavefront_trace(Wavefront *wavefront, const TraceContext *context, scalar least_throughput,
                     CameraPacket *packets, int count) {
    TraceContext keeping = *context;
    keeping.cutoff = least_throughput;
    wavefront_begin(wavefront, packets, count);
    for (int p = 0; p < count; p++) {
        camera_packet_trace(wavefront, context->cutoff, &keeping, (unsigned)p * PACKET_RAYS,
                            &packets[p]);
    }
    for (unsigned bounce = 1; ray_queue_count(&wavefront->next) > 0; bounce++) {
        wavefront_advance(wavefront);
        if (!wavefront_trace_level(wavefront, context->cutoff, &keeping,
                                   &packets[0].rays->packet.context, bounce)) {
            return false;
        }
    }
    wavefront_set_results(wavefront, packets, count);
    return true;
}

/** Queues a ray that was kept. */
static void kept_ray_queue(Wavefront *wavefront, const QueuedRay *ray, RayCounts *counts) {
    PathNode *node = &wavefront->nodes[ray->node];
    node->dropped = (Rgbs){0};
    node->rays = 0;
    *ray_queue_add(&wavefront->level, ray->is_refracted) = *ray;
    *(ray->is_refracted ? &counts->refraction : &counts->reflection) += 1;
}

/** @return Whether a camera ray is traced. @param sample Its index. */
static bool is_sample_traced(const CameraPacket *packets, unsigned sample) {
    unsigned i = sample % PACKET_RAYS;
    return mask_lane(packets[sample / PACKET_RAYS].lanes[i / LANES], (int)(i % LANES));
}

bool wavefront_resume(Wavefront *wavefront, const TraceContext *context, CameraPacket *packets,
                      int count) {
    const QueuedRay *kept = wavefront->kept, *const end = kept + wavefront->kept_count;
    wavefront->kept_count = 0;
    wavefront->next.front = wavefront->next.back = 0;
    for (unsigned bounce = 1; kept < end || ray_queue_count(&wavefront->next) > 0; bounce++) {
        wavefront_advance(wavefront);
        for (; kept < end && kept->bounce == bounce; kept++) {
            if (ray_queue_count(&wavefront->level) == QUEUE_MAXIMUM) {
                return wavefront_fail(wavefront);
            }
            if (is_sample_traced(packets, kept->sample)) {
                kept_ray_queue(wavefront, kept, context->counts);
            }
        }
        if (!wavefront_trace_level(wavefront, context->cutoff, context,
                                   &packets[0].rays->packet.context, bounce)) {
            return false;
        }
    }
    wavefront_set_results(wavefront, packets, count);
    return true;
}
