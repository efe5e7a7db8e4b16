/**
 * @file
 * @brief Numbers that look random: sums, products and square roots only, so that they are the same
 *        on every machine.
 */
#include "lab/random.h"

#include <math.h>

uint64_t random_bits(Random *random) {
    uint64_t z = random->state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

double random_share(Random *random) {
    return (double)(random_bits(random) >> 11) * 0x1p-53;
}

double random_between(Random *random, double low, double high) {
    return low + (high - low) * random_share(random);
}

Quad3 random_direction(Random *random) {
    for (;;) {
        double x = random_between(random, -1, 1), y = random_between(random, -1, 1);
        double z = random_between(random, -1, 1), length_squared = x * x + y * y + z * z;
        if (length_squared <= 1 && length_squared > 1e-6) {
            return quad3_normalize((Quad3){x, y, z});
        }
    }
}

Quad3 random_across(Random *random, Quad3 axis, double radius) {
    // What another direction has across this one: no way round is preferred.
    Quad3 other = random_direction(random);
    Quad3 first = quad3_normalize(quad3_subtract(other, quad3_scale(axis, quad3_dot(axis, other))));
    return quad3_scale(first, radius * sqrt(random_share(random)));
}
