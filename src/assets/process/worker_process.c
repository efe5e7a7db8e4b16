/**
 * @file
 * @brief Worker processes: the program's side.
 */
#include "assets/process/worker_process.h"

#include "assets/process/worker_clock.h"
#include "assets/process/worker_protocol.h"
#include "base/clock.h"
#include "base/executable_dir.h"
#include "base/language.h"

#include <errno.h>
#include <libintl.h>
#include <limits.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

/** Time limit for the start of a worker with its modules, seconds. */
static const double START_LIMIT = 60;
/** Time limit for the report after a timeout, seconds: a busy machine may need some. */
static const double REPORT_LIMIT = 5;
/** Seconds between two calls of #WorkerMonitor.on_tick. */
static const double TICK_INTERVAL = 0.2;
/** Largest number of starts until the address of the result is free in a worker. */
enum { START_ATTEMPTS = 16 };

// --- starting and ending -------------------------------------------------------------------------

/** Finds the worker program: beside this program, or in its installed folder. @return Its path. */
static const char *find_program(char path[PATH_MAX]) {
    static const char *const places[] = {"dioptre-worker", "../lib/dioptre/dioptre-worker"};
    char folder[PATH_MAX];
    bool has_folder = executable_dir(folder);
    for (size_t i = 0; has_folder && i < sizeof places / sizeof *places; i++) {
        int length = snprintf(path, PATH_MAX, "%s/%s", folder, places[i]);
        if (length < PATH_MAX && access(path, X_OK) == 0) {
            break;
        }
    }
    return path;
}

/**
 * Spawns a worker with default signals and one end of the socket pair.
 * @return 0, or an error number.
 */
static int spawn(WorkerProcess *process, const WorkerCall *call, int socket) {
    char path[PATH_MAX] = "dioptre-worker", task[32], parent[16], language[4];
    char option[] = WORKER_OPTION;
    snprintf(task, sizeof task, "%s", call->task);
    snprintf(parent, sizeof parent, "%d", (int)getpid());
    snprintf(language, sizeof language, "%s", language_is_french() ? "fr" : "en");
    const char *program = call->program ? call->program : find_program(path);
    char name[] = "dioptre-worker", *arguments[] = {name, option, task, parent, language, NULL};
    sigset_t handled, none;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_t files;
    struct sigaction hangup;
    sigfillset(&handled);
    if (sigaction(SIGHUP, NULL, &hangup) == 0 && hangup.sa_handler == SIG_IGN) {
        sigdelset(&handled, SIGHUP); // Under nohup, workers survive the terminal, too.
    }
    sigemptyset(&none);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigdefault(&attributes, &handled);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    posix_spawn_file_actions_init(&files);
    int failed = posix_spawn_file_actions_adddup2(&files, socket, WORKER_SOCKET);
    failed = failed ? failed
                    : posix_spawn(&process->pid, program, &files, &attributes, arguments, environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    return failed;
}

/** Starts a worker. @return 0, or an error number. */
static int start(WorkerProcess *process, const WorkerCall *call) {
    int ends[2];
    *process = (WorkerProcess){0};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
        return errno;
    }
    int failed = spawn(process, call, ends[1]);
    close(ends[1]);
    process->socket = ends[0];
    if (failed) {
        close(ends[0]);
        *process = (WorkerProcess){0};
    }
    return failed;
}

/**
 * Waits for the end of a worker.
 * @return Its status as of waitpid; 0 if the system has reaped it.
 */
static int reap(WorkerProcess *process) {
    int status = 0;
    pid_t ended;
    do {
        ended = waitpid(process->pid, &status, 0);
    } while (ended < 0 && errno == EINTR);
    close(process->socket);
    pid_t pid = process->pid;
    *process = (WorkerProcess){0};
    return ended == pid ? status : 0;
}

void worker_process_stop(WorkerProcess *process) {
    if (process->pid > 0) {
        kill(process->pid, SIGKILL);
        reap(process);
    }
}

/** Whether a worker ran without a filter of its system calls; for one note at the end. */
static atomic_bool was_unfiltered;

bool worker_process_was_unfiltered(void) {
    return atomic_load(&was_unfiltered);
}

// --- messages ------------------------------------------------------------------------------------

/** A current call. */
typedef struct Exchange {
    const WorkerProcess *process; /**< The worker. */
    const WorkerCall *call;       /**< The request. */
    WorkerClock clock;            /**< The time limits. */
    double fraction;              /**< Progress, 0 to 1. */
    bool is_ready;                /**< Whether the worker is ready. */
    bool is_late;                 /**< Whether the deadline has passed, or the call is stopped. */
    int failure;                  /**< errno of a failure of this process; 0: none. */
} Exchange;

