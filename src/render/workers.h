/**
 * @file
 * @brief Worker threads that share out numbered pieces of work.
 */
#ifndef DIOPTRE_RENDER_WORKERS_H
#define DIOPTRE_RENDER_WORKERS_H

#include "dioptre/error.h"

#include <stddef.h>

/** Threads that wait for work; their inside is their own. */
typedef struct Workers Workers;

/** Does one piece of work. @param context The caller's own. @param index Which piece. */
typedef void (*WorkersJob)(void *context, size_t index);

/**
 * Starts threads.
 * @param threads     How many work at once, at least 1, the caller of #workers_run included.
 * @param[out] error  What is wrong.
 * @return The workers, to be given back with #workers_destroy; NULL if they cannot be started.
 */
Workers *workers_create(int threads, Error *error);

/** Ends the threads. @param workers The workers, idle; or NULL. */
void workers_destroy(Workers *workers);

/**
 * Does pieces 0 to count - 1, each once, in about that order, and waits until all are done.
 * @param workers  The workers, idle.
 * @param count    How many pieces.
 * @param job      Does a piece; called by several threads at once.
 * @param context  Handed to it.
 */
void workers_run(Workers *workers, size_t count, WorkersJob job, void *context);

#endif
