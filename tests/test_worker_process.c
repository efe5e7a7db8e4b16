/**
 * @file
 * @brief Tests of worker processes. This program is its own worker.
 */
#include "refused_call.h"
#include "testing.h"

#include "assets/asset_failure.h"
#include "assets/process/worker_main.h"
#include "assets/process/worker_process.h"
#include "assets/process/worker_protocol.h"
#include "assets/process/worker_sandbox.h"

#include "base/clock.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
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

/** What a worker that was taken over tries. */
typedef enum {
    TRY_SOCKET,      /**< The network. */
    TRY_EXEC,        /**< Another program. */
    TRY_FORK,        /**< Another process. */
    TRY_KILL,        /**< A signal to its parent. */
    TRY_TRACE,       /**< Its parent's memory. */
    TRY_SEND_FILE,   /**< To pass a descriptor on. */
    TRY_KILL_COUNT,  /**< The first that is refused with an error number. */
    TRY_OPEN,        /**< A file by its name. */
    TRY_CREATE,      /**< A new file. */
    TRY_REMOVE,      /**< To remove a file. */
    TRY_CODE,        /**< Memory that is run. */
    TRY_UNPROTECT,   /**< Memory that becomes code. */
    TRY_MEMORY,      /**< A GiB of memory. */
    TRY_SHARED,      /**< 16 GiB of shared memory, which the limit of data does not count. */
    TRY_PRIVILEGES,  /**< Its own core files again. */
    TRY_STAT,        /**< The size and times of a file, by its name. */
    TRY_THREAD,      /**< A thread. */
    TRY_ERROR_COUNT, /**< The first that is allowed. */
    TRY_READ,        /**< The file that was sent along, and its size. */
    TRY_CLOCK,       /**< The time, and to sleep. */
    TRY_COUNT        /**< Number of attempts, with those that only separate them. */
} Attempt;

/** The only byte of the file that is sent along. */
enum { SENT_BYTE = '#' };
/** Bytes of memory that the sandbox of the attempts allows. */
enum { ATTEMPT_MEMORY = 64 << 20 };

/** Runs in a thread. See pthread_create. @return Its argument. */
static void *run_nothing(void *argument) {
    return argument;
}

/** Sends a descriptor to the program. @return As sendmsg. */
static ssize_t send_file(int file) {
    char byte = 0, control[CMSG_SPACE(sizeof file)] = {0};
    struct iovec part = {&byte, 1};
    struct msghdr message = {.msg_iov = &part,
                             .msg_iovlen = 1,
                             .msg_control = control,
                             .msg_controllen = sizeof control};
    struct cmsghdr *rights = CMSG_FIRSTHDR(&message);
    rights->cmsg_level = SOL_SOCKET;
    rights->cmsg_type = SCM_RIGHTS;
    rights->cmsg_len = CMSG_LEN(sizeof file);
    memcpy(CMSG_DATA(rights), &file, sizeof file);
    return sendmsg(WORKER_SOCKET, &message, 0);
}

/** Tries what must kill a worker. @return Whether it worked. */
static bool try_deadly(Attempt attempt) {
    char name[] = "/bin/true", *words[] = {name, NULL};
    switch (attempt) {
    case TRY_SOCKET:
        return socket(AF_INET, SOCK_STREAM, 0) >= 0;
    case TRY_EXEC:
        return execve(name, words, NULL) == 0;
    case TRY_FORK:
        return fork() >= 0;
    case TRY_KILL:
        return kill(getppid(), 0) == 0;
    case TRY_TRACE:
        return ptrace(PTRACE_SEIZE, getppid(), NULL, NULL) == 0;
    default:
        return send_file(WORKER_SOCKET) >= 0;
    }
}

