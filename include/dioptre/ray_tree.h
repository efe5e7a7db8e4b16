/**
 * @file
 * @brief The probe: the tree of rays of one pixel, with all numbers that its colour comes of.
 *
 * The rays are noted while the tracer itself follows them, so they are those of the picture, bit
 * for bit. All numbers are those of the engine, held exactly in double (of `f128x1`: rounded).
 */
#ifndef DIOPTRE_RAY_TREE_H
#define DIOPTRE_RAY_TREE_H

#include "dioptre/vec3d.h"

#include <stdbool.h>
#include <stddef.h>

/** What kind of ray it is. */
typedef enum {
    RAY_CAMERA,     /**< From the camera: the first of a tree. */
    RAY_SHADOW,     /**< From a surface to a lamp. */
    RAY_REFLECTION, /**< Mirrored by a surface. */
    RAY_REFRACTION  /**< Through the surface of something transparent. */
} RayType;

/** Most rays of a tree: a guard for the memory. */
enum { RAY_TREE_MAX_NODES = 1 << 20 };

/** What a surface does with light: its colour is `emission + body (ambient + diffuse M) +
 *  highlight H`, where M and H are the sums of #RayTreeNode.diffuse and #RayTreeNode.specular of
 * its shadow rays, in their order. */
typedef struct RayTreeSurface {
    double epsilon;      /**< How far from it rays that leave it start, scene units. */
    double ulps;         /**< The same in ulps of the largest coordinate of the point. */
    double cosine;       /**< Of the angle between the ray and the normal on its side. */
    bool is_inside;      /**< Whether it was met from inside. */
    bool is_transparent; /**< Whether light goes through; else the next five say nothing. */
    bool is_overridden;  /**< Whether it is not there: a later shape is in its place. */
    bool is_total;       /**< Whether all is mirrored: there is no way to refract. */
    double ior_from;     /**< Index of refraction where the ray comes from. */
    double ior_to;       /**< Index of refraction behind. */
    double fresnel;      /**< Fresnel's share: what is mirrored of the light that could go through.
                          */
    Rgbd emission;       /**< Light of its own. */
    Rgbd albedo;         /**< Colour of the body, weighted, and times that of a picture. */
    Rgbd specular;       /**< Weight of highlights. */
    Rgbd ambient;        /**< Light from everywhere. */
    double diffuse;      /**< Weight of the lamps' matt shine. */
    Rgbd reflect_weight; /**< Share of what a mirrored ray brings back, whether there is one or not.
                          */
    Rgbd refract_weight; /**< The same of a refracted ray. */
} RayTreeSurface;

/** One ray of a tree. */
typedef struct RayTreeNode {
    int parent;        /**< Place of the ray that it comes from, lower than its own; -1: none. */
    RayType kind;      /**< What it is. */
    int depth;         /**< Rays before it on its way: 0 for the camera's. */
    Vec3d origin;      /**< Where it starts, scene units. */
    Vec3d direction;   /**< Which way, one long. */
    double limit;      /**< How far it goes, scene units: to the lamp, or infinity. */
    double throughput; /**< Largest share with which a primary of what it brings back enters the
                        picture; of a shadow ray: what its surface brings back. */
    Rgbd weight;       /**< What is added to its parent's colour of what it brings back. */
    bool is_hit; /**< Whether it met a shape or a lamp; of a shadow ray: whether the lamp does not
                      reach the point. */
    int shape;   /**< Place in the scene of the shape that it met; -1: none. */
    int light;   /**< Place of the lamp that it was sent to, or that it met; -1: none. */
    double distance;        /**< Where it met that, scene units; infinity: nothing. */
    Vec3d point;            /**< Where that is. */
    Vec3d normal;           /**< The surface's unit normal there, outwards. */
    RayTreeSurface surface; /**< What it met, if that is a shape; not of shadow rays. */
    Rgbd diffuse;  /**< Of shadow rays: V L f max(0, n . l), what the lamp gives for matt shine. */
    Rgbd specular; /**< Of shadow rays: V L f max(0, r . v)^shininess, for highlights. */
    Rgbd transmittance; /**< Of shadow rays: share of the light that glass on its way leaves. */
    Rgbd local_color; /**< What it brings back without mirrored and refracted rays: of the sky, of a
                    lamp, of the surface's body; of a shadow ray all. */
    Rgbd color; /**< What it brings back: #local_color, then each mirrored and refracted child's
                   colour times its share is added. */
} RayTreeNode;

/** The tree of rays of one pixel. Starts as `{0}`; given back by #ray_tree_deinit. */
typedef struct RayTree {
    RayTreeNode *nodes; /**< The rays, each behind the one that it comes from; owned. */
    size_t count;       /**< How many. */
    size_t capacity;    /**< For how many there is room. */
    int current;        /**< While it is noted: the ray that is being followed. */
    bool is_truncated; /**< Whether memory or #RAY_TREE_MAX_NODES did not do: then rays are missing.
                        */
} RayTree;

/** Gives the rays back. @param probe The tree, empty afterwards. */
void ray_tree_deinit(RayTree *probe);

#endif
