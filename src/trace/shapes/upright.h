/**
 * @file
 * @brief How pictures lie on flat shapes: upright, as somebody sees them who looks at the front.
 */
#ifndef DIOPTRE_TRACE_SHAPES_UPRIGHT_H
#define DIOPTRE_TRACE_SHAPES_UPRIGHT_H

#include "trace/shape.h"

/** Which way a picture lies on a flat shape. */
typedef struct Upright {
    WidePoint right; /**< Its right, a unit vector. */
    WidePoint up;    /**< Its up, a unit vector. */
} Upright;

/**
 * @return Which way a picture lies: its up is as near to y as the shape allows; on the ground, and
 *         on what lies more than it stands, as near to -z, which is up for who looks along -z.
 * @param n  The shape's unit normal, which points at who sees the picture.
 */
static inline Upright upright_of(WidePoint n) {
    wide_scalar x = n.x < 0 ? -n.x : n.x, y = n.y < 0 ? -n.y : n.y, z = n.z < 0 ? -n.z : n.z;
    bool lies = y > x && y > z;
    WidePoint wanted = lies ? (WidePoint){0, 0, n.y > 0 ? -1 : 1} : (WidePoint){0, 1, 0};
    WidePoint across = wide_point_scale(n, wide_point_dot(wanted, n));
    WidePoint up = wide_point_normalize(wide_point_subtract(wanted, across));
    return (Upright){wide_point_cross(up, n), up};
}

/** @return How far points are along a direction. @param arm From some zero. @param way The
 *  direction. */
INLINE real arm_along(WideVector arm, WidePoint way) {
    return narrow(wide_dot(arm, wide_vector_of(way)));
}

/** @return Where on a picture points of a disk lie. @param arm From its middle, in radii.
 *  @param upright Which way the picture lies. */
INLINE TexturePlace circle_texture_place(WideVector arm, const Upright *upright) {
    const real half = real_of((scalar)0.5f);
    return (TexturePlace){.u = half + half * arm_along(arm, upright->right),
                          .v = half + half * arm_along(arm, upright->up),
                          .around_u = mask_of(false),
                          .around_v = mask_of(false)};
}

#endif
