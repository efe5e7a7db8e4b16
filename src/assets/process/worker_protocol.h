/**
 * @file
 * @brief Messages between the program and a worker process, over a pair of sockets.
 *
 * The program sends a #WorkerRequestHeader and the bytes of the request. The worker answers with
 * #WorkerFrame headers: one #WORKER_FRAME_READY, any number of #WORKER_FRAME_PROGRESS and
 * #WORKER_FRAME_QUESTION, then one #WORKER_FRAME_RESULT. The program answers a question as it sends
 * a request. Both ends are built from the same sources, so structs travel as they are. A stranger's
 * file may have got hold of the worker: the program checks every byte that it receives.
 */
#ifndef DIOPTRE_ASSETS_PROCESS_WORKER_PROTOCOL_H
#define DIOPTRE_ASSETS_PROCESS_WORKER_PROTOCOL_H

#include <stddef.h>

/** First word of a worker's command line; task, parent process id and language follow. */
#define WORKER_OPTION "--worker"
/** Words of a worker's command line: program, option, task, parent, language. */
enum { WORKER_ARGUMENT_COUNT = 5 };
/** Descriptor of the worker's end of the sockets. */
enum { WORKER_SOCKET = 3 };
/**
 * Exit status of a worker in which the address of the result is not free; another start may
 * succeed.
 */
enum { WORKER_EXIT_RETRY = 75 };

/** Largest size of a question, bytes: a path and some words. */
enum { WORKER_QUESTION_MAXIMUM = 8192 };

/** Start of a request, or of the answer to a question. A file descriptor may be sent along. */
typedef struct WorkerRequestHeader {
    size_t size;       /**< Bytes that follow. */
    double time_limit; /**< See #WorkerCall.time_limit. */
} WorkerRequestHeader;

/** Kind of a message from a worker. */
typedef enum {
    WORKER_FRAME_READY,      /**< Modules are loaded: the time limit starts. */
    WORKER_FRAME_UNFILTERED, /**< The system does not filter the worker's system calls. */
    WORKER_FRAME_PROGRESS,   /**< #WorkerFrame.per_mille has changed. */
    WORKER_FRAME_QUESTION,   /**< A question follows, of #WorkerFrame.report_size bytes. */
    WORKER_FRAME_REPORT,     /**< A fatal signal arrived: the report follows, then the end. */
    WORKER_FRAME_RESULT      /**< The task has ended: report and block follow. */
} WorkerFrameKind;

/** Start of a message from a worker. */
typedef struct WorkerFrame {
    int kind;                 /**< A #WorkerFrameKind. */
    int per_mille;            /**< Progress, 0 to 1000. */
    double processor_seconds; /**< Processor time of the worker before #WORKER_FRAME_READY, seconds:
                                 the program may be late in reading this frame. */
    size_t report_size;       /**< Bytes of the report, which follows this header. */
    size_t block_size;        /**< Bytes of the block, which follows the report; 0: none. */
} WorkerFrame;

#endif
