/**
 * @file
 * @brief `dioptre view`: the window.
 */
#include "dioptre/view.h"
#include "cli/commands.h"
#include "dioptre/clock.h"
#include "dioptre/language.h"
#include "dioptre/scene_name.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

/** Loads a scene for the list of scenes, as it is by itself: what the command line says is for
 *  another scene. See #ViewPreviewer. @param context Not used. @param path See there. @param stop
 * See there.
 *  @param[out] render See there. @param[out] error See there. @return See there. */
static Scene *preview(void *context, const char *path, const atomic_bool *stop,
                      RenderSettings *render, Error *error) {
    (void)context;
    Options options = {.arguments = {path},
                       .argument_count = 1,
                       .depth = -1,
                       .offset = -1,
                       .epsilon = -1,
                       .progress = PROGRESS_NONE};
    Scene *scene = command_scene_at(&options, 0, NULL, stop, error);
    if (scene) {
        *render = command_settings(&options, scene);
    }
    return scene;
}

/** Shows a scene. @param options The command line. @param lesson What is done; NULL: nothing by
 *  itself. @param[out] error What is wrong. @return The exit status. */
static int show(const Options *options, const Lesson *lesson, Error *error) {
    char lesson_name[PATH_MAX] = "";
    Loading loading = {.options = *options};
    ViewSettings settings = {.keys_by_letter = options->by_letter,
                             .path = options->arguments[0],
                             .snapshot_dir = ".",
                             .launched = clock_seconds(),
                             .time = options->time,
                             .load = load,
                             .preview = preview,
                             .context = &loading,
                             .lesson = lesson,
                             .lesson_name = lesson_name,
                             .lesson_snapshots = options->lesson_snapshots,
                             .is_timed = options->timing};
    if (lesson) {
        scene_name(options->lesson, lesson_name, sizeof lesson_name);
    }
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

/** Sees that a lesson is for the scene that is asked for, if any is. @param[in,out] options The
 *  command line; gets the lesson's scene. @param lesson The lesson. @param[out] error What is
 *  wrong. @return Whether it is. */
static bool take_scene(Options *options, const Lesson *lesson, Error *error) {
    char wanted[PATH_MAX], named[PATH_MAX];
    const char *given = options->argument_count > 0 ? options->arguments[0] : lesson->scene;
    bool is_same =
        realpath(given, wanted) && realpath(lesson->scene, named) && strcmp(wanted, named) == 0;
    options->arguments[0] = lesson->scene;
    options->argument_count = 1;
    return is_same || error_set(error, STATUS_SCENE, "%s: this lesson is for %s, not for %s",
                                options->lesson, lesson->scene, given);
}

/** Takes what a lesson says of how its scene is drawn, where the command line says nothing.
 *  @param[in,out] options The command line. @param lesson The lesson. @param[out] error What is
 *  wrong. @return Whether all is well. */
static bool take_look(Options *options, const Lesson *lesson, Error *error) {
    const LessonLook *look = &lesson->look;
    options->samples = options->samples ? options->samples : look->samples;
    options->depth = options->depth >= 0 ? options->depth : look->depth;
    options->offset = options->offset >= 0 ? options->offset : look->offset;
    options->epsilon = options->epsilon >= 0 ? options->epsilon : look->epsilon;
    options->time = options->time != 0 ? options->time : look->time;
    if (!options->width) {
        options->width = look->width;
        options->height = look->height;
    }
    if (look->engine && !options->engine && strcmp(look->engine, "auto") != 0) {
        options->engine = engine_find(look->engine, error);
        if (!options->engine) {
            error->status = STATUS_SCENE;
            return error_prefix(error, "%s: ", options->lesson);
        }
    }
    return true;
}

/** Plays a lesson. @param options The command line. @param[out] error What is wrong. @return The
 *  exit status. */
static int play_lesson(const Options *options, Error *error) {
    Options taught = *options;
    ActionNames actions;
    actions.names = view_actions(&actions.move_count);
    Lesson *lesson = script_load_lesson(options->lesson, &actions, error);
    bool is_good =
        lesson && take_scene(&taught, lesson, error) && take_look(&taught, lesson, error);
    int status = is_good ? show(&taught, lesson, error) : (int)error->status;
    lesson_destroy(lesson);
    return status;
}

/** Shows a scene, or plays a lesson. See #Command.run. @param options The command line.
 *  @param[out] error What is wrong. @return The exit status. */
static int view_command_run(const Options *options, Error *error) {
    if (options->lesson) {
        return play_lesson(options, error);
    }
    if (options->argument_count == 0 || options->lesson_snapshots) {
        return error_set(error, STATUS_USAGE,
                         options->argument_count == 0 ? N_("view needs a SCENE, or --lesson FILE")
                                                      : N_("--lesson-snapshots needs --lesson")),
               STATUS_USAGE;
    }
    return show(options, NULL, error);
}

const Command view_command = {.name = "view",
                              .usage = N_("SCENE"),
                              .help = N_("shows a scene in a window and moves camera and light"),
                              .accepts = "sASDtjEOXBKIWLq",
                              .arguments = 1,
                              .optional = 1,
                              .run = view_command_run};
