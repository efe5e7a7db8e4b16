/**
 * @file
 * @brief Finds what a scene needs: depth, tolerances, number type, in this order; then their cost.
 */
#include "lab/needs/needs.h"

#include "lab/needs/image_difference.h"

/** Depth of the reference: a larger one changes nothing. */
enum { REFERENCE_DEPTH = 128 };
/** Cutoff of the reference, 8-bit steps: a sixteenth of the default. */
#define REFERENCE_CUTOFF (CUTOFF_DEFAULT / 16)

/** Rays per pixel when number types are compared: each samples soft lights differently. */
enum { ROUNDING_SAMPLES = 4 };

/** How often each variant is timed, in turn with the others; the least time counts. */
enum { TIMING_REPEATS = 3 };

/** Tolerances of the reference over the scene's own. */
#define REFERENCE_TOLERANCE (1.0 / 16)

/** A search in progress. */
typedef struct NeedsSearch {
    const NeedsRequest *request; /**< What is wanted. */
    RenderContext context;       /**< The scene and the pixels that are rendered. */
    Variant best;                /**< The cheapest sufficient variant so far, in double. */
    Encoding encoding;           /**< How light is displayed. */
    Needs *needs;                /**< The result. */
} NeedsSearch;

bool needs_trial_fails(const NeedsTrial *trial) {
    return (double)(trial->visible + trial->outliers) >
           NEEDS_FRACTION_MAXIMUM * (double)trial->rays;
}

double needs_trial_certainty(const NeedsTrial *trial) {
    /** -ln 0.05: if one ray in n were wrong, 3 n rays would show none with probability 0.05. */
    const double rule_of_three = 3;
    return (double)trial->rays / rule_of_three;
}

/** @return A trial without outliers. */
static NeedsTrial trial_from_difference(const ImageDifference *difference) {
    return (NeedsTrial){.rays = difference->rays,
                        .max_steps = difference->max_steps,
                        .visible = difference->visible,
                        .edge_flips = difference->edge_flips};
}

/** Tries a variant against a reference of the same number type, without outliers. @return false if
 *  anything is wrong. */
static bool try_same_precision(const NeedsSearch *search, const Variant *variant,
                               const SampledRender *reference_render, NeedsTrial *trial,
                               Error *error) {
    SampledRender render;
    if (!render_samples(&search->context, variant, &render, error)) {
        return false;
    }
    ImageDifference difference =
        image_difference_of(&render, reference_render, NULL, search->encoding);
    *trial = trial_from_difference(&difference);
    sampled_render_deinit(&render);
    return true;
}

/** Tries a depth. @return false if anything is wrong. */
static bool try_depth(const NeedsSearch *search, int depth, const SampledRender *reference_render,
                      NeedsTrial *trial, Error *error) {
    Variant variant = search->best;
    variant.trace.depth = depth;
    return try_same_precision(search, &variant, reference_render, trial, error);
}

/** Finds the least sufficient depth: by doubling, then by bisection. @return false if anything is
 *  wrong. */
static bool search_depth(NeedsSearch *search, const SampledRender *reference_render, Error *error) {
    Needs *needs = search->needs;
    int low = -1, high = 0;
    while (true) {
        if (!try_depth(search, high, reference_render, &needs->depth_trial, error)) {
            return false;
        }
        if (needs->depth_trial.visible == 0 || high >= REFERENCE_DEPTH) {
            break;
        }
        low = high;
        needs->shallower_trial = needs->depth_trial;
        high = high ? 2 * high : 1;
    }
    while (high - low > 1) {
        NeedsTrial trial;
        int middle = (low + high) / 2;
        if (!try_depth(search, middle, reference_render, &trial, error)) {
            return false;
        }
        bool fails = trial.visible > 0;
        *(fails ? &low : &high) = middle;
        *(fails ? &needs->shallower_trial : &needs->depth_trial) = trial;
    }
    needs->depth = high;
    return true;
}

