/**
 * @file
 * @brief `dioptre view`: the window.
 */
#include "dioptre/view.h"
#include "base/clock.h"
#include "base/language.h"
#include "base/scene_name.h"
#include "cli/commands.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** The source of scenes for the window. */
typedef struct SceneSource {
    Options options;     /**< The command line, with the newest scene. */
    char path[PATH_MAX]; /**< File of that scene, if it is not that of the command line. */
    AssetCache *cache;   /**< Its assets; NULL before the first scene; owned. */
} SceneSource;

/** Stores the source of a scene that was loaded. */
static void store_loaded(SceneSource *source, const Options *options, AssetCache *cache) {
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

/**
 * Loads a scene. See #ViewLoader.
 * @param stop  Loading ends early once this is true.
 * @param[out] render  Its settings.
 * @return The scene, or NULL.
 */
static Scene *load_scene(void *context, const ViewRequest *request, const atomic_bool *stop,
                         RenderSettings *render, Error *error) {
    SceneSource *source = context;
    Options options = source->options;
    bool needs_new_cache = request->path || request->force_reload || !source->cache;
    if (request->path) {
        options.arguments[0] = request->path;
        options.base_dir = NULL;
    }
    AssetCache *cache = needs_new_cache ? asset_cache_create(error) : source->cache;
    Scene *scene = cache ? command_run_scene(&options,
                                             &(SceneRun){.time = request->time,
                                                         .cache = cache,
                                                         .stop = stop,
                                                         .overrides = request->overrides,
                                                         .override_count = request->override_count},
                                             error)
                         : NULL;
    if (scene && needs_new_cache) {
        command_print_notes(scene);
    }
    if (scene) {
        *render = command_render_settings(&options, scene);
        store_loaded(source, &options, cache);
    } else if (needs_new_cache) {
        asset_cache_destroy(cache);
    }
    return scene;
}

/** Loads a scene for the scene browser, without the options of the command line, which are for
 * another scene. See #ViewPreviewLoader. */
static Scene *load_preview(void *context, const char *path, const atomic_bool *stop,
                           RenderSettings *render, Error *error) {
    (void)context;
    Options options = options_default();
    options.arguments[0] = path;
    options.argument_count = 1;
    options.progress = PROGRESS_NONE;
    Scene *scene = command_run_scene(&options, &(SceneRun){.stop = stop}, error);
    if (scene) {
        *render = command_render_settings(&options, scene);
    }
    return scene;
}

/** Shows a scene until its window is closed. @param lesson The lesson to play, or NULL. */
static void show_scene(const Options *options, const Lesson *lesson, Error *error) {
    char lesson_name[PATH_MAX] = "";
    SceneSource source = {.options = *options};
    ViewSettings settings = {.keys_by_letter = options->keys == KEYS_BY_LETTER,
                             .path = options->arguments[0],
                             .snapshot_dir = ".",
                             .launch_time = clock_now_seconds(),
                             .initial_time = options->time,
                             .load = load_scene,
                             .preview = load_preview,
                             .loader_context = &source,
                             .lesson = lesson,
                             .lesson_name = lesson_name,
                             .lesson_snapshot_dir = options->lesson_snapshots,
                             .prints_timing = options->timing};
    if (lesson) {
        scene_name_from_path(options->lesson, lesson_name, sizeof lesson_name);
    }
    const ViewRequest first = {.time = options->time};
    Scene *scene = load_scene(&source, &first, NULL, &settings.render, error);
    if (scene) {
        error->status = view_run(scene, &settings, interrupt_flag(), error);
        scene_destroy(scene);
    }
    asset_cache_destroy(source.cache);
}

/**
 * Uses the scene of a lesson; one on the command line must be the same.
 * @param[in,out] options  The command line; gets the scene.
 * @return false if they differ.
 */
static bool use_lesson_scene(Options *options, const Lesson *lesson, Error *error) {
    char wanted[PATH_MAX], named[PATH_MAX];
    const char *given = options->argument_count > 0 ? options->arguments[0] : lesson->scene;
    bool is_same =
        realpath(given, wanted) && realpath(lesson->scene, named) && strcmp(wanted, named) == 0;
    options->arguments[0] = lesson->scene;
    options->argument_count = 1;
    return is_same || error_set(error, STATUS_SCENE, "%s: this lesson is for %s, not for %s",
                                options->lesson, lesson->scene, given);
}

/** Applies the settings of a lesson that the command line does not set. @return false if its engine
 *  cannot run. */
static bool apply_lesson_settings(Options *options, const Lesson *lesson, Error *error) {
    const LessonSettings *initial = &lesson->initial_settings;
    options->samples = options->samples ? options->samples : initial->samples;
    options->depth = options->depth >= 0 ? options->depth : initial->depth;
    options->offset = options->offset >= 0 ? options->offset : initial->offset;
    options->epsilon = options->epsilon >= 0 ? options->epsilon : initial->epsilon;
    options->time = options->time != 0 ? options->time : initial->time;
    if (!options->width) {
        options->width = initial->width;
        options->height = initial->height;
    }
    if (initial->engine && !options->engine && strcmp(initial->engine, "auto") != 0) {
        options->engine = engine_find(initial->engine, error);
        if (!options->engine) {
            error->status = STATUS_SCENE;
            return error_prefix(error, "%s: ", options->lesson);
        }
    }
    return true;
}

/** Plays a lesson. */
static void play_lesson(const Options *options, Error *error) {
    Options lesson_options = *options;
    const char *names[VIEW_ACTIONS_MAXIMUM];
    const ActionNames actions = {names, view_actions(names)};
    Lesson *lesson = script_load_lesson(options->lesson, &actions, error);
    if (lesson && use_lesson_scene(&lesson_options, lesson, error) &&
        apply_lesson_settings(&lesson_options, lesson, error)) {
        show_scene(&lesson_options, lesson, error);
    }
    lesson_destroy(lesson);
}

void cli_view(const Options *options, Error *error) {
    if (options->lesson) {
        play_lesson(options, error);
    } else if (options->argument_count == 0) {
        error_set(error, STATUS_USAGE, "view needs a SCENE, or --lesson FILE");
    } else if (options->lesson_snapshots) {
        error_set(error, STATUS_USAGE, "--lesson-snapshots needs --lesson");
    } else {
        show_scene(options, NULL, error);
    }
}
