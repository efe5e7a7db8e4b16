/**
 * @file
 * @brief Shots: some pixels of a scene, traced in one manner, with every ray's colour and trail.
 */
#ifndef DIOPTRE_LAB_SHOT_H
#define DIOPTRE_LAB_SHOT_H

#include "lab/pixels.h"

#include <stdatomic.h>

/** How pixels are traced. */
typedef struct Manner {
    const Engine *engine; /**< With which engine. */
    TraceSettings trace;  /**< With which settings; its samples are the picture's. */
    int rays;             /**< How many of the samples of each pixel are traced. */
    double right;         /**< By how much the camera is turned to the right, pixels. */
    double up;            /**< By how much it is turned up, pixels. */
} Manner;

/** What a scene looked like. */
typedef struct Shot {
    size_t count;     /**< Rays: pixels times samples. */
    double *rgb;      /**< Linear light of each, three numbers; sample after sample; owned. */
    uint64_t *trails; /**< The trail of each; owned. */
    double seconds;   /**< The processor's time for tracing, of all threads. */
    RayCounts rays;   /**< Rays traced in all. */
} Shot;

/** What is shot, and by whom. */
typedef struct Studio {
    const Scene *scene;      /**< The scene. */
    const Pixels *pixels;    /**< Of the picture. */
    int threads;             /**< How many trace. */
    const atomic_bool *stop; /**< A shot is given up once it is true; may be NULL. */
} Studio;

/**
 * Traces.
 * @param studio      What.
 * @param manner      How.
 * @param[out] shot   The shot, to be given back with #shot_release.
 * @param[out] error  What is wrong; #STATUS_INTERRUPTED where it was stopped.
 * @return false if anything is.
 */
bool shot_take(const Studio *studio, const Manner *manner, Shot *shot, Error *error);

/** Gives a shot back. @param shot The shot; may be empty. */
void shot_release(Shot *shot);

#endif
