/**
 * @file
 * @brief Reads a model in a worker process: the part that runs there.
 */
#ifndef DIOPTRE_ASSETS_MESHES_MESH_WORKER_H
#define DIOPTRE_ASSETS_MESHES_MESH_WORKER_H

#include "assets/process/worker_main.h"
#include "base/error.h"

/** Name of the task, see #WorkerTask. */
#define MESH_WORKER_TASK "model"

/** Most bytes of a mesh. */
#define MESH_CAPACITY ((size_t)2 << 30)

/** Bytes that the library may take for a model. */
#define MESH_FILE_MEMORY_LIMIT ((size_t)2 << 30)

/** Request for a model. The file comes with it. */
typedef struct MeshWorkerRequest {
    char extension[8]; /**< Its format, see #MeshSource.extension. */
    size_t size;       /**< Bytes of the file. */
} MeshWorkerRequest;

/** Report on a model. */
typedef struct MeshWorkerReport {
    bool is_done; /**< Whether the block is a mesh. */
    Error error;  /**< What is wrong, if it is not. */
} MeshWorkerReport;

/** Reads the model of a #MeshWorkerRequest; the block is a #Mesh. See #WorkerTask.run. */
void mesh_worker_read(WorkerJob *job);

#endif
