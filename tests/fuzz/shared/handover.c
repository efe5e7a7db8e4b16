/**
 * @file
 * @brief A worker that replies whatever the fuzzer wants.
 */
#include "shared/handover.h"

#include <sys/mman.h>

WorkerReply __wrap_worker_process_call_once(const WorkerCall *call) {
    WorkerReply reply = {.end = WORKER_FINISHED};
    size_t size = 0;
    const void *bytes = fuzz_reply(call, &size);
    if (bytes && size > 0 && size <= call->block_capacity) {
        reply.block = call->block ? call->block
                                  : mmap(NULL, size, PROT_READ | PROT_WRITE,
                                         MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        FUZZ_REQUIRE(reply.block != MAP_FAILED);
        reply.block_size = size;
        memcpy(reply.block, bytes, size);
    }
    return reply;
}

WorkerReply __wrap_worker_process_call(WorkerProcess *process, const WorkerCall *call) {
    (void)process;
    return __wrap_worker_process_call_once(call);
}
