/**
 * @file
 * @brief Finds what a scene needs: the cheapest settings for an error, or the least error for a
 *        time.
 *
 * Each setting is tried on a whole small picture. Then all of them together are checked on a whole
 * larger one, against a reference with everything on. What that picture refutes is corrected by
 * the next finer setting and checked again. An error of E steps means: at most
 * #NEEDS_FRACTION_MAXIMUM of the pixels differ by E steps or more.
 */
#ifndef DIOPTRE_LAB_NEEDS_NEEDS_H
#define DIOPTRE_LAB_NEEDS_NEEDS_H

#include "lab/needs/trial.h"
#include "render/precision_estimate.h"

/** Largest fraction of the pixels that may be off. */
#define NEEDS_FRACTION_MAXIMUM 1e-4

/** Default of #NeedsRequest.error_steps: half an 8-bit step, which rounding to 8 bits leaves
 * anyway. */
#define NEEDS_ERROR_STEPS 0.5

/** What is wanted. */
typedef struct NeedsRequest {
    int width;                  /**< Of the picture, pixels. */
    int height;                 /**< Of the picture, pixels. */
    int samples;                /**< Rays per pixel to judge: the scene's own, or others. */
    int depth;                  /**< Depth to judge, such as the scene's own; -1: none. */
    const TraceSettings *trace; /**< Settings that are not searched. */
    int threads;                /**< How many threads trace. */
    double error_steps;         /**< The error allowed, 8-bit steps, above 0. */
    double budget_seconds;      /**< Time of a picture for which the best is sought; 0: none. */
    const atomic_bool *stop;    /**< The search is given up once this is true; may be NULL. */

    /** Is told what is tried now, in English; may be NULL. */
    void (*report)(void *context, const char *stage);

    void *context; /**< Passed to #report. */
} NeedsRequest;

/** A setting that can be made finer. */
typedef enum {
    NEEDS_ENGINE,       /**< The number type. */
    NEEDS_DEPTH,        /**< The depth. */
    NEEDS_CUTOFF,       /**< The cutoff. */
    NEEDS_OFFSET,       /**< The ray offset. */
    NEEDS_TOLERANCE,    /**< The tolerances of distance fields. */
    NEEDS_SETTING_COUNT /**< Number of settings. */
} NeedsSetting;

/** A check of all settings together on a whole picture. */
typedef struct NeedsCheck {
    const Engine *reference; /**< Engine of the reference. */
    int width;               /**< Pixels. */
    int height;              /**< Pixels. */
    int samples;             /**< Rays per pixel. */
    NeedsTrial trial;        /**< How far the picture is off. */
} NeedsCheck;

/** Number of ray offsets. */
enum { NEEDS_OFFSET_COUNT = OFFSET_BOUND + 1 };

/** Most checks: against double, and against quad. */
enum { NEEDS_CHECKS_MAXIMUM = 2 };

/** A correction of what a check refuted. */
typedef struct NeedsCorrection {
    NeedsSetting setting; /**< What was made finer. */
    NeedsSettings before; /**< The settings that were refuted. */
    NeedsTrial trial;     /**< How far their picture was off. */
    NeedsTrial without;   /**< The same with this setting alone as in the reference. */
} NeedsCorrection;

/** Most corrections. */
enum { NEEDS_CORRECTIONS_MAXIMUM = 12 };

/** The noise of a number of rays per pixel. */
typedef struct NeedsNoise {
    int samples;      /**< Rays per pixel. */
    NeedsTrial trial; /**< Difference from four times as many. */
} NeedsNoise;

/** Most numbers of rays per pixel that are tried. */
enum { NEEDS_NOISE_MAXIMUM = 12 };

/** The best picture within a time. */
typedef struct NeedsBudget {
    NeedsSettings settings;   /**< Its settings. */
    bool is_met;              /**< Whether it is drawn in time; otherwise nothing is. */
    double seconds;           /**< Its time on the clock, of the whole picture as asked for. */
    bool is_measured;         /**< Whether that was measured; otherwise it follows from a smaller
                                   picture. */
    int reference_samples;    /**< Rays per pixel of what it is compared with. */
    NeedsTrial trial;         /**< How far it is off, noise included. */
    NeedsTrial without_noise; /**< The same with as many rays per pixel as the reference. */
    size_t candidates;        /**< How many settings were compared. */
} NeedsBudget;

