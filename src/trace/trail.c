/**
 * @file
 * @brief What is noted of a ray's way.
 */
#include "trace/trail.h"

/** Steps that a component of a normal, or a share of light, is told apart in; the two together with
 *  #COARSE_SHIFT put no step where scenes have their normals. */
#define COARSE_STEPS 3.71
/** Where the steps begin. */
#define COARSE_SHIFT 4.63

/** @return A number in few steps: roundings hardly ever change it, an edge does. @param x It, from
 *  -1 to 1. */
static uint64_t coarse(scalar x) {
    double place = (double)x * COARSE_STEPS + COARSE_SHIFT;
    return place > 0 && place < 16 ? (uint64_t)place : 15;
}

/** Goes on with a trail. @param[in,out] trail The trail. @param note What is noted. */
static void trail_add(uint64_t *trail, uint64_t note) {
    // Steele, Lea, Flood, Fast Splittable Pseudorandom Number Generators, 2014: splitmix64.
    uint64_t z = (*trail + note + 1) * 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    *trail = z ^ (z >> 31);
}

/** @return Three numbers in few steps each. @param x One. @param y One. @param z One.
 *  @param i The lane. */
static uint64_t coarse_lanes(real x, real y, real z, int i) {
    return coarse(real_lane(x, i)) << 8 | coarse(real_lane(y, i)) << 4 | coarse(real_lane(z, i));
}

void trail_surfaces(const Encounter *met) {
    const Lineage *lineage = &met->packet->lineage;
    for (int i = 0; i < PACKET_RAYS; i++) {
        const Vector *normal = &met->facing[i / LANES];
        int lane = i % LANES;
        if (!mask_lane(met->packet->active[i / LANES], lane)) {
            continue;
        }
        uint64_t note = (uint64_t)lineage->bounce << 48;
        if (mask_lane(met->met[i / LANES], lane)) {
            uint64_t shape = (uint64_t)integer_lane(met->hits[i / LANES].shape, lane) + 1;
            note |= shape << 12 | coarse_lanes(normal->x, normal->y, normal->z, lane);
        }
        trail_add(&lineage->notes->trails[i], note);
    }
}

void trail_shadows(const Encounter *met, const Packet *shadow, const mask *blocked,
                   const Light3 *visible) {
    for (int i = 0; i < PACKET_RAYS; i++) {
        int v = i / LANES, lane = i % LANES;
        if (!mask_lane(shadow->active[v], lane)) {
            continue;
        }
        bool is_dark = mask_lane(blocked[v], lane);
        uint64_t note = is_dark ? UINT64_C(1) << 40 : UINT64_C(1) << 41;
        if (!is_dark && visible) {
            note |= coarse_lanes(visible[v].red, visible[v].green, visible[v].blue, lane);
        }
        trail_add(&met->packet->lineage.notes->trails[i], note);
    }
}
