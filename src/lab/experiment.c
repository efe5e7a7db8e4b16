/**
 * @file
 * @brief Runs experiments: a task per level and number type.
 */
#include "lab/experiment.h"

#include "render/thread_pool.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Samples that are generated before any method runs: they stay in the cache. */
enum { SAMPLE_CHUNK = 64 };
/** Quad is a hundred times slower: it gets one sample of so many. */
enum { QUAD_SAMPLE_DIVISOR = 16 };

extern const NumberType number_float;    /**< 24 bits. */
extern const NumberType number_double;   /**< 53 bits. */
extern const NumberType number_extended; /**< Long double: 64 bits on x86. */
extern const NumberType number_quad;     /**< 113 bits. */

const MethodFamily *number_type_family(const NumberType *type, const char *name) {
    const MethodFamily *const *family = type->families;
    while (*family && strcmp((*family)->name, name) != 0) {
        family++;
    }
    return *family;
}

const NumberType *const *number_types(void) {
    static const NumberType *const types[] = {&number_float, &number_double, &number_extended,
                                              &number_quad, NULL};
    // On some machines long double is double or quad.
    static const NumberType *const types_without_extended[] = {&number_float, &number_double,
                                                               &number_quad, NULL};
    bool is_own = number_extended.mantissa_bits != number_double.mantissa_bits &&
                  number_extended.mantissa_bits != number_quad.mantissa_bits;
    return is_own ? types : types_without_extended;
}

/** Most methods of a family, and the engine. */
enum { METHODS_MAXIMUM = 16 };

/** What is run: a method in a number type, or an engine. */
typedef struct MethodSubject {
    const Experiment *experiment; /**< The experiment. */
    const ExperimentSetup *setup; /**< The level and the number type. */
    const MethodFamily *family;   /**< The family, in the number type. */
    const Method *method;         /**< The method; NULL: the engine is run. */
    const Engine *engine;         /**< The engine of the number type; NULL: none. */
    Tracer *tracer;               /**< Its tracer, or NULL. */
} MethodSubject;

/** An experiment in progress. */
typedef struct ExperimentRun {
    const Experiment *experiment; /**< The experiment. */
    const atomic_bool *stop;      /**< Whether to give up. */
    size_t method_count;          /**< Methods of the family; the engine comes after them. */
    ExperimentResults *results;   /**< The results. */
    atomic_bool has_failed;       /**< Whether memory was short. */
} ExperimentRun;

const Engine *experiment_engine(const NumberType *type) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if ((*engine)->lanes == 1 && (*engine)->mantissa_bits == type->mantissa_bits) {
            return *engine;
        }
    }
    return NULL;
}

/** Finds the nearest hit by an engine. @param input Begins with a ray. @param[out] distance Or
 *  #QUAD_NO_HIT. */
static void query_engine_distance(const MethodSubject *subject, const Quadruple *input,
                                  Quadruple *distance) {
    RayQueryQuad ray;
    RayResult answer;
    memcpy(ray.origin, input, sizeof ray.origin);
    memcpy(ray.direction, input + 3, sizeof ray.direction);
    subject->engine->intersect(subject->tracer, 1, &ray, &answer);
    *distance = answer.shape < 0 ? QUAD_NO_HIT : answer.distance;
}

/** Computes the outputs of all queries of a sample. */
static void query_subject(const MethodSubject *subject, const ExperimentSample *sample,
                          Quadruple *outputs) {
    const Experiment *experiment = subject->experiment;
    if (subject->method) {
        subject->setup->type->evaluate(subject->family, subject->method,
                                       experiment->queries_per_sample, sample->inputs, outputs);
    } else if (experiment->query_engine) {
        experiment->query_engine(subject->engine, subject->tracer, sample, outputs);
    } else {
        query_engine_distance(subject, sample->inputs, outputs);
    }
}