/** What a scene needs. */
typedef struct Needs {
    PrecisionEstimate forecast; /**< The estimate from its numbers. */
    double error_steps;         /**< The error allowed. */
    NeedsSettings settings;     /**< The cheapest sufficient settings. */
    NeedsSettings reference;    /**< Everything on, in double. */
    bool is_recursive;          /**< Whether anything reflects or transmits light. */
    bool has_sdf;               /**< Whether it has distance fields. */
    int asked_samples;          /**< Rays per pixel that were judged. */
    int scene_depth;            /**< The depth that was judged; -1: none. */
    int width;                  /**< Of the pictures of trials. */
    int height;                 /**< Of the pictures of trials. */
    int samples;                /**< Most rays per pixel in those trials. */

    NeedsTrial depth_trial;       /**< The depth against full depth. */
    NeedsTrial shallower_trial;   /**< One less. */
    NeedsTrial scene_depth_trial; /**< The depth that was judged. */

    NeedsTrial cutoff_trial;         /**< The cutoff against the reference's. */
    double coarser_cutoff;           /**< The next coarser cutoff; 0: none was tried. */
    NeedsTrial coarser_cutoff_trial; /**< That one. */

    bool is_tolerance_sufficient;       /**< Whether any tolerance is; otherwise the scene's own
                                             are those of the reference. */
    NeedsTrial own_tolerance_trial;     /**< The scene's own tolerances against the finest. */
    double finest_tolerance;            /**< The finest tolerance that was compared with that. */
    NeedsTrial finest_tolerance_trial;  /**< That one. */
    NeedsTrial tolerance_trial;         /**< The tolerance against the reference's. */
    double coarser_tolerance;           /**< The next coarser tolerance; 0: none was tried. */
    NeedsTrial coarser_tolerance_trial; /**< That one. */

    NeedsTrial float_trial;           /**< Float against double, all else equal. */
    bool has_float_cause;             /**< Whether the next two are known. */
    NeedsTrial float_depth_0_trial;   /**< Float against double without any turn of a ray. */
    NeedsTrial float_unlit_trial;     /**< The same without lights and shadows. */
    double double_over_float_seconds; /**< Time of double over that of float. */

    NeedsTrial offset_trials[NEEDS_OFFSET_COUNT]; /**< Each ray offset against #OFFSET_BOUND. */
    double offset_ratio; /**< Time of the offset proposed over that of #OFFSET_BOUND; 0: no other is
                              both sufficient and faster. */

    NeedsNoise noise[NEEDS_NOISE_MAXIMUM]; /**< Noise, the least rays per pixel first. */
    int noise_count;                       /**< Number of #noise. */
    bool is_noise_sufficient;              /**< Whether #settings has enough rays per pixel. */

    NeedsCheck checks[NEEDS_CHECKS_MAXIMUM];                /**< The final checks. */
    int check_count;                                        /**< Number of #checks. */
    NeedsCorrection corrections[NEEDS_CORRECTIONS_MAXIMUM]; /**< In their order. */
    int correction_count;                                   /**< Number of #corrections. */

    const Engine *default_engine; /**< The engine of that number type that is taken by default. */
    double engine_ratio;          /**< Its time over that of the engine proposed. */
    double seconds; /**< Time on the clock of a whole picture with #settings; where it is large,
                         from a smaller picture. */
    double reference_ratio; /**< CPU time of #reference over that of #settings. */

    NeedsBudget budget; /**< With #NeedsRequest.budget_seconds. */
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

/** @return Whether more than #NEEDS_FRACTION_MAXIMUM of the pixels are off. */
bool needs_trial_fails(const NeedsTrial *trial);

/** @return Whether a check refutes the settings: they were not fine enough, and nothing is finer.
 */
bool needs_is_refuted(const Needs *needs);

/**
 * Explains needs in a paragraph for pupils.
 * @param needs      What a scene needs.
 * @param[out] text  The paragraph, in one line; cut to its size.
 * @param size       Bytes of it.
 */
void needs_explain(const Needs *needs, char *text, size_t size);

#endif
