/**
 * @file
 * @brief The direction of rounding: WebAssembly rounds to the nearest number, always.
 *
 * musl's own says that it has changed the direction, and the layer of rounding that no number hangs
 * on its last bits.
 */
#include <fenv.h>

/** @return The direction in which numbers are rounded. */
int fegetround(void) {
    return FE_TONEAREST;
}

/** Chooses a direction. @return 0 if numbers are rounded so. */
int fesetround(int direction) {
    return direction == FE_TONEAREST ? 0 : -1;
}
