/**
 * @file
 * @brief What a scene needs: the cheapest settings that nobody can tell from the reference.
 *
 * The settings are forecast from the scene's numbers, then tried on a fixed sample of pixels: one
 * of 8 by 8, and more where shapes end. Nobody can tell means: less than half an 8-bit step of the
 * encoded picture, for rays that took the same way; and where roundings put a ray on the other side
 * of an edge, that the edge is moved by less than 1/64 pixel.
 */
#ifndef DIOPTRE_NEEDS_H
#define DIOPTRE_NEEDS_H

#include "render/precision_estimate.h"

#include <stdatomic.h>

/** Share of the rays that may be off all the same: as few as a sample can tell from none. */
#define NEEDS_FRACTION_MAXIMUM 1e-4

/** Engines that are tried at most. */
enum { NEEDS_ENGINES = 3 };

/** What is asked. */
typedef struct NeedsRequest {
    int width;                  /**< Of the picture, pixels. */
    int height;                 /**< Of the picture, pixels. */
    int samples;                /**< Rays a pixel that are wanted. */
    int depth;                  /**< Depth that is wanted; -1: what the scene needs. */
    const TraceSettings *trace; /**< How rays leave surfaces. */
    int threads;                /**< How many work. */
    bool uses_all_pixels; /**< Whether all pixels are tried: to see whether a sample is enough. */
    const atomic_bool *stop; /**< It is given up once this is true; may be NULL. */
} NeedsRequest;

/** How something was found to be off. */
typedef struct NeedsTrial {
    size_t rays;       /**< How many were compared. */
    double max_steps;  /**< By how many steps at most, of those that took the same way. */
    size_t visible;    /**< How many are off by half a step or more. */
    size_t edge_flips; /**< How many passed an edge on its other side. */
    size_t outliers;   /**< How many of those by more than anybody would miss. */
} NeedsTrial;

/** An engine that was tried. */
typedef struct NeedsEngine {
    const Engine *engine; /**< The engine. */
    const Engine
        *reference;     /**< What it was compared with; NULL: with nothing, it was only timed. */
    NeedsTrial trial;   /**< How it did. */
    double cpu_seconds; /**< The processor's time for the timed part of the picture. */
} NeedsEngine;

/** What a scene needs. */
typedef struct Needs {
    PrecisionEstimate forecast;         /**< What its numbers say. */
    NeedsEngine engines[NEEDS_ENGINES]; /**< The engines that were tried, the fastest first. */
    int engine_count;                   /**< How many. */
    int engine;                         /**< Which of them is enough. */
    bool is_recursive;                  /**< Whether anything mirrors or lets light through. */
    int depth;                          /**< How deep rays must be followed. */
    NeedsTrial depth_trial;             /**< What following them deeper would change. */
    NeedsTrial shallower_trial;         /**< What following them once less changes. */
    NeedsTrial cutoff_trial;            /**< What rays that end at the usual weight leave out. */
    NeedsTrial scene_depth_trial;       /**< What the scene's own depth changes. */
    int scene_depth;                    /**< The scene's own depth; -1: it says none. */
    bool has_sdf;                       /**< Whether it has distance fields. */
    double tolerance;                   /**< How many times as coarse as it says they may be. */
    NeedsTrial tolerance_trial;         /**< What that changes. */
    NeedsTrial offset_none_trial;       /**< What starting rays at the very surface changes. */
    NeedsTrial offset_fixed_trial;      /**< What starting them one length away changes. */
    int samples;                        /**< Rays a pixel. */
    double samples_rms;                 /**< What edges are still off then, steps: root of the mean
                                             square of the pixels that are off at all. */
    double samples_fraction;            /**< Share of the pixels that are off at all. */
    NeedsTrial total_trial;             /**< All of it together, against the reference. */
    double reference_cpu_seconds;       /**< The processor's time for everything on, for the timed
                                  part of the picture. */
} Needs;

/**
 * Finds what a scene needs.
 * @param scene       The scene.
 * @param request     What is asked.
 * @param[out] needs  What it needs.
 * @param[out] error  What is wrong.
 * @return false if anything is.
 */
bool needs_find(const Scene *scene, const NeedsRequest *request, Needs *needs, Error *error);

/** @return Whether somebody could tell. @param trial What was tried. */
bool needs_trial_fails(const NeedsTrial *trial);

/** @return Rays of which at most one is off, as the sample says with 95 % certainty.
 *  @param trial A trial without any that is off. */
double needs_trial_certainty(const NeedsTrial *trial);

/**
 * Explains it in a paragraph for a pupil.
 * @param needs  What a scene needs.
 * @param[out] text  The paragraph, in one line; cut to its size.
 * @param size   Bytes of it.
 */
void needs_explain(const Needs *needs, char *text, size_t size);

#endif
