/**
 * @file
 * @brief `dioptre view`: the window.
 */
#include "dioptre/view.h"
#include "cli/commands.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

/** @return Seconds on the monotonic clock. */
static double now_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/**
 * Finds a scene's name: its file's, without folder and ending.
 * @param path       The scene file, or `-`.
 * @param[out] name  The name, cut to its size.
 * @param size       Bytes of it.
 */
static void scene_name(const char *path, char *name, size_t size) {
    const char *slash = strrchr(path, '/');
    snprintf(name, size, "%s", strcmp(path, "-") == 0 ? "scene" : slash ? slash + 1 : path);
    char *dot = strrchr(name, '.');
    if (dot && dot != name) {
        *dot = 0;
    }
}

/** Shows a scene. See #Command.run. @param options The command line.
 *  @param[out] error What is wrong. @return The exit status. */
static int view_command_run(const Options *options, Error *error) {
    double launched = now_seconds();
    Scene *scene = command_scene(options, error);
    if (!scene) {
        return (int)error->status;
    }
    char name[256];
    scene_name(options->arguments[0], name, sizeof name);
    ViewSettings settings = {.render = command_settings(options, scene),
                             .keys_by_letter = options->by_letter,
                             .name = name,
                             .snapshot_dir = ".",
                             .launched = launched,
                             .is_timed = options->timing};
    int status = (int)view_run(scene, &settings, interrupt_flag(), error);
    scene_destroy(scene);
    return status;
}

const Command view_command = {.name = "view",
                              .usage = "SCENE",
                              .help = "shows a scene in a window and moves camera and light",
                              .accepts = "sASDtjEOXBKLq",
                              .arguments = 1,
                              .run = view_command_run};
