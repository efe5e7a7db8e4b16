/**
 * @file
 * @brief Checks settings on a whole picture, finds by experiment which of them is to blame where it
 *        refutes them, and corrects that one.
 */
#include "base/language.h"
#include "lab/needs/search.h"

/** Largest picture that is checked against double. */
static const StageSize double_size = {320, 16};
/** Largest picture that is checked against quad. */
static const StageSize quad_size = {320, 1};
/** CPU time of their references, seconds. */
#define DOUBLE_SECONDS 4.0
/** See #DOUBLE_SECONDS; quad takes a hundred times as long as double. */
#define QUAD_SECONDS 10.0

/** @return Settings with one of them as in the reference. */
static NeedsSettings settings_with_reference(const Needs *needs, NeedsSetting setting) {
    NeedsSettings settings = needs->settings;
    const NeedsSettings *reference = &needs->reference;
    switch (setting) {
    case NEEDS_ENGINE:
        settings.engine = reference->engine;
        break;
    case NEEDS_DEPTH:
        settings.depth = reference->depth;
        break;
    case NEEDS_CUTOFF:
        settings.cutoff = reference->cutoff;
        break;
    case NEEDS_OFFSET:
        settings.offset = reference->offset;
        break;
    case NEEDS_TOLERANCE:
    case NEEDS_SETTING_COUNT:
        settings.tolerance = reference->tolerance;
        break;
    }
    return settings;
}

/** @return Whether a setting is coarser than in the reference. */
static bool setting_is_coarse(const Needs *needs, NeedsSetting setting) {
    const NeedsSettings *settings = &needs->settings, *reference = &needs->reference;
    const bool is_coarse[NEEDS_SETTING_COUNT] = {
        [NEEDS_ENGINE] = settings->engine->mantissa_bits < reference->engine->mantissa_bits,
        [NEEDS_DEPTH] = settings->depth < reference->depth,
        [NEEDS_CUTOFF] = needs->is_recursive && settings->cutoff > reference->cutoff,
        [NEEDS_OFFSET] = settings->offset != reference->offset,
        [NEEDS_TOLERANCE] = settings->tolerance > reference->tolerance};
    return is_coarse[setting];
}

/** Makes a setting one step finer. */
static void setting_refine(Needs *needs, NeedsSetting setting) {
    NeedsSettings *settings = &needs->settings;
    const NeedsSettings *reference = &needs->reference;
    if (setting == NEEDS_DEPTH) {
        int deeper = settings->depth + settings->depth / 2 + 1;
        settings->depth = deeper < reference->depth ? deeper : reference->depth;
    } else if (setting == NEEDS_CUTOFF && settings->cutoff / NEEDS_STEP > reference->cutoff) {
        settings->cutoff /= NEEDS_STEP;
    } else if (setting == NEEDS_TOLERANCE &&
               settings->tolerance / NEEDS_STEP > reference->tolerance) {
        settings->tolerance /= NEEDS_STEP;
    } else {
        *settings = settings_with_reference(needs, setting);
    }
}

/**
 * Finds which setting is to blame: the one with which as in the reference the fewest pixels are
 * off.
 * @param[in,out] correction  What is refuted; then what is to blame.
 * @param[out] is_any         Whether any setting can be finer.
 * @return false if anything is wrong.
 */
static bool find_blame(const NeedsSearch *search, const TrialStage *stage,
                       const TrialPicture *reference, NeedsCorrection *correction, bool *is_any,
                       Error *error) {
    *is_any = false;
    for (int i = 0; i < NEEDS_SETTING_COUNT; i++) {
        NeedsTrial trial;
        NeedsSettings settings = settings_with_reference(search->needs, (NeedsSetting)i);
        if (!setting_is_coarse(search->needs, (NeedsSetting)i)) {
            continue;
        }
        if (!trial_run(stage, &settings, reference, &trial, error)) {
            return false;
        }
        const NeedsTrial *best = &correction->without;
        if (!*is_any || trial.off < best->off ||
            (trial.off == best->off && trial.rms_steps < best->rms_steps)) {
            correction->setting = (NeedsSetting)i;
            correction->without = trial;
        }
        *is_any = true;
    }
    return true;
}

/** @param[out] is_better  Whether the finest settings leave fewer pixels off than a correction
 *                         began with. Where they do not, the number type of the reference is what
 *                         makes the difference. @return false if anything is wrong. */
