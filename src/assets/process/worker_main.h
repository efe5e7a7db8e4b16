/**
 * @file
 * @brief The main loop of a worker process: it receives requests, runs tasks and sends results.
 */
#ifndef DIOPTRE_ASSETS_PROCESS_WORKER_MAIN_H
#define DIOPTRE_ASSETS_PROCESS_WORKER_MAIN_H

#include <stdbool.h>
#include <stddef.h>

/** A request and its reply. */
typedef struct WorkerJob {
    const void *request;   /**< Bytes of the request. */
    size_t request_size;   /**< Number of its bytes. */
    int file;              /**< Descriptor sent along; -1: none. */
    double time_limit;     /**< See #WorkerCall.time_limit. */
    const void *report;    /**< The report, sent at the end or at a fatal signal. */
    size_t report_size;    /**< Bytes of the report. */
    bool owns_report;      /**< Whether the report is freed with `free` after it was sent. */
    void *block;           /**< The block; sent at the end. NULL: none. */
    size_t block_size;     /**< Bytes of the block. */
    size_t block_capacity; /**< Bytes to unmap after sending, by munmap; 0: none. */
} WorkerJob;

/** A task of a worker. */
typedef struct WorkerTask {
    const char *name;            /**< Its name, see #WorkerCall.task. */
    void (*run)(WorkerJob *job); /**< Runs the task; sets report and block. */
} WorkerTask;

/**
 * @return Whether the command line starts a worker.
 * @param argc  Number of arguments.
 * @param argv  The arguments.
 */
bool worker_is_requested(int argc, char **argv);

/**
 * Answers requests until the program at the other end closes the sockets; then exits.
 * @param argv   The command line, see #worker_is_requested.
 * @param tasks  All tasks, ended by one without a name.
 */
_Noreturn void worker_main(char **argv, const WorkerTask *tasks);

/** Starts the time limit of a job, after its modules are loaded. */
void worker_job_ready(void);

/** Sends the progress of a job. @param fraction 0 to 1. */
void worker_job_progress(double fraction);

/** Leaves the job if its time has passed, where no limit of the system ends it: in a page. To be
 *  called often by whatever may run without end. */
void worker_job_check(void);

/**
 * Allocates, resizes or frees memory that ends with the job at the latest, even if its task does
 * not return.
 * @param memory  The memory to resize or free; NULL: none.
 * @param size    Its new size, bytes; 0 frees it.
 * @return The memory; NULL if there is none, or it was freed.
 */
void *worker_job_resize(void *memory, size_t size);

/**
 * Confines this process before it reads a stranger's bytes: limits of memory and time, and a filter
 * of system calls. From now on no file can be opened and no library loaded. Can be called again,
 * for the next request.
 * @param bytes  Limit of data beyond the current use.
 */
void worker_enter_sandbox(size_t bytes);

/** The answer to a question. */
typedef struct WorkerAnswer {
    void *bytes; /**< The answer, to be freed with `free`. */
    size_t size; /**< Number of its bytes. */
    int file;    /**< Descriptor sent along, to be closed; -1: none. */
} WorkerAnswer;

/**
 * Asks the program for what this process cannot do by itself, such as to open a file. See
 * #WorkerCall.answer.
 * @param question  The question.
 * @param size      Number of its bytes, at most #WORKER_QUESTION_MAXIMUM.
 * @return The answer.
 */
WorkerAnswer worker_job_ask(const void *question, size_t size);

/** Exits, so that the program starts another worker: the address of the result is not free here. */
_Noreturn void worker_exit_to_retry(void);

#endif
