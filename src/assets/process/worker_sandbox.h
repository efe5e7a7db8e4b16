/**
 * @file
 * @brief What the system takes from a worker process before it reads a stranger's bytes.
 *
 * The filter of its system calls is in assets/process/worker_filter.h.
 */
#ifndef DIOPTRE_ASSETS_PROCESS_WORKER_SANDBOX_H
#define DIOPTRE_ASSETS_PROCESS_WORKER_SANDBOX_H

#include <stddef.h>

/**
 * Takes what a worker never needs: new privileges, standard streams, inherited descriptors. Called
 * once, at its start.
 */
void worker_sandbox_prepare(void);

/**
 * Limits memory and processor time from now on. Can be called again, for the next request.
 * @param bytes    Limit of data beyond the current use.
 * @param seconds  Limit of processor time beyond the current use; HUGE_VAL: none.
 */
void worker_sandbox_limit(size_t bytes, double seconds);

#endif
