/**
 * @file
 * @brief Finds the best picture within a time.
 *
 * Coarser settings and numbers of rays per pixel are combined. What a combination costs and how far
 * it is off is estimated from small pictures: the mean square errors of settings and of noise add
 * up. The best combination that fits is timed as a whole picture; if it is too slow, or much faster
 * than need be, the estimates are scaled and another one is taken.
 */
#include "base/language.h"
#include "lab/needs/search.h"

#include <math.h>
#include <stdlib.h>

/** Most rays per pixel of the reference, and the least. */
enum { REFERENCE_SAMPLES_MAXIMUM = 128, REFERENCE_SAMPLES_MINIMUM = 8 };
/** CPU time of the reference, seconds. */
#define REFERENCE_SECONDS 6.0
/** How often the time of a combination may correct the estimates. */
enum { ATTEMPTS_MAXIMUM = 6 };
/** Fraction of the budget below which a finer combination is looked for. */
#define BUDGET_USED 0.8
/** Errors that differ by less than this factor are alike: the faster combination is taken. */
#define EQUAL_ERROR 1.02

/** Numbers of rays per pixel. */
static const int sample_counts[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};
/** Number of #sample_counts. */
enum { SAMPLE_COUNTS = sizeof sample_counts / sizeof *sample_counts };
/** Depths below the one that is sufficient. */
static const int depths[] = {0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128};
/** Number of #depths. */
enum { DEPTHS = sizeof depths / sizeof *depths };
/** Factors of cutoffs and tolerances. */
static const double coarser_factors[] = {1, NEEDS_STEP, NEEDS_STEP *NEEDS_STEP};
/** Number of #coarser_factors. */
enum { FACTORS = sizeof coarser_factors / sizeof *coarser_factors };
/** Most settings without rays per pixel: two number types, depths, cutoffs and tolerances. */
enum { MODELS_MAXIMUM = 2 * (DEPTHS + 1) * FACTORS * FACTORS };

/** Settings with one ray per pixel. */
typedef struct Model {
    NeedsSettings settings; /**< They. */
    double seconds;         /**< Estimated time of the whole picture. */
    double rms_steps;       /**< Error without noise. */
} Model;

/** A search for the best picture. */
typedef struct BudgetSearch {
    NeedsSearch *search;         /**< What the scene needs. */
    TrialStage stage;            /**< The pictures that are compared. */
    Model *models;               /**< The settings; owned. */
    size_t model_count;          /**< Number of #models. */
    double noise[SAMPLE_COUNTS]; /**< Error by noise of each number of rays, 8-bit steps. */
    int sample_count;            /**< Numbers of rays that are tried. */
    double time_factor;          /**< Measured over estimated time. */
    TrialPicture reference;      /**< The sufficient settings with many rays; owned. */
} BudgetSearch;

/** A combination of settings and rays per pixel. */
typedef struct Choice {
    const Model *model; /**< NULL: none. */
    int samples;        /**< Index in #sample_counts. */
    double rms_steps;   /**< Estimated error. */
    double seconds;     /**< Estimated time. */
} Choice;

/* --- what there is to choose from ----------------------------------------------------------------
 */

/** Adds settings. */
static void add_model(BudgetSearch *budget, const NeedsSettings *settings) {
    budget->models[budget->model_count] = (Model){.settings = *settings};
    budget->models[budget->model_count++].settings.samples = 1;
}

/** Adds settings with coarser cutoffs and tolerances. */
static void add_factors(BudgetSearch *budget, NeedsSettings settings) {
    const Needs *needs = budget->search->needs;
    const double cutoff = settings.cutoff, tolerance = settings.tolerance;
    int cutoffs = needs->is_recursive && settings.depth > 0 ? FACTORS : 1;
    int tolerances = needs->has_sdf ? FACTORS : 1;
    for (int i = 0; i < cutoffs; i++) {
        for (int k = 0; k < tolerances; k++) {
            settings.cutoff = coarser_factors[i] * cutoff;
            settings.tolerance = coarser_factors[k] * tolerance;
            add_model(budget, &settings);
        }
    }
}

