/**
 * @file
 * @brief Reads and encodes pictures in a worker process: both ends of it.
 *
 * The libraries behind the picture module do not expect hostile files: a damaged or malicious one
 * can make them write beyond their memory (the JPEG reader of OpenImageIO 2.4 does so for
 * `bad-iptc.jpg` of its own test files) or never end. That stays in the worker.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_WORKER_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_WORKER_H

#include "assets/images/image_plugin_io.h"
#include "assets/process/worker_main.h"
#include "dioptre/scene.h"

/** Name of the task, see #WorkerTask. */
#define IMAGE_WORKER_TASK "picture"

/** Limits of reading a picture. */
typedef struct ImageReadLimits {
    double time_limit;       /**< Seconds. */
    size_t memory_limit;     /**< Bytes of data of the libraries. */
    size_t texture_capacity; /**< Bytes of the texture. */
} ImageReadLimits;

/** A program that reads pictures. */
typedef struct ImageWorker {
    const char *program; /**< See #WorkerCall.program. */
    const char *task;    /**< See #WorkerCall.task. */
} ImageWorker;

/**
 * Reads a picture as #image_plugin_read does, in a worker.
 * @param worker  Started for this picture; NULL: `dioptre-worker`, which is kept for the next
 *                picture, since its libraries take half a second to load.
 * @param format  The format, as OpenImageIO names it.
 * @param file    Descriptor of the file; 0: none, for tests.
 * @param[out] texture  The picture, sanitized, to be given back with #texture_release; NULL if
 *                      anything is wrong.
 * @param[out] error  What is wrong (#STATUS_SCENE; #STATUS_FAILED without module, memory or
 *                    process).
 * @return Whether it was read.
 */
bool image_worker_call(const ImageWorker *worker, const char *format, int file,
                       const ImageReadLimits *limits, Texture **texture, Error *error);

/** Checks, in the worker that is kept, that the picture module is there. @param[out] error What is
 *  missing and what to install (#STATUS_FAILED). @return Whether it is. */
bool image_worker_check(Error *error);

/**
 * Writes a picture in a format of the module; it is encoded in the worker that is kept. A format of
 * linear light (OpenEXR, Radiance) gets the picture's own, if it was kept, else the decoded steps.
 * @param format     The format, as OpenImageIO names it.
 * @param is_linear  Whether it holds linear light.
 * @param stream     Where to; need not be seekable.
 * @param[out] error  Why not (#STATUS_FAILED); the file is not named in it.
 * @return Whether all bytes were written to the stream.
 */
bool image_worker_write(const char *format, bool is_linear, const Picture *picture, FILE *stream,
                        Error *error);

/** Does what is asked of the picture module, in a worker. See #WorkerTask.run. */
void image_worker_run(WorkerJob *job);

/** Reads a picture with any module, in a worker: for tests. */
void image_worker_read_with(WorkerJob *job, const ImagePlugin *plugin);

#endif
