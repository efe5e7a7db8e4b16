/**
 * @file
 * @brief Reading and encoding of pictures in a worker process.
 */
#include "assets/images/image_worker.h"

#include "assets/asset_failure.h"
#include "base/language.h"
#include "base/untrusted.h"

#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

/** Operations of the picture module. */
typedef enum {
    IMAGE_CHECK, /**< Checks that it is installed. */
    IMAGE_READ,  /**< Reads the file of the request as a texture. */
    IMAGE_ENCODE /**< Encodes the pixels that follow. */
} ImageOperation;

/** Request to the picture module. */
typedef struct ImageWorkerRequest {
    ImageOperation operation; /**< Operation. */
    char format[32];          /**< Name of the format in OpenImageIO. */
    ImageReadLimits limits;   /**< Limits of reading. */
    int width;                /**< Width of the picture to encode, pixels. */
    int height;               /**< Height of the picture to encode, pixels. */
    bool is_linear; /**< Whether floats of linear light follow; else 8-bit codes. Names and values
                       of the metadata come after them, each ended by a zero byte. */
    size_t metadata_count; /**< Number of metadata entries. */
} ImageWorkerRequest;

/** @return Bytes of the pixels after a request. */
static size_t pixels_size(const ImageWorkerRequest *request) {
    return (size_t)request->width * (size_t)request->height * TEXEL_CHANNELS *
           (request->is_linear ? sizeof(float) : sizeof(uint8_t));
}

/** Report on a picture. */
typedef struct ImageWorkerReport {
    int is_done; /**< Not 0: the block contains the result. No bool, which may hold any byte here.
                  */
    Error error; /**< What is wrong, without a result. */
} ImageWorkerReport;

// --- in the program ------------------------------------------------------------------------------

/** The worker process, kept for the next picture, because its libraries take long to load. */
static struct {
    pthread_mutex_t mutex; /**< Held during a call. */
    WorkerProcess process; /**< The worker, if one runs. */
} kept = {.mutex = PTHREAD_MUTEX_INITIALIZER};

/** Sends a request to the kept worker. @return The reply. */
static WorkerReply call_kept_worker(const WorkerCall *call) {
    pthread_mutex_lock(&kept.mutex);
    WorkerReply reply = worker_process_call(&kept.process, call);
    const ImageWorkerReport *report = call->report;
    if (reply.end == WORKER_FINISHED && !report->is_done) {
        worker_process_stop(&kept.process); // A malicious file may have changed its memory.
    }
    pthread_mutex_unlock(&kept.mutex);
    return reply;
}

/** Sets the error of a worker without a picture. @return false, always. */
static bool set_failure(const WorkerReply *reply, const ImageWorkerReport *report,
                        const ImageReadLimits *limits, Error *error) {
    const AssetFailure failure = {.reply = reply,
                                  .reported = &report->error,
                                  .time_limit = limits->time_limit,
                                  .is_time_shared = limits->is_time_shared,
                                  .no_process = N_("no process for pictures: %s"),
                                  .crash = N_("it makes the libraries that read it crash (%s)")};
    return asset_failure_set(&failure, error);
}

/**
 * Checks a texture from a worker, which a malicious file may control.
 * @param texture     The texture.
 * @param size        Bytes of its block.
 * @param[out] error  What is wrong.
 * @return Whether it is valid.
 */
static bool validate_texture(Texture *texture, size_t size, Error *error) {
    bool has_size = size >= sizeof *texture && untrusted_is_bool(&texture->is_hdr) &&
                    untrusted_is_bool(&texture->is_damaged) && texture->width >= 1 &&
                    texture->width <= IMAGE_SIZE_MAXIMUM && texture->height >= 1 &&
                    texture->height <= IMAGE_SIZE_MAXIMUM;
    if (!has_size || texture_block_size(texture) != size) {
        return error_set(error, STATUS_SCENE, "it makes the libraries that read it go astray");
    }
    atomic_store(&texture->reference_count, 1);
    texture_sanitize(texture);
    return true;
}

/** @return Limits of reading a picture, with what a scene has left. */
static ImageReadLimits limits_within(const ImageReadLimits *limits, const AssetBudget *budget) {
    ImageReadLimits result = *limits;
    if (budget && budget->seconds < limits->time_limit) {
        result.time_limit = fmax(budget->seconds, 0);
        result.is_time_shared = true;
    }
    if (budget && budget->memory < limits->texture_capacity) {
        result.texture_capacity = budget->memory > 0 ? budget->memory : 1;
        result.is_memory_shared = true;
    }
    return result;
}

