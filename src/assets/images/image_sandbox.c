/**
 * @file
 * @brief Reads pictures in a child process, out of harm's way.
 */
#include "assets/images/image_sandbox.h"

#include "assets/process/sandbox_process.h"

#include <libintl.h>
#include <signal.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

/** What child and parent share, but for the texture. */
typedef struct SharedResult {
    bool is_done; /**< Whether the child came to the end of its work. */
    Error error;  /**< What is wrong, if anything. */
} SharedResult;

/** What a child is asked. */
typedef struct ReadJob {
    ImageReadRequest request; /**< What to read. */
    size_t memory_limit;      /**< Bytes that the libraries may take. */
    SharedResult *result;     /**< What both share. */
    Texture *texture;         /**< Where the child leaves the picture; shared, too. */
} ReadJob;

/** Is the child: reads the picture. See #sandbox_process_run. */
static void read_in_sandbox(void *context) {
    const ReadJob *job = context;
    SharedResult *result = job->result;
    sandbox_process_enter(job->memory_limit);
    result->is_done = image_plugin_read(&job->request, job->texture, &result->error);
}

/**
 * Says why a child left no picture.
 * @param detail  The signal or the errno.
 * @param[out] error  Where it is said.
 * @return false, always.
 */
static bool set_failure(const SharedResult *result, SandboxProcessEnd end, int detail,
                        const ImageReadLimits *limits, Error *error) {
    if (end == SANDBOX_PROCESS_NOT_STARTED) {
        return error_set(error, STATUS_FAILED, "no process to read a picture in: %s",
                         error_errno_text(detail));
    }
    if (end == SANDBOX_PROCESS_TIMED_OUT) {
        return error_set(error, STATUS_SCENE, "it takes more than %.0f s to read",
                         limits->time_limit);
    }
    if (end == SANDBOX_PROCESS_CRASHED && detail == SIGINT) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    const Error *reported = &result->error;
    if (end == SANDBOX_PROCESS_EXITED && reported->status != STATUS_OK) {
        return error_set(error, reported->status, "%.*s", ERROR_MESSAGE_SIZE - 1,
                         reported->message);
    }
    return error_set(error, STATUS_SCENE, "it makes the libraries that read it crash (%s)",
                     detail ? strsignal(detail) : gettext("it ended early"));
}

/**
 * Makes a texture of what a child left, which may be anything if a file has got hold of it, and
 * gives the rest of the room back.
 * @param capacity  Bytes that it lies in.
 * @return Whether it is one.
 */
static bool validate_texture(Texture *texture, size_t capacity, Error *error) {
    bool has_size = texture->width >= 1 && texture->width <= IMAGE_SIZE_MAXIMUM &&
                    texture->height >= 1 && texture->height <= IMAGE_SIZE_MAXIMUM;
    if (!has_size || texture_block_size(texture) > capacity) {
        return error_set(error, STATUS_SCENE, "it makes the libraries that read it go astray");
    }
    size_t page = (size_t)sysconf(_SC_PAGESIZE);
    size_t kept = (texture_block_size(texture) + page - 1) / page * page;
    if (kept < capacity) {
        munmap((char *)texture + kept, capacity - kept);
    }
    atomic_store(&texture->reference_count, 1);
    texture_sanitize(texture);
    return true;
}

/** Asks a child. @return Whether the picture is there. */
static bool run_job(ReadJob *job, const ImageReadLimits *limits, Error *error) {
    int detail;
    SandboxProcessEnd end = sandbox_process_run(read_in_sandbox, job, limits->time_limit, &detail);
    bool is_good = end == SANDBOX_PROCESS_EXITED && job->result->is_done;
    return is_good ? validate_texture(job->texture, limits->texture_capacity, error)
                   : set_failure(job->result, end, detail, limits, error);
}

bool image_sandbox_read(const ImagePlugin *plugin, const char *format, const char *path,
                        const ImageReadLimits *limits, Texture **texture, Error *error) {
    ReadJob job = {.request = {plugin, format, path, limits->texture_capacity},
                   .memory_limit = limits->memory_limit};
    job.result = sandbox_process_share_memory(sizeof *job.result);
    job.texture = sandbox_process_share_memory(limits->texture_capacity);
    bool has_memory = job.result && job.texture;
    bool is_read = has_memory ? run_job(&job, limits, error)
                              : error_set(error, STATUS_FAILED, "no memory for a picture");
    if (job.texture && !is_read) {
        munmap(job.texture, limits->texture_capacity);
    }
    if (job.result) {
        munmap(job.result, sizeof *job.result);
    }
    *texture = is_read ? job.texture : NULL;
    return is_read;
}
