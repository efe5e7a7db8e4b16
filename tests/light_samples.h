/**
 * @file
 * @brief Shared helpers for tests of lights: adding them, and measuring their irradiance at a
 *        point.
 */
#ifndef DIOPTRE_LIGHT_SAMPLES_H
#define DIOPTRE_LIGHT_SAMPLES_H

#include "pictures.h"

/** @return A light with the defaults of its keyword. */
static inline SceneLight light_of_kind(const char *name) {
    size_t i = 0;
    while (scene_light_classes[i] && strcmp(scene_light_classes[i]->keyword->name, name) != 0) {
        i++;
    }
    assert_non_null(scene_light_classes[i]);
    SceneLight light = *(const SceneLight *)scene_light_classes[i]->keyword->defaults;
    light.class_index = i;
    return light;
}

/** Adds a light to a scene. */
static inline void add_light(Scene *scene, SceneLight light) {
    Error error = {0};
    assert_true(scene_add_light(scene, &light, &error));
}

/** Points a scene's camera, with so narrow a field of view that all rays hit the same point. */
static inline void aim_camera(Scene *scene, Vec3d from, Vec3d to) {
    Error error = {0};
    SceneCamera camera = *(const SceneCamera *)scene_camera_keyword.defaults;
    camera.position = from;
    camera.look_at = to;
    camera.fov = 0.01;
    assert_true(scene_camera_keyword.finish(&camera, 3, &error));
    scene->camera = camera;
}

/** Statistics of many pixels and samples of one point. */
typedef struct LightStatistics {
    double mean; /**< Mean of the pixels. */
    double rms;  /**< RMS of their differences from the expected value. */
} LightStatistics;

/** Pixels per side of a picture of the point. */
enum { PIXELS = 16 };

/** @return Statistics of a soft light at one point. */
static inline LightStatistics sample_soft_light(const Engine *engine, const Scene *scene,
                                                int samples, double truth) {
    double sums[PIXELS * PIXELS] = {0}, rgb[3 * PIXELS * PIXELS];
    Error error = {0};
    RayCounts counts = {0};
    TraceSettings settings = {.samples = samples, .offset = OFFSET_BOUND};
    Tracer *tracer = engine->create_tracer(scene, &settings, &error);
    assert_non_null(tracer);
    engine->set_view(tracer, scene, PIXELS, PIXELS);
    PixelGrid grid = {.columns = PIXELS, .rows = PIXELS, .stride = 1};
    for (grid.sample = 0; grid.sample < samples; grid.sample++) {
        engine->trace(tracer, &grid, rgb, &counts);
        for (int i = 0; i < PIXELS * PIXELS; i++) {
            sums[i] += rgb[i] / samples;
        }
    }
    LightStatistics spread = {0};
    for (int i = 0; i < PIXELS * PIXELS; i++) {
        spread.mean += sums[i] / (PIXELS * PIXELS);
        spread.rms += (sums[i] - truth) * (sums[i] - truth) / (PIXELS * PIXELS);
    }
    spread.rms = sqrt(spread.rms);
    engine->destroy(tracer);
    return spread;
}

#endif
