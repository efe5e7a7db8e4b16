/**
 * @file
 * @brief Finding what a scene needs: depth, tolerance, number type, in this order; then what each
 *        costs.
 */
#include "dioptre/needs.h"

#include "lab/smoothness.h"
#include "lab/strays.h"
#include "lab/variation.h"

/** Depth of the reference, and the weight where its rays end: more changes nothing. */
enum { REFERENCE_DEPTH = 128 };
/** See #REFERENCE_DEPTH; a fifteenth of what the tracer takes. */
#define REFERENCE_CUTOFF 1e-5

/** Rays a pixel that number types are compared with: soft lamps are aimed at another place by each.
 */
enum { ROUNDING_RAYS = 4 };

/** How often each manner is timed, in turn with the others: the least time is taken. */
enum { TIMINGS = 3 };

/** How many times as fine as the scene says tolerances of the reference are. */
#define REFERENCE_TOLERANCE (1.0 / 16)

/** A pilot under way. */
typedef struct Pilot {
    const NeedsRequest *request; /**< What is asked. */
    Studio studio;               /**< The scene and the pixels that are tried. */
    Manner best;                 /**< The cheapest manner so far that is enough, in double. */
    Encoding encoding;           /**< How light is shown. */
    Needs *needs;                /**< What was found. */
} Pilot;

bool needs_fails(const NeedsTrial *trial) {
    return (double)(trial->off + trial->strays) > NEEDS_SHARE * (double)trial->rays;
}

double needs_certainty(const NeedsTrial *trial) {
    /** -ln 0.05: if one in n were off, none of 3 n would be seen in one case of twenty. */
    const double rule_of_three = 3;
    return (double)trial->rays / rule_of_three;
}

/** @return What a comparison says. @param contrast The comparison. */
static NeedsTrial trial_of(const Contrast *contrast) {
    return (NeedsTrial){.rays = contrast->rays,
                        .worst = contrast->worst,
                        .off = contrast->off,
                        .flips = contrast->flips};
}

/** @return The engine that others are compared with first. */
static const Engine *double_engine(void) {
    const Engine *engine = engine_find("f64x4", NULL);
    return engine ? engine : engine_find("f64x1", NULL);
}

/**
 * @return An engine of a number type that takes ray by ray: pixels that lie far apart share
 * nothing, and the bits are the same.
 * @param engine  Any engine of that type.
 */
static const Engine *single_engine(const Engine *engine) {
    int bits = engine->mantissa_bits;
    return engine_find(bits < 53 ? "f32x1" : bits == 53 ? "f64x1" : "f128x1", NULL);
}

/** Compares two manners whose rays start alike, in one number type. @param pilot The pilot.
 *  @param manner A manner. @param truth How it should be. @param[out] trial How it is.
 *  @param[out] error What is wrong. @return false if anything is. */
static bool model_try(const Pilot *pilot, const Manner *manner, const Shot *truth,
                      NeedsTrial *trial, Error *error) {
    Shot shot;
    if (!shot_take(&pilot->studio, manner, &shot, error)) {
        return false;
    }
    Contrast contrast = contrast_of(&shot, truth, NULL, pilot->encoding);
    *trial = trial_of(&contrast);
    shot_release(&shot);
    return true;
}

/** Tries a depth. @param pilot The pilot. @param depth It. @param truth The reference.
 *  @param[out] trial How it did. @param[out] error What is wrong. @return false if anything is. */
static bool depth_try(const Pilot *pilot, int depth, const Shot *truth, NeedsTrial *trial,
                      Error *error) {
    Manner manner = pilot->best;
    manner.trace.depth = depth;
    return model_try(pilot, &manner, truth, trial, error);
}

/** Finds the least depth that is enough: doubled until it is, then halved between.
 *  @param[in,out] pilot The pilot. @param truth The reference. @param[out] error What is wrong.
 *  @return false if anything is. */
static bool depth_search(Pilot *pilot, const Shot *truth, Error *error) {
    Needs *needs = pilot->needs;
    int low = -1, high = 0;
    while (true) {
        if (!depth_try(pilot, high, truth, &needs->at_depth, error)) {
            return false;
        }
        if (needs->at_depth.off == 0 || high >= REFERENCE_DEPTH) {
            break;
        }
        low = high;
        needs->shallower = needs->at_depth;
        high = high ? 2 * high : 1;
    }
    while (high - low > 1) {
        NeedsTrial trial;
        int middle = (low + high) / 2;
        if (!depth_try(pilot, middle, truth, &trial, error)) {
            return false;
        }
        bool fails = trial.off > 0;
        *(fails ? &low : &high) = middle;
        *(fails ? &needs->shallower : &needs->at_depth) = trial;
    }
    needs->depth = high;
    return true;
}

