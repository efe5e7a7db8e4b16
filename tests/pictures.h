/**
 * @file
 * @brief Shared helpers for tests of pictures: loading a scene, rendering it, comparing.
 */
#ifndef DIOPTRE_PICTURES_H
#define DIOPTRE_PICTURES_H

#include "load_scene.h"
#include "testing.h"

#include "dioptre/renderer.h"
#include "dioptre/script.h"

#include <stdlib.h>
#include <time.h>

/** Size of the test pictures: not a multiple of any block. */
enum { WIDTH = 203, HEIGHT = 157 };

/** @return Settings for a small picture. */
static inline RenderSettings small_settings(const Scene *scene, const char *engine, int threads) {
    Error error = {0};
    RenderSettings settings = render_settings_default(scene);
    settings.engine = engine_find(engine, &error);
    assert_non_null(settings.engine);
    settings.threads = threads;
    settings.width = WIDTH;
    settings.height = HEIGHT;
    return settings;
}

/** @return A renderer. */
static inline Renderer *create_renderer(const Scene *scene, const RenderSettings *settings) {
    Error error = {0};
    Renderer *renderer = renderer_create(scene, settings, &error);
    if (!renderer) {
        fail_msg("%s", error.message);
    }
    return renderer;
}

/** @return A picture rendered in one call. */
static inline Picture draw_picture(const Scene *scene, const RenderSettings *settings) {
    Error error = {0};
    Picture picture;
    assert_true(picture_init(&picture, settings->width, settings->height, &error));
    Renderer *renderer = create_renderer(scene, settings);
    RenderStats report = renderer_render(renderer, NULL, &picture);
    assert_true(report.is_finished);
    renderer_destroy(renderer);
    return picture;
}

/** Fails unless two pictures are equal; frees the second. */
static inline void assert_same_picture(const Picture *a, Picture b) {
    PictureComparison comparison = picture_compare(a, &b, NULL);
    assert_int_equal(comparison.max_difference, 0);
    assert_memory_equal(a->pixels, b.pixels, 3 * (size_t)a->width * (size_t)a->height);
    picture_deinit(&b);
}

/**
 * Renders in the background until the picture is finished.
 * @param[out] passes  Number of different passes seen.
 * @return The picture.
 */
static inline Picture draw_in_background(Renderer *renderer, const Scene *scene, int *passes) {
    Error error = {0};
    RenderStats report = {0};
    const struct timespec pause = {.tv_nsec = 200000};
    uint8_t *bgrx = calloc(4, (size_t)WIDTH * HEIGHT);
    assert_true(renderer_start(renderer, scene, WIDTH, HEIGHT, NULL, NULL, &error));
    int last_stride = 0, last_samples = 0;
    *passes = 0;
    while (!report.is_finished) {
        if (renderer_copy_latest(renderer, &report, bgrx, 4 * WIDTH) &&
            (report.stride != last_stride || report.samples != last_samples)) {
            last_stride = report.stride;
            last_samples = report.samples;
            ++*passes;
        }
        nanosleep(&pause, NULL);
    }
    Picture picture;
    assert_true(picture_init(&picture, WIDTH, HEIGHT, &error));
    for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; i++) {
        for (size_t c = 0; c < 3; c++) {
            picture.pixels[3 * i + c] = bgrx[4 * i + 2 - c];
        }
    }
    free(bgrx);
    return picture;
}

#endif
