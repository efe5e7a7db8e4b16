/**
 * @file
 * @brief What the targets of hand-overs share: a worker that replies whatever the fuzzer wants.
 *
 * A worker reads files of strangers, so it may be theirs. The targets are linked with `--wrap`
 * (see the Makefile): no worker is started, and its reply comes from the input.
 */
#ifndef DIOPTRE_TESTS_FUZZ_HANDOVER_H
#define DIOPTRE_TESTS_FUZZ_HANDOVER_H

#include "fuzz.h"

#include "assets/process/worker_process.h"

/**
 * Fills the reply of a worker; defined by each target.
 * @param call       The call.
 * @param[out] size  Bytes of the block.
 * @return The bytes of the block; NULL: none. They are copied.
 */
const void *fuzz_reply(const WorkerCall *call, size_t *size);

/** Stands for a worker. See #worker_process_call_once. */
WorkerReply __wrap_worker_process_call_once(const WorkerCall *call);

/** Stands for a worker that is kept. See #worker_process_call. */
WorkerReply __wrap_worker_process_call(WorkerProcess *process, const WorkerCall *call);

#endif
