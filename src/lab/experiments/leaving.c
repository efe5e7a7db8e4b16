/**
 * @file
 * @brief Experiments on rays that leave a surface: mirrored ones meet it again (acne), refracted
 *        ones do not come out where they should.
 */
#include "dioptre/language.h"
#include "lab/experiments/experiments.h"
#include "lab/experiments/pose.h"

/** Index of glass over air, upside down: as Snell's law wants it for a ray that goes in. */
#define RATIO (1 / 1.5)
/** Of the way through the glass, what a second ray may be off. */
#define SHARE_OFF 0.01

/** A sphere that rays meet and leave. */
typedef struct Ball {
    Quad3 center;     /**< Where, exact in float. */
    Quadruple radius; /**< How large, exact in float. */
    double ratio;     /**< For refraction: #RATIO; 0: it mirrors. */
} Ball;

/** @return How far it is through the glass. @param point Where a ray meets the sphere, from its
 *  centre, over the radius. @param direction Which way it goes, of length 1. */
static Quadruple way_through(Quad3 point, Quad3 direction) {
    // The refracted ray's cosine by Snell; the way is the chord of the sphere.
    Quadruple cosine = -quad3_dot(point, direction);
    return 2 * quad_sqrt(1 - (Quadruple)RATIO * RATIO * (1 - cosine * cosine));
}

/** Poses a ray to a ball from three radii away. @param setting Where. @param ball The ball.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose(const Setting *setting, const Ball *ball, Random *random, Case *posed) {
    Writer writer = {setting->type, posed->questions};
    Quad3 outwards = random_direction(random);
    Quad3 place = quad3_add(ball->center, quad3_scale(outwards, 3 * ball->radius));
    Quad3 origin = write_vector(&writer, place);
    Quad3 beside = random_across(random, outwards, 0.95);
    Quad3 target = quad3_add(ball->center, quad3_scale(beside, ball->radius));
    Quad3 direction = write_vector(&writer, quad3_normalize(quad3_subtract(target, origin)));
    write_vector(&writer, ball->center);
    write_number(&writer, ball->radius);
    write_number(&writer, ball->ratio);
    Quadruple t = sphere_truth(origin, direction, ball->center, ball->radius);
    Quad3 point = quad3_add(origin, quad3_scale(direction, t));
    Quad3 arm = quad3_scale(quad3_subtract(point, ball->center), 1 / ball->radius);
    posed->truth[0] = ball->radius;
    posed->truth[1] = ball->radius * way_through(arm, quad3_normalize(direction));
}

/** Judges a second ray. @param posed The case. @param is_wrong Whether it met what it should not.
 *  @param shift How far it was moved. @param[in,out] score The score. */
static void judge_second(const Case *posed, bool is_wrong, Quadruple shift, Score *score) {
    score_outcome(score, OUTCOME_WRONG, is_wrong);
    score_error(score, shift / posed->truth[0]);
}

/** Judges a mirrored ray: it meets nothing. See #Experiment.judge. @param posed The case.
 *  @param answers Distance and shift. @param[in,out] score The score. */
static void judge_mirrored(const Case *posed, const Quadruple *answers, Score *score) {
    judge_second(posed, answers[0] < QUAD_NONE, answers[1], score);
}

/** Judges a refracted ray: it meets the other side. See #Experiment.judge. @param posed The case.
 *  @param answers Distance and shift. @param[in,out] score The score. */
static void judge_refracted(const Case *posed, const Quadruple *answers, Score *score) {
    Quadruple off = quad_abs(answers[0] - posed->truth[1]);
    judge_second(posed, !(off < SHARE_OFF * posed->truth[1]), answers[1], score);
}

/** @return A ray's direction after a surface, of length 1. @param d Before. @param n The surface's
 *  normal, outwards. @param ratio See #Ball. */
static Quad3 after(Quad3 d, Quad3 n, Quadruple ratio) {
    Quadruple cosine = -quad3_dot(d, n);
    if (ratio == 0) {
        return quad3_normalize(quad3_add(d, quad3_scale(n, 2 * cosine)));
    }
    Quadruple k = 1 - ratio * ratio * (1 - cosine * cosine);
    Quad3 onward = quad3_scale(n, ratio * cosine - quad_sqrt(k));
    return quad3_normalize(quad3_add(quad3_scale(d, ratio), onward));
}

/** @return Where the tracer starts a second ray (src/trace/departure.h). @param hit The hit.
 *  @param d Which way the second ray goes. */
static Quad3 departure(const RayAnswer *hit, Quad3 d) {
    Quad3 point = quad3_of(hit->point), n = quad3_of(hit->normal);
    Quadruple cosine = quad3_dot(d, n), through = 2 * hit->error;
    if (cosine > 0) {
        return quad3_add(point, quad3_scale(n, hit->error));
    }
    const Quadruple least = 0.0625;
    return quad3_add(point, quad3_scale(d, through / (-cosine > least ? -cosine : least)));
}

/** Asks an engine for both rays. See #Experiment.ask. @param engine The engine. @param tracer Its
 *  tracer. @param posed The case. @param[out] answers Distance and shift. */
