/**
 * @file
 * @brief The engine: the tracer of this number type and width as an object.
 */
#include "trace/grid.h"
#include "trace/origin.h"

#include <stdlib.h>

/**
 * Weight below which a ray cannot change the picture: half a step of 8 bits, 1 / 510, at the dark
 * end of the sRGB curve, where the slope is 12.92.
 */
#define WEIGHT_CUTOFF 1.5e-4

/** @return The sky in the engine's number type. @param sky The sky. */
static Backdrop backdrop_of(const Sky *sky) {
    Color rise = {sky->zenith.red - sky->horizon.red, sky->zenith.green - sky->horizon.green,
                  sky->zenith.blue - sky->horizon.blue};
    bool is_gradient = rise.red != 0 || rise.green != 0 || rise.blue != 0;
    return (Backdrop){light3_of(scalar3_of(sky->horizon)), light3_of(scalar3_of(rise)),
                      is_gradient};
}

/** Gives a tracer back. See #Engine.release. @param tracer The tracer, or NULL. */
static void engine_release(Tracer *tracer) {
    if (tracer) {
        shape_list_release(&tracer->list);
        models_release(&tracer->models);
        textures_release(&tracer->textures);
        glass_release(&tracer->glass);
        free(tracer->surfaces);
        free(tracer->lamps);
        glow_release(&tracer->glow);
        free(tracer);
    }
}

/** @return Memory for things that hold vectors, zero. @param size Bytes. */
static void *vector_allocate(size_t size) {
    /** Bytes: the widest vector of any engine. */
    const size_t alignment = 64;
    return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

/** Takes camera, lights and size anew. See #Engine.look.
 *  @param tracer The tracer. @param scene The scene. @param width Pixels. @param height Pixels. */
static void engine_look(Tracer *tracer, const Scene *scene, int width, int height) {
    Vector3 way = vector3_scale(tracer->origin, -1);
    Camera camera = scene->camera;
    keyword_move(&camera_keyword, &camera, way);
    tracer->eye = eye_of(&camera, width, height);
    footprint_look(&tracer->models.footprint, &tracer->eye);
    glass_look(&tracer->glass, tracer->eye.origin);
    for (size_t i = 0; i < tracer->lamp_count; i++) {
        Light light = scene->lights[i];
        keyword_move(light_keyword_of(&light), &light, way);
        tracer->lamps[i] = lamp_of(&light, tracer->samples);
        tracer->is_soft = tracer->is_soft || tracer->lamps[i].is_soft;
    }
    glow_look(&tracer->glow, scene, tracer->origin);
}

/** @return A tracer whose shapes are there, without camera; NULL without memory.
 *  @param scene The scene. @param settings What is asked for. @param[out] error What is wrong. */
static Tracer *tracer_create(const Scene *scene, const TraceSettings *settings, Error *error) {
    Tracer *tracer = vector_allocate(sizeof *tracer);
    if (!tracer) {
        error_set(error, STATUS_FAILED, "no memory for a tracer");
        return NULL;
    }
    const Models *former = settings->former ? &settings->former->models : NULL;
    bool is_recursive = scene_has_mirrors(scene) || scene_has_glass(scene);
    *tracer = (Tracer){.backdrop = backdrop_of(&scene->sky),
                       .lamp_count = scene->light_count,
                       .depth = is_recursive ? settings->depth : 0,
                       .cutoff = (scalar)(settings->cutoff > 0 ? settings->cutoff : WEIGHT_CUTOFF),
                       .samples = settings->samples,
                       .shines = scene_has_highlights(scene),
                       .departure = {settings->offset, (scalar)settings->epsilon}};
    tracer->lamps = vector_allocate((scene->light_count + 1) * sizeof(Lamp));
    tracer->surfaces = vector_allocate(scene->material_count * sizeof(Surface));
    if (!tracer->lamps || !tracer->surfaces || !glow_init(&tracer->glow, scene, error) ||
        !textures_init(&tracer->textures, scene, error) ||
        !models_init(&tracer->models, scene, former, settings, error) ||
        !shape_list_init(&tracer->list, scene, &tracer->models, settings, error) ||
        !glass_init(&tracer->glass, scene, &tracer->list, settings)) {
        error_set(error, STATUS_FAILED, "no memory for the scene");
        engine_release(tracer);
        return NULL;
    }
    return tracer;
}

/** @return The same, with coordinates that begin elsewhere. @param scene The scene. @param settings
 *  What is asked for. @param origin Where in the scene. @param[out] error What is wrong. */
static Tracer *tracer_create_at(const Scene *scene, const TraceSettings *settings, Vector3 origin,
                                Error *error) {
    Scene *near = scene_moved(scene, shape_keywords, vector3_scale(origin, -1), error);
    Tracer *tracer = near ? tracer_create(near, settings, error) : NULL;
    if (tracer) {
        tracer->origin = origin;
    }
    scene_destroy(near);
    return tracer;
}

/** How often the origin is moved at most: very far away, where a scene's size is not seen in the
 *  engine's numbers, the first move only comes near. */
enum { ORIGIN_MOVES = 4 };

/** @return A tracer for a scene. See #Engine.prepare.
 *  @param scene The scene. @param settings What is asked for. @param[out] error What is wrong. */
static Tracer *engine_prepare(const Scene *scene, const TraceSettings *settings, Error *error) {
    Tracer *tracer = tracer_create(scene, settings, error);
    for (int moves = 0; tracer && moves < ORIGIN_MOVES; moves++) {
        Vector3 offset = origin_offset(&tracer->list);
        if (vector3_largest(offset) == 0) {
            break;
        }
        Vector3 origin = vector3_add(tracer->origin, offset);
        engine_release(tracer);
        tracer = tracer_create_at(scene, settings, origin, error);
    }
    if (tracer) {
        for (size_t i = 0; i < scene->material_count; i++) {
            tracer->surfaces[i] = surface_of(&scene->materials[i], scene->ambient);
        }
        glass_survey(&tracer->glass, tracer->surfaces);
        engine_look(tracer, scene, scene->image.width, scene->image.height);
    }
    return tracer;
}

/**
 * Begins a packet of rays from outside: none is active yet.
 * @param[out] packet  The packet.
 */
static void packet_clear(Packet *packet) {
    packet->wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Vector zero = {real_of(0), real_of(0), real_of(0)};
        packet->rays[v] = (Ray){zero, zero, zero};
        packet->active[v] = mask_of(false);
        packet->limit[v] = real_of(INFINITE);
    }
}

