/**
 * @file
 * @brief How much faster pictures are with many threads, on a machine with few: a simulation.
 *
 * This program has a thread pool of its own, in place of the library's: it runs all tasks on one
 * thread and times each of them. Then it gives them to N threads in the same order, as the real
 * pool does: the next task to the first thread that is free. What the program does between two
 * runs of the pool is done by one thread. Threads of the simulation cost nothing to wake up, and
 * do not share caches and memory: real ones are slower.
 */
#include "base/clock.h"
#include "base/picture.h"
#include "dioptre/renderer.h"
#include "dioptre/script.h"
#include "render/thread_pool.h"

#include <stdio.h>
#include <stdlib.h>

/** Numbers of threads. */
static const int thread_counts[] = {1, 2, 4, 8, 16};
enum {
    THREAD_COUNTS = sizeof thread_counts / sizeof *thread_counts, /**< Number of them. */
    SIMULATED_THREADS = 16,                                       /**< The largest of them. */
    ROUNDS = 3                                                    /**< Pictures per scene. */
};

/** The runs of the pool for one picture. */
typedef struct Schedule {
    double busy;                 /**< Seconds in runs. */
    double spans[THREAD_COUNTS]; /**< Seconds from the start of runs to their ends. */
} Schedule;

/** The schedule of the picture that is drawn. The pool has no room for it: its caller is the
 *  library. */
static Schedule schedule;

/** @return The thread that is free first. @param free_at When each is. */
static int first_free(const double *free_at, int threads) {
    int first = 0;
    for (int i = 1; i < threads; i++) {
        first = free_at[i] < free_at[first] ? i : first;
    }
    return first;
}

/** @return When the last thread is free. */
static double last_end(const double *free_at, int threads) {
    double end = 0;
    for (int i = 0; i < threads; i++) {
        end = free_at[i] > end ? free_at[i] : end;
    }
    return end;
}

/** In place of the library's. */
void thread_pool_run(ThreadPool *pool, size_t count, ThreadPoolTask task, void *context) {
    double free_at[THREAD_COUNTS][SIMULATED_THREADS] = {{0}};
    (void)pool;
    double begin = clock_thread_cpu_seconds();
    for (size_t i = 0; i < count; i++) {
        double start = clock_thread_cpu_seconds();
        task(context, i);
        double seconds = clock_thread_cpu_seconds() - start;
        for (int n = 0; n < THREAD_COUNTS; n++) {
            free_at[n][first_free(free_at[n], thread_counts[n])] += seconds;
        }
    }
    // The clock, too: a short task takes hardly longer than to look at it twice.
    schedule.busy += clock_thread_cpu_seconds() - begin;
    for (int n = 0; n < THREAD_COUNTS; n++) {
        schedule.spans[n] += last_end(free_at[n], thread_counts[n]);
    }
}

/** Draws a picture. @param[out] speedups With each number of threads. @return false on failure. */
static bool simulate_picture(const Scene *scene, double *speedups, Error *error) {
    RenderSettings settings = render_settings_default(scene);
    settings.threads = 1;
    Picture picture;
    bool has_picture = picture_init(&picture, settings.width, settings.height, error);
    Renderer *renderer = has_picture ? renderer_create(scene, &settings, error) : NULL;
    if (renderer) {
        schedule = (Schedule){0};
        double start = clock_thread_cpu_seconds();
        renderer_render(renderer, NULL, &picture);
        double all = clock_thread_cpu_seconds() - start, alone = all - schedule.busy;
        for (int n = 0; n < THREAD_COUNTS; n++) {
            speedups[n] = (alone + schedule.spans[0]) / (alone + schedule.spans[n]);
        }
    }
    renderer_destroy(renderer);
    picture_deinit(&picture);
    return renderer != NULL;
}

/** Compares numbers, for qsort. */
static int compare_numbers(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/**
 * Prints a row per scene: its name, and how many times as fast 2, 4, 8 and 16 threads are, medians.
 * @param argc  Number of scenes, plus one.
 * @return 1 on failure.
 */
int main(int argc, char **argv) {
    for (int i = 1; i < argc; i++) {
        Error error = {0};
        double speedups[ROUNDS][THREAD_COUNTS];
        ScriptRequest request = {
            .path = argv[i], .time_limit = SCRIPT_TIME_LIMIT, .memory_limit = SCRIPT_MEMORY_LIMIT};
        Scene *scene = script_load(&request, &error);
        bool is_drawn = scene;
        for (int round = 0; is_drawn && round < ROUNDS; round++) {
            is_drawn = simulate_picture(scene, speedups[round], &error);
        }
        scene_destroy(scene);
        if (!is_drawn) {
            fprintf(stderr, "%s: %s\n", argv[i], error.message);
            return 1;
        }
        printf("%s", argv[i]);
        for (int n = 1; n < THREAD_COUNTS; n++) {
            double column[ROUNDS];
            for (int round = 0; round < ROUNDS; round++) {
                column[round] = speedups[round][n];
            }
            qsort(column, ROUNDS, sizeof *column, compare_numbers);
            printf(",%.2f", column[ROUNDS / 2]);
        }
        printf("\n");
        fflush(stdout);
    }
    return 0;
}
