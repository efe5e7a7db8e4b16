/**
 * @file
 * @brief Shapes: the abstract class and its vtable.
 *
 * A new shape is one file in `shapes/` that ends in a #ShapeClass, one line in `shapes/registry.c`,
 * one row in the contract test and one scene.
 */
#ifndef DIOPTRE_TRACE_SHAPES_SHAPE_H
#define DIOPTRE_TRACE_SHAPES_SHAPE_H

#include "trace/tracer/ray.h"

typedef struct Shape Shape;
typedef struct Packet Packet;
typedef struct MeshBvhCache MeshBvhCache;

/** A box along the axes that holds a shape, rounded outwards; infinite where the shape is. */
typedef struct Aabbs {
    scalar low[3];  /**< Lowest coordinates. */
    scalar high[3]; /**< Highest coordinates. */
} Aabbs;

/**
 * Where on a picture LANES points of a shape lie: (0, 0) is its lower left corner, (1, 1) its upper
 * right one.
 */
typedef struct TextureUv {
    real u;      /**< To the right. */
    real v;      /**< Up. */
    mask wrap_u; /**< Where the picture goes on at its left and right edges, rather than ending. */
    mask wrap_v; /**< The same at its upper and lower edges. */
} TextureUv;

/** What every shape can do: the vtable. */
typedef struct ShapeClass {
    Keyword keyword; /**< Base: its name, fields and checks in the scene language. */
    size_t size;     /**< Bytes of an object of the class, a multiple of its alignment. */

    bool is_flat; /**< Whether it has flat faces only: in them, mirrored rays go apart no faster
                     than before. */

    /** @return Bytes that an object needs behind itself: see #shape_tail. NULL: none.
     *  @param parameters The struct that #keyword describes, finished. */
    size_t (*tail_size)(const void *parameters);

    /**
     * Makes an object out of what the scene file said. The base is already filled.
     * @param self        Memory of #size bytes, and those of its #tail_size.
     * @param parameters  The struct that #keyword describes, finished.
     */
    void (*init)(Shape *self, const void *parameters);

    /**
     * Finds the model that the shape shows, once #init has filled it. NULL: it shows none.
     * @param said  The shape, as the scene has it.
     * @return false without memory.
     */
    bool (*bind_mesh)(Shape *self, const SceneShape *said, MeshBvhCache *models, Error *error);

    /**
     * Finds where LANES rays meet the shape.
     * @param active  The lanes that count; others are neither read nor written.
     * @param[in,out] hit  The nearest hit so far, replaced in the lanes where this one is nearer.
     * @return The lanes that were replaced.
     */
    mask (*is_hit)(const Shape *self, const Ray *ray, mask active, Hit *hit);

    /**
     * Says whether the shape is anywhere on the way.
     * @param limit  How far the way goes; what lies there or beyond does not block.
     * @return The lanes that are blocked.
     */
    mask (*is_occluding)(const Shape *self, const Ray *ray, mask active, real limit);

    /** Finds where the rays of a packet meet the shape. NULL: #is_hit is asked, vector by vector.
     *  @param[in,out] hits What each vector has met so far. */
    void (*closest_hits)(const Shape *self, const Packet *packet, Hit *hits);

    /** Finds which rays of a packet the shape blocks. NULL: #is_occluding is asked. @param[in,out]
     *  blocked Those that are blocked; they need not be asked again. */
    void (*occluded)(const Shape *self, const Packet *packet, mask *blocked);

    /** @return A box that holds the shape, rounded outwards. */
    Aabbs (*bounds)(const Shape *self);

    /**
     * Finds where on a picture points of the shape lie. Only asked where a material has a picture.
     * NULL: all of them in its lower left corner.
     * @param hit  What was found of the points.
     * @param lanes  The lanes that count; of the others anything may be said.
     * @return The places.
     */
    TextureUv (*texture_uv)(const Shape *self, const Hit *hit, mask lanes);

    /**
     * Counts the steps in which rays come to the shape, for surveys. NULL: it takes none.
     * @param active  The lanes that count; of the others anything may be said.
     * @param limit  How far they look.
     * @return How many.
     */
    real (*count_steps)(const Shape *self, const Ray *ray, mask active, real limit);
} ShapeClass;

/** What all shapes have. Every class embeds it first. */
struct Shape {
    const ShapeClass *class; /**< What it is. */
    int index;               /**< Its place in the scene; the lower one wins a tie. */
    int material;            /**< Place of its material in the scene. */
};

/** @return Where on a picture points of a shape lie. See #ShapeClass.texture_uv. */
static inline TextureUv shape_texture_uv(const Shape *shape, const Hit *hit, mask lanes) {
    return shape->class->texture_uv
               ? shape->class->texture_uv(shape, hit, lanes)
               : (TextureUv){real_of(0), real_of(0), mask_of(false), mask_of(false)};
}

/**
 * The registry: the keyword of each shape class, ended by NULL. The class is found by the keyword,
 * which it embeds first.
 */
extern const Keyword *const shape_keywords[];

/** @return A shape class. @param kind Its place in #shape_keywords. */
static inline const ShapeClass *shape_class(size_t kind) {
    return (const ShapeClass *)shape_keywords[kind];
}

/** Alignment of shapes, bytes: that of the widest vector of numbers in any class. */
#define SHAPE_ALIGNMENT 64

/** @return The memory behind an object that its class has asked for by #ShapeClass.tail_size. */
void *shape_tail(Shape *shape);

/** @return Bytes of the object that a shape of the scene becomes, a multiple of
 *          #SHAPE_ALIGNMENT. @param scene_shape The shape, as the scene has it. */
size_t shape_size(const SceneShape *scene_shape);

/**
 * Makes the object that a shape of the scene becomes; inside a Transformed one if it is
 * transformed.
 * @param memory  #shape_size bytes, aligned to #SHAPE_ALIGNMENT.
 * @param scene_shape  The shape, as the scene has it.
 * @param index  Its place in the scene.
 * @return The object; it lies in the memory and owns nothing else. NULL without memory for its
 *         model.
 */
Shape *shape_init_from_scene(void *memory, const SceneShape *scene_shape, int index,
                             MeshBvhCache *meshes, Error *error);

/**
 * Measures a shape of the scene before it is transformed, without making a tracer.
 * @param scene_shape  The shape, as the scene has it.
 * @return Its box and whether it is flat. The box of a shape that shows a model is not known here.
 */
ShapeMeasure shape_measure(const SceneShape *scene_shape);

/**
 * Roundings that may move a found point off the box of its shape, each half an ulp of the largest
 * coordinate: eight cover the corner itself, the point and the ray's own rounding with room.
 */
#define AABB_ROUNDINGS 8

/** Half an ulp of 1 of the corners, which come in double. */
#define AABB_ROUNDOFF (REAL_BITS == 128 ? (scalar)0x1p-53 : ROUNDOFF)

/** @return A box moved out on all sides by the roundings of its own coordinates, far enough that no
 *  rounding of an intersection can find a point outside. */
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

/** @return A box moved out on all sides by the roundings of its largest coordinate: for shapes
 *  whose roundings along one axis come from the others. */
Aabbs aabbs_padded_by_largest(Aabbs bounds);

/** @return A box that holds everything. */
Aabbs aabbs_infinite(void);

#endif
