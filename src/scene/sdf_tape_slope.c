/**
 * @file
 * @brief The slope of tapes, measured on random pairs of points.
 */
#include "dioptre/sdf_tape.h"

/** Pairs of points over the whole region, and further ones around the steepest of them. */
enum { PAIRS = 3000, PAIRS_NEARBY = 500 };
/** Shortest distance of a pair as a power of two, in sizes of the region: a slope is then wrong by
 *  some 2^-53 / 2^-20 = 1e-10. */
#define DISTANCE_EXPONENT 20
/** Distances of points from zero along axes without end, as powers of two. */
#define REACH_EXPONENT_MINIMUM -4
/** See #REACH_EXPONENT_MINIMUM. */
#define REACH_EXPONENT_MAXIMUM 5
/** Shortest distance to which a steep pair is halved, as a power of two, in distances from zero. */
#define HALVED_EXPONENT 26
/** A slope above this between two points so near is a jump. */
#define JUMP_SLOPE 1000

/** A pair of points. */
typedef struct SdfPair {
    Vec3d p;      /**< First point. */
    Vec3d q;      /**< Second point. */
    double slope; /**< |f(p) - f(q)| / |p - q|. */
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

/** @return A random coordinate: within twice the box, or within a reach. */
static double random_coordinate(uint64_t *state, double low, double high, double reach) {
    double length = high - low;
    return isfinite(length) ? 0.5 * (low + high) + length * random_sign(state)
                            : reach * random_sign(state);
}

/** @return A pair with its slope; 0 if the tape is no number there. */
static SdfPair pair_of(const SdfNode *tape, Vec3d p, Vec3d q) {
    double length = vec3d_length(vec3d_subtract(q, p));
    double change = fabs(sdf_tape_value(tape, p) - sdf_tape_value(tape, q));
    bool is_known = length > 0 && isfinite(change);
    return (SdfPair){p, q, is_known ? change / length : 0};
}

/** @return A random pair. @param size The longest edge of the box; 0 if it has none. */
static SdfPair random_pair(const Sdf *field, uint64_t *state, double size) {
    double exponent = REACH_EXPONENT_MINIMUM +
                      (REACH_EXPONENT_MAXIMUM - REACH_EXPONENT_MINIMUM) * random_unit(state);
    double reach = exp2(exponent);
    Vec3d p = {random_coordinate(state, field->low.x, field->high.x, reach),
               random_coordinate(state, field->low.y, field->high.y, reach),
               random_coordinate(state, field->low.z, field->high.z, reach)};
    double distance = (size > 0 ? size : reach) * exp2(-DISTANCE_EXPONENT * random_unit(state));
    Vec3d step = {distance * random_sign(state), distance * random_sign(state),
                  distance * random_sign(state)};
    return pair_of(field->nodes, p, vec3d_add(p, step));
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
    if (pair.slope > fmax(found->slope, SDF_TAPE_SLOPE_MAXIMUM)) {
        pair = steepest_part(tape, pair);
    }
    if (pair.slope > JUMP_SLOPE) {
        double jump = pair.slope * vec3d_length(vec3d_subtract(pair.q, pair.p));
        found->jump_at = jump > found->jump ? pair.p : found->jump_at;
        found->jump = fmax(found->jump, jump);
    } else if (pair.slope > found->slope) {
        *found = (SdfTapeSlope){pair.slope, pair.p, pair.q, found->jump, found->jump_at};
    }
}

SdfTapeSlope sdf_tape_measure_slope(const Sdf *field) {
    /** Any constant is suitable. */
    uint64_t state = 20210101;
    SdfTapeSlope found = {.slope = 0};
    Vec3d edges = vec3d_subtract(field->high, field->low);
    double size = fmax(isfinite(edges.x) ? edges.x : 0, isfinite(edges.y) ? edges.y : 0);
    size = fmax(size, isfinite(edges.z) ? edges.z : 0);
    for (int i = 0; i < PAIRS; i++) {
        examine_pair(field->nodes, random_pair(field, &state, size), &found);
    }
    double radius = size > 0 ? size : 1;
    for (int i = 0; i < PAIRS_NEARBY && found.slope > SDF_TAPE_SLOPE_MAXIMUM; i++) {
        radius *= 0.98;
        Vec3d offset = {radius * random_sign(&state), radius * random_sign(&state),
                        radius * random_sign(&state)};
        Vec3d step = {radius * random_sign(&state), radius * random_sign(&state),
                      radius * random_sign(&state)};
        Vec3d p = vec3d_add(found.from, offset);
        examine_pair(field->nodes, pair_of(field->nodes, p, vec3d_add(p, vec3d_scale(step, 0.01))),
                     &found);
    }
    return found;
}