/** Finds the depth. @return false if anything is wrong. */
static bool find_depth(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    Variant reference = search->best;
    SampledRender reference_render;
    reference.trace.depth = REFERENCE_DEPTH;
    if (!needs->is_recursive) {
        return true;
    }
    if (!render_samples(&search->context, &reference, &reference_render, error)) {
        return false;
    }
    Variant finer = reference;
    finer.trace.cutoff = REFERENCE_CUTOFF;
    bool is_found =
        try_same_precision(search, &finer, &reference_render, &needs->cutoff_trial, error) &&
        search_depth(search, &reference_render, error) &&
        (needs->scene_depth < 0 || try_depth(search, needs->scene_depth, &reference_render,
                                             &needs->scene_depth_trial, error));
    search->best.trace.depth = needs->depth;
    sampled_render_deinit(&reference_render);
    return is_found;
}

/** Renders the best variant with scaled tolerances. @return false if anything is wrong. */
static bool render_with_tolerance(const NeedsSearch *search, double factor, SampledRender *render,
                                  Error *error) {
    ScaledToleranceScene scaled;
    if (!scaled_tolerance_scene_init(&scaled, search->context.scene, factor, error)) {
        return false;
    }
    RenderContext render_context = search->context;
    render_context.scene = &scaled.scene;
    bool is_taken = render_samples(&render_context, &search->best, render, error);
    scaled_tolerance_scene_deinit(&scaled);
    return is_taken;
}

/** Finds how coarse tolerances may be. @return false if anything is wrong. */
static bool find_tolerance(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    SampledRender reference_render;
    needs->tolerance = 1;
    needs->has_sdf = scene_has_tolerances(search->context.scene);
    if (!needs->has_sdf) {
        return true;
    }
    if (!render_with_tolerance(search, REFERENCE_TOLERANCE, &reference_render, error)) {
        return false;
    }
    bool is_enough = true, is_done = true;
    for (double factor = 1; is_enough && is_done && factor <= 1024; factor *= 4) {
        SampledRender render;
        is_done = render_with_tolerance(search, factor, &render, error);
        if (is_done) {
            // Hit points depend on the tolerance, and so do the rays that pass an edge.
            ImageDifference difference = image_difference_of(&render, &reference_render,
                                                             &reference_render, search->encoding);
            NeedsTrial trial = trial_from_difference(&difference);
            is_enough = !needs_trial_fails(&trial);
            needs->tolerance_trial = is_enough || factor == 1 ? trial : needs->tolerance_trial;
            needs->tolerance = is_enough ? factor : needs->tolerance;
            sampled_render_deinit(&render);
        }
    }
    sampled_render_deinit(&reference_render);
    return is_done;
}

/** Tries a number type or an offset against a reference. @return false if anything is wrong. */
static bool try_rounding(const NeedsSearch *search, const RenderContext *render_context,
                         const Variant *variant, const Variant *reference, NeedsTrial *trial,
                         Error *error) {
    SampledRender render, reference_render;
    if (!render_samples(render_context, variant, &render, error)) {
        return false;
    }
    bool is_done = render_samples(render_context, reference, &reference_render, error);
    if (is_done) {
        ImageDifference difference =
            image_difference_of(&render, &reference_render, &reference_render, search->encoding);
        *trial = trial_from_difference(&difference);
        is_done = outliers_count(render_context, reference, &reference_render, &render,
                                 &trial->outliers, error);
        sampled_render_deinit(&reference_render);
    }
    sampled_render_deinit(&render);
    return is_done;
}

/** Is a #PixelTest: pixels that are traced in quad, which is a hundred times slower. */
static bool pixel_is_in_quad_set(const void *context, int x, int y) {
    /** Of so many cells along each axis, one is traced. */
    const int cells = 5;
    return pixel_is_sampled(context, x, y) && x / 8 % cells == 2 && y / 8 % cells == 2;
}