/** Adds all settings of a number type. */
static void add_models(BudgetSearch *budget, const Engine *engine) {
    NeedsSettings settings = budget->search->needs->settings;
    int sufficient = settings.depth;
    settings.engine = engine;
    for (int i = 0; i < DEPTHS && depths[i] < sufficient; i++) {
        settings.depth = depths[i];
        add_factors(budget, settings);
    }
    settings.depth = sufficient;
    add_factors(budget, settings);
}

/** Measures time and error of all settings, with one ray per pixel. @return false if anything is
 *  wrong. */
static bool measure_models(BudgetSearch *budget, Error *error) {
    const NeedsRequest *request = budget->search->request;
    TrialStage stage = budget->stage;
    NeedsSettings sufficient = budget->search->needs->settings;
    TrialPicture base;
    double scale = (double)request->width * request->height / ((double)stage.width * stage.height);
    sufficient.samples = 1;
    if (!trial_render(&stage, &sufficient, &base, error)) {
        return false;
    }
    bool is_done = true;
    for (size_t i = 0; is_done && i < budget->model_count; i++) {
        Model *model = &budget->models[i];
        TrialPicture picture;
        is_done = trial_render(&stage, &model->settings, &picture, error);
        if (is_done) {
            model->rms_steps = trial_compare(&stage, &picture, &base).rms_steps;
            model->seconds = scale * picture.seconds;
            trial_picture_deinit(&picture);
        }
    }
    trial_picture_deinit(&base);
    return is_done;
}

/** Measures the noise of all numbers of rays. @return false if anything is wrong. */
static bool measure_noise(BudgetSearch *budget, Error *error) {
    NeedsSettings settings = budget->search->needs->settings;
    int most = budget->search->needs->budget.reference_samples / 2;
    for (int i = 0; i < SAMPLE_COUNTS && sample_counts[i] <= most; i++) {
        NeedsTrial trial;
        settings.samples = sample_counts[i];
        if (!trial_run(&budget->stage, &settings, &budget->reference, &trial, error)) {
            return false;
        }
        budget->noise[budget->sample_count++] = trial.rms_steps;
    }
    return true;
}

/* --- the choice ---------------------------------------------------------------------------------
 */

/** @return Whether a combination is to be preferred. */
static bool choice_is_better(const Choice *a, const Choice *b) {
    bool is_alike =
        a->rms_steps <= EQUAL_ERROR * b->rms_steps && b->rms_steps <= EQUAL_ERROR * a->rms_steps;
    return !b->model || (is_alike ? a->seconds < b->seconds : a->rms_steps < b->rms_steps);
}

/** @return The best combination that fits by the estimates. */
static Choice best_choice(const BudgetSearch *budget) {
    Choice best = {0};
    for (size_t i = 0; i < budget->model_count; i++) {
        const Model *model = &budget->models[i];
        for (int k = 0; k < budget->sample_count; k++) {
            Choice choice = {model, k, hypot(model->rms_steps, budget->noise[k]),
                             budget->time_factor * model->seconds * sample_counts[k]};
            if (choice.seconds <= budget->search->request->budget_seconds &&
                choice_is_better(&choice, &best)) {
                best = choice;
            }
        }
    }
    return best;
}

/** @return The fastest combination. */
static Choice fastest_choice(const BudgetSearch *budget) {
    const Model *fastest = budget->models;
    for (size_t i = 1; i < budget->model_count; i++) {
        fastest = budget->models[i].seconds < fastest->seconds ? &budget->models[i] : fastest;
    }
    return (Choice){fastest, 0, hypot(fastest->rms_steps, budget->noise[0]),
                    budget->time_factor * fastest->seconds};
}

/** @return The settings of a combination. */
static NeedsSettings choice_settings(const Choice *choice) {
    NeedsSettings settings = choice->model->settings;
    settings.samples = sample_counts[choice->samples];
    return settings;
}

/** Times a combination, and takes it if it fits. @param[in,out] taken The one taken so far. @return
 *  false if anything is wrong. */
