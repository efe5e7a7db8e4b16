/**
 * @file
 * @brief Leaving a surface: each coordinate moved by a number of its own ulps (Wächter, Binder, *A
 *        Fast and Robust Method for Avoiding Self-Intersection*, Ray Tracing Gems 6).
 *
 *   256 ulps times the normal's coordinate, but near zero N / 65536
 *
 * Written for all number types here, without the original's trick on the bits of a float. Near the
 * origin the shift is a constant again, and larger than a sphere of a millionth.
 */
#include "lab/methods/ray_offset.h"

/** @return A coordinate, moved. */
static real ray_offset_by_ulps(real plane, real normal) {
    const real ulps = 256 * 2 * ROUNDOFF, near_zero = (scalar)0.03125f;
    return real_abs(plane) < near_zero ? plane + normal / 65536
                                       : plane + real_abs(plane) * ulps * normal;
}

/** Asks it. See #Method.run. */
static void ray_offset_ulps_run(const void *input, void *output) {
    const RayOffsetInput *in = input;
    RayOffsetHit hit = ray_offset_hit(in);
    Vec3 n = hit.normal;
    if (vec3_dot(hit.outgoing, n) < 0) {
        n = vec3_scale(n, -1);
    }
    Vec3 p = hit.point;
    RayOffsetStart start = {
        {ray_offset_by_ulps(p.x, n.x), ray_offset_by_ulps(p.y, n.y), ray_offset_by_ulps(p.z, n.z)},
        0};
    *(RayOffsetOutput *)output = ray_offset_output_of(in, &hit, &start);
}

const Method ray_offset_ulps = {.group = "leaving",
                                .name = "256 ulps",
                                .label = "256 ulps",
                                .input_count = NUMBERS_IN(RayOffsetInput),
                                .output_count = NUMBERS_IN(RayOffsetOutput),
                                .run = ray_offset_ulps_run};
