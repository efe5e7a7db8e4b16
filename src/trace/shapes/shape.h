/**
 * @file
 * @brief The class Shape: what rays can meet.
 *
 * Every shape is an object that starts with #Shape and a class that fills the table #ShapeClass.
 * `include/dioptre/scene.h` describes how to add a shape.
 */
#ifndef DIOPTRE_TRACE_SHAPES_SHAPE_H
#define DIOPTRE_TRACE_SHAPES_SHAPE_H

#include "dioptre/engine.h"
#include "dioptre/scene.h"
#include "trace/tracer/ray.h"

typedef struct Shape Shape;
typedef struct Packet Packet;
typedef struct Beam Beam;
typedef struct PacketIntervals PacketIntervals;
typedef struct PlaneEquation PlaneEquation;
typedef struct MeshBvhCache MeshBvhCache;

/** A bounding box along the axes, rounded outwards; infinite where a shape is unbounded. */
typedef struct Aabbs {
    scalar low[3];  /**< Lowest coordinates. */
    scalar high[3]; /**< Highest coordinates. */
} Aabbs;

/**
 * Texture coordinates of LANES points: (0, 0) is the lower left corner of the picture, (1, 1) its
 * upper right corner.
 */
typedef struct TextureUv {
    real u;      /**< To the right. */
    real v;      /**< Up. */
    mask wrap_u; /**< Whether the picture repeats beyond its left and right edges. */
    mask wrap_v; /**< Whether it repeats beyond its lower and upper edges. */
} TextureUv;

/** The steps of sphere tracing of one ray, as they are recorded. */
typedef struct MarchLog {
    RayMarchStep *steps; /**< The steps; not owned. */
    size_t count;        /**< Number of steps. */
    size_t capacity;     /**< Room for steps; those beyond are left out. */
    double length;       /**< Length of the ray's direction. */
    uint64_t operations; /**< Operations on distances in all steps. */
} MarchLog;

/** Methods of the few kinds of shapes that are more than a primitive: meshes, distance fields and
 *  transformed shapes. Each method may be NULL. */
typedef struct ShapeExtension {
    /** @return Bytes that an object needs behind itself: see #shape_tail. NULL: none.
     *  @param parameters The parameter struct of the shape, finished. */
    size_t (*tail_size)(const void *parameters);

    /**
     * Connects a new object with data that shapes of a tracer share. NULL: there is none.
     * @param self         The object, after #ShapeClass.init.
     * @param scene_shape  The shape in the scene.
     * @return false without memory.
     */
    bool (*bind)(Shape *self, const SceneShape *scene_shape, MeshBvhCache *meshes, Error *error);

    bool has_bvh; /**< Whether the shape has its own BVH. */

    /**
     * Intersects a whole packet. NULL: the caller calls #ShapeClass.is_hit for each vector of rays.
     * #closest_hits and #occluded come together.
     * @param[in,out] hits  Nearest hits so far, one per vector of rays.
     */
    void (*closest_hits)(const Shape *self, const Packet *packet, Hit *hits);

    /** Finds the rays of a packet that the shape occludes. @param[in,out] occluded The occluded
     *  rays so far; they are not tested again. */
    void (*occluded)(const Shape *self, const Packet *packet, mask *occluded);

    /**
     * Counts the steps of sphere tracing, for the AOVs. NULL: there are none.
     * @param active  Lanes that count; the result in other lanes is undefined.
     * @param limit   Largest distance.
     * @param log     Gets the steps and operations of the first lane; NULL: steps are only counted.
     * @return Number of steps per ray.
     */
    real (*count_steps)(const Shape *self, const Ray *ray, mask active, real limit, MarchLog *log);
} ShapeExtension;

/** Whether rays that leave a shape, from beyond the error bound of the hit, may meet it again. */
typedef enum ShapeForm {
    FORM_ANY,    /**< They may. */
    FORM_CONVEX, /**< The surface of a convex solid: not those that leave it outwards. */
    FORM_FLAT    /**< A part of a plane: none. */
} ShapeForm;

