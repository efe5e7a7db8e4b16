/**
 * @file
 * @brief Counters of a worker, which is killed, or ends without a return from main: they are
 * written before each reply. Part of `make coverage` only, where the linker's --wrap puts it in.
 */
#include "assets/process/worker_protocol.h"

#include <stdbool.h>
#include <sys/socket.h>
#include <sys/types.h>

// Of gcc's run time.
void __gcov_dump(void);
void __gcov_reset(void);
// What --wrap calls in place of the functions, and one of the functions itself.
ssize_t __real_send(int file, const void *bytes, size_t size, int flags);
ssize_t __wrap_send(int file, const void *bytes, size_t size, int flags);
bool __wrap_worker_filter_install(void);
void __wrap_worker_sandbox_limit(size_t bytes, double seconds);

/** Writes the counters before the header of a reply. See send. */
ssize_t __wrap_send(int file, const void *bytes, size_t size, int flags) {
    const WorkerFrame *frame = bytes;
    if (size == sizeof *frame &&
        (frame->kind == WORKER_FRAME_RESULT || frame->kind == WORKER_FRAME_REPORT)) {
        __gcov_dump();
        __gcov_reset();
    }
    return __real_send(file, bytes, size, flags);
}

/** Leaves out the filter of system calls, under which no counters can be written. */
bool __wrap_worker_filter_install(void) {
    return true;
}

/** Leaves out the limits, which count files that are written. */
void __wrap_worker_sandbox_limit(size_t bytes, double seconds) {
    (void)bytes, (void)seconds;
}