/** @return Whether the stop flag of the call is set. */
static bool is_stopped(const Exchange *exchange) {
    const WorkerMonitor *monitor = exchange->call->monitor;
    return monitor && monitor->stop && atomic_load(monitor->stop);
}

/** @return Milliseconds until the next tick or the next look at the clock, rounded up. */
static int sleep_time(const Exchange *exchange) {
    double left = worker_clock_left(&exchange->clock);
    double seconds = exchange->call->monitor ? fmin(left, TICK_INTERVAL) : left;
    return (int)fmin(fmax(ceil(1000 * seconds), 0), INT_MAX);
}

/**
 * Waits until the socket is ready, and calls the monitor meanwhile.
 * @param exchange  The call.
 * @param events    POLLIN or POLLOUT.
 * @return false at the deadline or if the call is stopped; #Exchange.is_late is set then.
 */
static bool wait_until_ready(Exchange *exchange, short events) {
    struct pollfd watched = {.fd = exchange->process->socket, .events = events};
    const WorkerMonitor *monitor = exchange->call->monitor;
    while (!is_stopped(exchange)) {
        int ready = poll(&watched, 1, sleep_time(exchange));
        if (ready > 0) {
            return true;
        }
        if (ready == 0 && worker_clock_left(&exchange->clock) <= 0) {
            break;
        }
        if (ready == 0 && monitor && monitor->on_tick) {
            monitor->on_tick(monitor->context, worker_clock_elapsed(&exchange->clock),
                             exchange->fraction);
        }
    }
    exchange->is_late = true;
    return false;
}

/** @return Whether a transfer that failed can be tried again. */
static bool is_temporary(int reason) {
    return reason == EAGAIN || reason == EINTR;
}

/** Receives bytes. @return false if the worker has ended, or is late. */
static bool receive(Exchange *exchange, void *bytes, size_t size) {
    char *next = bytes;
    while (size > 0) {
        ssize_t count = wait_until_ready(exchange, POLLIN)
                            ? recv(exchange->process->socket, next, size, MSG_DONTWAIT)
                            : 0;
        if (count == 0 || (count < 0 && !is_temporary(errno))) {
            return false;
        }
        next += count > 0 ? count : 0;
        size -= count > 0 ? (size_t)count : 0;
    }
    return true;
}

/** Notes why nothing can be sent, unless the worker has ended. @return false, always. */
static bool note_failure(Exchange *exchange, int reason) {
    exchange->failure = reason == EPIPE || reason == ECONNRESET ? 0 : reason;
    return false;
}

/** Sends bytes. @return false if the worker has ended, or is late, or nothing can be sent. */
static bool send_bytes(Exchange *exchange, const void *bytes, size_t size) {
    const char *next = bytes;
    while (size > 0) {
        if (!wait_until_ready(exchange, POLLOUT)) {
            return false;
        }
        ssize_t count = send(exchange->process->socket, next, size, MSG_DONTWAIT | MSG_NOSIGNAL);
        if (count < 0 && !is_temporary(errno)) {
            return note_failure(exchange, errno);
        }
        next += count > 0 ? count : 0;
        size -= count > 0 ? (size_t)count : 0;
    }
    return true;
}

/** A message to a worker: a request, or the answer to a question. */
typedef struct Message {
    const void *bytes; /**< Its bytes. */
    size_t size;       /**< Number of its bytes. */
    int file;          /**< Descriptor to send along; 0: none. */
} Message;

/**
 * Sends a header, to which a descriptor may be attached. It is never split: it is smaller than any
 * buffer.
 * @return false if the worker has ended, or is late: one that does not read fills the buffer.
 */
static bool send_header(Exchange *exchange, const struct msghdr *message) {
    ssize_t count = -1;
    while (count < 0) {
        if (!wait_until_ready(exchange, POLLOUT)) {
            return false;
        }
        count = sendmsg(exchange->process->socket, message, MSG_DONTWAIT | MSG_NOSIGNAL);
        if (count < 0 && !is_temporary(errno)) {
            return note_failure(exchange, errno);
        }
    }
    return count == sizeof(WorkerRequestHeader);
}

/** Sends a message, with its file. @return false if the worker has ended, or is late. */
static bool send_message(Exchange *exchange, const Message *sent) {
    WorkerRequestHeader header = {.size = sent->size, .time_limit = exchange->call->time_limit};
    struct iovec part = {&header, sizeof header};
    union {
        struct cmsghdr align;                /**< For the alignment. */
        char bytes[CMSG_SPACE(sizeof(int))]; /**< Memory for a descriptor. */
    } control = {0};
    struct msghdr message = {.msg_iov = &part, .msg_iovlen = 1};
    if (sent->file > 0) {
        message.msg_control = control.bytes;
        message.msg_controllen = sizeof control.bytes;
        struct cmsghdr *rights = CMSG_FIRSTHDR(&message);
        rights->cmsg_level = SOL_SOCKET;
        rights->cmsg_type = SCM_RIGHTS;
        rights->cmsg_len = CMSG_LEN(sizeof(int));
        memcpy(CMSG_DATA(rights), &sent->file, sizeof sent->file);
    }
    return send_header(exchange, &message) && send_bytes(exchange, sent->bytes, sent->size);
}