bool image_worker_call(const ImageWorker *worker, const ImageSource *source,
                       const ImageReadLimits *limits, AssetBudget *budget, Texture **texture,
                       Error *error) {
    const ImageReadLimits left = limits_within(limits, budget);
    ImageWorkerRequest request = {.operation = IMAGE_READ, .limits = left};
    ImageWorkerReport report = {0};
    strncpy(request.format, source->format, sizeof request.format - 1);
    const WorkerCall call = {.program = worker ? worker->program : NULL,
                             .task = worker ? worker->task : IMAGE_WORKER_TASK,
                             .request = &request,
                             .request_size = sizeof request,
                             .file = source->file,
                             .time_limit = left.time_limit,
                             .report = &report,
                             .report_capacity = sizeof report,
                             .block_capacity = left.texture_capacity};
    WorkerReply reply = worker ? worker_process_call_once(&call) : call_kept_worker(&call);
    if (budget) {
        asset_budget_take_seconds(budget, reply.seconds);
    }
    bool is_read = reply.end == WORKER_FINISHED && report.is_done
                       ? validate_texture(reply.block, reply.block_size, error)
                       : set_failure(&reply, &report, &left, error);
    is_read = is_read && (!budget || asset_budget_take_memory(budget, reply.block_size, error));
    if (!is_read && reply.block) {
        munmap(reply.block, reply.block_size);
    }
    *texture = is_read ? reply.block : NULL;
    return is_read;
}

/** Largest number of workers that signals may end before one of them replies. */
enum { START_ATTEMPTS = 3 };

/** Sends a request without limits to the kept worker. @return Whether it succeeded. */
static bool call_unlimited(const ImageWorkerRequest *request, size_t size, WorkerReply *reply,
                           Error *error) {
    ImageWorkerReport report = {0};
    int attempts = 0;
    // The signal that interrupts a rendering ends the idle worker, too, sooner or later.
    do {
        *reply = call_kept_worker(&(WorkerCall){.task = IMAGE_WORKER_TASK,
                                                .request = request,
                                                .request_size = size,
                                                .time_limit = HUGE_VAL,
                                                .report = &report,
                                                .report_capacity = sizeof report,
                                                .block_capacity = SIZE_MAX});
    } while (worker_reply_is_interrupted(reply) && ++attempts < START_ATTEMPTS);
    bool is_done = reply->end == WORKER_FINISHED && report.is_done;
    return is_done || set_failure(reply, &report, &request->limits, error);
}

bool image_worker_check(Error *error) {
    const ImageWorkerRequest request = {.operation = IMAGE_CHECK};
    WorkerReply reply;
    return call_unlimited(&request, sizeof request, &reply, error);
}

/**
 * @return Bytes of the metadata of a picture.
 * @param metadata    The metadata.
 * @param[out] count  Number of entries.
 */
static size_t metadata_size(const MetadataEntry *metadata, size_t *count) {
    size_t size = 0;
    for (*count = 0; metadata && metadata[*count].name; (*count)++) {
        size += strlen(metadata[*count].name) + strlen(metadata[*count].value) + 2;
    }
    return size;
}

/**
 * Packs a request to encode.
 * @param format     Name of the format in OpenImageIO.
 * @param picture    The picture.
 * @param linear     Its linear light; NULL: its 8-bit codes are sent.
 * @param[out] size  Bytes of the request.
 * @return The request, to be freed with `free`; NULL without memory.
 */
static ImageWorkerRequest *pack_picture(const char *format, const Picture *picture,
                                        const float *linear, size_t *size) {
    ImageWorkerRequest head = {.operation = IMAGE_ENCODE,
                               .width = picture->width,
                               .height = picture->height,
                               .is_linear = linear};
    strncpy(head.format, format, sizeof head.format - 1);
    *size =
        sizeof head + pixels_size(&head) + metadata_size(picture->metadata, &head.metadata_count);
    ImageWorkerRequest *request = malloc(*size);
    if (request) {
        *request = head;
        char *next = mempcpy(request + 1, linear ? (const void *)linear : picture->pixels,
                             pixels_size(&head));
        for (size_t i = 0; i < head.metadata_count; i++) {
            next = stpcpy(next, picture->metadata[i].name) + 1;
            next = stpcpy(next, picture->metadata[i].value) + 1;
        }
    }
    return request;
}

