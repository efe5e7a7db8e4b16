/**
 * @file
 * @brief Interval arithmetic for tapes: their values in double, and where they have no surface.
 *
 * Roundings are not turned outwards: a box is enlarged by much more than they are
 * (#BOUNDS_MARGIN).
 */
#include "scene/sdf_tape_range.h"

/** What a box is enlarged by, per edge: far more than the roundings of a tape. */
#define BOUNDS_MARGIN 0x1p-8
/** Where a search for an end of a box starts, scene units: below #LENGTH_MAXIMUM. */
#define BOUNDS_START 0x1p49
/** Number of halvings of a search for an end of a box: down to 2^-20 units. */
enum { BOUNDS_HALVINGS = 70 };
/** Number of boxes that are examined where no end is found along the axes alone. */
enum { BOUNDS_BOXES_MAXIMUM = 6000 };

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
        return NAN;
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
    const SdfRange point[3] = {{p.x, p.x}, {p.y, p.y}, {p.z, p.z}};
    return sdf_tape_range(tape, point).low;
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
    double sign = is_high ? 1 : -1, inside = -BOUNDS_START, outside = BOUNDS_START;
    if (!is_empty_beyond(tape, axis, is_high, sign * outside)) {
        return sign * HUGE_VAL;
    }
    for (int i = 0; i < BOUNDS_HALVINGS; i++) {
        double middle = 0.5 * (inside + outside);
        *(is_empty_beyond(tape, axis, is_high, sign * middle) ? &outside : &inside) = middle;
    }
    return sign * outside;
}

/** The boxes that are examined, halved level by level. */
typedef struct BoxQueue {
    SdfRangeBox *boxes; /**< The boxes. */
    int first;          /**< First that waits. */
    int count;          /**< Number of boxes. */
} BoxQueue;

bool sdf_tape_find_bounds(Sdf *field) {
    const SdfNode *tape = field->nodes;
    const SdfRangeBox space = {{everything, everything, everything}};
    if (is_empty(tape, &space)) {
        return false;
    }
    double ends[2][3], edge = 0;
    for (int axis = 0; axis < 3; axis++) {
        for (int side = 0; side < 2; side++) {
            ends[side][axis] = find_end(tape, axis, side == 1);
        }
        double length = ends[1][axis] - ends[0][axis];
        edge = isfinite(length) ? fmax(edge, length) : edge;
    }
    field->low = (Vec3d){ends[0][0], ends[0][1], ends[0][2]};
    field->high = (Vec3d){ends[1][0], ends[1][1], ends[1][2]};
    Vec3d margin = {BOUNDS_MARGIN * edge, BOUNDS_MARGIN * edge, BOUNDS_MARGIN * edge};
    field->low = vec3d_subtract(field->low, margin);
    field->high = vec3d_add(field->high, margin);
    return true;
}
