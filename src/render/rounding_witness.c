/**
 * @file
 * @brief Tracing while the processor rounds in another direction.
 */
#include "render/rounding_witness.h"

#include <fenv.h>

/** The names of the directions in C. */
static const int fenv_directions[ROUNDING_DIRECTION_COUNT] = {
    [ROUNDING_NEAREST] = FE_TONEAREST,
    [ROUNDING_UPWARD] = FE_UPWARD,
    [ROUNDING_DOWNWARD] = FE_DOWNWARD,
    [ROUNDING_TOWARD_ZERO] = FE_TOWARDZERO,
};

bool rounding_is_supported(void) {
    int before = fegetround();
    bool is_supported = before >= 0;
    for (int i = 0; is_supported && i < ROUNDING_DIRECTION_COUNT; i++) {
        is_supported = fesetround(fenv_directions[i]) == 0;
    }
    return fesetround(before) == 0 && is_supported;
}

bool trace_rounded(const Engine *engine, RoundingDirection direction, const Tracer *tracer,
                   const PixelGrid *grid, double *rgb, RayCounts *counts) {
    int before = fegetround();
    if (before < 0 || fesetround(fenv_directions[direction]) != 0) {
        return false;
    }
    engine->trace(tracer, grid, rgb, counts); // It always returns here: engines do not jump.
    fesetround(before);
    return true;
}