/** The table of methods of a class of shapes. */
typedef struct ShapeClass {
    size_t size; /**< Bytes of an object, a multiple of its alignment. */

    ShapeForm form; /**< Whether rays that leave the shape may meet it again. */

    /**
     * Initialises an object. Its base is already filled.
     * @param self        Memory of #size bytes, and #ShapeExtension.tail_size behind.
     * @param parameters  The parameter struct of the shape (dioptre/scene.h), finished.
     */
    void (*init)(Shape *self, const void *parameters);

    /**
     * Intersects LANES rays with the shape: whether, at which point and with which normal.
     * @param active       Lanes that count; others are neither read nor written.
     * @param[in,out] hit  Nearest hits so far, replaced in the lanes where this one is nearer.
     * @return The replaced lanes.
     */
    mask (*is_hit)(const Shape *self, const Ray *ray, mask active, Hit *hit);

    /**
     * Finds the rays that meet the shape before a limit: shadow rays.
     * @param limit  Distances at or beyond it do not count.
     * @return The lanes that are occluded.
     */
    mask (*is_occluding)(const Shape *self, const Ray *ray, mask active, real limit);

    /** @return How far the shape reaches, no less: the most of direction . (p - from) for its
     * points p, and for points beside them by roundings or by #NARROW_BEAM_SLACK. NULL: only its
     * box tells. @param directions Of any length, one per lane. */
    real (*support)(const Shape *self, Vec3s from, Vec3 directions);

    /** @return Whether all rays to a point surely miss the shape. NULL: #support tells. @param
     *  intervals Those of the rays; they have a #PacketIntervals.region. */
    bool (*misses_to_point)(const Shape *self, const PacketIntervals *intervals);

    /** @return Whether the lines of all rays of a beam surely meet it. NULL: nobody knows; with a
     *  #plane, those do that meet the plane. */
    bool (*covers)(const Shape *self, const Beam *beam);

    /** @return The plane in which the shape lies: its hits are plane_equation_surface(). NULL:
     *  none. */
    const PlaneEquation *(*plane)(const Shape *self);

    /** #is_hit for all rays of a packet with a beam: to the bit the same, for less. NULL: there is
     *  none. @return Whether it is done; false: #is_hit is called for each vector of rays. */
    bool (*beam_hits)(const Shape *self, const Packet *packet, Hit *hits);

    /** @return The bounding box. */
    Aabbs (*bounds)(const Shape *self);

    /**
     * Finds texture coordinates; called for materials with a texture only. NULL: (0, 0) everywhere.
     * @param hit    The hits.
     * @param lanes  Lanes that count; the result in other lanes is undefined.
     * @return The coordinates.
     */
    TextureUv (*texture_uv)(const Shape *self, const Hit *hit, mask lanes);

    const ShapeExtension *extension; /**< Methods of shapes that are no primitives; NULL: none. */
} ShapeClass;

/** A method of #ShapeClass that is for beams and packets of several rays only: engines of one lane
 *  have none. */
#define METHOD_OF_BEAMS(method) (LANES > 1 ? (method) : NULL)

/** Base of all shapes: their objects start with it. */
struct Shape {
    const ShapeClass *class; /**< Its class. */
    int index;               /**< Index in #Scene.shapes; at equal distance the lower one wins. */
    int material;            /**< Index in #Scene.materials. */
};

/** Declares a class, which its own file defines. */
#define DECLARE_SHAPE_CLASS(name) extern const ShapeClass name##_class;
SHAPES(DECLARE_SHAPE_CLASS)

/** @return Texture coordinates of points of a shape. See #ShapeClass.texture_uv. */
static inline TextureUv shape_texture_uv(const Shape *shape, const Hit *hit, mask lanes) {
    return shape->class->texture_uv
               ? shape->class->texture_uv(shape, hit, lanes)
               : (TextureUv){real_of(0), real_of(0), mask_of(false), mask_of(false)};
}

/** @return Whether rays step through a shape: a field, or a transformed one. */
static inline bool shape_has_steps(const Shape *shape) {
    return shape->class->extension && shape->class->extension->count_steps;
}

/** @return Whether hits may lie beside the bounding box of a shape: sphere tracing ends as far from
 *  a field as a pixel is wide there. */
static inline bool shape_exceeds_box(const Shape *shape) {
    return shape_has_steps(shape);
}

/** @return Whether a shape intersects whole packets. */
static inline bool shape_takes_packets(const Shape *shape) {
    return shape->class->extension && shape->class->extension->closest_hits;
}

/** @return Whether a shape has its own BVH; it then takes packets. */
static inline bool shape_has_bvh(const Shape *shape) {
    return shape->class->extension && shape->class->extension->has_bvh;
}

/* --- what all primitives share ---------------------------------------------------------------- */

/** A point of a surface that LANES rays meet. */
typedef struct SurfacePoint {
    Vec3 point;  /**< The point. */
    Vec3 normal; /**< Unit normal of the surface, outwards. */
    real error;  /**< Bound on the distance of #point from the surface, scene units. */
} SurfacePoint;

/**
 * Solves the equation of a shape for the distance.
 * @param active           Lanes that count.
 * @param[out] distance    Nearest root above 0, if there is any.
 * @param[out] roots       What #SurfaceFunction needs besides; a struct of the shape.
 * @return The lanes with a root, above 0 or not.
 */
typedef mask IntersectFunction(const Shape *self, const Ray *ray, mask active, real *distance,
                               void *roots);

/** @return The points at the distances that #IntersectFunction has found. @param roots Its roots.
 */
typedef SurfacePoint SurfaceFunction(const Shape *self, const Ray *ray, real distance,
                                     const void *roots);