/** Answers a question. @return false if it is not valid, or the worker has ended. */
static bool answer_question(Exchange *exchange, size_t size) {
    char question[WORKER_QUESTION_MAXIMUM];
    const WorkerCall *call = exchange->call;
    const double started = clock_thread_cpu_seconds();
    WorkerResponse response = {0};
    bool is_valid = call->answer && size <= sizeof question && receive(exchange, question, size) &&
                    call->answer(call->answer_context, question, size, &response);
    const Message message = {response.bytes, response.size, response.file};
    bool is_sent = is_valid && send_message(exchange, &message);
    if (response.file > 0) {
        close(response.file);
    }
    worker_clock_charge(&exchange->clock, clock_thread_cpu_seconds() - started);
    return is_sent;
}

/** Receives the report of a frame. @return false if it does not fit, or the worker has ended. */
static bool receive_report(Exchange *exchange, const WorkerFrame *frame) {
    return frame->report_size <= exchange->call->report_capacity &&
           receive(exchange, exchange->call->report, frame->report_size);
}

/** Receives the block of a frame. @return false if it does not fit, or the worker has ended. */
static bool receive_block(Exchange *exchange, const WorkerFrame *frame, WorkerReply *reply) {
    const WorkerCall *call = exchange->call;
    if (frame->block_size == 0 || frame->block_size > call->block_capacity) {
        return frame->block_size == 0;
    }
    void *block = call->block ? call->block
                              : mmap(NULL, frame->block_size, PROT_READ | PROT_WRITE,
                                     MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (block == MAP_FAILED) {
        exchange->failure = errno;
        return false;
    }
    bool is_received = receive(exchange, block, frame->block_size);
    if (is_received) {
        reply->block = block;
        reply->block_size = frame->block_size;
    } else if (!call->block) {
        munmap(block, frame->block_size);
    }
    return is_received;
}

/** Starts the time limit, once. @return false if the worker says again that it is ready. */
static bool start_time_limit(Exchange *exchange, const WorkerFrame *frame) {
    bool is_first = !exchange->is_ready;
    exchange->is_ready = true;
    worker_clock_start(&exchange->clock, exchange->process->pid, exchange->call->time_limit,
                       exchange->call->wall_limit);
    worker_clock_exclude(&exchange->clock, frame->processor_seconds);
    return is_first;
}

/**
 * Handles a frame before the result.
 * @return false if it is not valid, or the worker has ended or is late.
 */
static bool handle_frame(Exchange *exchange, const WorkerFrame *frame) {
    bool is_handled = true;
    if (frame->kind == WORKER_FRAME_READY) {
        return start_time_limit(exchange, frame);
    }
    if (frame->kind == WORKER_FRAME_UNFILTERED) {
        atomic_store(&was_unfiltered, true);
    } else if (frame->kind == WORKER_FRAME_PROGRESS) {
        exchange->fraction = fmin(fmax(frame->per_mille / 1000.0, 0), 1);
    } else if (frame->kind == WORKER_FRAME_QUESTION) {
        is_handled = answer_question(exchange, frame->report_size);
    } else if (frame->kind == WORKER_FRAME_REPORT) {
        // The worker ends by a signal then, which describes the error.
        is_handled = receive_report(exchange, frame);
    } else {
        is_handled = false;
    }
    // A worker that keeps talking is late, too.
    exchange->is_late = exchange->is_late || worker_clock_left(&exchange->clock) < 0;
    return is_handled && !exchange->is_late;
}

/** Receives the answer. @return Whether there is a result. */
static bool receive_reply(Exchange *exchange, WorkerReply *reply) {
    WorkerFrame frame;
    while (receive(exchange, &frame, sizeof frame)) {
        if (frame.kind == WORKER_FRAME_RESULT) {
            return receive_report(exchange, &frame) && receive_block(exchange, &frame, reply);
        }
        if (!handle_frame(exchange, &frame)) {
            return false;
        }
    }
    return false;
}

/** Requests the report of a late worker, and kills it. */
static void end_late_worker(Exchange *exchange, WorkerProcess *process) {
    if (!is_stopped(exchange)) {
        WorkerReply none = {0};
        Exchange last = {.process = process, .call = exchange->call, .is_ready = true};
        worker_clock_start_wall(&last.clock, REPORT_LIMIT);
        kill(process->pid, SIGXCPU);
        if (receive_reply(&last, &none) && none.block && !exchange->call->block) {
            munmap(none.block, none.block_size);
        }
    }
    worker_process_stop(process);
}

/**
 * Drops a result that came too late, unnoticed because this process had to wait.
 * @return Whether it came in time.
 */
static bool is_in_time(Exchange *exchange, WorkerReply *reply) {
    exchange->is_late = worker_clock_left(&exchange->clock) < 0;
    if (exchange->is_late && reply->block && !exchange->call->block) {
        munmap(reply->block, reply->block_size);
    }
    return !exchange->is_late;
}

/**
 * Sends the request and waits for the reply.
 * @param process           The worker.
 * @param call              The call.
 * @param[out] exit_status  Status of a worker that ended without a result.
 * @return The reply.
 */
static WorkerReply converse(WorkerProcess *process, const WorkerCall *call, int *exit_status) {
    WorkerReply reply = {.end = WORKER_FINISHED};
    Exchange exchange = {.process = process, .call = call};
    const Message request = {call->request, call->request_size, call->file};
    worker_clock_start_wall(&exchange.clock, START_LIMIT);
    bool is_finished = send_message(&exchange, &request) && receive_reply(&exchange, &reply) &&
                       is_in_time(&exchange, &reply);
    double seconds = worker_clock_used(&exchange.clock);
    if (is_finished) {
        reply.seconds = seconds;
        reply.is_ready = exchange.is_ready;
        return reply;
    }
    if (exchange.is_late) {
        bool is_stalled = worker_clock_is_stalled(&exchange.clock);
        end_late_worker(&exchange, process);
        return (WorkerReply){.end = WORKER_TIMED_OUT,
                             .is_ready = exchange.is_ready,
                             .is_stalled = is_stalled,
                             .seconds = seconds};
    }
    // A worker that closed its socket has its exit status already, which the signal does not
    // change. One with an invalid reply still runs.
    kill(process->pid, SIGKILL);
    int status = reap(process);
    reply = (WorkerReply){.end = WORKER_EXITED, .is_ready = exchange.is_ready, .seconds = seconds};
    if (exchange.failure) {
        reply.end = WORKER_CUT_OFF;
        reply.detail = exchange.failure;
    } else if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
        reply.end = WORKER_TIMED_OUT; // At its limit of processor time.
    } else if (WIFSIGNALED(status)) {
        reply.end = WORKER_CRASHED;
        reply.detail = WTERMSIG(status);
    } else {
        *exit_status = WEXITSTATUS(status);
    }
    return reply;
}

