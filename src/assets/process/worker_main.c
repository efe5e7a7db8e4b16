/**
 * @file
 * @brief The main loop of a worker process.
 */
#include "assets/process/worker_main.h"

#include "assets/process/worker_filter.h"
#include "assets/process/worker_protocol.h"
#include "assets/process/worker_sandbox.h"
#include "base/language.h"

#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

/** The current job, for the signal handler; NULL: none, or its result is being sent. */
static WorkerJob *volatile current_job;

/** Sends bytes; exits if the program has closed the socket. */
static void send_bytes(const void *bytes, size_t size) {
    const char *next = bytes;
    while (size > 0) {
        ssize_t count = send(WORKER_SOCKET, next, size, MSG_NOSIGNAL);
        if (count < 0 && errno != EINTR) {
            _exit(EXIT_FAILURE);
        }
        next += count > 0 ? count : 0;
        size -= count > 0 ? (size_t)count : 0;
    }
}

/** Receives bytes; exits if the program has closed the socket. */
static void receive(void *bytes, size_t size) {
    char *next = bytes;
    while (size > 0) {
        ssize_t count = recv(WORKER_SOCKET, next, size, 0);
        if (count == 0 || (count < 0 && errno != EINTR)) {
            _exit(EXIT_FAILURE);
        }
        next += count > 0 ? count : 0;
        size -= count > 0 ? (size_t)count : 0;
    }
}

/** Sends the report of a job, and its block with a result. */
static void send_answer(const WorkerJob *job, WorkerFrameKind kind) {
    const WorkerFrame frame = {.kind = (int)kind,
                               .report_size = job->report ? job->report_size : 0,
                               .block_size = kind == WORKER_FRAME_RESULT ? job->block_size : 0};
    send_bytes(&frame, sizeof frame);
    send_bytes(job->report, frame.report_size);
    send_bytes(job->block, frame.block_size);
}

/** Sends the report in its current state, then ends by the signal. */
static void handle_fatal_signal(int number) {
    WorkerJob *job = current_job;
    current_job = NULL;
    if (job && job->report) {
        send_answer(job, WORKER_FRAME_REPORT);
    }
    signal(number, SIG_DFL);
    raise(number);
}

/**
 * Sets the signals: this process ends with its parent, on Ctrl-C and on crashes, without a core
 * file.
 */
static void set_signals(pid_t parent) {
    static const int fatal[] = {SIGXCPU, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
    static char stack[1 << 16];
    static const struct rlimit no_core = {0, 0};
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) {
        _exit(EXIT_FAILURE);
    }
    setrlimit(RLIMIT_CORE, &no_core);
    signal(SIGPIPE, SIG_IGN);
    sigaltstack(&(stack_t){.ss_sp = stack, .ss_size = sizeof stack}, NULL);
    struct sigaction action = {.sa_handler = handle_fatal_signal, .sa_flags = SA_ONSTACK};
    sigfillset(&action.sa_mask);
    for (size_t i = 0; i < sizeof fatal / sizeof *fatal; i++) {
        sigaction(fatal[i], &action, NULL);
    }
}

/**
 * Receives a request, or the answer to a question; exits if the program has closed the socket.
 * @param[out] header  Its header.
 * @param[out] file    Descriptor sent along; -1: none.
 * @return Its bytes, to be freed with `free`.
 */
static void *receive_message(WorkerRequestHeader *header, int *file) {
    struct iovec part = {header, sizeof *header};
    union {
        struct cmsghdr align;                /**< For the alignment. */
        char bytes[CMSG_SPACE(sizeof(int))]; /**< Memory for a descriptor. */
    } control;
    struct msghdr message = {.msg_iov = &part,
                             .msg_iovlen = 1,
                             .msg_control = control.bytes,
                             .msg_controllen = sizeof control.bytes};
    ssize_t count;
    do {
        count = recvmsg(WORKER_SOCKET, &message, MSG_CMSG_CLOEXEC | MSG_WAITALL);
    } while (count < 0 && errno == EINTR);
    void *bytes = count == sizeof *header ? malloc(header->size + 1) : NULL;
    if (!bytes) {
        _exit(EXIT_FAILURE);
    }
    const struct cmsghdr *rights = CMSG_FIRSTHDR(&message);
    *file = -1;
    if (rights && rights->cmsg_type == SCM_RIGHTS) {
        memcpy(file, CMSG_DATA(rights), sizeof *file);
    }
    receive(bytes, header->size);
    return bytes;
}

bool worker_is_requested(int argc, char **argv) {
    return argc == WORKER_ARGUMENT_COUNT && strcmp(argv[1], WORKER_OPTION) == 0;
}

_Noreturn void worker_main(char **argv, const WorkerTask *tasks) {
    const WorkerTask *task = tasks;
    set_signals((pid_t)atoi(argv[3]));
    worker_sandbox_prepare();
    language_init_as(strcmp(argv[4], "fr") == 0);
    language_preload(); // The filter of system calls would refuse to open the translations.
    while (task->name && strcmp(task->name, argv[2]) != 0) {
        task++;
    }
    while (task->name) {
        WorkerJob job = {0};
        WorkerRequestHeader header;
        void *bytes = receive_message(&header, &job.file);
        job.request = bytes;
        job.request_size = header.size;
        job.time_limit = header.time_limit;
        current_job = &job;
        task->run(&job);
        current_job = NULL;
        send_answer(&job, WORKER_FRAME_RESULT);
        free(bytes);
        if (job.owns_report) {
            free((void *)(uintptr_t)job.report);
        }
        if (job.block_capacity > 0) {
            munmap(job.block, job.block_capacity);
        }
        if (job.file >= 0) {
            close(job.file);
        }
    }
    _exit(EXIT_FAILURE);
}

void worker_job_ready(void) {
    struct timespec used = {0};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    const WorkerFrame frame = {.kind = WORKER_FRAME_READY,
                               .processor_seconds =
                                   (double)used.tv_sec + 1e-9 * (double)used.tv_nsec};
    send_bytes(&frame, sizeof frame);
}

void worker_job_progress(double fraction) {
    const WorkerFrame frame = {.kind = WORKER_FRAME_PROGRESS, .per_mille = (int)(1000 * fraction)};
    send_bytes(&frame, sizeof frame);
}

void worker_job_check(void) {
    // The system counts the processor time, and ends this process: RLIMIT_CPU.
}

void *worker_job_resize(void *memory, size_t size) {
    if (size == 0) {
        free(memory);
        return NULL;
    }
    return realloc(memory, size);
}

WorkerAnswer worker_job_ask(const void *question, size_t size) {
    const WorkerFrame frame = {.kind = WORKER_FRAME_QUESTION, .report_size = size};
    WorkerRequestHeader header;
    WorkerAnswer answer = {.file = -1};
    send_bytes(&frame, sizeof frame);
    send_bytes(question, size);
    answer.bytes = receive_message(&header, &answer.file);
    answer.size = header.size;
    return answer;
}

void worker_enter_sandbox(size_t bytes) {
    static bool is_reported;
    worker_sandbox_limit(bytes, current_job ? current_job->time_limit : HUGE_VAL);
    if (!worker_filter_install() && !is_reported) {
        is_reported = true;
        send_bytes(&(WorkerFrame){.kind = WORKER_FRAME_UNFILTERED}, sizeof(WorkerFrame));
    }
}

_Noreturn void worker_exit_to_retry(void) {
    _exit(WORKER_EXIT_RETRY);
}
