/**
 * @file
 * @brief Octrees of tapes: making and finding cells.
 */
#include "trace/sdf/tape_octree.h"

#include "trace/shapes/shape.h"

#include <stdlib.h>
#include <string.h>

enum {
    OCTREE_TAPE_MINIMUM = LANES > 1 ? 128 : 64, /**< Shorter tapes have no octree: a vector has
                                                   points in several cells (measured). */
    OCTREE_STEPS_MINIMUM = 32,  /**< Cells with fewer steps are not divided: finding a cell costs as
                                   much as some ten steps. */
    OCTREE_CHOICES_MINIMUM = 2, /**< Nor are those with fewer minima and maxima. */
    OCTREE_LEVELS = 4, /**< Most levels below the whole: one more has no room, for 80 balls not even
                          in twice that below (measured). */
    OCTREE_CELLS = 1 + 8 + 64 + 512 + 4096, /**< Most cells: those of all levels. */
    OCTREE_USES_PER_STEP = 512 /**< Room for steps of cells, per step of the tape: as many as the
                                  cells of the last level but one. */
};

/** Number of cells that a cell is divided into. */
enum { OCTANTS = 8 };
/** Begins a function that builds octrees. Each tracer builds its own, once: such a function is to
 * be small, as the page fetches it, not fast. */
#define BUILDS static __attribute__((cold, noinline))
/** Registers of the coordinates; a shortened tape keeps them. */
enum { INPUTS = 3 };

/** Room around the box of a tape, in its longest edge: rays begin just beside it. */
#define OCTREE_MARGIN ((scalar)0x1p-5f)

/* --- ranges ----------------------------------------------------------------------------------- */

/** What LANES numbers lie between; infinite where that is not known, or may be NaN. */
typedef struct NumberRange {
    real low;  /**< Smallest numbers. */
    real high; /**< Largest numbers. */
} NumberRange;

/** Bound on sines and cosines, with their errors. */
#define SINE_BOUND ((scalar)1.0001f)

/** @return Where a range is known: finite. Operations on infinite numbers may give NaN. */
INLINE mask range_is_known(NumberRange range) {
    return (range.low > -INFINITE) & (range.high < INFINITE);
}

/** @return A range where those of its operands are known. One that is not finite, or NaN, is not:
 *          see #range_is_known. */
INLINE NumberRange range_where(mask known, real low, real high) {
    return (NumberRange){real_select(known, low, real_of(-INFINITE)),
                         real_select(known, high, real_of(INFINITE))};
}

/** @return The range of the four results at the ends of two ranges. */
INLINE NumberRange range_of_ends(mask known, real p, real q, real r, real s) {
    return range_where(known, real_min(real_min(p, q), real_min(r, s)),
                       real_max(real_max(p, q), real_max(r, s)));
}

/** @return The range of magnitudes: least 0 where a range contains it. @param p The magnitude at
 * one end of the range. @param q That at the other one. */
INLINE NumberRange range_of_magnitudes(NumberRange a, real p, real q) {
    mask crosses = (a.low <= 0) & (a.high >= 0);
    return range_where(range_is_known(a), real_select(crosses, real_of(0), real_min(p, q)),
                       real_max(p, q));
}

/** Defines the range of the results of an operation. @param EXPRESSION It, from the ranges `a` and
 *  `b` of its operands, the constant `c`, and where both operands are known. */
#define RANGE(NAME, EXPRESSION)                                                                    \
    BUILDS NumberRange range_##NAME(NumberRange a, NumberRange b, real c) {                        \
        const mask known = range_is_known(a) & range_is_known(b);                                  \
        (void)c, (void)known;                                                                      \
        return (EXPRESSION);                                                                       \
    }

/** The constant. */
RANGE(constant, range_where(mask_of(true), c, c))
/** a + b */
RANGE(add, range_where(known, a.low + b.low, a.high + b.high))
/** a - b */
RANGE(subtract, range_where(known, a.low - b.high, a.high - b.low))
/** a * b */
RANGE(multiply,
      range_of_ends(known, (a.low * b.low), (a.low * b.high), (a.high * b.low), (a.high * b.high)))
/** a * a */
RANGE(square, range_of_magnitudes(a, (a.low * a.low), (a.high * a.high)))
/** a / b, unless b may be 0. */
RANGE(divide, range_of_ends((known & ((b.low > 0) | (b.high < 0))), a.low / b.low, a.low / b.high,
                            a.high / b.low, a.high / b.high))
