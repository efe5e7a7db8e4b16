/**
 * @file
 * @brief The slope of tapes, measured on random pairs of points.
 */
#include "dioptre/sdf_tape.h"

#include <string.h>

/** Points over the whole region, each with a pair of any length and one along the gradient; and
 *  further points around the steepest pair. */
enum { PAIRS = 1000, PAIRS_NEARBY = 500 };
/** Shortest distance of a pair as a power of two, in sizes of the region: a slope is then wrong by
 *  some 2^-53 / 2^-20 = 1e-10. */
#define DISTANCE_EXPONENT 20
/** Distances of points from zero, or from the one end, along axes without end, powers of two. */
#define REACH_EXPONENT_MINIMUM -4
/** See #REACH_EXPONENT_MINIMUM. */
#define REACH_EXPONENT_MAXIMUM 5
/** What a box is enlarged by to find out whether a tape grows faster outside it. */
#define OUTSIDE_GROWTH 4
/** Factor from one pair around the steepest one to the next: all of them shrink by 4e-5. */
#define NEARBY_SHRINKING 0.98
/** Shortest distance to which a steep pair is halved, as a power of two, in distances from zero. */
#define HALVED_EXPONENT 26
/** A slope above this between two points so near is a jump. */
#define JUMP_SLOPE 1000

/** A pair of points. */
typedef struct SdfPair {
    Vec3d p;        /**< First point. */
    Vec3d q;        /**< Second point. */
    double slope;   /**< |f(p) - f(q)| / |p - q|. */
    bool is_number; /**< Whether the tape is a finite number at both. */
} SdfPair;

/** @return A random number, 0 to 1. Steele, Lea, Flood, *Fast Splittable Pseudorandom Number
 *  Generators*, 2014: splitmix64. */
static double random_unit(uint64_t *state) {
    uint64_t bits = *state += 0x9e3779b97f4a7c15u;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return (double)((bits ^ (bits >> 31)) >> 11) * 0x1p-53;
}

/** @return A random number, -1 to 1. */
static double random_sign(uint64_t *state) {
    return 2 * random_unit(state) - 1;
}

/** The region of the pairs. */
typedef struct PairRegion {
    Vec3d low;   /**< Lowest corner; -infinity: without end. */
    Vec3d high;  /**< Highest corner. */
    double size; /**< Longest edge; 0: none is finite. */
} PairRegion;

/** @return The region of a field. @param growth What its box is enlarged by, per edge. */
static PairRegion region_of(const Sdf *field, double growth) {
    Vec3d edges = vec3d_subtract(field->high, field->low);
    double size = fmax(isfinite(edges.x) ? edges.x : 0, isfinite(edges.y) ? edges.y : 0);
    size = fmax(size, isfinite(edges.z) ? edges.z : 0);
    Vec3d margin = {growth * size, growth * size, growth * size};
    return (PairRegion){vec3d_subtract(field->low, margin), vec3d_add(field->high, margin), size};
}

/** @return A random coordinate: between the ends, or within a reach of the finite one, or of zero.
 */
static double random_coordinate(uint64_t *state, double low, double high, double reach) {
    low = isfinite(low) ? low : isfinite(high) ? high - reach : -reach;
    high = isfinite(high) ? high : low + 2 * reach;
    return low + (high - low) * random_unit(state);
}

/** @return A pair with its slope; 0 if the tape is no number there. */
static SdfPair pair_of(const SdfNode *tape, Vec3d p, Vec3d q) {
    double length = vec3d_length(vec3d_subtract(q, p));
    double change = fabs(sdf_tape_value(tape, p) - sdf_tape_value(tape, q));
    bool is_number = isfinite(change);
    return (SdfPair){p, q, is_number && length > 0 ? change / length : 0, is_number};
}

/** @return A pair in the region. @param p Its first point. @param distance Largest offset of its
 *  second point along each axis. */
static SdfPair pair_near(const SdfNode *tape, const PairRegion *region, uint64_t *state, Vec3d p,
                         double distance) {
    Vec3d step = {distance * random_sign(state), distance * random_sign(state),
                  distance * random_sign(state)};
    p = vec3d_min(vec3d_max(p, region->low), region->high);
    return pair_of(tape, p, vec3d_min(vec3d_max(vec3d_add(p, step), region->low), region->high));
}

/** @return The change of a tape over a step to both sides of a point. */
static double central_change(const SdfNode *tape, Vec3d p, Vec3d step) {
    return sdf_tape_value(tape, vec3d_add(p, step)) - sdf_tape_value(tape, vec3d_subtract(p, step));
}

/** @return A short pair in the direction in which a tape grows fastest. @param p Its first point.
 *  @param length Its length. */
static SdfPair pair_along_gradient(const SdfNode *tape, const PairRegion *region, Vec3d p,
                                   double length) {
    p = vec3d_min(vec3d_max(p, region->low), region->high);
    Vec3d gradient = {central_change(tape, p, (Vec3d){length, 0, 0}),
                      central_change(tape, p, (Vec3d){0, length, 0}),
                      central_change(tape, p, (Vec3d){0, 0, length})};
    double change = vec3d_length(gradient);
    return change > 0 ? pair_of(tape, p, vec3d_add(p, vec3d_scale(gradient, length / change)))
                      : (SdfPair){p, p, 0, false};
}

