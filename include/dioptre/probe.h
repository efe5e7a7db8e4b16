/**
 * @file
 * @brief The probe: the tree of rays of one pixel, with all numbers that its colour comes of.
 *
 * The rays are noted while the tracer itself follows them, so they are those of the picture, bit
 * for bit. All numbers are those of the engine, held exactly in double (of `f128x1`: rounded).
 */
#ifndef DIOPTRE_PROBE_H
#define DIOPTRE_PROBE_H

#include "dioptre/vector3.h"

#include <stdbool.h>
#include <stddef.h>

/** What kind of ray it is. */
typedef enum {
    PROBE_CAMERA, /**< From the camera: the first of a tree. */
    PROBE_SHADOW, /**< From a surface to a lamp. */
    PROBE_MIRROR, /**< Mirrored by a surface. */
    PROBE_REFRACT /**< Through the surface of something transparent. */
} ProbeKind;

/** Most rays of a tree: a guard for the memory. */
enum { PROBE_RAYS_MAXIMUM = 1 << 20 };

/** What a surface does with light: its colour is `emission + body (ambient + diffuse M) +
 *  highlight H`, where M and H are the sums of #ProbeRay.matt and #ProbeRay.shine of its shadow
 *  rays, in their order. */
typedef struct ProbeSurface {
    double epsilon;      /**< How far from it rays that leave it start, scene units. */
    double ulps;         /**< The same in ulps of the largest coordinate of the point. */
    double cosine;       /**< Of the angle between the ray and the normal on its side. */
    bool is_inside;      /**< Whether it was met from inside. */
    bool is_transparent; /**< Whether light goes through; else the next five say nothing. */
    bool is_hidden;      /**< Whether it is not there: a later shape is in its place. */
    bool is_total;       /**< Whether all is mirrored: there is no way to refract. */
    double before;       /**< Index of refraction where the ray comes from. */
    double behind;       /**< Index of refraction behind. */
    double fresnel;      /**< Fresnel's share: what is mirrored of the light that could go through.
                          */
    Color emission;      /**< Light of its own. */
    Color body;          /**< Colour of the body, weighted, and times that of a picture. */
    Color highlight;     /**< Weight of highlights. */
    Color ambient;       /**< Light from everywhere. */
    double diffuse;      /**< Weight of the lamps' matt shine. */
    Color mirrored;  /**< Share of what a mirrored ray brings back, whether there is one or not. */
    Color refracted; /**< The same of a refracted ray. */
} ProbeSurface;

/** One ray of a tree. */
typedef struct ProbeRay {
    int parent;        /**< Place of the ray that it comes from, lower than its own; -1: none. */
    ProbeKind kind;    /**< What it is. */
    int depth;         /**< Rays before it on its way: 0 for the camera's. */
    Vector3 origin;    /**< Where it starts, scene units. */
    Vector3 direction; /**< Which way, one long. */
    double limit;      /**< How far it goes, scene units: to the lamp, or infinity. */
    double weight;     /**< Largest share with which a primary of what it brings back enters the
                            picture; of a shadow ray: what its surface brings back. */
    Color share;       /**< What is added to its parent's colour of what it brings back. */
    bool is_hit; /**< Whether it met a shape or a lamp; of a shadow ray: whether the lamp does not
                      reach the point. */
    int shape;   /**< Place in the scene of the shape that it met; -1: none. */
    int lamp;    /**< Place of the lamp that it was sent to, or that it met; -1: none. */
    double distance;      /**< Where it met that, scene units; infinity: nothing. */
    Vector3 point;        /**< Where that is. */
    Vector3 normal;       /**< The surface's unit normal there, outwards. */
    ProbeSurface surface; /**< What it met, if that is a shape; not of shadow rays. */
    Color matt;   /**< Of shadow rays: V L f max(0, n . l), what the lamp gives for matt shine. */
    Color shine;  /**< Of shadow rays: V L f max(0, r . v)^shininess, for highlights. */
    Color passed; /**< Of shadow rays: share of the light that glass on its way leaves. */
    Color own;    /**< What it brings back without mirrored and refracted rays: of the sky, of a
                       lamp, of the surface's body; of a shadow ray all. */
    Color color;  /**< What it brings back: #own, then each mirrored and refracted child's colour
                       times its share is added. */
} ProbeRay;

/** The tree of rays of one pixel. Starts as `{0}`; given back by #probe_release. */
typedef struct Probe {
    ProbeRay *rays;  /**< The rays, each behind the one that it comes from; owned. */
    size_t count;    /**< How many. */
    size_t capacity; /**< For how many there is room. */
    int current;     /**< While it is noted: the ray that is being followed. */
    bool is_short; /**< Whether memory or #PROBE_RAYS_MAXIMUM did not do: then rays are missing. */
} Probe;

/** Gives the rays back. @param probe The tree, empty afterwards. */
void probe_release(Probe *probe);

#endif
