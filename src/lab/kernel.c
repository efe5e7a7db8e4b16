/**
 * @file
 * @brief Measuring what a test of each method costs.
 *
 * All methods in all number types are timed in turn, again and again, so that a clock that drifts
 * drifts for all. A test is a call through a pointer, which costs each the same.
 */
#include "lab/kernel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/** Questions that are asked one after the other: so few that they stay in the cache. */
enum { QUESTIONS = 256 };
/** How often each method is timed. */
enum { TURNS = 11 };
/** Least length of a turn, seconds. */
#define TURN_SECONDS 3e-4
/** Most cases that errors are found from. */
enum { CASES_MAXIMUM = 10000 };

/** A method that is timed. */
typedef struct Timed {
    const NumberType *type; /**< In this type. */
    const Method *method;   /**< The method. */
    void *packed;           /**< Its questions; owned. */
    int rounds;             /**< How often they are asked in a turn. */
    double ns[TURNS];       /**< What a test cost in each turn. */
} Timed;

/** @return The processor's time that this thread has used, seconds. */
static double thread_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** @return How long all questions took, seconds. @param timed Who is asked. */
static double ask_rounds(const Timed *timed) {
    double start = thread_seconds();
    for (int i = 0; i < timed->rounds; i++) {
        timed->type->repeat(timed->method, QUESTIONS, timed->packed);
    }
    return thread_seconds() - start;
}

/** Poses the questions of a method. @param experiment The experiment. @param setting Where: a
 *  level. @param[in,out] timed The method; gets its questions. @return false without memory. */
static bool questions_pose(const Experiment *experiment, const Setting *setting, Timed *timed) {
    size_t numbers = (size_t)timed->method->inputs;
    Quadruple *questions = calloc(QUESTIONS * numbers, sizeof *questions);
    Random random = {20261121};
    for (size_t i = 0; questions && i < QUESTIONS; i++) {
        Case posed = {{0}, {0}};
        experiment->pose(setting, &random, &posed);
        memcpy(questions + i * numbers, posed.questions, numbers * sizeof *questions);
    }
    timed->packed = questions ? timed->type->pack(timed->method, QUESTIONS, questions) : NULL;
    free(questions);
    return timed->packed != NULL;
}

/** Prepares a method. @param experiment The experiment. @param finding The method and its level.
 *  @param[out] timed The method. @return false without memory. */
static bool timed_prepare(const Experiment *experiment, const Finding *finding, Timed *timed) {
    const NumberType *const *type = number_types();
    while (strcmp((*type)->name, finding->type) != 0) {
        type++;
    }
    const Method *const *method = (*type)->methods;
    while (strcmp((*method)->family, experiment->family) != 0 ||
           strcmp((*method)->name, finding->method) != 0) {
        method++;
    }
    *timed = (Timed){.type = *type, .method = *method, .rounds = 1};
    void *world = experiment->build ? experiment->build(finding->level) : NULL;
    bool is_posed = (!experiment->build || world) &&
                    questions_pose(experiment, &(Setting){*type, finding->level, world}, timed);
    free(world);
    return is_posed;
}

/** Finds how often the questions must be asked to be timed; the first round warms up.
 *  @param[in,out] timed The method. */
static void rounds_find(Timed *timed) {
    ask_rounds(timed);
    while (ask_rounds(timed) < TURN_SECONDS) {
        timed->rounds *= 2;
    }
}

/** @return Order of two numbers, for qsort. @param a One. @param b The other. */
static int compare_numbers(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/** Writes down what a test costs. @param[in,out] timed The method. @param[out] point Where to. */
static void time_conclude(Timed *timed, KernelPoint *point) {
    qsort(timed->ns, TURNS, sizeof *timed->ns, compare_numbers);
    point->ns_low = timed->ns[TURNS / 4];
    point->ns = timed->ns[TURNS / 2];
    point->ns_high = timed->ns[TURNS - 1 - TURNS / 4];
}

/** Times methods in turn. @param[in,out] timed They. @param count How many. @param stop Whether to
 *  give up. */
static void turns_take(Timed *timed, size_t count, const atomic_bool *stop) {
    for (size_t i = 0; i < count; i++) {
        rounds_find(&timed[i]);
    }
    for (int turn = 0; turn < TURNS && !(stop && atomic_load(stop)); turn++) {
        for (size_t i = 0; i < count; i++) {
            double tests = (double)QUESTIONS * timed[i].rounds;
            timed[i].ns[turn] = 1e9 * ask_rounds(&timed[i]) / tests;
        }
    }
}

/** Finds what a test of each method costs. @param experiment The experiment. @param stop Whether to
 *  give up. @param[in,out] kernel The methods. @param[out] error What is wrong.
 *  @return false if anything is wrong. */
static bool points_time(const Experiment *experiment, const atomic_bool *stop, Kernel *kernel,
                        Error *error) {
    Timed timed[KERNEL_POINTS_MAXIMUM] = {{0}};
    bool has_room = true;
    for (size_t i = 0; i < kernel->count && has_room; i++) {
        has_room = timed_prepare(experiment, &kernel->points[i].finding, &timed[i]);
    }
    if (has_room) {
        turns_take(timed, kernel->count, stop);
    }
    for (size_t i = 0; i < kernel->count; i++) {
        time_conclude(&timed[i], &kernel->points[i]);
        free(timed[i].packed);
    }
    if (stop && atomic_load(stop)) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    return has_room || error_set(error, STATUS_FAILED, "no memory for a clock");
}

/** @return The largest share of answers that are wrong altogether; NaN where none is counted.
 *  @param finding What was found. */
static double failures_of(const Finding *finding) {
    double worst = NAN;
    for (int i = 0; i < OUTCOME_COUNT; i++) {
        if (i != OUTCOME_DOUBLE_HIT) {
            worst = fmax(worst, finding->shares[i]); // What is not counted is NaN, and left out.
        }
    }
    return worst;
}

/** Adds a method in a number type: at the level that suits it, where there are several.
 *  @param[in,out] kernel Gets it. @param levels What was found at each. @param count How many. */
static void point_add(Kernel *kernel, const Finding *levels, size_t count) {
    const Finding *best = levels;
    for (size_t i = 1; i < count; i++) {
        best = levels[i].p999 < best->p999 ? &levels[i] : best;
    }
    if (best->cases > 0 && kernel->count < KERNEL_POINTS_MAXIMUM) {
        kernel->points[kernel->count++] =
            (KernelPoint){.finding = *best, .failures = failures_of(best)};
    }
}

bool kernel_measure(const Experiment *experiment, int threads, const atomic_bool *stop,
                    Kernel *kernel, Error *error) {
    Experiment timed = *experiment;
    Findings findings;
    timed.scene = NULL; // An engine is asked another way: its time would say little.
    timed.cases = timed.cases < CASES_MAXIMUM ? timed.cases : CASES_MAXIMUM;
    if (experiment->timed > 0) {
        timed.levels = &experiment->timed;
        timed.level_count = 1;
    }
    *kernel = (Kernel){.count = 0};
    if (!experiment_make(&timed, threads, stop, &findings, error)) {
        return false;
    }
    for (size_t m = 0; m < findings.method_count; m++) {
        for (size_t t = 0; t < findings.type_count; t++) {
            point_add(kernel, findings_at(&findings, m, t, 0), findings.level_count);
        }
    }
    findings_release(&findings);
    return points_time(experiment, stop, kernel, error);
}