static bool compare_finest(const NeedsSearch *search, const TrialStage *stage,
                           const TrialPicture *reference, const NeedsCorrection *correction,
                           bool *is_better, Error *error) {
    NeedsTrial trial;
    if (!trial_run(stage, &search->needs->reference, reference, &trial, error)) {
        return false;
    }
    *is_better = trial.off < correction->trial.off;
    return true;
}

/** Checks the settings against a picture and corrects them. @return false if anything is wrong. */
static bool check_against(NeedsSearch *search, const TrialStage *stage,
                          const TrialPicture *reference, NeedsTrial *trial, Error *error) {
    Needs *needs = search->needs;
    while (true) {
        bool is_any = false;
        if (!trial_run(stage, &needs->settings, reference, trial, error)) {
            return false;
        }
        if (!needs_trial_fails(trial) || needs->correction_count == NEEDS_CORRECTIONS_MAXIMUM) {
            return true;
        }
        NeedsCorrection correction = {.before = needs->settings, .trial = *trial};
        if (!find_blame(search, stage, reference, &correction, &is_any, error)) {
            return false;
        }
        // Two settings may be to blame, and neither alone.
        if (is_any && correction.without.off >= correction.trial.off &&
            !compare_finest(search, stage, reference, &correction, &is_any, error)) {
            return false;
        }
        if (!is_any) {
            return true;
        }
        setting_refine(needs, correction.setting);
        needs->corrections[needs->correction_count++] = correction;
    }
}

/** Checks the settings against a reference. @return false if anything is wrong. */
static bool check_with(NeedsSearch *search, const TrialStage *stage, const NeedsSettings *reference,
                       Error *error) {
    Needs *needs = search->needs;
    TrialPicture picture;
    NeedsCheck check = {.reference = reference->engine,
                        .width = stage->width,
                        .height = stage->height,
                        .samples = stage->samples < reference->samples ? stage->samples
                                                                       : reference->samples};
    if (!trial_render(stage, reference, &picture, error)) {
        return false;
    }
    bool is_done = check_against(search, stage, &picture, &check.trial, error);
    trial_picture_deinit(&picture);
    needs->checks[needs->check_count++] = check;
    return is_done;
}

/** Compares float with double, all else equal. @return false if anything is wrong. */
static bool compare_types(const TrialStage *stage, NeedsSettings settings, NeedsTrial *trial,
                          Error *error) {
    TrialPicture doubles;
    settings.engine = engine_with_role(ENGINE_DOUBLE);
    if (!trial_render(stage, &settings, &doubles, error)) {
        return false;
    }
    settings.engine = engine_with_role(ENGINE_FASTEST);
    bool is_done = trial_run(stage, &settings, &doubles, trial, error);
    trial_picture_deinit(&doubles);
    return is_done;
}

/** Measures what float leaves, and where that comes from: without turns of rays, and without lights
 *  too. @return false if anything is wrong. */
static bool measure_float(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    if (!compare_types(&search->check_stage, needs->settings, &needs->float_trial, error)) {
        return false;
    }
    if (!needs_trial_fails(&needs->float_trial)) {
        return true;
    }
    NeedsSettings straight = needs->settings;
    TrialStage unlit = search->check_stage;
    straight.depth = 0;
    unlit.lighting = LIGHTING_UNLIT;
    needs->has_float_cause = true;
    return compare_types(&search->check_stage, straight, &needs->float_depth_0_trial, error) &&
           compare_types(&unlit, straight, &needs->float_unlit_trial, error);
}

/** Checks settings in double against quad. @return false if anything is wrong. */
static bool check_double(NeedsSearch *search, Error *error) {
    NeedsSettings reference = search->needs->reference;
    double ray_seconds;
    reference.engine = engine_with_role(ENGINE_REFERENCE);
    if (!reference.engine) {
        return true;
    }
    search_report(search, N_("a check against quad"));
    if (!search_probe_cost(search, &reference, &ray_seconds, error)) {
        return false;
    }
    TrialStage stage = search_stage(search, quad_size, ray_seconds, QUAD_SECONDS);
    return check_with(search, &stage, &reference, error);
}

bool search_check(NeedsSearch *search, Error *error) {
    const Needs *needs = search->needs;
    search->check_stage = search_stage(search, double_size, search->ray_seconds, DOUBLE_SECONDS);
    search_report(search, N_("a check on a whole picture"));
    if (!check_with(search, &search->check_stage, &needs->reference, error)) {
        return false;
    }
    bool is_float = needs->settings.engine->mantissa_bits < needs->reference.engine->mantissa_bits;
    return (is_float || check_double(search, error)) && measure_float(search, error);
}
