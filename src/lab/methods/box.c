/**
 * @file
 * @brief Where does a ray hit an axis-aligned box?
 *
 * A slab is the space between two parallel planes; a box is the intersection of three slabs. Low
 * and high are its corners, o and d the ray's origin and direction along an axis.
 */
#include "lab/methods/family.h"

/** A ray and a box. */
typedef struct BoxInput {
    Vec3 origin;    /**< Origin of the ray. */
    Vec3 direction; /**< Direction. */
    Vec3 low;       /**< Lowest corner. */
    Vec3 high;      /**< Highest corner. */
} BoxInput;

/** The hits. */
typedef struct BoxOutput {
    real distance; /**< The nearest hit ahead; #INFINITE: none. */
    real count;    /**< Hits ahead; from inside the box it must be 1. */
} BoxOutput;

/** The interval of a ray in a slab, or in a box. */
typedef struct SlabInterval {
    real near; /**< Where it begins. */
    real far;  /**< Where it ends. */
} SlabInterval;

/** @return The hits of a ray that is in the box within an interval. */
static BoxOutput box_output_of(SlabInterval interval) {
    int is_hit = interval.near <= interval.far && interval.far >= 0;
    return (BoxOutput){.distance =
                           is_hit ? (interval.near > 0 ? interval.near : interval.far) : INFINITE,
                       .count = is_hit ? (interval.near > 0 ? 2 : 1) : 0};
}

/** Clips an interval to a slab. @return Whether anything is left. */
static int box_slabs_nan_misses_clip(SlabInterval *interval, real origin, real direction, real low,
                                     real high) {
    real t1 = (low - origin) / direction, t2 = (high - origin) / direction;
    real near = t1 <= t2 ? t1 : t2, far = t1 <= t2 ? t2 : t1;
    interval->near = near <= interval->near ? interval->near : near;
    interval->far = far >= interval->far ? interval->far : far;
    return interval->near <= interval->far;
}

/**
 * Slabs as in a textbook.
 *
 *   t1 = (low - o) / d,  t2 = (high - o) / d,  swapped where t1 > t2; no slab may leave an empty
 *   interval
 *
 * For a ray in the plane of a face t is 0 / 0: NaN. Every comparison is written as "continue only
 * if", so that NaN is a miss.
 */
METHOD(box_slabs_nan_misses, BoxInput, BoxOutput) {
    SlabInterval interval = {-INFINITE, INFINITE};
    const Vec3 *o = &in->origin, *d = &in->direction, *low = &in->low, *high = &in->high;
    int is_hit = box_slabs_nan_misses_clip(&interval, o->x, d->x, low->x, high->x) &&
                 box_slabs_nan_misses_clip(&interval, o->y, d->y, low->y, high->y) &&
                 box_slabs_nan_misses_clip(&interval, o->z, d->z, low->z, high->z);
    return is_hit ? box_output_of(interval) : (BoxOutput){.distance = INFINITE};
}

/** Clips an interval to a slab. @param far_factor By which the far end is multiplied. */
static void box_slabs_clip(SlabInterval *interval, real origin, real direction, real low, real high,
                           real far_factor) {
    real inverse = 1 / direction;
    real enter = ((inverse < 0 ? high : low) - origin) * inverse;
    real leave = ((inverse < 0 ? low : high) - origin) * inverse * far_factor;
    interval->near = enter > interval->near ? enter : interval->near;
    interval->far = leave < interval->far ? leave : interval->far;
}

/** @return The hits by three slabs. @param far_factor See #box_slabs_clip. */
static BoxOutput box_slabs_intersect(const BoxInput *in, real far_factor) {
    SlabInterval interval = {-INFINITE, INFINITE};
    const Vec3 *o = &in->origin, *d = &in->direction, *low = &in->low, *high = &in->high;
    box_slabs_clip(&interval, o->x, d->x, low->x, high->x, far_factor);
    box_slabs_clip(&interval, o->y, d->y, low->y, high->y, far_factor);
    box_slabs_clip(&interval, o->z, d->z, low->z, high->z, far_factor);
    return box_output_of(interval);
}

/**
 * Slabs with a minimum and a maximum that ignore NaN.
 *
 *   near = max(near, min(t1, t2)),  far = min(far, max(t1, t2)), t by the inverse of the direction
 *
 * A ray in the plane of a face is inside the slab now. But near and far are rounded separately: at
 * edges and corners, and where a box is flat, near may exceed far.
 */
METHOD(box_slabs_nan_ignored, BoxInput, BoxOutput) {
    return box_slabs_intersect(in, 1);
}

/**
 * Slabs with the far end moved away by its error bound (Ize, *Robust BVH Ray Traversal*, JCGT
 * 2013). The tracer computes it so.
 *
 *   far (1 + 2 gamma_3),  gamma_3 = 3 u / (1 - 3 u)
 *
 * t is a difference, an inverse and a product: three roundings. With the bound added, far is never
 * below a near that is at most far in exact arithmetic.
 */