/**
 * Puts a ray into a packet; #packet_close makes it whole.
 * @param[in,out] packet  The packet.
 * @param i          Its place, 0 to #PACKET_RAYS - 1.
 * @param origin     Where it starts, in the engine's numbers.
 * @param direction  Which way, in the engine's numbers.
 */
INLINE void packet_put(Packet *packet, size_t i, const scalar origin[3],
                       const scalar direction[3]) {
    Ray *ray = &packet->rays[i / LANES];
    int lane = (int)(i % LANES);
    real_set_lane(&ray->origin.x, lane, origin[0]);
    real_set_lane(&ray->origin.y, lane, origin[1]);
    real_set_lane(&ray->origin.z, lane, origin[2]);
    real_set_lane(&ray->direction.x, lane, direction[0]);
    real_set_lane(&ray->direction.y, lane, direction[1]);
    real_set_lane(&ray->direction.z, lane, direction[2]);
    mask_set_lane(&packet->active[i / LANES], lane, true);
}

/** Works out what follows from the rays that were put in. @param[in,out] packet The packet. */
static void packet_close(Packet *packet) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        packet->rays[v] = ray_of(packet->rays[v].origin, packet->rays[v].direction);
    }
}

/** Makes a packet of plain rays. @param rays The rays. @param count How many, at most
 *  #PACKET_RAYS. @param zero Where the tracer's coordinates begin. @param[out] packet The packet.
 */
