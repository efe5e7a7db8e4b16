/**
 * @file
 * @brief The ray tree of one pixel, with all numbers that its colour is computed from.
 *
 * The tracer records the rays while it traces them, so they are those of the picture, bit for bit.
 * All numbers are those of the engine, held exactly in double (of `f128x1`: rounded).
 */
#ifndef DIOPTRE_RAY_TREE_H
#define DIOPTRE_RAY_TREE_H

#include "dioptre/vec3d.h"

#include <stdbool.h>
#include <stddef.h>

/** The type of a ray. */
typedef enum {
    RAY_CAMERA,     /**< From the camera: the root of the tree. */
    RAY_SHADOW,     /**< From a surface to a light. */
    RAY_REFLECTION, /**< Reflected by a surface. */
    RAY_REFRACTION  /**< Refracted into or out of a transparent shape. */
} RayType;

/** Most rays of a tree: a limit of memory. */
enum { RAY_TREE_MAX_NODES = 1 << 20 };

/** Optics of a surface at a hit. Its colour without secondary rays is `emission + albedo (ambient +
 *  diffuse D) + specular S`, where D and S are the sums of #RayTreeNode.diffuse and
 *  #RayTreeNode.specular of its shadow rays, in their order. */
typedef struct RayTreeSurface {
    double epsilon;      /**< Offset of rays that leave the surface, scene units. */
    double ulps;         /**< The same in ulps of the largest coordinate of the point. */
    double cosine;       /**< Cosine of the angle of incidence. */
    bool is_inside;      /**< Whether the ray comes from inside. */
    bool is_transparent; /**< Whether light is refracted; otherwise the next five are unset. */
    bool is_overridden;  /**< Whether a later shape overrides the interface. */
    bool is_total;       /**< Whether reflection is total. */
    double ior_from;     /**< Index of refraction on the ray's side. */
    double ior_to;       /**< Index of refraction behind the surface. */
    double fresnel;      /**< Fresnel reflectance. */
    Rgbd emission;       /**< Emitted light. */
    Rgbd albedo;         /**< Diffuse albedo, weighted, and times the texture's. */
    Rgbd specular;       /**< Weight of highlights. */
    Rgbd ambient;        /**< Ambient light. */
    double diffuse;      /**< Weight of diffuse light of the lights. */
    Rgbd reflect_weight; /**< Weight of a reflected ray's colour, whether it was traced or not. */
    Rgbd refract_weight; /**< Weight of a refracted ray's colour, likewise. */
} RayTreeSurface;

/** A ray of the tree. */
typedef struct RayTreeNode {
    int parent;        /**< Index of the ray that it comes from, below its own; -1: none. */
    RayType kind;      /**< Its type. */
    int depth;         /**< Number of its ancestors. */
    Vec3d origin;      /**< Its origin, scene units. */
    Vec3d direction;   /**< Its direction, a unit vector. */
    double limit;      /**< Its length, scene units: to the light, or infinity. */
    double throughput; /**< Largest channel of the product of weights from the pixel; of shadow
                            rays that of the surface. */
    Rgbd weight;       /**< Weight of its colour in that of its parent. */
    bool is_hit;       /**< Whether it hits a shape or a light; of a shadow ray: whether no light
                            arrives. */
    int shape;         /**< Index of the shape that it hits; -1: none. */
    int light;         /**< Index of the light that it is sent to, or hits; -1: none. */
    double distance;   /**< Distance of the hit, scene units; infinity: none. */
    Vec3d point;       /**< The hit point. */
    Vec3d normal;      /**< Outward unit normal there. */
    RayTreeSurface surface; /**< Optics of the surface hit; not of shadow rays. */
    Rgbd diffuse;           /**< Of shadow rays: V L f max(0, n . l), for diffuse light. */
    Rgbd specular;          /**< Of shadow rays: V L f max(0, r . v)^shininess, for highlights. */
    Rgbd transmittance;     /**< Of shadow rays: share of light that transparent shapes leave. */
    Rgbd local_color; /**< Radiance without secondary rays: of the sky, a light or a surface. */
    Rgbd color;       /**< Radiance: #local_color plus the weighted colours of secondary
                           rays. */
} RayTreeNode;

/** The ray tree of one pixel. Starts as `{0}`; freed by #ray_tree_deinit. */
typedef struct RayTree {
    RayTreeNode *nodes; /**< The rays, each after its parent; owned. */
    size_t count;       /**< Number of rays. */
    size_t capacity;    /**< Number of rays that the memory is enough for. */
    int current;        /**< While recording: the ray being traced. */
    bool is_truncated;  /**< Whether rays are missing for lack of memory, or #RAY_TREE_MAX_NODES. */
} RayTree;

/** Frees the rays of a tree and empties it. */
void ray_tree_deinit(RayTree *tree);

#endif
