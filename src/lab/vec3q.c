/**
 * @file
 * @brief Points and directions in quad precision.
 */
#include "lab/vec3q.h"

#include <math.h>

Quadruple quad_sqrt(Quadruple x) {
    if (!(x > 0)) {
        return x == 0 ? 0 : (Quadruple)NAN;
    }
    // Newton's method from a root of 53 bits: twice as many correct ones each time.
    Quadruple root = (Quadruple)sqrt((double)x);
    if (!(root > 0)) {
        root = x; // Too small for double: many more steps, but they get there.
    }
    for (int i = 0; i < 3; i++) {
        root = (root + x / root) / 2;
    }
    return root;
}

#if defined(__SIZEOF_FLOAT128__)
/** The angle of a point, from the C library. @return It. */
extern Quadruple atan2f128(Quadruple y, Quadruple x);
#else
/** The same in what is quad here. */
#define atan2f128 atan2l
#endif

Quadruple quad_atan2(Quadruple y, Quadruple x) {
    return atan2f128(y, x);
}
