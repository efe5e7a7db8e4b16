/**
 * @file
 * @brief All tasks of a worker.
 */
#include "worker/tasks.h"

#include "assets/images/image_worker.h"
#include "assets/meshes/mesh_worker.h"
#include "script/script_worker.h"

/** Runs the text of a scene. See #WorkerTask.run. */
static void run_scene(WorkerJob *job) {
    script_worker_scene(job, scene_shape_keywords);
}

const WorkerTask worker_tasks[] = {{SCRIPT_SCENE_TASK, run_scene},
                                   {SCRIPT_NFF_TASK, script_worker_nff},
                                   {SCRIPT_LESSON_TASK, script_worker_lesson},
                                   {IMAGE_WORKER_TASK, image_worker_run},
                                   {MESH_WORKER_TASK, mesh_worker_read},
                                   {0}};
