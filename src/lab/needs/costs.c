/**
 * @file
 * @brief Finds how many rays per pixel are sufficient, the fastest engine, and times.
 */
#include "base/language.h"
#include "lab/needs/search.h"

#include <math.h>

/* --- rays per pixel -----------------------------------------------------------------------------
 */

/** Rays per pixel of the reference over those that are judged. */
enum { NOISE_FACTOR = 4 };
/** Most rays per pixel that are tried, unless more are asked for. */
enum { NOISE_SAMPLES_MAXIMUM = 256 };
/** CPU time of the reference of noise, seconds. */
#define NOISE_SECONDS 6.0

/** Measures the noise of a number of rays per pixel. @return false if anything is wrong. */
static bool measure_noise(const NeedsSearch *search, int samples, NeedsNoise *noise, Error *error) {
    TrialStage stage = search->stage;
    NeedsSettings settings = search->needs->settings, many = settings;
    TrialPicture reference;
    settings.samples = samples;
    many.samples = NOISE_FACTOR * samples;
    stage.samples = many.samples;
    *noise = (NeedsNoise){.samples = samples};
    if (!trial_render(&stage, &many, &reference, error)) {
        return false;
    }
    bool is_done = trial_run(&stage, &settings, &reference, &noise->trial, error);
    trial_picture_deinit(&reference);
    return is_done;
}

/** Adds a measurement at one end. */
static void add_noise(Needs *needs, NeedsNoise noise, bool is_first) {
    int at = is_first ? 0 : needs->noise_count;
    for (int i = needs->noise_count; i > at; i--) {
        needs->noise[i] = needs->noise[i - 1];
    }
    needs->noise[at] = noise;
    needs->noise_count++;
}

/** Tries fewer rays while those are sufficient. @return false if anything is wrong. */
static bool try_fewer_samples(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    for (int samples = needs->asked_samples / 2;
         samples > 0 && needs->noise_count < NEEDS_NOISE_MAXIMUM; samples /= 2) {
        NeedsNoise noise;
        if (!measure_noise(search, samples, &noise, error)) {
            return false;
        }
        if (needs_trial_fails(&noise.trial)) {
            return true;
        }
        add_noise(needs, noise, true);
        needs->settings.samples = samples;
    }
    return true;
}

/** Tries more rays until they are sufficient, as far as time allows. @return false if anything is
 *  wrong. */
static bool try_more_samples(NeedsSearch *search, double ray_seconds, Error *error) {
    Needs *needs = search->needs;
    double pixel_seconds = ray_seconds * search->stage.width * search->stage.height;
    for (int samples = 2 * needs->asked_samples;
         samples <= NOISE_SAMPLES_MAXIMUM && needs->noise_count < NEEDS_NOISE_MAXIMUM &&
         pixel_seconds * NOISE_FACTOR * samples <= NOISE_SECONDS;
         samples *= 2) {
        NeedsNoise noise;
        if (!measure_noise(search, samples, &noise, error)) {
            return false;
        }
        add_noise(needs, noise, false);
        if (!needs_trial_fails(&noise.trial)) {
            needs->settings.samples = samples;
            needs->is_noise_sufficient = true;
            return true;
        }
    }
    return true;
}

bool search_samples(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    NeedsNoise noise;
    double ray_seconds;
    search_report(search, N_("rays per pixel"));
    if (!search_probe_cost(search, &(NeedsSettings){.engine = needs->settings.engine,
                                                    .depth = needs->settings.depth,
                                                    .cutoff = needs->settings.cutoff,
                                                    .offset = needs->settings.offset,
                                                    .samples = 1,
                                                    .tolerance = needs->settings.tolerance},
                           &ray_seconds, error) ||
        !measure_noise(search, needs->asked_samples, &noise, error)) {
        return false;
    }
    add_noise(needs, noise, true);
    needs->is_noise_sufficient = !needs_trial_fails(&noise.trial);
    return needs->is_noise_sufficient ? try_fewer_samples(search, error)
                                      : try_more_samples(search, ray_seconds, error);
}

/* --- times --------------------------------------------------------------------------------------
 */

/** How often settings are timed. */
enum { TURNS = 5 };
/** Most engines of one number type. */
enum { LANE_ENGINES_MAXIMUM = 8 };
/** Time below which an engine counts as faster than the one that is taken by default: noise of the
 *  clock is smaller. */
#define FASTER_RATIO 0.97

/** Takes the fastest engine of the number type that was found. @return false if anything is wrong.
 */
static bool choose_lanes(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    NeedsSettings tried[LANE_ENGINES_MAXIMUM];
    double seconds[LANE_ENGINES_MAXIMUM];
    size_t count = 0, best = 0;
    needs->default_engine = needs->settings.engine;
    tried[count++] = needs->settings;
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        bool is_alike = (*engine)->mantissa_bits == needs->default_engine->mantissa_bits;
        if (is_alike && *engine != needs->default_engine && (*engine)->lanes > 1 &&
            engine_is_supported(*engine) && count < LANE_ENGINES_MAXIMUM) {
            tried[count] = needs->settings;
            tried[count++].engine = *engine;
        }
    }
    if (!trial_time(&search->stage, tried, count, TURNS, seconds, NULL, error)) {
        return false;
    }
    for (size_t i = 1; i < count; i++) {
        best = seconds[i] < FASTER_RATIO * seconds[best] ? i : best;
    }
    needs->settings.engine = tried[best].engine;
    needs->engine_ratio = seconds[0] / seconds[best];
    return true;
}

bool search_time_picture(const NeedsSearch *search, const NeedsSettings *settings, double *seconds,
                         bool *is_measured, Error *error) {
    /** Longest picture that is measured as a whole, seconds, and how often. */
    const double longest = 2;
    enum { PICTURES = 5 };
    const NeedsRequest *request = search->request;
    double cpu_seconds;
    TrialStage stage = search->stage;
    stage.samples = settings->samples;
    if (!trial_time(&stage, settings, 1, 1, &cpu_seconds, seconds, error)) {
        return false;
    }
    *seconds *= (double)request->width * request->height / ((double)stage.width * stage.height);
    *is_measured = *seconds <= longest;
    stage.width = request->width;
    stage.height = request->height;
    return !*is_measured ||
           trial_time(&stage, settings, 1, PICTURES, &cpu_seconds, seconds, error);
}

bool search_costs(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    double seconds[3];
    bool is_measured;
    search_report(search, N_("times"));
    if (!choose_lanes(search, error)) {
        return false;
    }
    bool is_float = needs->settings.engine->mantissa_bits < needs->reference.engine->mantissa_bits;
    NeedsSettings timed[3] = {needs->settings, needs->settings, needs->reference};
    timed[1].engine = engine_with_role(is_float ? ENGINE_DOUBLE : ENGINE_FASTEST);
    if (!trial_time(&search->stage, timed, 2, TURNS, seconds, NULL, error) ||
        !trial_time(&search->stage, &timed[2], 1, 1, &seconds[2], NULL, error)) {
        return false;
    }
    needs->double_over_float_seconds = is_float ? seconds[1] / seconds[0] : seconds[0] / seconds[1];
    needs->reference_ratio = seconds[2] / seconds[0];
    return search_time_picture(search, &needs->settings, &needs->seconds, &is_measured, error);
}
