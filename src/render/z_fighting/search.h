/**
 * @file
 * @brief What the parts of the search share.
 */
#ifndef DIOPTRE_RENDER_Z_FIGHTING_SEARCH_H
#define DIOPTRE_RENDER_Z_FIGHTING_SEARCH_H

#include "render/roundoff.h"
#include "render/z_fighting/z_fighting.h"

/** Relative gap below which faces coincide: roundings of a few operations on the scene's numbers.
 *  Double cannot tell them apart. */
#define COINCIDENT 0x1p-48

/** Cosine from which on two planes are nearly parallel. At larger angles they cross in a line
 *  whose rounding is a small fraction of a pixel. */
#define PARALLEL_COSINE 0.9999

/** Chance that a pixel is wrong where light in glass may miss a surface. */
#define GLASS_CHANCE 0.5

/** Largest number of pairs of shapes whose faces are compared, about 20 ms. Later pairs are not
 *  seen. */
enum { SHAPE_PAIRS_MAXIMUM = 1 << 15 };

/** A bounded shape. */
typedef struct BoundedShape {
    Aabbd box;               /**< Its bounding box, enlarged by #bound. */
    const SceneShape *shape; /**< The shape. */
    const Mesh *mesh;        /**< Its triangles; NULL: no mesh. */
    double bound;            /**< Largest gap that matters, scene units. */
} BoundedShape;

/** The state of the search. */
typedef struct Search {
    const Scene *scene;        /**< The scene. */
    Vec3d origin;              /**< #scene_local_origin */
    Vec3d right;               /**< To the right in the picture. */
    double half_width;         /**< Half the width of the picture at distance 1. */
    double half_height;        /**< Half its height. */
    bool has_secondary;        /**< Whether rays are reflected or refracted. */
    bool has_glass;            /**< Whether rays are refracted. */
    Aabbd secondary;           /**< Box from which they start. */
    Aabbd centers;             /**< Box around the centres of the shapes from which they start. */
    long shape_pairs;          /**< Pairs of shapes compared. */
    size_t vertices;           /**< Vertices compared. */
    double largest_coincident; /**< Largest share of a pair in #ZFighting.coincident. */
    ZFighting result;          /**< What is found. */
} Search;

/** What the rounding of a gap depends on. */
typedef struct GapScale {
    double height;    /**< Distance of the eye from the surfaces. */
    double distance;  /**< If one of them is transformed: distance of the eye from the point where
                           they are met. Else 0. */
    double magnitude; /**< Largest coordinate there. */
    bool is_glass;    /**< Whether one of them is transparent. */
} GapScale;

/** Counts a pair of boxes before it is compared. @return false where it is one too many: loops over
 *  pairs end there. */
static inline bool search_begin_pair(Search *search) {
    return search->result.pairs < Z_FIGHTING_PAIRS_MAXIMUM && ++search->result.pairs > 0;
}

/** @return The height of a point above the plane of a face, signed. */
static inline double height_above(const ShapeFace *face, Vec3d point) {
    return vec3d_dot(face->normal, vec3d_subtract(point, face->corners[0]));
}

/** @return Whether two boxes overlap. */
static inline bool aabbd_overlaps(const Aabbd *a, const Aabbd *b) {
    return a->low.x <= b->high.x && b->low.x <= a->high.x && a->low.y <= b->high.y &&
           b->low.y <= a->high.y && a->low.z <= b->high.z && b->low.z <= a->high.z;
}

/** @return Whether a shape is transparent. */
static inline bool is_glass(const Search *search, const SceneShape *shape) {
    return scene_material_is_transparent(&search->scene->materials[shape->material_index]);
}

/* --- roundings.c --- */

/** @return The largest gap between surfaces that float may see wrongly, scene units. */
double gap_bound(GapScale scale);

/** @return The mean chance that rounding inverts the order of two surfaces whose gap runs from one
 *          value to another. @param bound See gap_bound(). */
double chance_between(double low, double high, double bound);

/* --- faces.c --- */

/** @return The largest gap of a bounded shape that float may see the wrong way round, scene units.
 *  @param box Its bounding box. */
double shape_gap_bound(const Search *search, const Aabbd *box);

/** Compares the faces of two shapes. @param bound Largest gap that matters, scene units. */
void compare_flat_shapes(Search *search, const SceneShape *a, const SceneShape *b, double bound);

/** Compares the triangles of a mesh with the faces of another shape, which may be none. */
void compare_mesh(Search *search, const SceneShape *shape, const Mesh *mesh,
                  const SceneShape *other, double bound);

/** Compares the face of a light with a shape. @param bound Largest gap that matters, scene units.
 */
void compare_light_with_shape(Search *search, const ShapeFace *light, const SceneShape *shape,
                              const Mesh *mesh, double bound);

/* --- shells.c --- */

/** Compares two shapes if both are spheres, or both cylinders or cones. The gap between them is
 *  taken to be spread evenly over its range. @param bound Largest gap that matters, scene units. */
void compare_shells(Search *search, const SceneShape *shape_a, const SceneShape *shape_b,
                    double bound);

/* --- pairs.c --- */

/** Compares the shapes of a group with one another. */
void compare_group(Search *search, BoundedShape *shapes, size_t count);

/** Compares spheres whose boxes are nearly the same. */
void compare_spheres(Search *search, BoundedShape *spheres, size_t count);

/** Compares a plane with bounded shapes. */
void compare_plane_with_shapes(Search *search, const SceneShape *shape, const BoundedShape *shapes,
                               size_t count);

/** Compares planes with one another. @param planes Their shapes. */
void compare_planes(Search *search, const SceneShape *const *planes, size_t count);

#endif
