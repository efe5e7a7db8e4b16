/**
 * @file
 * @brief Tests of worker processes. This program is its own worker.
 */
#include "testing.h"

#include "assets/process/worker_main.h"
#include "assets/process/worker_process.h"

#include "base/clock.h"

#include <sched.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

// --- tasks ---------------------------------------------------------------------------------------

/** Reports a number, then raises the signal of the request. */
static void abort_task(WorkerJob *job) {
    static int report = 7;
    job->report = &report;
    job->report_size = sizeof report;
    worker_job_ready();
    raise(*(const int *)job->request);
}

/** Never ends, and keeps the processor busy. */
static void spin_task(WorkerJob *job) {
    static int report = 8;
    job->report = &report;
    job->report_size = sizeof report;
    worker_job_ready();
    for (;;) {
        __asm__ volatile("");
    }
}

/** Never ends, and uses no processor time. */
static void hang_task(WorkerJob *job) {
    static int report = 9;
    job->report = &report;
    job->report_size = sizeof report;
    worker_job_ready();
    for (;;) {
        pause();
    }
}

/** Reports the request. */
static void echo_task(WorkerJob *job) {
    static int count;
    count++;
    job->report = &count;
    job->report_size = sizeof count;
    worker_job_progress(0.5);
    job->block = (void *)(uintptr_t)job->request;
    job->block_size = job->request_size;
}

/** Always requests a retry because of missing memory. */
static void retry_task(WorkerJob *job) {
    (void)job;
    worker_exit_to_retry();
}

/** Worker tasks of this program. */
static const WorkerTask tasks[] = {{"abort", abort_task}, {"spin", spin_task},
                                   {"hang", hang_task},   {"echo", echo_task},
                                   {"retry", retry_task}, {0}};

// --- tests ---------------------------------------------------------------------------------------

/** @return A call of a task whose report is an int. */
static WorkerCall call_of(const char *task, const void *request, size_t size, double time_limit,
                          int *report) {
    return (WorkerCall){.program = "/proc/self/exe",
                        .task = task,
                        .request = request,
                        .request_size = size,
                        .time_limit = time_limit,
                        .report = report,
                        .report_capacity = sizeof *report,
                        .block_capacity = 1 << 26};
}

/** The exit of a worker is reported; its report is received. */
static void test_ends(void **state) {
    (void)state;
    static const int signals[] = {SIGINT, SIGKILL, SIGTERM, SIGSEGV, SIGABRT};
    for (size_t i = 0; i < 5; i++) {
        int report = 0;
        WorkerCall call = call_of("abort", &signals[i], sizeof *signals, 10, &report);
        WorkerReply reply = worker_process_call_once(&call);
        assert_int_equal(reply.end, WORKER_CRASHED);
        assert_int_equal(reply.detail, signals[i]);
        assert_int_equal(report, i < 3 ? 0 : 7);
    }
    int report = 0, ignored = SIGCHLD;
    WorkerCall call = call_of("abort", &ignored, sizeof ignored, 10, &report);
    assert_int_equal(worker_process_call_once(&call).end, WORKER_FINISHED);
    assert_int_equal(report, 7);
    for (int i = 0; i < 2; i++) {
        call = call_of("spin", NULL, 0, i ? -1 : 0.05, &report);
        assert_int_equal(worker_process_call_once(&call).end, WORKER_TIMED_OUT);
        assert_int_equal(report, 8);
    }
    call = call_of("none", NULL, 0, 10, &report);
    assert_int_equal(worker_process_call_once(&call).end, WORKER_EXITED);
    call = call_of("retry", NULL, 0, 10, &report);
    assert_int_equal(worker_process_call_once(&call).end, WORKER_EXITED);
    call.program = "/none";
    assert_int_equal(worker_process_call_once(&call).end, WORKER_NOT_STARTED);
}

/** Burns processor time until it is killed. @return Its process. */
static pid_t start_burner(void) {
    pid_t burner = fork();
    while (burner == 0) {
        __asm__ volatile("");
    }
    return burner;
}

/**
 * The limit is one of processor time: a worker that gets little of it is not late, and one that
 * only waits is, by a limit on the wall clock.
 */