/** Finds the depth. @param[in,out] pilot The pilot. @param[out] error What is wrong.
 *  @return false if anything is. */
static bool depth_find(Pilot *pilot, Error *error) {
    Needs *needs = pilot->needs;
    Manner reference = pilot->best;
    Shot truth;
    reference.trace.depth = REFERENCE_DEPTH;
    if (!needs->is_recursive) {
        return true;
    }
    if (!shot_take(&pilot->studio, &reference, &truth, error)) {
        return false;
    }
    Manner finer = reference;
    finer.trace.cutoff = REFERENCE_CUTOFF;
    bool is_found = model_try(pilot, &finer, &truth, &needs->at_cutoff, error) &&
                    depth_search(pilot, &truth, error) &&
                    (needs->depth_asked < 0 ||
                     depth_try(pilot, needs->depth_asked, &truth, &needs->as_asked, error));
    pilot->best.trace.depth = needs->depth;
    shot_release(&truth);
    return is_found;
}

/** Shoots with other tolerances. @param pilot The pilot. @param factor How many times as large.
 *  @param[out] shot The shot. @param[out] error What is wrong. @return false if anything is. */
static bool tolerance_shoot(const Pilot *pilot, double factor, Shot *shot, Error *error) {
    Variation variation;
    if (!variation_make(&variation, pilot->studio.scene, pilot->best.engine->shape_keywords, factor,
                        error)) {
        return false;
    }
    Studio studio = pilot->studio;
    studio.scene = &variation.scene;
    bool is_taken = shot_take(&studio, &pilot->best, shot, error);
    variation_release(&variation);
    return is_taken;
}

/** Finds how coarse tolerances may be. @param[in,out] pilot The pilot. @param[out] error What is
 *  wrong. @return false if anything is. */
static bool tolerance_find(Pilot *pilot, Error *error) {
    Needs *needs = pilot->needs;
    Shot truth;
    needs->tolerance = 1;
    needs->is_marched =
        variation_is_possible(pilot->studio.scene, pilot->best.engine->shape_keywords);
    if (!needs->is_marched) {
        return true;
    }
    if (!tolerance_shoot(pilot, REFERENCE_TOLERANCE, &truth, error)) {
        return false;
    }
    bool is_enough = true, is_done = true;
    for (double factor = 1; is_enough && is_done && factor <= 1024; factor *= 4) {
        Shot shot;
        is_done = tolerance_shoot(pilot, factor, &shot, error);
        if (is_done) {
            // Rays end elsewhere with each: which of them pass an edge is no fault of theirs.
            Contrast contrast = contrast_of(&shot, &truth, &truth, pilot->encoding);
            NeedsTrial trial = trial_of(&contrast);
            is_enough = !needs_fails(&trial);
            needs->at_tolerance = is_enough || factor == 1 ? trial : needs->at_tolerance;
            needs->tolerance = is_enough ? factor : needs->tolerance;
            shot_release(&shot);
        }
    }
    shot_release(&truth);
    return is_done;
}

/** Compares two number types, or ways to leave a surface. @param pilot The pilot. @param studio
 *  What is shot. @param manner A manner. @param reference How it should be.
 *  @param[out] trial How it is. @param[out] error What is wrong. @return false if anything is. */
static bool rounding_try(const Pilot *pilot, const Studio *studio, const Manner *manner,
                         const Manner *reference, NeedsTrial *trial, Error *error) {
    Shot shot, truth;
    if (!shot_take(studio, manner, &shot, error)) {
        return false;
    }
    bool is_done = shot_take(studio, reference, &truth, error);
    if (is_done) {
        Contrast contrast = contrast_of(&shot, &truth, &truth, pilot->encoding);
        *trial = trial_of(&contrast);
        is_done = strays_count(studio, reference, &truth, &shot, &trial->strays, error);
        shot_release(&truth);
    }
    shot_release(&shot);
    return is_done;
}

