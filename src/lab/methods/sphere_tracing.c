/**
 * @file
 * @brief How many steps does sphere tracing take down to a plane?
 *
 * The field f is y: the distance to the plane y = 0. P0 is the ray's origin, d its direction.
 */
#include "lab/methods/family.h"

/** A ray above the plane. */
typedef struct SphereTracingInput {
    Vec3 origin;    /**< P0. */
    Vec3 direction; /**< d, of length 1 but for rounding. */
    real tolerance; /**< Distance below which a point is on the surface. */
} SphereTracingInput;

/** Where it stops. */
typedef struct SphereTracingOutput {
    real distance; /**< Along the ray; #INFINITE: the step limit was reached. */
    real steps;    /**< Evaluations of f. */
} SphereTracingOutput;

/** Step limit of a ray. */
enum { SPHERE_TRACING_STEPS = 100000 };

/** @return f(P0 + t d). */
static real sphere_tracing_height(const SphereTracingInput *in, real t) {
    return in->origin.y + in->direction.y * t;
}

/**
 * Plain sphere tracing (Hart, *Sphere Tracing: A Geometric Method for the Antialiased Ray Tracing
 * of Implicit Surfaces*, 1996), as in report B (doc/reports.md).
 *
 *   t = t + f(P0 + t d) until f < tolerance
 */
METHOD(sphere_tracing_plain, SphereTracingInput, SphereTracingOutput) {
    real t = 0;
    for (int i = 1; i <= SPHERE_TRACING_STEPS; i++) {
        real height = sphere_tracing_height(in, t);
        if (height < in->tolerance) {
            return (SphereTracingOutput){t, (real)i};
        }
        t += height;
    }
    return (SphereTracingOutput){.distance = INFINITE};
}

/**
 * Over-relaxation (Keinert and others, *Enhanced Sphere Tracing*, 2014), as in the tracer.
 *
 *   t = t + w f with w = 1.6, undone where the spheres around two successive points do not touch
 */
METHOD(sphere_tracing_relaxed, SphereTracingInput, SphereTracingOutput) {
    const real relaxation = (scalar)1.6f;
    real t = 0, previous = 0, step = 0, factor = relaxation;
    for (int i = 1; i <= SPHERE_TRACING_STEPS; i++) {
        real height = sphere_tracing_height(in, t);
        if (factor > 1 && previous + real_abs(height) < step) {
            // A surface may lie between the two spheres: return to the end of the safe step.
            t += previous - step;
            factor = 1;
            step = previous;
            continue;
        }
        if (height < in->tolerance) {
            return (SphereTracingOutput){t, (real)i};
        }
        step = factor * height;
        previous = height;
        t += step;
    }
    return (SphereTracingOutput){.distance = INFINITE};
}

const MethodFamily sphere_tracing_family = {
    FAMILY("marching", SphereTracingInput, SphereTracingOutput),
    (const Method[]){{"plain", "plain", sphere_tracing_plain_run},
                     {"relaxed", "relaxed", sphere_tracing_relaxed_run},
                     {0}}};