static void ask(const Engine *engine, Tracer *tracer, const Case *posed, Quadruple *answers) {
    const Quadruple *q = posed->questions;
    const Quad3 first[2] = {quad3_of(q), quad3_of(q + 3)};
    RayAnswer hit, again;
    engine_ask(engine, tracer, first, &hit);
    Quad3 onward = after(first[1], quad3_of(hit.normal), q[10]);
    Quad3 start = departure(&hit, onward);
    engine_ask(engine, tracer, (const Quad3[]){start, onward}, &again);
    answers[0] = again.shape < 0 ? QUAD_NONE : again.distance;
    answers[1] = quad3_length(quad3_subtract(start, quad3_of(hit.point)));
}

/* --- small and large --- */

/** Scene units. */
static const double scales[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1, 10, 1e2, 1e3, 1e4, 1e5, 1e6};

/** @return A ball that lies one radius beside the origin. @param radius Its radius. @param ratio
 *  See #Ball. */
static Ball ball_of(double radius, double ratio) {
    return (Ball){place_far(radius), number_types()[0]->round(radius), ratio};
}

/** Poses a mirror, small or large. See #Experiment.pose. @param setting Where. @param[in,out]
 * random Where it comes from. @param[out] posed The case. */
static void pose_mirror_scale(const Setting *setting, Random *random, Case *posed) {
    Ball ball = ball_of(setting->level, 0);
    pose(setting, &ball, random, posed);
}

/** Poses a ball of glass, small or large. See #Experiment.pose. @param setting Where.
 *  @param[in,out] random Where it comes from. @param[out] posed The case. */
static void pose_glass_scale(const Setting *setting, Random *random, Case *posed) {
    Ball ball = ball_of(setting->level, RATIO);
    pose(setting, &ball, random, posed);
}

/** @return Its scene. See #Experiment.scene. @param setting Where. @param[out] error What is wrong.
 */
static Scene *scene_scale(const Setting *setting, Error *error) {
    Ball ball = ball_of(setting->level, 0);
    return sphere_scene(ball.center, (double)ball.radius, error);
}

const Experiment mirror_scale_experiment = {
    .name = "mirror-scale",
    .title = N_("Rays that leave a mirroring sphere, small and large: which meet it again?"),
    .family = "leaving",
    .stress = N_("radius, scene units"),
    .error = N_("shift of the start over the radius"),
    .levels = scales,
    .level_count = COUNT_OF(scales),
    .cases = 10000,
    .parts = 1,
    .timed = 1e3,
    .pose = pose_mirror_scale,
    .judge = judge_mirrored,
    .scene = scene_scale,
    .ask = ask,
};

const Experiment glass_scale_experiment = {
    .name = "glass-scale",
    .title = N_("Rays that go into a sphere of glass, small and large: which come out wrong?"),
    .family = "leaving",
    .stress = N_("radius, scene units"),
    .error = N_("shift of the start over the radius"),
    .levels = scales,
    .level_count = COUNT_OF(scales),
    .cases = 10000,
    .parts = 1,
    .timed = 1e3,
    .pose = pose_glass_scale,
    .judge = judge_refracted,
    .scene = scene_scale,
    .ask = ask,
};

/* --- far from the origin of the world --- */

/** Radii. */
static const double offsets[] = {1, 10, 1e2, 1e3, 1e4, 1e5};

/** Poses a mirror far away. See #Experiment.pose. @param setting Where. @param[in,out] random Where
 *  it comes from. @param[out] posed The case. */
static void pose_mirror_world(const Setting *setting, Random *random, Case *posed) {
    pose(setting, &(Ball){place_far(setting->level), 1, 0}, random, posed);
}

/** Poses a ball of glass far away. See #Experiment.pose. @param setting Where. @param[in,out]
 * random Where it comes from. @param[out] posed The case. */
static void pose_glass_world(const Setting *setting, Random *random, Case *posed) {
    pose(setting, &(Ball){place_far(setting->level), 1, RATIO}, random, posed);
}

/** @return Its scene. See #Experiment.scene. @param setting Where. @param[out] error What is wrong.
 */
static Scene *scene_world(const Setting *setting, Error *error) {
    return sphere_scene(place_far(setting->level), 1, error);
}

const Experiment mirror_world_experiment = {
    .name = "mirror-world",
    .title = N_("Rays that leave a mirroring sphere far from the origin: which meet it again?"),
    .family = "leaving",
    .stress = N_("distance from the origin / radius"),
    .error = N_("shift of the start over the radius"),
    .levels = offsets,
    .level_count = COUNT_OF(offsets),
    .cases = 10000,
    .parts = 1,
    .pose = pose_mirror_world,
    .judge = judge_mirrored,
    .scene = scene_world,
    .ask = ask,
};

const Experiment glass_world_experiment = {
    .name = "glass-world",
    .title = N_("Rays that go into a sphere of glass far from the origin: which come out wrong?"),
    .family = "leaving",
    .stress = N_("distance from the origin / radius"),
    .error = N_("shift of the start over the radius"),
    .levels = offsets,
    .level_count = COUNT_OF(offsets),
    .cases = 10000,
    .parts = 1,
    .pose = pose_glass_world,
    .judge = judge_refracted,
    .scene = scene_world,
    .ask = ask,
};
