/**
 * @file
 * @brief The filter of system calls of a worker process (seccomp).
 */
#include "assets/process/worker_filter.h"

#include "assets/process/worker_protocol.h"

#include <assert.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#if defined(__x86_64__) && !defined(__ILP32__)
#define FILTER_ARCHITECTURE AUDIT_ARCH_X86_64
#elif defined(__aarch64__) && defined(__AARCH64EL__)
#define FILTER_ARCHITECTURE AUDIT_ARCH_AARCH64
#endif

#ifdef FILTER_ARCHITECTURE

/** First number of the calls of x32, another interface of x86-64 with numbers of its own. */
enum { X32_CALLS = 0x40000000 };

/** What happens to a call; the values are those of the kernel. */
enum {
    ALLOW = (int)SECCOMP_RET_ALLOW,
    /** No library asks for it while it decodes a file. */
    KILL = (int)SECCOMP_RET_KILL_PROCESS,
    /** As for a file that one may not read: libraries do without optional files. */
    DENY = (int)(SECCOMP_RET_ERRNO | EACCES),
    /** As on an older kernel: the C library then uses an older call. */
    UNKNOWN = (int)(SECCOMP_RET_ERRNO | ENOSYS),
    NOT_PERMITTED = (int)(SECCOMP_RET_ERRNO | EPERM),
    /** As where no more threads are allowed; root, too, whom the limit of processes does not stop.
     */
    NO_MORE = (int)(SECCOMP_RET_ERRNO | EAGAIN)
};

/** Condition on an argument of a call, of which the lower 32 bits are compared. */
typedef enum {
    CONDITION_NONE,     /**< None. */
    CONDITION_EQUAL,    /**< It equals #FilterRule.value. */
    CONDITION_SELF,     /**< It is this process. */
    CONDITION_HAS_BIT,  /**< It has the bit. */
    CONDITION_LACKS_BIT /**< It lacks the bit. */
} FilterCondition;

/** A rule on a system call. */
typedef struct FilterRule {
    int call;                  /**< Its number. */
    int action;                /**< What happens to it if the condition holds. */
    FilterCondition condition; /**< The condition. */
    int argument;              /**< Number of the argument, from 0. */
    uint32_t value;            /**< What it is compared with. */
    int otherwise;             /**< What happens if the condition does not hold. */
} FilterRule;

/** Instructions of a rule, at most. */
enum { RULE_INSTRUCTIONS = 5 };
/** Instructions before the first rule and after the last one. */
enum { FRAME_INSTRUCTIONS = 7 };

/** A filter being written. */
typedef struct Filter {
    struct sock_filter *next; /**< The next instruction. */
} Filter;

/** Appends an instruction. */
static void filter_add(Filter *filter, unsigned code, uint32_t value, unsigned if_true,
                       unsigned if_false) {
    *filter->next++ =
        (struct sock_filter){(uint16_t)code, (uint8_t)if_true, (uint8_t)if_false, value};
}

/** Appends a load of a field of `struct seccomp_data`. */
static void filter_load(Filter *filter, size_t offset) {
    filter_add(filter, BPF_LD | BPF_W | BPF_ABS, (uint32_t)offset, 0, 0);
}

/** Appends an end with an action. */
static void filter_return(Filter *filter, int action) {
    filter_add(filter, BPF_RET | BPF_K, (uint32_t)action, 0, 0);
}

/** Appends a rule. The number of the call is loaded before and, unless the rule matches, after. */
static void filter_add_rule(Filter *filter, const FilterRule *rule) {
    const unsigned equal = BPF_JMP | BPF_JEQ | BPF_K, has_bit = BPF_JMP | BPF_JSET | BPF_K;
    bool is_conditional = rule->condition != CONDITION_NONE;
    filter_add(filter, equal, (uint32_t)rule->call, 0, is_conditional ? RULE_INSTRUCTIONS - 1 : 1);
    if (is_conditional) {
        filter_load(filter, offsetof(struct seccomp_data, args) +
                                sizeof(uint64_t) * (size_t)rule->argument);
        bool is_self = rule->condition == CONDITION_SELF;
        bool is_equal = is_self || rule->condition == CONDITION_EQUAL;
        bool is_reversed = rule->condition == CONDITION_LACKS_BIT;
        filter_add(filter, is_equal ? equal : has_bit, is_self ? (uint32_t)getpid() : rule->value,
                   is_reversed, !is_reversed);
    }
    filter_return(filter, rule->action);
    if (is_conditional) {
        filter_return(filter, rule->otherwise);
    }
}