METHOD(box_slabs_robust, BoxInput, BoxOutput) {
    const real gamma = 3 * ROUNDOFF / (1 - 3 * ROUNDOFF);
    return box_slabs_intersect(in, 1 + 2 * gamma);
}

/**
 * Quilez, `boxIntersection` of his *Intersectors* (MIT licence; see doc/references.md).
 *
 *   m = 1 / d,  n = m (P0 - C),  k = |m| r,  near = max(-n - k),  far = min(-n + k), for a box with
 *   centre C and half its size r
 *
 * Where d is 0 in an axis, n and k are infinite or NaN: a ray along a face is a matter of luck. A
 * centre and half a size must be rounded where low and high need not be.
 */
METHOD(box_quilez, BoxInput, BoxOutput) {
    const real half = (scalar)0.5f;
    Vec3 center = vec3_scale(vec3_add(in->low, in->high), half);
    Vec3 extent = vec3_scale(vec3_subtract(in->high, in->low), half);
    Vec3 o = vec3_subtract(in->origin, center), d = in->direction;
    Vec3 m = {1 / d.x, 1 / d.y, 1 / d.z}, n = {m.x * o.x, m.y * o.y, m.z * o.z};
    Vec3 k = {real_abs(m.x) * extent.x, real_abs(m.y) * extent.y, real_abs(m.z) * extent.z};
    real near = real_max(real_max(-n.x - k.x, -n.y - k.y), -n.z - k.z);
    real far = real_min(real_min(-n.x + k.x, -n.y + k.y), -n.z + k.z);
    return !(near > far || far < 0) ? box_output_of((SlabInterval){near, far})
                                    : (BoxOutput){.distance = INFINITE};
}

/** A box in a cyclic order of axes: [0] is across a pair of faces, [1] and [2] are in them. */
typedef struct BoxFace {
    real origin[3];    /**< Origin of the ray. */
    real direction[3]; /**< Direction. */
    real low[3];       /**< Lowest corner of the box. */
    real high[3];      /**< Highest corner. */
} BoxFace;

/** Intersects a face. @param plane Its coordinate along axis [0]. */
static void box_face_intersect(const BoxFace *face, real plane, BoxOutput *out) {
    real t = (plane - face->origin[0]) / face->direction[0];
    real u = face->origin[1] + face->direction[1] * t;
    real v = face->origin[2] + face->direction[2] * t;
    int is_inside =
        u >= face->low[1] && u <= face->high[1] && v >= face->low[2] && v <= face->high[2];
    if (is_inside && t > 0) {
        out->count += 1;
        out->distance = real_min(t, out->distance);
    }
}

/**
 * A cube as six quads, as in reports C and D (doc/reports.md).
 *
 * Each quad tests its own rounded point. At an edge both neighbours may report a miss, and the ray
 * leaks, or both a hit.
 */
METHOD(box_six_quads, BoxInput, BoxOutput) {
    const Vec3 *o = &in->origin, *d = &in->direction, *low = &in->low, *high = &in->high;
    const BoxFace faces[] = {{{o->x, o->y, o->z},
                              {d->x, d->y, d->z},
                              {low->x, low->y, low->z},
                              {high->x, high->y, high->z}},
                             {{o->y, o->z, o->x},
                              {d->y, d->z, d->x},
                              {low->y, low->z, low->x},
                              {high->y, high->z, high->x}},
                             {{o->z, o->x, o->y},
                              {d->z, d->x, d->y},
                              {low->z, low->x, low->y},
                              {high->z, high->x, high->y}}};
    BoxOutput out = {.distance = INFINITE};
    for (int i = 0; i < 3; i++) {
        box_face_intersect(&faces[i], faces[i].low[0], &out);
        box_face_intersect(&faces[i], faces[i].high[0], &out);
    }
    return out;
}

const MethodFamily box_slabs_family = {
    FAMILY("box-slabs", BoxInput, BoxOutput),
    (const Method[]){{"NaN misses", "NaN misses", box_slabs_nan_misses_run},
                     {"NaN drops out", "NaN drops out", box_slabs_nan_ignored_run},
                     {"far(1+2g3)", "far(1+2g3)", box_slabs_robust_run},
                     {"Quilez", "Quilez", box_quilez_run},
                     {0}}};

const MethodFamily box_cube_family = {
    FAMILY("box-cube", BoxInput, BoxOutput),
    (const Method[]){{"six quads", "six quads", box_six_quads_run},
                     {"slabs", "slabs", box_slabs_robust_run},
                     {"Quilez", "Quilez", box_quilez_run},
                     {0}}};