/** Tries double against quad. @return false if anything is wrong. */
static bool try_double(const NeedsSearch *search, NeedsEngine *tried, Error *error) {
    PixelSet quad_pixels;
    Variant variant = search->best, reference = search->best;
    tried->reference = engine_with_role(ENGINE_REFERENCE);
    reference.engine = tried->reference;
    variant.samples_traced = reference.samples_traced = 1;
    if (!pixel_set_init(&quad_pixels, search->request->width, search->request->height,
                        pixel_is_in_quad_set, NULL, error)) {
        return false;
    }
    RenderContext render_context = search->context;
    render_context.pixels = &quad_pixels;
    bool is_done = quad_pixels.count == 0 || try_rounding(search, &render_context, &variant,
                                                          &reference, &tried->trial, error);
    pixel_set_deinit(&quad_pixels);
    return is_done;
}

/** Finds the number type. @return false if anything is wrong. */
static bool find_sufficient_engine(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    Variant variant = search->best;
    NeedsEngine *fast = &needs->engines[0], *exact = &needs->engines[1];
    int rays = search->request->samples;
    fast->engine = engine_with_role(ENGINE_FASTEST);
    fast->reference = exact->engine = engine_with_role(ENGINE_DOUBLE);
    variant.engine = engine_scalar(fast->engine);
    needs->engine_count = 2;
    variant.samples_traced = rays < ROUNDING_SAMPLES ? rays : ROUNDING_SAMPLES;
    Variant reference = variant;
    reference.engine = engine_scalar(exact->engine);
    if (!try_rounding(search, &search->context, &variant, &reference, &fast->trial, error)) {
        return false;
    }
    if (!needs_trial_fails(&fast->trial)) {
        return true;
    }
    needs->engine = 1;
    if (!try_double(search, exact, error)) {
        return false;
    }
    if (needs_trial_fails(&exact->trial)) {
        needs->engines[2] = (NeedsEngine){.engine = exact->reference};
        needs->engine_count = 3;
        needs->engine = 2;
    }
    return true;
}

/** Tries the other ray offsets. @return false if anything is wrong. */
static bool try_offset_modes(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    Variant bound = search->best;
    bound.engine = engine_scalar(needs->engines[needs->engine].engine);
    bound.trace.offset = OFFSET_BOUND;
    Variant none = bound, fixed = bound;
    none.trace.offset = OFFSET_NONE;
    fixed.trace.offset = OFFSET_FIXED;
    return try_rounding(search, &search->context, &none, &bound, &needs->offset_none_trial,
                        error) &&
           try_rounding(search, &search->context, &fixed, &bound, &needs->offset_fixed_trial,
                        error);
}

/** Finds the samples, and their noise. @return false if anything is wrong. */
static bool find_sampling_error(NeedsSearch *search, Error *error) {
    SamplingError sampling_error;
    Variant variant = search->best;
    variant.engine = engine_scalar(search->needs->engines[0].engine);
    bool is_found = sampling_error_measure(&search->context, &variant, &sampling_error, error);
    search->needs->samples = sampling_error.samples;
    search->needs->samples_rms = sampling_error.rms;
    search->needs->samples_fraction = sampling_error.fraction;
    return is_found;
}

/** Tries all settings found together, against a reference with full depth and cutoff. @return false
 *  if anything is wrong. */
static bool try_total(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    const NeedsEngine *chosen = &needs->engines[needs->engine];
    Variant variant = search->best, path_variant = search->best, reference = search->best;
    SampledRender render = {0}, path_render = {0}, reference_render = {0};
    variant.engine = engine_scalar(chosen->engine);
    reference.trace.depth = REFERENCE_DEPTH;
    reference.trace.cutoff = REFERENCE_CUTOFF;
    bool is_done = render_samples(&search->context, &variant, &render, error) &&
                   render_samples(&search->context, &path_variant, &path_render, error) &&
                   render_samples(&search->context, &reference, &reference_render, error);
    if (is_done) {
        ImageDifference difference =
            image_difference_of(&render, &reference_render, &path_render, search->encoding);
        needs->total_trial = trial_from_difference(&difference);
        needs->total_trial.outliers = chosen->trial.outliers;
    }
    sampled_render_deinit(&render);
    sampled_render_deinit(&path_render);
    sampled_render_deinit(&reference_render);
    return is_done;
}

