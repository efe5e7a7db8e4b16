/**
 * @file
 * @brief Vectors in quad precision.
 */
#include "lab/vec3q.h"

#include <math.h>

Quadruple quad_sqrt(Quadruple x) {
    if (!(x > 0)) {
        return x == 0 ? 0 : (Quadruple)NAN;
    }
    // Newton's method from a root of 53 bits: each step doubles the correct bits.
    Quadruple root = (Quadruple)sqrt((double)x);
    if (!(root > 0)) {
        root = x; // Below the range of double: converges more slowly.
    }
    for (int i = 0; i < 3; i++) {
        root = (root + x / root) / 2;
    }
    return root;
}

#if defined(__SIZEOF_FLOAT128__)
/** @return The angle of a point, from the C library. */
extern Quadruple atan2f128(Quadruple y, Quadruple x);
#else
/** Long double is quad on this machine. */
#define atan2f128 atan2l
#endif

Quadruple quad_atan2(Quadruple y, Quadruple x) {
    return atan2f128(y, x);
}