/** The largest integer. */
RANGE(floor, range_where(known, real_floor(a.low), real_floor(a.high)))
/** The remainder by the floor: the same operations as those of the step. */
RANGE(modulo, range_subtract(a, range_multiply(range_floor(range_divide(a, b, c), a, c), b, c), c))
/** The smaller one. */
RANGE(minimum, range_where(known, real_min(a.low, b.low), real_min(a.high, b.high)))
/** The larger one. */
RANGE(maximum, range_where(known, real_max(a.low, b.low), real_max(a.high, b.high)))
/** -a */
RANGE(negate, range_where(known, -a.high, -a.low))
/** The square root; of a negative number NaN, so that it is not known. */
RANGE(square_root, range_where(known, real_sqrt(a.low), real_sqrt(a.high)))
/** The absolute value. */
RANGE(absolute, range_of_magnitudes(a, real_abs(a.low), real_abs(a.high)))
/** Sine and cosine. */
RANGE(sine, range_where(known, real_of(-SINE_BOUND), real_of(SINE_BOUND)))
/** a + c */
RANGE(add_constant, range_where(known, a.low + c, a.high + c))
/** a * c */
RANGE(multiply_constant, range_of_ends(known, (a.low * c), (a.low * c), (a.high * c), (a.high * c)))

/** @return The range of the results of an operation, from those of its operands. */
typedef NumberRange RangeFunction(NumberRange a, NumberRange b, real c);

/** The ranges of operations. */
static RangeFunction *const range_functions[SDF_TAPE_OP_COUNT] = {
    [SDF_TAPE_CONSTANT] = range_constant,
    [SDF_TAPE_ADD] = range_add,
    [SDF_TAPE_SUBTRACT] = range_subtract,
    [SDF_TAPE_MULTIPLY] = range_multiply,
    [SDF_TAPE_DIVIDE] = range_divide,
    [SDF_TAPE_MODULO] = range_modulo,
    [SDF_TAPE_MINIMUM] = range_minimum,
    [SDF_TAPE_MAXIMUM] = range_maximum,
    [SDF_TAPE_NEGATE] = range_negate,
    [SDF_TAPE_SQUARE_ROOT] = range_square_root,
    [SDF_TAPE_ABSOLUTE] = range_absolute,
    [SDF_TAPE_FLOOR] = range_floor,
    [SDF_TAPE_SINE] = range_sine,
    [SDF_TAPE_COSINE] = range_sine,
    [SDF_TAPE_ADD_CONSTANT] = range_add_constant,
    [SDF_TAPE_MULTIPLY_CONSTANT] = range_multiply_constant};

/** @return The range of the results of a step. */
BUILDS NumberRange range_of_step(const TapeStep *step, const TapeUse *use,
                                 const NumberRange *registers) {
    const bool is_square = step->op == SDF_TAPE_MULTIPLY && use->a == use->b;
    RangeFunction *function = is_square ? range_square : range_functions[step->op];
    return function(registers[use->a], registers[use->b], real_of(step->constant));
}

/* --- shorter tapes ---------------------------------------------------------------------------- */

/** Most numbers of a tape: the coordinates and the results of its steps. */
enum { NUMBERS_MAXIMUM = INPUTS + SDF_TAPE_STEPS_MAXIMUM };

/** What is needed while an octree is built. */
typedef struct OctreeWork {
    NumberRange registers[SDF_TAPE_REGISTERS]; /**< Ranges in LANES cells. */
    uint16_t takes_a[SDF_TAPE_STEPS_MAXIMUM];  /**< Bit i: in lane i the step always gives a. */
    uint16_t takes_b[SDF_TAPE_STEPS_MAXIMUM];  /**< Bit i: in lane i it always gives b. */
    uint16_t number_in[SDF_TAPE_REGISTERS];    /**< Number that a register holds. */
    uint16_t same_as[NUMBERS_MAXIMUM];         /**< Number that is always the same, or itself. */
    uint16_t a[SDF_TAPE_STEPS_MAXIMUM];        /**< Number of the first operand of a step. */
    uint16_t b[SDF_TAPE_STEPS_MAXIMUM];        /**< Number of its second operand. */
    int last_use[NUMBERS_MAXIMUM];             /**< Last step that needs a number; -1: none. */
    uint16_t register_of[NUMBERS_MAXIMUM];     /**< Register of a number in the shorter tape. */
    uint16_t free[SDF_TAPE_REGISTERS];         /**< Registers that hold nothing. */
    int free_count;                            /**< Number of these. */
} OctreeWork;

