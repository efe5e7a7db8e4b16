/**
 * @file
 * @brief Shots: some pixels of a scene, traced in one manner, with every ray's colour and trail.
 */
#ifndef DIOPTRE_LAB_NEEDS_SAMPLED_RENDER_H
#define DIOPTRE_LAB_NEEDS_SAMPLED_RENDER_H

#include "lab/needs/pixel_set.h"

#include <stdatomic.h>

/** How pixels are traced. */
typedef struct Variant {
    const Engine *engine; /**< With which engine. */
    TraceSettings trace;  /**< With which settings; its samples are the picture's. */
    int samples_traced;   /**< How many of the samples of each pixel are traced. */
    double shift_right;   /**< By how much the camera is turned to the right, pixels. */
    double shift_up;      /**< By how much it is turned up, pixels. */
} Variant;

/** What a scene looked like. */
typedef struct SampledRender {
    size_t ray_count;      /**< Rays: pixels times samples. */
    double *rgb;           /**< Linear light of each, three numbers; sample after sample; owned. */
    uint64_t *path_hashes; /**< The trail of each; owned. */
    double cpu_seconds;    /**< The processor's time for tracing, of all threads. */
    RayCounts ray_counts;  /**< Rays traced in all. */
} SampledRender;

/** What is shot, and by whom. */
typedef struct RenderContext {
    const Scene *scene;      /**< The scene. */
    const PixelSet *pixels;  /**< Of the picture. */
    int threads;             /**< How many trace. */
    const atomic_bool *stop; /**< A shot is given up once it is true; may be NULL. */
} RenderContext;

/**
 * Traces.
 * @param[out] render  The shot, to be given back with #sampled_render_deinit.
 * @param[out] error  What is wrong; #STATUS_INTERRUPTED where it was stopped.
 * @return false if anything is.
 */
bool render_samples(const RenderContext *render_context, const Variant *variant,
                    SampledRender *render, Error *error);

/** Gives a shot back. @param render The shot; may be empty. */
void sampled_render_deinit(SampledRender *render);

#endif
