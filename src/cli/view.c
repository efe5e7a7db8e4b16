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

/** What the scene is loaded from at other times. */
typedef struct Loading {
    const Options *options; /**< The command line. */
    Stock *stock;           /**< What no time changes. */
} Loading;

/** Loads the scene at another time. See #ViewLoader. @param context The #Loading.
 *  @param time Seconds. @param stop Whether to give up. @param[out] error What is wrong.
 *  @return The scene. */
static Scene *load_at(void *context, double time, const atomic_bool *stop, Error *error) {
    const Loading *loading = context;
    return command_scene_at(loading->options, time, loading->stock, stop, error);
}

/** Shows a scene. See #Command.run. @param options The command line.
 *  @param[out] error What is wrong. @return The exit status. */
static int view_command_run(const Options *options, Error *error) {
    double launched = now_seconds();
    Loading loading = {.options = options, .stock = stock_create(error)};
    Scene *scene = loading.stock ? load_at(&loading, options->time, NULL, error) : NULL;
    int status = (int)error->status;
    if (scene) {
        char name[256];
        scene_name(options->arguments[0], name, sizeof name);
        ViewSettings settings = {.render = command_settings(options, scene),
                                 .keys_by_letter = options->by_letter,
                                 .name = name,
                                 .snapshot_dir = ".",
                                 .launched = launched,
                                 .time = options->time,
                                 .load = load_at,
                                 .context = &loading,
                                 .is_timed = options->timing};
        status = (int)view_run(scene, &settings, interrupt_flag(), error);
        scene_destroy(scene);
    }
    stock_destroy(loading.stock);
    return status;
}

const Command view_command = {.name = "view",
                              .usage = "SCENE",
                              .help = "shows a scene in a window and moves camera and light",
                              .accepts = "sASDtjEOXBKLq",
                              .arguments = 1,
                              .run = view_command_run};
