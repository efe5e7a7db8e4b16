/**
 * @file
 * @brief Measures the error of settings on a small picture, in a thread of its own.
 *
 * The picture has the camera of the one on screen and few pixels. It is compared with one that is
 * drawn in double, with many samples, and as deep as rays go. That reference is drawn once for each
 * view.
 */
#ifndef DIOPTRE_VIEW_LOADING_ERROR_METER_H
#define DIOPTRE_VIEW_LOADING_ERROR_METER_H

#include "dioptre/renderer.h"

#include <pthread.h>

/** Pixels of the small picture, at most. */
enum { ERROR_METER_PIXELS = 4800 };
/** Samples per pixel of the reference. */
enum { ERROR_METER_SAMPLES = 64 };

/** The meter. Starts as `{0}`: idle. */
typedef struct ErrorMeter {
    uint32_t event;       /**< SDL event, registered, to send when a measurement has ended. */
    bool is_busy;         /**< Whether the thread was started and its result is not taken. */
    pthread_t thread;     /**< The thread, while it is busy. */
    atomic_bool stop;     /**< Whether it is to end early. */
    atomic_bool has_done; /**< Whether it has ended. */
    Renderer *renderer;   /**< Draws the picture; owned, while it is busy. */
    Renderer *reference;  /**< Draws the reference; owned, while it is busy; NULL: it is drawn. */
    Picture picture;      /**< The picture, with its light. */
    Picture truth;        /**< The reference, with its light; kept for the next measurement. */
    bool has_truth;       /**< Whether the reference is drawn. */
    double error;         /**< The result, RMS in steps of 255; NaN: it was stopped. */
} ErrorMeter;

/**
 * Starts to measure.
 * @param meter     An idle meter.
 * @param scene     The scene; read during this call only.
 * @param settings  The settings.
 * @return false without memory or thread: the meter stays idle.
 */
bool error_meter_start(ErrorMeter *meter, const Scene *scene, const RenderSettings *settings,
                       Error *error);

/** Takes the result, if there is one; the meter is idle then. @param[out] result RMS in steps of
 *  255. @return Whether there is one. */
bool error_meter_take(ErrorMeter *meter, double *result);

/** Stops it: the picture on screen needs all threads. A finished reference is kept. */
void error_meter_stop(ErrorMeter *meter);

/** Stops it and forgets the reference: the view has changed, or the window closes. */
void error_meter_reset(ErrorMeter *meter);

#endif
