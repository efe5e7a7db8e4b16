/**
 * @file
 * @brief Rendering of pictures: threads, tiles and passes.
 *
 * A renderer owns a thread pool and a tracer. It renders in passes: from coarse to fine in the
 * background, then one sample per pixel after another. It renders either in one call
 * (#renderer_render) or in the background (#renderer_start); the final bits are the same.
 */
#ifndef DIOPTRE_RENDERER_H
#define DIOPTRE_RENDERER_H

#include "base/picture.h"
#include "dioptre/engine.h"
#include "dioptre/layer.h"

#include <stdatomic.h>

/** Largest number of threads. */
enum { THREADS_MAXIMUM = 1024 };

/** Numbers of samples per pixel. */
typedef enum {
    SAMPLING_ADAPTIVE, /**< Few in pixels whose first samples agree: the default. */
    SAMPLING_FULL      /**< The full number in every pixel. */
} Sampling;

/** The light of the picture. */
typedef enum {
    LIGHTING_FULL,       /**< Lights and ambient light of the scene: the default. */
    LIGHTING_NO_AMBIENT, /**< The lights alone, under a black sky. */
    LIGHTING_UNLIT,      /**< White ambient light alone: shapes show their albedo, and what glows
                              still glows. */
    LIGHTING_MODE_COUNT  /**< Number of modes. */
} LightingMode;

/** The settings of a renderer, besides the scene. */
typedef struct RenderSettings {
    const Engine *engine;  /**< The engine. */
    int threads;           /**< Threads, 1 to #THREADS_MAXIMUM. */
    int width;             /**< Pixels. */
    int height;            /**< Pixels. */
    int samples;           /**< Samples per pixel. */
    Sampling sampling;     /**< Whether adaptive sampling may take fewer samples. */
    int encoding;          /**< An #Encoding. */
    LightingMode lighting; /**< The light of the picture. */
    MethodSet method_set;  /**< Whose methods; #method_set_apply sets what follows from it. */
    TraceSettings trace;   /**< Depth, offset and BVH; the renderer fills in the rest. */
} RenderSettings;

/** The state of a picture. */
typedef struct RenderStats {
    double seconds;                 /**< Wall-clock time. */
    double full_resolution_seconds; /**< Time until every pixel had a ray; 0: not yet. */
    RayCounts rays;                 /**< Rays traced. */
    int stride;                     /**< Pixels from one ray to the next: 8, 4, 2 or 1. */
    int samples;                    /**< Samples per pixel. */
    double progress;                /**< Completed fraction of the work, 0 to 1. */
    bool is_finished;               /**< Whether this is the last pass. */
    bool is_part;                   /**< Whether tiles of the first pass are missing: they show
                                         the picture of before. */
    LayerStats layer;               /**< The layer shown, and its statistics. */
} RenderStats;

/** A renderer; opaque. */
typedef struct Renderer Renderer;

/** Called on a thread of the renderer when there is more to show. @param context See
 * #renderer_start. */
typedef void (*RenderPassCallback)(void *context);

/**
 * @return The settings of a scene file, with an engine of sufficient precision and one thread per
 *         processor.
 * @param scene  The scene.
 */
RenderSettings render_settings_default(const Scene *scene);

/** Distance to a surface at which sphere tracing stops, in half pixels (doc/marching.md). */
#define RENDER_FOOTPRINT 0.125

/** The words of `--sampling`, in the order of #Sampling; ended by NULL. */
extern const char *const sampling_words[];

/** The words of `--methods`, in the order of #MethodSet; ended by NULL. */
extern const char *const method_set_words[];

/** The words of `--pixel`, in the order of #PixelPoint; ended by NULL. */
extern const char *const pixel_point_words[];

/** @return Where in its pixel a ray goes, in English: to be put behind "rays go". */
const char *pixel_point_name(PixelPoint point);

/** @return Whose methods they are, in English. */
const char *method_set_name(MethodSet set);

/** @return What is seen of them, in a sentence, in English. */
const char *method_set_effect(MethodSet set);

/** Sets everything that a report did in its own way: methods, offset, epsilon and marching. Does
 *  nothing if the settings have these methods already. */
void method_set_apply(MethodSet set, RenderSettings *settings);

