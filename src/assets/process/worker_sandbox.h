/**
 * @file
 * @brief What the system takes from a worker process before it reads a stranger's bytes.
 *
 * A filter of system calls (seccomp) leaves a worker its memory, its time, the file that it was
 * sent and the socket to the program. It cannot be lifted again, so files of later requests arrive
 * over the socket.
 */
#ifndef DIOPTRE_ASSETS_PROCESS_WORKER_SANDBOX_H
#define DIOPTRE_ASSETS_PROCESS_WORKER_SANDBOX_H

#include <stdbool.h>
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

/**
 * Filters the system calls of all threads of this process from now on; see doc/design.md for what
 * is allowed. Later calls do nothing.
 * @return false where the system has no such filter, or refuses it.
 */
bool worker_sandbox_filter(void);

#endif
