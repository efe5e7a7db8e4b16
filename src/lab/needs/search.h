/**
 * @file
 * @brief A search for what a scene needs: its state, and its parts in their order.
 */
#ifndef DIOPTRE_LAB_NEEDS_SEARCH_H
#define DIOPTRE_LAB_NEEDS_SEARCH_H

#include "lab/needs/needs.h"

/** Depth of the reference. */
enum { REFERENCE_DEPTH = DEPTH_MAXIMUM };

/** Coarsest and finest cutoff of a reference, 8-bit steps: below the finest no picture of doubles
 *  changes. */
#define REFERENCE_CUTOFF_COARSEST (CUTOFF_DEFAULT / 16)
/** See #REFERENCE_CUTOFF_COARSEST. */
#define REFERENCE_CUTOFF_FINEST 1e-9

/** Tolerances of the reference over the scene's own, where any are sufficient. */
#define REFERENCE_TOLERANCE (1.0 / 64)

/** From a cutoff or a tolerance to the next coarser or finer one. */
#define NEEDS_STEP 4.0

/** A search in progress. */
typedef struct NeedsSearch {
    const Scene *scene;          /**< The scene. */
    const NeedsRequest *request; /**< What is wanted. */
    TrialStage stage;            /**< Pictures on which single settings are tried. */
    TrialStage check_stage;      /**< Pictures on which all of them are checked. */
    double ray_seconds;          /**< CPU time per camera ray of the reference. */
    Needs *needs;                /**< The result. */
} NeedsSearch;

/** How large pictures are. */
typedef struct StageSize {
    int width;   /**< Pixels at most; the height follows. */
    int samples; /**< Rays per pixel at most. */
} StageSize;

/** Tells what is tried now. @param what English, with N_(). */
void search_report(const NeedsSearch *search, const char *what);

/**
 * Makes pictures as large as time allows.
 * @param largest      The largest size that is of use.
 * @param ray_seconds  CPU time per camera ray.
 * @param limit        CPU time of one picture, seconds.
 * @return The stage.
 */
TrialStage search_stage(const NeedsSearch *search, StageSize largest, double ray_seconds,
                        double limit);

/** Measures the CPU time per camera ray of settings. @return false if anything is wrong. */
bool search_probe_cost(const NeedsSearch *search, const NeedsSettings *settings,
                       double *ray_seconds, Error *error);

/** Finds depth, cutoff, tolerance, number type and offset, each by itself. @return false if
 *  anything is wrong. */
bool search_settings(NeedsSearch *search, Error *error);

/** Checks all of them together and corrects what is refuted. @return false if anything is wrong. */
bool search_check(NeedsSearch *search, Error *error);

/** Finds how many rays per pixel are sufficient. @return false if anything is wrong. */
bool search_samples(NeedsSearch *search, Error *error);

/** Finds the fastest engine of the number type, and times. @return false if anything is wrong. */
bool search_costs(NeedsSearch *search, Error *error);

/** Finds the best picture within a time. @return false if anything is wrong. */
bool search_budget(NeedsSearch *search, Error *error);

/**
 * Measures the time on the clock of a whole picture as asked for.
 * @param[out] seconds      The time.
 * @param[out] is_measured  Whether it was measured; otherwise it follows from a smaller picture.
 * @return false if anything is wrong.
 */
bool search_time_picture(const NeedsSearch *search, const NeedsSettings *settings, double *seconds,
                         bool *is_measured, Error *error);

#endif
