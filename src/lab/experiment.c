/**
 * @file
 * @brief Experiments are made: each level in each number type is a piece of work of its own.
 */
#include "lab/experiment.h"

#include "render/workers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Cases that are posed before any method is asked: they stay in the cache. */
enum { CHUNK = 64 };
/** Quad numbers are a hundred times slower: of so many cases they get one. */
enum { QUAD_SHARE = 16 };

extern const NumberType number_float;    /**< 24 bits. */
extern const NumberType number_double;   /**< 53 bits. */
extern const NumberType number_extended; /**< Long double: 64 bits on x86. */
extern const NumberType number_quad;     /**< 113 bits. */

const NumberType *const *number_types(void) {
    static const NumberType *const types[] = {&number_float, &number_double, &number_extended,
                                              &number_quad, NULL};
    // Where long double is double or quad under another name it says nothing of its own.
    static const NumberType *const few[] = {&number_float, &number_double, &number_quad, NULL};
    bool is_own = number_extended.mantissa_bits != number_double.mantissa_bits &&
                  number_extended.mantissa_bits != number_quad.mantissa_bits;
    return is_own ? types : few;
}

/** Most methods of a family, with the engine. */
enum { METHODS_MAXIMUM = 16 };

/** Somebody who is asked: a method in a number type, or an engine. */
typedef struct Subject {
    const Experiment *experiment; /**< In this experiment. */
    const Setting *setting;       /**< Where. */
    const Method *method;         /**< The method; NULL: the engine is asked. */
    const Engine *engine;         /**< The engine of the type; NULL: there is none. */
    Tracer *tracer;               /**< Its tracer, or NULL. */
} Subject;

/** An experiment that is being made. */
typedef struct Making {
    const Experiment *experiment;   /**< The experiment. */
    const atomic_bool *stop;        /**< Whether to give up. */
    size_t places[METHODS_MAXIMUM]; /**< The methods of the family, by #NumberType.methods. */
    size_t place_count;             /**< How many; whoever comes after them is an engine. */
    Findings *findings;             /**< What was found. */
    atomic_bool has_failed;         /**< Whether there was no memory. */
} Making;

/** @return The engine of one ray at a time with a number type; NULL: there is none.
 *  @param type The number type. */
static const Engine *engine_of(const NumberType *type) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if ((*engine)->lanes == 1 && (*engine)->mantissa_bits == type->mantissa_bits) {
            return *engine;
        }
    }
    return NULL;
}

/** Asks an engine for the nearest hit. @param subject Who. @param question A ray, to begin with.
 *  @param[out] distance How far, or #QUAD_NONE. */
static void ask_distance(const Subject *subject, const Quadruple *question, Quadruple *distance) {
    RayQuery ray;
    RayAnswer answer;
    memcpy(ray.origin, question, sizeof ray.origin);
    memcpy(ray.direction, question + 3, sizeof ray.direction);
    subject->engine->intersect(subject->tracer, 1, &ray, &answer);
    *distance = answer.shape < 0 ? QUAD_NONE : answer.distance;
}

/** Asks somebody all questions of a case. @param subject Who. @param posed The case.
 *  @param[out] answers The answers. */
static void ask(const Subject *subject, const Case *posed, Quadruple *answers) {
    const Experiment *experiment = subject->experiment;
    if (subject->method) {
        subject->setting->type->ask(subject->method, experiment->parts, posed->questions, answers);
    } else if (experiment->ask) {
        experiment->ask(subject->engine, subject->tracer, posed, answers);
    } else {
        ask_distance(subject, posed->questions, answers);
    }
}

/** @return Cases for a number type. @param experiment The experiment. @param type The type. */
static size_t case_count(const Experiment *experiment, const NumberType *type) {
    bool is_quad = type->mantissa_bits > 64;
    return is_quad ? (experiment->cases + QUAD_SHARE - 1) / QUAD_SHARE : experiment->cases;
}

/** Writes down what a score has come to. @param[in,out] score The score; sorted.
 *  @param[out] finding Where to. */