/** @return The processors that this process may use, at least 1. */
int render_cpu_count(void);

/**
 * Creates a renderer for a scene.
 * @param scene       The scene; read during this call only.
 * @param settings    The settings.
 * @param[out] error  No memory, or no thread.
 * @return The renderer, to be freed with #renderer_destroy; NULL on failure.
 */
Renderer *renderer_create(const Scene *scene, const RenderSettings *settings, Error *error);

/**
 * Creates a renderer for a scene, such as the next frame of a film, that shares the mesh BVHs of
 * another renderer.
 * @param reuse_from  The other renderer, perhaps rendering; needed during this call only. May be
 *                    NULL.
 * @param scene       See #renderer_create.
 * @param settings    See #renderer_create.
 * @param[out] error  See #renderer_create.
 * @return See #renderer_create.
 */
Renderer *renderer_create_reusing(const Renderer *reuse_from, const Scene *scene,
                                  const RenderSettings *settings, Error *error);

/** @return The contents of a renderer's tracer. */
TracerStats renderer_contents(const Renderer *renderer);

/** Stops rendering and frees a renderer, or NULL. */
void renderer_destroy(Renderer *renderer);

/**
 * Renders the whole picture.
 * @param renderer       The renderer, idle in the background.
 * @param stop           Rendering ends early once it is true. May be NULL.
 * @param[in,out] picture   An empty picture of the settings' size, or NULL to time only. Pixels
 * that are not rendered stay black. Linear light is filled in, too, if allocated.
 * @return The state of the picture; RenderStats.is_finished is false when it was stopped.
 */
RenderStats renderer_render(Renderer *renderer, const atomic_bool *stop, Picture *picture);

/**
 * @return Completed fraction of the work, 0 to 1.
 * @param renderer  A renderer, perhaps rendering on another thread.
 */
double renderer_progress(const Renderer *renderer);

/** How far a pass is. */
typedef struct PassProgress {
    double fraction; /**< Fraction of its tiles that are done, 0 to 1. */
    double seconds;  /**< Seconds since its begin. */
} PassProgress;

/** @return How far the newest pass is; zeros before the first. @param renderer A renderer, perhaps
 *  rendering on another thread. */
PassProgress renderer_pass_progress(const Renderer *renderer);

/**
 * Starts, or restarts, rendering in the background, and returns at once.
 * @param renderer  The renderer.
 * @param scene     Source of camera and lights, read during this call; same shapes as before.
 * @param width     Pixels of the picture from now on.
 * @param height    Pixels of the picture from now on.
 * @param callback  Called on another thread after each pass, and during a long first pass when
 *                  more of its tiles can be shown; may be NULL.
 * @param context   Argument of the callback.
 * @param[out] error  No memory, or no thread.
 * @return false on failure.
 */
bool renderer_start(Renderer *renderer, const Scene *scene, int width, int height,
                    RenderPassCallback callback, void *context, Error *error);

/**
 * Sets the layer to render from the next #renderer_start on, with one ray per pixel. Stops
 * rendering.
 * @param renderer  The renderer.
 * @param layer     The layer; #LAYER_SHADED, the picture itself, is the default.
 */
void renderer_set_layer(Renderer *renderer, Layer layer);

/**
 * Measures a layer in one call, without a picture.
 * @param renderer    The renderer; rendering in the background is stopped, its layer stays set.
 * @param scene       Source of camera and lights; same shapes as before.
 * @param layer       The layer; not #LAYER_SHADED.
 * @param stop        Measuring ends early once it is true. May be NULL.
 * @param[out] stats  Its statistics, of one ray per pixel.
 * @param[out] error  No memory; or #STATUS_INTERRUPTED where it was stopped.
 * @return false if anything is wrong.
 */
bool renderer_measure_layer(Renderer *renderer, const Scene *scene, Layer layer,
                            const atomic_bool *stop, LayerStats *stats, Error *error);

/** Stops rendering in the background and waits until it has stopped. */
void renderer_stop(Renderer *renderer);

/**
 * Copies the newest finished pass of the background, or the tiles of the first one, where it takes
 * long, over the picture of before.
 * @param renderer       The renderer.
 * @param[out] stats     The state of the picture.
 * @param[out] bgrx      The pixels: blue, green, red and an unused byte each; may be NULL.
 * @param pitch          Bytes from a row to the next.
 * @return false if nothing is there since #renderer_start: nothing is written then.
 */
