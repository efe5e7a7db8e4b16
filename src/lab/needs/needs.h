/**
 * @file
 * @brief Finds what a scene needs: the cheapest settings without a visible difference.
 *
 * The settings are estimated from the scene's numbers and then tried on a fixed sample of pixels:
 * one of 8 by 8, and more at the edges of shapes. A difference is visible from half an 8-bit step
 * of the encoded picture on, for rays on the same path. Where roundings put a ray on the other side
 * of an edge, it is visible if the edge moves by more than 1/64 pixel.
 */
#ifndef DIOPTRE_LAB_NEEDS_NEEDS_H
#define DIOPTRE_LAB_NEEDS_NEEDS_H

#include "render/precision_estimate.h"

#include <stdatomic.h>

/** Largest fraction of rays with visible differences: about what a sample can tell from none. */
#define NEEDS_FRACTION_MAXIMUM 1e-4

/** Engines that are tried at most. */
enum { NEEDS_ENGINES = 3 };

/** What is wanted. */
typedef struct NeedsRequest {
    int width;                  /**< Of the picture, pixels. */
    int height;                 /**< Of the picture, pixels. */
    int samples;                /**< Rays per pixel. */
    int depth;                  /**< Depth to judge, such as the scene's own; -1: none. */
    const TraceSettings *trace; /**< How rays leave surfaces. */
    int threads;                /**< How many threads trace. */
    bool uses_all_pixels;       /**< Whether all pixels are tried, to judge the sample. */
    const atomic_bool *stop;    /**< The search is given up once this is true; may be NULL. */
} NeedsRequest;

/** Differences of a setting from its reference. */
typedef struct NeedsTrial {
    size_t rays;       /**< Rays compared. */
    double max_steps;  /**< Largest difference on the same path, 8-bit steps. */
    size_t visible;    /**< Rays on the same path with a visible difference. */
    size_t edge_flips; /**< Rays on another path with a visible difference. */
    size_t outliers;   /**< Those of them that no small rotation of the camera explains. */
} NeedsTrial;

/** An engine that was tried. */
typedef struct NeedsEngine {
    const Engine *engine;    /**< The engine. */
    const Engine *reference; /**< Its reference; NULL: it was only timed. */
    NeedsTrial trial;        /**< Its differences. */
    double cpu_seconds;      /**< CPU time of the timed part of the picture. */
} NeedsEngine;

/** What a scene needs. */
typedef struct Needs {
    PrecisionEstimate forecast;         /**< The estimate from its numbers. */
    NeedsEngine engines[NEEDS_ENGINES]; /**< The engines that were tried, the fastest first. */
    int engine_count;                   /**< Number of #engines. */
    int engine;                         /**< The first of them that is sufficient. */
    bool is_recursive;                  /**< Whether anything reflects or transmits light. */
    int depth;                          /**< The depth that is sufficient. */
    NeedsTrial depth_trial;             /**< That depth against full depth. */
    NeedsTrial shallower_trial;         /**< One less against full depth. */
    NeedsTrial cutoff_trial;            /**< The default cutoff against a smaller one. */
    NeedsTrial scene_depth_trial;       /**< The scene's own depth against full depth. */
    int scene_depth;                    /**< The scene's own depth; -1: it has none. */
    bool has_sdf;                       /**< Whether it has distance fields. */
    double tolerance;                   /**< The factor by which tolerances may be coarser. */
    NeedsTrial tolerance_trial;         /**< That against fine tolerances. */
    NeedsTrial offset_none_trial;       /**< No ray offset against the error bound. */
    NeedsTrial offset_fixed_trial;      /**< A fixed ray offset against the error bound. */
    int samples;                        /**< Rays per pixel. */
    double samples_rms;                 /**< RMS noise of pixels with visible noise, 8-bit steps. */
    double samples_fraction;            /**< Fraction of the pixels with visible noise. */
    NeedsTrial total_trial;             /**< All settings together against the reference. */
    double reference_cpu_seconds;       /**< CPU time of the reference, for the timed part. */
} Needs;

/**
 * Finds what a scene needs.
 * @param scene       The scene.
 * @param request     What is wanted.
 * @param[out] needs  What it needs.
 * @param[out] error  What is wrong.
 * @return false if anything is wrong.
 */
bool needs_find(const Scene *scene, const NeedsRequest *request, Needs *needs, Error *error);

/** @return Whether more than #NEEDS_FRACTION_MAXIMUM of the rays differ visibly. */
bool needs_trial_fails(const NeedsTrial *trial);

/** @return n, so that with 95 % confidence at most one ray in n differs visibly.
 *  @param trial A trial without visible differences. */
double needs_trial_certainty(const NeedsTrial *trial);

/**
 * Explains needs in a paragraph for pupils.
 * @param needs  What a scene needs.
 * @param[out] text  The paragraph, in one line; cut to its size.
 * @param size   Bytes of it.
 */
void needs_explain(const Needs *needs, char *text, size_t size);

#endif
