/**
 * @file
 * @brief Contact of opaque surfaces with glass.
 */
#include "trace/glass/contact.h"

#include "trace/glass/interior_list.h"
#include "trace/materials/material_ids.h"

/** Finds where offset segments cross an opaque shape. See #ShapeVisitor. @param[in,out] found One
 *  #Hit per vector. */
static void segment_hit_shape(const Shape *shape, const Packet *segments, int v, mask active,
                              void *found) {
    Hit *hit = (Hit *)found + v;
    shape->class->is_hit(shape, &segments->rays[v], active, hit);
}

/** Sets the offset segments of the rays of a vector that meet glass. Rays that start in contact,
 *  such as one that a table reflects, have passed the opaque surface already. */
INLINE void contact_segments_set(real offset_length, const SurfaceHit *surface, int v,
                                 mask is_glass, Packet *segments) {
    const Hit *hit = &surface->hits[v];
    Vec3 n_front = surface->n_front[v];
    real height = -hit->distance * vec3_dot(surface->packet->rays[v].direction, n_front);
    mask is_far = height > TOUCHING_OFFSET_SCALE * offset_length;
    offset_segment_set(offset_length, hit, n_front, is_glass & is_far, v, segments);
}

/** Replaces the hits of a vector by those of opaque surfaces. */
static void contact_replace(const Hit *opaque, mask lanes, int v, SurfaceHit *surface) {
    Hit *hit = &surface->hits[v], found = *opaque;
    found.distance = hit->distance;
    found.error *= TOUCHING_OFFSET_SCALE;
    hit_update(hit, lanes, &found);
    hit->primitive = integer_select(lanes, found.primitive, hit->primitive);
    mask is_inside = vec3_dot(surface->packet->rays[v].direction, hit->normal) > 0;
    surface->n_front[v] = vec3_select(is_inside, vec3_scale(hit->normal, real_of(-1)), hit->normal);
}

void contacts_resolve(const RayOffset *offset, SurfaceHit *surface) {
    const Dielectrics *dielectrics = surface->dielectrics;
    Packet segments;
    Hit opaque[PACKET_VECTORS];
    if (!dielectrics->offset_scales) {
        return;
    }
    packet_init(&segments, packet_vector_count(surface->packet), true);
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        Hit *hit = &surface->hits[v];
        integer shape = integer_select(surface->is_hit[v], hit->shape, integer_of(-1));
        real scale = real_gather(dielectrics->offset_scales, shape + 1);
        mask is_glass = scale == 0;
        segments.active[v] = mask_of(false);
        segments.limit[v] = real_of(0);
        if (any(is_glass)) {
            contact_segments_set(ray_offset_length(offset, hit), surface, v, is_glass, &segments);
            opaque[v] = hit_none(real_of(1));
        }
        hit->error *= real_max(scale, real_of(1));
    }
    if (packet_active_count(&segments) == 0) {
        return;
    }
    shape_set_visit(&dielectrics->touching, &segments, segment_hit_shape, opaque);
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        if (any(segments.active[v])) {
            mask lanes = segments.active[v] & (opaque[v].shape >= integer_of(0));
            if (any(lanes)) {
                contact_replace(&opaque[v], lanes, v, surface);
            }
        }
    }
}
