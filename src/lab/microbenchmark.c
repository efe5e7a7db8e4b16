/**
 * @file
 * @brief Measures the time per test of each method.
 *
 * All methods in all number types are timed in turn, several times, so that a drift of the clock
 * affects all alike. Each test includes a call through a function pointer. The tracer's engines
 * with one lane stand among them: by #Engine.closest_hits, with all rays in one call, or, where an
 * experiment asks for more than a hit, by what it asks.
 */
#include "lab/microbenchmark.h"

#include "base/clock.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Inputs of a method: so few that they stay in the cache. */
enum { INPUT_COUNT = 256 };
/** How often each method is timed. */
enum { TURNS = 11 };
/** Least time of a turn, seconds. */
#define TURN_SECONDS 3e-4
/** Most samples for errors. */
enum { ERROR_SAMPLES_MAXIMUM = 10000 };

/** A method or an engine that is timed. */
typedef struct TimedMethod {
    const NumberType *type;       /**< The number type. */
    const MethodFamily *family;   /**< The family, in the number type. */
    const Method *method;         /**< The method; NULL: the engine is timed. */
    void *packed_inputs;          /**< Its inputs; owned. NULL: of an engine. */
    const Experiment *experiment; /**< Of an engine. */
    const Engine *engine;         /**< The engine, or NULL. */
    Tracer *tracer;               /**< Its tracer; owned. */
    RayQuery *rays;               /**< Its rays; owned. NULL: #samples are asked instead. */
    ExperimentSample *samples;    /**< The inputs; owned. */
    int rounds;                   /**< Passes over the inputs per turn. */
    double ns[TURNS];             /**< Time per test in each turn. */
} TimedMethod;

/** Runs an engine on all inputs. */
static void engine_run(const TimedMethod *timed) {
    Quadruple outputs[SAMPLE_QUERIES_MAXIMUM * METHOD_NUMBERS_MAXIMUM];
    int shapes[INPUT_COUNT];
    double distances[INPUT_COUNT];
    if (timed->rays) {
        timed->engine->closest_hits(timed->tracer, INPUT_COUNT, timed->rays, shapes, distances);
        return;
    }
    for (int i = 0; i < INPUT_COUNT; i++) {
        timed->experiment->query_engine(timed->engine, timed->tracer, &timed->samples[i], outputs);
    }
}

/** @return The CPU time of a turn, seconds. */
static double time_rounds(const TimedMethod *timed) {
    double start = clock_thread_cpu_seconds();
    for (int i = 0; i < timed->rounds; i++) {
        if (timed->method) {
            timed->type->evaluate_packed(timed->family, timed->method, INPUT_COUNT,
                                         timed->packed_inputs);
        } else {
            engine_run(timed);
        }
    }
    return clock_thread_cpu_seconds() - start;
}

/** Generates the samples that are timed, the same for all. @return They, to be released with free;
 *  NULL without memory. */
static ExperimentSample *generate_samples(const Experiment *experiment,
                                          const ExperimentSetup *setup) {
    ExperimentSample *samples = calloc(INPUT_COUNT, sizeof *samples);
    Random random = {20261121};
    for (size_t i = 0; samples && i < INPUT_COUNT; i++) {
        experiment->generate(setup, &random, &samples[i]);
    }
    return samples;
}

/** Packs the inputs of a method. @return false without memory. */
static bool pack_method_inputs(TimedMethod *timed) {
    size_t numbers = (size_t)timed->family->input_count;
    Quadruple *inputs = calloc(INPUT_COUNT * numbers, sizeof *inputs);
    for (size_t i = 0; inputs && i < INPUT_COUNT; i++) {
        memcpy(inputs + i * numbers, timed->samples[i].inputs, numbers * sizeof *inputs);
    }
    timed->packed_inputs =
        inputs ? timed->type->pack_inputs(timed->family, INPUT_COUNT, inputs) : NULL;
    free(inputs);
    return timed->packed_inputs != NULL;
}

/** Makes the rays of an engine, with which the inputs begin. @return false without memory. */
static bool make_engine_rays(TimedMethod *timed) {
    timed->rays = calloc(INPUT_COUNT, sizeof *timed->rays);
    for (int i = 0; timed->rays && i < INPUT_COUNT; i++) {
        for (int k = 0; k < 3; k++) {
            timed->rays[i].origin[k] = (double)timed->samples[i].inputs[k];
            timed->rays[i].direction[k] = (double)timed->samples[i].inputs[3 + k];
        }
    }
    return timed->rays != NULL;
}

/** Prepares an engine. @return false if anything is wrong. */
static bool prepare_engine(TimedMethod *timed, const ExperimentSetup *setup) {
    const Experiment *experiment = timed->experiment;
    timed->engine = experiment_engine(timed->type);
    timed->tracer = experiment_create_tracer(experiment, timed->engine, setup);
    bool is_nearest_hit = !experiment->query_engine || experiment->is_nearest_hit;
    return timed->tracer && (!is_nearest_hit || make_engine_rays(timed));
}

