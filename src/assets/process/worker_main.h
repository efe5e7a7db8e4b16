/**
 * @file
 * @brief The life of a worker process: it receives requests, runs a task, sends results.
 */
#ifndef DIOPTRE_ASSETS_PROCESS_WORKER_MAIN_H
#define DIOPTRE_ASSETS_PROCESS_WORKER_MAIN_H

#include <stdbool.h>
#include <stddef.h>

/** A request, and the answer to it. */
typedef struct WorkerJob {
    const void *request;   /**< Bytes of the request. */
    size_t request_size;   /**< How many. */
    int file;              /**< Descriptor that came with it; -1: none. */
    const void *report;    /**< The report. Sent at the end, and at a fatal signal as it is then. */
    size_t report_size;    /**< Bytes of it. */
    void *block;           /**< The block; sent at the end. NULL: none. */
    size_t block_size;     /**< Bytes of it. */
    size_t block_capacity; /**< Bytes that are given back by munmap afterwards; 0: none. */
} WorkerJob;

/** Something that a worker can do. */
typedef struct WorkerTask {
    const char *name;            /**< Its name, see #WorkerCall.task. */
    void (*run)(WorkerJob *job); /**< Does it; fills report and block. */
} WorkerTask;

/** @return Whether the command line asks the program to be a worker. */
bool worker_is_requested(int argc, char **argv);

/**
 * Answers requests until the program at the other end closes the sockets; then exits.
 * @param argv   The command line, see #worker_is_requested.
 * @param tasks  All tasks, ended by one without a name.
 */
_Noreturn void worker_main(char **argv, const WorkerTask *tasks);

/** Starts the time limit of a job: its modules are loaded. */
void worker_job_ready(void);

/** Sends the progress of a job. @param fraction 0 to 1. */
void worker_job_progress(double fraction);

/** Limits the memory of this process, and closes its output: foreign libraries run now.
 *  @param bytes Data beyond what the process has already. */
void worker_enter_sandbox(size_t bytes);

/** Ends this process; the program starts another: the memory where the result must lie is taken. */
_Noreturn void worker_exit_to_retry(void);

#endif
