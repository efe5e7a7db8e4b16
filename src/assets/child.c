/**
 * @file
 * @brief Work in a child process, with a deadline that nothing can get round.
 */
#include "assets/child.h"

#include "dioptre/clock.h"

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
    static const int usual[] = {SIGHUP,  SIGINT,  SIGQUIT, SIGTERM, SIGALRM, SIGCHLD, SIGUSR1,
                                SIGUSR2, SIGSEGV, SIGBUS,  SIGFPE,  SIGILL,  SIGABRT};
    for (size_t i = 0; i < sizeof usual / sizeof *usual; i++) {
        signal(usual[i], SIG_DFL);
    }
    signal(SIGPIPE, SIG_IGN);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
}

/**
 * The child's whole life. Ends with _exit: what the program does when it ends is not for a child.
 * @param work     The work.
 * @param context  Handed to it.
 * @param parent   The process that waits.
 */
_Noreturn static void live(void (*work)(void *), void *context, pid_t parent) {
    static const struct rlimit no_core = {0, 0};
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) {
        _exit(EXIT_FAILURE);
    }
    setrlimit(RLIMIT_CORE, &no_core);
    reset_signals();
    work(context);
    _exit(EXIT_SUCCESS);
}

/**
 * Starts the child. No signal is delivered between the fork and the child's own arrangements.
 * @param work     The work.
 * @param context  Handed to it.
 * @return The child's number; -1 with errno set.
 */
static pid_t start(void (*work)(void *), void *context) {
    sigset_t all, before;
    pid_t parent = getpid();
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    pid_t child = fork();
    if (child == 0) {
        live(work, context, parent);
    }
    int reason = errno;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    errno = reason;
    return child;
}

/**
 * @return Milliseconds until a moment, rounded up; 0 when it has passed.
 * @param deadline  The moment, on #clock_seconds.
 */
static int milliseconds_until(double deadline) {
    double left = ceil(1000 * (deadline - clock_seconds()));
    return left > 0 ? (int)fmin(left, INT_MAX) : 0;
}

/**
 * Sleeps until a pipe is closed at its other end.
 * @param pipe   The end to read from.
 * @param until  Until when, on #clock_seconds.
 * @param[out] is_closed  Whether it was closed in time.
 * @return false where there is no sense in sleeping on: it is closed, or cannot be watched.
 */
static bool wait_for_close(int pipe, double until, bool *is_closed) {
    struct pollfd watched = {.fd = pipe, .events = POLLIN};
    *is_closed = false;
    for (;;) {
        int ready = poll(&watched, 1, milliseconds_until(until));
        if (ready > 0) {
            *is_closed = true;
            return false;
        }
        if (ready == 0 && milliseconds_until(until) == 0) {
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
 * @param start     When the child was started, on #clock_seconds.
 * @param deadline  Until when, on #clock_seconds.
 * @param watcher   Who is told; NULL: nobody.
 * @return Whether it was closed in time.
 */
static bool watch(int pipe, double start, double deadline, const ChildWatcher *watcher) {
    /** Seconds from one telling to the next: five a second are smooth enough to read. */
    const double pause = 0.2;
    bool is_closed;
    double until;
    do {
        until = watcher ? fmin(deadline, clock_seconds() + pause) : deadline;
        if (!wait_for_close(pipe, until, &is_closed)) {
            return is_closed;
        }
        if (watcher && watcher->tell) {
            watcher->tell(watcher->context, clock_seconds() - start);
        }
    } while (until < deadline && !(watcher && watcher->stop && atomic_load(watcher->stop)));
    return false;
}

/**
 * Reaps a child, killing it where it is late.
 * @param child        The child.
 * @param is_late      Whether it has not ended by the deadline.
 * @param[out] detail  The signal that it died of, or 0.
 * @return How it ended.
 */
static ChildEnd reap(pid_t child, bool is_late, int *detail) {
    int status = 0;
    pid_t ended = is_late ? waitpid(child, &status, WNOHANG) : 0;
    is_late = is_late && ended == 0;
    if (is_late) {
        kill(child, SIGKILL);
    }
    while (ended == 0 || (ended < 0 && errno == EINTR)) {
        ended = waitpid(child, &status, 0);
    }
    if (is_late) {
        return CHILD_LATE;
    }
    *detail = ended == child && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return *detail ? CHILD_CRASHED : CHILD_ENDED;
}

ChildEnd child_run(void (*work)(void *context), void *context, double seconds, int *detail) {
    return child_run_watched(work, context, seconds, NULL, detail);
}

ChildEnd child_run_watched(void (*work)(void *context), void *context, double seconds,
                           const ChildWatcher *watcher, int *detail) {
    double started = clock_seconds(), deadline = started + seconds;
    // The child holds the writing end for as long as it lives, and never writes.
    int ends[2];
    *detail = 0;
    if (pipe2(ends, O_CLOEXEC) != 0) {
        *detail = errno;
        return CHILD_UNSTARTED;
    }
    pid_t child = start(work, context);
    int reason = errno;
    close(ends[1]);
    ChildEnd end = CHILD_UNSTARTED;
    if (child < 0) {
        *detail = reason;
    } else {
        end = reap(child, !watch(ends[0], started, deadline, watcher), detail);
    }
    close(ends[0]);
    return end;
}

/** @return Bytes that this process has for its data already. */
static size_t used_memory(void) {
    unsigned long pages = 0;
    FILE *file = fopen("/proc/self/statm", "re");
    bool is_read = file && fscanf(file, "%*s %*s %*s %*s %*s %lu", &pages) == 1;
    if (file) {
        fclose(file);
    }
    return is_read ? pages * (size_t)sysconf(_SC_PAGESIZE) : 0;
}

void child_withdraw(size_t bytes) {
    rlim_t most = (rlim_t)(used_memory() + bytes);
    setrlimit(RLIMIT_DATA, &(struct rlimit){.rlim_cur = most, .rlim_max = most});
    int silence = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (silence >= 0) {
        dup2(silence, STDOUT_FILENO);
        dup2(silence, STDERR_FILENO);
    }
}

void *child_share_memory(size_t size) {
    void *memory =
        mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    return memory == MAP_FAILED ? NULL : memory;
}
