/**
 * @file
 * @brief Descriptions of shapes: what a scene file says about each kind, and what is known of it
 *        without a tracer.
 *
 * A new kind of shape `cone` is
 *  - a struct `ConeParameters` and the entry `X(cone)` of #SHAPES in this file,
 *  - its description `scene_cone_class` in `src/scene/shapes/cone.c`,
 *  - its geometry `cone_class` in `src/trace/shapes/cone.c`, listed in `src/trace/all.c`,
 *  - a row in `tests/contract_shapes.h` and a scene in `scenes/`.
 */
#ifndef DIOPTRE_SHAPE_H
#define DIOPTRE_SHAPE_H

#include "dioptre/mesh.h"
#include "dioptre/sdf.h"

typedef struct Scene Scene;
typedef struct SceneShape SceneShape;

/**
 * The registry: all kinds of shapes, in the order of the documentation. It defines
 * #SceneShape.class_index, #scene_shape_classes and the tracer's list of the same order.
 */
#define SHAPES(X)                                                                                  \
    X(sphere)                                                                                      \
    X(plane)                                                                                       \
    X(quad)                                                                                        \
    X(box)                                                                                         \
    X(disk)                                                                                        \
    X(cylinder)                                                                                    \
    X(triangle)                                                                                    \
    X(mesh)                                                                                        \
    X(sdf)

/** Parameters of `sphere`. */
typedef struct SphereParameters {
    Vec3d center;  /**< Centre. */
    double radius; /**< Radius, scene units. */
} SphereParameters;

/** Parameters of `plane`, which is infinite. */
typedef struct PlaneParameters {
    Vec3d point;  /**< A point of the plane. */
    Vec3d normal; /**< Normal, of any length. */
} PlaneParameters;

/** Parameters of `quad`, a parallelogram. */
typedef struct QuadParameters {
    Vec3d corner; /**< One corner. */
    Vec3d u;      /**< Edge to the next corner. */
    Vec3d v;      /**< Edge to the previous corner. */
} QuadParameters;

/** Parameters of `box`, whose edges are parallel to the axes. */
typedef struct BoxParameters {
    Vec3d low;  /**< Lowest corner: the field `min`. */
    Vec3d high; /**< Highest corner: the field `max`. */
} BoxParameters;

/** Parameters of `disk`, the inside of a circle. */
typedef struct DiskParameters {
    Vec3d center;  /**< Centre. */
    Vec3d normal;  /**< Normal, of any length. */
    double radius; /**< Radius, scene units. */
} DiskParameters;

/** Parameters of `cylinder`. */
typedef struct CylinderParameters {
    Vec3d base;    /**< Centre of one end. */
    Vec3d top;     /**< Centre of the other end. */
    double radius; /**< Radius, scene units. */
    bool capped;   /**< Whether two disks close the ends. */
} CylinderParameters;

/** Parameters of `triangle`. */
typedef struct TriangleParameters {
    Vec3d corners[3]; /**< Vertices. */
    Vec3d normals[3]; /**< Normals at the vertices, of any length; used if #is_smooth. */
    Uvd uvs[3];       /**< Texture coordinates at the vertices. */
    bool is_smooth;   /**< Whether the scene gives the normals; #Keyword.finish sets it. */
} TriangleParameters;

/** Where the normals of a mesh come from. */
typedef enum {
    NORMALS_FROM_FILE, /**< The file's; smooth where it has none. */
    NORMALS_SMOOTH,    /**< Averages of the triangles around each vertex. */
    NORMALS_FLAT       /**< One normal per triangle. */
} NormalSource;

/** Number of values of #NormalSource. */
enum { NORMAL_SOURCE_COUNT = 3 };

/** Parameters of `mesh`. */
typedef struct MeshShapeParameters {
    size_t file; /**< Index of the mesh file in #Scene.meshes. */
    int normals; /**< A #NormalSource. */
} MeshShapeParameters;

