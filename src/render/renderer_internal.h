/**
 * @file
 * @brief The members of a renderer, shared by its source files.
 */
#ifndef DIOPTRE_RENDER_RENDERER_INTERNAL_H
#define DIOPTRE_RENDER_RENDERER_INTERNAL_H

#include "render/render_pass.h"

#include <pthread.h>

/** Rendering in the background: its thread, what is requested, and the two pictures. */
typedef struct BackgroundRenderer {
    pthread_t thread;            /**< The thread; valid while #is_running. */
    bool is_running;             /**< Whether the thread was started. */
    pthread_mutex_t mutex;       /**< Guards all below but the back picture. */
    pthread_cond_t wake;         /**< Signalled when a picture is requested, or the thread ends. */
    pthread_cond_t idle;         /**< Signalled when the thread has stopped rendering. */
    bool is_requested;           /**< Whether a picture is requested. */
    bool is_rendering;           /**< Whether the thread renders. */
    bool is_stopping;            /**< Whether the thread is to end. */
    atomic_bool stop;            /**< Whether rendering is to stop. */
    int width;                   /**< Pixels of the requested picture. */
    int height;                  /**< Pixels of the requested picture. */
    RenderPassCallback callback; /**< Called after each pass; may be NULL. */
    void *context;               /**< Argument of the callback. */
    Picture back;                /**< The pass under way. */
    Picture front;               /**< The newest finished pass, also of before the start. */
    bool has_front;              /**< Whether there is one since the start. */
    bool has_part;               /**< Whether tiles of the first pass are to be shown before. */
    RenderStats stats;           /**< The state of the picture that is shown. */
    atomic_bool *tiles;          /**< Which tiles of the first pass are in the back picture, which
                                      no thread writes to any more; owned. */
    _Atomic double next_part_time; /**< When tiles are shown next, on #clock_now_seconds. */
} BackgroundRenderer;

/** The data of a layer. */
typedef struct LayerRenderer {
    Layer layer;              /**< The layer. */
    const Engine *reference;  /**< The engine that it is compared with; NULL: none. */
    Tracer *reference_tracer; /**< Its tracer; owned. */
    float *values;            /**< #LAYER_VALUES numbers of each ray; owned. */
    float *front_values;      /**< Those of the newest finished pass; owned. */
    LayerMarks marks;         /**< The artefacts of the pass under way. */
    LayerMarks front_marks;   /**< Those of the newest finished pass. */
    uint32_t *path_hashes;    /**< Path hash of the reference's rays; owned. */
    double *ranges;           /**< Least and greatest number of each tile; owned. */
    size_t capacity;          /**< Pixels that the arrays have room for. */
} LayerRenderer;

struct Renderer {
    RenderSettings settings;       /**< The settings. */
    Tracer *tracer;                /**< The engine's tracer; owned. */
    ThreadPool *thread_pool;       /**< The threads; owned. */
    Encoder encoder;               /**< From linear light to 8 bits. */
    atomic_size_t rays_done;       /**< Rays of pixels that are done. */
    atomic_size_t rays_total;      /**< Rays of pixels in all passes. */
    atomic_size_t tiles_done;      /**< Tiles of the pass under way that are done. */
    atomic_size_t tiles_total;     /**< Its tiles; 0: no pass has begun. */
    _Atomic double pass_start;     /**< Its begin, on #clock_now_seconds. */
    SampleAccumulator accumulator; /**< Sums over passes; empty where a single pass is enough. */
    LayerRenderer layer_renderer;  /**< The data of the layer. */
    BackgroundRenderer background; /**< Rendering in the background. */
};

/** @return Whether a renderer samples adaptively: calm pixels get fewer samples. */
bool renderer_is_adaptive(const Renderer *renderer);

/** Initialises the background part; its thread is not started. */
void background_renderer_init(BackgroundRenderer *background);

/** Ends the thread and frees the background part. */
void background_renderer_deinit(BackgroundRenderer *background);

/**
 * Prepares a layer: its memory, and the tracer that it is compared with.
 * @param renderer  The renderer; its background part is idle.
 * @return false without memory.
 */
bool layer_renderer_prepare(Renderer *renderer, const Scene *scene, int width, int height,
                            Error *error);

/** Makes the numbers and marks of a finished pass those that are shown. */
void layer_renderer_publish(Renderer *renderer, int width, int height);

/** Frees the data of layers. */
void layer_renderer_deinit(Renderer *renderer);

/** The passes of a layer. */
typedef struct LayerPasses {
    int samples;                   /**< Passes at full resolution. */
    bool has_preview;              /**< Whether a preview comes first. */
    bool (*run)(RenderPass *pass); /**< Renders a pass; false when it was stopped. */
} LayerPasses;

/** @return The passes of a renderer's layer; the shaded picture is one of them. */
LayerPasses layer_passes(const Renderer *renderer);

/** @return The settings of a renderer's tracer. @param reuse_from A renderer whose mesh BVHs may be
 *  shared, or NULL. */
TraceSettings renderer_trace_settings(const Renderer *renderer, const Renderer *reuse_from);

/** @return A scene in the lighting mode of a renderer. Its pointers are the scene's. */
Scene renderer_lit_scene(const Renderer *renderer, const Scene *scene);

/** @return A pass of a renderer, without range, of the shaded picture. */
RenderPass renderer_make_pass(Renderer *renderer, int width, int height, const atomic_bool *stop);

#endif
