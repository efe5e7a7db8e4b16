/**
 * @file
 * @brief Finds what a scene needs: each setting by itself, on a whole small picture.
 */
#include "lab/needs/needs.h"

#include "base/language.h"
#include "lab/needs/scaled_tolerance.h"
#include "lab/needs/search.h"

/** Largest pictures on which single settings are tried. */
static const StageSize trial_size = {160, 4};
/** CPU time of the reference of those, seconds: some twenty pictures are tried, most of them
 *  faster. */
#define TRIAL_SECONDS 1.5

/** Width of the picture that shows how long a ray takes. */
enum { PROBE_WIDTH = 40 };

/** Coarsest factor of tolerances that is tried. */
#define TOLERANCE_MAXIMUM 1024.0
/** Coarsest cutoff that is tried. */
#define CUTOFF_COARSEST (64 * CUTOFF_DEFAULT)

bool needs_trial_fails(const NeedsTrial *trial) {
    return (double)trial->off > NEEDS_FRACTION_MAXIMUM * (double)trial->pixels;
}

bool needs_is_refuted(const Needs *needs) {
    bool is_refuted = false;
    for (int i = 0; i < needs->check_count; i++) {
        is_refuted = is_refuted || needs_trial_fails(&needs->checks[i].trial);
    }
    return is_refuted;
}

void search_report(const NeedsSearch *search, const char *what) {
    if (search->request->report) {
        search->request->report(search->request->context, what);
    }
}

/* --- stages -------------------------------------------------------------------------------------
 */

/** @return A stage of a size, no larger than what is asked for. */
static TrialStage stage_of(const NeedsSearch *search, StageSize size) {
    const NeedsRequest *request = search->request;
    int width = size.width < request->width ? size.width : request->width;
    int height = (int)((int64_t)request->height * width / request->width);
    return (TrialStage){.scene = search->scene,
                        .trace = request->trace,
                        .width = width,
                        .height = height > 0 ? height : 1,
                        .samples = size.samples,
                        .threads = request->threads,
                        .lighting = LIGHTING_FULL,
                        .error_steps = request->error_steps,
                        .stop = request->stop};
}

TrialStage search_stage(const NeedsSearch *search, StageSize largest, double ray_seconds,
                        double limit) {
    static const StageSize sizes[] = {{320, 16}, {320, 4}, {320, 1}, {160, 4},
                                      {160, 1},  {80, 1},  {40, 1}};
    enum { SIZE_COUNT = sizeof sizes / sizeof *sizes };
    TrialStage stage = stage_of(search, sizes[SIZE_COUNT - 1]);
    for (size_t i = 0; i < SIZE_COUNT; i++) {
        TrialStage larger = stage_of(search, sizes[i]);
        int asked = search->request->samples;
        int samples = asked < sizes[i].samples ? asked : sizes[i].samples;
        if (sizes[i].width <= largest.width && sizes[i].samples <= largest.samples &&
            ray_seconds * larger.width * larger.height * samples <= limit) {
            return larger;
        }
    }
    return stage;
}

bool search_probe_cost(const NeedsSearch *search, const NeedsSettings *settings,
                       double *ray_seconds, Error *error) {
    TrialStage stage = stage_of(search, (StageSize){PROBE_WIDTH, 1});
    return trial_time(&stage, settings, 1, 1, ray_seconds, NULL, error) &&
           (*ray_seconds /= (double)stage.width * stage.height, true);
}

/* --- depth --------------------------------------------------------------------------------------
 */

/** Tries a depth, all else as in the reference. @return false if anything is wrong. */
static bool try_depth(const NeedsSearch *search, int depth, const TrialPicture *reference,
                      NeedsTrial *trial, Error *error) {
    NeedsSettings settings = search->needs->reference;
    settings.depth = depth;
    return trial_run(&search->stage, &settings, reference, trial, error);
}

/** Finds the least sufficient depth: by doubling, then by bisection. @return false if anything is
 *  wrong. */
static bool find_depth(NeedsSearch *search, const TrialPicture *reference, Error *error) {
    Needs *needs = search->needs;
    int low = -1, high = 0;
    while (true) {
        if (!try_depth(search, high, reference, &needs->depth_trial, error)) {
            return false;
        }
        if (!needs_trial_fails(&needs->depth_trial) || high >= REFERENCE_DEPTH) {
            break;
        }
        low = high;
        high = high ? 2 * high : 1;
    }
    while (high - low > 1) {
        NeedsTrial trial;
        int middle = (low + high) / 2;
        if (!try_depth(search, middle, reference, &trial, error)) {
            return false;
        }
        *(needs_trial_fails(&trial) ? &low : &high) = middle;
    }
    needs->settings.depth = high;
    return true;
}

