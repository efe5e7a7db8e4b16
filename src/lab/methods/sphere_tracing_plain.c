/**
 * @file
 * @brief Plain marching (Hart, *Sphere Tracing: A Geometric Method for the Antialiased Ray Tracing
 *        of Implicit Surfaces*, 1996), as in report B (row B1).
 *
 *   t = t + f(P0 + t d) until f < tolerance
 */
#include "lab/methods/sphere_tracing.h"

/** Asks it. See #Method.run. */
static void sphere_tracing_plain_run(const void *input, void *output) {
    const SphereTracingInput *in = input;
    SphereTracingOutput *out = output;
    *out = (SphereTracingOutput){.distance = INFINITE};
    real t = 0;
    for (int i = 1; i <= SPHERE_TRACING_STEPS; i++) {
        real height = sphere_tracing_height(in, t);
        if (height < in->tolerance) {
            *out = (SphereTracingOutput){t, (real)i};
            return;
        }
        t += height;
    }
}

const Method sphere_tracing_plain = {.group = "marching",
                                     .name = "plain",
                                     .label = "plain",
                                     .input_count = NUMBERS_IN(SphereTracingInput),
                                     .output_count = NUMBERS_IN(SphereTracingOutput),
                                     .run = sphere_tracing_plain_run};
