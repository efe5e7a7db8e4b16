/**
 * @file
 * @brief `dioptre animate`: a film, or its numbered frames.
 *
 * A frame has the bits of `render --time`: it depends on its number alone. So frames may come from
 * several machines, in any order, and an interrupted film can be continued.
 */
#include "assets/film.h"
#include "assets/images/image_file.h"
#include "assets/images/image_whole.h"
#include "base/language.h"
#include "cli/commands.h"
#include "cli/frames.h"

#include <math.h>

/** An animation under way. */
typedef struct Animation {
    const Options *options;  /**< The command line. */
    FrameRange frames;       /**< The frames. */
    double fps;              /**< Frames per second. */
    bool is_film;            /**< Whether the output is one film instead of numbered files. */
    bool is_rendered;        /**< Whether frames are rendered instead of read from files. */
    FramePattern output;     /**< Numbered files to write, unless #is_film. */
    FramePattern input;      /**< Numbered files to read, unless #is_rendered. */
    Film *film;              /**< The film, from the first frame on; owned. */
    AssetCache *cache;       /**< Assets of the scenes of all frames; owned. */
    Scene *scene;            /**< Scene of the newest frame; owned. */
    RenderSettings settings; /**< Its settings. */
    Renderer *renderer;      /**< Its renderer; owned. */
    Picture picture;         /**< The newest frame. */
    Progress *progress;      /**< Progress, or NULL. */
    int done;                /**< Number of frames that are done. */
} Animation;

/** Computes the range of frames. @return false for none, too many, or frames beyond the end. */
static bool plan_frames(Animation *animation, Error *error) {
    const Options *options = animation->options;
    animation->fps = options->fps > 0 ? options->fps : FRAMES_FPS_DEFAULT;
    double seconds = options->seconds >= 0 ? options->seconds : FRAMES_SECONDS_DEFAULT;
    double count = round(seconds * animation->fps);
    if (!(count >= 1 && count <= FRAMES_MAXIMUM)) {
        return error_set(error, STATUS_USAGE,
                         "%g s at %g frames per second are %g frames, not 1 to %d", seconds,
                         animation->fps, count, FRAMES_MAXIMUM);
    }
    animation->frames = (FrameRange){.first = 0, .last = (int)count - 1, .step = 1};
    if (options->frames.step == 0) {
        return true;
    }
    animation->frames = options->frames;
    int first = options->frames.first, last = options->frames.last;
    if (options->seconds >= 0 && fmax(first, last) >= count) {
        return error_set(error, STATUS_USAGE,
                         "--frames %d-%d: %g s at %g frames per second end at %g", first, last,
                         seconds, animation->fps, count - 1);
    }
    return true;
}

/** Determines the input and the output of frames. @return false if they are wrong. */
static bool plan_files(Animation *animation, Error *error) {
    const Options *options = animation->options;
    const char *output = options->output, *input = options->arguments[0];
    if (!output || (!film_has_extension(output) && !frame_pattern_is_in(output))) {
        return error_set(error, STATUS_USAGE,
                         "animate needs -o FILM.mp4, -o FILM.webm or numbered frames such as "
                         "-o frames/%%05d.png");
    }
    animation->is_film = film_has_extension(output);
    animation->is_rendered = !frame_pattern_is_in(input);
    if (animation->is_film && (options->skip_existing || options->no_sync)) {
        return error_set(error, STATUS_USAGE,
                         options->skip_existing ? N_("--skip-existing is for numbered frames")
                                                : N_("--no-sync is for numbered frames"));
    }
    return (animation->is_film || frame_pattern_parse(output, &animation->output, error)) &&
           (animation->is_rendered || frame_pattern_parse(input, &animation->input, error));
}

/**
 * Checks before rendering that the output can be written.
 * @return false if it cannot.
 */
static bool check_output(const Animation *animation, Error *error) {
    char path[PATH_MAX];
    if (animation->is_film) {
        return film_check(animation->options->output, error);
    }
    return frame_pattern_path(&animation->output, animation->frames.last, path, error) &&
           image_file_check(path, error);
}

/** Makes a scene that of the newest frame, with its settings. @param scene Ownership passes; may be
 *  NULL. */
static void use_scene(Animation *animation, Scene *scene) {
    bool is_first = !animation->scene;
    scene_destroy(animation->scene);
    animation->scene = scene;
    if (scene) {
        animation->settings = is_first ? command_print_notes(animation->options, scene)
                                       : command_render_settings(animation->options, scene);
    }
}

/**
 * Renders a frame. Where the scene does not depend on time, the previous frame is kept.
 * @return false on failure or interruption.
 */
