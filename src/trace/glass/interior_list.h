/**
 * @file
 * @brief Media: which transparent shapes rays are inside of, and what the index of refraction is
 *        there.
 *
 * Where shapes overlap, the one that comes later in the scene is there, and the earlier is not: a
 * bubble is a ball of air after the glass that it is in. So a ray need not know in which order it
 * has entered shapes, only which ones it is in (Schmidt and Budge, *Simple Nested Dielectrics in
 * Ray Traced Images*, 2002, with the scene's order as priority).
 */
#ifndef DIOPTRE_TRACE_GLASS_INTERIOR_LIST_H
#define DIOPTRE_TRACE_GLASS_INTERIOR_LIST_H

#include "trace/bvh/shape_set.h"
#include "trace/materials/material.h"
#include "trace/tracer/ray_offset.h"

/** Most shapes that a ray is inside of at once; of more, those that come first in the scene are
 *  forgotten. */
enum { INTERIOR_LIST_CAPACITY = 8 };

/** The transparent shapes that LANES rays are inside of. */
typedef struct InteriorList {
    integer
        shapes[INTERIOR_LIST_CAPACITY]; /**< Their places, the last of the scene first; then -1. */
} InteriorList;

/** What a scene has of glass. */
typedef struct Dielectrics {
    scalar *iors;         /**< Of refraction: air's, then each shape's, 0 where it is opaque; owned.
                                  NULL: there is no glass. */
    ShapeSet transparent; /**< The transparent shapes. */
    ShapeSet opaque;      /**< The others. */
    InteriorList camera_interior; /**< What the camera is inside of. */
    bool may_override; /**< Whether a later shape may hide a tinted surface from a lamp's light. */
} Dielectrics;

/** @return Nothing but air. */
INLINE InteriorList interior_list_empty(void) {
    InteriorList interior;
    for (int i = 0; i < INTERIOR_LIST_CAPACITY; i++) {
        interior.shapes[i] = integer_of(-1);
    }
    return interior;
}

/**
 * Takes shapes out.
 * @param[in,out] interior  What rays are inside of.
 * @param shape_index  What they leave, whether they are in it or not.
 */
INLINE void interior_list_remove(InteriorList *interior, mask leaving, integer shape_index) {
    mask is_behind = mask_of(false);
    for (int i = 0; i < INTERIOR_LIST_CAPACITY; i++) {
        is_behind |= leaving & (interior->shapes[i] == shape_index);
        integer next = i + 1 < INTERIOR_LIST_CAPACITY ? interior->shapes[i + 1] : integer_of(-1);
        interior->shapes[i] = integer_select(is_behind, next, interior->shapes[i]);
    }
}

/**
 * Puts shapes in.
 * @param[in,out] interior  What rays are inside of.
 * @param shape_index  What they enter, whether they are in it already or not.
 */
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

/** @return Place of the shape that rays are in: of several, the last of the scene; -1: air.
 *  @param interior What they are inside of. */
INLINE integer interior_list_top(const InteriorList *interior) {
    return interior->shapes[0];
}

/**
 * Takes rays over surfaces. Whoever leaves a shape was inside, whoever enters it was not, whatever
 * has been noted before.
 * @param[in,out] interior  What the rays are inside of.
 * @param lanes  The lanes that met a transparent one.
 * @return Place of the medium before the surface.
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
 * Aims a jump over a surface, backwards: from where rays behind it start to where those before it
 * do.
 * @param n_front  Its normal, on the side that the rays come from.
 * @param v  Which vector of the packet.
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

/** @return Indices of refraction. */
INLINE real dielectrics_ior(const Dielectrics *dielectrics, integer shape_index) {
    return real_gather(dielectrics->iors, shape_index + 1);
}

/**
 * Sorts a scene's shapes into transparent and opaque ones.
 * @param[out] dielectrics  What the scene has; give it back with #dielectrics_deinit.
 * @param shapes  Its shapes, which must live longer.
 * @param settings  Whether there are trees, and who builds them.
 * @return false without memory.
 */
bool dielectrics_init(Dielectrics *dielectrics, const Scene *scene, const ShapeSet *shapes,
                      const TraceSettings *settings);

/** Finds whether any tinted shape meets a later transparent one: whether the boxes around them do.
 */
void dielectrics_find_overrides(Dielectrics *dielectrics, const Material *materials);

/** Gives indices and lists back. */
void dielectrics_deinit(Dielectrics *dielectrics);

/**
 * Finds what the camera is inside of. No shape is asked for it: rays along the axes tell, by the
 * side on which the nearest of them meets a shape.
 * @param[in,out] dielectrics  What the scene has; at_eye is filled.
 * @param camera_position            Where the camera is.
 */
void dielectrics_set_camera(Dielectrics *dielectrics, Vec3 camera_position);

/**
 * Sets right what rays are inside of, where they jump over a surface: every surface that lies in
 * the jump is crossed, also those that the first one hides.
 * @param segments  From the end of each jump back to its start: the end is inside of a shape whose
 *         inside is seen first on the way back.
 * @param[in,out] interior  What the rays are inside of.
 */
void dielectrics_cross_segments(const Dielectrics *dielectrics, const Packet *segments,
                                InteriorList *interior);

#endif
