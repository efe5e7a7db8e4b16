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
#include "lab/methods/leaving.h"

/** @return A coordinate, moved. @param at The coordinate. @param normal The normal's. */
static real moved(real at, real normal) {
    const real ulps = 256 * 2 * ROUNDOFF, near_zero = (scalar)0.03125f;
    return real_abs(at) < near_zero ? at + normal / 65536 : at + real_abs(at) * ulps * normal;
}

/** Asks it. See #Method.run. @param question A #LeavingQuestion. @param[out] answer A
 * #LeavingAnswer. */
static void run(const void *question, void *answer) {
    const LeavingQuestion *q = question;
    Leaving leaving = leaving_of(q);
    Vector n = leaving.normal;
    if (vector_dot(leaving.direction, n) < 0) {
        n = vector_scale(n, -1);
    }
    Vector p = leaving.point;
    Second second = {{moved(p.x, n.x), moved(p.y, n.y), moved(p.z, n.z)}, 0};
    *(LeavingAnswer *)answer = leaving_answer(q, &leaving, &second);
}

const Method leaving_ulps = {.family = "leaving",
                             .name = "256 ulps",
                             .label = "256 ulps",
                             .inputs = NUMBERS_OF(LeavingQuestion),
                             .outputs = NUMBERS_OF(LeavingAnswer),
                             .run = run};
