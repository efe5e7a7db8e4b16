/**
 * @file
 * @brief Workers of the page: both sides, in the thread that asks.
 *
 * A page has no processes. It confines everything itself: what a file does wrong can reach nothing
 * outside. So a task runs in the thread of its caller. What the system's limits do for a process is
 * done here: #worker_job_check leaves a task at its deadline, and the memory of
 * #worker_job_resize ends with its job. It stands in for worker_process.c, worker_main.c,
 * worker_sandbox.c and worker_filter.c of src/assets/process.
 */
#include "assets/process/worker_clock.h"
#include "assets/process/worker_main.h"
#include "assets/process/worker_process.h"
#include "assets/process/worker_protocol.h"
#include "base/clock.h"
#include "worker/tasks.h"

#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

/** Seconds between two calls of #WorkerMonitor.on_tick. */
static const double TICK_INTERVAL = 0.2;

/** Memory of a job, with what links all of them. */
typedef struct JobBlock {
    struct JobBlock *previous; /**< The one before; NULL: the first. */
    struct JobBlock *next;     /**< The one behind; NULL: the last. */
    max_align_t bytes[];       /**< The memory. */
} JobBlock;

/** A job being done. */
typedef struct Run {
    const WorkerCall *call; /**< The request. */
    WorkerJob job;          /**< The same, for the task. */
    JobBlock *blocks;       /**< The memory of the job. */
    double started;         /**< When its limit began, seconds. */
    double ticked;          /**< When #WorkerMonitor.on_tick was called last, seconds. */
    bool is_ready;          /**< Whether its limit has begun. */
    jmp_buf late;           /**< Where a job goes on that is late or stopped. */
} Run;

/** The job of this thread; NULL: none. */
static _Thread_local Run *current_run;

/** Held during a job: tasks keep their reports in memory of their own. */
static pthread_mutex_t job_mutex = PTHREAD_MUTEX_INITIALIZER;

// --- the worker's side ---------------------------------------------------------------------------

void worker_job_ready(void) {
    current_run->is_ready = true;
    current_run->started = current_run->ticked = clock_now_seconds();
}

void worker_job_check(void) {
    Run *run = current_run;
    const WorkerMonitor *monitor = run->call->monitor;
    bool is_stopped = monitor && monitor->stop && atomic_load(monitor->stop);
    if (is_stopped || clock_now_seconds() - run->started > run->call->time_limit) {
        longjmp(run->late, 1);
    }
}

void worker_job_progress(double fraction) {
    Run *run = current_run;
    const WorkerMonitor *monitor = run->call->monitor;
    double now = clock_now_seconds();
    if (monitor && monitor->on_tick && now - run->ticked > TICK_INTERVAL) {
        run->ticked = now;
        monitor->on_tick(monitor->context, now - run->started, fraction);
    }
}

void worker_enter_sandbox(size_t bytes) {
    (void)bytes; // The page is one.
}

_Noreturn void worker_exit_to_retry(void) {
    longjmp(current_run->late, 1);
}

WorkerAnswer worker_job_ask(const void *question, size_t size) {
    const WorkerCall *call = current_run->call;
    WorkerResponse response = {0};
    worker_job_check();
    bool is_valid = call->answer && call->answer(call->answer_context, question, size, &response);
    WorkerAnswer answer = {.bytes = malloc(response.size + 1), .file = -1};
    if (!is_valid || !answer.bytes) {
        free(answer.bytes);
        longjmp(current_run->late, 1);
    }
    memcpy(answer.bytes, response.bytes, response.size);
    answer.size = response.size;
    answer.file = response.file > 0 ? response.file : -1;
    return answer;
}

/** Takes a block out of the list of a job. */
static void unlink_block(Run *run, const JobBlock *block) {
    if (block->previous) {
        block->previous->next = block->next;
    } else {
        run->blocks = block->next;
    }
    if (block->next) {
        block->next->previous = block->previous;
    }
}

void *worker_job_resize(void *memory, size_t size) {
    Run *run = current_run;
    JobBlock *block = memory ? (JobBlock *)memory - 1 : NULL;
    if (size == 0) {
        if (block) {
            unlink_block(run, block);
        }
        free(block);
        return NULL;
    }
    JobBlock *resized = realloc(block, sizeof *resized + size);
    if (!resized) {
        return NULL;
    }
    if (!block) {
        *resized = (JobBlock){.next = run->blocks};
        run->blocks = resized;
    }
    if (resized->previous) {
        resized->previous->next = resized;
    } else {
        run->blocks = resized;
    }
    if (resized->next) {
        resized->next->previous = resized;
    }
    return resized->bytes;
}

// --- the program's side --------------------------------------------------------------------------

/** What the program writes at most into a block before a worker fills it: defaults, bytes. */
enum { FRESH_BLOCK_SIZE = 1 << 16 };

