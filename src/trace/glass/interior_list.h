/**
 * @file
 * @brief Interior lists: the transparent shapes that rays are inside of, and their indices of
 *        refraction.
 *
 * Where transparent shapes overlap, the one that comes later in the scene replaces the earlier
 * ones: an air bubble in glass is a sphere of air after the glass. So a ray needs no history of the
 * shapes that it entered, only the set of those that it is inside of (Schmidt and Budge, *Simple
 * Nested Dielectrics in Ray Traced Images*, 2002; the order of the scene is the priority).
 */
#ifndef DIOPTRE_TRACE_GLASS_INTERIOR_LIST_H
#define DIOPTRE_TRACE_GLASS_INTERIOR_LIST_H

#include "trace/bvh/shape_set.h"
#include "trace/materials/material.h"
#include "trace/tracer/ray_offset.h"

/** Most shapes in a list; of more, those that come first in the scene are dropped. */
enum { INTERIOR_LIST_CAPACITY = 8 };

/** The transparent shapes that LANES rays are inside of. */
typedef struct InteriorList {
    integer shapes[INTERIOR_LIST_CAPACITY]; /**< Their indices in descending order; then -1. */
} InteriorList;

/** See trace/glass/neighbours.h. */
typedef struct Neighbours Neighbours;

/** The transparent shapes of a scene. */
typedef struct Dielectrics {
    scalar *iors;         /**< Indices of refraction: of air, then of each shape, 0 if it is opaque;
                               owned. NULL: no shape is transparent. */
    ShapeSet transparent; /**< The transparent shapes. */
    ShapeSet opaque;      /**< The opaque shapes. */
    ShapeSet tinted;      /**< The transparent shapes that matter to shadow rays: those that absorb
                               light; all, where one overrides another. */
    ShapeSet touching;    /**< The opaque shapes that may touch a transparent one. */
    const ShapeSet *all;  /**< All shapes; not owned. */
    scalar *offset_scales;  /**< Factors of the ray offset: 1 for air, then of each shape 0 if it is
                                 transparent, #TOUCHING_OFFSET_SCALE if it is in #touching, or 1;
                                 owned. NULL: no shape touches a transparent one. */
    Neighbours *neighbours; /**< What rays inside of each shape meet; owned. NULL: there are
                                 too many shapes. */
    InteriorList camera_interior; /**< The shapes that the camera is inside of. */
    bool may_override; /**< Whether a later shape may override a tinted surface, for shadow rays. */
} Dielectrics;

/** @return The empty list: air. */
INLINE InteriorList interior_list_empty(void) {
    InteriorList interior;
    for (int i = 0; i < INTERIOR_LIST_CAPACITY; i++) {
        interior.shapes[i] = integer_of(-1);
    }
    return interior;
}

/** Removes a shape from the lists of rays, where it is in them. */
INLINE void interior_list_remove(InteriorList *interior, mask leaving, integer shape_index) {
    mask is_behind = mask_of(false);
    for (int i = 0; i < INTERIOR_LIST_CAPACITY; i++) {
        is_behind |= leaving & (interior->shapes[i] == shape_index);
        integer next = i + 1 < INTERIOR_LIST_CAPACITY ? interior->shapes[i + 1] : integer_of(-1);
        interior->shapes[i] = integer_select(is_behind, next, interior->shapes[i]);
    }
}

/** Inserts a shape into the lists of rays, where it is not in them. */
INLINE void interior_list_insert(InteriorList *interior, mask entering, integer shape_index) {
    interior_list_remove(interior, entering, shape_index);
    integer next = integer_select(entering, shape_index, integer_of(-1));
    for (int i = 0; i < INTERIOR_LIST_CAPACITY; i++) {
        mask is_later = next > interior->shapes[i];
        integer current = interior->shapes[i];
        interior->shapes[i] = integer_select(is_later, next, current);
        next = integer_select(is_later, current, next);
    }
}

/** @return The shape whose medium rays are in: the last one in the scene; -1: air. */
INLINE integer interior_list_top(const InteriorList *interior) {
    return interior->shapes[0];
}

/**
 * Updates the lists of rays that cross a surface. The hit overrules the list: a ray that leaves a
 * shape was inside of it, and a ray that enters one was not.
 * @param lanes  The lanes that hit a transparent shape.
 * @return The shape whose medium is before the surface; -1: air.
 */
INLINE integer interior_list_cross(InteriorList *interior, const Ray *ray, const Hit *hit,
                                   mask lanes) {
    mask leaves = vec3_dot(ray->direction, hit->normal) > 0;
    mask leaving = lanes & leaves, entering = lanes & mask_not(leaves);
    InteriorList outer = *interior;
    interior_list_insert(&outer, leaving, hit->shape);
    interior_list_remove(&outer, entering, hit->shape);
    interior_list_remove(interior, leaving, hit->shape);
    interior_list_insert(interior, entering, hit->shape);
    return interior_list_top(&outer);
}

/**
 * Sets the offset segment of a surface: from the origin of transmitted rays, behind it, back to the
 * origin of reflected rays, before it. Surfaces in between would be missed by both.
 * @param n_front  The unit normal on the side that the rays come from.
 * @param v  Vector of the packet that is set.
 */
INLINE void offset_segment_set(real offset_length, const Hit *hit, Vec3 n_front, mask lanes, int v,
                               Packet *segments) {
    Vec3 before = vec3_add(hit->point, vec3_scale(n_front, offset_length));
    Vec3 behind =
        vec3_add(hit->point, vec3_scale(n_front, -TRANSMIT_OFFSET_BOUNDS * offset_length));
    segments->rays[v] = ray_of(behind, vec3_subtract(before, behind));
    segments->active[v] = lanes & (offset_length > 0);
    segments->limit[v] = real_of(1);
}

/** @return The indices of refraction of shapes; -1 is air. */
INLINE real dielectrics_ior(const Dielectrics *dielectrics, integer shape_index) {
    return real_gather(dielectrics->iors, shape_index + 1);
}

/**
 * Divides the shapes of a scene into transparent and opaque ones.
 * @param[out] dielectrics  Both sets; release them with #dielectrics_deinit.
 * @param shapes  The shapes, which must live longer.
 * @param settings  Whether BVHs are built, and the parallel for loop for that.
 * @return Whether memory sufficed.
 */
bool dielectrics_init(Dielectrics *dielectrics, const Scene *scene, const ShapeSet *shapes,
                      const TraceSettings *settings);

/** Sets #Dielectrics.tinted and #Dielectrics.may_override: whether the bounding box of a tinted
 * shape overlaps that of a later transparent one. @return Whether memory sufficed. */
bool dielectrics_find_tints(Dielectrics *dielectrics, const Material *materials,
                            const TraceSettings *settings);

/** Releases both sets. */
void dielectrics_deinit(Dielectrics *dielectrics);

/**
 * Sets #Dielectrics.camera_interior. Six rays along the axes test each shape: the camera is inside
 * if the nearest hit is from inside.
 * @param camera_position  The eye point.
 */
void dielectrics_set_camera(Dielectrics *dielectrics, Vec3 camera_position);

/**
 * Corrects the interior lists of transmitted rays: every surface within an offset segment is
 * crossed, not only the one that was hit.
 * @param segments  The segments, by offset_segment_set(). They run backwards: the transmitted ray
 *         starts inside of the shapes that a segment first hits from inside.
 * @param hits  The surfaces that were hit, per vector.
 * @param[in,out] interior  One list per vector.
 */
void dielectrics_cross_segments(const Dielectrics *dielectrics, const Packet *segments,
                                const Hit *hits, InteriorList *interior);

#endif
