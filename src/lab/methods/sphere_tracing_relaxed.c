/**
 * @file
 * @brief Marching with longer steps (Keinert and others, *Enhanced Sphere Tracing*, 2014): the
 *        tracer's way.
 *
 *   t = t + w f, w = 1.6, taken back where the balls around two points in turn do not touch
 */
#include "lab/methods/sphere_tracing.h"

/** Asks it. See #Method.run. */
static void sphere_tracing_relaxed_run(const void *input, void *output) {
    const SphereTracingInput *in = input;
    const real longer = (scalar)1.6f;
    SphereTracingOutput *out = output;
    *out = (SphereTracingOutput){.distance = INFINITE};
    real t = 0, previous = 0, step = 0, factor = longer;
    for (int i = 1; i <= SPHERE_TRACING_STEPS; i++) {
        real height = sphere_tracing_height(in, t);
        if (factor > 1 && previous + real_abs(height) < step) {
            // Something may lie between the two balls: back to the end of the safe step.
            t += previous - step;
            factor = 1;
            step = previous;
            continue;
        }
        if (height < in->tolerance) {
            *out = (SphereTracingOutput){t, (real)i};
            return;
        }
        step = factor * height;
        previous = height;
        t += step;
    }
}

const Method sphere_tracing_relaxed = {.group = "marching",
                                       .name = "relaxed",
                                       .label = "relaxed",
                                       .input_count = NUMBERS_IN(SphereTracingInput),
                                       .output_count = NUMBERS_IN(SphereTracingOutput),
                                       .run = sphere_tracing_relaxed_run};