static bool render_frame(Animation *animation, RenderJob *job, Error *error) {
    RenderStats report = {.is_finished = true};
    if (animation->scene && !animation->scene->is_time_dependent) {
        progress_done(animation->progress);
        return true;
    }
    Scene *scene = command_run_scene(
        job->options,
        &(SceneRun){.time = job->time, .cache = animation->cache, .stop = interrupt_flag()}, error);
    use_scene(animation, scene);
    job->settings = animation->settings;
    picture_deinit(&animation->picture);
    return scene &&
           command_render(job, scene, &animation->renderer, &animation->picture, &report, error) &&
           (report.is_finished || error_set(error, STATUS_INTERRUPTED, "interrupted"));
}

/** Reads a frame from its numbered file. @return false on failure. */
static bool read_frame(Animation *animation, int number, Error *error) {
    char path[PATH_MAX];
    picture_deinit(&animation->picture);
    bool is_read = frame_pattern_path(&animation->input, number, path, error) &&
                   image_file_read(path, &animation->picture, error);
    progress_done(animation->progress);
    return is_read;
}

/** Adds the newest frame to the film, which begins with the first one. @return false on failure. */
static bool add_frame(Animation *animation, Error *error) {
    const Picture *picture = &animation->picture;
    if (!animation->film) {
        FilmSettings shape = {.width = picture->width,
                              .height = picture->height,
                              .fps = animation->fps,
                              .stop = interrupt_flag()};
        animation->film = film_begin(animation->options->output, &shape, error);
    }
    return animation->film && film_add_frame(animation->film, picture, error);
}

/** Writes the newest frame to the output. @return false on failure. */
static bool write_frame(Animation *animation, const RenderJob *job, Error *error) {
    if (animation->is_film) {
        return add_frame(animation, error);
    }
    return animation->is_rendered ? command_write_image(job, &animation->picture, error)
                                  : command_write_file(job, &animation->picture, error);
}

/** Renders or reads a frame and writes it. @return false on failure. */
static bool produce_frame(Animation *animation, int number, Error *error) {
    char path[PATH_MAX];
    const Options *options = animation->options;
    RenderJob job = {.options = options,
                     .output = animation->is_film ? options->output : path,
                     .time = options_time(options) + number / animation->fps,
                     .settings = animation->settings,
                     .progress = animation->progress};
    if (!animation->is_film && !frame_pattern_path(&animation->output, number, path, error)) {
        return false;
    }
    if (options->skip_existing && image_file_is_whole(path)) {
        progress_skip(animation->progress);
        return true;
    }
    bool is_there = animation->is_rendered ? render_frame(animation, &job, error)
                                           : read_frame(animation, number, error);
    return is_there && write_frame(animation, &job, error);
}

/** Produces all frames. @return false on failure or interruption. */
static bool produce_frames(Animation *animation, const atomic_bool *stop, Error *error) {
    int count = frame_range_count(&animation->frames);
    bool is_good = true;
    while (is_good && !atomic_load(stop) && animation->done < count) {
        int number = animation->frames.first + animation->done * animation->frames.step;
        is_good = produce_frame(animation, number, error);
        animation->done += is_good;
    }
    return is_good && animation->done == count;
}

/** Produces all frames and finishes the film. */
static void animate(Animation *animation, Error *error) {
    int count = frame_range_count(&animation->frames);
    const atomic_bool *stop = interrupt_flag();
    animation->progress = progress_begin(animation->options, PROGRESS_FRAMES, count);
    bool is_good = produce_frames(animation, stop, error);
    if (is_good && animation->film) {
        is_good = film_commit(animation->film, error);
    } else {
        film_discard(animation->film);
    }
    progress_end(animation->progress);
    if (!is_good && (atomic_load(stop) || error->status == STATUS_INTERRUPTED)) {
        error_set(error, STATUS_INTERRUPTED,
                  animation->is_film
                      ? N_("interrupted: %d of %d frames were done; there is no film")
                      : N_("interrupted: %d of %d frames were done and are kept"),
                  animation->done, count);
    }
    picture_deinit(&animation->picture);
    renderer_destroy(animation->renderer);
    scene_destroy(animation->scene);
}

void cli_animate(const Options *options, Error *error) {
    Animation animation = {.options = options};
    if (plan_files(&animation, error) && plan_frames(&animation, error) &&
        check_output(&animation, error)) {
        animation.cache = asset_cache_create(error);
        if (animation.cache) {
            animate(&animation, error);
            asset_cache_destroy(animation.cache);
        }
    }
}
