/**
 * @file
 * @brief The inside of a renderer, shared by its parts: at once, in the background, hits alone.
 */
#ifndef DIOPTRE_RENDER_RENDERER_INTERNAL_H
#define DIOPTRE_RENDER_RENDERER_INTERNAL_H

#include "render/render_pass.h"

#include <pthread.h>

/** What the thread in the background is told, and tells. */
typedef struct BackgroundRenderer {
    pthread_t thread;            /**< The thread; runs while #is_running. */
    bool is_running;             /**< Whether the thread was started. */
    pthread_mutex_t mutex;       /**< Guards all below but the back picture. */
    pthread_cond_t wake;         /**< Told when something is asked for. */
    pthread_cond_t idle;         /**< Told when the thread has stopped drawing. */
    bool is_requested;           /**< Whether a picture is asked for. */
    bool is_rendering;           /**< Whether the thread draws. */
    bool is_stopping;            /**< Whether the thread should end. */
    atomic_bool stop;            /**< Whether the drawing should stop. */
    int width;                   /**< Pixels of the picture asked for. */
    int height;                  /**< Pixels of the picture asked for. */
    RenderPassCallback callback; /**< Told after each pass; may be NULL. */
    void *context;               /**< Handed to it. */
    Picture back;                /**< The pass that is being drawn. */
    Picture front;               /**< The newest finished pass. */
    bool has_front;              /**< Whether there is one since the start. */
    RenderStats stats;           /**< How the front picture stands. */
} BackgroundRenderer;

/** What it takes to draw a layer of a picture instead of its light. */
typedef struct LayerRenderer {
    Layer layer;              /**< Which layer. */
    const Engine *reference;  /**< The engine that it is compared with; NULL: none. */
    Tracer *reference_tracer; /**< Its tracer; owned. */
    float *values;            /**< Numbers of each cell: #LAYER_VALUES; owned. */
    uint32_t *path_hashes;    /**< What the reference's rays meet at each, as one number; owned. */
    double *ranges;           /**< Least and greatest number of each block; owned. */
    size_t capacity;          /**< Pixels that there is room for. */
} LayerRenderer;

struct Renderer {
    RenderSettings settings;  /**< What was asked for. */
    Tracer *tracer;           /**< The engine's tracer; owned. */
    ThreadPool *thread_pool;  /**< The threads; owned. */
    Encoder encoder;          /**< From light to 8 bits. */
    atomic_size_t rays_done;  /**< Rays of pixels that are done. */
    atomic_size_t rays_total; /**< Rays of pixels that there are to do. */
    SampleAccumulator
        accumulator;              /**< What is known of every pixel; empty where nothing is kept. */
    LayerRenderer layer_renderer; /**< Drawing layers. */
    BackgroundRenderer background; /**< Drawing in the background. */
};

/** @return Whether a renderer's pixels are judged: whether calm ones get fewer samples. */
bool renderer_is_adaptive(const Renderer *renderer);

/** Makes the background part ready; no thread yet. */
void background_renderer_init(BackgroundRenderer *background);

/** Makes a finished pass the one that is shown. @param renderer The renderer, with the pass in its
 *  back picture. */
void background_renderer_publish(Renderer *renderer, const RenderStats *stats);

/**
 * Makes a layer ready to be drawn: its memory, and the tracer that it is compared with.
 * @param renderer  The renderer; its background part is idle.
 * @return false without memory.
 */
bool layer_renderer_prepare(Renderer *renderer, const Scene *scene, int width, int height,
                            Error *error);

/** Draws the layer asked for, pass by pass, until it is finished or stopped. */
void layer_renderer_render(Renderer *renderer);

/** Gives what layers need back. */
void layer_renderer_deinit(Renderer *renderer);

/** @return What a tracer is told. @param renderer Its renderer, with its workers. @param reuse_from
 *  Whose models it may share, or NULL. */
TraceSettings renderer_trace_settings(const Renderer *renderer, const Renderer *reuse_from);

/** @return A scene in the light that a renderer is asked for. What it points to is the scene's. */
Scene renderer_lit_scene(const Renderer *renderer, const Scene *scene);

/** Ends the background part. */
void background_renderer_deinit(BackgroundRenderer *background);

/** @return A drawing of a renderer, without pass. */
RenderPass renderer_make_pass(Renderer *renderer, int width, int height, const atomic_bool *stop);

#endif
