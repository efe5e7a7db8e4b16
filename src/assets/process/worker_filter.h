/**
 * @file
 * @brief The filter of system calls of a worker process (seccomp).
 *
 * It leaves a worker its memory, its time, the file that it was sent and the socket to the program;
 * doc/design.md says what is refused, and how. It cannot be lifted again.
 */
#ifndef DIOPTRE_ASSETS_PROCESS_WORKER_FILTER_H
#define DIOPTRE_ASSETS_PROCESS_WORKER_FILTER_H

#include <linux/filter.h>
#include <stdbool.h>
#include <stddef.h>

/** Most instructions of a filter. */
enum { WORKER_FILTER_CAPACITY = 512 };

/**
 * Writes the filter of this process, for the kernel.
 * @param[out] instructions  Its instructions.
 * @return Their number; 0: there is no filter for this kind of processor.
 */
size_t worker_filter_write(struct sock_filter instructions[WORKER_FILTER_CAPACITY]);

/**
 * Filters the system calls of all threads of this process from now on. Later calls do nothing.
 * @return false where the system has no such filter, or refuses it.
 */
bool worker_filter_install(void);

#endif
