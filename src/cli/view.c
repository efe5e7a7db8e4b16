/**
 * @file
 * @brief `dioptre view`: the window.
 */
#include "dioptre/view.h"
#include "base/clock.h"
#include "base/data_dir.h"
#include "base/language.h"
#include "base/lesson_file.h"
#include "cli/commands.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/** The source of scenes for the window. */
typedef struct SceneLoadContext {
    const Options *command_line; /**< The command line. */
    Options options;             /**< The same, with the newest scene and its lesson's settings. */
    char path[PATH_MAX];         /**< File of that scene, if it is not that of the command line. */
    AssetCache *cache;           /**< Its assets; NULL before the first scene; owned. */
} SceneLoadContext;

/** Stores the source of a scene that was loaded. */
static void store_loaded(SceneLoadContext *source, const Options *options, AssetCache *cache) {
    if (options->arguments[0] != source->options.arguments[0]) {
        snprintf(source->path, sizeof source->path, "%s", options->arguments[0]);
        source->options = *options;
        source->options.arguments[0] = source->path;
    }
    if (cache != source->cache) {
        asset_cache_destroy(source->cache);
        source->cache = cache;
    }
}

/** Loads a lesson. See #ViewLessonLoader. */
static Lesson *load_lesson(const char *path, Error *error) {
    const char *names[VIEW_ACTIONS_MAXIMUM];
    const ActionNames actions = {names, view_actions(names)};
    return script_load_lesson(path, &actions, error);
}

/** Applies the scene and the settings of a lesson that the command line does not set. @param path
 *  The lesson's file. @return false if its engine cannot run. */
static bool apply_lesson(Options *options, const Lesson *lesson, const char *path, Error *error) {
    const LessonSettings *initial = &lesson->initial_settings;
    options->arguments[0] = lesson->scene;
    options->argument_count = 1;
    options->base_dir = NULL;
    options->samples = options->samples ? options->samples : initial->samples;
    options->depth = options->depth >= 0 ? options->depth : initial->depth;
    options->offset = options->offset >= 0 ? options->offset : initial->offset;
    options->epsilon = options->epsilon >= 0 ? options->epsilon : initial->epsilon;
    options->time = isnan(options->time) ? initial->time : options->time;
    if (!options->width) {
        options->width = initial->width;
        options->height = initial->height;
    }
    if (initial->engine && !options->engine && strcmp(initial->engine, "auto") != 0) {
        options->engine = engine_find(initial->engine, error);
        if (!options->engine) {
            error->status = STATUS_SCENE;
            return error_prefix(error, "%s: ", path);
        }
    }
    return true;
}

/** Opens a lesson in place of a scene. @param path Its file. @param[in,out] options Get its scene
 *  and its settings. @return The lesson; NULL after an error. */
static Lesson *open_lesson(const char *path, Options *options, Error *error) {
    Lesson *lesson = load_lesson(path, error);
    if (lesson && !apply_lesson(options, lesson, path, error)) {
        lesson_destroy(lesson);
        lesson = NULL;
    }
    return lesson;
}

/** @return The settings of a scene without those of a lesson, but of the size that it has with
 * them.
 */
static RenderSettings own_settings(const SceneLoadContext *source, const Options *options,
                                   const Scene *scene) {
    Options own = *source->command_line;
    own.width = options->width;
    own.height = options->height;
    return command_render_settings(&own, scene);
}

/** Checks that a scene has what its lesson names. @param path The lesson's file. */
static bool check_lesson_objects(const Lesson *lesson, const char *path, const Scene *scene,
                                 Error *error) {
    return lesson_check_scene(lesson, scene, error) || error_prefix(error, "%s: ", path);
}

/**
 * Replaces the scene by the one that the window asks for, or by that of a lesson.
 * @param[in,out] options  Get the scene, and the settings of the lesson.
 * @param[in,out] time     Becomes that of the lesson.
 * @param[out] lesson      The lesson; NULL: none.
 * @return false if the lesson cannot be read.
 */
static bool apply_requested_path(const ViewRequest *request, Options *options, double *time,
                                 Lesson **lesson, Error *error) {
    *lesson = NULL;
    if (!request->path) {
        return true;
    }
    options->arguments[0] = request->path;
    options->argument_count = 1;
    options->base_dir = NULL;
    if (!lesson_file_is(request->path)) {
        return true;
    }
    *lesson = open_lesson(request->path, options, error);
    if (*lesson) {
        *time = (*lesson)->initial_settings.time;
    }
    return *lesson != NULL;
}

/**
 * Loads a scene, or a lesson with its scene. See #ViewLoader.
 * @param stop  Loading ends early once this is true.
 * @param[out] render  Its settings.
 * @param[out] own  The same without those of its lesson.
 * @return The scene, or NULL.
 */
static Scene *load_scene(void *context, const ViewRequest *request, const atomic_bool *stop,
                         RenderSettings *render, RenderSettings *own, Lesson **lesson,
                         Error *error) {
    SceneLoadContext *source = context;
    Options options = request->path ? *source->command_line : source->options;
    double time = request->time;
    bool needs_new_cache = request->path || request->force_reload || !source->cache;
    if (!apply_requested_path(request, &options, &time, lesson, error)) {
        return NULL;
    }
    AssetCache *cache = needs_new_cache ? asset_cache_create(error) : source->cache;
    Scene *scene = cache ? command_run_scene(&options,
                                             &(SceneRun){.time = time,
                                                         .cache = cache,
                                                         .stop = stop,
                                                         .overrides = request->overrides,
                                                         .override_count = request->override_count},
                                             error)
                         : NULL;
    if (scene && *lesson && !check_lesson_objects(*lesson, request->path, scene, error)) {
        scene_destroy(scene);
        scene = NULL;
    }
    if (scene) {
        *render = needs_new_cache ? command_print_notes(&options, scene)
                                  : command_render_settings(&options, scene);
        *own = own_settings(source, &options, scene);
        store_loaded(source, &options, cache);
        return scene;
    }
    if (needs_new_cache) {
        asset_cache_destroy(cache);
    }
    lesson_destroy(*lesson);
    *lesson = NULL;
    return NULL;
}

