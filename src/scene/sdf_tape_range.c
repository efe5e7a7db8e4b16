/**
 * @file
 * @brief Interval arithmetic for tapes: their values in double, and where they have no surface.
 *
 * Roundings are not turned outwards: a box is enlarged by much more than they are
 * (#BOUNDS_MARGIN).
 */
#include "scene/sdf_tape_range.h"

/** What a box is enlarged by, per edge: far more than the roundings of a tape. */
#define BOUNDS_MARGIN 0x1p-20
/** Farthest coordinate at which the end of a surface is searched, scene units: #LENGTH_MAXIMUM. */
#define BOUNDS_REACH 0x1p49
/** Number of halvings of a search along an axis alone: down to 2^-20 units. */
enum { AXIS_HALVINGS = 70 };
/** Ratio of the outer size of a shell to its inner size. */
#define SHELL_RATIO 8
/** Smallest shell that is examined, scene units. */
#define SHELL_MINIMUM 0x1p-20
/** Largest number of halvings of a part of space, and of parts. */
enum { PART_DEPTH = 16, PARTS_MAXIMUM = 1000 };
/** Number of halvings of a search by parts: down to 2^-10 of the box. */
enum { PART_HALVINGS = 10 };

/* --- steps ------------------------------------------------------------------------------------ */

/** All numbers. */
static const SdfRange everything = {-HUGE_VAL, HUGE_VAL};

/** @return Whether a range is one number, or none. */
static bool is_point(SdfRange a) {
    return !(a.low < a.high);
}

/** @return A range; all numbers if an end is unknown. */
static SdfRange range_of(double low, double high) {
    return isnan(low) || isnan(high) ? everything : (SdfRange){low, high};
}

/** @return The range that contains four numbers; all numbers if one is unknown. */
static SdfRange range_of_four(double a, double b, double c, double d) {
    if (isnan(a) || isnan(b) || isnan(c) || isnan(d)) {
        return everything;
    }
    return (SdfRange){fmin(fmin(a, b), fmin(c, d)), fmax(fmax(a, b), fmax(c, d))};
}

/** @return The ranges of a product. */
static SdfRange range_multiply(SdfRange a, SdfRange b) {
    return range_of_four(a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high);
}

/** @return The range of a quotient; all numbers if the divisor may be zero. */
static SdfRange range_divide(SdfRange a, SdfRange b) {
    if (b.low <= 0 && b.high >= 0) {
        return everything;
    }
    return range_of_four(a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high);
}

/** @return The remainder of a division by its floor, with the sign of the divisor. */
static double modulo(double a, double b) {
    return a - floor(a / b) * b;
}

/** @return The range of a remainder; all numbers if the divisor varies or is not positive. */
static SdfRange range_modulo(SdfRange a, SdfRange b) {
    if (!is_point(b) || !(b.low > 0)) {
        return everything;
    }
    bool is_in_one_cell = floor(a.low / b.low) == floor(a.high / b.low) && isfinite(a.high - a.low);
    return is_in_one_cell ? (SdfRange){modulo(a.low, b.low), modulo(a.high, b.low)}
                          : (SdfRange){0, b.low};
}

/** @return The range of an absolute value. */
static SdfRange range_absolute(SdfRange a) {
    double low = fabs(a.low), high = fabs(a.high);
    return (SdfRange){a.low <= 0 && a.high >= 0 ? 0 : fmin(low, high), fmax(low, high)};
}

/** @return The range of a sine or cosine. @param middle Its value at the middle of the operand. */
static SdfRange range_wave(SdfRange a, double middle) {
    // It grows by at most 1 per radian.
    double half = 0.5 * (a.high - a.low);
    return half < 2 ? (SdfRange){fmax(-1, middle - half), fmin(1, middle + half)}
                    : (SdfRange){-1, 1};
}

/** @return The result of a step whose operands are numbers. See #sdf_tape_step_range. */
static double step_value(SdfTapeOp op, double a, double b, double constant) {
    switch (op) {
    case SDF_TAPE_CONSTANT:
        return constant;
    case SDF_TAPE_ADD:
        return a + b;
    case SDF_TAPE_SUBTRACT:
        return a - b;
    case SDF_TAPE_MULTIPLY:
        return a * b;
    case SDF_TAPE_DIVIDE:
        return a / b;
    case SDF_TAPE_MODULO:
        return modulo(a, b);
    case SDF_TAPE_MINIMUM:
        return b < a ? b : a;
    case SDF_TAPE_MAXIMUM:
        return b > a ? b : a;
    case SDF_TAPE_NEGATE:
        return -a;
    case SDF_TAPE_SQUARE_ROOT:
        return sqrt(a);
    case SDF_TAPE_ABSOLUTE:
        return fabs(a);
    case SDF_TAPE_FLOOR:
        return floor(a);
    case SDF_TAPE_SINE:
        return sin(a);
    case SDF_TAPE_COSINE:
        return cos(a);
    case SDF_TAPE_ADD_CONSTANT:
        return a + constant;
    case SDF_TAPE_MULTIPLY_CONSTANT:
        return a * constant;
    default:
        return (double)NAN;
    }
}