static void plain_pack(const PlainRay *rays, size_t count, Vector3 zero, Packet *packet) {
    packet_clear(packet);
    for (size_t i = 0; i < count; i++) {
        const double *o = rays[i].origin, *d = rays[i].direction;
        const scalar origin[3] = {(scalar)(o[0] - zero.x), (scalar)(o[1] - zero.y),
                                  (scalar)(o[2] - zero.z)};
        const scalar direction[3] = {(scalar)d[0], (scalar)d[1], (scalar)d[2]};
        packet_put(packet, i, origin, direction);
    }
    packet_close(packet);
    packet->wants_points = false;
}

/** Makes a packet of rays asked in full. @param queries The rays. @param count How many, at most
 *  #PACKET_RAYS. @param zero Where the tracer's coordinates begin. @param[out] packet The packet.
 */
static void queries_pack(const RayQuery *queries, size_t count, Vector3 zero, Packet *packet) {
    packet_clear(packet);
    for (size_t i = 0; i < count; i++) {
        const Quadruple *o = queries[i].origin, *d = queries[i].direction;
        const scalar origin[3] = {(scalar)(o[0] - (Quadruple)zero.x),
                                  (scalar)(o[1] - (Quadruple)zero.y),
                                  (scalar)(o[2] - (Quadruple)zero.z)};
        const scalar direction[3] = {(scalar)d[0], (scalar)d[1], (scalar)d[2]};
        packet_put(packet, i, origin, direction);
    }
    packet_close(packet);
}

/** @return How many of the rays from `done` on fill the next packet. @param count All rays.
 *  @param done Those already traced. */
static size_t packet_fill(size_t count, size_t done) {
    return count - done < PACKET_RAYS ? count - done : PACKET_RAYS;
}

/** Finds the nearest hits of any rays. See #Engine.nearest. @param tracer The tracer.
 *  @param count How many. @param rays The rays. @param[out] shapes What they meet.
 *  @param[out] distances How far. */
static void engine_nearest(const Tracer *tracer, size_t count, const PlainRay *rays, int *shapes,
                           double *distances) {
    for (size_t done = 0; done < count; done += PACKET_RAYS) {
        Packet packet;
        Hit hits[PACKET_VECTORS];
        size_t fill = packet_fill(count, done);
        plain_pack(rays + done, fill, tracer->origin, &packet);
        shape_list_nearest(&tracer->list, &packet, hits);
        for (size_t i = 0; i < fill; i++) {
            shapes[done + i] = integer_lane(hits[i / LANES].shape, (int)(i % LANES));
            distances[done + i] = (double)real_lane(hits[i / LANES].distance, (int)(i % LANES));
        }
    }
}

/** Finds which of any rays meet anything. See #Engine.shadowed. @param tracer The tracer.
 *  @param count How many. @param rays The rays. @param[out] shadowed Whether each does. */
static void engine_shadowed(const Tracer *tracer, size_t count, const PlainRay *rays,
                            bool *shadowed) {
    for (size_t done = 0; done < count; done += PACKET_RAYS) {
        Packet packet;
        mask blocked[PACKET_VECTORS];
        size_t fill = packet_fill(count, done);
        plain_pack(rays + done, fill, tracer->origin, &packet);
        shape_list_blocked(&tracer->list, &packet, blocked);
        for (size_t i = 0; i < fill; i++) {
            shadowed[done + i] = mask_lane(blocked[i / LANES], (int)(i % LANES));
        }
    }
}

/** @return One lane, exactly, in the widest type. @param x Numbers. @param i The lane. */
INLINE Quadruple widest_lane(real x, int i) {
    return (Quadruple)real_lane(x, i);
}

/**
 * @return One lane of a hit, as an answer.
 * @param zero     Where the tracer's coordinates begin.
 * @param hit      The hit.
 * @param blocked  Which lanes `is_blocking` called blocked.
 * @param i        The lane.
 */