/** @return Whether a step chooses between two numbers. */
INLINE bool step_chooses(SdfTapeOp op) {
    return op == SDF_TAPE_MINIMUM || op == SDF_TAPE_MAXIMUM;
}

/** Notes in which cells a step always gives one of its operands. Of equal ones it gives a. @param i
 *  Its index in the tape. */
BUILDS void note_choice(OctreeWork *work, SdfTapeOp op, const TapeUse *use, int i) {
    work->takes_a[i] = work->takes_b[i] = 0;
    if (step_chooses(op)) {
        const NumberRange a = work->registers[use->a], b = work->registers[use->b];
        const bool is_minimum = op == SDF_TAPE_MINIMUM;
        mask is_a = is_minimum ? a.high <= b.low : a.low >= b.high;
        mask is_b = is_minimum ? b.high < a.low : b.low > a.high;
        mask both = range_is_known(a) & range_is_known(b);
        work->takes_a[i] = (uint16_t)mask_bits(is_a & both);
        work->takes_b[i] = (uint16_t)mask_bits(is_b & both & mask_not(is_a));
    }
}

/** Finds which operands of minima and maxima win in LANES cells. @return The range of the result.
 *  @param low Lowest corners. @param high Highest ones. */
BUILDS NumberRange find_choices(OctreeWork *work, Tape tape, Vec3 low, Vec3 high) {
    work->registers[0] = (NumberRange){low.x, high.x};
    work->registers[1] = (NumberRange){low.y, high.y};
    work->registers[2] = (NumberRange){low.z, high.z};
    for (int i = 0; i < tape.count; i++) {
        const TapeUse *use = tape_use(&tape, i);
        const TapeStep *step = tape_step(&tape, i);
        note_choice(work, step->op, use, i);
        work->registers[use->to] = range_of_step(step, use, work->registers);
    }
    return work->registers[tape.result];
}

/** Finds what the steps of a tape need where some of their choices are known. @return The number
 *  that is the result. @param lane Which of the cells. */
BUILDS uint16_t find_operands(OctreeWork *work, Tape tape, int lane) {
    for (int i = 0; i < INPUTS; i++) {
        work->number_in[i] = work->same_as[i] = (uint16_t)i;
    }
    for (int i = 0; i < tape.count; i++) {
        const TapeUse *use = tape_use(&tape, i);
        const uint16_t number = (uint16_t)(INPUTS + i);
        const int operands = sdf_tape_operand_count(tape_step(&tape, i)->op);
        work->a[i] = operands > 0 ? work->same_as[work->number_in[use->a]] : 0;
        work->b[i] = operands > 1 ? work->same_as[work->number_in[use->b]] : work->a[i];
        work->same_as[number] = work->takes_a[i] >> lane & 1   ? work->a[i]
                                : work->takes_b[i] >> lane & 1 ? work->b[i]
                                                               : number;
        work->number_in[use->to] = number;
    }
    return work->same_as[work->number_in[tape.result]];
}

/** Finds the last uses of the numbers of a tape. @param result The number that is the result.
 *  @return Number of steps that are needed. */
BUILDS int find_last_uses(OctreeWork *work, Tape tape, uint16_t result) {
    int needed = 0;
    for (int i = 0; i < INPUTS + tape.count; i++) {
        work->last_use[i] = -1;
    }
    work->last_use[result] = tape.count;
    for (int i = tape.count - 1; i >= 0; i--) {
        if (work->last_use[INPUTS + i] < 0) {
            continue;
        }
        needed++;
        if (sdf_tape_operand_count(tape_step(&tape, i)->op) > 0) {
            int *a = &work->last_use[work->a[i]], *b = &work->last_use[work->b[i]];
            *a = *a < 0 ? i : *a;
            *b = *b < 0 ? i : *b;
        }
    }
    return needed;
}

/** Frees the register of a number after its last use. Those of the coordinates stay. */
INLINE void release_number(OctreeWork *work, uint16_t number, int step) {
    if (number >= INPUTS && work->last_use[number] == step) {
        work->last_use[number] = -1; // Once, if it is both operands.
        work->free[work->free_count++] = work->register_of[number];
    }
}

