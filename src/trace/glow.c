/**
 * @file
 * @brief Lamps that are seen.
 */
#include "trace/glow.h"

#include "trace/shapes/registry.h"
#include "trace/shapes/sphere.h"

#include <stdlib.h>

/** @return How many balls a scene has. @param scene The scene. */
static size_t count_balls(const Scene *scene) {
    size_t count = 0;
    for (size_t i = 0; i < scene->light_count; i++) {
        count += light_is_ball(&scene->lights[i]);
    }
    return count;
}

/** @return Bytes from a ball to the next. */
static size_t ball_stride(void) {
    return (sphere_class.size + SHAPE_ALIGNMENT - 1) / SHAPE_ALIGNMENT * SHAPE_ALIGNMENT;
}

bool glow_init(Glow *glow, const Scene *scene, Error *error) {
    *glow = (Glow){.count = count_balls(scene)};
    if (glow->count == 0) {
        return true;
    }
    glow->balls = malloc(glow->count * sizeof *glow->balls);
    glow->colors = malloc(glow->count * sizeof *glow->colors);
    glow->memory = aligned_alloc(SHAPE_ALIGNMENT, glow->count * ball_stride());
    if (!glow->balls || !glow->colors || !glow->memory) {
        glow_release(glow);
        return error_set(error, STATUS_FAILED, "no memory for the lamps");
    }
    return true;
}

void glow_release(Glow *glow) {
    free(glow->balls);
    free(glow->colors);
    free(glow->memory);
    *glow = (Glow){0};
}

void glow_look(Glow *glow, const Scene *scene, Vector3 origin) {
    size_t ball = 0;
    for (size_t i = 0; i < scene->light_count && ball < glow->count; i++) {
        const Light *light = &scene->lights[i];
        if (light_is_ball(light)) {
            Shape *shape = (Shape *)((char *)glow->memory + ball * ball_stride());
            *shape = (Shape){.class = &sphere_class, .place = INT32_MAX};
            Vector3 center = vector3_subtract(light->position, origin);
            sphere_class.init(shape, &(SphereParameters){center, light->radius});
            glow->balls[ball] = shape;
            glow->colors[ball++] = light_strength(light);
        }
    }
}

/** What hits say of ball 0, in the place of a shape; less by one for each further ball. Below -1,
 *  so that it is no shape. */
enum { FIRST_BALL = -2 };

void glow_nearest(const Glow *glow, const Packet *packet, Hit *hits) {
    for (size_t i = 0; i < glow->count; i++) {
        for (int v = 0; v < PACKET_VECTORS; v++) {
            Hit *hit = &hits[v];
            mask nearer =
                sphere_class.is_hit(glow->balls[i], &packet->rays[v], packet->active[v], hit);
            hit->shape = integer_select(nearer, integer_of(FIRST_BALL - (int)i), hit->shape);
        }
    }
}

int glow_ball(int shape) {
    return shape <= FIRST_BALL ? FIRST_BALL - shape : -1;
}

void glow_show(const Glow *glow, const Hit *hits, Light3 *colors) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask left = hits[v].shape <= integer_of(FIRST_BALL);
        while (any(left)) {
            int ball = integer_lane(hits[v].shape, mask_first(left));
            mask same = left & (hits[v].shape == integer_of(ball));
            Light3 color = light3_of(glow->colors[FIRST_BALL - ball]);
            colors[v] = light3_select(same, color, colors[v]);
            left &= mask_not(same);
        }
    }
}
