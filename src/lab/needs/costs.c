/**
 * @file
 * @brief Finds how many rays per pixel are sufficient, the fastest engine, and times.
 */
#include "base/language.h"
#include "lab/needs/search.h"

/* --- rays per pixel -----------------------------------------------------------------------------
 */

/** Rays per pixel of the reference over those that are judged, and from a number to the next. */
enum { NOISE_FACTOR = 4 };
/** Most rays per pixel that are tried, unless more are asked for. */
enum { NOISE_SAMPLES_MAXIMUM = 256 };
/** CPU time of the largest reference of noise, seconds. */
#define NOISE_SECONDS 2.0

/** Renders a picture with a number of rays per pixel. @return false if anything is wrong. */
static bool render_samples_of(const NeedsSearch *search, int samples, TrialPicture *picture,
                              Error *error) {
    TrialStage stage = search->stage;
    NeedsSettings settings = search->needs->settings;
    settings.samples = stage.samples = samples;
    return trial_render(&stage, &settings, picture, error);
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

/** Tries fewer rays while those are sufficient. @param reference With #NOISE_FACTOR times as many
 * as are asked for. @return false if anything is wrong. */
static bool try_fewer_samples(NeedsSearch *search, const TrialPicture *reference, Error *error) {
    Needs *needs = search->needs;
    for (int samples = needs->asked_samples / 2;
         samples > 0 && needs->noise_count < NEEDS_NOISE_MAXIMUM; samples /= 2) {
        TrialPicture picture;
        if (!render_samples_of(search, samples, &picture, error)) {
            return false;
        }
        NeedsNoise noise = {samples, trial_compare(&search->stage, &picture, reference)};
        trial_picture_deinit(&picture);
        if (needs_trial_fails(&noise.trial)) {
            return true;
        }
        add_noise(needs, noise, true);
        needs->settings.samples = samples;
    }
    return true;
}

/** @return Whether more rays may be sufficient. Errors fall with one over the rays at best, and so
 *  do, at an edge, the pixels that are off by more than some error. */
static bool is_promising(const NeedsNoise *noise) {
    double fewer = (double)noise->samples / NOISE_SAMPLES_MAXIMUM;
    return (double)noise->trial.off * fewer * fewer <=
           NEEDS_FRACTION_MAXIMUM * (double)noise->trial.pixels;
}

/**
 * Tries more rays until they are sufficient, as far as time allows and there is hope.
 * @param ray_seconds        CPU time of a ray.
 * @param[in,out] reference  With #NOISE_FACTOR times as many as are asked for; then with more.
 * @return false if anything is wrong.
 */
static bool try_more_samples(NeedsSearch *search, double ray_seconds, TrialPicture *reference,
                             Error *error) {
    Needs *needs = search->needs;
    double pixel_seconds = ray_seconds * search->stage.width * search->stage.height;
    for (int samples = NOISE_FACTOR * needs->asked_samples;
         samples <= NOISE_SAMPLES_MAXIMUM && needs->noise_count < NEEDS_NOISE_MAXIMUM &&
         pixel_seconds * NOISE_FACTOR * samples <= NOISE_SECONDS;
         samples *= NOISE_FACTOR) {
        TrialPicture many;
        // One number more than there is hope for shows how slowly the noise falls.
        bool is_last = !is_promising(&needs->noise[needs->noise_count - 1]);
        if (!render_samples_of(search, NOISE_FACTOR * samples, &many, error)) {
            return false;
        }
        NeedsNoise noise = {samples, trial_compare(&search->stage, reference, &many)};
        trial_picture_deinit(reference);
        *reference = many;
        add_noise(needs, noise, false);
        needs->is_noise_sufficient = !needs_trial_fails(&noise.trial);
        if (needs->is_noise_sufficient) {
            needs->settings.samples = samples;
        }
        if (needs->is_noise_sufficient || is_last) {
            return true;
        }
    }
    return true;
}

/** Judges the rays per pixel that are asked for, then others. @param[in,out] reference See
 *  #try_more_samples. @return false if anything is wrong. */
static bool judge_samples(NeedsSearch *search, TrialPicture *reference, Error *error) {
    Needs *needs = search->needs;
    NeedsSettings single = needs->settings;
    TrialPicture picture;
    double ray_seconds;
    single.samples = 1;
    if (!render_samples_of(search, needs->asked_samples, &picture, error)) {
        return false;
    }
    add_noise(
        needs,
        (NeedsNoise){needs->asked_samples, trial_compare(&search->stage, &picture, reference)},
        true);
    trial_picture_deinit(&picture);
    needs->is_noise_sufficient = !needs_trial_fails(&needs->noise[0].trial);
    if (needs->is_noise_sufficient) {
        return try_fewer_samples(search, reference, error);
    }
    return search_probe_cost(search, &single, &ray_seconds, error) &&
           try_more_samples(search, ray_seconds, reference, error);
}

bool search_samples(NeedsSearch *search, Error *error) {
    TrialPicture reference;
    search_report(search, N_("rays per pixel"));
    if (!render_samples_of(search, NOISE_FACTOR * search->needs->asked_samples, &reference,
                           error)) {
        return false;
    }
    bool is_done = judge_samples(search, &reference, error);
    trial_picture_deinit(&reference);
    return is_done;
}

/* --- times --------------------------------------------------------------------------------------
 */

/** How often settings are timed. */
enum { TURNS = 5 };
/** Most engines of one number type. */
enum { LANE_ENGINES_MAXIMUM = 8 };

/** Takes the fastest engine of the number type that was found. @return false if anything is wrong.
 */
static bool choose_lanes(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    NeedsSettings tried[LANE_ENGINES_MAXIMUM];
    TrialTime times[LANE_ENGINES_MAXIMUM];
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
    if (!trial_time_processor(&search->stage, tried, count, TURNS, times, error)) {
        return false;
    }
    for (size_t i = 1; i < count; i++) {
        best = trial_time_is_faster(&times[i], &times[best]) ? i : best;
    }
    needs->settings.engine = tried[best].engine;
    needs->engine_ratio = times[0].cpu_least / times[best].cpu_least;
    return true;
}

bool search_time_picture(const NeedsSearch *search, const NeedsSettings *settings, double *seconds,
                         bool *is_measured, Error *error) {
    /** Longest picture that is measured as a whole, seconds, and how often. */
    const double longest = 1;
    enum { PICTURES = 5 };
    const NeedsRequest *request = search->request;
    TrialTime time;
    TrialStage stage = search->stage;
    stage.samples = settings->samples;
    if (!trial_time(&stage, settings, 1, 1, &time, error)) {
        return false;
    }
    *seconds = time.least * request->width * request->height / ((double)stage.width * stage.height);
    *is_measured = *seconds <= longest;
    stage.width = request->width;
    stage.height = request->height;
    if (*is_measured && !trial_time(&stage, settings, 1, PICTURES, &time, error)) {
        return false;
    }
    *seconds = *is_measured ? time.least : *seconds;
    return true;
}

bool search_costs(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    TrialTime times[3];
    bool is_measured;
    search_report(search, N_("times"));
    if (!choose_lanes(search, error)) {
        return false;
    }
    bool is_float = needs->settings.engine->mantissa_bits < needs->reference.engine->mantissa_bits;
    NeedsSettings timed[3] = {needs->settings, needs->settings, needs->reference};
    timed[1].engine = engine_with_role(is_float ? ENGINE_DOUBLE : ENGINE_FASTEST);
    if (!trial_time_processor(&search->stage, timed, 2, TURNS, times, error) ||
        !trial_time_processor(&search->stage, &timed[2], 1, 1, &times[2], error)) {
        return false;
    }
    double ratio = times[1].cpu_least / times[0].cpu_least;
    needs->double_over_float_seconds = is_float ? ratio : 1 / ratio;
    needs->reference_ratio = times[2].cpu_least / times[0].cpu_least;
    return search_time_picture(search, &needs->settings, &needs->seconds, &is_measured, error);
}
