/**
 * @file
 * @brief How pictures lie on flat shapes: upright, as somebody sees them who looks at the front.
 */
#ifndef DIOPTRE_TRACE_SHAPES_UV_FRAME_H
#define DIOPTRE_TRACE_SHAPES_UV_FRAME_H

#include "trace/shapes/shape.h"

/** Which way a picture lies on a flat shape. */
typedef struct UvFrame {
    Vec3sw right; /**< Its right, a unit vector. */
    Vec3sw up;    /**< Its up, a unit vector. */
} UvFrame;

/**
 * @return Which way a picture lies: its up is as near to y as the shape allows; on the ground, and
 *         on what lies more than it stands, as near to -z, which is up for who looks along -z.
 * @param n  The shape's unit normal, which points at who sees the picture.
 */
static inline UvFrame uv_frame_of(Vec3sw n) {
    wide_scalar x = n.x < 0 ? -n.x : n.x, y = n.y < 0 ? -n.y : n.y, z = n.z < 0 ? -n.z : n.z;
    bool is_horizontal = y > x && y > z;
    Vec3sw target_up = is_horizontal ? (Vec3sw){0, 0, n.y > 0 ? -1 : 1} : (Vec3sw){0, 1, 0};
    Vec3sw across = vec3sw_scale(n, vec3sw_dot(target_up, n));
    Vec3sw up = vec3sw_normalize(vec3sw_subtract(target_up, across));
    return (UvFrame){vec3sw_cross(up, n), up};
}

/** @return How far points are along a direction. */
INLINE real component_along(Vec3w offset, Vec3sw axis) {
    return narrow(vec3w_dot(offset, vec3w_splat(axis)));
}

/** @return Where on a picture points of a disk lie. @param offset From its middle, in radii.
 *  @param frame Which way the picture lies. */
INLINE TextureUv circle_texture_uv(Vec3w offset, const UvFrame *frame) {
    const real half = real_of((scalar)0.5f);
    return (TextureUv){.u = half + half * component_along(offset, frame->right),
                       .v = half + half * component_along(offset, frame->up),
                       .wrap_u = mask_of(false),
                       .wrap_v = mask_of(false)};
}

#endif