bool renderer_copy_latest(Renderer *renderer, RenderStats *stats, uint8_t *bgrx, int pitch);

/** What one pixel of a picture shows. */
typedef struct PixelReading {
    uint8_t rgb[3];             /**< Its colour. */
    Layer layer;                /**< The layer. */
    float values[LAYER_VALUES]; /**< Its numbers, see #layer_values; zero in #LAYER_SHADED. */
    int shape;                  /**< Index of the shape at the middle of the pixel; -1: none. */
    double distance;            /**< Distance to it, scene units; infinity: none. */
} PixelReading;

/**
 * Reads a pixel of the newest pass.
 * @param renderer      The renderer.
 * @param x             The pixel's column, from the left.
 * @param y             Its row, from the top.
 * @param[out] reading  What it shows.
 * @return false if no pass has finished, or the pixel is outside.
 */
bool renderer_read_pixel(Renderer *renderer, int x, int y, PixelReading *reading);

/**
 * Copies the colours of a part of the newest pass.
 * @param renderer  The renderer.
 * @param x         Column of its first pixel; may be outside.
 * @param y         Row of its first pixel; may be outside.
 * @param columns   Pixels to the right.
 * @param rows      Pixels down.
 * @param[in,out] rgb  The colours, row by row; what is outside of the picture stays as it is.
 */
void renderer_copy_part(Renderer *renderer, int x, int y, int columns, int rows, uint8_t *rgb);

/**
 * Copies the numbers of the newest pass of a layer.
 * @param renderer     The renderer.
 * @param[out] stats   The state of the picture.
 * @param[out] values  #LAYER_VALUES numbers of each pixel, row by row.
 * @return false if no pass has finished, or it shows no layer: nothing is written then.
 */
bool renderer_copy_values(Renderer *renderer, RenderStats *stats, float *values);

/** Copies the marks of the newest pass of a layer; none if it has none. */
void renderer_copy_marks(Renderer *renderer, LayerMarks *marks);

/**
 * Records the ray tree of a pixel's first sample, through its centre. A picture of one sample shows
 * the colour of the first ray, bit for bit.
 * @param renderer       The renderer, perhaps rendering in the background. Size and camera are
 * those of the newest picture.
 * @param x              The pixel's column, from the left.
 * @param y              Its row, from the top.
 * @param[in,out] tree   The tree, `{0}` or a recorded one, whose memory is reused.
 * @param[out] error     No memory.
 * @return false without memory.
 */
bool renderer_record_ray_tree(const Renderer *renderer, int x, int y, RayTree *tree, Error *error);

/**
 * Times closest hits alone, for `dioptre bench --rays`.
 * @param renderer  The renderer, idle in the background.
 * @param random    false: a camera ray per pixel; true: as many rays with origins uniform in the
 *                  scene's bounds and uniform directions, from a fixed seed.
 * @return Time and rays.
 */
RenderStats renderer_benchmark_rays(Renderer *renderer, bool random);

/**
 * Traces a camera ray per pixel, closest hits alone, in an order that is spread over the picture,
 * until all are traced or the time is over. #renderer_contents then has what they counted.
 * @param renderer  The renderer, idle in the background.
 * @param seconds   The time.
 * @return Time and rays; RenderStats::is_finished: all pixels have theirs.
 */
RenderStats renderer_sample_camera_rays(Renderer *renderer, double seconds);

/**
 * Traces a camera ray for every eighth pixel of every eighth row (of small pictures for more), with
 * all that come from it, in an order that is spread over the picture, until all are traced or the
 * time is over: to say before a picture how much of its light it will lack.
 * @param renderer  The renderer, idle in the background.
 * @param seconds   The time.
 * @param stop      Once true, the rest is left out; may be NULL.
 * @return The rays; #RayCounts.unresolved of #RayCounts.camera lack more light than the cutoff
 *         allows. None where nothing is reflected or refracted.
 */
RayCounts renderer_forecast_light(Renderer *renderer, double seconds, const atomic_bool *stop);

#endif