static RayAnswer answer_of(Vector3 zero, const Hit *hit, mask blocked, int i) {
    const Vector *p = &hit->point, *n = &hit->normal;
    return (RayAnswer){.shape = integer_lane(hit->shape, i),
                       .blocked = mask_lane(blocked, i),
                       .distance = widest_lane(hit->distance, i),
                       .point = {widest_lane(p->x, i) + (Quadruple)zero.x,
                                 widest_lane(p->y, i) + (Quadruple)zero.y,
                                 widest_lane(p->z, i) + (Quadruple)zero.z},
                       .normal = {widest_lane(n->x, i), widest_lane(n->y, i), widest_lane(n->z, i)},
                       .error = widest_lane(hit->error, i)};
}

/**
 * Adds to an answer where on a picture its point lies.
 * @param tracer  The tracer.
 * @param hit     The hit.
 * @param i       The lane.
 * @param[in,out] answer  The answer.
 */
static void answer_place(const Tracer *tracer, const Hit *hit, int i, RayAnswer *answer) {
    if (answer->shape >= 0) {
        mask lane = mask_of(false);
        mask_set_lane(&lane, i, true);
        TexturePlace place = shape_texture_place(tracer->list.shapes[answer->shape], hit, lane);
        answer->place[0] = widest_lane(place.u, i);
        answer->place[1] = widest_lane(place.v, i);
    }
}

/** Answers any rays in full. See #Engine.intersect. @param tracer The tracer. @param count How
 * many.
 *  @param queries The rays. @param[out] answers The answers. */
static void engine_intersect(const Tracer *tracer, size_t count, const RayQuery *queries,
                             RayAnswer *answers) {
    for (size_t done = 0; done < count; done += PACKET_RAYS) {
        Packet packet;
        Hit hits[PACKET_VECTORS];
        mask blocked[PACKET_VECTORS];
        size_t fill = packet_fill(count, done);
        queries_pack(queries + done, fill, tracer->origin, &packet);
        shape_list_nearest(&tracer->list, &packet, hits);
        shape_list_blocked(&tracer->list, &packet, blocked);
        for (size_t i = 0; i < fill; i++) {
            answers[done + i] =
                answer_of(tracer->origin, &hits[i / LANES], blocked[i / LANES], (int)(i % LANES));
            answer_place(tracer, &hits[i / LANES], (int)(i % LANES), &answers[done + i]);
        }
    }
}

/** Finds the box of all bounded shapes. See #Engine.bounds. @param tracer The tracer.
 *  @param[out] low Its lowest corner. @param[out] high Its highest. */
static void engine_bounds(const Tracer *tracer, Vector3 *low, Vector3 *high) {
    origin_bounds(&tracer->list, low, high);
    *low = vector3_add(*low, tracer->origin);
    *high = vector3_add(*high, tracer->origin);
}

/** Says what a tracer was made of. See #Engine.contents. @param tracer The tracer. @return It. */
static TracerContents engine_contents(const Tracer *tracer) {
    const ShapeList *list = &tracer->list;
    TracerContents contents = {.listed = list->loose_count,
                               .planted = list->count - list->loose_count,
                               .tree_from = list->tree_from};
    contents.stalled = stalls_count(&tracer->models.stalls);
    for (size_t i = 0; i < tracer->models.count; i++) {
        const Model *model = tracer->models.all[i];
        contents.triangles += model ? model->triangle_count : 0;
        contents.triangle_bytes += model ? model_size(model) : 0;
    }
    return contents;
}

/** This engine. */
extern const Engine ENGINE;

const Engine ENGINE = {
    .name = ENGINE_NAME,
    .lanes = LANES,
    .mantissa_bits = MANTISSA_BITS,
    .shape_keywords = shape_keywords,
    .prepare = engine_prepare,
    .look = engine_look,
    .trace = grid_trace,
    .cast = grid_cast,
    .nearest = engine_nearest,
    .shadowed = engine_shadowed,
    .intersect = engine_intersect,
    .bounds = engine_bounds,
    .contents = engine_contents,
    .measure = shape_measure,
    .release = engine_release,
};
