/**
 * @file
 * @brief What rays meet inside of a transparent shape, and at its wall.
 */
#include "trace/glass/neighbours.h"

#include <stdlib.h>
#include <string.h>

/** Most shapes of a scene whose neighbours are looked for: each pair of boxes is compared. */
enum { NEIGHBOUR_SHAPES_MAXIMUM = 512 };

/** By how many roundings of its largest coordinate the box of a transparent shape is enlarged, each
 *  half an ulp: offset segments reach a few error bounds of a hit beyond the wall. */
#define NEIGHBOUR_ROUNDINGS 256

/* --- the neighbours of a shape ---------------------------------------------------------------- */

/** @return The neighbours of a transparent shape. */
static Neighbours neighbours_of(const Shape *glass, const ShapeSet *all) {
    const Aabbs bounds = glass->class->bounds(glass);
    const scalar slack = NEIGHBOUR_ROUNDINGS * AABB_ROUNDOFF * aabbs_largest(&bounds);
    // Twice the slack: once for the segments, and once for that of their own boxes.
    Neighbours neighbours = {.box = aabbs_enlarged(bounds, 2 * slack), .slack = slack};
    // All shapes are neighbours of unbounded glass.
    neighbours.glass = aabbs_is_bounded(&bounds) ? glass : NULL;
    for (size_t i = 0; neighbours.glass && i < all->count; i++) {
        const Shape *shape = all->shapes[i];
        Aabbs box = shape_exceeds_box(shape) ? aabbs_infinite() : shape->class->bounds(shape);
        if (shape == glass || !aabbs_overlap(&neighbours.box, &box)) {
            continue;
        }
        if (neighbours.count == NEIGHBOURS_MAXIMUM) {
            neighbours.glass = NULL;
            break;
        }
        neighbours.others[neighbours.count++] = (Neighbour){shape, box};
    }
    return neighbours;
}

bool neighbours_init(Dielectrics *dielectrics) {
    const ShapeSet *all = dielectrics->all, *transparent = &dielectrics->transparent;
    if (all->count > NEIGHBOUR_SHAPES_MAXIMUM) {
        return true;
    }
    dielectrics->neighbours = calloc(all->count, sizeof *dielectrics->neighbours);
    for (size_t i = 0; dielectrics->neighbours && i < transparent->count; i++) {
        const Shape *glass = transparent->shapes[i];
        dielectrics->neighbours[glass->index] = neighbours_of(glass, all);
    }
    return dielectrics->neighbours;
}

/* --- the rays of one shape -------------------------------------------------------------------- */

/** The rays of a packet that are in or at one transparent shape. */
typedef struct GlassRays {
    const Neighbours *neighbours; /**< Of the shape. */
    mask lanes[PACKET_VECTORS];   /**< The rays, per vector. */
} GlassRays;

/** @return Whether any lane is set. @param lanes Per vector of a packet. */
INLINE bool any_of(const mask *lanes, int vector_count) {
    mask sum = mask_of(false);
    for (int v = 0; v < vector_count; v++) {
        sum |= lanes[v];
    }
    return any(sum);
}

/** @return Some rays of a packet. @param lanes Which, per vector. */
INLINE Packet packet_part(const Packet *packet, const mask *lanes) {
    Packet part = *packet;
    memcpy(part.active, lanes, sizeof part.active);
    return part;
}

/** @return The first of some shapes; -1: there is none. @param lanes Which lanes, per vector. */
INLINE int first_shape(const integer *shapes, const mask *lanes, int vector_count) {
    for (int v = 0; v < vector_count; v++) {
        if (any(lanes[v])) {
            return integer_at(&shapes[v], mask_first(lanes[v]));
        }
    }
    return -1;
}

/**
 * Takes the rays of the first shape that has neighbours.
 * @param shapes          The shape that each ray is in or at.
 * @param[in,out] lanes   The rays; those that are taken, or without neighbours, are removed.
 * @param[out] taken      The rays that are taken.
 * @return Whether there are any.
 */