/** Writes the steps of a tape that are needed. @param[out] uses Room for them. @return false
 *  without a free register: a tape that needs nearly all may also use those of the coordinates. */
BUILDS bool write_uses(OctreeWork *work, Tape tape, TapeUse *uses) {
    work->free_count = 0;
    for (int i = SDF_TAPE_REGISTERS - 1; i >= INPUTS; i--) {
        work->free[work->free_count++] = (uint16_t)i;
    }
    for (uint16_t i = 0; i < INPUTS; i++) {
        work->register_of[i] = i;
    }
    for (int i = 0; i < tape.count; i++) {
        const int number = INPUTS + i;
        if (work->last_use[number] < 0) {
            continue;
        }
        const uint16_t step = tape_use(&tape, i)->step, a = work->register_of[work->a[i]],
                       b = work->register_of[work->b[i]];
        if (sdf_tape_operand_count(tape_step(&tape, i)->op) > 0) {
            release_number(work, work->a[i], i);
            release_number(work, work->b[i], i);
        }
        if (work->free_count == 0) {
            return false;
        }
        work->register_of[number] = work->free[--work->free_count];
        *uses++ = (TapeUse){step, work->register_of[number], a, b};
    }
    return true;
}

/** @return The tape for a cell: a shorter one, or the same. @param lane Which of the cells of
 *          #find_choices. @param[out] uses Room for its steps. */
BUILDS Tape tape_shorten(OctreeWork *work, Tape tape, int lane, TapeUse *uses) {
    const uint16_t result = find_operands(work, tape, lane);
    const int count = find_last_uses(work, tape, result);
    return count == tape.count || !write_uses(work, tape, uses)
               ? tape
               : (Tape){tape.steps, uses, (uint16_t)count, work->register_of[result]};
}

/* --- cells ------------------------------------------------------------------------------------ */

/** A box of points. */
typedef struct CellBox {
    scalar low[3];  /**< Lowest corner. */
    scalar high[3]; /**< Highest corner. */
} CellBox;

/** @return The middle of a box along an axis. */
INLINE scalar box_middle(const CellBox *box, int axis) {
    return (scalar)0.5f * (box->low[axis] + box->high[axis]);
}

/** Halves a box along each axis. @param octant Bit i: the upper half along axis i is left. */
INLINE void box_take_octant(CellBox *box, unsigned octant) {
    for (int axis = 0; axis < 3; axis++) {
        *(octant >> axis & 1 ? &box->low[axis] : &box->high[axis]) = box_middle(box, axis);
    }
}

/** @return The longest edge of a box. */
static scalar box_length(const CellBox *box) {
    scalar length = 0;
    for (int axis = 0; axis < 3; axis++) {
        scalar edge = box->high[axis] - box->low[axis];
        length = edge > length ? edge : length;
    }
    return length;
}

/** @return Number of minima and maxima of a tape. */
BUILDS int count_choices(Tape tape) {
    int choices = 0;
    for (int i = 0; i < tape.count; i++) {
        choices += step_chooses(tape_step(&tape, i)->op);
    }
    return choices;
}

/** An octree that is being built. */
typedef struct OctreeBuilder {
    TapeOctree *octree; /**< It. */
    OctreeWork *work;   /**< For LANES cells at a time. */
    TapeUse *stack;     /**< Tapes of the cells that are being divided: eight per level. */
    scalar factor;      /**< Factor of the tape's result, which makes it a distance. */
    size_t room;        /**< Room in #TapeOctree.uses. */
    size_t kept;        /**< Number of cells that are not divided. */
    int levels;         /**< Most levels. */
    bool is_full;       /**< Whether room has run out. */
} OctreeBuilder;

/** The eight parts of a cell. */
typedef struct Octants {
    Tape tapes[OCTANTS];  /**< Their tapes. */
    bool is_far[OCTANTS]; /**< Whether all of a part is farther from the surface than it is long:
                             rays cross it in a step or two. */
} Octants;

/** Finds the tapes of the parts of a cell. @param[out] uses Room for eight tapes as long as that
 *  of the cell. */