static void conclude(Score *score, Finding *finding) {
    finding->median = score_quantile(score, 0.5);
    finding->p999 = score_quantile(score, 0.999);
    finding->maximum = score_quantile(score, 1);
    for (int i = 0; i < OUTCOME_COUNT; i++) {
        finding->shares[i] = score_share(score, (Outcome)i);
    }
    finding->work = score->worked ? score->work / (double)score->worked : (double)NAN;
}

/** @return Whether an experiment is to be given up. @param making The experiment. */
static bool is_stopped(const Making *making) {
    return making->stop && atomic_load(making->stop);
}

/**
 * Asks everybody about a number of cases.
 * @param making        The experiment.
 * @param subjects      Who is asked, as many as methods.
 * @param setting       Where.
 * @param[out] scores  A score each.
 */
static void ask_all(const Making *making, const Subject *subjects, const Setting *setting,
                    Score *scores) {
    const Experiment *experiment = making->experiment;
    static const uint64_t seed = 20261121;
    Random random = {seed};
    Quadruple answers[CASE_PARTS_MAXIMUM * METHOD_NUMBERS_MAXIMUM];
    Case cases[CHUNK];
    for (size_t left = case_count(experiment, setting->type); left > 0 && !is_stopped(making);) {
        size_t count = left < CHUNK ? left : CHUNK;
        for (size_t i = 0; i < count; i++) {
            cases[i] = (Case){0};
            experiment->pose(setting, &random, &cases[i]);
        }
        for (size_t m = 0; m < making->findings->method_count; m++) {
            for (size_t i = 0; i < count && (subjects[m].method || subjects[m].tracer); i++) {
                ask(&subjects[m], &cases[i], answers);
                experiment->judge(&cases[i], answers, &scores[m]);
            }
        }
        left -= count;
    }
}

/**
 * Makes the tracer of an engine.
 * @param experiment  The experiment.
 * @param engine      The engine; may be NULL.
 * @param setting     Where.
 * @return The tracer, or NULL where there is none.
 */
static Tracer *tracer_of(const Experiment *experiment, const Engine *engine,
                         const Setting *setting) {
    Error error = {0};
    TraceSettings settings = {.offset = OFFSET_BOUND};
    Scene *scene = engine && experiment->scene ? experiment->scene(setting, &error) : NULL;
    Tracer *tracer = scene ? engine->prepare(scene, &settings, &error) : NULL;
    scene_destroy(scene);
    return tracer;
}

/** @return A method in a number type; NULL for the engine. @param making The experiment.
 *  @param type The type. @param m Which, of those that are asked. */
static const Method *method_at(const Making *making, const NumberType *type, size_t m) {
    return m < making->place_count ? type->methods[making->places[m]] : NULL;
}

/** Writes down what came of all that were asked. @param[in,out] making The experiment.
 *  @param subjects Who. @param[in,out] scores Their scores; given back. @param index The piece. */
static void conclude_all(Making *making, const Subject *subjects, Score *scores, size_t index) {
    Findings *findings = making->findings;
    const Setting *setting = subjects->setting;
    for (size_t m = 0; m < findings->method_count; m++) {
        const Method *method = subjects[m].method;
        bool is_asked = method || subjects[m].tracer;
        Finding *finding =
            findings_at(findings, m, index % findings->type_count, index / findings->type_count);
        *finding = (Finding){.method = method ? method->name : OWN_METHOD,
                             .label = method ? method->label : OWN_METHOD,
                             .type = setting->type->name,
                             .mantissa_bits = setting->type->mantissa_bits,
                             .level = setting->level,
                             .cases = is_asked ? case_count(making->experiment, setting->type) : 0};
        conclude(&scores[m], finding);
        if (scores[m].is_full) {
            atomic_store(&making->has_failed, true);
        }
        score_release(&scores[m]);
    }
}

/** Makes an experiment at one level in one number type, in a world. @param[in,out] making The
 *  experiment. @param setting Where. @param index Which piece. */
