/**
 * @file
 * @brief Counters of processes that do not return from main: a worker is killed after its reply, a
 * test's child ends by `_exit`. Part of `make coverage` only, where the linker's --wrap puts these
 * functions in place of those that they are named after.
 *
 * Counters are written at each end, and before each reply of a worker. Its sandbox stays as it is,
 * but that it may write counters: its filter lets the files of counters be opened as gcc opens
 * them, for reading and writing, and locked; the limit of what it writes is a soft one.
 */
#include "assets/process/worker_filter.h"
#include "assets/process/worker_protocol.h"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

struct gcov_info;
// Of gcc's run time.
void __gcov_dump(void);
void __gcov_reset(void);
void __gcov_init(struct gcov_info *info);
// What --wrap calls in place of the functions, and the functions themselves.
ssize_t __real_send(int file, const void *bytes, size_t size, int flags);
ssize_t __wrap_send(int file, const void *bytes, size_t size, int flags);
_Noreturn void __wrap__exit(int status);
_Noreturn void __real_worker_exit_to_retry(void);
_Noreturn void __wrap_worker_exit_to_retry(void);
long __real_syscall(long number, ...);
long __wrap_syscall(long number, ...);
int __real_setrlimit(__rlimit_resource_t resource, const struct rlimit *limit);
int __wrap_setrlimit(__rlimit_resource_t resource, const struct rlimit *limit);
void __wrap___gcov_init(struct gcov_info *info);
void __wrap___gcov_exit(void);

/** Limits that could keep counters from being written. */
static const __rlimit_resource_t resources[] = {RLIMIT_FSIZE, RLIMIT_DATA, RLIMIT_AS};
/** Number of these limits. */
enum { RESOURCE_COUNT = sizeof resources / sizeof *resources };

/** Size of a file that holds the counters of any source, bytes. */
enum { COUNTERS_SIZE = 1 << 20 };

/**
 * Raises the limits as far as this process may.
 * @param[out] before  What they were.
 * @return Whether counters can be written: a file that is cut off would spoil those of others.
 */
static bool raise_limits(struct rlimit before[RESOURCE_COUNT]) {
    for (size_t i = 0; i < RESOURCE_COUNT; i++) {
        getrlimit(resources[i], &before[i]);
        const struct rlimit soft = {before[i].rlim_max, before[i].rlim_max};
        __real_setrlimit(resources[i], &soft);
    }
    return before[0].rlim_max >= COUNTERS_SIZE;
}

/** Writes the counters, and counts from zero again. */
static void write_counters(void) {
    struct rlimit before[RESOURCE_COUNT];
    if (raise_limits(before)) {
        __gcov_dump();
        __gcov_reset();
    }
    for (size_t i = 0; i < RESOURCE_COUNT; i++) {
        __real_setrlimit(resources[i], &before[i]);
    }
}

/** Keeps gcc from writing counters at the end of a program that may not write so much. */
static void at_exit(int status, void *context) {
    struct rlimit before[RESOURCE_COUNT];
    (void)context;
    if (!raise_limits(before)) {
        fflush(NULL);
        _exit(status);
    }
}

/** Has at_exit() called before gcc writes the counters. */
__attribute__((constructor)) static void register_at_exit(void) {
    on_exit(at_exit, NULL);
}

/** Writes the counters before the header of a reply. See send. */
ssize_t __wrap_send(int file, const void *bytes, size_t size, int flags) {
    const WorkerFrame *frame = bytes;
    if (file == WORKER_SOCKET && size == sizeof *frame &&
        (frame->kind == WORKER_FRAME_RESULT || frame->kind == WORKER_FRAME_REPORT)) {
        write_counters();
    }
    return __real_send(file, bytes, size, flags);
}

/** Writes the counters first. See _exit. */
_Noreturn void __wrap__exit(int status) {
    write_counters();
    for (;;) {
        __real_syscall(SYS_exit_group, status);
    }
}

/** Writes the counters first. See worker_exit_to_retry(). */
_Noreturn void __wrap_worker_exit_to_retry(void) {
    write_counters();
    __real_worker_exit_to_retry();
}

/** Leaves the hard limit of files as it is, so that counters can be written. See setrlimit. */
int __wrap_setrlimit(__rlimit_resource_t resource, const struct rlimit *limit) {
    struct rlimit soft = *limit;
    if (resource == RLIMIT_FSIZE) {
        struct rlimit before;
        getrlimit(resource, &before);
        soft.rlim_max = before.rlim_max;
    }
    return __real_setrlimit(resource, &soft);
}

/** Installs a worker's filter behind rules that allow to write counters. @return As seccomp. */
static long install_filter(long operation, long flags, const struct sock_fprog *program) {
    const struct sock_filter rules[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_openat, 0, 3),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, args[2])),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, O_RDWR | O_CREAT, 0, 5),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_fcntl, 0, 3),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, args[1])),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, F_SETLKW, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    enum { RULE_COUNT = sizeof rules / sizeof *rules };
    struct sock_filter both[RULE_COUNT + WORKER_FILTER_CAPACITY];
    memcpy(both, rules, sizeof rules);
    memcpy(both + RULE_COUNT, program->filter, program->len * sizeof *program->filter);
    const struct sock_fprog longer = {(unsigned short)(RULE_COUNT + program->len), both};
    return __real_syscall(SYS_seccomp, operation, flags, &longer);
}

/** Lets workers write counters. See syscall. */
long __wrap_syscall(long number, ...) {
    enum { ARGUMENT_COUNT = 6 };
    long words[ARGUMENT_COUNT];
    va_list arguments;
    va_start(arguments, number);
    for (int i = 0; i < ARGUMENT_COUNT; i++) {
        words[i] = va_arg(arguments, long);
    }
    va_end(arguments);
    if (number == SYS_seccomp && words[0] == SECCOMP_SET_MODE_FILTER) {
        return install_filter(words[0], words[1], (const struct sock_fprog *)words[2]);
    }
    return __real_syscall(number, words[0], words[1], words[2], words[3], words[4], words[5]);
}

/** Takes the counters of a module, which it would write itself, to those of its worker. */
void __wrap___gcov_init(struct gcov_info *info) {
    __gcov_init(info);
}

/** Does nothing: a module's counters are its worker's. */
void __wrap___gcov_exit(void) {}
