/**
 * @file
 * @brief Reading of meshes: the worker's side.
 */
#ifndef DIOPTRE_ASSETS_MESHES_MESH_WORKER_H
#define DIOPTRE_ASSETS_MESHES_MESH_WORKER_H

#include "assets/process/worker_main.h"
#include "base/error.h"

/** Name of the task, see #WorkerTask. */
#define MESH_WORKER_TASK "model"

/** Largest size of a mesh, bytes. */
#ifndef MESH_CAPACITY // A page has less: src/web/memory.h.
#define MESH_CAPACITY ((size_t)2 << 30)
#endif

/** Limit of the data of the library, bytes. */
#define MESH_FILE_MEMORY_LIMIT ((size_t)2 << 30)

/** Request for a mesh; the descriptor of the file is sent along. */
typedef struct MeshWorkerRequest {
    char extension[8];      /**< Format, see #MeshSource.extension. */
    size_t size;            /**< Bytes of the file. */
    size_t capacity;        /**< Largest size of the mesh, bytes. */
    int is_capacity_shared; /**< Not 0: other files of the scene have taken the rest. */
} MeshWorkerRequest;

/** Report on a mesh. */
typedef struct MeshWorkerReport {
    int is_done; /**< Not 0: the block is a mesh. No bool, which may hold any byte here. */
    Error error; /**< What is wrong, without a mesh. */
} MeshWorkerReport;

/** Reads the mesh of a #MeshWorkerRequest; the block is a #Mesh. See #WorkerTask.run. */
void mesh_worker_read(WorkerJob *job);

#endif