/** Is a #PixelTest: the pixels that are timed, in whole tiles, as pictures are rendered. */
static bool pixel_is_in_timed_set(const void *context, int x, int y) {
    (void)context;
    return (x / 64 + 5 * (y / 16)) % 32 == 0;
}

/** Times variants in turn. @param[out] seconds The least time of each. @return false if anything is
 *  wrong. */
static bool time_variants(const RenderContext *render_context, const Variant *variants,
                          size_t count, double *seconds, Error *error) {
    for (int turn = 0; turn < TIMING_REPEATS; turn++) {
        for (size_t i = 0; i < count; i++) {
            SampledRender render;
            if (!render_samples(render_context, &variants[i], &render, error)) {
                return false;
            }
            seconds[i] =
                turn == 0 || render.cpu_seconds < seconds[i] ? render.cpu_seconds : seconds[i];
            sampled_render_deinit(&render);
        }
    }
    return true;
}

/** Times the engines and the reference. @return false if anything is wrong. */
static bool find_costs(NeedsSearch *search, Error *error) {
    Needs *needs = search->needs;
    Variant variants[3] = {search->best, search->best, search->best};
    double seconds[3] = {0};
    PixelSet timed;
    variants[0].engine = needs->engines[0].engine;
    variants[1].engine = needs->engines[1].engine;
    variants[2].engine = needs->engines[1].engine;
    variants[2].trace.depth = REFERENCE_DEPTH;
    variants[2].trace.cutoff = REFERENCE_CUTOFF;
    if (!pixel_set_init(&timed, search->request->width, search->request->height,
                        pixel_is_in_timed_set, NULL, error)) {
        return false;
    }
    RenderContext render_context = search->context;
    render_context.pixels = &timed;
    bool is_timed = time_variants(&render_context, variants, 3, seconds, error);
    needs->engines[0].cpu_seconds = seconds[0];
    needs->engines[1].cpu_seconds = seconds[1];
    needs->reference_cpu_seconds = seconds[2];
    pixel_set_deinit(&timed);
    return is_timed;
}

/** Finds everything. @return false if anything is wrong. */
static bool run_search(NeedsSearch *search, Error *error) {
    return find_depth(search, error) && find_tolerance(search, error) &&
           find_sufficient_engine(search, error) && try_offset_modes(search, error) &&
           find_sampling_error(search, error) && try_total(search, error) &&
           find_costs(search, error);
}

bool needs_find(const Scene *scene, const NeedsRequest *request, Needs *needs, Error *error) {
    *needs = (Needs){.forecast = precision_estimate_of(scene),
                     .is_recursive = scene_has_reflection(scene) || scene_has_transparency(scene),
                     .scene_depth = request->depth};
    PixelSet pixels;
    if (!(request->uses_all_pixels
              ? pixel_set_init(&pixels, request->width, request->height, pixel_is_any, NULL, error)
              : pixel_set_init_sparse(&pixels, scene, request->width, request->height, error))) {
        return false;
    }
    NeedsSearch search = {.request = request,
                          .context = {scene, &pixels, request->threads, request->stop},
                          .best = {.engine = engine_scalar(engine_with_role(ENGINE_DOUBLE)),
                                   .trace = *request->trace,
                                   .samples_traced = 1},
                          .encoding = (Encoding)scene->image.encoding,
                          .needs = needs};
    search.best.trace.samples = request->samples;
    search.best.trace.depth = 0;
    bool is_done = run_search(&search, error);
    pixel_set_deinit(&pixels);
    return is_done;
}
