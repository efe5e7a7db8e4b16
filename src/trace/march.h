/**
 * @file
 * @brief Marching: how rays find the surface of a field.
 *
 * A ray steps as far as the field allows until it is as near as the tolerance (Hart, *Sphere
 * Tracing*, 1996). Steps are made longer than allowed; where the ball around the new point does not
 * touch the one around the last, something may lie between them, and the step is taken back
 * (Keinert and others, *Enhanced Sphere Tracing*, 2014). How much longer follows from how the field
 * has changed of late: before a plane, the two balls then just touch (Bálint and Valasek,
 * *Accelerating Sphere Tracing*, 2018; Bán and Valasek, *Automatic Step Size Relaxation*, 2023).
 * Only what may hold a surface is marched: the way through the field's box, cell by cell where it
 * is repeated.
 */
#ifndef DIOPTRE_TRACE_MARCH_H
#define DIOPTRE_TRACE_MARCH_H

#include "trace/field.h"
#include "trace/footprint.h"
#include "trace/lattice.h"
#include "trace/packet.h"
#include "trace/placing.h"
#include "trace/stalls.h"

/** Tolerances that a hit may be off, and that rays which leave it start away: farther than where a
 *  march ends. */
#define ERROR_TOLERANCES 2
/** Half ulps of the coordinates that a distance can be wrong by, with room for long tapes. */
#define FIELD_ERROR 16

/** A field as rays see it. */
typedef struct Marching {
    FieldCode *codes;           /**< Its tape; the shape's. */
    int count;                  /**< How many steps it has. */
    Placing outer;              /**< Where all of it stands. */
    Lattice lattice;            /**< How it is repeated there. */
    Placing inner;              /**< Where each copy stands in its cell. */
    BoundsBlock around;         /**< All copies, in the outer placing. */
    BoundsBlock box;            /**< One of them, in the inner placing. */
    scalar scale;               /**< Scene units of a unit of the tape. */
    scalar tolerance;           /**< How near to the surface is on it, scene units. */
    scalar slack;               /**< See #Field.slack. */
    scalar relaxation;          /**< How much longer than allowed a step is; 0: as it pays. */
    int max_steps;              /**< Steps after which a ray is given up. */
    const Footprint *footprint; /**< How finely the camera sees; NULL: by the tolerance alone. */
    Stalls *stalls;             /**< Counts the rays that were given up. */
} Marching;

/** LANES rays on their way. Lengths are those of the tape unless it is said otherwise. */
typedef struct March {
    WideVector start;   /**< Where it starts, as the lattice sees it. */
    WideVector toward;  /**< Its direction there. */
    LatticeRay through; /**< How it goes through the lattice. */
    real far;           /**< How far it looks, in lengths of the direction. */
    Vector cell;        /**< The cell where it is. */
    WideVector heading; /**< Its direction as the tape sees it. */
    Vector direction;   /**< The same, one long. */
    Vector inverse;     /**< 1 / #heading. */
    real length;        /**< Of #heading. */
    real from;          /**< Where it comes into the cell, in lengths of the direction. */
    real entry;         /**< How much later into the box there, in the same lengths. */
    Vector origin;      /**< Where that is; or where it starts in the box. */
    real end;           /**< From there: where it leaves the box, or has come too far. */
    real eye;           /**< How far the eye is from where it starts. */
    real ahead;         /**< How much of that is left at #origin. */
    scalar spread;      /**< See #Footprint. */
    scalar beyond;      /**< The same behind the eye. */
    mask seeking;       /**< The lanes that look for a cell whose copy they may meet. */
    mask entering;      /**< Those that stand before one. */
    mask walking;       /**< Those that walk through its box. */
    real slope;         /**< How fast the field grows along the ray, of late. */
    real steps;         /**< How many they have made. */
    mask leaving;       /**< Those that have not yet left the surface that they started on. */
    mask found;         /**< Those that have arrived. */
    real side;          /**< 1: outside; -1: inside. */
    real way;           /**< How far they are, from #origin. */
    real step;          /**< The last step. */
    real radius;        /**< How far they might have gone. */
    real best;          /**< The nearest to the surface that they were. */
    real best_way;      /**< Where. */
} March;

/**
 * Makes a field ready for rays, but for #Marching.footprint and #Marching.stalls.
 * @param[in,out] marching  Its tape has room; tolerance, relaxation and steps are filled.
 * @param field             The field.
 * @param[out] bounds       A box that holds all points within the tolerance.
 */
void marching_init(Marching *marching, const Field *field, Bounds *bounds);

/**
 * Finds where rays meet the surface.
 * @param marching   The field.
 * @param ray        The rays.
 * @param active     The lanes that count.
 * @param limit      How far they look.
 * @param is_shadow  Whether they are on their way to a lamp.
 * @param[out] march Where they are, and which have arrived.
 * @return Whether any has.
 */
bool march_run(const Marching *marching, const Ray *ray, mask active, real limit, bool is_shadow,
               March *march);

/**
 * @return How many steps rays make to where they meet the surface, or to where they find none.
 * @param marching   The field.
 * @param ray        The rays.
 * @param active     The lanes that count; the others make none.
 * @param limit      How far they look.
 */
real march_count(const Marching *marching, const Ray *ray, mask active, real limit);

/** @return The points where rays are, as the tape sees them. @param march The rays. @param way How
 *  far. */
INLINE Vector march_point(const March *march, real way) {
    return vector_add(march->origin, vector_scale(march->direction, way));
}

/** @return How large a thing the camera does not see. @param march The rays. @param to_eye How much
 *  nearer they are than the eye. */
INLINE real march_unseen(const March *march, real to_eye) {
    return real_max(march->spread * to_eye, -march->beyond * to_eye);
}

/** @return How near to the surface is on it: as near as roundings let one see, and as finely as the
 *  camera does. @param marching The field. @param march The rays. @param way How far.
 *  @param point Where that is. */
INLINE real march_tolerance(const Marching *marching, const March *march, real way, Vector point) {
    real least = real_max(real_of(marching->tolerance / marching->scale),
                          FIELD_ERROR * ROUNDOFF * vector_largest(point));
    return real_max(least, march_unseen(march, march->ahead - way));
}

/** @return How far rays are, in lengths of their direction. @param march The rays. */
INLINE real march_distance(const March *march) {
    wide way = widen(march->entry) + widen(march->way / march->length);
    return narrow(widen(march->from) + way);
}

/** @return Points as the scene sees them. @param marching The field. @param march The rays.
 *  @param point Points of the tape. */
INLINE Vector march_scene_point(const Marching *marching, const March *march, Vector point) {
    WideVector p = vector_widen(point);
    if (marching->inner.is_any) {
        p = placing_take_back(&marching->inner, p);
    }
    if (marching->lattice.is_any) {
        p = wide_add_scaled(p, lattice_zero(&marching->lattice, march->cell), wide_of(1));
    }
    return vector_narrow(marching->outer.is_any ? placing_take_back(&marching->outer, p) : p);
}

/** @return Directions as the scene sees them. @param marching The field. @param direction Those of
 *  the tape. */
INLINE Vector march_scene_direction(const Marching *marching, Vector direction) {
    WideVector d = vector_widen(direction);
    if (marching->inner.is_any) {
        d = placing_turn_back(&marching->inner, d);
    }
    return vector_narrow(marching->outer.is_any ? placing_turn_back(&marching->outer, d) : d);
}

#endif