BUILDS void find_octants(OctreeBuilder *builder, const CellBox *box, Tape tape, TapeUse *uses,
                         Octants *octants) {
    OctreeWork *work = builder->work;
    const scalar length = box_length(box) / 2 / builder->factor;
    for (unsigned first = 0; first < OCTANTS; first += LANES) {
        Vec3 low, high;
        for (unsigned lane = 0; lane < LANES; lane++) {
            CellBox part = *box;
            box_take_octant(&part, (first + lane) % OCTANTS);
            real_set_lane(&low.x, (int)lane, part.low[0]);
            real_set_lane(&low.y, (int)lane, part.low[1]);
            real_set_lane(&low.z, (int)lane, part.low[2]);
            real_set_lane(&high.x, (int)lane, part.high[0]);
            real_set_lane(&high.y, (int)lane, part.high[1]);
            real_set_lane(&high.z, (int)lane, part.high[2]);
        }
        const NumberRange result = find_choices(work, tape, low, high);
        for (unsigned lane = 0; lane < LANES && first + lane < OCTANTS; lane++) {
            const unsigned octant = first + lane;
            octants->tapes[octant] =
                tape_shorten(work, tape, (int)lane, uses + octant * (size_t)tape.count);
            octants->is_far[octant] = real_lane(result.low, (int)lane) > length ||
                                      real_lane(result.high, (int)lane) < -length;
        }
    }
}

/** Keeps a tape in a cell that is not divided. */
BUILDS void cell_keep_tape(OctreeBuilder *builder, TapeCell *cell, Tape tape) {
    TapeOctree *octree = builder->octree;
    builder->is_full |= octree->use_count + tape.count > builder->room;
    if (!builder->is_full) {
        for (int i = 0; i < tape.count; i++) {
            octree->uses[octree->use_count + (size_t)i] = *tape_use(&tape, i);
        }
        *cell = (TapeCell){0, (uint32_t)octree->use_count, tape.count, tape.result};
        octree->use_count += tape.count;
        builder->kept++;
    }
}

/** Divides a cell as long as that pays, or keeps its tape. @param level Its level; the whole: 0.
 *  @param uses Free part of #OctreeBuilder.stack. */
BUILDS void cell_build(OctreeBuilder *builder, uint32_t index, const CellBox *box, Tape tape,
                       bool is_far, int level, TapeUse *uses) {
    TapeOctree *octree = builder->octree;
    if (is_far || level == builder->levels || tape.count < OCTREE_STEPS_MINIMUM ||
        count_choices(tape) < OCTREE_CHOICES_MINIMUM) {
        cell_keep_tape(builder, &octree->cells[index], tape);
        return;
    }
    const uint32_t children = octree->cell_count;
    Octants octants;
    find_octants(builder, box, tape, uses, &octants);
    octree->cells[index].children = children;
    octree->cell_count += OCTANTS;
    for (unsigned octant = 0; octant < OCTANTS && !builder->is_full; octant++) {
        CellBox part = *box;
        box_take_octant(&part, octant);
        cell_build(builder, children + octant, &part, octants.tapes[octant], octants.is_far[octant],
                   level + 1, uses + OCTANTS * (size_t)tape.count);
    }
}

/** @return The box of an octree: that of its tape, and some room around. */
BUILDS CellBox octree_box(const SdfInstruction *instruction) {
    CellBox box;
    const scalar *corners = instruction->operands + SDF_TAPE_BOX;
    memcpy(box.low, corners, sizeof box.low);
    memcpy(box.high, corners + 3, sizeof box.high);
    const scalar margin = OCTREE_MARGIN * box_length(&box);
    for (int axis = 0; axis < 3; axis++) {
        box.low[axis] -= margin;
        box.high[axis] += margin;
    }
    return box;
}

size_t tape_octree_size(const SdfNode *tape) {
    int choices = 0;
    bool has_box = true;
    for (int i = 1; i <= tape->body_count; i++) {
        choices += step_chooses((SdfTapeOp)tape[i].operands[SDF_STEP_OP]);
    }
    for (int i = 0; i < 6; i++) {
        // The lengths of a larger one would not be in the range of float.
        has_box = has_box && fabs(tape->operands[SDF_TAPE_BOX + i]) <= SDF_TAPE_CONSTANT_MAXIMUM;
    }
    if (!HAS_TAPE_OCTREES || tape->body_count < OCTREE_TAPE_MINIMUM ||
        choices < OCTREE_CHOICES_MINIMUM || !has_box) {
        return 0;
    }
    return shape_aligned_size(sizeof(TapeOctree)) +
           shape_aligned_size(OCTREE_CELLS * sizeof(TapeCell)) +
           shape_aligned_size((size_t)tape->body_count * OCTREE_USES_PER_STEP * sizeof(TapeUse));
}