/** @return Samples for a number type. */
static size_t sample_count_for(const Experiment *experiment, const NumberType *type) {
    bool is_quad = type->mantissa_bits > 64;
    return is_quad ? (experiment->sample_count + QUAD_SAMPLE_DIVISOR - 1) / QUAD_SAMPLE_DIVISOR
                   : experiment->sample_count;
}

/** Summarizes scores in a result. */
static void summarize_score(ScoreStats *score, MethodResult *result) {
    result->median = score_quantile(score, 0.5);
    result->p999 = score_quantile(score, 0.999);
    result->maximum = score_quantile(score, 1);
    for (int i = 0; i < OUTCOME_COUNT; i++) {
        result->outcome_fractions[i] = score_fraction(score, (Outcome)i);
    }
    result->failure_fraction = score_failure_fraction(score);
    result->mean_cost =
        score->cost_count ? score->cost_sum / (double)score->cost_count : (double)NAN;
}

/** @return Whether an experiment is stopped. */
static bool run_is_stopped(const ExperimentRun *run) {
    return run->stop && atomic_load(run->stop);
}

/** Generates samples, and scores all methods. @param subjects As many as methods of the results. */
static void score_samples(const ExperimentRun *run, const MethodSubject *subjects,
                          const ExperimentSetup *setup, ScoreStats *scores) {
    const Experiment *experiment = run->experiment;
    static const uint64_t seed = 20261121;
    Random random = {seed};
    Quadruple outputs[SAMPLE_QUERIES_MAXIMUM * METHOD_NUMBERS_MAXIMUM];
    ExperimentSample samples[SAMPLE_CHUNK];
    for (size_t left = sample_count_for(experiment, setup->type);
         left > 0 && !run_is_stopped(run);) {
        size_t count = left < SAMPLE_CHUNK ? left : SAMPLE_CHUNK;
        for (size_t i = 0; i < count; i++) {
            samples[i] = (ExperimentSample){0};
            experiment->generate(setup, &random, &samples[i]);
        }
        for (size_t m = 0; m < run->results->method_count; m++) {
            for (size_t i = 0; i < count && (subjects[m].method || subjects[m].tracer); i++) {
                query_subject(&subjects[m], &samples[i], outputs);
                experiment->score_sample(&samples[i], outputs, &scores[m]);
                score_end_sample(&scores[m]);
            }
        }
        left -= count;
    }
}

Tracer *experiment_create_tracer(const Experiment *experiment, const Engine *engine,
                                 const ExperimentSetup *setup) {
    Error error = {0};
    TraceSettings settings = {.offset = OFFSET_BOUND};
    Scene *scene =
        engine && experiment->create_scene ? experiment->create_scene(setup, &error) : NULL;
    Tracer *tracer = scene ? engine->create_tracer(scene, &settings, &error) : NULL;
    scene_destroy(scene);
    return tracer;
}

/** Stores the results of a level. @param[in,out] scores Per method; released. */
static void store_results(ExperimentRun *run, const MethodSubject *subjects, ScoreStats *scores,
                          size_t index) {
    ExperimentResults *results = run->results;
    const ExperimentSetup *setup = subjects->setup;
    for (size_t m = 0; m < results->method_count; m++) {
        const Method *method = subjects[m].method;
        bool is_included = method || subjects[m].tracer;
        MethodResult *result = experiment_results_at(results, m, index % results->type_count,
                                                     index / results->type_count);
        *result = (MethodResult){
            .method = method ? method->name : TRACER_METHOD,
            .label = method ? method->label : TRACER_METHOD,
            .type = setup->type->name,
            .mantissa_bits = setup->type->mantissa_bits,
            .level = setup->level,
            .sample_count = is_included ? sample_count_for(run->experiment, setup->type) : 0};
        summarize_score(&scores[m], result);
        if (scores[m].is_out_of_memory) {
            atomic_store(&run->has_failed, true);
        }
        score_deinit(&scores[m]);
    }
}

