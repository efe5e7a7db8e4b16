/**
 * @file
 * @brief Lamps that are seen.
 */
#include "trace/lights/emitter_spheres.h"

#include "trace/shapes/shape.h"

#include <stdlib.h>

/** @return How many balls a scene has. */
static size_t count_emitters(const Scene *scene) {
    size_t count = 0;
    for (size_t i = 0; i < scene->light_count; i++) {
        count += scene_light_is_spherical(&scene->lights[i]);
    }
    return count;
}

/** @return Bytes from a ball to the next. */
static size_t sphere_stride(void) {
    return (sphere_class.size + SHAPE_ALIGNMENT - 1) / SHAPE_ALIGNMENT * SHAPE_ALIGNMENT;
}

bool emitter_spheres_init(EmitterSpheres *emitters, const Scene *scene, Error *error) {
    *emitters = (EmitterSpheres){.count = count_emitters(scene)};
    if (emitters->count == 0) {
        return true;
    }
    emitters->spheres = malloc(emitters->count * sizeof *emitters->spheres);
    emitters->colors = malloc(emitters->count * sizeof *emitters->colors);
    emitters->memory = aligned_alloc(SHAPE_ALIGNMENT, emitters->count * sphere_stride());
    if (!emitters->spheres || !emitters->colors || !emitters->memory) {
        emitter_spheres_deinit(emitters);
        return error_set(error, STATUS_FAILED, "no memory for the lamps");
    }
    return true;
}

void emitter_spheres_deinit(EmitterSpheres *emitters) {
    free(emitters->spheres);
    free(emitters->colors);
    free(emitters->memory);
    *emitters = (EmitterSpheres){0};
}

void emitter_spheres_set(EmitterSpheres *emitters, const Scene *scene, Vec3d origin) {
    size_t sphere = 0;
    for (size_t i = 0; i < scene->light_count && sphere < emitters->count; i++) {
        const SceneLight *light = &scene->lights[i];
        if (scene_light_is_spherical(light)) {
            Shape *shape = (Shape *)((char *)emitters->memory + sphere * sphere_stride());
            *shape = (Shape){.class = &sphere_class, .index = INT32_MAX};
            Vec3d center = vec3d_subtract(light->position, origin);
            sphere_class.init(shape, &(SphereParameters){center, light->radius});
            emitters->spheres[sphere] = shape;
            emitters->colors[sphere++] = scene_light_rgb(light);
        }
    }
}

/** What hits say of ball 0, in the place of a shape; less by one for each further ball. Below -1,
 *  so that it is no shape. */
enum { FIRST_EMITTER_ID = -2 };

void emitter_spheres_closest_hits(const EmitterSpheres *emitters, const Packet *packet, Hit *hits) {
    for (size_t i = 0; i < emitters->count; i++) {
        for (int v = 0; v < PACKET_VECTORS; v++) {
            Hit *hit = &hits[v];
            mask nearer =
                sphere_class.is_hit(emitters->spheres[i], &packet->rays[v], packet->active[v], hit);
            hit->shape = integer_select(nearer, integer_of(FIRST_EMITTER_ID - (int)i), hit->shape);
        }
    }
}

int emitter_sphere_index(int shape) {
    return shape <= FIRST_EMITTER_ID ? FIRST_EMITTER_ID - shape : -1;
}

void emitter_spheres_shade(const EmitterSpheres *emitters, const Hit *hits, Rgb *colors) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask remaining = hits[v].shape <= integer_of(FIRST_EMITTER_ID);
        while (any(remaining)) {
            int sphere = integer_lane(hits[v].shape, mask_first(remaining));
            mask same = remaining & (hits[v].shape == integer_of(sphere));
            Rgb color = rgb_splat(emitters->colors[FIRST_EMITTER_ID - sphere]);
            colors[v] = rgb_select(same, color, colors[v]);
            remaining &= mask_not(same);
        }
    }
}
