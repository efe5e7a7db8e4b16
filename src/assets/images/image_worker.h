/**
 * @file
 * @brief Reading and encoding of pictures in a worker process: both sides.
 *
 * The libraries of the picture module are not safe for malicious files. A file can make them write
 * outside their memory, as `bad-iptc.jpg` of OpenImageIO 2.4's own tests does, or loop forever.
 * Only the worker is affected.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_WORKER_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_WORKER_H

#include "assets/asset_budget.h"
#include "assets/images/image_plugin_io.h"
#include "assets/process/worker_main.h"
#include "dioptre/scene.h"

/** Name of the task, see #WorkerTask. */
#define IMAGE_WORKER_TASK "picture"

/** Limits of reading a picture. */
typedef struct ImageReadLimits {
    double time_limit;       /**< Limit of processor time, seconds. */
    size_t memory_limit;     /**< Limit of the data of the libraries, bytes. */
    size_t texture_capacity; /**< Largest size of the texture, bytes. */
    bool is_time_shared;     /**< Whether #time_limit is what the budget of a scene has left. */
    bool is_memory_shared;   /**< Whether #texture_capacity is. */
} ImageReadLimits;

/** A picture file to read. */
typedef struct ImageSource {
    const char *format; /**< Name of the format in OpenImageIO. */
    int file;           /**< Descriptor of the file; 0: none, for tests. */
} ImageSource;

/** A worker program that reads pictures. */
typedef struct ImageWorker {
    const char *program; /**< See #WorkerCall.program. */
    const char *task;    /**< See #WorkerCall.task. */
} ImageWorker;

/**
 * Reads a picture like #image_plugin_read, in a worker.
 * @param worker        The program, started for this picture; NULL: `dioptre-worker`, which is kept
 *                      for the next picture, because its libraries take half a second to load.
 * @param source        The file.
 * @param limits        Limits of time and memory.
 * @param[in,out] budget  What the scene has left; NULL: no budget.
 * @param[out] texture  The picture, sanitized, to be freed with #texture_release; NULL on errors.
 * @param[out] error    What is wrong (#STATUS_SCENE; #STATUS_FAILED without module, memory or
 *                      process).
 * @return Whether it was read.
 */
bool image_worker_call(const ImageWorker *worker, const ImageSource *source,
                       const ImageReadLimits *limits, AssetBudget *budget, Texture **texture,
                       Error *error);

/**
 * @return Whether the picture module is installed, as the kept worker finds.
 * @param[out] error  What is missing, and the package to install (#STATUS_FAILED).
 */
bool image_worker_check(Error *error);

/**
 * Writes a picture in a format of the module, encoded in the kept worker. Formats of linear light
 * (OpenEXR, Radiance) get #Picture.linear, or the decoded codes if it is NULL.
 * @param format      Name of the format in OpenImageIO.
 * @param is_linear   Whether it contains linear light.
 * @param picture     The picture.
 * @param stream      The output; need not be seekable.
 * @param[out] error  What is wrong (#STATUS_FAILED), without the path.
 * @return Whether all bytes were written to the stream.
 */
bool image_worker_write(const char *format, bool is_linear, const Picture *picture, FILE *stream,
                        Error *error);

/** Runs a request to the picture module; the worker's side. See #WorkerTask.run. */
void image_worker_run(WorkerJob *job);

/** Reads a picture with a given module, for tests; the worker's side. */
void image_worker_read_with(WorkerJob *job, const ImagePlugin *plugin);

#endif