SdfRange sdf_tape_step_range(SdfTapeOp op, SdfRange a, SdfRange b, double constant) {
    const SdfRange c = {constant, constant};
    if (is_point(a) && is_point(b)) {
        double value = step_value(op, a.low, b.low, constant);
        return (SdfRange){value, value};
    }
    switch (op) {
    case SDF_TAPE_CONSTANT:
        return c;
    case SDF_TAPE_ADD:
        return range_of(a.low + b.low, a.high + b.high);
    case SDF_TAPE_SUBTRACT:
        return range_of(a.low - b.high, a.high - b.low);
    case SDF_TAPE_MULTIPLY:
        return range_multiply(a, b);
    case SDF_TAPE_DIVIDE:
        return range_divide(a, b);
    case SDF_TAPE_MODULO:
        return range_modulo(a, b);
    case SDF_TAPE_MINIMUM:
        return range_of(fmin(a.low, b.low), fmin(a.high, b.high));
    case SDF_TAPE_MAXIMUM:
        return range_of(fmax(a.low, b.low), fmax(a.high, b.high));
    case SDF_TAPE_NEGATE:
        return (SdfRange){-a.high, -a.low};
    case SDF_TAPE_SQUARE_ROOT:
        return range_of(sqrt(fmax(a.low, 0)), sqrt(a.high));
    case SDF_TAPE_ABSOLUTE:
        return range_absolute(a);
    case SDF_TAPE_FLOOR:
        return (SdfRange){floor(a.low), floor(a.high)};
    case SDF_TAPE_SINE:
        return range_wave(a, sin(0.5 * (a.low + a.high)));
    case SDF_TAPE_COSINE:
        return range_wave(a, cos(0.5 * (a.low + a.high)));
    case SDF_TAPE_ADD_CONSTANT:
        return range_of(a.low + constant, a.high + constant);
    case SDF_TAPE_MULTIPLY_CONSTANT:
        return range_multiply(a, c);
    default:
        return everything;
    }
}

/* --- tapes ------------------------------------------------------------------------------------ */

/** @return The range of a square. */
static SdfRange range_square(SdfRange a) {
    SdfRange magnitude = range_absolute(a);
    return (SdfRange){magnitude.low * magnitude.low, magnitude.high * magnitude.high};
}

SdfRange sdf_tape_range(const SdfNode *tape, const SdfRange point[3]) {
    SdfRange registers[SDF_TAPE_REGISTERS];
    for (int axis = 0; axis < 3; axis++) {
        registers[axis] = point[axis];
    }
    for (const SdfNode *node = tape + 1; node <= tape + tape->body_count; node++) {
        const double *operands = node->operands;
        SdfTapeOp op = (SdfTapeOp)operands[SDF_STEP_OP];
        int a = (int)operands[SDF_STEP_A], b = (int)operands[SDF_STEP_B];
        // If both factors are the same number, the product is not negative.
        bool is_square = op == SDF_TAPE_MULTIPLY && a == b;
        registers[(int)operands[SDF_STEP_TO]] =
            is_square
                ? range_square(registers[a])
                : sdf_tape_step_range(op, registers[a], registers[b], operands[SDF_STEP_CONSTANT]);
    }
    return registers[(int)tape->operands[SDF_TAPE_RESULT]];
}

double sdf_tape_value(const SdfNode *tape, Vec3d p) {
    double registers[SDF_TAPE_REGISTERS];
    registers[0] = p.x;
    registers[1] = p.y;
    registers[2] = p.z;
    for (const SdfNode *node = tape + 1; node <= tape + tape->body_count; node++) {
        const double *operands = node->operands;
        registers[(int)operands[SDF_STEP_TO]] =
            step_value((SdfTapeOp)operands[SDF_STEP_OP], registers[(int)operands[SDF_STEP_A]],
                       registers[(int)operands[SDF_STEP_B]], operands[SDF_STEP_CONSTANT]);
    }
    return registers[(int)tape->operands[SDF_TAPE_RESULT]];
}

/* --- bounding boxes --------------------------------------------------------------------------- */

/** A box of points, axis by axis. */
typedef struct SdfRangeBox {
    SdfRange axes[3]; /**< Ranges of x, y and z. */
} SdfRangeBox;

/** @return Whether a tape is proven to be positive in a box. */
static bool is_empty(const SdfNode *tape, const SdfRangeBox *box) {
    return sdf_tape_range(tape, box->axes).low > 0;
}

/** @return Whether a tape is proven to be positive beyond a coordinate. @param is_high Whether
 *  above it, or else below it. */
static bool is_empty_beyond(const SdfNode *tape, int axis, bool is_high, double coordinate) {
    SdfRangeBox box = {{everything, everything, everything}};
    *(is_high ? &box.axes[axis].low : &box.axes[axis].high) = coordinate;
    return is_empty(tape, &box);
}

/** @return The end of the surface along an axis; infinite if none is proven. @param is_high Whether
 *  the upper end. */
