/**
 * @file
 * @brief Noting the rays of one pixel while they are followed: see dioptre/ray_tree.h.
 *
 * The packet that is noted has one ray, in its first lane, and so have those that come of it.
 * Where nobody asks, a packet costs a few looks at a pointer.
 */
#ifndef DIOPTRE_TRACE_TRACER_RAY_TREE_RECORDER_H
#define DIOPTRE_TRACE_TRACER_RAY_TREE_RECORDER_H

#include "trace/glass/dielectric.h"
#include "trace/lights/light.h"

/**
 * Notes a ray that is about to be followed, as a child of the current one. It is the current one
 * now.
 * @param[in,out] ray_tree  The tree; the ray is the camera's where it is empty.
 * @param throughput  Of what it brings back, that goes to its parent.
 */
void ray_tree_push(RayTree *ray_tree, RayType kind, const Packet *packet, Rgb weight,
                   real throughput);

/** Notes what the current ray has met. @param surface The surface; its packet has a probe.
 *  @param offset How rays leave it. */
void ray_tree_record_surface(const SurfaceHit *surface, const RayOffset *offset);

/** Notes what becomes of the current ray at glass. */
void ray_tree_record_dielectric(const SurfaceHit *surface, const DielectricHit *dielectric);

/**
 * Notes a shadow ray from the current ray's surface.
 * @param sample  What the lamp would give, with the ray.
 * @param occluded  Whether it does not reach the point.
 */
void ray_tree_record_shadow(const ShapeSet *shapes, const SurfaceHit *surface, size_t light_index,
                            const LightSample *sample, mask occluded,
                            const DirectLighting *lighting);

/**
 * Notes what the body of the current ray's surface sends back.
 * @param dielectric  What becomes of the ray at glass; NULL: there is none.
 * @param texture_color  The picture's colour; NULL: it shows none.
 */
void ray_tree_record_shading(const SurfaceHit *surface, const DielectricHit *dielectric,
                             const Rgb *texture_color, Rgb color);

/** Notes what the current ray has brought back; its parent is the current one now. */
void ray_tree_pop(RayTree *ray_tree, Rgb color);

/** Ends a tree: names the lamps that were met, and gives places in the scene. @param origin Where
 *  in the scene the tracer's coordinates begin. */
void ray_tree_finish(RayTree *ray_tree, Vec3d origin);

#endif
