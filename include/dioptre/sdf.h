/**
 * @file
 * @brief Distance fields: solids given by how far any point is from their surface.
 *
 * A field says for each point of space a number: positive outside of its solid, negative inside,
 * and never larger than the distance to the surface. It never changes faster than the point moves:
 * |f(p) - f(q)| <= |p - q|. So whoever stands at p may walk f(p) in any direction without meeting
 * anything. An *exact* field says the very distance everywhere outside; a *bound* may say less.
 *
 * A field is a short tape of steps, plain data: what stands first measures the point, and each
 * further step changes the number that is there so far. Steps with a body run the steps behind them
 * at a point of their own.
 */
#ifndef DIOPTRE_SDF_H
#define DIOPTRE_SDF_H

#include "dioptre/transform.h"

/** What a step of a field does; its numbers stand behind it. */
typedef enum {
    SDF_SPHERE,       /**< Measures a ball: radius. */
    SDF_BOX,          /**< Measures a box: half its edges. */
    SDF_BOX_FRAME,    /**< Measures the edges of a box: half its edges, half their thickness. */
    SDF_TORUS,        /**< Measures a ring around y: major and minor radius. */
    SDF_MENGER,       /**< Measures a Menger sponge: half its edge, iterations. */
    SDF_MANDELBULB,   /**< Measures a Mandelbulb; see the file sdf_primitives.c. */
    SDF_ROUND,        /**< Moves the surface outwards: by how much. */
    SDF_TRANSFORM,    /**< Body at a point of its own: matrix, move, scale, box of the body. */
    SDF_REPEAT,       /**< Body in cells: periods, halves, limits, reach, its box, for 3 axes. */
    SDF_UNION,        /**< The nearer of this and the body: box of the body, 0. */
    SDF_SMOOTH_UNION, /**< The same, melted together: box of the body, radius. */
    SDF_INTERSECTION, /**< What is in this and in the body. */
    SDF_DIFFERENCE    /**< What is in this and not in the body: box of the body. */
} SdfOp;

/** Numbers of a step. */
enum { SDF_OPERANDS = 19 };
/** Most steps of a field: a scene file that runs away does not fill the machine. */
enum { SDF_NODES_MAXIMUM = 4096 };
/** How deep bodies may stand in bodies: a guard for the stack. */
enum { SDF_DEPTH_MAXIMUM = 64 };

/** A step of a field. */
typedef struct SdfNode {
    SdfOp op;                      /**< What it does. */
    int body_count;                /**< How many of the next steps are its body. */
    double operands[SDF_OPERANDS]; /**< With what; as the operation says. */
} SdfNode;

/** A distance field. Of any size: its steps stand behind it. */
typedef struct Sdf {
    bool is_exact;      /**< Whether it says the very distance outside; else a bound of it. */
    double bound_slack; /**< Outside its box it says at least the distance to the box over this. */
    Vec3d low;          /**< Lowest corner of a box around its solid; -infinity: without end. */
    Vec3d high;         /**< Highest corner. */
    int depth;          /**< How deep bodies stand in bodies. */
    int node_count;     /**< How many steps. */
    SdfNode nodes[];    /**< The steps. */
} Sdf;

/** A field that is made of nothing but numbers: its keyword and what becomes of its fields. */
typedef struct SdfPrimitive {
    Keyword keyword; /**< Base: its name and fields. */
    bool is_exact;   /**< Whether it is exact. */
    /** Makes it. @param[out] field Room for one step. @param values The keyword's struct. */
    void (*create)(Sdf *field, const void *values);
} SdfPrimitive;

/** All of them, ended by NULL. */
extern const SdfPrimitive *const sdf_primitives[];

/** What is made of two fields. */
typedef enum {
    SDF_COMBINE_UNION,        /**< What is in any. */
    SDF_COMBINE_INTERSECTION, /**< What is in all. */
    SDF_COMBINE_DIFFERENCE,   /**< What is in the first but not in the second. */
    SDF_COMBINE_SMOOTH_UNION  /**< What is in any, melted together. */
} SdfCombination;

/** How a field is repeated: `f:repeat_every`. */
typedef struct SdfRepetition {
    Vec3d period; /**< From one copy to the next, along each axis; 0: not repeated. */
    Vec3d count;  /**< How many copies along each axis; 0: without end. */
} SdfRepetition;

extern const Parameter sdf_period_parameter; /**< What `f:repeat_every` takes. */
extern const Parameter sdf_count_parameter;  /**< Its `count`. */
extern const Parameter sdf_scale_parameter;  /**< What `f:scale` takes. */
extern const Parameter sdf_round_parameter;  /**< What `f:round` takes. */
extern const Parameter sdf_radius_parameter; /**< The radius of `distance.smooth_union`. */

/** @return Bytes of a field. @param node_count Its steps. */
size_t sdf_size(int node_count);

/** @return Steps that are enough for any operation on fields. @param sdfs The fields.
 *  @param count How many. */
int sdf_combined_capacity(const Sdf *const *sdfs, int count);

/**
 * Scales, turns and moves a field.
 * @param[out] out    Room for the result.
 * @param sdf       The field.
 * @param transform   How, finished; its scale is the same and above 0 along all axes.
 * @param[out] error  What is wrong.
 * @return false where it becomes too deep.
 */
bool sdf_transform(Sdf *out, const Sdf *sdf, const Transform *transform, Error *error);

/**
 * Moves a field, and with it each field that it is made of: so that the numbers of its steps are as
 * small as where it is then.
 * @param[out] out  Room for twice its steps.
 * @param sdf     The field.
 * @param offset       How far, scene units.
 */
void sdf_translate(Sdf *out, const Sdf *sdf, Vec3d offset);

/**
 * Moves a field's surface outwards, which rounds edges.
 * @param[out] out    Room for the result.
 * @param sdf       The field.
 * @param radius      By how much, scene units.
 */
void sdf_round(Sdf *out, const Sdf *sdf, double radius);

/**
 * Repeats a field along axes.
 * @param[out] out    Room for the result.
 * @param sdf       The field.
 * @param repeat      How.
 * @param[out] error  What is wrong.
 * @return false where copies would overlap more than their neighbours, and where it is too deep.
 */
bool sdf_repeat(Sdf *out, const Sdf *sdf, const SdfRepetition *repeat, Error *error);

/**
 * Makes one field of several.
 * @param[out] out    Room for the result.
 * @param combination        How.
 * @param sdfs      The fields.
 * @param count       How many, at least 1.
 * @param radius      For #SDF_COMBINE_SMOOTH_UNION: how far from both the seam is filled.
 * @param[out] error  What is wrong.
 * @return false where nothing is left of them, and where it becomes too long or too deep.
 */
bool sdf_combine(Sdf *out, SdfCombination combination, const Sdf *const *sdfs, int count,
                 double radius, Error *error);

#endif