/** @return Whether a pixel is one of the few that quad is asked about: it takes a hundred times as
 *          long. See #PixelTest. @param context Not looked at. @param x Its column. @param y Its
 *  row. */
static bool pixel_is_few(const void *context, int x, int y) {
    /** Cells of which one is asked, each way. */
    const int cells = 5;
    return pixel_is_sampled(context, x, y) && x / 8 % cells == 2 && y / 8 % cells == 2;
}

/** Tries double against quad. @param pilot The pilot. @param[in,out] tried Double.
 *  @param[out] error What is wrong. @return false if anything is. */
static bool double_try(const Pilot *pilot, NeedsEngine *tried, Error *error) {
    Pixels few;
    Manner manner = pilot->best, reference = pilot->best;
    tried->reference = engine_find("f128x1", NULL);
    reference.engine = tried->reference;
    manner.rays = reference.rays = 1;
    if (!pixels_make(&few, pilot->request->width, pilot->request->height, pixel_is_few, NULL,
                     error)) {
        return false;
    }
    Studio studio = pilot->studio;
    studio.pixels = &few;
    bool is_done =
        few.count == 0 || rounding_try(pilot, &studio, &manner, &reference, &tried->trial, error);
    pixels_release(&few);
    return is_done;
}

/** Finds the number type. @param[in,out] pilot The pilot. @param[out] error What is wrong.
 *  @return false if anything is. */
static bool engine_find_enough(Pilot *pilot, Error *error) {
    Needs *needs = pilot->needs;
    Manner manner = pilot->best;
    NeedsEngine *fast = &needs->engines[0], *exact = &needs->engines[1];
    int rays = pilot->request->samples;
    fast->engine = engine_find("auto", NULL);
    fast->reference = exact->engine = double_engine();
    manner.engine = single_engine(fast->engine);
    needs->engine_count = 2;
    manner.rays = rays < ROUNDING_RAYS ? rays : ROUNDING_RAYS;
    Manner reference = manner;
    reference.engine = single_engine(exact->engine);
    if (!rounding_try(pilot, &pilot->studio, &manner, &reference, &fast->trial, error)) {
        return false;
    }
    if (!needs_fails(&fast->trial)) {
        return true;
    }
    needs->engine = 1;
    if (!double_try(pilot, exact, error)) {
        return false;
    }
    if (needs_fails(&exact->trial)) {
        needs->engines[2] = (NeedsEngine){.engine = exact->reference};
        needs->engine_count = 3;
        needs->engine = 2;
    }
    return true;
}

/** Looks what the other ways to leave a surface would change. @param[in,out] pilot The pilot.
 *  @param[out] error What is wrong. @return false if anything is. */
static bool offsets_look(Pilot *pilot, Error *error) {
    Needs *needs = pilot->needs;
    Manner bound = pilot->best;
    bound.engine = single_engine(needs->engines[needs->engine].engine);
    bound.trace.offset = OFFSET_BOUND;
    Manner none = bound, fixed = bound;
    none.trace.offset = OFFSET_NONE;
    fixed.trace.offset = OFFSET_FIXED;
    return rounding_try(pilot, &pilot->studio, &none, &bound, &needs->offset_none, error) &&
           rounding_try(pilot, &pilot->studio, &fixed, &bound, &needs->offset_fixed, error);
}

/** Looks what the samples that are wanted leave. @param[in,out] pilot The pilot. @param[out] error
 *  What is wrong. @return false if anything is. */
static bool smoothness_look(Pilot *pilot, Error *error) {
    Smoothness smoothness;
    Manner manner = pilot->best;
    manner.engine = single_engine(pilot->needs->engines[0].engine);
    bool is_found = smoothness_find(&pilot->studio, &manner, &smoothness, error);
    pilot->needs->samples = smoothness.samples;
    pilot->needs->samples_rms = smoothness.rms;
    pilot->needs->samples_share = smoothness.share;
    return is_found;
}

/** Tries all of it together: what was found against a reference with everything on.
 *  @param[in,out] pilot The pilot. @param[out] error What is wrong. @return false if anything is.
 */
