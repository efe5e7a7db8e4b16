/**
 * @file
 * @brief How a picture comes about: threads, blocks, passes.
 *
 * A renderer owns worker threads and a tracer. It draws in passes, coarse blocks first where that
 * is wanted, then every pixel, then sample after sample. It draws either at once (#renderer_render)
 * or in the background (#renderer_start), with the same bits in the end.
 */
#ifndef DIOPTRE_RENDERER_H
#define DIOPTRE_RENDERER_H

#include "dioptre/engine.h"
#include "dioptre/layer.h"
#include "dioptre/picture.h"

#include <stdatomic.h>

/** Largest number of threads that may be asked for. */
enum { THREADS_MAXIMUM = 1024 };

/** Whether every pixel gets all samples. */
typedef enum {
    SAMPLING_ADAPTIVE, /**< Where few are enough, a pixel gets few: the default. */
    SAMPLING_FULL      /**< Every one gets all. */
} Sampling;

/** Which light there is (row D4). */
typedef enum {
    LIGHTING_FULL,       /**< The lamps, and light from everywhere: the scene's own, the default. */
    LIGHTING_NO_AMBIENT, /**< The lamps alone. */
    LIGHTING_UNLIT,      /**< None: things show their own colours, as if cut from paper. */
    LIGHTING_MODE_COUNT  /**< How many there are. */
} LightingMode;

/** What is asked of a renderer besides the scene. */
typedef struct RenderSettings {
    const Engine *engine;  /**< Which engine. */
    int threads;           /**< Worker threads, 1 to #THREADS_MAXIMUM. */
    int width;             /**< Pixels. */
    int height;            /**< Pixels. */
    int samples;           /**< Rays a pixel. */
    Sampling sampling;     /**< Whether every pixel gets that many. */
    int encoding;          /**< An #Encoding. */
    LightingMode lighting; /**< Which light there is. */
    TraceSettings trace;   /**< Depth, offset and tree; the rest the renderer fills in. */
} RenderSettings;

/** How a drawing went. */
typedef struct RenderStats {
    double seconds; /**< Wall-clock time. */
    double
        full_resolution_seconds; /**< Of that, until every pixel had its first ray; 0: not yet. */
    RayCounts rays;              /**< Rays traced. */
    int stride;                  /**< Pixels a block of the newest pass: 8, 4, 2 or 1. */
    int samples;                 /**< Samples a pixel that are in the picture. */
    double progress;             /**< Share of all the work that is done, 0 to 1. */
    bool is_finished;            /**< Whether this is the last pass. */
    LayerStats layer;            /**< Which layer is drawn, and what is to be said of it. */
} RenderStats;

/** A renderer; its inside is its own. */
typedef struct Renderer Renderer;

/** Told when a pass has ended, from a thread of the renderer. @param context The listener's own. */
typedef void (*RenderPassCallback)(void *context);

/**
 * @return Settings as the scene asks for them, with the preferred engine and a thread a core.
 * @param scene  The scene.
 */
RenderSettings render_settings_default(const Scene *scene);

/** @return The processors that this process may use, at least 1. */
int render_cpu_count(void);

/**
 * Makes a renderer for a scene.
 * @param scene       The scene; read during this call only.
 * @param settings    What is asked for.
 * @param[out] error  What is wrong.
 * @return The renderer, to be given back with #renderer_destroy; NULL if anything is wrong.
 */
Renderer *renderer_create(const Scene *scene, const RenderSettings *settings, Error *error);

/**
 * Makes a renderer for a scene, such as the next one of a film, that shares with another what both
 * of them need: the trees of the same meshes.
 * @param reuse_from      The other, perhaps drawing, there during this call; NULL: none.
 * @param scene       See #renderer_create.
 * @param settings    See #renderer_create.
 * @param[out] error  See #renderer_create.
 * @return See #renderer_create. It does not need the other any more.
 */
Renderer *renderer_create_reusing(const Renderer *reuse_from, const Scene *scene,
                                  const RenderSettings *settings, Error *error);

/** @return What a renderer's tracer was made of. @param renderer The renderer. */
TracerStats renderer_contents(const Renderer *renderer);

/** Stops whatever is drawn and gives a renderer back. @param renderer The renderer, or NULL. */
void renderer_destroy(Renderer *renderer);

/**
 * Draws the whole picture and waits for it.
 * @param renderer       The renderer, with nothing drawn in the background.
 * @param stop           Looked at often: the drawing ends early once it is true. May be NULL.
 * @param[out] picture   An empty picture of the settings' size for the result, or NULL: only timed.
 *                       What is not drawn stays black. Its encoding becomes the settings'; its
 *                       light is filled, too, if it keeps any.
 * @return How it went; RenderStats.is_finished is false when it was stopped.
 */
RenderStats renderer_render(Renderer *renderer, const atomic_bool *stop, Picture *picture);

/**
 * Share of the work that is done, for a progress line.
 * @param renderer  A renderer, perhaps drawing in another thread.
 * @return 0 to 1.
 */
double renderer_progress(const Renderer *renderer);

/**
 * Begins, or begins again, to draw in the background, and returns at once.
 * @param renderer  The renderer.
 * @param scene     Camera and lights are taken from it, before this returns; same shapes as before.
 * @param width     Pixels of the picture from now on.
 * @param height    Pixels of the picture from now on.
 * @param callback  Told after each pass, from another thread; may be NULL.
 * @param context   Handed to the listener.
 * @param[out] error  What is wrong.
 * @return false without memory.
 */
bool renderer_start(Renderer *renderer, const Scene *scene, int width, int height,
                    RenderPassCallback callback, void *context, Error *error);

/**
 * Draws a layer of the picture in the background from the next #renderer_start on, with one ray a
 * pixel; or the light again, which is drawn at first.
 * @param renderer  The renderer.
 * @param layer     Which.
 */
void renderer_set_layer(Renderer *renderer, Layer layer);

/** Stops drawing in the background and waits until it has stopped. @param renderer The renderer. */
void renderer_stop(Renderer *renderer);

/**
 * Takes the newest finished pass of a drawing in the background.
 * @param renderer       The renderer.
 * @param[out] stats    How it stands.
 * @param[out] bgrx      Where the pixels go: blue, green, red and an unused byte each; NULL:
 * nowhere.
 * @param pitch          Bytes from a row to the next.
 * @return false while there is no finished pass since #renderer_start: nothing is written then.
 */
bool renderer_copy_latest(Renderer *renderer, RenderStats *stats, uint8_t *bgrx, int pitch);

/**
 * Finds the tree of rays of a pixel: those of its first sample, through its centre. A picture of
 * one sample shows the first ray's colour, bit for bit.
 * @param renderer       The renderer, perhaps drawing in the background; its size and its camera
 * are those of the newest drawing.
 * @param x              The pixel's column, from the left.
 * @param y              Its row, from the top.
 * @param[in,out] tree  The tree, `{0}` or of another pixel: its room is used again.
 * @param[out] error     What is wrong.
 * @return false without memory for it.
 */
bool renderer_record_ray_tree(const Renderer *renderer, int x, int y, RayTree *tree, Error *error);

/**
 * Times what `dioptre bench --rays primary` and `--rays random` ask for: nearest hits alone.
 * @param renderer  The renderer, with nothing drawn in the background.
 * @param random    false: a camera ray a pixel; true: as many rays with origins uniform in the
 *                  scene's bounds and directions uniform, from a fixed seed.
 * @return Time and rays.
 */
RenderStats renderer_benchmark_rays(Renderer *renderer, bool random);

#endif