/** Loads a scene for the scene browser, without the options of the command line, which are for
 * another scene. See #ViewPreviewLoader. */
static Scene *load_preview(void *context, const char *path, const atomic_bool *stop,
                           RenderSettings *render, Error *error) {
    (void)context;
    Options options = options_default();
    Lesson *lesson = NULL;
    options.arguments[0] = path;
    options.argument_count = 1;
    options.progress = PROGRESS_NONE;
    options.quiet = true; // What a scene prints is not asked for here.
    if (lesson_file_is(path) && !(lesson = open_lesson(path, &options, error))) {
        return NULL;
    }
    Scene *scene = command_run_scene(
        &options, &(SceneRun){.time = options_time(&options), .stop = stop}, error);
    if (scene) {
        *render = command_render_settings(&options, scene);
    }
    lesson_destroy(lesson);
    return scene;
}

/** Shows a scene until its window is closed. @param options The command line, with the settings of
 *  the lesson. @param command_line Without them. @param lesson The lesson to play, or NULL. */
static void show_scene(const Options *options, const Options *command_line, const Lesson *lesson,
                       Error *error) {
    SceneLoadContext source = {.command_line = command_line, .options = *options};
    Lesson *none = NULL;
    ViewSettings settings = {.keys_by_letter = options->keys == KEYS_BY_LETTER,
                             .path = options->arguments[0],
                             .snapshot_dir = ".",
                             .launch_time = clock_now_seconds(),
                             .initial_time = options_time(options),
                             .load = load_scene,
                             .preview = load_preview,
                             .loader_context = &source,
                             .load_lesson = load_lesson,
                             .lesson = lesson,
                             .lesson_path = options->lesson,
                             .lesson_snapshot_dir = options->lesson_snapshots,
                             .predictions = options->predictions,
                             .answer_path = options->answers,
                             .opens_list = options->opens_list,
                             .prints_timing = options->timing};
    const ViewRequest first = {.time = options_time(options)};
    RenderSettings own;
    Scene *scene = load_scene(&source, &first, NULL, &settings.render, &own, &none, error);
    if (scene && (!lesson || check_lesson_objects(lesson, options->lesson, scene, error))) {
        settings.own = &own;
        error->status = view_run(scene, &settings, interrupt_flag(), error);
    }
    scene_destroy(scene);
    asset_cache_destroy(source.cache);
}

/** @return Whether the scene of the command line, if any, is that of the lesson. */
static bool check_lesson_scene(const Options *options, const Lesson *lesson, Error *error) {
    char wanted[PATH_MAX], named[PATH_MAX];
    const char *given = options->argument_count > 0 ? options->arguments[0] : lesson->scene;
    return (realpath(given, wanted) && realpath(lesson->scene, named) &&
            strcmp(wanted, named) == 0) ||
           error_set(error, STATUS_SCENE, "%s: this lesson is for %s, not for %s", options->lesson,
                     lesson->scene, given);
}

/** Plays a lesson. */
static void play_lesson(const Options *options, Error *error) {
    Options lesson_options = *options;
    Lesson *lesson = load_lesson(options->lesson, error);
    if (lesson && check_lesson_scene(options, lesson, error) &&
        apply_lesson(&lesson_options, lesson, options->lesson, error)) {
        show_scene(&lesson_options, options, lesson, error);
    }
    lesson_destroy(lesson);
}

/** Finds the first scene: in the working folder, else among the program's own. @param[out] path
 *  Its file. @return Whether there is one. */
static bool find_first_scene(char path[PATH_MAX]) {
    static const char name[] = "box.lua";
    char folder[PATH_MAX];
    snprintf(path, PATH_MAX, "scenes/%s", name);
    return access(path, R_OK) == 0 ||
           (data_dir_scenes(folder) && snprintf(path, PATH_MAX, "%s/%s", folder, name) < PATH_MAX &&
            access(path, R_OK) == 0);
}

bool cli_browse(const Options *options, Error *error) {
    char path[PATH_MAX];
    Options own = *options;
    if (!find_first_scene(path) || !view_is_possible()) {
        return false;
    }
    own.arguments[0] = path;
    own.argument_count = 1;
    own.opens_list = true;
    cli_view(&own, error);
    return true;
}

void cli_view(const Options *options, Error *error) {
    Options own = *options;
    if (!own.lesson && own.argument_count == 1 && lesson_file_is(own.arguments[0])) {
        own.lesson = own.arguments[0];
        own.argument_count = 0;
    }
    if (own.lesson) {
        play_lesson(&own, error);
    } else if (own.argument_count == 0) {
        // The menu of a desktop opens the program without a file.
        if (own.lesson_snapshots || !cli_browse(options, error)) {
            error_set(error, STATUS_USAGE, "view needs a SCENE, or --lesson FILE");
        }
    } else if (own.lesson_snapshots) {
        error_set(error, STATUS_USAGE, "--lesson-snapshots needs --lesson");
    } else {
        show_scene(&own, options, NULL, error);
    }
}