/** @return The steeper half of a pair, and of that again, until the points are next to each other
 * or the pair is steeper than its halves. */
static SdfPair steepest_part(const SdfNode *tape, SdfPair pair) {
    double shortest = fmax(vec3d_max_abs(pair.p), 1) * exp2(-HALVED_EXPONENT);
    while (vec3d_length(vec3d_subtract(pair.q, pair.p)) > shortest) {
        Vec3d middle = vec3d_scale(vec3d_add(pair.p, pair.q), 0.5);
        SdfPair first = pair_of(tape, pair.p, middle), second = pair_of(tape, middle, pair.q);
        SdfPair steeper = first.slope > second.slope ? first : second;
        if (steeper.slope < pair.slope) {
            break; // The rest are roundings, or points without a number.
        }
        pair = steeper;
    }
    return pair;
}

/** Examines a pair. @param[in,out] found What was found so far. */
static void examine_pair(const SdfNode *tape, SdfPair pair, SdfTapeSlope *found) {
    found->is_number = found->is_number || pair.is_number;
    if (pair.slope > fmax(found->slope, SDF_TAPE_SLOPE_MAXIMUM)) {
        pair = steepest_part(tape, pair);
    }
    if (pair.slope > JUMP_SLOPE) {
        double jump = pair.slope * vec3d_length(vec3d_subtract(pair.q, pair.p));
        found->jump_at = jump > found->jump ? pair.p : found->jump_at;
        found->jump = fmax(found->jump, jump);
    } else if (pair.slope > found->slope) {
        found->slope = pair.slope;
        found->from = pair.p;
        found->to = pair.q;
    }
}

/** @return A random distance. @param size Size of the region. */
static double random_distance(uint64_t *state, double size) {
    return size * exp2(-DISTANCE_EXPONENT * random_unit(state));
}

/** Examines a random pair, and one along the gradient. @param[in,out] found What was found so far.
 */
static void examine_random_pairs(const SdfNode *tape, const PairRegion *region, uint64_t *state,
                                 SdfTapeSlope *found) {
    double exponent = REACH_EXPONENT_MINIMUM +
                      (REACH_EXPONENT_MAXIMUM - REACH_EXPONENT_MINIMUM) * random_unit(state);
    double reach = exp2(exponent), size = region->size > 0 ? region->size : reach;
    Vec3d p = {random_coordinate(state, region->low.x, region->high.x, reach),
               random_coordinate(state, region->low.y, region->high.y, reach),
               random_coordinate(state, region->low.z, region->high.z, reach)};
    examine_pair(tape, pair_near(tape, region, state, p, random_distance(state, size)), found);
    double length = fmax(size, vec3d_max_abs(p)) * exp2(-DISTANCE_EXPONENT);
    examine_pair(tape, pair_along_gradient(tape, region, p, length), found);
}

/** Examines pairs around the steepest one, nearer and nearer. @param[in,out] found What was found
 * so far. */
static void examine_nearby_pairs(const SdfNode *tape, const PairRegion *region, uint64_t *state,
                                 SdfTapeSlope *found) {
    double radius = region->size > 0 ? region->size : 1;
    double length = radius * exp2(-DISTANCE_EXPONENT);
    for (int i = 0; i < PAIRS_NEARBY; i++) {
        radius *= NEARBY_SHRINKING;
        Vec3d offset = {radius * random_sign(state), radius * random_sign(state),
                        radius * random_sign(state)};
        Vec3d p = vec3d_add(found->from, offset);
        examine_pair(tape, pair_along_gradient(tape, region, p, length), found);
    }
}

SdfTapeSlope sdf_tape_measure_slope(const Sdf *field, double growth) {
    /** Any constant is suitable. */
    uint64_t state = 20210101;
    const PairRegion region = region_of(field, growth);
    SdfTapeSlope found = {.slope = 0};
    for (int i = 0; i < PAIRS; i++) {
        examine_random_pairs(field->nodes, &region, &state, &found);
    }
    examine_nearby_pairs(field->nodes, &region, &state, &found);
    return found;
}

SdfTapeSlope sdf_tape_normalize(Sdf *field) {
    const SdfTapeSlope inside = sdf_tape_measure_slope(field, 0),
                       outside = sdf_tape_measure_slope(field, OUTSIDE_GROWTH);
    double *operands = field->nodes[0].operands;
    const double box[6] = {field->low.x,  field->low.y,  field->low.z,
                           field->high.x, field->high.y, field->high.z};
    memcpy(operands + SDF_TAPE_BOX, box, sizeof box);
    operands[SDF_TAPE_SLOPE] = inside.slope;
    if (inside.slope > SDF_TAPE_SLOPE_MAXIMUM ||
        (inside.slope > 1 / SDF_TAPE_CONSTANT_MAXIMUM && inside.slope < SDF_TAPE_SLOPE_MINIMUM)) {
        operands[SDF_TAPE_FACTOR] = 1 / (SDF_TAPE_SLOPE_MARGIN * inside.slope);
    }
    operands[SDF_TAPE_CLAMPS] = outside.slope * operands[SDF_TAPE_FACTOR] > SDF_TAPE_SLOPE_MAXIMUM;
    return inside;
}
