/**
 * @file
 * @brief A thread pool that runs numbered tasks.
 */
#ifndef DIOPTRE_RENDER_THREAD_POOL_H
#define DIOPTRE_RENDER_THREAD_POOL_H

#include "base/error.h"

#include <stddef.h>

/** A thread pool; opaque. */
typedef struct ThreadPool ThreadPool;

/** Runs one task. @param index Its number. */
typedef void (*ThreadPoolTask)(void *context, size_t index);

/**
 * Creates a thread pool.
 * @param concurrency  Tasks that run at once, at least 1; one of them on the caller of
 *                     #thread_pool_run.
 * @return The pool, to be freed with #thread_pool_destroy; NULL if threads cannot be started.
 */
ThreadPool *thread_pool_create(int concurrency, Error *error);

/** Ends the threads and frees the pool. @param pool An idle pool, or NULL. */
void thread_pool_destroy(ThreadPool *pool);

/** Runs tasks 0 to count - 1, each once, in about that order, and waits for all. @param task Runs a
 *  task; called on several threads at once. */
void thread_pool_run(ThreadPool *pool, size_t count, ThreadPoolTask task, void *context);

#endif
