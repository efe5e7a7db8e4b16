/**
 * @file
 * @brief Tapes: distance fields that are a list of operations on numbers.
 *
 * A tape is recorded by calling a function once with symbols instead of numbers
 * (script/sdf_function.h). Each step is one operation; its operands are earlier steps. Steps that
 * are equal are one step. A finished tape is a node #SDF_TAPE of a field, and each of its steps is
 * a node of its body.
 *
 * Nobody promises that a tape is a distance. Its bounding box is proven by interval arithmetic, and
 * its slope is measured on random pairs of points.
 */
#ifndef DIOPTRE_SDF_TAPE_H
#define DIOPTRE_SDF_TAPE_H

#include "dioptre/sdf.h"

/** Operation of a step; those with two operands follow one another, see #sdf_tape_operand_count. */
typedef enum {
    SDF_TAPE_INPUT,             /**< A coordinate of the point. */
    SDF_TAPE_CONSTANT,          /**< The constant. */
    SDF_TAPE_ADD,               /**< a + b */
    SDF_TAPE_SUBTRACT,          /**< a - b */
    SDF_TAPE_MULTIPLY,          /**< a * b */
    SDF_TAPE_DIVIDE,            /**< a / b */
    SDF_TAPE_MODULO,            /**< a - floor(a / b) * b */
    SDF_TAPE_MINIMUM,           /**< The smaller of a and b; a where they are equal. */
    SDF_TAPE_MAXIMUM,           /**< The larger of a and b; a where they are equal. */
    SDF_TAPE_NEGATE,            /**< -a */
    SDF_TAPE_SQUARE_ROOT,       /**< The square root of a. */
    SDF_TAPE_ABSOLUTE,          /**< The absolute value of a. */
    SDF_TAPE_FLOOR,             /**< The largest integer that is not larger than a. */
    SDF_TAPE_SINE,              /**< The sine of a, radians. */
    SDF_TAPE_COSINE,            /**< The cosine of a, radians. */
    SDF_TAPE_ADD_CONSTANT,      /**< a + the constant */
    SDF_TAPE_MULTIPLY_CONSTANT, /**< a * the constant */
    SDF_TAPE_OP_COUNT           /**< Number of operations. */
} SdfTapeOp;

/** @return Number of operands of an operation: 0, 1 or 2. */
static inline int sdf_tape_operand_count(SdfTapeOp op) {
    if (op <= SDF_TAPE_CONSTANT) {
        return 0;
    }
    return op <= SDF_TAPE_MAXIMUM ? 2 : 1;
}

/** Largest number of steps: with its head, a tape then has #SDF_NODES_MAXIMUM nodes. */
enum { SDF_TAPE_STEPS_MAXIMUM = SDF_NODES_MAXIMUM - 1 };
/** Number of registers: results of steps that are still needed. */
enum { SDF_TAPE_REGISTERS = 256 };
/** Largest constant of a tape: its square is in the range of double, and it is in that of float. */
#define SDF_TAPE_CONSTANT_MAXIMUM 1e30

/** Operands of a #SDF_TAPE node. */
enum {
    SDF_TAPE_FACTOR = 0, /**< Factor of the result, so that it grows by about 1 per unit at most. */
    SDF_TAPE_RESULT = 1, /**< Register of the result. */
    SDF_TAPE_SLOPE = 2,  /**< Largest slope that was found; 0: not measured. */
    SDF_TAPE_CLAMPS = 3, /**< 1 if it grows faster outside its box: there it is not evaluated. */
    SDF_TAPE_BOX = 4     /**< Its bounding box: six operands. */
};

/** Operands of a #SDF_TAPE_STEP node. */
enum {
    SDF_STEP_OP = 0,      /**< A #SdfTapeOp. */
    SDF_STEP_TO = 1,      /**< Register of its result. */
    SDF_STEP_A = 2,       /**< Register of its first operand; 0 if it has none. */
    SDF_STEP_B = 3,       /**< Register of its second operand; that of the first if it has one. */
    SDF_STEP_CONSTANT = 4 /**< Its constant. */
};

/** Size of the hash table of steps: a power of two, twice as many as steps. */
enum { SDF_TAPE_TABLE_SIZE = 8192 };

/** A step while a tape is recorded. */
typedef struct SdfTapeStep {
    SdfTapeOp op;    /**< Operation. */
    int a;           /**< Index of the first operand; for #SDF_TAPE_INPUT: the axis. */
    int b;           /**< Index of the second operand; #a if it has one. */
    double constant; /**< Constant; else 0. */
} SdfTapeStep;