/** Measures what the depth found leaves out. @return false if anything is wrong. */
static bool measure_depth(NeedsSearch *search, const TrialPicture *reference, Error *error) {
    Needs *needs = search->needs;
    return try_depth(search, needs->settings.depth, reference, &needs->depth_trial, error) &&
           (needs->settings.depth == 0 || try_depth(search, needs->settings.depth - 1, reference,
                                                    &needs->shallower_trial, error)) &&
           (needs->scene_depth < 0 || try_depth(search, needs->scene_depth, reference,
                                                &needs->scene_depth_trial, error));
}

/* --- cutoff and tolerance -----------------------------------------------------------------------
 */

/** A setting that is a number, of which less is finer. */
typedef struct NumberSetting {
    NeedsSetting setting; /**< Which. */
    double start;         /**< Tried first. */
    double finest;        /**< The reference's. */
    double coarsest;      /**< Tried last. */
} NumberSetting;

/** @return Where a number stands in settings. */
static double *number_of(NeedsSettings *settings, NeedsSetting setting) {
    return setting == NEEDS_CUTOFF ? &settings->cutoff : &settings->tolerance;
}

/** Tries a number, all else as in the reference. @return false if anything is wrong. */
static bool try_number(const NeedsSearch *search, NeedsSetting setting, double value,
                       const TrialPicture *reference, NeedsTrial *trial, Error *error) {
    NeedsSettings settings = search->needs->reference;
    *number_of(&settings, setting) = value;
    return trial_run(&search->stage, &settings, reference, trial, error);
}

/** Finds the coarsest sufficient number. @return false if anything is wrong. */
static bool find_number(NeedsSearch *search, NumberSetting number, const TrialPicture *reference,
                        Error *error) {
    NeedsTrial trial;
    double value = number.start, *found = number_of(&search->needs->settings, number.setting);
    *found = number.finest;
    // Finer while it fails, else coarser until it fails.
    while (true) {
        if (!try_number(search, number.setting, value, reference, &trial, error)) {
            return false;
        }
        if (needs_trial_fails(&trial)) {
            if (*found != number.finest || value / NEEDS_STEP <= number.finest) {
                return true;
            }
            value /= NEEDS_STEP;
            number.coarsest = value;
        } else {
            *found = value;
            if (value * NEEDS_STEP > number.coarsest) {
                return true;
            }
            value *= NEEDS_STEP;
        }
    }
}

/** Measures what a number leaves, and the next coarser one. @return false if anything is wrong. */
static bool measure_number(NeedsSearch *search, NeedsSetting setting,
                           const TrialPicture *reference, Error *error) {
    Needs *needs = search->needs;
    bool is_cutoff = setting == NEEDS_CUTOFF;
    NeedsTrial *trial = is_cutoff ? &needs->cutoff_trial : &needs->tolerance_trial;
    NeedsTrial *coarser = is_cutoff ? &needs->coarser_cutoff_trial : &needs->coarser_tolerance_trial;
    double value = *number_of(&needs->settings, setting), above = NEEDS_STEP * value;
    *(is_cutoff ? &needs->coarser_cutoff : &needs->coarser_tolerance) = above;
    return try_number(search, setting, value, reference, trial, error) &&
           try_number(search, setting, above, reference, coarser, error);
}

/* --- number type and offset ---------------------------------------------------------------------
 */

/** Finds the number type. @return false if anything is wrong. */
static bool find_number_type(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    NeedsSettings floats = needs->settings;
    TrialPicture doubles;
    NeedsTrial trial;
    floats.engine = engine_with_role(ENGINE_FASTEST);
    if (!trial_render(&search->stage, &needs->settings, &doubles, error)) {
        return false;
    }
    bool is_done = trial_run(&search->stage, &floats, &doubles, &trial, error);
    if (is_done && !needs_trial_fails(&trial)) {
        needs->settings.engine = floats.engine;
    }
    trial_picture_deinit(&doubles);
    return is_done;
}

/** Finds the ray offset: another than #OFFSET_BOUND only if it is faster. @return false if anything
 *  is wrong. */