/** Writes the lanes in which a shape is nearer. @param[in,out] hit The nearest hits so far. */
INLINE void shape_update_hit(const Shape *self, Hit *hit, mask nearer, real distance,
                             const SurfacePoint *surface) {
    Hit found = {.distance = distance,
                 .point = surface->point,
                 .normal = surface->normal,
                 .error = surface->error,
                 .shape = integer_of(self->index)};
    hit_update(hit, nearer, &found);
}

/**
 * #ShapeClass.is_hit of a primitive, from its two functions. They are inlined.
 * @param roots  A struct of the shape for its roots.
 */
INLINE mask primitive_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit,
                             IntersectFunction *intersect, SurfaceFunction *surface_at,
                             void *roots) {
    real distance;
    mask crosses = intersect(self, ray, active, &distance, roots);
    if (!any(crosses)) {
        return crosses;
    }
    mask nearer = hit_is_nearer(hit, crosses, distance, self->index);
    if (any(nearer)) {
        SurfacePoint surface = surface_at(self, ray, distance, roots);
        shape_update_hit(self, hit, nearer, distance, &surface);
    }
    return nearer;
}

/** #ShapeClass.is_occluding of a primitive, from its function. @param roots A struct of the shape
 *  for its roots. */
INLINE mask primitive_is_occluding(const Shape *self, const Ray *ray, mask active, real limit,
                                   IntersectFunction *intersect, void *roots) {
    real distance;
    mask crosses = intersect(self, ray, active, &distance, roots);
    if (!any(crosses)) {
        return crosses;
    }
    return crosses & (distance > 0) & (distance < limit);
}

/* --- shapes of a scene ------------------------------------------------------------------------ */

/** Alignment of shapes, bytes: that of the widest vector in any class. */
#define SHAPE_ALIGNMENT 64

/** @return A size rounded up so that what follows is aligned. */
static inline size_t shape_aligned_size(size_t size) {
    return (size + SHAPE_ALIGNMENT - 1) / SHAPE_ALIGNMENT * SHAPE_ALIGNMENT;
}

/** @return The memory behind an object that its class has requested by #ShapeExtension.tail_size.
 */
void *shape_tail(Shape *shape);

/** @return Bytes of the object of a shape, a multiple of #SHAPE_ALIGNMENT. @param methods A set of
 *  #ReportMethod. */
size_t shape_size(const SceneShape *scene_shape, unsigned methods);

/**
 * Creates the object of a shape, inside a transformed one if the scene transforms it.
 * @param memory  #shape_size bytes, aligned to #SHAPE_ALIGNMENT.
 * @param index   Index of the shape in the scene.
 * @return The object; it lies in the memory and owns nothing else. NULL without memory for its
 *         mesh.
 */
Shape *shape_init_from_scene(void *memory, const SceneShape *scene_shape, int index,
                             MeshBvhCache *meshes, Error *error);

/* --- bounding boxes --------------------------------------------------------------------------- */

/**
 * Roundings that can move a hit point off the box of its shape, each half an ulp of the largest
 * coordinate: eight cover the corner itself, the point and the ray's own rounding with room.
 */
#define AABB_ROUNDINGS 8

/** Half an ulp of 1 of the corners, which come in double. */
#define AABB_ROUNDOFF (REAL_BITS == 128 ? (scalar)0x1p-53 : ROUNDOFF)

/** @return A box enlarged by the roundings of its own coordinates: no rounding of an intersection
 *  can find a point outside. */
static inline Aabbs aabbs_padded(Aabbs box) {
    for (int axis = 0; axis < 3; axis++) {
        scalar low = box.low[axis], high = box.high[axis], magnitude = high > -low ? high : -low;
        box.low[axis] = low - AABB_ROUNDINGS * AABB_ROUNDOFF * magnitude;
        box.high[axis] = high + AABB_ROUNDINGS * AABB_ROUNDOFF * magnitude;
    }
    return box;
}

/** @return A box around two corners, by #aabbs_padded. */
Aabbs aabbs_from_corners(Vec3d low, Vec3d high);

/** @return The largest coordinate of a box, without its sign. */
scalar aabbs_largest(const Aabbs *box);

/** @return A box enlarged on all sides. @param length By how much, scene units. */
Aabbs aabbs_enlarged(Aabbs box, scalar length);

/** @return Whether two boxes overlap. */
bool aabbs_overlap(const Aabbs *a, const Aabbs *b);

/** @return Whether a box is finite along all axes. */
bool aabbs_is_bounded(const Aabbs *box);

/** @return A box enlarged by the roundings of its largest coordinate: for shapes whose rounding
 *  errors along one axis come from the others. */
Aabbs aabbs_padded_by_largest(Aabbs box);

/** @return The box of all space. */
Aabbs aabbs_infinite(void);

#endif
