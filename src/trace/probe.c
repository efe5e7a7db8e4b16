/**
 * @file
 * @brief Noting the rays of one pixel.
 */
#include "trace/probe.h"

#include "trace/glow.h"

#include <stdlib.h>

/** Rays for which there is room at first. */
enum { PROBE_FIRST = 64 };

/* --- out of the engine's numbers -------------------------------------------------------------- */

/** @return The vector in the first lane. @param v Vectors. */
static Vector3 vector_first(Vector v) {
    return (Vector3){(double)real_lane(v.x, 0), (double)real_lane(v.y, 0),
                     (double)real_lane(v.z, 0)};
}

/** @return The light in the first lane. @param light Light. */
static Color light_first(Light3 light) {
    return (Color){(double)real_lane(light.red, 0), (double)real_lane(light.green, 0),
                   (double)real_lane(light.blue, 0)};
}

/** @return The number in the first lane. @param x Numbers. */
static double real_first(real x) {
    return (double)real_lane(x, 0);
}

/** @return A length in units of the last place of a number of the engine. @param length It.
 *  @param x The number. */
static double in_ulps(double length, double x) {
    int exponent;
    frexp(x, &exponent);
    return x > 0 ? length / ldexp(1, exponent - MANTISSA_BITS) : 0;
}

/* --- the list of rays ------------------------------------------------------------------------- */

/** Makes room for one more ray. @param[in,out] probe The tree. @return false without memory. */
static bool probe_make_room(Probe *probe) {
    if (probe->count < probe->capacity) {
        return true;
    }
    size_t capacity = probe->capacity ? 2 * probe->capacity : PROBE_FIRST;
    ProbeRay *rays =
        capacity <= PROBE_RAYS_MAXIMUM ? realloc(probe->rays, capacity * sizeof *rays) : NULL;
    if (rays) {
        probe->rays = rays;
        probe->capacity = capacity;
    }
    return rays != NULL;
}

/** Adds a ray as a child of the current one. @param[in,out] probe The tree. @param kind What it is.
 *  @param ray Where it goes, in the first lane. @param limit How far, in lengths of its direction.
 *  @return It; NULL without memory. */
static ProbeRay *probe_add(Probe *probe, ProbeKind kind, const Ray *ray, real limit) {
    probe->is_short = probe->is_short || !probe_make_room(probe);
    if (probe->is_short) {
        return NULL;
    }
    bool is_first = probe->count == 0;
    Vector3 way = vector_first(ray->direction);
    ProbeRay *added = &probe->rays[probe->count++];
    *added = (ProbeRay){.parent = is_first ? -1 : probe->current,
                        .kind = kind,
                        .depth = is_first ? 0 : probe->rays[probe->current].depth + 1,
                        .origin = vector_first(ray->origin),
                        .direction = vector3_normalize(vector3_scaled(way)),
                        .limit = real_first(limit) * vector3_length(way),
                        .shape = -1,
                        .lamp = -1,
                        .distance = HUGE_VAL};
    return added;
}

/** @return The ray that is being followed; NULL where memory did not do. @param probe The tree. */
static ProbeRay *probe_current(const Probe *probe) {
    return probe->is_short ? NULL : &probe->rays[probe->current];
}

void probe_send(Probe *probe, ProbeKind kind, const Packet *packet, Light3 share, real weight) {
    ProbeRay *ray = probe_add(probe, kind, &packet->rays[0], packet->limit[0]);
    if (ray) {
        ray->share = light_first(share);
        ray->weight = real_first(weight);
        probe->current = (int)(ray - probe->rays);
    }
}

void probe_return(Probe *probe, Light3 color) {
    ProbeRay *ray = probe_current(probe);
    if (ray) {
        ray->color = light_first(color);
        ray->own = ray->shape < 0 ? ray->color : ray->own;
        probe->current = ray->parent;
    }
}

/* --- what the current ray met ----------------------------------------------------------------- */

/** Notes where a ray met something. @param[in,out] ray The ray. @param hit Where, if anywhere.
 *  @param length Of its direction in the engine. */
static void ray_meet(ProbeRay *ray, const Hit *hit, double length) {
    int shape = integer_lane(hit->shape, 0), ball = glow_ball(shape);
    ray->is_hit = shape >= 0 || ball >= 0;
    if (ray->is_hit) {
        ray->shape = shape >= 0 ? shape : -1;
        ray->lamp = shape >= 0 ? ray->lamp : ball;
        ray->distance = real_first(hit->distance) * length;
        ray->point = vector_first(hit->point);
        ray->normal = vector_first(hit->normal);
    }
}

void probe_surface(const Encounter *met, const Departure *departure) {
    ProbeRay *ray = probe_current(met->packet->lineage.notes->probe);
    const Hit *hit = &met->hits[0];
    if (!ray) {
        return;
    }
    ray_meet(ray, hit, 1);
    if (ray->shape >= 0) {
        real along = vector_dot(met->packet->rays[0].direction, met->facing[0]);
        double epsilon = real_first(departure_far(departure, hit));
        ray->surface =
            (ProbeSurface){.epsilon = epsilon,
                           .ulps = in_ulps(epsilon, real_first(vector_largest(hit->point))),
                           .cosine = -real_first(along),
                           .is_inside = vector3_dot(vector_first(met->facing[0]), ray->normal) < 0};
    }
}