/** Tries what is refused or allowed. @return Whether it worked; if not, errno. */
static bool try_harmless(const WorkerJob *job, Attempt attempt) {
    pthread_t thread;
    struct stat info;
    char byte;
    switch (attempt) {
    case TRY_OPEN:
        return open("/etc/passwd", O_RDONLY) >= 0;
    case TRY_CREATE:
        return open("/tmp/dioptre-owned", O_CREAT | O_WRONLY, 0600) >= 0;
    case TRY_REMOVE:
        return unlink("/tmp/dioptre-owned") == 0;
    case TRY_CODE:
        return mmap(NULL, 4096, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) !=
               MAP_FAILED;
    case TRY_UNPROTECT:
        return mprotect(mmap(NULL, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0), 4096,
                        PROT_READ | PROT_EXEC) == 0;
    case TRY_MEMORY:
        return mmap(NULL, (size_t)1 << 30, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1,
                    0) != MAP_FAILED;
    case TRY_SHARED:
        return mmap(NULL, (size_t)16 << 30, PROT_READ | PROT_WRITE,
                    MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0) != MAP_FAILED;
    case TRY_PRIVILEGES:
        return prctl(PR_SET_DUMPABLE, 1) == 0;
    case TRY_STAT:
        return syscall(SYS_newfstatat, AT_FDCWD, "/etc/passwd", &info, AT_EMPTY_PATH) == 0;
    case TRY_READ:
        return pread(job->file, &byte, 1, 0) == 1 && byte == SENT_BYTE &&
               lseek(job->file, 0, SEEK_END) == 1;
    case TRY_THREAD:
        errno = pthread_create(&thread, NULL, run_nothing, NULL);
        return errno == 0 && pthread_join(thread, NULL) == 0;
    default:
        return usleep(1000) == 0 && clock() >= 0;
    }
}

/** Enters the sandbox and tries something. Reports 0: it worked, else errno. */
static void attempt_task(WorkerJob *job) {
    static int report;
    Attempt attempt = *(const Attempt *)job->request;
    job->report = &report;
    job->report_size = sizeof report;
    worker_job_ready();
    worker_enter_sandbox(ATTEMPT_MEMORY);
    errno = 0;
    bool is_done = attempt < TRY_KILL_COUNT ? try_deadly(attempt) : try_harmless(job, attempt);
    report = is_done ? 0 : errno ? errno : -1;
}

/** Number of limits of #limits_task. */
enum { LIMIT_COUNT = 4 };

/** Reports the resources that the sandbox leaves. */
static void limits_task(WorkerJob *job) {
    static rlim_t report[LIMIT_COUNT];
    static const int resources[LIMIT_COUNT] = {RLIMIT_FSIZE, RLIMIT_NOFILE, RLIMIT_CPU,
                                               RLIMIT_NPROC};
    worker_job_ready();
    worker_enter_sandbox(ATTEMPT_MEMORY);
    for (int i = 0; i < LIMIT_COUNT; i++) {
        struct rlimit limit;
        getrlimit(resources[i], &limit);
        report[i] = resources[i] == RLIMIT_NPROC ? limit.rlim_max : limit.rlim_cur;
    }
    job->report = report;
    job->report_size = sizeof report;
}

/** Uses up its processor time in a thread that no signal of the program reaches. */
static void sandboxed_spin_task(WorkerJob *job) {
    (void)job;
    worker_job_ready();
    worker_enter_sandbox(ATTEMPT_MEMORY);
    for (volatile unsigned long i = 0;; i++) {
    }
}

/** Sends frames of a kind without end. */
static void flood_task(WorkerJob *job) {
    const WorkerFrame frame = {.kind = *(const int *)job->request};
    worker_job_ready();
    for (;;) {
        send(WORKER_SOCKET, &frame, sizeof frame, 0);
    }
}

/** Asks questions without end, and reads no answer. */
static void deaf_task(WorkerJob *job) {
    const WorkerFrame frame = {.kind = WORKER_FRAME_QUESTION, .report_size = 1};
    (void)job;
    worker_job_ready();
    for (;;) {
        send(WORKER_SOCKET, &frame, sizeof frame, 0);
        send(WORKER_SOCKET, "q", 1, 0);
    }
}

/** Asks a question of some size, and reports the first byte of the answer. */
static void ask_task(WorkerJob *job) {
    static int report;
    static const char question[2 * WORKER_QUESTION_MAXIMUM] = "q";
    worker_job_ready();
    worker_enter_sandbox(ATTEMPT_MEMORY);
    WorkerAnswer answer = worker_job_ask(question, *(const size_t *)job->request);
    char byte = 0;
    report = answer.size == 1 && answer.file >= 0 && read(answer.file, &byte, 1) == 1
                 ? *(char *)answer.bytes * 256 + byte
                 : -1;
    free(answer.bytes);
    job->report = &report;
    job->report_size = sizeof report;
}

