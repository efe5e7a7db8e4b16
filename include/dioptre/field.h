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
#ifndef DIOPTRE_FIELD_H
#define DIOPTRE_FIELD_H

#include "dioptre/transform.h"

/** What a step of a field does; its numbers stand behind it. */
typedef enum {
    FIELD_SPHERE,       /**< Measures a ball: radius. */
    FIELD_BOX,          /**< Measures a box: half its edges. */
    FIELD_BOX_FRAME,    /**< Measures the edges of a box: half its edges, half their thickness. */
    FIELD_TORUS,        /**< Measures a ring around y: major and minor radius. */
    FIELD_MENGER,       /**< Measures a Menger sponge: half its edge, iterations. */
    FIELD_MANDELBULB,   /**< Measures a Mandelbulb; see the file field_kinds.c. */
    FIELD_ROUND,        /**< Moves the surface outwards: by how much. */
    FIELD_PLACE,        /**< Body at a point of its own: matrix, move, scale, box of the body. */
    FIELD_REPEAT,       /**< Body in cells: periods, halves, limits, reach, its box, for 3 axes. */
    FIELD_UNION,        /**< The nearer of this and the body: box of the body, 0. */
    FIELD_SMOOTH_UNION, /**< The same, melted together: box of the body, radius. */
    FIELD_INTERSECTION, /**< What is in this and in the body. */
    FIELD_DIFFERENCE    /**< What is in this and not in the body: box of the body. */
} FieldOperation;

/** Numbers of a step. */
enum { FIELD_NUMBERS = 19 };
/** Most steps of a field: a scene file that runs away does not fill the machine. */
enum { FIELD_STEPS_MAXIMUM = 4096 };
/** How deep bodies may stand in bodies: a guard for the stack. */
enum { FIELD_DEPTH_MAXIMUM = 64 };

/** A step of a field. */
typedef struct FieldStep {
    FieldOperation operation;      /**< What it does. */
    int body;                      /**< How many of the next steps are its body. */
    double numbers[FIELD_NUMBERS]; /**< With what; as the operation says. */
} FieldStep;

/** A distance field. Of any size: its steps stand behind it. */
typedef struct Field {
    bool is_exact;     /**< Whether it says the very distance outside; else a bound of it. */
    double slack;      /**< Outside its box it says at least the distance to the box over this. */
    Vector3 low;       /**< Lowest corner of a box around its solid; -infinity: without end. */
    Vector3 high;      /**< Highest corner. */
    int depth;         /**< How deep bodies stand in bodies. */
    int count;         /**< How many steps. */
    FieldStep steps[]; /**< The steps. */
} Field;

/** A field that is made of nothing but numbers: its keyword and what becomes of its fields. */
typedef struct FieldKind {
    Keyword keyword; /**< Base: its name and fields. */
    bool is_exact;   /**< Whether it is exact. */
    /** Makes it. @param[out] field Room for one step. @param values The keyword's struct. */
    void (*make)(Field *field, const void *values);
} FieldKind;

/** All of them, ended by NULL. */
extern const FieldKind *const field_kinds[];

/** What is made of two fields. */
typedef enum {
    FIELD_JOIN_UNION,        /**< What is in any. */
    FIELD_JOIN_INTERSECTION, /**< What is in all. */
    FIELD_JOIN_DIFFERENCE,   /**< What is in the first but not in the second. */
    FIELD_JOIN_SMOOTH        /**< What is in any, melted together. */
} FieldJoin;

/** How a field is repeated: `f:repeat_every`. */
typedef struct FieldRepeat {
    Vector3 period; /**< From one copy to the next, along each axis; 0: not repeated. */
    Vector3 count;  /**< How many copies along each axis; 0: without end. */
} FieldRepeat;

extern const Parameter field_period_row; /**< What `f:repeat_every` takes. */
extern const Parameter field_count_row;  /**< Its `count`. */
extern const Parameter field_scale_row;  /**< What `f:scale` takes. */
extern const Parameter field_round_row;  /**< What `f:round` takes. */
extern const Parameter field_radius_row; /**< The radius of `distance.smooth_union`. */

/** @return Bytes of a field. @param count Its steps. */
size_t field_size(int count);

/** @return Steps that are enough for any operation on fields. @param fields The fields.
 *  @param count How many. */
int field_room(const Field *const *fields, int count);

/**
 * Scales, turns and moves a field.
 * @param[out] out    Room for the result.
 * @param field       The field.
 * @param transform   How, finished; its scale is the same and above 0 along all axes.
 * @param[out] error  What is wrong.
 * @return false where it becomes too deep.
 */
bool field_place(Field *out, const Field *field, const Transform *transform, Error *error);

/**
 * Moves a field, and with it each field that it is made of: so that the numbers of its steps are as
 * small as where it is then.
 * @param[out] out  Room for twice its steps.
 * @param field     The field.
 * @param way       How far, scene units.
 */
void field_move(Field *out, const Field *field, Vector3 way);

/**
 * Moves a field's surface outwards, which rounds edges.
 * @param[out] out    Room for the result.
 * @param field       The field.
 * @param radius      By how much, scene units.
 */
void field_round(Field *out, const Field *field, double radius);

/**
 * Repeats a field along axes.
 * @param[out] out    Room for the result.
 * @param field       The field.
 * @param repeat      How.
 * @param[out] error  What is wrong.
 * @return false where copies would overlap more than their neighbours, and where it is too deep.
 */
bool field_repeat(Field *out, const Field *field, const FieldRepeat *repeat, Error *error);

/**
 * Makes one field of several.
 * @param[out] out    Room for the result.
 * @param join        How.
 * @param fields      The fields.
 * @param count       How many, at least 1.
 * @param radius      For #FIELD_JOIN_SMOOTH: how far from both the seam is filled.
 * @param[out] error  What is wrong.
 * @return false where nothing is left of them, and where it becomes too long or too deep.
 */
bool field_join(Field *out, FieldJoin join, const Field *const *fields, int count, double radius,
                Error *error);

#endif