static bool glass_rays_take(const Dielectrics *dielectrics, const integer *shapes, mask *lanes,
                            int vector_count, GlassRays *taken) {
    if (!dielectrics->neighbours) {
        return false;
    }
    for (int shape = first_shape(shapes, lanes, vector_count); shape >= 0;
         shape = first_shape(shapes, lanes, vector_count)) {
        taken->neighbours = &dielectrics->neighbours[shape];
        for (int v = 0; v < vector_count; v++) {
            taken->lanes[v] = lanes[v] & (shapes[v] == integer_of(shape));
            lanes[v] &= mask_not(taken->lanes[v]);
        }
        if (taken->neighbours->glass) {
            return true;
        }
    }
    return false;
}

/* --- closest hits ----------------------------------------------------------------------------- */

/** Intersects some rays of a packet with a shape. @param lanes Which, per vector. */
static void shape_update_lanes(const Shape *shape, const Packet *packet, const mask *lanes,
                               Hit *hits) {
    if (shape_takes_packets(shape)) {
        Packet part = packet_part(packet, lanes);
        shape->class->extension->closest_hits(shape, &part, hits);
        return;
    }
    for (int v = 0; v < packet_vector_count(packet); v++) {
        if (any(lanes[v])) {
            shape->class->is_hit(shape, &packet->rays[v], lanes[v], &hits[v]);
        }
    }
}

/** The bounding boxes of LANES segments of rays. */
typedef struct SegmentBoxes {
    Vec3 low;  /**< The lowest corners. */
    Vec3 high; /**< The highest corners. */
} SegmentBoxes;

/** @return The boxes of segments. @param slack By how much they are enlarged. */
INLINE SegmentBoxes segment_boxes_of(const Vec3 *from, const Vec3 *to, scalar slack) {
    const Vec3 around = {real_of(slack), real_of(slack), real_of(slack)};
    return (SegmentBoxes){vec3_subtract(vec3_min(*from, *to), around),
                          vec3_add(vec3_max(*from, *to), around)};
}

/** @return The lanes in which the box of a segment overlaps another. */
INLINE mask segment_boxes_overlap(const SegmentBoxes *boxes, const Aabbs *box) {
    mask overlap = mask_of(true);
    for (int axis = 0; axis < 3; axis++) {
        mask begins = vec3_component(&boxes->low, axis) <= real_of(box->high[axis]);
        mask ends = vec3_component(&boxes->high, axis) >= real_of(box->low[axis]);
        overlap &= begins & ends;
    }
    return overlap;
}

/** @return The lanes in which the box of a segment is within another. */
INLINE mask segment_boxes_within(const SegmentBoxes *boxes, const Aabbs *box) {
    mask is_within = mask_of(true);
    for (int axis = 0; axis < 3; axis++) {
        mask begins = vec3_component(&boxes->low, axis) >= real_of(box->low[axis]);
        mask ends = vec3_component(&boxes->high, axis) <= real_of(box->high[axis]);
        is_within &= begins & ends;
    }
    return is_within;
}

/** Finds the hits of rays inside of a shape: first with its wall, then with what may be before
 *  that. @param[in,out] open The rays whose closest hit is not known: those whose hit is surely the
 *  closest are removed. */
static void glass_rays_closest_hits(const GlassRays *rays, const Packet *packet, mask *open,
                                    Hit *hits) {
    const Neighbours *neighbours = rays->neighbours;
    mask closed[PACKET_VECTORS] = {0};
    SegmentBoxes boxes[PACKET_VECTORS];
    shape_update_lanes(neighbours->glass, packet, rays->lanes, hits);
    for (int v = 0; v < packet_vector_count(packet); v++) {
        boxes[v] = segment_boxes_of(&packet->rays[v].origin, &hits[v].point, neighbours->slack);
        closed[v] = rays->lanes[v] & (hits[v].shape >= integer_of(0)) &
                    segment_boxes_within(&boxes[v], &neighbours->box);
        open[v] &= mask_not(closed[v]);
    }
    for (int i = 0; i < neighbours->count; i++) {
        mask near[PACKET_VECTORS];
        for (int v = 0; v < packet_vector_count(packet); v++) {
            near[v] = closed[v] & segment_boxes_overlap(&boxes[v], &neighbours->others[i].box);
        }
        if (any_of(near, packet_vector_count(packet))) {
            shape_update_lanes(neighbours->others[i].shape, packet, near, hits);
        }
    }
}

