/**
 * @file
 * @brief Whole small pictures of a scene with various settings, and how far they differ.
 *
 * Every setting is judged by the same measure: how many pixels of the encoded picture differ by
 * the error that is allowed, or more. It does not matter why: by another shade, by another thing
 * that a ray meets, or by an edge that has moved.
 */
#ifndef DIOPTRE_LAB_NEEDS_TRIAL_H
#define DIOPTRE_LAB_NEEDS_TRIAL_H

#include "dioptre/renderer.h"

/** Settings that are proposed or tried. */
typedef struct NeedsSettings {
    const Engine *engine;  /**< The engine. */
    int depth;             /**< Depth of recursion. */
    double cutoff;         /**< See #TraceSettings.cutoff. */
    OffsetStrategy offset; /**< How rays leave surfaces. */
    int samples;           /**< Rays per pixel. */
    double tolerance;      /**< Factor of the tolerances of distance fields. */
} NeedsSettings;

/** Differences of a picture from its reference. */
typedef struct NeedsTrial {
    size_t pixels;    /**< Pixels compared. */
    size_t off;       /**< Those that differ by the error allowed, or more. */
    double max_steps; /**< Largest difference of a channel, 8-bit steps of the encoded picture. */
    double rms_steps; /**< Root of the mean square of the differences of all channels, likewise. */
} NeedsTrial;

/** What pictures are rendered of, all alike but for the settings that are tried. */
typedef struct TrialStage {
    const Scene *scene;         /**< The scene. */
    const TraceSettings *trace; /**< Settings that are not tried. */
    int width;                  /**< Pixels. */
    int height;                 /**< Pixels. */
    int samples;                /**< Most rays per pixel that are traced. */
    int threads;                /**< Threads that trace. */
    LightingMode lighting;      /**< The light. */
    double error_steps;         /**< The error allowed, 8-bit steps, above 0. */
    const atomic_bool *stop;    /**< Rendering stops once this is true; may be NULL. */
} TrialStage;

/** A picture of a trial. */
typedef struct TrialPicture {
    Picture picture;    /**< The picture, with its linear light; owned. */
    double seconds;     /**< Time on the clock. */
    double cpu_seconds; /**< CPU time of the thread that renders. */
} TrialPicture;

/**
 * Renders all pixels of a picture, each with all its rays.
 * @param[out] picture  The picture, to be released with #trial_picture_deinit; empty on failure.
 * @param[out] error    What is wrong; #STATUS_INTERRUPTED where it was stopped.
 * @return false if anything is wrong.
 */
bool trial_render(const TrialStage *stage, const NeedsSettings *settings, TrialPicture *picture,
                  Error *error);

/** Releases a picture, which may be empty. */
void trial_picture_deinit(TrialPicture *picture);

/** @return How two pictures of a stage differ. */
NeedsTrial trial_compare(const TrialStage *stage, const TrialPicture *a, const TrialPicture *b);

/**
 * Renders a picture and compares it.
 * @param reference   What it is compared with.
 * @param[out] trial  How they differ.
 * @param[out] error  What is wrong.
 * @return false if anything is wrong.
 */
bool trial_run(const TrialStage *stage, const NeedsSettings *settings,
               const TrialPicture *reference, NeedsTrial *trial, Error *error);

/** How long pictures take. */
typedef struct TrialTime {
    double cpu_least; /**< Least CPU time of a turn, seconds. */
    double cpu_most;  /**< Most CPU time of a turn, seconds. */
    double least;     /**< Least time on the clock of a turn, seconds. */
} TrialTime;

/**
 * Times settings in turn, so that a busy processor affects all alike.
 * @param settings    The settings.
 * @param count       Their number.
 * @param turns       How often each is timed, at least 1.
 * @param[out] times  Per settings.
 * @param[out] error  What is wrong.
 * @return false if anything is wrong.
 */
bool trial_time(const TrialStage *stage, const NeedsSettings *settings, size_t count, int turns,
                TrialTime *times, Error *error);

/**
 * Does what trial_time() does, on the calling thread alone: its CPU times can be compared, whatever
 * the picture's size.
 */
bool trial_time_processor(const TrialStage *stage, const NeedsSettings *settings, size_t count,
                          int turns, TrialTime *times, Error *error);

/** @return Whether every turn of a was faster than every turn of b: more than the noise of the
 *          clock. */
bool trial_time_is_faster(const TrialTime *a, const TrialTime *b);

#endif
