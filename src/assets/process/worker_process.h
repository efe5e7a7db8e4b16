/**
 * @file
 * @brief Worker processes, the program's side: they read scenes, pictures and meshes.
 *
 * A worker is another program (`dioptre-worker`), started by exec: it shares no lock, thread or
 * file with this process. It receives a request and replies with a report and a block of bytes. It
 * ends with this process, and is always reaped. All functions are thread-safe.
 */
#ifndef DIOPTRE_ASSETS_PROCESS_WORKER_PROCESS_H
#define DIOPTRE_ASSETS_PROCESS_WORKER_PROCESS_H

#include "base/error.h"

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

/** A worker process. Zero: none runs. */
typedef struct WorkerProcess {
    pid_t pid;  /**< The process; 0: none. */
    int socket; /**< This process's end of the socket pair. */
} WorkerProcess;

/** Outcome of a call. */
typedef enum {
    WORKER_FINISHED,   /**< With a result. */
    WORKER_TIMED_OUT,  /**< Ended at the time limit, or by #WorkerMonitor.stop. */
    WORKER_CRASHED,    /**< The process died of a signal. */
    WORKER_EXITED,     /**< The process exited without a result. */
    WORKER_CUT_OFF,    /**< This process could not send to it, or has no memory for its result. */
    WORKER_NOT_STARTED /**< No process could be started. */
} WorkerEnd;

/** Callback and stop flag of a call. */
typedef struct WorkerMonitor {
    /**
     * Called about five times per second; NULL: none.
     * @param context   #context.
     * @param seconds   Seconds since the start.
     * @param fraction  Progress, 0 to 1.
     */
    void (*on_tick)(void *context, double seconds, double fraction);
    void *context;           /**< Passed to #on_tick. */
    const atomic_bool *stop; /**< The worker is killed once this is true; NULL: never. */
} WorkerMonitor;

/** What the program sends to a worker that asks. */
typedef struct WorkerResponse {
    const void *bytes; /**< The answer; valid until the next question. */
    size_t size;       /**< Number of its bytes. */
    int file;          /**< Descriptor to send along, closed afterwards; 0: none. */
} WorkerResponse;

/** A request to a worker, and memory for its reply. */
typedef struct WorkerCall {
    const char *program; /**< Path of the worker program; NULL: `dioptre-worker`. */
    const char *task;    /**< Name of the task, see #WorkerTask. */
    const void *request; /**< Bytes of the request. */
    size_t request_size; /**< Number of its bytes. */
    int file;            /**< Descriptor to send along; 0: none. */
    double time_limit;   /**< Limit of its processor time, seconds, from #worker_job_ready. */
    double wall_limit;   /**< Limit on the wall clock, seconds; 0: #worker_clock_wall_limit. */
    const WorkerMonitor *monitor; /**< Callback and stop flag; NULL: none. */
    /**
     * Answers a question of the worker, see #worker_job_ask. A stranger's file may have written the
     * question. NULL: a worker that asks is ended.
     * @param context        #answer_context.
     * @param question       The question, of any bytes.
     * @param size           Number of its bytes, at most #WORKER_QUESTION_MAXIMUM.
     * @param[out] response  The answer, empty before.
     * @return false if it is no valid question; the worker is ended.
     */
    bool (*answer)(void *context, const void *question, size_t size, WorkerResponse *response);
    void *answer_context;   /**< Passed to #answer. */
    void *report;           /**< Memory for the report. */
    size_t report_capacity; /**< Its size in bytes. */
    void *block;            /**< Memory for the block; NULL: new memory by mmap. */
    size_t block_capacity;  /**< Largest size of the block, bytes. */
} WorkerCall;

/** Reply of a worker. */
typedef struct WorkerReply {
    WorkerEnd end; /**< How the call ended. */
    int detail;    /**< The signal after #WORKER_CRASHED, errno after #WORKER_CUT_OFF and
                      #WORKER_NOT_STARTED, else 0. */
    bool is_ready; /**< Whether the worker had loaded its modules, see #worker_job_ready. */
    void *block;   /**< The block; NULL: none. To be unmapped with munmap if #WorkerCall.block is
                      NULL. */
    size_t block_size; /**< Bytes of the block. */
    double seconds;    /**< Processor time of the call, seconds, from #worker_job_ready. */
    bool is_stalled;   /**< After #WORKER_TIMED_OUT: whether it only waited, until the limit on the
                          wall clock. */
} WorkerReply;

/**
 * Sends a request to a worker and waits for the reply. After a crash or a timeout, the report is
 * filled if the worker could send it.
 * @param[in,out] process  The worker; started if none runs. It keeps running after #WORKER_FINISHED
 *                         only.
 * @param call             The call.
 * @return The reply.
 */
WorkerReply worker_process_call(WorkerProcess *process, const WorkerCall *call);

/**
 * @return Whether a worker died of SIGINT, SIGTERM or SIGHUP, which terminals, batch systems and
 *         shutdowns send to all processes of a job: not a crash.
 * @param reply  Its reply.
 */
bool worker_reply_is_interrupted(const WorkerReply *reply);

/** Size of a text of #worker_reply_start_failure, with its final zero. */
enum { WORKER_REASON_SIZE = 256 };

/**
 * Says why a worker did not get as far as the request, or its result as far as this process: it
 * could not be started or reached, or died while it loaded its modules, whose libraries abort
 * without memory or threads. That is no fault of a file.
 * @param reply        The reply.
 * @param[out] reason  The reason, translated.
 * @return false if it got further, or was interrupted.
 */
bool worker_reply_start_failure(const WorkerReply *reply, char reason[WORKER_REASON_SIZE]);

/**
 * Sets the error that a worker reports, which a stranger's file may have written: the text ends,
 * and the status is one that workers have.
 * @param[out] error  The error; may be NULL.
 * @param reported    The reported one.
 * @return false, always.
 */
bool worker_error_set(Error *error, const Error *reported);

/** @return Whether a worker ran without a filter of its system calls, see #worker_enter_sandbox. */
bool worker_process_was_unfiltered(void);

/** Ends a worker, if one runs, and reaps it. */
void worker_process_stop(WorkerProcess *process);

/** Starts a worker for one request, and ends it. @return As #worker_process_call. */
WorkerReply worker_process_call_once(const WorkerCall *call);

#endif
