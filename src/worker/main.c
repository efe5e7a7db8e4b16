/**
 * @file
 * @brief The program `dioptre-worker`: reads scenes, pictures and meshes, and encodes pictures, for
 * `dioptre`.
 *
 * As a separate program without SDL, whose libraries load in ten milliseconds, it starts in one.
 */
#include "base/standard_streams.h"
#include "worker/tasks.h"

#include <stdio.h>
#include <stdlib.h>

/** The worker program. @return EXIT_FAILURE if it is not started by `dioptre`. */
int main(int argc, char **argv) {
    standard_streams_open();
    if (worker_is_requested(argc, argv)) {
        worker_main(argv, worker_tasks);
    }
    fputs("dioptre-worker is started by dioptre, not by hand\n", stderr);
    return EXIT_FAILURE;
}