static void make_in(Making *making, const Setting *setting, size_t index) {
    const Engine *engine = engine_of(setting->type);
    Tracer *tracer = tracer_of(making->experiment, engine, setting);
    Subject subjects[METHODS_MAXIMUM];
    Score scores[METHODS_MAXIMUM] = {{0}};
    for (size_t m = 0; m < making->findings->method_count; m++) {
        const Method *method = method_at(making, setting->type, m);
        subjects[m] = (Subject){making->experiment, setting, method, engine, tracer};
    }
    ask_all(making, subjects, setting, scores);
    conclude_all(making, subjects, scores, index);
    if (tracer) {
        engine->release(tracer);
    }
}

/** Makes an experiment at one level in one number type. See WorkersJob. @param context The
 *  #Making. @param index Which piece: its type counts up first. */
static void make_piece(void *context, size_t index) {
    Making *making = context;
    const Experiment *experiment = making->experiment;
    size_t types = making->findings->type_count;
    double level = experiment->levels[index / types];
    void *world = experiment->build ? experiment->build(level) : NULL;
    if (experiment->build && !world) {
        atomic_store(&making->has_failed, true);
        return;
    }
    make_in(making, &(Setting){number_types()[index % types], level, world}, index);
    free(world);
}

/** Finds who is to be asked. @param[in,out] making The experiment. @return How many, the engine
 *  counted. */
static size_t find_methods(Making *making) {
    const Method *const *methods = number_float.methods;
    for (size_t i = 0; methods[i]; i++) {
        bool is_asked = strcmp(methods[i]->family, making->experiment->family) == 0;
        if (is_asked && making->place_count < METHODS_MAXIMUM - 1) {
            making->places[making->place_count++] = i;
        }
    }
    return making->place_count + (making->experiment->scene != NULL);
}

/** @return How many number types there are. */
static size_t type_count(void) {
    size_t count = 0;
    while (number_types()[count]) {
        count++;
    }
    return count;
}

/** Does all pieces of work. @param[in,out] making The experiment. @param threads How many at once.
 *  @param[out] error What is wrong. @return Whether all was done. */
static bool make_all(Making *making, int threads, Error *error) {
    Findings *findings = making->findings;
    Workers *workers = workers_create(threads, error);
    if (!workers) {
        return false;
    }
    workers_run(workers, findings->type_count * findings->level_count, make_piece, making);
    workers_destroy(workers);
    if (is_stopped(making)) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    return !atomic_load(&making->has_failed) ||
           error_set(error, STATUS_FAILED, "no memory for what %s finds", making->experiment->name);
}

bool experiment_make(const Experiment *experiment, int threads, const atomic_bool *stop,
                     Findings *findings, Error *error) {
    Making making = {.experiment = experiment, .stop = stop, .findings = findings};
    *findings = (Findings){.method_count = find_methods(&making),
                           .type_count = type_count(),
                           .level_count = experiment->level_count};
    size_t rows = findings->method_count * findings->type_count * findings->level_count;
    findings->rows = calloc(rows, sizeof *findings->rows);
    if (!findings->rows) {
        return error_set(error, STATUS_FAILED, "no memory for what %s finds", experiment->name);
    }
    if (!make_all(&making, threads, error)) {
        findings_release(findings);
        return false;
    }
    return true;
}

Finding *findings_at(const Findings *findings, size_t method, size_t type, size_t level) {
    return &findings->rows[(method * findings->type_count + type) * findings->level_count + level];
}

const Finding *findings_find(const Findings *findings, const char *method, const char *type,
                             double level) {
    size_t count = findings->method_count * findings->type_count * findings->level_count;
    for (size_t i = 0; i < count; i++) {
        const Finding *row = &findings->rows[i];
        if (row->cases > 0 && row->level == level && strcmp(row->method, method) == 0 &&
            strcmp(row->type, type) == 0) {
            return row;
        }
    }
    return NULL;
}

void findings_release(Findings *findings) {
    free(findings->rows);
    *findings = (Findings){0};
}