/** Runs a level in a number type. @param index Of the task. */
static void run_level(ExperimentRun *run, const ExperimentSetup *setup, size_t index) {
    const Engine *engine = experiment_engine(setup->type);
    Tracer *tracer = experiment_create_tracer(run->experiment, engine, setup);
    const MethodFamily *family = number_type_family(setup->type, run->experiment->family);
    MethodSubject subjects[METHODS_MAXIMUM];
    ScoreStats scores[METHODS_MAXIMUM] = {{0}};
    for (size_t m = 0; m < run->results->method_count; m++) {
        const Method *method = m < run->method_count ? &family->methods[m] : NULL;
        subjects[m] = (MethodSubject){run->experiment, setup, family, method, engine, tracer};
    }
    score_samples(run, subjects, setup, scores);
    store_results(run, subjects, scores, index);
    if (tracer) {
        engine->destroy(tracer);
    }
}

/** Is a ThreadPoolTask: a level in a number type. @param index Level times number types, plus the
 *  number type. */
static void run_level_task(void *context, size_t index) {
    ExperimentRun *run = context;
    const Experiment *experiment = run->experiment;
    size_t types = run->results->type_count;
    double level = experiment->levels[index / types];
    void *shared = experiment->create_shared ? experiment->create_shared(level) : NULL;
    if (experiment->create_shared && !shared) {
        atomic_store(&run->has_failed, true);
        return;
    }
    run_level(run, &(ExperimentSetup){number_types()[index % types], level, shared}, index);
    free(shared);
}

/** Counts the methods of the family. @return How many, with the engine. */
static size_t count_methods(ExperimentRun *run) {
    const MethodFamily *family = number_type_family(&number_float, run->experiment->family);
    while (family->methods[run->method_count].name && run->method_count < METHODS_MAXIMUM - 1) {
        run->method_count++;
    }
    return run->method_count + (run->experiment->create_scene != NULL);
}

/** @return The number of number types. */
static size_t number_type_count(void) {
    size_t count = 0;
    while (number_types()[count]) {
        count++;
    }
    return count;
}

/** Runs all tasks. @return false if anything is wrong. */
static bool run_all_levels(ExperimentRun *run, int threads, Error *error) {
    ExperimentResults *results = run->results;
    ThreadPool *workers = thread_pool_create(threads, error);
    if (!workers) {
        return false;
    }
    thread_pool_run(workers, results->type_count * results->level_count, run_level_task, run);
    thread_pool_destroy(workers);
    if (run_is_stopped(run)) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    return !atomic_load(&run->has_failed) ||
           error_set(error, STATUS_FAILED, "no memory for what %s finds", run->experiment->name);
}

bool experiment_run(const Experiment *experiment, int threads, const atomic_bool *stop,
                    ExperimentResults *results, Error *error) {
    ExperimentRun run = {.experiment = experiment, .stop = stop, .results = results};
    *results = (ExperimentResults){.method_count = count_methods(&run),
                                   .type_count = number_type_count(),
                                   .level_count = experiment->level_count};
    size_t rows = results->method_count * results->type_count * results->level_count;
    results->rows = calloc(rows, sizeof *results->rows);
    if (!results->rows) {
        return error_set(error, STATUS_FAILED, "no memory for what %s finds", experiment->name);
    }
    if (!run_all_levels(&run, threads, error)) {
        experiment_results_deinit(results);
        return false;
    }
    return true;
}

MethodResult *experiment_results_at(const ExperimentResults *results, size_t method, size_t type,
                                    size_t level) {
    return &results->rows[(method * results->type_count + type) * results->level_count + level];
}

const MethodResult *experiment_results_find(const ExperimentResults *results, const char *method,
                                            const char *type, double level) {
    size_t count = results->method_count * results->type_count * results->level_count;
    for (size_t i = 0; i < count; i++) {
        const MethodResult *row = &results->rows[i];
        if (row->sample_count > 0 && row->level == level && strcmp(row->method, method) == 0 &&
            strcmp(row->type, type) == 0) {
            return row;
        }
    }
    return NULL;
}

void experiment_results_deinit(ExperimentResults *results) {
    free(results->rows);
    *results = (ExperimentResults){0};
}