/** @return Whether a kept worker has ended meanwhile, as by Ctrl-C. */
static bool has_ended(const WorkerProcess *process) {
    char byte;
    return process->pid > 0 &&
           recv(process->socket, &byte, sizeof byte, MSG_PEEK | MSG_DONTWAIT) == 0;
}

WorkerReply worker_process_call(WorkerProcess *process, const WorkerCall *call) {
    WorkerReply reply;
    int exit_status, attempts = 0;
    if (has_ended(process)) {
        worker_process_stop(process);
    }
    do {
        exit_status = 0;
        int failed = process->pid > 0 ? 0 : start(process, call);
        if (failed) {
            return (WorkerReply){.end = WORKER_NOT_STARTED, .detail = failed};
        }
        reply = converse(process, call, &exit_status);
    } while (exit_status == WORKER_EXIT_RETRY && ++attempts < START_ATTEMPTS);
    return reply;
}

WorkerReply worker_process_call_once(const WorkerCall *call) {
    WorkerProcess process = {0};
    WorkerReply reply = worker_process_call(&process, call);
    worker_process_stop(&process);
    return reply;
}

bool worker_reply_is_interrupted(const WorkerReply *reply) {
    return reply->end == WORKER_CRASHED &&
           (reply->detail == SIGINT || reply->detail == SIGTERM || reply->detail == SIGHUP);
}

bool worker_reply_start_failure(const WorkerReply *reply, char reason[WORKER_REASON_SIZE]) {
    bool has_ended = reply->end == WORKER_CRASHED || reply->end == WORKER_EXITED;
    if (reply->end == WORKER_NOT_STARTED || reply->end == WORKER_CUT_OFF) {
        snprintf(reason, WORKER_REASON_SIZE, "%s", error_errno_text(reply->detail));
        return true;
    }
    if (!has_ended || reply->is_ready || worker_reply_is_interrupted(reply)) {
        return false;
    }
    snprintf(reason, WORKER_REASON_SIZE,
             gettext("it ended at its start (%s); memory, threads or files may be short"),
             reply->detail ? strsignal(reply->detail) : gettext("without a signal"));
    return true;
}

bool worker_error_set(Error *error, const Error *reported) {
    bool is_failure = reported->status == STATUS_FAILED;
    error_set(error, is_failure ? STATUS_FAILED : STATUS_SCENE, "%.*s", ERROR_MESSAGE_SIZE - 1,
              reported->message);
    return error_set_line(error, reported->line);
}