/** Ends before it is ready, as a library that finds no memory. */
static void early_task(WorkerJob *job) {
    (void)job;
    abort();
}

/** Worker tasks of this program. */
static const WorkerTask tasks[] = {{"abort", abort_task},
                                   {"hang", hang_task},
                                   {"echo", echo_task},
                                   {"retry", retry_task},
                                   {"try", attempt_task},
                                   {"spin", spin_task},
                                   {"sandboxed spin", sandboxed_spin_task},
                                   {"flood", flood_task},
                                   {"ask", ask_task},
                                   {"deaf", deaf_task},
                                   {"early", early_task},
                                   {"limits", limits_task},
                                   {0}};

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

/** Where this process has no memory for a result, the worker is not to blame. */
static void test_no_memory_for_the_result(void **state) {
    (void)state;
    enum { SIZE = 1 << 26 };
    int report = 0;
    struct rlimit before, limit;
    char *bytes = calloc(SIZE, 1);
    unsigned long pages = 0;
    FILE *use = fopen("/proc/self/statm", "re");
    assert_true(bytes && use && fscanf(use, "%lu", &pages) == 1);
    fclose(use);
    getrlimit(RLIMIT_AS, &before);
    limit = (struct rlimit){pages * (rlim_t)sysconf(_SC_PAGESIZE) + SIZE / 2, before.rlim_max};
    WorkerProcess process = {0};
    WorkerCall call = call_of("echo", bytes, 1, 10, &report);
    WorkerReply reply = worker_process_call(&process, &call);
    assert_int_equal(reply.end, WORKER_FINISHED);
    munmap(reply.block, 1);
    // The worker runs already, without this limit.
    call.request_size = SIZE;
    assert_int_equal(setrlimit(RLIMIT_AS, &limit), 0);
    reply = worker_process_call(&process, &call);
    setrlimit(RLIMIT_AS, &before);
    free(bytes);
    assert_int_equal(reply.end, WORKER_CUT_OFF);
    const AssetFailure failure = {.reply = &reply, .no_process = "%s", .crash = "%s"};
    Error error = {0};
    assert_false(asset_failure_set(&failure, &error));
    assert_int_equal(error.status, STATUS_FAILED);
    assert_string_equal(error.message, "Cannot allocate memory");
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
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

/** Skips a test where the system filters no system calls. */
static void require_filter(void) {
    if (worker_process_was_unfiltered()) {
        skip();
    }
}

/** Tries something in a worker. @return The reply. @param[out] report 0: it worked; else errno. */
static WorkerReply attempt(Attempt what, int *report) {
    *report = -2;
    WorkerCall call = call_of("try", &what, sizeof what, 10, report);
    const char byte = SENT_BYTE;
    call.file = memfd_create("sent", MFD_CLOEXEC);
    assert_true(call.file >= 0);
    assert_int_equal(write(call.file, &byte, 1), 1);
    WorkerReply reply = worker_process_call_once(&call);
    close(call.file);
    return reply;
}

/** A worker that reads a stranger's bytes reaches nothing but its memory, its file, its socket. */
static void test_sandbox(void **state) {
    (void)state;
    int report;
    for (Attempt what = TRY_ERROR_COUNT + 1; what < TRY_COUNT; what++) {
        assert_int_equal(attempt(what, &report).end, WORKER_FINISHED);
        assert_int_equal(report, 0);
    }
    require_filter();
    for (Attempt what = 0; what < TRY_KILL_COUNT; what++) {
        WorkerReply reply = attempt(what, &report);
        assert_int_equal(reply.end, WORKER_CRASHED);
        assert_int_equal(reply.detail, SIGSYS);
        assert_true(reply.is_ready);
    }
    for (Attempt what = TRY_KILL_COUNT + 1; what < TRY_ERROR_COUNT; what++) {
        assert_int_equal(attempt(what, &report).end, WORKER_FINISHED);
        assert_true(report == EACCES || report == ENOSYS || report == EPERM || report == ENOMEM ||
                    (what == TRY_THREAD && report == EAGAIN));
    }
    assert_int_not_equal(access("/tmp/dioptre-owned", F_OK), 0);
}

#ifdef __SANITIZE_ADDRESS__
/** Before a thread starts, the sanitizer asks for memory, and ends where the limits refuse it.
 *  @return Whether no thread can be started: the release build tries it. */
static bool is_thread_refused(void) {
    return true;
}
#else
/** @return Whether no thread can be started. */
static bool is_thread_refused(void) {
    pthread_t thread;
    return pthread_create(&thread, NULL, run_nothing, NULL) == EAGAIN;
}
#endif

/** Tries to start a process and a thread within the limits. @return 0: neither could be started. */
static int start_within_limits(void) {
    worker_sandbox_limit(ATTEMPT_MEMORY, HUGE_VAL);
    pid_t child = fork();
    if (child >= 0) {
        return 1; // In both processes.
    }
    bool is_refused = errno == EAGAIN;
    return is_refused && is_thread_refused() ? 0 : 2;
}

/** Without a filter, too, a worker starts neither a process nor a thread; but for root's. */
static void test_limit_of_processes(void **state) {
    (void)state;
    enum { NOBODY = 65534, IS_ROOT = 77 };
    int status;
    pid_t child = fork();
    if (child == 0) {
        // The system never limits root. In a namespace of users, nobody may be unknown.
        if (getuid() == 0 && setresuid(NOBODY, NOBODY, NOBODY) != 0) {
            _exit(IS_ROOT);
        }
        _exit(start_within_limits());
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    if (WEXITSTATUS(status) == IS_ROOT) {
        skip();
    }
    assert_int_equal(WEXITSTATUS(status), 0);
}

/** Files, descriptors and processor time are limited. */
static void test_limits(void **state) {
    (void)state;
    rlim_t limits[LIMIT_COUNT] = {[LIMIT_COUNT - 1] = 1};
    WorkerCall call = call_of("limits", NULL, 0, 7, NULL);
    call.report = limits;
    call.report_capacity = sizeof limits;
    assert_int_equal(worker_process_call_once(&call).end, WORKER_FINISHED);
    assert_int_equal(limits[0], 0);
    assert_in_range(limits[1], 4, 64);
    assert_in_range(limits[2], 7, 9);
    assert_int_equal(limits[3], 0);
    int report;
    call = call_of("sandboxed spin", NULL, 0, 0.1, &report);
    assert_int_equal(worker_process_call_once(&call).end, WORKER_TIMED_OUT);
}

/** A worker that never stops talking, or says what is no message, is ended. */
static void test_floods(void **state) {
    (void)state;
    static const struct {
        int kind;      /**< Kind of the frames. */
        WorkerEnd end; /**< How the call ends. */
    } floods[] = {{WORKER_FRAME_READY, WORKER_CRASHED},
                  {WORKER_FRAME_PROGRESS, WORKER_TIMED_OUT},
                  {WORKER_FRAME_UNFILTERED, WORKER_TIMED_OUT},
                  {WORKER_FRAME_REPORT, WORKER_TIMED_OUT},
                  {WORKER_FRAME_QUESTION, WORKER_CRASHED},
                  {-1, WORKER_CRASHED},
                  {99, WORKER_CRASHED}};
    for (size_t i = 0; i < sizeof floods / sizeof *floods; i++) {
        int report;
        WorkerCall call = call_of("flood", &floods[i].kind, sizeof floods[i].kind, 0.3, &report);
        assert_int_equal(worker_process_call_once(&call).end, floods[i].end);
    }
}

/** Answers `A` with a file of which the first byte is read. See #WorkerCall.answer. */
static bool answer_with_file(void *context, const void *question, size_t size,
                             WorkerResponse *response) {
    int *count = context;
    ++*count;
    response->bytes = "A";
    response->size = 1;
    response->file = open("/proc/self/status", O_RDONLY | O_CLOEXEC);
    return size == 1 && *(const char *)question == 'q';
}

/** @return The lowest free descriptor, which shows whether any was left open. */
static int next_descriptor(void) {
    int file = dup(STDERR_FILENO);
    close(file);
    return file;
}

/** A question is answered with bytes and a file; one that is not valid ends the worker. */
static void test_questions(void **state) {
    (void)state;
    size_t sizes[] = {1, 2, WORKER_QUESTION_MAXIMUM + 1};
    int count = 0, report = 0, first = next_descriptor();
    for (size_t i = 0; i < 3; i++) {
        WorkerCall call = call_of("ask", &sizes[i], sizeof *sizes, 10, &report);
        call.answer = answer_with_file;
        call.answer_context = &count;
        WorkerReply reply = worker_process_call_once(&call);
        assert_int_equal(reply.end, i == 0 ? WORKER_FINISHED : WORKER_CRASHED);
        assert_int_equal(report, 'A' * 256 + 'N'); // Name: ...
    }
    assert_int_equal(count, 2);
    assert_int_equal(next_descriptor(), first);
}

/** Answers nothing. See #WorkerCall.answer. */
static bool answer_nothing(void *context, const void *question, size_t size,
                           WorkerResponse *response) {
    (void)context, (void)question, (void)size, (void)response;
    return true;
}

/** A worker that asks and does not read the answers is ended, and holds up nobody. */
static void test_deaf_worker(void **state) {
    (void)state;
    int report;
    WorkerCall call = call_of("deaf", NULL, 0, 60, &report);
    call.wall_limit = 0.3;
    call.answer = answer_nothing;
    WorkerReply reply = worker_process_call_once(&call);
    assert_int_equal(reply.end, WORKER_TIMED_OUT);
    assert_true(reply.is_stalled);
}

/** A worker that dies before it is ready is told from one that a file brings down. */
static void test_early_end(void **state) {
    (void)state;
    char reason[WORKER_REASON_SIZE];
    int report, signal_number = SIGSEGV;
    WorkerCall call = call_of("early", NULL, 0, 10, &report);
    WorkerReply reply = worker_process_call_once(&call);
    assert_true(worker_reply_start_failure(&reply, reason));
    assert_non_null(strstr(reason, "Aborted"));
    call.program = "/none";
    reply = worker_process_call_once(&call);
    assert_true(worker_reply_start_failure(&reply, reason));
    assert_non_null(strstr(reason, "No such file"));
    call = call_of("abort", &signal_number, sizeof signal_number, 10, &report);
    reply = worker_process_call_once(&call);
    assert_false(worker_reply_start_failure(&reply, reason));
}

/** The error of a report ends, and has a status that workers have. */
static void test_reported_error(void **state) {
    (void)state;
    Error reported, error;
    memset(&reported, 'x', sizeof reported);
    assert_false(worker_error_set(&error, &reported));
    assert_int_equal(error.status, STATUS_SCENE);
    assert_int_equal(strlen(error.message), ERROR_MESSAGE_SIZE - 1);
    reported.status = STATUS_FAILED;
    worker_error_set(&error, &reported);
    assert_int_equal(error.status, STATUS_FAILED);
}

/**
 * Runs a program under a filter that refuses filters, as an old kernel or a container does.
 * @return Only if it fails: the exit status.
 */
static int run_without_filter(char **words) {
    if (refuse_call(SYS_seccomp)) {
        execvp(words[0], words);
    }
    return EXIT_FAILURE;
}

/** @return 0 if all tests pass. `--without-filter PROGRAM...` runs a program, for scripts. */
int main(int argc, char **argv) {
    const struct CMUnitTest tests_of_workers[] = {
        cmocka_unit_test(test_ends),
        cmocka_unit_test(test_processor_time),
        cmocka_unit_test(test_kept_worker),
        cmocka_unit_test(test_worker_dies_with_its_parent),
        cmocka_unit_test(test_sandbox),
        cmocka_unit_test(test_limits),
        cmocka_unit_test(test_floods),
        cmocka_unit_test(test_questions),
        cmocka_unit_test(test_early_end),
        cmocka_unit_test(test_reported_error),
        cmocka_unit_test(test_deaf_worker),
        cmocka_unit_test(test_limit_of_processes),
        cmocka_unit_test(test_no_memory_for_the_result),
    };
    if (worker_is_requested(argc, argv)) {
        worker_main(argv, tasks);
    }
    if (argc > 2 && strcmp(argv[1], "--without-filter") == 0) {
        return run_without_filter(argv + 2);
    }
    return cmocka_run_group_tests_name("worker", tests_of_workers, NULL, NULL);
}
