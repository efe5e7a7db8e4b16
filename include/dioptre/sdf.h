/**
 * @file
 * @brief Signed distance fields (SDF).
 *
 * The value of a field is positive outside its solid, negative inside, and its absolute value is at
 * most the distance to the surface. Its Lipschitz constant is 1: |f(p) - f(q)| <= |p - q|. A step
 * of length f(p) from p in any direction therefore meets no surface. An *exact* field equals the
 * distance everywhere outside; a *bound* may be smaller.
 *
 * A field is a list of nodes, plain data: the first computes a distance, and each further node
 * changes the result so far. Nodes with a body evaluate the nodes behind them, most of them at
 * another point.
 */
#ifndef DIOPTRE_SDF_H
#define DIOPTRE_SDF_H

#include "dioptre/parameter.h"

/** Operation of a node; its operands follow the colon. */
typedef enum {
    SDF_SPHERE,       /**< Sphere: radius. */
    SDF_BOX,          /**< Box: half its edges. */
    SDF_BOX_FRAME,    /**< Edges of a box: half its edges, half their thickness. */
    SDF_TORUS,        /**< Torus around y: major and minor radius. */
    SDF_MENGER,       /**< Menger sponge: half its edge, iterations. */
    SDF_MANDELBULB,   /**< Mandelbulb: see sdf_primitives.c. */
    SDF_ROUND,        /**< Moves the surface outwards: distance. */
    SDF_TRANSFORM,    /**< Transforms the body: matrix, translation, scale, box of the body. */
    SDF_REPEAT,       /**< Repeats the body: periods, halves, limits, neighbours, its box. */
    SDF_UNION,        /**< Union with the body: box of the body, 0. */
    SDF_SMOOTH_UNION, /**< Smooth union with the body: box of the body, radius. */
    SDF_INTERSECTION, /**< Intersection with the body. */
    SDF_DIFFERENCE,   /**< Difference from the body: box of the body. */
    SDF_TAPE,         /**< Operations on numbers, the steps of its body: see sdf_tape.h. */
    SDF_TAPE_STEP     /**< A step of a tape: see sdf_tape.h. */
} SdfOp;

/** Number of operands of a node. */
enum { SDF_OPERANDS = 19 };
/** Largest number of nodes: it limits scene files that never stop. */
enum { SDF_NODES_MAXIMUM = 4096 };
/** Largest number of iterations of a sponge: the smallest holes are 3^-12 of its edge. */
enum { SDF_MENGER_ITERATIONS_MAXIMUM = 12 };
/** Largest power of a Mandelbulb, and largest number of its iterations: engines loop over them. */
enum { SDF_BULB_POWER_MAXIMUM = 16, SDF_BULB_ITERATIONS_MAXIMUM = 32 };
/** Largest depth of nested bodies: a guard for the stack. */
enum { SDF_DEPTH_MAXIMUM = 64 };

/** A node of a field. */
typedef struct SdfNode {
    SdfOp op;                      /**< Operation. */
    int body_count;                /**< Number of following nodes that are its body. */
    double operands[SDF_OPERANDS]; /**< Operands; see #SdfOp. */
} SdfNode;

/** A distance field, followed by its nodes. */
typedef struct Sdf {
    bool is_exact;      /**< Whether it equals the distance outside; else a lower bound. */
    double bound_slack; /**< Outside its box, it is at least the distance to the box over this. */
    Vec3d low;          /**< Lowest corner of the bounding box; -infinity: unbounded. */
    Vec3d high;         /**< Highest corner. */
    int depth;          /**< Depth of nested bodies. */
    int node_count;     /**< Number of nodes. */
    SdfNode nodes[];    /**< Nodes. */
} Sdf;

/** A primitive of distance fields: its keyword, and the field that it creates. */
typedef struct SdfPrimitive {
    Keyword keyword; /**< Base: name and fields. */
    bool is_exact;   /**< Whether it is exact. */
    /**
     * Creates it.
     * @param[out] field  With memory for one node.
     * @param values      The keyword's struct.
     */
    void (*create)(Sdf *field, const void *values);
} SdfPrimitive;

/** All primitives; NULL ends the list. */
extern const SdfPrimitive *const sdf_primitives[];

/** Combination of fields. */
typedef enum {
    SDF_COMBINE_UNION,        /**< Union. */
    SDF_COMBINE_INTERSECTION, /**< Intersection. */
    SDF_COMBINE_DIFFERENCE,   /**< The first without the others. */
    SDF_COMBINE_SMOOTH_UNION  /**< Union with filled seams. */
} SdfCombination;

/** Repetition of a field: `f:repeat_every`. */
typedef struct SdfRepetition {
    Vec3d period; /**< Distance between copies along each axis; 0: not repeated. */
    Vec3d count;  /**< Number of copies along each axis; 0: infinite. */
} SdfRepetition;

extern const Parameter sdf_period_parameter; /**< Argument of `f:repeat_every`. */
extern const Parameter sdf_count_parameter;  /**< Argument `count` of `f:repeat_every`. */
extern const Parameter sdf_scale_parameter;  /**< Argument of `f:scale`. */
extern const Parameter sdf_round_parameter;  /**< Argument of `f:round`. */
extern const Parameter sdf_radius_parameter; /**< Radius of `distance.smooth_union`. */

/** @return Bytes of a field. @param node_count Number of its nodes. */
size_t sdf_size(int node_count);

/**
 * @return Number of nodes that suffices for any operation on fields.
 * @param sdfs   The fields.
 * @param count  Number of fields.
 */
int sdf_combined_capacity(const Sdf *const *sdfs, int count);

/**
 * Transforms a field.
 * @param[out] out    Memory for the result.
 * @param sdf         The field.
 * @param transform   The transform, finished; its scale is the same along all axes, above 0.
 * @param[out] error  What is wrong.
 * @return false if the result is too deep.
 */
bool sdf_transform(Sdf *out, const Sdf *sdf, const Transform *transform, Error *error);

/**
 * Translates a field and each field that it consists of: its operands then are as small as its new
 * position.
 * @param[out] out  Memory for twice its nodes.
 * @param sdf       The field.
 * @param offset    Translation, scene units.
 */
void sdf_translate(Sdf *out, const Sdf *sdf, Vec3d offset);

/**
 * Moves the surface of a field outwards, which rounds edges.
 * @param[out] out  Memory for the result.
 * @param sdf       The field.
 * @param radius    Distance, scene units.
 */
void sdf_round(Sdf *out, const Sdf *sdf, double radius);

/**
 * Repeats a field along axes.
 * @param[out] out    Memory for the result.
 * @param sdf         The field.
 * @param repeat      The repetition.
 * @param[out] error  What is wrong.
 * @return false if copies overlap more than their neighbours, or if the result is too deep.
 */
bool sdf_repeat(Sdf *out, const Sdf *sdf, const SdfRepetition *repeat, Error *error);

/**
 * Combines fields.
 * @param[out] out     Memory for the result.
 * @param combination  The operation.
 * @param sdfs         The fields.
 * @param count        Number of fields, at least 1.
 * @param radius       For #SDF_COMBINE_SMOOTH_UNION: distance from both up to which the seam is
 * filled.
 * @param[out] error   What is wrong.
 * @return false if the result is empty, too long or too deep.
 */
bool sdf_combine(Sdf *out, SdfCombination combination, const Sdf *const *sdfs, int count,
                 double radius, Error *error);

#endif