/** Parameters of `sdf`, the surface of a distance field. */
typedef struct SdfShapeParameters {
    const Sdf *field; /**< Distance field; owned by the scene. */
    double tolerance; /**< Distance from the surface that counts as a hit, scene units. */
    int max_steps;    /**< Largest number of steps per ray. */
} SdfShapeParameters;

/** What the description of a shape says about it, without a tracer. */
typedef struct ShapeFacts {
    Aabbd bounds;     /**< Bounding box; infinite along the axes where the shape is unbounded. */
    bool is_flat;     /**< Whether all faces are flat: reflections do not make rays diverge. */
    const Mesh *mesh; /**< Its triangles; NULL: no mesh, or not read yet. */
    bool is_smooth;   /**< Whether #mesh is shaded with interpolated normals. */
    const Sdf *sdf;   /**< Its distance field; NULL: none. */
    double tolerance; /**< For #sdf: distance that counts as a hit, scene units. */
} ShapeFacts;

/** Description of a kind of shape. */
typedef struct SceneShapeClass {
    Keyword keyword; /**< Base: name, fields, defaults and checks in the scene language. */

    /**
     * Finds what is known of a shape before its transform.
     * @param parameters  The struct that #keyword describes, finished.
     * @param scene       The scene of the shape, for its meshes.
     * @return The facts.
     */
    ShapeFacts (*facts)(const void *parameters, const Scene *scene);

    /**
     * Multiplies the tolerance of sphere tracing, within the range of its field. NULL: shapes of
     * this kind have none.
     * @param[in,out] parameters  The struct that #keyword describes, finished.
     * @param factor              Factor, above 0.
     */
    void (*scale_tolerance)(void *parameters, double factor);
} SceneShapeClass;

/** Descriptions of all kinds of shapes in the order of #SHAPES; NULL ends the list. */
extern const SceneShapeClass *const scene_shape_classes[];

/** Keywords of #scene_shape_classes in the same order; NULL ends the list. */
extern const Keyword *const scene_shape_keywords[];

/**
 * Finds a kind of shape by its keyword.
 * @param name  The keyword, such as `sphere`.
 * @return Its index in #scene_shape_classes; that of the final NULL if there is no such kind.
 */
size_t scene_shape_find(const char *name);

/**
 * Finds what is known of a shape of a scene.
 * @param scene  The scene.
 * @param shape  One of its shapes.
 * @return The facts; the bounding box is that of the transformed shape.
 */
ShapeFacts scene_shape_facts(const Scene *scene, const SceneShape *shape);

/**
 * Finds the bounding box of all bounded shapes of a scene.
 * @param scene  The scene.
 * @return The box; its lowest corner is above its highest one if no shape is bounded.
 */
Aabbd scene_bounds(const Scene *scene);

/**
 * Finds the origin for the coordinates of a tracer.
 *
 * A float is exact to 1 / 2^24 of its value: in a scene of size 1 at a distance of 10,000 from zero
 * all coordinates are wrong by up to a thousandth. The scene file gives them in double, which is
 * enough. Tracers therefore use coordinates relative to the middle of the shapes if it is far away.
 * @param scene  The scene.
 * @return The middle of all bounded shapes, rounded to few digits, if it is much farther from zero
 *         than the shapes are large; else zero.
 */
Vec3d scene_local_origin(const Scene *scene);

/**
 * @return Half the bounding box of a circle: radius * sqrt(1 - n_i^2) along each axis i, computed
 *         from the other two components, because 1 - n_i^2 would cancel.
 * @param normal  Unit normal of the plane of the circle.
 * @param radius  Radius, scene units.
 */
static inline Vec3d circle_extent(Vec3d normal, double radius) {
    double x = normal.x, y = normal.y, z = normal.z;
    return (Vec3d){radius * sqrt(y * y + z * z), radius * sqrt(z * z + x * x),
                   radius * sqrt(x * x + y * y)};
}

#endif