static bool try_choice(BudgetSearch *budget, const Choice *choice, Choice *taken, Error *error) {
    NeedsBudget *result = &budget->search->needs->budget;
    NeedsSettings settings = choice_settings(choice);
    double seconds;
    bool is_measured;
    if (!search_time_picture(budget->search, &settings, &seconds, &is_measured, error)) {
        return false;
    }
    budget->time_factor *= seconds / choice->seconds;
    bool fits = seconds <= budget->search->request->budget_seconds;
    if (!taken->model || (fits && (!result->is_met || choice_is_better(choice, taken)))) {
        *taken = *choice;
        taken->seconds = seconds;
        result->settings = settings;
        result->seconds = seconds;
        result->is_measured = is_measured;
        result->is_met = fits;
    }
    return true;
}

/** Finds the best combination. @return false if anything is wrong. */
static bool choose(BudgetSearch *budget, Error *error) {
    NeedsBudget *result = &budget->search->needs->budget;
    Choice taken = {0}, last = {0};
    for (int attempt = 0; attempt < ATTEMPTS_MAXIMUM; attempt++) {
        Choice choice = best_choice(budget);
        bool is_repeated = choice.model == last.model && choice.samples == last.samples;
        bool is_used = result->is_met &&
                       taken.seconds >= BUDGET_USED * budget->search->request->budget_seconds;
        if (!choice.model || (attempt > 0 && (is_repeated || is_used))) {
            break;
        }
        if (!try_choice(budget, &choice, &taken, error)) {
            return false;
        }
        last = choice;
    }
    if (result->is_met) {
        return true;
    }
    Choice fastest = fastest_choice(budget);
    taken.model = NULL; // What did not fit is not taken, even if nothing does.
    return try_choice(budget, &fastest, &taken, error);
}

/** Measures the error of what was chosen. @return false if anything is wrong. */
static bool measure_error(BudgetSearch *budget, Error *error) {
    NeedsBudget *result = &budget->search->needs->budget;
    NeedsSettings many = result->settings;
    many.samples = result->reference_samples;
    return trial_run(&budget->stage, &result->settings, &budget->reference, &result->trial,
                     error) &&
           trial_run(&budget->stage, &many, &budget->reference, &result->without_noise, error);
}

/** Compares all combinations. @return false if anything is wrong. */
static bool find_best(BudgetSearch *budget, Error *error) {
    const Needs *needs = budget->search->needs;
    add_models(budget, needs->settings.engine);
    if (needs->settings.engine->mantissa_bits > engine_with_role(ENGINE_FASTEST)->mantissa_bits) {
        add_models(budget, engine_with_role(ENGINE_FASTEST));
    }
    if (!measure_noise(budget, error) || !measure_models(budget, error) || !choose(budget, error)) {
        return false;
    }
    budget->search->needs->budget.candidates = budget->model_count * (size_t)budget->sample_count;
    return measure_error(budget, error);
}

/** @return Rays per pixel of a reference that does not take too long. */
static int reference_samples_of(const NeedsSearch *search, double ray_seconds) {
    double pixels = (double)search->stage.width * search->stage.height;
    int samples = REFERENCE_SAMPLES_MAXIMUM;
    while (samples > REFERENCE_SAMPLES_MINIMUM &&
           ray_seconds * pixels * samples > REFERENCE_SECONDS) {
        samples /= 2;
    }
    return samples;
}

bool search_budget(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    NeedsSettings many = needs->settings;
    double ray_seconds;
    search_report(search, N_("the best picture in that time"));
    many.samples = 1;
    if (!search_probe_cost(search, &many, &ray_seconds, error)) {
        return false;
    }
    many.samples = reference_samples_of(search, ray_seconds);
    needs->budget.reference_samples = many.samples;
    BudgetSearch budget = {.search = search,
                           .stage = search->stage,
                           .models = calloc(MODELS_MAXIMUM, sizeof *budget.models),
                           .time_factor = 1};
    budget.stage.samples = many.samples;
    bool is_done = budget.models ||
                   error_set(error, STATUS_FAILED, "no memory for %d settings", MODELS_MAXIMUM);
    if (is_done && trial_render(&budget.stage, &many, &budget.reference, error)) {
        is_done = find_best(&budget, error);
        trial_picture_deinit(&budget.reference);
    } else {
        is_done = false;
    }
    free(budget.models);
    return is_done;
}
