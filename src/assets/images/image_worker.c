/**
 * @file
 * @brief Reads pictures in a worker process.
 */
#include "assets/images/image_worker.h"

#include "assets/process/worker_process.h"

#include <libintl.h>
#include <pthread.h>
#include <signal.h>
#include <string.h>
#include <sys/mman.h>

/** Request for a picture. The file comes with it. */
typedef struct ImageWorkerRequest {
    char format[32];        /**< The format, as OpenImageIO names it. */
    ImageReadLimits limits; /**< The limits. */
} ImageWorkerRequest;

/** Report on a picture. */
typedef struct ImageWorkerReport {
    bool is_done; /**< Whether the block is a texture. */
    Error error;  /**< What is wrong, if it is not. */
} ImageWorkerReport;

// --- in the program ------------------------------------------------------------------------------

/** The worker that is kept from picture to picture, as a module that was opened would be. */
static struct {
    pthread_mutex_t mutex; /**< Held during a call. */
    WorkerProcess process; /**< The worker, if one runs. */
} kept = {.mutex = PTHREAD_MUTEX_INITIALIZER};

/** Sends a request to the kept worker. @return The answer. */
static WorkerReply call_kept_worker(const WorkerCall *call) {
    pthread_mutex_lock(&kept.mutex);
    WorkerReply reply = worker_process_call(&kept.process, call);
    const ImageWorkerReport *report = call->report;
    if (reply.end == WORKER_FINISHED && !report->is_done) {
        worker_process_stop(&kept.process); // A bad file may have left anything in it.
    }
    pthread_mutex_unlock(&kept.mutex);
    return reply;
}

/** Sets the error of a worker without a picture. @return false, always. */
static bool set_failure(const WorkerReply *reply, const ImageWorkerReport *report,
                        const ImageReadLimits *limits, Error *error) {
    if (reply->end == WORKER_NOT_STARTED) {
        return error_set(error, STATUS_FAILED, "no process to read a picture in: %s",
                         error_errno_text(reply->detail));
    }
    if (reply->end == WORKER_TIMED_OUT) {
        return error_set(error, STATUS_SCENE, "it takes more than %.0f s to read",
                         limits->time_limit);
    }
    if (reply->end == WORKER_CRASHED && reply->detail == SIGINT) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    if (reply->end == WORKER_FINISHED && report->error.status != STATUS_OK) {
        return error_set(error, report->error.status, "%.*s", ERROR_MESSAGE_SIZE - 1,
                         report->error.message);
    }
    return error_set(error, STATUS_SCENE, "it makes the libraries that read it crash (%s)",
                     reply->detail ? strsignal(reply->detail) : gettext("it ended early"));
}

/** Checks a texture from a worker: the file may have taken control of it. @param size Bytes of the
 *  block that it lies in. @return Whether it is a texture. */
static bool validate_texture(Texture *texture, size_t size, Error *error) {
    bool has_size = size >= sizeof *texture && texture->width >= 1 &&
                    texture->width <= IMAGE_SIZE_MAXIMUM && texture->height >= 1 &&
                    texture->height <= IMAGE_SIZE_MAXIMUM;
    if (!has_size || texture_block_size(texture) != size) {
        return error_set(error, STATUS_SCENE, "it makes the libraries that read it go astray");
    }
    atomic_store(&texture->reference_count, 1);
    texture_sanitize(texture);
    return true;
}

bool image_worker_call(const ImageWorker *worker, const char *format, int file,
                       const ImageReadLimits *limits, Texture **texture, Error *error) {
    ImageWorkerRequest request = {.limits = *limits};
    ImageWorkerReport report = {0};
    strncpy(request.format, format, sizeof request.format - 1);
    const WorkerCall call = {.program = worker ? worker->program : NULL,
                             .task = worker ? worker->task : IMAGE_WORKER_TASK,
                             .request = &request,
                             .request_size = sizeof request,
                             .file = file,
                             .time_limit = limits->time_limit,
                             .report = &report,
                             .report_capacity = sizeof report,
                             .block_capacity = limits->texture_capacity};
    WorkerReply reply = worker ? worker_process_call_once(&call) : call_kept_worker(&call);
    bool is_read = reply.end == WORKER_FINISHED && report.is_done
                       ? validate_texture(reply.block, reply.block_size, error)
                       : set_failure(&reply, &report, limits, error);
    if (!is_read && reply.block) {
        munmap(reply.block, reply.block_size);
    }
    *texture = is_read ? reply.block : NULL;
    return is_read;
}

// --- in the worker -------------------------------------------------------------------------------

/** Reads the picture of a request. @return Whether it was read. */
static bool read_texture(WorkerJob *job, const ImagePlugin *plugin, Error *error) {
    const ImageWorkerRequest *request = job->request;
    size_t capacity = request->limits.texture_capacity;
    char path[sizeof "/proc/self/fd/-2147483648"];
    snprintf(path, sizeof path, "/proc/self/fd/%d", job->file);
    // Shared, so that the limit of data does not count it.
    Texture *texture = mmap(NULL, capacity, PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (texture == MAP_FAILED) {
        return error_set(error, STATUS_FAILED, "no memory for a picture");
    }
    const ImageReadRequest read = {plugin, request->format, path, capacity};
    job->block = texture;
    job->block_capacity = capacity;
    if (!image_plugin_read(&read, texture, error)) {
        return false;
    }
    job->block_size = texture_block_size(texture);
    return true;
}

/** Prepares the report of a job. @return The report, empty. */
static ImageWorkerReport *prepare_report(WorkerJob *job) {
    static ImageWorkerReport report;
    report = (ImageWorkerReport){0};
    job->report = &report;
    job->report_size = sizeof report;
    return &report;
}

void image_worker_read_with(WorkerJob *job, const ImagePlugin *plugin) {
    const ImageWorkerRequest *request = job->request;
    ImageWorkerReport *report = prepare_report(job);
    worker_job_ready();
    worker_enter_sandbox(request->limits.memory_limit);
    report->is_done = read_texture(job, plugin, &report->error);
}

void image_worker_read(WorkerJob *job) {
    ImageWorkerReport *report = prepare_report(job);
    const ImagePlugin *plugin = image_plugin_load(&report->error);
    if (plugin) {
        image_worker_read_with(job, plugin);
    }
}
