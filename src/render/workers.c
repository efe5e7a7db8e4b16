/**
 * @file
 * @brief Worker threads.
 */
#include "render/workers.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

struct Workers {
    pthread_mutex_t mutex;  /**< Guards all below but #next. */
    pthread_cond_t is_work; /**< Told when there is work, or the end. */
    pthread_cond_t is_idle; /**< Told when the last helper has nothing left. */
    pthread_t *helpers;     /**< The threads besides the caller's; owned. */
    int helper_count;       /**< How many of them run. */
    int busy;               /**< How many of them are at work. */
    unsigned round;         /**< Grows with every call of #workers_run. */
    bool is_over;           /**< Whether the threads should end. */
    WorkersJob job;         /**< What is to be done. */
    void *context;          /**< Handed to it. */
    size_t count;           /**< How many pieces. */
    atomic_size_t next;     /**< The first piece that nobody has taken. */
};

/** Takes pieces until there are none. @param workers The workers. */
static void workers_take(Workers *workers) {
    size_t index = atomic_fetch_add(&workers->next, 1);
    while (index < workers->count) {
        workers->job(workers->context, index);
        index = atomic_fetch_add(&workers->next, 1);
    }
}

/** A helper's life: waits for a round, takes part in it. @param argument The workers. @return NULL
 */
static void *helper_main(void *argument) {
    Workers *workers = argument;
    unsigned seen = 0;
    pthread_mutex_lock(&workers->mutex);
    while (true) {
        while (workers->round == seen && !workers->is_over) {
            pthread_cond_wait(&workers->is_work, &workers->mutex);
        }
        if (workers->is_over) {
            break;
        }
        seen = workers->round;
        pthread_mutex_unlock(&workers->mutex);
        workers_take(workers);
        pthread_mutex_lock(&workers->mutex);
        if (--workers->busy == 0) {
            pthread_cond_signal(&workers->is_idle);
        }
    }
    pthread_mutex_unlock(&workers->mutex);
    return NULL;
}

Workers *workers_create(int threads, Error *error) {
    Workers *workers = calloc(1, sizeof *workers);
    pthread_t *helpers = calloc((size_t)threads, sizeof *helpers);
    if (!workers || !helpers) {
        free(workers);
        free(helpers);
        error_set(error, STATUS_FAILED, "no memory for %d threads", threads);
        return NULL;
    }
    workers->helpers = helpers;
    pthread_mutex_init(&workers->mutex, NULL);
    pthread_cond_init(&workers->is_work, NULL);
    pthread_cond_init(&workers->is_idle, NULL);
    for (int i = 0; i < threads - 1; i++) {
        int code = pthread_create(&helpers[i], NULL, helper_main, workers);
        if (code != 0) {
            error_set(error, STATUS_FAILED, "cannot start thread %d: %s", i + 2,
                      error_system(code));
            workers_destroy(workers);
            return NULL;
        }
        workers->helper_count++;
    }
    return workers;
}

void workers_destroy(Workers *workers) {
    if (!workers) {
        return;
    }
    pthread_mutex_lock(&workers->mutex);
    workers->is_over = true;
    pthread_cond_broadcast(&workers->is_work);
    pthread_mutex_unlock(&workers->mutex);
    for (int i = 0; i < workers->helper_count; i++) {
        pthread_join(workers->helpers[i], NULL);
    }
    pthread_cond_destroy(&workers->is_work);
    pthread_cond_destroy(&workers->is_idle);
    pthread_mutex_destroy(&workers->mutex);
    free(workers->helpers);
    free(workers);
}

void workers_run(Workers *workers, size_t count, WorkersJob job, void *context) {
    pthread_mutex_lock(&workers->mutex);
    workers->job = job;
    workers->context = context;
    workers->count = count;
    atomic_store(&workers->next, 0);
    workers->busy = workers->helper_count;
    workers->round++;
    pthread_cond_broadcast(&workers->is_work);
    pthread_mutex_unlock(&workers->mutex);

    workers_take(workers);

    pthread_mutex_lock(&workers->mutex);
    while (workers->busy > 0) {
        pthread_cond_wait(&workers->is_idle, &workers->mutex);
    }
    pthread_mutex_unlock(&workers->mutex);
}
