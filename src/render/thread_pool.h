/**
 * @file
 * @brief Worker threads that share out numbered pieces of work.
 */
#ifndef DIOPTRE_RENDER_THREAD_POOL_H
#define DIOPTRE_RENDER_THREAD_POOL_H

#include "dioptre/error.h"

#include <stddef.h>

/** Threads that wait for work; their inside is their own. */
typedef struct ThreadPool ThreadPool;

/** Does one piece of work. */
typedef void (*ThreadPoolTask)(void *context, size_t index);

/**
 * Starts threads.
 * @param concurrency  How many work at once, at least 1, the caller of #thread_pool_run included.
 * @return The workers, to be given back with #thread_pool_destroy; NULL if they cannot be started.
 */
ThreadPool *thread_pool_create(int concurrency, Error *error);

/** Ends the threads. @param pool The workers, idle; or NULL. */
void thread_pool_destroy(ThreadPool *pool);

/** Does pieces 0 to count - 1, each once, in about that order, and waits until all are done. @param
 *  task Does a piece; called by several threads at once. */
void thread_pool_run(ThreadPool *pool, size_t count, ThreadPoolTask task, void *context);

#endif