bool image_worker_write(const char *format, bool is_linear, const Picture *picture, FILE *stream,
                        Error *error) {
    WorkerReply reply = {0};
    size_t size;
    float *decoded = is_linear && !picture->linear ? image_plugin_decode(picture) : NULL;
    const float *linear = !is_linear ? NULL : decoded ? decoded : picture->linear;
    bool has_memory = linear || !is_linear;
    ImageWorkerRequest *request = has_memory ? pack_picture(format, picture, linear, &size) : NULL;
    bool is_written = request ? call_unlimited(request, size, &reply, error)
                              : error_set(error, STATUS_FAILED, "no memory");
    free(decoded);
    free(request);
    if (is_written && reply.block_size == 0) {
        is_written = error_set(error, STATUS_FAILED, "the picture module made an empty file");
    } else if (is_written) {
        is_written = fwrite(reply.block, 1, reply.block_size, stream) == reply.block_size ||
                     error_set(error, STATUS_FAILED, "%s", error_errno_text(errno));
    }
    if (reply.block) {
        munmap(reply.block, reply.block_size);
    }
    return is_written;
}

// --- in the worker -------------------------------------------------------------------------------

/** Least memory for a picture, bytes; with less, none is read. */
static const size_t TEXTURE_CAPACITY_MINIMUM = (size_t)1 << 20;

/**
 * Reserves memory for a picture whose size is not known yet.
 * @param[in,out] capacity  Its bytes; fewer where addresses are limited.
 * @return The memory; NULL: there is none.
 */
static Texture *map_texture(size_t *capacity) {
    size_t minimum = *capacity < TEXTURE_CAPACITY_MINIMUM ? *capacity : TEXTURE_CAPACITY_MINIMUM;
    for (; *capacity >= minimum; *capacity /= 2) {
        // A shared mapping, which the limit of data does not count.
        void *memory = mmap(NULL, *capacity, PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (memory != MAP_FAILED) {
            return memory;
        }
    }
    return NULL;
}

/** Reads the picture of a request. @return Whether it was read. */
static bool read_texture(WorkerJob *job, const ImagePlugin *plugin, Error *error) {
    const ImageWorkerRequest *request = job->request;
    size_t capacity = request->limits.texture_capacity;
    Texture *texture = map_texture(&capacity);
    if (!texture) {
        return error_set(error, STATUS_FAILED, "no memory for a picture");
    }
    const ImageReadRequest read = {plugin, request->format, job->file, capacity,
                                   request->limits.is_memory_shared};
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

/**
 * Unpacks the metadata of a request.
 * @return Entries, ended by one without a name; to be freed with `free`.
 */
static MetadataEntry *unpack_metadata(const ImageWorkerRequest *request) {
    const char *next = (const char *)(request + 1) + pixels_size(request);
    MetadataEntry *metadata = calloc(request->metadata_count + 1, sizeof *metadata);
    for (size_t i = 0; metadata && i < request->metadata_count; i++) {
        metadata[i].name = next;
        next += strlen(next) + 1;
        metadata[i].value = next;
        next += strlen(next) + 1;
    }
    return metadata;
}

/**
 * Encodes the picture of a request. The next call frees the file.
 * @return Whether it was encoded.
 */
static bool encode_picture(WorkerJob *job, const ImagePlugin *plugin, Error *error) {
    static EncodedImage file;
    const ImageWorkerRequest *request = job->request;
    const void *pixels = request + 1;
    if (file.owner) {
        plugin->free_encoded(&file);
    }
    file = (EncodedImage){0};
    MetadataEntry *metadata = unpack_metadata(request);
    const ImagePluginSource source = {.width = request->width,
                                      .height = request->height,
                                      .encoded = request->is_linear ? NULL : pixels,
                                      .linear = request->is_linear ? pixels : NULL,
                                      .metadata = metadata};
    ImagePluginMessage message = {""};
    bool is_encoded = metadata && plugin->encode(request->format, &source, &file, &message);
    free(metadata);
    job->block = (void *)(uintptr_t)file.bytes;
    job->block_size = is_encoded ? file.size : 0;
    return is_encoded || error_set(error, STATUS_FAILED, "%s", message.text);
}

/**
 * Ignores the signals that end programs: the partial picture of an interrupted rendering is still
 * written. This process ends with its parent.
 */
static void ignore_interruption(void) {
    static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        signal(signals[i], SIG_IGN);
    }
}

void image_worker_run(WorkerJob *job) {
    // Loaded once: the filter of system calls of the first request stays.
    static const ImagePlugin *plugin;
    const ImageWorkerRequest *request = job->request;
    ImageWorkerReport *report = prepare_report(job);
    plugin = plugin ? plugin : image_plugin_load(&report->error);
    if (plugin && request->operation == IMAGE_READ) {
        image_worker_read_with(job, plugin);
    } else if (plugin && request->operation == IMAGE_ENCODE) {
        ignore_interruption();
        worker_job_ready();
        worker_enter_sandbox(SIZE_MAX / 2);
        report->is_done = encode_picture(job, plugin, &report->error);
    } else {
        report->is_done = plugin != NULL;
    }
}