void probe_crossing(const Encounter *met, const Crossing *crossing) {
    ProbeRay *ray = probe_current(met->packet->lineage.notes->probe);
    Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[0], met->met[0]);
    mask through = met->met[0] & (light3_largest(surfaces.through) > 0);
    if (!ray || !mask_lane(through, 0)) {
        return;
    }
    Media media = met->media[0];
    integer before = media_cross(&media, &met->packet->rays[0], &met->hits[0], through);
    integer behind = media_place(&crossing->media[0]);
    ProbeSurface *surface = &ray->surface;
    surface->is_transparent = true;
    surface->is_hidden = mask_lane(crossing->hidden[0], 0);
    surface->is_total = !mask_lane(crossing->through[0], 0);
    surface->before = real_first(glass_index(met->glass, before));
    surface->behind = real_first(glass_index(met->glass, behind));
    surface->fresnel = real_first(crossing->mirrored[0]);
}

/* --- light ------------------------------------------------------------------------------------ */

/** Finds what is in the way of a shadow ray. @param list All shapes. @param met The surface that it
 *  comes from. @param shadow It. @param[out] hit What it meets first, if anything: of shapes that
 *  light goes through, only where no other is in the way. */
static void blocker_find(const ShapeList *list, const Encounter *met, const Packet *shadow,
                         Hit *hit) {
    Packet way = *shadow;
    Hit hits[PACKET_VECTORS];
    way.wants_points = true;
    shape_list_nearest(met->media ? &met->glass->opaque : list, &way, hits);
    if (integer_lane(hits[0].shape, 0) < 0 && met->media) {
        shape_list_nearest(&met->glass->clear, &way, hits);
    }
    *hit = hits[0];
}

void probe_shadow(const ShapeList *list, const Encounter *met, size_t lamp, const Shine *shine,
                  mask blocked, const Lighting *light) {
    const Packet *shadow = &shine->shadow;
    Probe *probe = met->packet->lineage.notes->probe;
    ProbeRay *ray = probe_add(probe, PROBE_SHADOW, &shadow->rays[0], shadow->limit[0]);
    if (!ray) {
        return;
    }
    const Color all = {1, 1, 1};
    ray->lamp = (int)lamp;
    ray->weight = probe->rays[ray->parent].weight;
    ray->share = all;
    ray->matt = light_first(light->matt[0]);
    ray->shine = light_first(light->highlight[0]);
    ray->passed = met->media ? light_first(shine->visible[0]) : all;
    if (mask_lane(blocked, 0)) {
        Hit hit;
        blocker_find(list, met, shadow, &hit);
        ray_meet(ray, &hit, vector3_length(vector_first(shadow->rays[0].direction)));
        ray->is_hit = true;
        ray->passed = (Color){0, 0, 0};
    }
}

/** @return The same light in all lanes. @param color Light, in numbers of the engine. */
static Light3 light_again(Color color) {
    return light3_of(scalar3_of(color));
}

/** Works out what each shadow ray of a surface adds to its colour. @param probe The tree.
 *  @param place The place of the ray that met the surface. @param surface The surface. */
static void shadows_weigh(Probe *probe, int place, const Surfaces *surface) {
    for (size_t i = (size_t)place + 1; i < probe->count; i++) {
        ProbeRay *ray = &probe->rays[i];
        Light3 matt = light3_scale(light_again(ray->matt), surface->diffuse);
        Light3 shine = light3_multiply(surface->highlight, light_again(ray->shine));
        ray->own = light_first(light3_add(light3_multiply(surface->body, matt), shine));
        ray->color = ray->own;
    }
}

void probe_body(const Encounter *met, const Crossing *crossing, const Light3 *paint, Light3 color) {
    Probe *probe = met->packet->lineage.notes->probe;
    ProbeRay *ray = probe_current(probe);
    if (!ray) {
        return;
    }
    Surfaces surfaces = surfaces_gather(met->surfaces, &met->materials[0], met->met[0]);
    surfaces.body = paint ? light3_multiply(surfaces.body, paint[0]) : surfaces.body;
    ProbeSurface *surface = &ray->surface;
    surface->emission = light_first(surfaces.emission);
    surface->body = light_first(surfaces.body);
    surface->highlight = light_first(surfaces.highlight);
    surface->ambient = light_first(surfaces.ambient);
    surface->diffuse = real_first(surfaces.diffuse);
    surface->mirrored = light_first(crossing_mirrored(crossing, 0, &surfaces));
    if (surface->is_transparent) {
        surface->refracted = light_first(crossing_refracted(crossing, 0, &surfaces));
    }
    ray->own = light_first(color);
    // The newest rays are this surface's shadow rays: none has gone on from it yet.
    shadows_weigh(probe, probe->current, &surfaces);
}

/* --- the end ---------------------------------------------------------------------------------- */

/** @return The place of a lamp's ball among the lamps. @param ball Which of the balls.
 *  @param lamps The lamps. @param count How many. */
static int lamp_of_ball(int ball, const Lamp *lamps, size_t count) {
    int lamp = -1;
    for (size_t i = 0; i < count && ball >= 0; i++) {
        if (lamps[i].radius > 0) {
            ball--;
            lamp = (int)i;
        }
    }
    return lamp;
}

void probe_finish(Probe *probe, Vector3 origin, const Lamp *lamps, size_t count) {
    for (size_t i = 0; i < probe->count; i++) {
        ProbeRay *ray = &probe->rays[i];
        ray->origin = vector3_add(ray->origin, origin);
        ray->point = vector3_add(ray->point, origin);
        if (ray->kind != PROBE_SHADOW) {
            ray->lamp = lamp_of_ball(ray->lamp, lamps, count);
        }
    }
}
