/**
 * @file
 * @brief Tests of the filter of system calls, as the kernel would run it: on this kind of
 * processor, whether or not its kernel filters. test_worker_process.c asks the kernel.
 */
#include "testing.h"

#include "assets/process/worker_filter.h"
#include "assets/process/worker_protocol.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#if defined(__x86_64__)
#define ARCHITECTURE AUDIT_ARCH_X86_64
#define OTHER_ARCHITECTURE AUDIT_ARCH_I386
#elif defined(__aarch64__)
#define ARCHITECTURE AUDIT_ARCH_AARCH64
#define OTHER_ARCHITECTURE AUDIT_ARCH_ARM
#else
#define ARCHITECTURE 0
#define OTHER_ARCHITECTURE 0
#endif

/** The filter under test. */
static struct sock_filter filter[WORKER_FILTER_CAPACITY];
/** Number of its instructions. */
static size_t filter_size;

/** Runs the filter on a call. @return The action; the test fails if the program is not valid. */
static uint32_t run_filter(const struct seccomp_data *call) {
    uint32_t loaded = 0;
    for (size_t i = 0; i < filter_size; i++) {
        const struct sock_filter *at = &filter[i];
        bool is_true = at->code == (BPF_JMP | BPF_JEQ | BPF_K)   ? loaded == at->k
                       : at->code == (BPF_JMP | BPF_JGE | BPF_K) ? loaded >= at->k
                                                                 : (loaded & at->k) != 0;
        switch (at->code) {
        case BPF_RET | BPF_K:
            return at->k;
        case BPF_LD | BPF_W | BPF_ABS:
            assert_true(at->k + sizeof loaded <= sizeof *call && at->k % sizeof loaded == 0);
            memcpy(&loaded, (const char *)call + at->k, sizeof loaded);
            break;
        case BPF_JMP | BPF_JEQ | BPF_K:
        case BPF_JMP | BPF_JGE | BPF_K:
        case BPF_JMP | BPF_JSET | BPF_K:
            i += is_true ? at->jt : at->jf;
            break;
        default:
            fail_msg("instruction %zu has code %u", i, at->code);
        }
    }
    fail_msg("the filter has no end");
    return 0;
}

/** @return What happens to a call. @param argument Number of the one that is not 0. */
static uint32_t action_of(int number, int argument, uint64_t value) {
    struct seccomp_data call = {.nr = number, .arch = ARCHITECTURE};
    call.args[argument] = value;
    return run_filter(&call);
}

/** Writes the filter; there is none on other processors. @return 0 */
static int set_up(void **state) {
    (void)state;
    filter_size = worker_filter_write(filter);
    return 0;
}

/** Each rule gives its action on this processor, whose calls have numbers of their own. */
static void test_actions(void **state) {
    (void)state;
    const uint32_t refused = SECCOMP_RET_ERRNO | EACCES, unknown = SECCOMP_RET_ERRNO | ENOSYS;
    const uint32_t forbidden = SECCOMP_RET_ERRNO | EPERM, no_more = SECCOMP_RET_ERRNO | EAGAIN;
    const uint32_t killed = SECCOMP_RET_KILL_PROCESS, allowed = SECCOMP_RET_ALLOW;
    const struct {
        int number;      /**< Of the call. */
        int argument;    /**< Which one is given. */
        uint64_t value;  /**< Its value. */
        uint32_t action; /**< What happens. */
    } calls[] = {
        {SYS_read, 0, 0, allowed},
        {SYS_futex, 0, 0, allowed},
        {SYS_exit_group, 0, 0, allowed},
        {SYS_mmap, 2, PROT_READ | PROT_WRITE, allowed},
        {SYS_mmap, 2, PROT_READ | PROT_EXEC, forbidden},
        {SYS_mprotect, 2, PROT_EXEC, forbidden},
        {SYS_sendto, 0, WORKER_SOCKET, allowed},
        {SYS_sendto, 0, WORKER_SOCKET + 1, killed},
        {SYS_recvmsg, 0, WORKER_SOCKET + 1, killed},
        {SYS_fcntl, 1, F_GETFL, allowed},
        {SYS_fcntl, 1, F_SETOWN, forbidden},
        {SYS_kill, 0, (uint64_t)getpid(), allowed},
        {SYS_kill, 0, 1, killed},
        {SYS_tgkill, 0, 1, killed},
        {SYS_prlimit64, 0, 0, allowed},
        {SYS_prlimit64, 0, 1, forbidden},
        {SYS_clone, 0, CLONE_VM | CLONE_THREAD, no_more},
        {SYS_clone, 0, SIGCHLD, killed},
        {SYS_clone3, 0, 0, unknown},
        {SYS_openat, 0, 0, refused},
        {SYS_newfstatat, 0, 0, refused},
        {SYS_readlinkat, 0, 0, refused},
        {SYS_socket, 0, 0, killed},
        {SYS_connect, 0, 0, killed},
        {SYS_execve, 0, 0, killed},
        {SYS_ptrace, 0, 0, killed},
        {SYS_mount, 0, 0, killed},
        {SYS_unlinkat, 0, 0, unknown},
        {SYS_prctl, 0, 0, unknown},
        {SYS_ioctl, 0, 0, unknown},
        {SYS_pwrite64, 0, 0, unknown},
        {100000, 0, 0, unknown},
    };
    for (size_t i = 0; filter_size > 0 && i < sizeof calls / sizeof *calls; i++) {
        uint32_t action = action_of(calls[i].number, calls[i].argument, calls[i].value);
        if (action != calls[i].action) {
            fail_msg("call %d (row %zu): %#x, not %#x", calls[i].number, i, action,
                     calls[i].action);
        }
    }
}

/** The calls of another kind of processor, which this one runs, too, have other numbers. */
static void test_other_interfaces(void **state) {
    (void)state;
    const int x32 = 0x40000000; // Of x86-64; on others it is no call.
    struct seccomp_data call = {.nr = SYS_read, .arch = OTHER_ARCHITECTURE};
    if (filter_size > 0) {
        assert_int_equal(run_filter(&call), SECCOMP_RET_KILL_PROCESS);
        assert_int_equal(action_of(SYS_read | x32, 0, 0), SECCOMP_RET_KILL_PROCESS);
        assert_int_equal(action_of(-1, 0, 0), SECCOMP_RET_KILL_PROCESS);
    }
}

/** Of a call by number, nothing that is not listed is allowed. */
static void test_allowed_calls(void **state) {
    (void)state;
    int allowed = 0;
    for (int number = 0; filter_size > 0 && number < 1000; number++) {
        allowed += action_of(number, 0, 0) == SECCOMP_RET_ALLOW;
    }
    // 33 that are always allowed, and conditions that zeros fulfil: mmap, mprotect, prlimit64.
    assert_in_range(allowed, filter_size > 0 ? 30 : 0, 37);
}

/** @return 0 if all tests pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_actions),
        cmocka_unit_test(test_other_interfaces),
        cmocka_unit_test(test_allowed_calls),
    };
    return cmocka_run_group_tests_name("worker filter", tests, set_up, NULL);
}
