/**
 * @file
 * @brief Light through transparent shapes.
 */
#include "trace/filter.h"

/** Most surfaces that a lamp's light crosses; behind more it is dark. A guard: rays that start at
 *  the very surface that they leave (`--offset none`) would meet it for ever. */
enum { FILTER_MAXIMUM = 256 };

/**
 * Moves rays on behind a surface. The way that is left gets shorter by as much.
 * @param departure  How.
 * @param hit        The surface.
 * @param lanes      The rays that go on.
 * @param v          Which vector.
 * @param[in,out] path  The rays.
 */
INLINE void path_go_on(const Departure *departure, const Hit *hit, mask lanes, int v,
                       Packet *path) {
    Vector direction = path->rays[v].direction;
    real along = vector_dot(direction, hit->normal), cosine = real_abs(along);
    real side = real_select(along < 0, real_of(-1), real_of(1));
    real far = departure_far(departure, hit);
    real way = departure_way(far, cosine, real_sqrt(vector_dot(direction, direction)));
    Vector onward = vector_scale(hit->normal, side);
    Vector origin = departure_through(hit, far, onward, direction, cosine, way);
    path->rays[v] = ray_of(origin, direction);
    path->limit[v] -= hit->distance + way;
    path->active[v] = lanes & (path->limit[v] > 0);
}

/**
 * Finds which of the surfaces that light meets are not there, because a later shape is. It is asked
 * as for rays that look (see crossing_find()), and only where #Glass.hides says so.
 * @param departure  How rays leave a surface.
 * @param glass      What the scene has of glass.
 * @param path       The rays.
 * @param hits       The surfaces.
 * @param[in,out] media   What the rays are inside of.
 * @param[out] hidden     Where the surface is not there.
 */
static void hidden_find(const Departure *departure, const Glass *glass, const Packet *path,
                        const Hit *hits, Media *media, mask *hidden) {
    Packet jumps;
    mask through[PACKET_VECTORS];
    integer before[PACKET_VECTORS];
    jumps.wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Hit *hit = &hits[v];
        Vector direction = path->rays[v].direction, normal = hit->normal;
        mask met = path->active[v] & (hit->shape >= integer_of(0));
        integer shape = integer_select(met, hit->shape, integer_of(-1));
        through[v] = met & (glass_index(glass, shape) > 0);
        before[v] = media_cross(&media[v], &path->rays[v], hit, through[v]);
        Vector facing = vector_select(vector_dot(direction, normal) > 0,
                                      vector_scale(normal, real_of(-1)), normal);
        jump_aim(departure_far(departure, hit), hit, facing, through[v], v, &jumps);
    }
    if (packet_count(&jumps) > 0) {
        glass_jump(glass, &jumps, media);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        hidden[v] = through[v] & (before[v] == media_place(&media[v]));
    }
}

/**
 * Filters a packet through the next surface of each ray.
 * @param list       The shapes.
 * @param departure  How rays leave a surface.
 * @param met        The points that the rays come from.
 * @param[in,out] path     The rays; active where there may be more surfaces.
 * @param[in,out] media    What they are inside of; only where #Glass.hides.
 * @param[in,out] visible  What is left of the light.
 */
static void filter_once(const ShapeList *list, const Departure *departure, const Encounter *met,
                        Packet *path, Media *media, Light3 *visible) {
    Hit hits[PACKET_VECTORS];
    mask hidden[PACKET_VECTORS] = {0};
    shape_list_nearest(&met->glass->clear, path, hits);
    if (met->glass->hides) {
        hidden_find(departure, met->glass, path, hits, media, hidden);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask crossed = path->active[v] & (hits[v].shape >= integer_of(0));
        path->active[v] = crossed;
        if (any(crossed)) {
            Materials materials = materials_of(list, &hits[v], crossed);
            Surfaces surface = surfaces_gather(met->surfaces, &materials, crossed);
            Light3 left = light3_multiply(visible[v], surface.through);
            visible[v] = light3_select(crossed & mask_not(hidden[v]), left, visible[v]);
            mask goes_on = crossed & (light3_largest(visible[v]) > 0);
            path_go_on(departure, &hits[v], goes_on, v, path);
        }
    }
}

void filter_shadows(const ShapeList *list, const Departure *departure, const Encounter *met,
                    const Packet *shadow, mask *blocked, Light3 *visible) {
    Packet path = *shadow;
    Media media[PACKET_VECTORS];
    path.wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        path.active[v] &= mask_not(blocked[v]);
        visible[v] = (Light3){real_of(1), real_of(1), real_of(1)};
        if (met->glass->hides) {
            media[v] = met->media[v];
        }
    }
    for (int i = 0; i < FILTER_MAXIMUM && packet_count(&path) > 0; i++) {
        filter_once(list, departure, met, &path, media, visible);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        blocked[v] |= path.active[v] | mask_not(light3_largest(visible[v]) > 0);
    }
}
