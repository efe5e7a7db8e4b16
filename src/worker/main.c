/**
 * @file
 * @brief The program `dioptre-worker`: reads scenes, pictures and meshes, and encodes pictures, for
 * `dioptre`.
 *
 * As a separate program without SDL, whose libraries load in ten milliseconds, it starts in one.
 */
#include "assets/images/image_worker.h"
#include "assets/meshes/mesh_worker.h"
#include "base/standard_streams.h"
#include "script/script_worker.h"

#include <stdio.h>
#include <stdlib.h>

/** Runs the text of a scene. See #WorkerTask.run. */
static void run_scene(WorkerJob *job) {
    script_worker_scene(job, scene_shape_keywords);
}

/** The worker program. @return EXIT_FAILURE if it is not started by `dioptre`. */
int main(int argc, char **argv) {
    static const WorkerTask tasks[] = {{SCRIPT_SCENE_TASK, run_scene},
                                       {SCRIPT_NFF_TASK, script_worker_nff},
                                       {SCRIPT_LESSON_TASK, script_worker_lesson},
                                       {IMAGE_WORKER_TASK, image_worker_run},
                                       {MESH_WORKER_TASK, mesh_worker_read},
                                       {0}};
    standard_streams_open();
    if (worker_is_requested(argc, argv)) {
        worker_main(argv, tasks);
    }
    fputs("dioptre-worker is started by dioptre, not by hand\n", stderr);
    return EXIT_FAILURE;
}
