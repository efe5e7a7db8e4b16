/**
 * @file
 * @brief Work in a child process, with a deadline that nothing can get round.
 */
#include "assets/process/sandbox_process.h"

#include "base/clock.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/**
 * Undoes, in the child, what the program has arranged for its own signals: Ctrl-C ends the child
 * as it would end any other, and a closed terminal does not. A crash is one, whoever would catch
 * it.
 */
static void reset_signals(void) {
    static const int signals[] = {SIGHUP,  SIGINT,  SIGQUIT, SIGTERM, SIGALRM, SIGCHLD, SIGUSR1,
                                  SIGUSR2, SIGSEGV, SIGBUS,  SIGFPE,  SIGILL,  SIGABRT};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        signal(signals[i], SIG_DFL);
    }
    signal(SIGPIPE, SIG_IGN);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
}

/** The child's whole life. Ends with _exit: what the program does when it ends is not for a child.
 */
_Noreturn static void child_main(void (*task)(void *), void *context, pid_t parent) {
    static const struct rlimit no_core = {0, 0};
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) {
        _exit(EXIT_FAILURE);
    }
    setrlimit(RLIMIT_CORE, &no_core);
    reset_signals();
    task(context);
    _exit(EXIT_SUCCESS);
}

/** Starts the child. No signal is delivered between the fork and the child's own arrangements.
 *  @return The child's number; -1 with errno set. */
static pid_t fork_child(void (*task)(void *), void *context) {
    sigset_t all, before;
    pid_t parent = getpid();
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    pid_t child = fork();
    if (child == 0) {
        child_main(task, context, parent);
    }
    int reason = errno;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    errno = reason;
    return child;
}

/**
 * @return Milliseconds until a moment, rounded up; 0 when it has passed.
 * @param deadline  The moment, on #clock_now_seconds.
 */
static int milliseconds_until(double deadline) {
    double left = ceil(1000 * (deadline - clock_now_seconds()));
    return left > 0 ? (int)fmin(left, INT_MAX) : 0;
}

/**
 * Sleeps until a pipe is closed at its other end.
 * @param pipe   The end to read from.
 * @param deadline  Until when, on #clock_now_seconds.
 * @param[out] is_closed  Whether it was closed in time.
 * @return false where there is no sense in sleeping on: it is closed, or cannot be watched.
 */
static bool wait_for_close(int pipe, double deadline, bool *is_closed) {
    struct pollfd watched = {.fd = pipe, .events = POLLIN};
    *is_closed = false;
    for (;;) {
        int ready = poll(&watched, 1, milliseconds_until(deadline));
        if (ready > 0) {
            *is_closed = true;
            return false;
        }
        if (ready == 0 && milliseconds_until(deadline) == 0) {
            return true;
        }
        if (ready < 0 && errno != EINTR) {
            return false;
        }
    }
}

/**
 * Sleeps until a pipe is closed at its other end, and tells a watcher now and then.
 * @param pipe      The end to read from.
 * @param started     When the child was started, on #clock_now_seconds.
 * @param deadline  Until when, on #clock_now_seconds.
 * @param monitor   Who is told; NULL: nobody.
 * @return Whether it was closed in time.
 */
static bool monitor_child(int pipe, double started, double deadline,
                          const SandboxProcessMonitor *monitor) {
    /** Seconds from one telling to the next: five a second are smooth enough to read. */
    const double interval = 0.2;
    bool is_closed;
    double until;
    do {
        until = monitor ? fmin(deadline, clock_now_seconds() + interval) : deadline;
        if (!wait_for_close(pipe, until, &is_closed)) {
            return is_closed;
        }
        if (monitor && monitor->on_tick) {
            monitor->on_tick(monitor->context, clock_now_seconds() - started);
        }
    } while (until < deadline && !(monitor && monitor->stop && atomic_load(monitor->stop)));
    return false;
}

/**
 * Reaps a child, killing it where it is late.
 * @param is_timed_out  Whether it has not ended by the deadline.
 * @param[out] detail  The signal that it died of, or 0.
 * @return How it ended.
 */
static SandboxProcessEnd reap_child(pid_t child, bool is_timed_out, int *detail) {
    int status = 0;
    pid_t ended = is_timed_out ? waitpid(child, &status, WNOHANG) : 0;
    is_timed_out = is_timed_out && ended == 0;
    if (is_timed_out) {
        kill(child, SIGKILL);
    }
    while (ended == 0 || (ended < 0 && errno == EINTR)) {
        ended = waitpid(child, &status, 0);
    }
    if (is_timed_out) {
        return SANDBOX_PROCESS_TIMED_OUT;
    }
    *detail = ended == child && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return *detail ? SANDBOX_PROCESS_CRASHED : SANDBOX_PROCESS_EXITED;
}

SandboxProcessEnd sandbox_process_run(void (*task)(void *context), void *context, double time_limit,
                                      int *detail) {
    return sandbox_process_run_monitored(task, context, time_limit, NULL, detail);
}

SandboxProcessEnd sandbox_process_run_monitored(void (*task)(void *context), void *context,
                                                double time_limit,
                                                const SandboxProcessMonitor *monitor, int *detail) {
    double started = clock_now_seconds(), deadline = started + time_limit;
    // The child holds the writing end for as long as it lives, and never writes.
    int ends[2];
    *detail = 0;
    if (pipe2(ends, O_CLOEXEC) != 0) {
        *detail = errno;
        return SANDBOX_PROCESS_NOT_STARTED;
    }
    pid_t child = fork_child(task, context);
    int reason = errno;
    close(ends[1]);
    SandboxProcessEnd end = SANDBOX_PROCESS_NOT_STARTED;
    if (child < 0) {
        *detail = reason;
    } else {
        end = reap_child(child, !monitor_child(ends[0], started, deadline, monitor), detail);
    }
    close(ends[0]);
    return end;
}

/** @return Bytes that this process has for its data already. */
static size_t data_memory_used(void) {
    unsigned long pages = 0;
    FILE *file = fopen("/proc/self/statm", "re");
    bool is_read = file && fscanf(file, "%*s %*s %*s %*s %*s %lu", &pages) == 1;
    if (file) {
        fclose(file);
    }
    return is_read ? pages * (size_t)sysconf(_SC_PAGESIZE) : 0;
}

void sandbox_process_enter(size_t bytes) {
    rlim_t limit = (rlim_t)(data_memory_used() + bytes);
    setrlimit(RLIMIT_DATA, &(struct rlimit){.rlim_cur = limit, .rlim_max = limit});
    int null_device = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (null_device >= 0) {
        dup2(null_device, STDOUT_FILENO);
        dup2(null_device, STDERR_FILENO);
    }
}

void *sandbox_process_share_memory(size_t size) {
    void *memory =
        mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    return memory == MAP_FAILED ? NULL : memory;
}
