/**
 * @file
 * @brief A closed cylinder as three parts: a wall between two heights and two disks (row D1).
 *
 * Each part decides by its own rounded point whether it is met: at the rim all may say no, and the
 * ray leaks, or two say yes.
 */
#include "lab/methods/cylinder.h"

/** Takes a meeting. @param found The answer. @param is_met Whether there is one. @param distance
 *  How far. */
static void take(CylinderAnswer *found, int is_met, real distance) {
    if (is_met && distance > 0) {
        found->count += 1;
        found->distance = real_min(distance, found->distance);
    }
}

/** Asks one end. @param q The question. @param height Of the end above the base. @param found The
 *  answer. */
static void meet_end(const CylinderQuestion *q, real height, CylinderAnswer *found) {
    real t = (q->base.y + height - q->origin.y) / q->direction.y;
    Vector point = vector_add(q->origin, vector_scale(q->direction, t));
    real x = point.x - q->base.x, z = point.z - q->base.z;
    take(found, x * x + z * z <= q->radius * q->radius, t);
}

/** Asks the wall. @param q The question. @param t How far a root is. @param found The answer. */
static void meet_wall(const CylinderQuestion *q, real t, CylinderAnswer *found) {
    real y = q->origin.y + q->direction.y * t - q->base.y;
    take(found, y >= 0 && y <= q->height, t);
}

/** Asks it. See #Method.run. @param question A #CylinderQuestion. @param[out] answer A
 * #CylinderAnswer. */
static void run(const void *question, void *answer) {
    const CylinderQuestion *q = question;
    CylinderAnswer *found = answer;
    *found = (CylinderAnswer){.distance = INFINITE};
    real x = q->origin.x - q->base.x, z = q->origin.z - q->base.z;
    real dx = q->direction.x, dz = q->direction.z;
    real a = dx * dx + dz * dz, b = x * dx + z * dz, c = x * x + z * z - q->radius * q->radius;
    real root = real_sqrt(b * b - a * c);
    meet_wall(q, (-b - root) / a, found);
    meet_wall(q, (-b + root) / a, found);
    meet_end(q, 0, found);
    meet_end(q, q->height, found);
}

const Method cylinder_solid_parts = {.family = "cylinder-solid",
                                     .name = "three parts",
                                     .label = "three parts",
                                     .inputs = NUMBERS_OF(CylinderQuestion),
                                     .outputs = NUMBERS_OF(CylinderAnswer),
                                     .run = run};
