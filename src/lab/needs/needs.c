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
#define TRIAL_SECONDS 0.5

/** Width of the picture that shows how long a ray takes. */
enum { PROBE_WIDTH = 40 };

/** Coarsest factor of tolerances that is tried. */
#define TOLERANCE_COARSEST 1024.0
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
    TrialTime time;
    if (!trial_time_processor(&stage, settings, 1, 1, &time, error)) {
        return false;
    }
    *ray_seconds = time.cpu_least / ((double)stage.width * stage.height);
    return true;
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
        needs->shallower_trial = needs->depth_trial;
        high = high ? 2 * high : 1;
    }
    while (high - low > 1) {
        NeedsTrial trial;
        int middle = (low + high) / 2;
        if (!try_depth(search, middle, reference, &trial, error)) {
            return false;
        }
        bool fails = needs_trial_fails(&trial);
        *(fails ? &low : &high) = middle;
        *(fails ? &needs->shallower_trial : &needs->depth_trial) = trial;
    }
    needs->settings.depth = high;
    return needs->scene_depth < 0 ||
           try_depth(search, needs->scene_depth, reference, &needs->scene_depth_trial, error);
}

/** Measures what a depth found by a check leaves out. @return false if anything is wrong. */
static bool measure_depth(NeedsSearch *search, const TrialPicture *reference, Error *error) {
    Needs *needs = search->needs;
    return try_depth(search, needs->settings.depth, reference, &needs->depth_trial, error) &&
           try_depth(search, needs->settings.depth - 1, reference, &needs->shallower_trial, error);
}

/* --- cutoff and tolerance -----------------------------------------------------------------------
 */

/** How often settings are timed. */
enum { TURNS = 5 };

/** @return Where a number stands in settings. @param setting #NEEDS_CUTOFF or #NEEDS_TOLERANCE. */
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

/** What is known of a number. */
typedef struct NumberTrials {
    NeedsTrial *trial;         /**< What it leaves. */
    double *coarser;           /**< The next coarser number. */
    NeedsTrial *coarser_trial; /**< What that leaves. */
} NumberTrials;

/** @return Where the trials of a number stand. */
static NumberTrials trials_of(Needs *needs, NeedsSetting setting) {
    return setting == NEEDS_CUTOFF
               ? (NumberTrials){&needs->cutoff_trial, &needs->coarser_cutoff,
                                &needs->coarser_cutoff_trial}
               : (NumberTrials){&needs->tolerance_trial, &needs->coarser_tolerance,
                                &needs->coarser_tolerance_trial};
}

/** Finds the coarsest sufficient number. @param setting With a number that is sufficient. @return
 *  false if anything is wrong. */
static bool find_coarsest(NeedsSearch *search, NeedsSetting setting, double coarsest,
                          const TrialPicture *reference, Error *error) {
    double *found = number_of(&search->needs->settings, setting);
    NumberTrials trials = trials_of(search->needs, setting);
    while (true) {
        *trials.coarser = NEEDS_STEP * *found;
        if (!try_number(search, setting, *trials.coarser, reference, trials.coarser_trial, error)) {
            return false;
        }
        if (needs_trial_fails(trials.coarser_trial) || *trials.coarser > coarsest) {
            return true;
        }
        *found = *trials.coarser;
        *trials.trial = *trials.coarser_trial;
    }
}

/** Measures what a number leaves, and the next coarser one. @return false if anything is wrong. */
static bool measure_number(NeedsSearch *search, NeedsSetting setting, const TrialPicture *reference,
                           Error *error) {
    NumberTrials trials = trials_of(search->needs, setting);
    double value = *number_of(&search->needs->settings, setting);
    *trials.coarser = NEEDS_STEP * value;
    return try_number(search, setting, value, reference, trials.trial, error) &&
           try_number(search, setting, *trials.coarser, reference, trials.coarser_trial, error);
}

/** Finds the coarsest sufficient number, and takes it if that saves time. @return false if anything
 *  is wrong. */
static bool find_coarser(NeedsSearch *search, NeedsSetting setting, double coarsest,
                         const TrialPicture *reference, Error *error) {
    NeedsSettings *settings = &search->needs->settings, tried[2] = {*settings, *settings};
    TrialTime times[2];
    if (!find_coarsest(search, setting, coarsest, reference, error)) {
        return false;
    }
    tried[1] = *settings;
    if (*number_of(&tried[0], setting) == *number_of(&tried[1], setting)) {
        return true;
    }
    if (!trial_time_processor(&search->stage, tried, 2, TURNS, times, error)) {
        return false;
    }
    if (trial_time_is_faster(&times[1], &times[0])) {
        return true;
    }
    *settings = tried[0];
    return measure_number(search, setting, reference, error);
}