static bool total_try(Pilot *pilot, Error *error) {
    Needs *needs = pilot->needs;
    const NeedsEngine *chosen = &needs->engines[needs->engine];
    Manner manner = pilot->best, ways = pilot->best, reference = pilot->best;
    Shot shot = {0}, way = {0}, truth = {0};
    manner.engine = single_engine(chosen->engine);
    reference.trace.depth = REFERENCE_DEPTH;
    reference.trace.cutoff = REFERENCE_CUTOFF;
    bool is_done = shot_take(&pilot->studio, &manner, &shot, error) &&
                   shot_take(&pilot->studio, &ways, &way, error) &&
                   shot_take(&pilot->studio, &reference, &truth, error);
    if (is_done) {
        Contrast contrast = contrast_of(&shot, &truth, &way, pilot->encoding);
        needs->total = trial_of(&contrast);
        needs->total.strays = chosen->trial.strays;
    }
    shot_release(&shot);
    shot_release(&way);
    shot_release(&truth);
    return is_done;
}

/** @return Whether a pixel is in the part of the picture that is timed: whole blocks, as pictures
 *          are drawn, here and there. See #PixelTest. @param context Not looked at. @param x Its
 *  column. @param y Its row. */
static bool pixel_is_timed(const void *context, int x, int y) {
    (void)context;
    return (x / 64 + 5 * (y / 16)) % 32 == 0;
}

/** Times manners in turn. @param studio What is shot. @param manners The manners. @param count How
 *  many. @param[out] seconds The least time of each. @param[out] error What is wrong. @return false
 *  if anything is. */
static bool manners_time(const Studio *studio, const Manner *manners, size_t count, double *seconds,
                         Error *error) {
    for (int turn = 0; turn < TIMINGS; turn++) {
        for (size_t i = 0; i < count; i++) {
            Shot shot;
            if (!shot_take(studio, &manners[i], &shot, error)) {
                return false;
            }
            seconds[i] = turn == 0 || shot.seconds < seconds[i] ? shot.seconds : seconds[i];
            shot_release(&shot);
        }
    }
    return true;
}

/** Finds what each engine costs, and everything on. @param[in,out] pilot The pilot.
 *  @param[out] error What is wrong. @return false if anything is. */
static bool costs_find(Pilot *pilot, Error *error) {
    Needs *needs = pilot->needs;
    Manner manners[3] = {pilot->best, pilot->best, pilot->best};
    double seconds[3] = {0};
    Pixels timed;
    manners[0].engine = needs->engines[0].engine;
    manners[1].engine = needs->engines[1].engine;
    manners[2].engine = needs->engines[1].engine;
    manners[2].trace.depth = REFERENCE_DEPTH;
    manners[2].trace.cutoff = REFERENCE_CUTOFF;
    if (!pixels_make(&timed, pilot->request->width, pilot->request->height, pixel_is_timed, NULL,
                     error)) {
        return false;
    }
    Studio studio = pilot->studio;
    studio.pixels = &timed;
    bool is_timed = manners_time(&studio, manners, 3, seconds, error);
    needs->engines[0].seconds = seconds[0];
    needs->engines[1].seconds = seconds[1];
    needs->everything = seconds[2];
    pixels_release(&timed);
    return is_timed;
}

/** Tries everything. @param[in,out] pilot The pilot. @param[out] error What is wrong.
 *  @return false if anything is. */
static bool pilot_run(Pilot *pilot, Error *error) {
    return depth_find(pilot, error) && tolerance_find(pilot, error) &&
           engine_find_enough(pilot, error) && offsets_look(pilot, error) &&
           smoothness_look(pilot, error) && total_try(pilot, error) && costs_find(pilot, error);
}

bool needs_find(const Scene *scene, const NeedsRequest *request, Needs *needs, Error *error) {
    *needs = (Needs){.forecast = forecast_of(scene),
                     .is_recursive = scene_has_mirrors(scene) || scene_has_glass(scene),
                     .depth_asked = request->depth};
    Pixels pixels;
    if (!(request->is_whole
              ? pixels_make(&pixels, request->width, request->height, pixel_is_any, NULL, error)
              : pixels_make_pilot(&pixels, scene, request->width, request->height, error))) {
        return false;
    }
    Pilot pilot = {
        .request = request,
        .studio = {scene, &pixels, request->threads, request->stop},
        .best = {.engine = single_engine(double_engine()), .trace = *request->trace, .rays = 1},
        .encoding = (Encoding)scene->image.encoding,
        .needs = needs};
    pilot.best.trace.samples = request->samples;
    pilot.best.trace.depth = 0;
    bool is_done = pilot_run(&pilot, error);
    pixels_release(&pixels);
    return is_done;
}
