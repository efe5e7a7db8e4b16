/**
 * @file
 * @brief A thread pool.
 */
#include "render/thread_pool.h"

#include "render/ray_stack.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

struct ThreadPool {
    pthread_mutex_t mutex;         /**< Guards all below but #next_task. */
    pthread_cond_t work_available; /**< Signalled when there are tasks, or the pool ends. */
    pthread_cond_t all_idle;       /**< Signalled when the last thread is idle. */
    pthread_t *threads;            /**< The threads besides the caller; owned. */
    int thread_count;              /**< Number of threads that run. */
    int busy_count;                /**< Number of threads that are busy. */
    unsigned generation;           /**< Number of calls of #thread_pool_run. */
    bool is_stopping;              /**< Whether the threads are to end. */
    ThreadPoolTask task;           /**< Runs a task. */
    void *context;                 /**< Its argument. */
    size_t task_count;             /**< Number of tasks. */
    atomic_size_t next_task;       /**< The first task that is not taken yet. */
};

/** Runs tasks until none is left. */
static void thread_pool_run_tasks(ThreadPool *pool) {
    size_t index = atomic_fetch_add(&pool->next_task, 1);
    while (index < pool->task_count) {
        pool->task(pool->context, index);
        index = atomic_fetch_add(&pool->next_task, 1);
    }
}

/** Main function of a thread. @return NULL */
static void *thread_pool_thread_main(void *argument) {
    ThreadPool *pool = argument;
    unsigned generation = 0;
    pthread_mutex_lock(&pool->mutex);
    while (true) {
        while (pool->generation == generation && !pool->is_stopping) {
            pthread_cond_wait(&pool->work_available, &pool->mutex);
        }
        if (pool->is_stopping) {
            break;
        }
        generation = pool->generation;
        pthread_mutex_unlock(&pool->mutex);
        thread_pool_run_tasks(pool);
        pthread_mutex_lock(&pool->mutex);
        if (--pool->busy_count == 0) {
            pthread_cond_signal(&pool->all_idle);
        }
    }
    pthread_mutex_unlock(&pool->mutex);
    return NULL;
}

ThreadPool *thread_pool_create(int concurrency, Error *error) {
    ThreadPool *pool = calloc(1, sizeof *pool);
    pthread_t *threads = calloc((size_t)concurrency, sizeof *threads);
    if (!pool || !threads) {
        free(pool);
        free(threads);
        error_set(error, STATUS_FAILED, "no memory for %d threads", concurrency);
        return NULL;
    }
    pool->threads = threads;
    pthread_mutex_init(&pool->mutex, NULL);
    pthread_cond_init(&pool->work_available, NULL);
    pthread_cond_init(&pool->all_idle, NULL);
    for (int i = 0; i < concurrency - 1; i++) {
        int code = ray_thread_create(&threads[i], thread_pool_thread_main, pool);
        if (code != 0) {
            error_set(error, STATUS_FAILED, "cannot start thread %d: %s", i + 2,
                      error_errno_text(code));
            thread_pool_destroy(pool);
            return NULL;
        }
        pool->thread_count++;
    }
    return pool;
}

void thread_pool_destroy(ThreadPool *pool) {
    if (!pool) {
        return;
    }
    pthread_mutex_lock(&pool->mutex);
    pool->is_stopping = true;
    pthread_cond_broadcast(&pool->work_available);
    pthread_mutex_unlock(&pool->mutex);
    for (int i = 0; i < pool->thread_count; i++) {
        pthread_join(pool->threads[i], NULL);
    }
    pthread_cond_destroy(&pool->work_available);
    pthread_cond_destroy(&pool->all_idle);
    pthread_mutex_destroy(&pool->mutex);
    free(pool->threads);
    free(pool);
}

void thread_pool_run(ThreadPool *pool, size_t count, ThreadPoolTask task, void *context) {
    pthread_mutex_lock(&pool->mutex);
    pool->task = task;
    pool->context = context;
    pool->task_count = count;
    atomic_store(&pool->next_task, 0);
    pool->busy_count = pool->thread_count;
    pool->generation++;
    pthread_cond_broadcast(&pool->work_available);
    pthread_mutex_unlock(&pool->mutex);

    thread_pool_run_tasks(pool);

    pthread_mutex_lock(&pool->mutex);
    while (pool->busy_count > 0) {
        pthread_cond_wait(&pool->all_idle, &pool->mutex);
    }
    pthread_mutex_unlock(&pool->mutex);
}