/** @return The task of a name; NULL: there is none. */
static const WorkerTask *find_task(const char *name) {
    const WorkerTask *task = worker_tasks;
    while (task->name && strcmp(task->name, name) != 0) {
        task++;
    }
    return task->name ? task : NULL;
}

/** Copies the block of a job, unless it is the caller's own. @return Whether there was memory. */
static bool copy_block(const WorkerJob *job, const WorkerCall *call, WorkerReply *reply) {
    reply->block = job->block;
    reply->block_size = job->block_size;
    if (job->block_size == 0 || job->block == call->block) {
        return true;
    }
    void *copy =
        mmap(NULL, job->block_size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (copy == MAP_FAILED || job->block_size > call->block_capacity) {
        reply->block = NULL;
        reply->block_size = 0;
        return false;
    }
    reply->block = memcpy(copy, job->block, job->block_size);
    return true;
}

/** Frees what is left of a job. */
static void end_job(Run *run) {
    while (run->blocks) {
        JobBlock *next = run->blocks->next;
        free(run->blocks);
        run->blocks = next;
    }
    if (run->job.owns_report) {
        free((void *)(uintptr_t)run->job.report);
    }
    if (run->job.block_capacity > 0) {
        munmap(run->job.block, run->job.block_capacity);
    }
}

/** Does a job. @return Its reply. */
static WorkerReply do_job(Run *run, const WorkerTask *task) {
    WorkerReply reply = {.end = WORKER_TIMED_OUT};
    WorkerJob *job = &run->job;
    current_run = run;
    if (run->call->block) {
        // The task takes it for new memory, which holds zeros; see __wrap_mmap.
        memset(run->call->block, 0,
               run->call->block_capacity < FRESH_BLOCK_SIZE ? run->call->block_capacity
                                                            : FRESH_BLOCK_SIZE);
    }
    if (setjmp(run->late) == 0) {
        task->run(job);
        reply.end = copy_block(job, run->call, &reply) ? WORKER_FINISHED : WORKER_EXITED;
    }
    current_run = NULL;
    size_t size = job->report_size < run->call->report_capacity ? job->report_size
                                                                : run->call->report_capacity;
    if (job->report) {
        memcpy(run->call->report, job->report, size);
    }
    reply.is_ready = run->is_ready;
    reply.seconds = run->is_ready ? clock_now_seconds() - run->started : 0;
    return reply;
}

WorkerReply worker_process_call(WorkerProcess *process, const WorkerCall *call) {
    (void)process;
    const WorkerTask *task = find_task(call->task);
    if (!task) {
        return (WorkerReply){.end = WORKER_NOT_STARTED, .detail = ENOENT};
    }
    pthread_mutex_lock(&job_mutex);
    Run run = {.call = call,
               .started = clock_now_seconds(),
               .job = {.request = call->request,
                       .request_size = call->request_size,
                       .file = call->file > 0 ? call->file : -1,
                       .time_limit = call->time_limit}};
    WorkerReply reply = do_job(&run, task);
    end_job(&run);
    pthread_mutex_unlock(&job_mutex);
    return reply;
}

WorkerReply worker_process_call_once(const WorkerCall *call) {
    return worker_process_call(NULL, call);
}

void worker_process_stop(WorkerProcess *process) {
    (void)process;
}

bool worker_reply_is_interrupted(const WorkerReply *reply) {
    (void)reply;
    return false;
}

bool worker_reply_start_failure(const WorkerReply *reply, char reason[WORKER_REASON_SIZE]) {
    if (reply->end == WORKER_NOT_STARTED) {
        strncpy(reason, error_errno_text(reply->detail), WORKER_REASON_SIZE - 1);
        reason[WORKER_REASON_SIZE - 1] = '\0';
    }
    return reply->end == WORKER_NOT_STARTED;
}

bool worker_error_set(Error *error, const Error *reported) {
    error_set(error, reported->status, "%s", reported->message);
    return error_set_line(error, reported->line);
}

bool worker_process_was_unfiltered(void) {
    return false;
}

// --- memory --------------------------------------------------------------------------------------

/**
 * Gives memory of zeros. See mmap(2): a worker asks for the address of the program's block, as
 * pointers are to mean the same in both. Here both have the same memory: it gets that block.
 */
void *__wrap_mmap(void *address, size_t size, int protection, int flags, int file, off_t offset) {
    if (address) {
        return address;
    }
    void *memory = calloc(1, size);
    // cppcheck-suppress memleak // __wrap_munmap frees it.
    return memory ? memory : MAP_FAILED;
}

/** Frees memory of #__wrap_mmap. See munmap(2). */
int __wrap_munmap(void *address, size_t size) {
    free(address);
    return 0;
}