/** @return A method of a family, or NULL: an engine. */
static const Method *family_method(const MethodFamily *family, const char *name) {
    const Method *method = family->methods;
    while (method->name && strcmp(method->name, name) != 0) {
        method++;
    }
    return method->name ? method : NULL;
}

/** Prepares a method or an engine. @param result Names it and the level. @return false if anything
 *  is wrong. */
static bool timed_method_init(const Experiment *experiment, const MethodResult *result,
                              TimedMethod *timed) {
    const NumberType *const *type = number_types();
    while (strcmp((*type)->name, result->type) != 0) {
        type++;
    }
    const MethodFamily *family = number_type_family(*type, experiment->family);
    *timed = (TimedMethod){.type = *type,
                           .family = family,
                           .method = family_method(family, result->method),
                           .experiment = experiment,
                           .rounds = 1};
    void *shared = experiment->create_shared ? experiment->create_shared(result->level) : NULL;
    if (experiment->create_shared && !shared) {
        return false;
    }
    ExperimentSetup setup = {*type, result->level, shared};
    timed->samples = generate_samples(experiment, &setup);
    bool is_ready = timed->samples &&
                    (timed->method ? pack_method_inputs(timed) : prepare_engine(timed, &setup));
    free(shared);
    return is_ready;
}

/** Releases what a method or an engine owns. */
static void timed_method_deinit(TimedMethod *timed) {
    if (timed->tracer) {
        timed->engine->destroy(timed->tracer);
    }
    free(timed->packed_inputs);
    free(timed->rays);
    free(timed->samples);
}

/** Finds how many rounds a turn needs; the first round warms up. */
static void calibrate_rounds(TimedMethod *timed) {
    time_rounds(timed);
    while (time_rounds(timed) < TURN_SECONDS) {
        timed->rounds *= 2;
    }
}

/** Times methods in turn. */
static void time_methods(TimedMethod *timed, size_t count, const atomic_bool *stop) {
    for (size_t i = 0; i < count; i++) {
        calibrate_rounds(&timed[i]);
    }
    for (int turn = 0; turn < TURNS && !(stop && atomic_load(stop)); turn++) {
        for (size_t i = 0; i < count; i++) {
            double tests = (double)INPUT_COUNT * timed[i].rounds;
            timed[i].ns[turn] = 1e9 * time_rounds(&timed[i]) / tests;
        }
    }
}

/** Times all methods of a benchmark. @return false if anything is wrong. */
static bool measure_times(const Experiment *experiment, const atomic_bool *stop,
                          Microbenchmark *benchmark, Error *error) {
    TimedMethod timed[MICROBENCHMARK_POINTS_MAXIMUM] = {{0}};
    bool has_room = true;
    for (size_t i = 0; i < benchmark->count && has_room; i++) {
        has_room = timed_method_init(experiment, &benchmark->points[i].result, &timed[i]);
    }
    if (has_room) {
        time_methods(timed, benchmark->count, stop);
    }
    for (size_t i = 0; i < benchmark->count; i++) {
        benchmark->points[i].ns = quartiles_of(timed[i].ns, TURNS);
        timed_method_deinit(&timed[i]);
    }
    if (stop && atomic_load(stop)) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    return has_room || error_set(error, STATUS_FAILED, "no memory for a clock");
}

/** Adds a method in a number type, at its best level. @param levels Its results at each. */
static void add_best_level(Microbenchmark *benchmark, const MethodResult *levels, size_t count) {
    const MethodResult *best = levels;
    for (size_t i = 1; i < count; i++) {
        best = levels[i].p999 < best->p999 ? &levels[i] : best;
    }
    if (best->sample_count > 0 && benchmark->count < MICROBENCHMARK_POINTS_MAXIMUM) {
        benchmark->points[benchmark->count++] = (MicrobenchmarkPoint){.result = *best};
    }
}

bool microbenchmark_measure(const Experiment *experiment, int threads, const atomic_bool *stop,
                            Microbenchmark *benchmark, Error *error) {
    Experiment timed = *experiment;
    ExperimentResults results;
    timed.sample_count =
        timed.sample_count < ERROR_SAMPLES_MAXIMUM ? timed.sample_count : ERROR_SAMPLES_MAXIMUM;
    if (experiment->timed_level > 0) {
        timed.levels = &experiment->timed_level;
        timed.level_count = 1;
    }
    *benchmark = (Microbenchmark){.count = 0};
    if (!experiment_run(&timed, threads, stop, &results, error)) {
        return false;
    }
    for (size_t m = 0; m < results.method_count; m++) {
        for (size_t t = 0; t < results.type_count; t++) {
            add_best_level(benchmark, experiment_results_at(&results, m, t, 0),
                           results.level_count);
        }
    }
    experiment_results_deinit(&results);
    return measure_times(experiment, stop, benchmark, error);
}
