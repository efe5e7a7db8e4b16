/**
 * @file
 * @brief Tests of work in child processes.
 */
#include "testing.h"

#include "assets/process/sandbox_process.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

/** Work that dies of a signal. */
static void abort_task(void *context) {
    raise(*(int *)context);
}

/** Work that takes for ever. */
static void hang_task(void *context) {
    (void)context;
    for (;;) {
        pause();
    }
}

/** How a child ended is told. */
static void test_child_ends(void **state) {
    (void)state;
    int detail, signals[] = {SIGINT, SIGKILL, SIGTERM, SIGCHLD};
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(sandbox_process_run(abort_task, &signals[i], 10, &detail),
                         SANDBOX_PROCESS_CRASHED);
        assert_int_equal(detail, signals[i]);
    }
    assert_int_equal(sandbox_process_run(abort_task, &signals[3], 10, &detail),
                     SANDBOX_PROCESS_EXITED);
    assert_int_equal(detail, 0);
    assert_int_equal(sandbox_process_run(hang_task, NULL, 0.05, &detail),
                     SANDBOX_PROCESS_TIMED_OUT);
    assert_int_equal(sandbox_process_run(hang_task, NULL, -1, &detail), SANDBOX_PROCESS_TIMED_OUT);
}

/** A child does not outlive the program. */
static void test_child_dies_with_its_parent(void **state) {
    (void)state;
    int ends[2], detail;
    char byte;
    assert_int_equal(pipe(ends), 0);
    pid_t parent = fork();
    if (parent == 0) {
        close(ends[0]);
        sandbox_process_run(hang_task, NULL, 60, &detail);
        _exit(0);
    }
    close(ends[1]);
    usleep(100000);
    kill(parent, SIGKILL);
    waitpid(parent, NULL, 0);
    // Both held the other end; it is closed when both are dead.
    alarm(10);
    assert_int_equal(read(ends[0], &byte, 1), 0);
    alarm(0);
    close(ends[0]);
}

/** @return 0 if all is well. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_child_ends),
        cmocka_unit_test(test_child_dies_with_its_parent),
    };
    return cmocka_run_group_tests_name("child", tests, NULL, NULL);
}
