/**
 * @file
 * @brief Measuring what a test of each method costs.
 *
 * All methods in all number types are timed in turn, again and again, so that a clock that drifts
 * drifts for all. A test is a call through a pointer, which costs each the same.
 */
#include "lab/microbenchmark.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/** Questions that are asked one after the other: so few that they stay in the cache. */
enum { INPUT_COUNT = 256 };
/** How often each method is timed. */
enum { TURNS = 11 };
/** Least length of a turn, seconds. */
#define TURN_SECONDS 3e-4
/** Most cases that errors are found from. */
enum { ERROR_SAMPLES_MAXIMUM = 10000 };

/** A method that is timed. */
typedef struct TimedMethod {
    const NumberType *type;     /**< In this type. */
    const MethodFamily *family; /**< Of this family. */
    const Method *method;       /**< The method. */
    void *packed_inputs;    /**< Its questions; owned. */
    int rounds;             /**< How often they are asked in a turn. */
    double ns[TURNS];       /**< What a test cost in each turn. */
} TimedMethod;

/** @return The processor's time that this thread has used, seconds. */
static double thread_cpu_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** @return How long all questions took, seconds. */
static double time_rounds(const TimedMethod *timed) {
    double start = thread_cpu_seconds();
    for (int i = 0; i < timed->rounds; i++) {
        timed->type->evaluate_packed(timed->family, timed->method, INPUT_COUNT,
                                     timed->packed_inputs);
    }
    return thread_cpu_seconds() - start;
}

/**
 * Poses the questions of a method.
 * @param[in,out] timed  The method; gets its questions.
 * @return false without memory.
 */
static bool generate_inputs(const Experiment *experiment, const ExperimentSetup *setup,
                            TimedMethod *timed) {
    size_t numbers = (size_t)timed->family->input_count;
    Quadruple *inputs = calloc(INPUT_COUNT * numbers, sizeof *inputs);
    Random random = {20261121};
    for (size_t i = 0; inputs && i < INPUT_COUNT; i++) {
        ExperimentSample sample = {{0}, {0}};
        experiment->generate(setup, &random, &sample);
        memcpy(inputs + i * numbers, sample.inputs, numbers * sizeof *inputs);
    }
    timed->packed_inputs =
        inputs ? timed->type->pack_inputs(timed->family, INPUT_COUNT, inputs) : NULL;
    free(inputs);
    return timed->packed_inputs != NULL;
}

/**
 * Prepares a method.
 * @param result  The method and its level.
 * @return false without memory.
 */
static bool timed_method_init(const Experiment *experiment, const MethodResult *result,
                              TimedMethod *timed) {
    const NumberType *const *type = number_types();
    while (strcmp((*type)->name, result->type) != 0) {
        type++;
    }
    const MethodFamily *family = number_type_family(*type, experiment->family);
    const Method *method = family->methods;
    while (strcmp(method->name, result->method) != 0) {
        method++;
    }
    *timed = (TimedMethod){.type = *type, .family = family, .method = method, .rounds = 1};
    void *shared = experiment->create_shared ? experiment->create_shared(result->level) : NULL;
    bool is_generated =
        (!experiment->create_shared || shared) &&
        generate_inputs(experiment, &(ExperimentSetup){*type, result->level, shared}, timed);
    free(shared);
    return is_generated;
}

/** Finds how often the questions must be asked to be timed; the first round warms up. */
static void calibrate_rounds(TimedMethod *timed) {
    time_rounds(timed);
    while (time_rounds(timed) < TURN_SECONDS) {
        timed->rounds *= 2;
    }
}

/** @return Order of two numbers, for qsort. */
static int compare_numbers(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/** Writes down what a test costs. */
static void store_quartiles(TimedMethod *timed, MicrobenchmarkPoint *point) {
    qsort(timed->ns, TURNS, sizeof *timed->ns, compare_numbers);
    point->ns_low = timed->ns[TURNS / 4];
    point->ns = timed->ns[TURNS / 2];
    point->ns_high = timed->ns[TURNS - 1 - TURNS / 4];
}

/** Times methods in turn. @param stop Whether to give up. */
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

/**
 * Finds what a test of each method costs.
 * @param stop  Whether to give up.
 * @return false if anything is wrong.
 */
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
        store_quartiles(&timed[i], &benchmark->points[i]);
        free(timed[i].packed_inputs);
    }
    if (stop && atomic_load(stop)) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    return has_room || error_set(error, STATUS_FAILED, "no memory for a clock");
}

/** @return The largest share of answers that are wrong altogether; NaN where none is counted. */
static double failure_fraction(const MethodResult *result) {
    double worst = NAN;
    for (int i = 0; i < OUTCOME_COUNT; i++) {
        if (i != OUTCOME_DOUBLE_HIT) {
            worst = fmax(worst,
                         result->outcome_fractions[i]); // What is not counted is NaN, and left out.
        }
    }
    return worst;
}

/** Adds a method in a number type: at the level that suits it, where there are several. @param
 *  levels What was found at each. */
static void add_best_level(Microbenchmark *benchmark, const MethodResult *levels, size_t count) {
    const MethodResult *best = levels;
    for (size_t i = 1; i < count; i++) {
        best = levels[i].p999 < best->p999 ? &levels[i] : best;
    }
    if (best->sample_count > 0 && benchmark->count < MICROBENCHMARK_POINTS_MAXIMUM) {
        benchmark->points[benchmark->count++] =
            (MicrobenchmarkPoint){.result = *best, .failure_fraction = failure_fraction(best)};
    }
}

bool microbenchmark_measure(const Experiment *experiment, int threads, const atomic_bool *stop,
                            Microbenchmark *benchmark, Error *error) {
    Experiment timed = *experiment;
    ExperimentResults results;
    timed.create_scene = NULL; // An engine is asked another way: its time would say little.
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
