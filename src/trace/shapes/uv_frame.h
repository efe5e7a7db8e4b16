/**
 * @file
 * @brief Orientation of textures on flat shapes: upright for a viewer in front.
 */
#ifndef DIOPTRE_TRACE_SHAPES_UV_FRAME_H
#define DIOPTRE_TRACE_SHAPES_UV_FRAME_H

#include "trace/shapes/shape.h"

/** Axes of a texture on a flat shape. */
typedef struct UvFrame {
    Vec3sw right; /**< Unit vector to the right of the picture. */
    Vec3sw up;    /**< Unit vector to its upper edge. */
} UvFrame;

/**
 * @return The axes: up is as close to y as the shape allows; on shapes that lie more than they
 *         stand, as close to -z, which is up for a camera that looks along -z.
 * @param n  Unit normal of the shape, towards the viewer of the picture.
 */
static inline UvFrame uv_frame_of(Vec3sw n) {
    wide_scalar x = n.x < 0 ? -n.x : n.x, y = n.y < 0 ? -n.y : n.y, z = n.z < 0 ? -n.z : n.z;
    bool is_horizontal = y > x && y > z;
    Vec3sw target_up = is_horizontal ? (Vec3sw){0, 0, n.y > 0 ? -1 : 1} : (Vec3sw){0, 1, 0};
    Vec3sw across = vec3sw_scale(n, vec3sw_dot(target_up, n));
    Vec3sw up = vec3sw_normalize(vec3sw_subtract(target_up, across));
    return (UvFrame){vec3sw_cross(up, n), up};
}

/** @return Components of vectors along a unit vector. */
INLINE real component_along(Vec3w offset, Vec3sw axis) {
    return narrow(vec3w_dot(offset, vec3w_splat(axis)));
}

/** @return Texture coordinates on a disk. @param offset From the centre, in radii. */
INLINE TextureUv circle_texture_uv(Vec3w offset, const UvFrame *frame) {
    const real half = real_of((scalar)0.5f);
    return (TextureUv){.u = half + half * component_along(offset, frame->right),
                       .v = half + half * component_along(offset, frame->up),
                       .wrap_u = mask_of(false),
                       .wrap_v = mask_of(false)};
}

#endif