/** Builds an octree with all levels, or with one less: for that there is always room. */
BUILDS void octree_build_levels(OctreeBuilder *builder, const SdfInstruction *instruction) {
    const CellBox box = octree_box(instruction);
    TapeOctree *octree = builder->octree;
    memcpy(octree->low, box.low, sizeof box.low);
    memcpy(octree->high, box.high, sizeof box.high);
    builder->levels = OCTREE_LEVELS + 1;
    do {
        builder->levels--;
        octree->cell_count = 1;
        octree->use_count = builder->kept = 0;
        builder->is_full = false;
        cell_build(builder, 0, &box, tape_of(instruction), false, 0, builder->stack);
    } while (builder->is_full);
}

/** @return Whether the tapes of cells are shorter on average than three quarters of the whole. */
static bool octree_is_worthwhile(const OctreeBuilder *builder, size_t count) {
    return 4 * builder->octree->use_count < 3 * builder->kept * count;
}

const TapeOctree *tape_octree_build(void *memory, const SdfInstruction *instruction) {
    if (!HAS_TAPE_OCTREES) {
        return NULL; // Nothing of the rest is compiled.
    }
    const size_t count = (size_t)instruction->body_count;
    TapeOctree *octree = memory;
    char *cells = (char *)memory + shape_aligned_size(sizeof *octree);
    *octree = (TapeOctree){
        .cells = (TapeCell *)(void *)cells,
        .uses = (TapeUse *)(void *)(cells + shape_aligned_size(OCTREE_CELLS * sizeof(TapeCell)))};
    OctreeBuilder builder = {
        .octree = octree,
        .work = aligned_alloc(SHAPE_ALIGNMENT, shape_aligned_size(sizeof *builder.work)),
        .stack = malloc(OCTREE_LEVELS * OCTANTS * count * sizeof *builder.stack),
        .factor = instruction->operands[SDF_TAPE_FACTOR],
        .room = count * OCTREE_USES_PER_STEP};
    const bool has_memory = builder.work && builder.stack;
    if (has_memory) {
        octree_build_levels(&builder, instruction);
    }
    free(builder.work);
    free(builder.stack);
    return has_memory && octree_is_worthwhile(&builder, count) ? octree : NULL;
}

/* --- points ----------------------------------------------------------------------------------- */

/** @return The points in a box, as bits. */
INLINE unsigned box_contains(const CellBox *box, Vec3 p) {
    return real_less_equal_bits(real_of(box->low[0]), p.x) &
           real_less_equal_bits(p.x, real_of(box->high[0])) &
           real_less_equal_bits(real_of(box->low[1]), p.y) &
           real_less_equal_bits(p.y, real_of(box->high[1])) &
           real_less_equal_bits(real_of(box->low[2]), p.z) &
           real_less_equal_bits(p.z, real_of(box->high[2]));
}

TapeLanes tape_octree_find(const TapeOctree *octree, Tape whole, Vec3 p, unsigned lanes) {
    CellBox box;
    memcpy(box.low, octree->low, sizeof box.low);
    memcpy(box.high, octree->high, sizeof box.high);
    const unsigned inside = lanes & box_contains(&box, p);
    const int first = __builtin_ctz(lanes);
    if (!(inside >> first & 1)) {
        return (TapeLanes){whole, lanes & ~inside};
    }
    const scalar x = real_at(&p.x, first), y = real_at(&p.y, first), z = real_at(&p.z, first);
    const TapeCell *cell = octree->cells;
    while (cell->children) {
        const unsigned octant = (unsigned)(x > box_middle(&box, 0)) |
                                (unsigned)(y > box_middle(&box, 1)) << 1 |
                                (unsigned)(z > box_middle(&box, 2)) << 2;
        box_take_octant(&box, octant);
        cell = &octree->cells[cell->children + octant];
    }
    const Tape tape = {whole.steps, &octree->uses[cell->first_use], cell->count, cell->result};
    return (TapeLanes){tape, inside & box_contains(&box, p)};
}