/** A tape while it is recorded. */
typedef struct SdfTape {
    bool is_open;                              /**< Whether steps may be added. */
    int count;                                 /**< Number of steps; the first three are x, y, z. */
    SdfTapeStep steps[SDF_TAPE_STEPS_MAXIMUM]; /**< The steps. */
    int table[SDF_TAPE_TABLE_SIZE];            /**< Hash table: index of a step plus 1; 0: free. */
} SdfTape;

/** Starts a tape. @param[out] tape The tape, of which steps 0, 1 and 2 are x, y and z. */
void sdf_tape_begin(SdfTape *tape);

/**
 * Adds a constant.
 * @param[in,out] tape  The tape.
 * @param value         The constant; infinities are valid as long as the result needs none.
 * @return Index of the step; -1: the tape is full.
 */
int sdf_tape_add_constant(SdfTape *tape, double value);

/**
 * Adds an operation. Equal steps are added once, and operations on constants are computed.
 * @param[in,out] tape  The tape.
 * @param op            An operation without constant.
 * @param a             Index of the first operand.
 * @param b             Index of the second operand; ignored if it has one.
 * @return Index of the step; -1: the tape is full.
 */
int sdf_tape_add(SdfTape *tape, SdfTapeOp op, int a, int b);

/**
 * Closes a tape and makes a field of it, without bounding box, with factor 1.
 * @param[out] out    With memory for one node more than the tape has steps.
 * @param tape        The tape.
 * @param result      Index of the step that is its result.
 * @param[out] error  What is wrong.
 * @return false if it needs a constant that is not finite, or too many registers.
 */
bool sdf_from_tape(Sdf *out, SdfTape *tape, int result, Error *error);

/** A range of numbers. */
typedef struct SdfRange {
    double low;  /**< Smallest. */
    double high; /**< Largest. */
} SdfRange;

/**
 * Computes bounds of a tape by interval arithmetic, but for roundings.
 * @param tape   Its #SDF_TAPE node, followed by its steps.
 * @param point  Ranges of x, y and z. If each is one number, the result is that of the tape in
 *               double.
 * @return The range, before the factor.
 */
SdfRange sdf_tape_range(const SdfNode *tape, const SdfRange point[3]);

/** @return A tape in double, before the factor. @param tape See #sdf_tape_range. @param p A point.
 */
double sdf_tape_value(const SdfNode *tape, Vec3d p);

/**
 * Sets the bounding box of a field that is a tape, where interval arithmetic proves it.
 * @param[in,out] field  The field; its box is infinite where nothing is proven.
 * @return false if the tape is positive everywhere: there is no surface.
 */
bool sdf_tape_find_bounds(Sdf *field);

/** How fast a tape grows. */
typedef struct SdfTapeSlope {
    double slope;   /**< Largest slope that was found: |f(p) - f(q)| / |p - q|. */
    Vec3d from;     /**< Point p where it was found. */
    Vec3d to;       /**< Point q. */
    double jump;    /**< Largest jump that was found: f(p) - f(q) for p next to q; 0: none. */
    Vec3d jump_at;  /**< Point where it was found. */
    bool is_number; /**< Whether the tape is a finite number anywhere that was tried. */
} SdfTapeSlope;

/** Slopes up to here are those of a distance; what is above 1 are roundings. */
#define SDF_TAPE_SLOPE_MAXIMUM 1.000001
/** Slopes below are not those of a distance: the tolerance would be reached far from the surface.
 */
#define SDF_TAPE_SLOPE_MINIMUM 0.5
/** Factor on the largest slope that was found: random pairs miss the steepest one. */
#define SDF_TAPE_SLOPE_MARGIN 1.05

/**
 * Measures the slope of a tape on random pairs of points, the same ones at each call: near and far
 * ones, in its bounding box, and within 32 units of zero along an axis where it has none.
 * @param field   A field that is a tape, with its bounding box.
 * @param growth  What the box is enlarged by for this, in its longest edge.
 * @return The largest slope.
 */
SdfTapeSlope sdf_tape_measure_slope(const Sdf *field, double growth);

/**
 * Divides a tape by its slope, if it is above #SDF_TAPE_SLOPE_MAXIMUM or below
 * #SDF_TAPE_SLOPE_MINIMUM, so that it is a bound of the distance.
 * @param[in,out] field  A field that is a tape, with its bounding box.
 * @return What was found.
 */
SdfTapeSlope sdf_tape_normalize(Sdf *field);

/**
 * Checks a field that another process has made: no operation, register or count may lead out of it,
 * and the constants of its tapes are finite.
 * @param field  The field.
 * @return Whether it is valid.
 */
bool sdf_check(const Sdf *field);

#endif