static bool find_offset(NeedsSearch *search, Error *error) {
    /** How often offsets are timed, and the fraction of time that noise does not feign. */
    enum { TURNS = 5 };
    const double faster = 0.95;
    Needs *needs = search->needs;
    NeedsSettings tried[NEEDS_OFFSET_COUNT];
    double seconds[NEEDS_OFFSET_COUNT];
    TrialPicture bound;
    needs->fastest_offset = OFFSET_BOUND;
    if (!trial_render(&search->stage, &needs->settings, &bound, error)) {
        return false;
    }
    bool is_done = true, is_any_sufficient = false;
    for (int i = 0; is_done && i < NEEDS_OFFSET_COUNT; i++) {
        tried[i] = needs->settings;
        tried[i].offset = (OffsetStrategy)i;
        is_done = trial_run(&search->stage, &tried[i], &bound, &needs->offset_trials[i], error);
        is_any_sufficient =
            is_any_sufficient || (i < OFFSET_BOUND && !needs_trial_fails(&needs->offset_trials[i]));
    }
    trial_picture_deinit(&bound);
    if (!is_done || !is_any_sufficient) {
        return is_done;
    }
    if (!trial_time(&search->stage, tried, NEEDS_OFFSET_COUNT, TURNS, seconds, NULL, error)) {
        return false;
    }
    for (int i = 0; i < OFFSET_BOUND; i++) {
        double ratio = seconds[i] / seconds[OFFSET_BOUND];
        if (!needs_trial_fails(&needs->offset_trials[i]) &&
            (needs->offset_ratio == 0 || ratio < needs->offset_ratio)) {
            needs->offset_ratio = ratio;
            needs->fastest_offset = (OffsetStrategy)i;
        }
    }
    needs->settings.offset = needs->offset_ratio < faster ? needs->fastest_offset : OFFSET_BOUND;
    return true;
}

/* --- all of it ----------------------------------------------------------------------------------
 */

/** Finds depth, cutoff and tolerance. @return false if anything is wrong. */
static bool find_model(NeedsSearch *search, const TrialPicture *reference, Error *error) {
    Needs *needs = search->needs;
    const NumberSetting cutoff = {NEEDS_CUTOFF, CUTOFF_DEFAULT, needs->reference.cutoff,
                                  CUTOFF_COARSEST};
    const NumberSetting tolerance = {NEEDS_TOLERANCE, 1, REFERENCE_TOLERANCE, TOLERANCE_MAXIMUM};
    return (!needs->is_recursive || (find_depth(search, reference, error) &&
                                     find_number(search, cutoff, reference, error))) &&
           (!needs->has_sdf || find_number(search, tolerance, reference, error));
}

bool search_settings(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    TrialPicture reference;
    needs->settings = needs->reference;
    needs->settings.tolerance = 1;
    needs->settings.cutoff = CUTOFF_DEFAULT;
    needs->settings.depth = 0;
    search_report(search, N_("depth and tolerances"));
    if (!trial_render(&search->stage, &needs->reference, &reference, error)) {
        return false;
    }
    bool is_done = find_model(search, &reference, error);
    trial_picture_deinit(&reference);
    search_report(search, N_("number type and offset"));
    return is_done && find_number_type(search, error) && find_offset(search, error);
}

/** Measures what the settings found leave out, each by itself. @return false if anything is wrong.
 */
static bool measure_settings(NeedsSearch *search, Error *error) {
    const Needs *needs = search->needs;
    TrialPicture reference;
    if (!trial_render(&search->stage, &needs->reference, &reference, error)) {
        return false;
    }
    bool is_done = (!needs->is_recursive ||
                    (measure_depth(search, &reference, error) &&
                     measure_number(search, NEEDS_CUTOFF, &reference, error))) &&
                   (!needs->has_sdf || measure_number(search, NEEDS_TOLERANCE, &reference, error));
    trial_picture_deinit(&reference);
    return is_done;
}

/** @return Everything on, in double. */
static NeedsSettings reference_settings(const Needs *needs) {
    return (NeedsSettings){.engine = engine_with_role(ENGINE_DOUBLE),
                           .depth = needs->is_recursive ? REFERENCE_DEPTH : 0,
                           .cutoff = REFERENCE_CUTOFF,
                           .offset = OFFSET_BOUND,
                           .samples = needs->asked_samples,
                           .tolerance = needs->has_sdf ? REFERENCE_TOLERANCE : 1};
}

bool needs_find(const Scene *scene, const NeedsRequest *request, Needs *needs, Error *error) {
    *needs = (Needs){.forecast = precision_estimate_of(scene),
                     .error_steps = request->error_steps,
                     .is_recursive = scene_has_reflection(scene) || scene_has_transparency(scene),
                     .has_sdf = scene_has_tolerances(scene),
                     .asked_samples = request->samples,
                     .scene_depth = request->depth};
    needs->reference = reference_settings(needs);
    NeedsSearch search = {.scene = scene, .request = request, .needs = needs};
    if (!search_probe_cost(&search, &needs->reference, &search.ray_seconds, error)) {
        return false;
    }
    search.stage = search_stage(&search, trial_size, search.ray_seconds, TRIAL_SECONDS);
    needs->width = search.stage.width;
    needs->height = search.stage.height;
    needs->samples = search.stage.samples < request->samples ? search.stage.samples : request->samples;
    return search_settings(&search, error) && search_check(&search, error) &&
           measure_settings(&search, error) && search_samples(&search, error) &&
           search_costs(&search, error) &&
           (request->budget_seconds == 0 || search_budget(&search, error));
}
