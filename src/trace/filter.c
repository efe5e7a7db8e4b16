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
 * Filters a packet through the next surface of each ray.
 * @param surfaces   All materials.
 * @param list       The shapes.
 * @param departure  How rays leave a surface.
 * @param[in,out] path     The rays; active where there may be more surfaces.
 * @param[in,out] visible  What is left of the light.
 */
static void filter_once(const Surface *surfaces, const ShapeList *list, const Departure *departure,
                        Packet *path, Light3 *visible) {
    Hit hits[PACKET_VECTORS];
    shape_list_nearest(list, path, hits);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask met = path->active[v] & (hits[v].shape >= integer_of(0));
        path->active[v] = met;
        if (any(met)) {
            Materials materials = materials_of(list, &hits[v], met);
            Surfaces surface = surfaces_gather(surfaces, &materials, met);
            Light3 left = light3_multiply(visible[v], surface.through);
            visible[v] = light3_select(met, left, visible[v]);
            path_go_on(departure, &hits[v], met & (light3_largest(left) > 0), v, path);
        }
    }
}

void filter_shadows(const Surface *surfaces, const ShapeList *list, const Departure *departure,
                    const Packet *shadow, mask *blocked, Light3 *visible) {
    Packet path = *shadow;
    path.wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        path.active[v] &= blocked[v];
        visible[v] = (Light3){real_of(1), real_of(1), real_of(1)};
    }
    for (int i = 0; i < FILTER_MAXIMUM && packet_count(&path) > 0; i++) {
        filter_once(surfaces, list, departure, &path, visible);
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        blocked[v] = path.active[v] | mask_not(light3_largest(visible[v]) > 0);
    }
}
