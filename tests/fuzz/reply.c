/**
 * @file
 * @brief Fuzz target: messages of a worker on its socket, which may be anything.
 *
 * The target is linked with `--wrap` (see the Makefile): no process is started, and the worker's
 * end of the sockets is filled with the input.
 */
#include "fuzz.h"

#include "assets/process/worker_process.h"

#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

/** Memory for the report of a call, bytes. */
enum { REPORT_CAPACITY = 64 };
/** Largest block of a call, bytes. */
enum { BLOCK_CAPACITY = 1 << 16 };
/** The process id of the worker that is not there: above all ids of Linux (2^22). Much larger ones
 * lose their bits in the id of a processor clock, which then is that of this process. */
enum { WORKER_ID = 1 << 23 };

/** The input of the run. */
static FuzzInput input;
/** The worker's end of the sockets. */
static int worker_socket = -1;

// What the linker's --wrap calls in place of the functions, and one of the functions itself.
int __real_posix_spawn_file_actions_adddup2(posix_spawn_file_actions_t *actions, int from, int to);
int __wrap_posix_spawn_file_actions_adddup2(posix_spawn_file_actions_t *actions, int from, int to);
int __wrap_posix_spawn(pid_t *pid, const char *path, const posix_spawn_file_actions_t *actions,
                       const posix_spawnattr_t *attributes, char *const *arguments,
                       char *const *environment);
int __wrap_kill(pid_t pid, int number);
pid_t __wrap_waitpid(pid_t pid, int *status, int options);

/** Notes the worker's end of the sockets. */
int __wrap_posix_spawn_file_actions_adddup2(posix_spawn_file_actions_t *actions, int from, int to) {
    worker_socket = worker_socket < 0 ? dup(from) : worker_socket;
    return __real_posix_spawn_file_actions_adddup2(actions, from, to);
}

/** Sends the input instead of starting a worker. */
int __wrap_posix_spawn(pid_t *pid, const char *path, const posix_spawn_file_actions_t *actions,
                       const posix_spawnattr_t *attributes, char *const *arguments,
                       char *const *environment) {
    (void)path, (void)actions, (void)attributes, (void)arguments, (void)environment;
    *pid = WORKER_ID;
    // Inputs are smaller than the buffer of the sockets.
    send(worker_socket, input.next, input.size, MSG_NOSIGNAL | MSG_DONTWAIT);
    shutdown(worker_socket, SHUT_WR);
    return 0;
}

/** Kills nothing. */
int __wrap_kill(pid_t pid, int number) {
    (void)number;
    FUZZ_REQUIRE(pid == WORKER_ID);
    return 0;
}

/** Reports that the worker has exited. */
pid_t __wrap_waitpid(pid_t pid, int *status, int options) {
    (void)options;
    FUZZ_REQUIRE(pid == WORKER_ID);
    *status = 0;
    return pid;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static char own_block[BLOCK_CAPACITY];
    char *report = calloc(1, REPORT_CAPACITY);
    input = (FuzzInput){data, size};
    bool has_block = fuzz_take_byte(&input) % 2;
    FUZZ_REQUIRE(report);
    WorkerReply reply =
        worker_process_call_once(&(WorkerCall){.program = "fuzz",
                                               .task = "fuzz",
                                               .request = "",
                                               .time_limit = 60,
                                               .report = report,
                                               .report_capacity = REPORT_CAPACITY,
                                               .block = has_block ? own_block : NULL,
                                               .block_capacity = BLOCK_CAPACITY});
    FUZZ_REQUIRE(reply.end == WORKER_FINISHED || (reply.end == WORKER_EXITED && !reply.block));
    FUZZ_REQUIRE(reply.block_size <= BLOCK_CAPACITY);
    FUZZ_REQUIRE(!reply.block || reply.block_size > 0);
    if (reply.block && !has_block) {
        munmap(reply.block, reply.block_size);
    }
    free(report);
    close(worker_socket);
    worker_socket = -1;
    return 0;
}