/** A call with an action. */
#define CALL(name, what)                                                                           \
    { .call = SYS_##name, .action = what }
/** A call with an action under a condition. */
#define CALL_WHEN(name, what, which, how, number, otherwise_)                                      \
    {                                                                                              \
        .call = SYS_##name, .action = what, .condition = how, .argument = which, .value = number,  \
        .otherwise = otherwise_                                                                    \
    }
/** A call that is allowed under a condition. */
#define CALL_IF(name, which, how, number, otherwise_)                                              \
    CALL_WHEN(name, ALLOW, which, how, number, otherwise_)

/** The rules of a worker; the first ones are the fastest. */
static const FilterRule rules[] = {
    // Locks, memory, the file of the request, the socket.
    CALL(futex, ALLOW),
    CALL(read, ALLOW),
    CALL(pread64, ALLOW),
    CALL(lseek, ALLOW),
    CALL_IF(mmap, 2, CONDITION_LACKS_BIT, PROT_EXEC, NOT_PERMITTED),
    CALL_IF(mprotect, 2, CONDITION_LACKS_BIT, PROT_EXEC, NOT_PERMITTED),
    CALL(munmap, ALLOW),
    CALL(mremap, ALLOW),
    CALL(madvise, ALLOW),
    CALL(brk, ALLOW),
    CALL_IF(sendto, 0, CONDITION_EQUAL, WORKER_SOCKET, KILL),
    CALL_IF(recvfrom, 0, CONDITION_EQUAL, WORKER_SOCKET, KILL),
    CALL_IF(recvmsg, 0, CONDITION_EQUAL, WORKER_SOCKET, KILL),
    CALL(close, ALLOW),
    CALL(dup, ALLOW),
    CALL_IF(fcntl, 1, CONDITION_EQUAL, F_GETFL, NOT_PERMITTED),
    // The streams, which lead to /dev/null; no file is open for writing.
    CALL(write, ALLOW),
    CALL(writev, ALLOW),
    // Of descriptors. newfstatat takes paths, too, which a filter cannot read. The C library calls
    // it for the size of a buffer, and has a default.
    CALL(fstat, ALLOW),
    CALL(newfstatat, DENY),
    CALL(clock_gettime, ALLOW),
    CALL(clock_getres, ALLOW),
    CALL(gettimeofday, ALLOW),
    CALL(clock_nanosleep, ALLOW),
    CALL(nanosleep, ALLOW),
    CALL(getrandom, ALLOW),
    CALL(sysinfo, ALLOW),
    CALL(getrusage, ALLOW),
    // Limits of this process only, for the next request.
    CALL_IF(prlimit64, 0, CONDITION_EQUAL, 0, NOT_PERMITTED),
    // Signals of this process only: abort.
    CALL(rt_sigaction, ALLOW),
    CALL(rt_sigprocmask, ALLOW),
    CALL(rt_sigreturn, ALLOW),
    CALL(sigaltstack, ALLOW),
    CALL(restart_syscall, ALLOW),
    CALL_IF(tgkill, 0, CONDITION_SELF, 0, KILL),
    CALL_IF(kill, 0, CONDITION_SELF, 0, KILL),
    // No more threads, as the libraries have theirs when they are loaded, and no processes. With
    // clone3 the flags are out of the filter's sight.
    CALL_WHEN(clone, NO_MORE, 0, CONDITION_HAS_BIT, CLONE_THREAD, KILL),
    CALL(clone3, UNKNOWN),
    CALL(set_robust_list, ALLOW),
    CALL(rseq, ALLOW),
    CALL(sched_yield, ALLOW),
    CALL(sched_getaffinity, ALLOW),
    CALL(getpid, ALLOW),
    CALL(gettid, ALLOW),
    CALL(exit, ALLOW),
    CALL(exit_group, ALLOW),
    // Files by name.
    CALL(openat, DENY),
    CALL(openat2, DENY),
    CALL(faccessat, DENY),
    CALL(readlinkat, DENY),
#ifdef SYS_open
    CALL(open, DENY),
    CALL(creat, DENY),
    CALL(stat, DENY),
    CALL(lstat, DENY),
    CALL(access, DENY),
    CALL(readlink, DENY),
#endif
    // What nobody does who decodes a file: network, programs, processes, other processes.
    CALL(socket, KILL),
    CALL(socketpair, KILL),
    CALL(connect, KILL),
    CALL(bind, KILL),
    CALL(listen, KILL),
    CALL(accept, KILL),
    CALL(accept4, KILL),
    CALL(sendmsg, KILL),
    CALL(execve, KILL),
    CALL(execveat, KILL),
#ifdef SYS_fork
    CALL(fork, KILL),
    CALL(vfork, KILL),
#endif
    CALL(ptrace, KILL),
    CALL(process_vm_readv, KILL),
    CALL(process_vm_writev, KILL),
    CALL(tkill, KILL),
    CALL(rt_sigqueueinfo, KILL),
    CALL(rt_tgsigqueueinfo, KILL),
    CALL(pidfd_send_signal, KILL),
    CALL(io_uring_setup, KILL),
    CALL(bpf, KILL),
    CALL(unshare, KILL),
    CALL(setns, KILL),
    CALL(mount, KILL),
};

static_assert(FRAME_INSTRUCTIONS + RULE_INSTRUCTIONS * (sizeof rules / sizeof *rules) <=
                  WORKER_FILTER_CAPACITY,
              "the filter has room");

size_t worker_filter_write(struct sock_filter instructions[WORKER_FILTER_CAPACITY]) {
    Filter filter = {instructions};
    filter_load(&filter, offsetof(struct seccomp_data, arch));
    filter_add(&filter, BPF_JMP | BPF_JEQ | BPF_K, FILTER_ARCHITECTURE, 1, 0);
    filter_return(&filter, KILL);
    filter_load(&filter, offsetof(struct seccomp_data, nr));
    filter_add(&filter, BPF_JMP | BPF_JGE | BPF_K, X32_CALLS, 0, 1);
    filter_return(&filter, KILL);
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        filter_add_rule(&filter, &rules[i]);
    }
    filter_return(&filter, UNKNOWN);
    return (size_t)(filter.next - instructions);
}

/** Asks the kernel to filter the calls of all threads. @return Whether it does. */
static bool install_filter(void) {
    struct sock_filter instructions[WORKER_FILTER_CAPACITY];
    const struct sock_fprog program = {.len = (unsigned short)worker_filter_write(instructions),
                                       .filter = instructions};
    return syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program) == 0;
}

#else

size_t worker_filter_write(struct sock_filter instructions[WORKER_FILTER_CAPACITY]) {
    (void)instructions;
    return 0;
}

/** @return false: there is no filter for this kind of processor. */
static bool install_filter(void) {
    return false;
}

#endif

bool worker_filter_install(void) {
    static bool is_tried, is_filtered;
    if (!is_tried) {
        is_tried = true;
        is_filtered = install_filter();
    }
    return is_filtered;
}
