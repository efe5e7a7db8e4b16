/**
 * @file
 * @brief Pseudo-random numbers from sums, products and square roots only, which are the same on
 * every machine.
 */
#include "lab/random.h"

#include <math.h>

uint64_t random_bits(Random *random) {
    uint64_t z = random->state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

double random_unit(Random *random) {
    return (double)(random_bits(random) >> 11) * 0x1p-53;
}

double random_range(Random *random, double low, double high) {
    return low + (high - low) * random_unit(random);
}

Vec3q random_direction(Random *random) {
    for (;;) {
        double x = random_range(random, -1, 1), y = random_range(random, -1, 1);
        double z = random_range(random, -1, 1), length_squared = x * x + y * y + z * z;
        if (length_squared <= 1 && length_squared > 1e-6) {
            return vec3q_normalize((Vec3q){x, y, z});
        }
    }
}

Vec3q random_in_disc(Random *random, Vec3q axis, double radius) {
    // The part of a random direction across the axis is uniform in angle.
    Vec3q other = random_direction(random);
    Vec3q first = vec3q_normalize(vec3q_subtract(other, vec3q_scale(axis, vec3q_dot(axis, other))));
    return vec3q_scale(first, radius * sqrt(random_unit(random)));
}
