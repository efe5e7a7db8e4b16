/**
 * @file
 * @brief What the system takes from a worker process before it reads a stranger's bytes.
 */
#include "assets/process/worker_sandbox.h"

#include "assets/process/worker_protocol.h"

#include <fcntl.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

// --- the start -----------------------------------------------------------------------------------

/** Descriptors that an old kernel, which cannot close a range, closes one by one. */
enum { DESCRIPTORS_CLOSED_ONE_BY_ONE = 1024 };

/** Descriptor of /proc/self/statm, the use of memory; -1: none. */
static int memory_use_file = -1;

/** Closes all descriptors after the socket: a shell may have left some open. */
static void close_inherited(void) {
    const unsigned first = WORKER_SOCKET + 1;
#ifdef SYS_close_range
    if (syscall(SYS_close_range, first, ~0U, 0) == 0) {
        return;
    }
#endif
    for (int file = (int)first; file < DESCRIPTORS_CLOSED_ONE_BY_ONE; file++) {
        close(file);
    }
}

void worker_sandbox_prepare(void) {
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    close_inherited();
    int null_device = open("/dev/null", O_RDWR | O_CLOEXEC);
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; stream++) {
        if (null_device < 0 || dup2(null_device, stream) < 0) {
            close(stream);
        }
    }
    if (null_device > STDERR_FILENO) {
        close(null_device);
    }
    memory_use_file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
}

// --- limits --------------------------------------------------------------------------------------

/** Largest number of descriptors: a worker has the socket, three streams and a file or two. */
static const rlim_t DESCRIPTORS_MAXIMUM = 32;
/** Largest memory of any request, bytes: a picture of 16384 x 16384 floats, encoded. */
static const size_t MEMORY_MAXIMUM = (size_t)16 << 30;
/** Largest result in memory that the limit of data does not count, bytes; see #MESH_CAPACITY. */
static const size_t RESULT_MAXIMUM = (size_t)4 << 30;

/** Use of memory, bytes. */
typedef struct MemoryUse {
    size_t addresses; /**< Size of all mappings. */
    size_t data;      /**< Size of the private ones that can be written. */
} MemoryUse;

/** @return Memory that this process uses; zero if it is unknown. */
static MemoryUse memory_use(void) {
    char text[256];
    unsigned long all = 0, data = 0;
    size_t page = (size_t)sysconf(_SC_PAGESIZE);
    ssize_t length = memory_use_file < 0 ? -1 : pread(memory_use_file, text, sizeof text - 1, 0);
    if (length > 0) {
        text[length] = '\0';
        length = sscanf(text, "%lu %*s %*s %*s %*s %lu", &all, &data);
    }
    return length == 2 ? (MemoryUse){all * page, data * page} : (MemoryUse){0, 0};
}

/** Sets a soft limit, below a hard one that is lowered to a maximum. */
static void set_limit(__rlimit_resource_t resource, rlim_t wanted, rlim_t maximum) {
    struct rlimit limit;
    if (getrlimit(resource, &limit) == 0) {
        limit.rlim_max = maximum < limit.rlim_max ? maximum : limit.rlim_max;
        limit.rlim_cur = wanted < limit.rlim_max ? wanted : limit.rlim_max;
        setrlimit(resource, &limit);
    }
}

void worker_sandbox_limit(size_t bytes, double seconds) {
    struct timespec used = {0};
    const MemoryUse memory = memory_use();
    size_t more = bytes < MEMORY_MAXIMUM ? bytes : MEMORY_MAXIMUM;
    // Only soft limits of memory and time, which the next request can raise again.
    set_limit(RLIMIT_DATA, memory.data + more, RLIM_INFINITY);
    set_limit(RLIMIT_AS, memory.addresses + more + RESULT_MAXIMUM, RLIM_INFINITY);
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    double end = (double)used.tv_sec + 1 + ceil(seconds);
    set_limit(RLIMIT_CPU, end < (double)INT32_MAX ? (rlim_t)end : RLIM_INFINITY, RLIM_INFINITY);
    set_limit(RLIMIT_FSIZE, 0, 0);
    set_limit(RLIMIT_NOFILE, DESCRIPTORS_MAXIMUM, DESCRIPTORS_MAXIMUM);
    // The system compares all processes and threads of the user with it: this process can start
    // none, neither a thread nor a process, and nobody else is concerned. Root is never counted.
    set_limit(RLIMIT_NPROC, 0, 0);
}