void neighbours_closest_hits(const Dielectrics *dielectrics, const Packet *packet,
                             const InteriorList *interior, Hit *hits) {
    integer shapes[PACKET_VECTORS];
    mask inside[PACKET_VECTORS], open[PACKET_VECTORS];
    GlassRays rays;
    for (int v = 0; v < packet_vector_count(packet); v++) {
        shapes[v] = interior_list_top(&interior[v]);
        inside[v] = packet->active[v] & (shapes[v] >= integer_of(0));
        hits[v] = hit_none(packet->limit[v]);
    }
    if (!glass_rays_take(dielectrics, shapes, inside, packet_vector_count(packet), &rays)) {
        shape_set_update_hits(dielectrics->all, packet, hits);
        return;
    }
    memcpy(open, packet->active, sizeof open);
    do {
        glass_rays_closest_hits(&rays, packet, open, hits);
    } while (glass_rays_take(dielectrics, shapes, inside, packet_vector_count(packet), &rays));
    if (any_of(open, packet_vector_count(packet))) {
        Packet part = packet_part(packet, open);
        shape_set_update_hits(dielectrics->all, &part, hits);
    }
}

/* --- offset segments -------------------------------------------------------------------------- */

/** Visits a shape and its transparent neighbours for the segments across its wall. @param[in,out]
 *  open The segments that all shapes are visited for: those of the shape are removed. */
static void glass_rays_visit(const GlassRays *rays, const Dielectrics *dielectrics,
                             const Packet *segments, mask *open, ShapeVisitor visitor,
                             void *found) {
    const Neighbours *neighbours = rays->neighbours;
    for (int v = 0; v < packet_vector_count(segments); v++) {
        const Ray *ray = &segments->rays[v];
        if (!any(rays->lanes[v])) {
            continue;
        }
        Vec3 end = vec3_add(ray->origin, ray->direction);
        SegmentBoxes boxes = segment_boxes_of(&ray->origin, &end, neighbours->slack);
        mask lanes = rays->lanes[v] & segment_boxes_within(&boxes, &neighbours->box);
        open[v] &= mask_not(lanes);
        visitor(neighbours->glass, segments, v, lanes, found);
        for (int i = 0; i < neighbours->count; i++) {
            const Shape *other = neighbours->others[i].shape;
            if (dielectrics->iors[other->index + 1] > 0) {
                mask near = lanes & segment_boxes_overlap(&boxes, &neighbours->others[i].box);
                if (any(near)) {
                    visitor(other, segments, v, near, found);
                }
            }
        }
    }
}

void neighbours_visit_segments(const Dielectrics *dielectrics, const Packet *segments,
                               const Hit *hits, ShapeVisitor visitor, void *found) {
    integer shapes[PACKET_VECTORS];
    mask lanes[PACKET_VECTORS], open[PACKET_VECTORS];
    GlassRays rays;
    for (int v = 0; v < packet_vector_count(segments); v++) {
        shapes[v] = hits[v].shape;
        lanes[v] = open[v] = segments->active[v];
    }
    while (glass_rays_take(dielectrics, shapes, lanes, packet_vector_count(segments), &rays)) {
        glass_rays_visit(&rays, dielectrics, segments, open, visitor, found);
    }
    if (any_of(open, packet_vector_count(segments))) {
        Packet part = packet_part(segments, open);
        shape_set_visit(&dielectrics->transparent, &part, visitor, found);
    }
}