static double find_end(const SdfNode *tape, int axis, bool is_high) {
    double sign = is_high ? 1 : -1, inside = -BOUNDS_REACH, outside = BOUNDS_REACH;
    if (!is_empty_beyond(tape, axis, is_high, sign * outside)) {
        return sign * HUGE_VAL;
    }
    for (int i = 0; i < AXIS_HALVINGS; i++) {
        double middle = 0.5 * (inside + outside);
        *(is_empty_beyond(tape, axis, is_high, sign * middle) ? &outside : &inside) = middle;
    }
    return sign * outside;
}

/** A proof that a tape is positive in a box, by halves of it. */
typedef struct EmptinessProof {
    const SdfNode *tape; /**< The tape. */
    int parts_left;      /**< Number of parts that may still be examined. */
} EmptinessProof;

/** @return Whether a box is proven to be empty. @param depth Number of halvings left. */
static bool is_empty_by_parts(EmptinessProof *proof, SdfRangeBox box, int depth) {
    if (proof->parts_left-- <= 0) {
        return false;
    }
    bool is_proven = is_empty(proof->tape, &box);
    if (is_proven || depth == 0) {
        return is_proven;
    }
    int longest = 0;
    for (int axis = 1; axis < 3; axis++) {
        bool is_longer = box.axes[axis].high - box.axes[axis].low >
                         box.axes[longest].high - box.axes[longest].low;
        longest = is_longer ? axis : longest;
    }
    SdfRangeBox halves[2] = {box, box};
    halves[0].axes[longest].high = halves[1].axes[longest].low =
        0.5 * (box.axes[longest].low + box.axes[longest].high);
    return is_empty_by_parts(proof, halves[0], depth - 1) &&
           is_empty_by_parts(proof, halves[1], depth - 1);
}

/** @return Whether the part of a box beyond a coordinate is proven to be empty. @param is_high
 *  Whether above it, or else below it. */
static bool is_part_empty(const SdfNode *tape, const SdfRangeBox *box, int axis, bool is_high,
                          double coordinate) {
    EmptinessProof proof = {tape, PARTS_MAXIMUM};
    SdfRangeBox part = *box;
    *(is_high ? &part.axes[axis].low : &part.axes[axis].high) = coordinate;
    return is_empty_by_parts(&proof, part, PART_DEPTH);
}

/** @return Whether a cube around zero is proven to be empty but for a smaller one. */
static bool is_shell_empty(const SdfNode *tape, double size) {
    const SdfRange edge = {-size, size};
    const SdfRangeBox cube = {{edge, edge, edge}};
    bool is_shell = true;
    for (int i = 0; i < 6 && is_shell; i++) {
        double inner = size / SHELL_RATIO;
        is_shell = is_part_empty(tape, &cube, i / 2, i % 2, i % 2 ? inner : -inner);
    }
    return is_shell;
}

/** Finds the ends of a surface that leans, so that no axis alone shows them: shells around zero are
 *  empty, from the outermost one inwards. @param[in,out] box The box; infinite as before if nothing
 *  is proven. */
static void find_ends_by_parts(const SdfNode *tape, SdfRangeBox *box) {
    double size = BOUNDS_REACH;
    if (!is_shell_empty(tape, size)) {
        return;
    }
    while (size > SHELL_MINIMUM && is_shell_empty(tape, size)) {
        size /= SHELL_RATIO;
    }
    for (int axis = 0; axis < 3; axis++) {
        SdfRange *range = &box->axes[axis];
        *range = (SdfRange){fmax(range->low, -size), fmin(range->high, size)};
    }
    for (int side = 0; side < 6; side++) {
        SdfRange *range = &box->axes[side / 2];
        bool is_high = side % 2;
        double inside = is_high ? range->low : range->high;
        double *outside = is_high ? &range->high : &range->low, end = *outside;
        for (int i = 0; i < PART_HALVINGS; i++) {
            double middle = 0.5 * (inside + end);
            *(is_part_empty(tape, box, side / 2, is_high, middle) ? &end : &inside) = middle;
        }
        *outside = end;
    }
}

bool sdf_tape_find_bounds(Sdf *field) {
    const SdfNode *tape = field->nodes;
    SdfRangeBox box = {{everything, everything, everything}};
    if (is_empty(tape, &box)) {
        return false;
    }
    double edge = 0;
    bool is_bounded = true;
    for (int axis = 0; axis < 3; axis++) {
        box.axes[axis] = (SdfRange){find_end(tape, axis, false), find_end(tape, axis, true)};
        is_bounded = is_bounded && isfinite(box.axes[axis].high - box.axes[axis].low);
    }
    if (!is_bounded) {
        find_ends_by_parts(tape, &box);
    }
    for (int axis = 0; axis < 3; axis++) {
        double length = box.axes[axis].high - box.axes[axis].low;
        edge = isfinite(length) ? fmax(edge, length) : edge;
    }
    double margin = BOUNDS_MARGIN * edge;
    field->low =
        (Vec3d){box.axes[0].low - margin, box.axes[1].low - margin, box.axes[2].low - margin};
    field->high =
        (Vec3d){box.axes[0].high + margin, box.axes[1].high + margin, box.axes[2].high + margin};
    return true;
}
