/**
 * @file
 * @brief Lights that are seen.
 */
#include "trace/lights/emitters.h"

#include <stdlib.h>

bool emitters_init(Emitters *emitters, const Scene *scene, Error *error) {
    *emitters = (Emitters){.stride = SHAPE_ALIGNMENT};
    if (scene->light_count == 0) {
        return true;
    }
    for (size_t i = 0; i < scene->light_count; i++) {
        const ShapeClass *shape = light_class_of(&scene->lights[i])->emitter;
        while (shape && emitters->stride < shape->size) {
            emitters->stride += SHAPE_ALIGNMENT;
        }
    }
    emitters->items = malloc(scene->light_count * sizeof *emitters->items);
    emitters->memory = aligned_alloc(SHAPE_ALIGNMENT, scene->light_count * emitters->stride);
    if (!emitters->items || !emitters->memory) {
        emitters_deinit(emitters);
        return error_set(error, STATUS_FAILED, "no memory for the lamps");
    }
    return true;
}

void emitters_deinit(Emitters *emitters) {
    free(emitters->items);
    free(emitters->memory);
    *emitters = (Emitters){0};
}

void emitters_set(Emitters *emitters, const Scene *scene, const Light *lights, size_t light_count,
                  Vec3d origin) {
    emitters->count = 0;
    for (size_t i = 0; i < light_count; i++) {
        if (lights[i].is_visible) {
            const LightClass *class = lights[i].class;
            Shape *shape = (Shape *)(emitters->memory + emitters->count * emitters->stride);
            SceneLight moved = scene->lights[i];
            keyword_translate(scene_light_keyword_for(&moved), &moved, vec3d_scale(origin, -1));
            // At the same distance a shape of the scene is nearer.
            *shape = (Shape){.class = class->emitter, .index = INT32_MAX};
            class->emitter_init(shape, &moved);
            emitters->items[emitters->count++] = (Emitter){&lights[i], (int)i, shape};
        }
    }
}

/** #Hit.shape of the emitter of light 0; less by one for each further light. */
enum { FIRST_EMITTER_ID = -2 };

void emitters_closest_hits(const Emitters *emitters, const Packet *packet, Hit *hits) {
    for (size_t i = 0; i < emitters->count; i++) {
        const Emitter *emitter = &emitters->items[i];
        const LightClass *class = emitter->light->class;
        integer id = integer_of(FIRST_EMITTER_ID - emitter->light_index);
        for (int v = 0; v < packet_vector_count(packet); v++) {
            const Ray *ray = &packet->rays[v];
            mask active = packet->active[v];
            if (class->visible_from) {
                active &= class->visible_from(emitter->light, ray);
            }
            mask nearer = emitter->shape->class->is_hit(emitter->shape, ray, active, &hits[v]);
            hits[v].shape = integer_select(nearer, id, hits[v].shape);
        }
    }
}

int emitter_light_index(int shape) {
    return shape <= FIRST_EMITTER_ID ? FIRST_EMITTER_ID - shape : -1;
}

void emitters_shade(const Light *lights, const Packet *packet, const Hit *hits, Rgb *colors) {
    for (int v = 0; v < packet_vector_count(packet); v++) {
        mask remaining = hits[v].shape <= integer_of(FIRST_EMITTER_ID);
        while (any(remaining)) {
            int shape = integer_lane(hits[v].shape, mask_first(remaining));
            mask same = remaining & (hits[v].shape == integer_of(shape));
            const Light *light = &lights[emitter_light_index(shape)];
            colors[v] = rgb_select(same, light->radiance, colors[v]);
            remaining &= mask_not(same);
        }
    }
}
