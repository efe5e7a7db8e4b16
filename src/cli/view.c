/**
 * @file
 * @brief `dioptre view`: the window.
 */
#include "dioptre/view.h"
#include "cli/commands.h"
#include "dioptre/language.h"

#include <limits.h>
#include <stdio.h>
#include <time.h>

/** @return Seconds on the monotonic clock. */
static double now_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** What scenes are loaded from. */
typedef struct Loading {
    Options options;     /**< The command line; its scene is the one that was loaded last. */
    char path[PATH_MAX]; /**< That scene's file, where it is not the command line's. */
    Stock *stock;        /**< What no time changes of it; NULL before the first; owned. */
} Loading;

/** Notes that a scene was loaded. @param[in,out] loading What from. @param options With its file.
 *  @param stock What it has left. */
static void keep(Loading *loading, const Options *options, Stock *stock) {
    if (options->arguments[0] != loading->options.arguments[0]) {
        snprintf(loading->path, sizeof loading->path, "%s", options->arguments[0]);
        loading->options = *options;
        loading->options.arguments[0] = loading->path;
    }
    if (stock != loading->stock) {
        stock_destroy(loading->stock);
        loading->stock = stock;
    }
}

/** Loads a scene. See #ViewLoader. @param context The #Loading. @param request Which. @param stop
 *  Whether to give up. @param[out] render How it is drawn. @param[out] error What is wrong.
 *  @return The scene. */
static Scene *load(void *context, const ViewRequest *request, const atomic_bool *stop,
                   RenderSettings *render, Error *error) {
    Loading *loading = context;
    Options options = loading->options;
    bool is_other = request->path || request->is_anew || !loading->stock;
    if (request->path) {
        options.arguments[0] = request->path;
        options.base_dir = NULL;
    }
    Stock *stock = is_other ? stock_create(error) : loading->stock;
    Scene *scene = stock ? command_scene_at(&options, request->time, stock, stop, error) : NULL;
    if (scene) {
        *render = command_settings(&options, scene);
        keep(loading, &options, stock);
    } else if (is_other) {
        stock_destroy(stock);
    }
    return scene;
}

/** Shows a scene. See #Command.run. @param options The command line.
 *  @param[out] error What is wrong. @return The exit status. */
static int view_command_run(const Options *options, Error *error) {
    double launched = now_seconds();
    Loading loading = {.options = *options};
    ViewSettings settings = {.keys_by_letter = options->by_letter,
                             .path = options->arguments[0],
                             .snapshot_dir = ".",
                             .launched = launched,
                             .time = options->time,
                             .load = load,
                             .context = &loading,
                             .is_timed = options->timing};
    const ViewRequest first = {.time = options->time};
    Scene *scene = load(&loading, &first, NULL, &settings.render, error);
    int status = (int)error->status;
    if (scene) {
        status = (int)view_run(scene, &settings, interrupt_flag(), error);
        scene_destroy(scene);
    }
    stock_destroy(loading.stock);
    return status;
}

const Command view_command = {.name = "view",
                              .usage = N_("SCENE"),
                              .help = N_("shows a scene in a window and moves camera and light"),
                              .accepts = "sASDtjEOXBKLq",
                              .arguments = 1,
                              .run = view_command_run};