/** Finds the cutoff. @return false if anything is wrong. */
static bool find_cutoff(NeedsSearch *search, const TrialPicture *reference, Error *error) {
    Needs *needs = search->needs;
    for (double value = CUTOFF_DEFAULT; value > needs->reference.cutoff; value /= NEEDS_STEP) {
        NeedsTrial trial;
        if (!try_number(search, NEEDS_CUTOFF, value, reference, &trial, error)) {
            return false;
        }
        if (!needs_trial_fails(&trial)) {
            needs->settings.cutoff = value;
            needs->cutoff_trial = trial;
            return value < CUTOFF_DEFAULT ||
                   find_coarser(search, NEEDS_CUTOFF, CUTOFF_COARSEST, reference, error);
        }
        needs->coarser_cutoff = value;
        needs->coarser_cutoff_trial = trial;
    }
    needs->settings.cutoff = needs->reference.cutoff;
    return measure_number(search, NEEDS_CUTOFF, reference, error);
}

/** Finds whether the scene's own tolerances are sufficient, or finer ones. Where none is, as on the
 *  edges of fractals, the scene's own are the reference. @return false if anything is wrong. */
static bool find_fine_tolerance(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    TrialPicture finest;
    bool is_done = true;
    needs->reference.tolerance = REFERENCE_TOLERANCE;
    if (!trial_render(&search->stage, &needs->reference, &finest, error)) {
        return false;
    }
    for (double value = 1;
         is_done && !needs->is_tolerance_sufficient && value > REFERENCE_TOLERANCE;
         value /= NEEDS_STEP) {
        NeedsTrial trial;
        is_done = try_number(search, NEEDS_TOLERANCE, value, &finest, &trial, error);
        if (value == 1) {
            needs->own_tolerance_trial = trial;
        }
        needs->finest_tolerance = value;
        needs->finest_tolerance_trial = trial;
        needs->is_tolerance_sufficient = !needs_trial_fails(&trial);
        needs->settings.tolerance = needs->is_tolerance_sufficient ? value : 1;
    }
    trial_picture_deinit(&finest);
    needs->reference.tolerance = needs->is_tolerance_sufficient ? REFERENCE_TOLERANCE : 1;
    return is_done;
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
    Needs *needs = search->needs;
    NeedsSettings tried[NEEDS_OFFSET_COUNT];
    TrialTime times[NEEDS_OFFSET_COUNT];
    TrialPicture bound;
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
    if (!trial_time_processor(&search->stage, tried, NEEDS_OFFSET_COUNT, TURNS, times, error)) {
        return false;
    }
    for (int i = 0; i < OFFSET_BOUND; i++) {
        double ratio = times[i].cpu_least / times[OFFSET_BOUND].cpu_least;
        if (!needs_trial_fails(&needs->offset_trials[i]) &&
            trial_time_is_faster(&times[i], &times[OFFSET_BOUND]) &&
            (needs->offset_ratio == 0 || ratio < needs->offset_ratio)) {
            needs->offset_ratio = ratio;
            needs->settings.offset = (OffsetStrategy)i;
        }
    }
    return true;
}

/* --- all of it ----------------------------------------------------------------------------------
 */

/** Finds depth, cutoff and tolerance. @return false if anything is wrong. */
static bool find_model(NeedsSearch *search, const TrialPicture *reference, Error *error) {
    const Needs *needs = search->needs;
    bool is_fine = needs->has_sdf && needs->settings.tolerance < 1;
    return (!needs->is_recursive ||
            (find_depth(search, reference, error) && find_cutoff(search, reference, error))) &&
           (!needs->has_sdf || is_fine ||
            find_coarser(search, NEEDS_TOLERANCE, TOLERANCE_COARSEST, reference, error)) &&
           (!is_fine || measure_number(search, NEEDS_TOLERANCE, reference, error));
}

