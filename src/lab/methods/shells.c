/**
 * @file
 * @brief Does a ray that goes straight through two concentric spheres, close to each other, meet
 *        all four surfaces?
 *
 * So thin is a cornea: 4e-5 of its radius in a model of the eye. After each hit the ray starts
 * anew, as one that is refracted does. N is the outward normal, d the ray's direction, P the hit
 * point, u half an ulp of 1.
 */
#include "lab/methods/family.h"

/** A ray and two spheres. */
typedef struct ShellsInput {
    Vec3 origin;    /**< Origin of the ray, outside both. */
    Vec3 direction; /**< Direction, of length 1 but for rounding. */
    Vec3 center;    /**< Centre of both. */
    real radii[2];  /**< Radius of the outer and of the inner sphere. */
} ShellsInput;

/** What the ray meets. */
typedef struct ShellsOutput {
    real in_order; /**< Surfaces met as they should be: outer, inner, inner, outer; 0 to 4. */
    real count;    /**< All hits, at most #SHELLS_HITS. */
} ShellsOutput;

/** Surfaces on the way. */
enum { SHELLS_SURFACES = 4 };
/** Hits after which a ray is given up. */
enum { SHELLS_HITS = 8 };

/** A hit. */
typedef struct ShellsHit {
    real distance; /**< #INFINITE: none. */
    int sphere;    /**< 0: the outer; 1: the inner. */
    Vec3 point;    /**< P. */
    Vec3 normal;   /**< N. */
} ShellsHit;

/** Moves a point to where the ray starts anew. @return The origin. */
typedef Vec3 ShellsOffset(const ShellsInput *in, const ShellsHit *hit);

/** @return The nearest hit beyond t_min, by the formula of Haines (see sphere.c). */
static ShellsHit shells_hit(const ShellsInput *in, Vec3 origin, real t_min) {
    ShellsHit hit = {.distance = INFINITE};
    Vec3 d = in->direction, f = vec3_subtract(origin, in->center);
    real a = vec3_dot(d, d), b = -vec3_dot(f, d);
    Vec3 l = vec3_add(f, vec3_scale(d, b / a));
    for (int i = 0; i < 2; i++) {
        real radius = in->radii[i], c = vec3_dot(f, f) - radius * radius;
        real root = real_sqrt(a * (radius * radius - vec3_dot(l, l)));
        real sum = b > 0 ? b + root : b - root;
        real near = b > 0 ? c / sum : sum / a, far = b > 0 ? sum / a : c / sum;
        real t = near > t_min ? near : far > t_min ? far : INFINITE;
        if (t < hit.distance) {
            hit.distance = t;
            hit.sphere = i;
        }
    }
    hit.point = vec3_add(origin, vec3_scale(d, hit.distance));
    hit.normal = vec3_normalize(vec3_subtract(hit.point, in->center));
    return hit;
}

/** @return What a ray meets. @param offset Where it starts anew. @param t_min Hits nearer than this
 *  are ignored, but for the first. */
static ShellsOutput shells_walk(const ShellsInput *in, ShellsOffset *offset, real t_min) {
    static const int expected[SHELLS_SURFACES] = {0, 1, 1, 0};
    ShellsOutput out = {0, 0};
    ShellsHit hit = shells_hit(in, in->origin, 0);
    for (int i = 0; i < SHELLS_HITS && hit.distance < INFINITE; i++) {
        int is_next = i < SHELLS_SURFACES && out.in_order == (real)i && hit.sphere == expected[i];
        out.in_order += (real)is_next;
        out.count += 1;
        hit = shells_hit(in, offset(in, &hit), t_min);
    }
    return out;
}

/** @return A point moved along the normal, to the side that the ray goes to. */
static Vec3 shells_along_normal(const ShellsInput *in, const ShellsHit *hit, real length) {
    real towards = vec3_dot(in->direction, hit->normal) > 0 ? length : -length;
    return vec3_add(hit->point, vec3_scale(hit->normal, towards));
}

/** Is a #ShellsOffset: none. */
static Vec3 shells_offset_none(const ShellsInput *in, const ShellsHit *hit) {
    (void)in;
    return hit->point;
}

/** No offset: the ray starts at P, which lies on either side of its surface as rounding has it. */
METHOD(shells_none, ShellsInput, ShellsOutput) {
    return shells_walk(in, shells_offset_none, 0);
}

/** Hits nearer than a constant are ignored, t > 1e-4: more than the two spheres are apart. */
METHOD(shells_tmin, ShellsInput, ShellsOutput) {
    return shells_walk(in, shells_offset_none, (scalar)1e-4f);
}

/** Is a #ShellsOffset: a constant. */
static Vec3 shells_offset_constant(const ShellsInput *in, const ShellsHit *hit) {
    return shells_along_normal(in, hit, (scalar)1e-4f);
}

/** A constant along the normal, P + sign(d.N) 1e-4 N: it jumps over the next surface. */
METHOD(shells_normal, ShellsInput, ShellsOutput) {
    return shells_walk(in, shells_offset_constant, 0);
}

/** @return A coordinate, moved by 256 of its ulps times the normal's component. */
static real shells_by_ulps(real coordinate, real normal) {
    const real ulps = 256 * 2 * ROUNDOFF, near_zero = (scalar)0.03125f;
    return real_abs(coordinate) < near_zero ? coordinate + normal / 65536
                                            : coordinate + real_abs(coordinate) * ulps * normal;
}

/** Is a #ShellsOffset: ulps of each coordinate. */
static Vec3 shells_offset_ulps(const ShellsInput *in, const ShellsHit *hit) {
    Vec3 n = hit->normal, p = hit->point;
    if (vec3_dot(in->direction, n) < 0) {
        n = vec3_scale(n, -1);
    }
    return (Vec3){shells_by_ulps(p.x, n.x), shells_by_ulps(p.y, n.y), shells_by_ulps(p.z, n.z)};
}

/** Each coordinate moved by 256 of its ulps (Wächter, Binder; see ray_offset.c). */
METHOD(shells_ulps, ShellsInput, ShellsOutput) {
    return shells_walk(in, shells_offset_ulps, 0);
}

/** Is a #ShellsOffset: a bound of the rounding error. */
static Vec3 shells_offset_bound(const ShellsInput *in, const ShellsHit *hit) {
    real bound = 32 * ROUNDOFF * (vec3_max_abs(hit->point) + in->radii[hit->sphere]);
    return shells_along_normal(in, hit, bound);
}

/** A bound of the rounding error, P + sign(d.N) 32 u (|P| + R) N. */
METHOD(shells_error_bound, ShellsInput, ShellsOutput) {
    return shells_walk(in, shells_offset_bound, 0);
}

const MethodFamily shells_family = {
    FAMILY("shells", ShellsInput, ShellsOutput),
    (const Method[]){{"no offset", "none", shells_none_run},
                     {"t > 1e-4", "t > 1e-4", shells_tmin_run},
                     {"1e-4 N", "1e-4 N", shells_normal_run},
                     {"256 ulps", "256 ulps", shells_ulps_run},
                     {"32 u (|P| + R) N", "bound", shells_error_bound_run},
                     {0}}};
