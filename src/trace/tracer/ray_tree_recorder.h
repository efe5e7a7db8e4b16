/**
 * @file
 * @brief Recording of the tree of rays of one pixel. See dioptre/engine.h.
 *
 * The recorded packet has one ray, in its first lane, and so have the packets of its secondary
 * rays. The current ray is the one that is being traced. Without a recorder, a packet costs a few
 * tests of a pointer.
 */
#ifndef DIOPTRE_TRACE_TRACER_RAY_TREE_RECORDER_H
#define DIOPTRE_TRACE_TRACER_RAY_TREE_RECORDER_H

#include "trace/glass/dielectric.h"
#include "trace/lights/light.h"

/**
 * Records a ray that is traced next, as a child of the current ray, and makes it the current ray.
 * @param[in,out] ray_tree  The tree; the first ray is the camera's.
 * @param weight  The factor of its colour in the colour of its parent.
 */
void ray_tree_push(RayTree *ray_tree, RayType type, const RayState *rays, Rgb weight);

/** Records what the current ray hits. @param offset How far from the surface rays start. */
void ray_tree_record_surface(const SurfaceHit *surface, const RayOffset *offset);

/** Records the steps of sphere tracing of the current ray: of the shape that it hits, or of that
 *  which takes most steps. */
void ray_tree_record_march(const ShapeSet *shapes, const SurfaceHit *surface);

/** Records what happens to the current ray at a transparent surface. */
void ray_tree_record_dielectric(const SurfaceHit *surface);

/**
 * Records a shadow ray from the current ray's surface.
 * @param light  The light.
 * @param sample  The light sample with the shadow ray.
 * @param occluded  Whether the light does not reach the point.
 * @param lighting  The light of this light alone.
 */
void ray_tree_record_shadow(const ShapeSet *shapes, const SurfaceHit *surface, size_t light_index,
                            const Light *light, const LightSample *sample, mask occluded,
                            const DirectLighting *lighting);

/**
 * Records the shading of the current ray's surface.
 * @param texture_color  The colour of the texture; NULL: no shape has one.
 * @param color  The colour without reflection and refraction.
 */
void ray_tree_record_shading(const SurfaceHit *surface, const Rgb *texture_color, Rgb color);

/** Records the colour of the current ray, and makes its parent the current ray. */
void ray_tree_pop(RayTree *ray_tree, Rgb color);

/** Gives the first ray the colour of its pixel: that of the tree with the light of merged rays. See
 *  #RayTree.merged_light. */
void ray_tree_set_pixel(RayTree *ray_tree, Rgb color);

/** Completes a tree: points are moved into the
 * coordinates of the scene. @param origin The origin of the tracer's coordinates. */
void ray_tree_finish(RayTree *ray_tree, Vec3d origin);

#endif