static void test_processor_time(void **state) {
    (void)state;
    enum { BURNERS = 16 };
    const double limit = 0.1;
    pid_t burners[BURNERS];
    int report = 0;
    cpu_set_t all, one;
    // All processes on one processor, so that the worker gets a small share of it.
    assert_int_equal(sched_getaffinity(0, sizeof all, &all), 0);
    CPU_ZERO(&one);
    for (size_t i = 0; i < CPU_SETSIZE && CPU_COUNT(&one) == 0; i++) {
        if (CPU_ISSET(i, &all)) {
            CPU_SET(i, &one);
        }
    }
    assert_int_equal(sched_setaffinity(0, sizeof one, &one), 0);
    for (int i = 0; i < BURNERS; i++) {
        burners[i] = start_burner();
    }
    WorkerCall call = call_of("spin", NULL, 0, limit, &report);
    double start = clock_now_seconds();
    WorkerReply reply = worker_process_call_once(&call);
    double taken = clock_now_seconds() - start;
    for (int i = 0; i < BURNERS; i++) {
        kill(burners[i], SIGKILL);
        waitpid(burners[i], NULL, 0);
    }
    sched_setaffinity(0, sizeof all, &all);
    assert_int_equal(reply.end, WORKER_TIMED_OUT);
    assert_false(reply.is_stalled);
    assert_int_equal(report, 8);
    assert_true(reply.seconds >= limit);
    // By the wall clock it would have been killed long before.
    assert_true(taken > 2 * limit);
    call = call_of("hang", NULL, 0, 60, &report);
    call.wall_limit = 0.2;
    reply = worker_process_call_once(&call);
    assert_int_equal(reply.end, WORKER_TIMED_OUT);
    assert_true(reply.is_stalled && reply.seconds < 0.2);
    assert_int_equal(report, 9);
}

/**
 * A worker can be kept for several calls; its data arrive complete; it is restarted after it died.
 */
static void test_kept_worker(void **state) {
    (void)state;
    const size_t size = 10000000;
    char *bytes = malloc(size);
    int report = 0;
    WorkerProcess process = {0};
    assert_non_null(bytes);
    for (size_t i = 0; i < size; i++) {
        bytes[i] = (char)(i * 7 + i / 4096);
    }
    WorkerCall call = call_of("echo", bytes, size, 10, &report);
    for (int i = 0; i < 4; i++) {
        WorkerReply reply = worker_process_call(&process, &call);
        assert_int_equal(reply.end, WORKER_FINISHED);
        assert_int_equal(reply.block_size, size);
        assert_memory_equal(reply.block, bytes, size);
        assert_int_equal(report, 1 + i % 2);
        munmap(reply.block, size);
        if (i == 1) {
            kill(process.pid, SIGKILL);
            usleep(100000);
        }
    }
    call.block_capacity = size - 1;
    assert_int_not_equal(worker_process_call(&process, &call).end, WORKER_FINISHED);
    worker_process_stop(&process);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
    free(bytes);
}

/** A worker ends with its parent process. */
static void test_worker_dies_with_its_parent(void **state) {
    (void)state;
    int ends[2], report;
    char byte;
    assert_int_equal(pipe(ends), 0);
    pid_t parent = fork();
    if (parent == 0) {
        close(ends[0]);
        WorkerCall call = call_of("hang", NULL, 0, 60, &report);
        worker_process_call_once(&call);
        _exit(0);
    }
    close(ends[1]);
    usleep(300000);
    kill(parent, SIGKILL);
    waitpid(parent, NULL, 0);
    // Parent and worker held the other end; the pipe is closed when both have ended.
    alarm(10);
    assert_int_equal(read(ends[0], &byte, 1), 0);
    alarm(0);
    close(ends[0]);
}

/** @return 0 if all tests pass. */
int main(int argc, char **argv) {
    const struct CMUnitTest tests_of_workers[] = {
        cmocka_unit_test(test_ends),
        cmocka_unit_test(test_processor_time),
        cmocka_unit_test(test_kept_worker),
        cmocka_unit_test(test_worker_dies_with_its_parent),
    };
    if (worker_is_requested(argc, argv)) {
        worker_main(argv, tasks);
    }
    return cmocka_run_group_tests_name("worker", tests_of_workers, NULL, NULL);
}