bool search_settings(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    TrialPicture reference;
    needs->settings = needs->reference;
    needs->settings.tolerance = 1;
    needs->settings.cutoff = CUTOFF_DEFAULT;
    needs->settings.depth = 0;
    search_report(search, N_("depth and tolerances"));
    if ((needs->has_sdf && !find_fine_tolerance(search, error)) ||
        !trial_render(&search->stage, &needs->reference, &reference, error)) {
        return false;
    }
    bool is_done = find_model(search, &reference, error);
    trial_picture_deinit(&reference);
    search_report(search, N_("number type and offset"));
    return is_done && find_number_type(search, error) && find_offset(search, error);
}

/** Measures what corrected settings leave out, each by itself. @return false if anything is wrong.
 */
static bool measure_corrected(NeedsSearch *search, Error *error) {
    const Needs *needs = search->needs;
    bool is_corrected[NEEDS_SETTING_COUNT] = {false};
    TrialPicture reference;
    for (int i = 0; i < needs->correction_count; i++) {
        is_corrected[needs->corrections[i].setting] = true;
    }
    if (!is_corrected[NEEDS_DEPTH] && !is_corrected[NEEDS_CUTOFF] &&
        !is_corrected[NEEDS_TOLERANCE]) {
        return true;
    }
    if (!trial_render(&search->stage, &needs->reference, &reference, error)) {
        return false;
    }
    bool is_done =
        (!is_corrected[NEEDS_DEPTH] || measure_depth(search, &reference, error)) &&
        (!is_corrected[NEEDS_CUTOFF] || measure_number(search, NEEDS_CUTOFF, &reference, error)) &&
        (!is_corrected[NEEDS_TOLERANCE] ||
         measure_number(search, NEEDS_TOLERANCE, &reference, error));
    trial_picture_deinit(&reference);
    return is_done;
}

/** @return Everything on, in double. */
static NeedsSettings reference_settings(const Needs *needs) {
    return (NeedsSettings){.engine = engine_with_role(ENGINE_DOUBLE),
                           .depth = needs->is_recursive ? REFERENCE_DEPTH : 0,
                           .cutoff = REFERENCE_CUTOFF_COARSEST,
                           .offset = OFFSET_BOUND,
                           .samples = needs->asked_samples,
                           .tolerance = needs->has_sdf ? REFERENCE_TOLERANCE : 1};
}

/**
 * Makes the cutoff of the reference as fine as time allows. No cutoff at all would follow rays that
 * two panes of glass split without end.
 * @return false if anything is wrong.
 */
static bool refine_reference(NeedsSearch *search, Error *error) {
    /** From a cutoff to the next, how many times the time of a ray may be spent on it, and CPU time
     *  of a ray, seconds, from which on it is slow already. */
    const double step = 16, patience = 2, slow = 2e-4;
    NeedsSettings *reference = &search->needs->reference, finer = *reference;
    double first = 0, seconds = 0;
    if (!search_probe_cost(search, reference, &first, error)) {
        return false;
    }
    search->ray_seconds = first;
    while (search->needs->is_recursive && finer.cutoff > REFERENCE_CUTOFF_FINEST && first < slow) {
        finer.cutoff /= step;
        if (!search_probe_cost(search, &finer, &seconds, error)) {
            return false;
        }
        if (seconds > patience * first) {
            break;
        }
        reference->cutoff = finer.cutoff;
        search->ray_seconds = seconds;
    }
    return true;
}

bool needs_find(const Scene *scene, const NeedsRequest *request, Needs *needs, Error *error) {
    *needs = (Needs){.forecast = precision_estimate_of(scene),
                     .error_steps = request->error_steps,
                     .is_recursive = scene_has_secondary_rays(scene),
                     .has_sdf = scene_has_tolerances(scene),
                     .asked_samples = request->samples,
                     .scene_depth = request->depth};
    needs->reference = reference_settings(needs);
    NeedsSearch search = {.scene = scene, .request = request, .needs = needs};
    if (!refine_reference(&search, error)) {
        return false;
    }
    search.stage = search_stage(&search, trial_size, search.ray_seconds, TRIAL_SECONDS);
    needs->width = search.stage.width;
    needs->height = search.stage.height;
    needs->samples =
        search.stage.samples < request->samples ? search.stage.samples : request->samples;
    return search_settings(&search, error) && search_check(&search, error) &&
           measure_corrected(&search, error) && search_samples(&search, error) &&
           search_costs(&search, error) &&
           (request->budget_seconds == 0 || search_budget(&search, error));
}
