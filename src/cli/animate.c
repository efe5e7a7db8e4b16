/**
 * @file
 * @brief `dioptre animate`: a film, or its numbered frames.
 *
 * A frame is drawn as `render --time` draws it, bit by bit: only its number says what is in it. So
 * frames may come from several machines, in any order, and a stopped film goes on where it was.
 */
#include "base/language.h"
#include "cli/commands.h"
#include "cli/frames.h"
#include "dioptre/film.h"
#include "dioptre/image_file.h"

#include <math.h>
#include <unistd.h>

/** A film that is being made. */
typedef struct Animation {
    const Options *options; /**< The command line. */
    FrameRange frames;      /**< Which frames. */
    double fps;             /**< Frames a second. */
    bool is_film;           /**< Whether it goes into one file, and not into numbered ones. */
    bool is_rendered;       /**< Whether frames are drawn, and not read from numbered files. */
    FramePattern output;    /**< Numbered files to write, unless #is_film. */
    FramePattern input;     /**< Numbered files to read, unless #is_rendered. */
    Film *film;             /**< The film, once its size is known; owned. */
    AssetCache *cache;      /**< What all frames' scenes have in common; owned. */
    Scene *scene;           /**< The scene of the frame drawn last; owned. */
    Renderer *renderer;     /**< Who drew it; owned. */
    Picture picture;        /**< The newest frame. */
    Progress *progress;     /**< Who tells how far it is, or NULL. */
    int done;               /**< Frames that are done. */
} Animation;

/** Finds which frames are asked for. @return false for none, too many, or some beyond the end of
 *  the film. */
static bool plan_frames(Animation *animation, Error *error) {
    const Options *options = animation->options;
    animation->fps = options->fps > 0 ? options->fps : FRAMES_FPS_DEFAULT;
    double seconds = options->seconds >= 0 ? options->seconds : FRAMES_SECONDS_DEFAULT;
    double count = round(seconds * animation->fps);
    if (!(count >= 1 && count <= FRAMES_MAXIMUM)) {
        return error_set(error, STATUS_USAGE,
                         "%g s at %g frames a second are %g frames, not 1 to %d", seconds,
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
                         "--frames %d-%d: %g s at %g frames a second end at %g", first, last,
                         seconds, animation->fps, count - 1);
    }
    return true;
}

/** Finds where frames come from and go to. @return Whether it makes sense. */
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
    if (animation->is_film && options->skip_existing) {
        return error_set(error, STATUS_USAGE, "--skip-existing is for numbered frames");
    }
    return (animation->is_film || frame_pattern_parse(output, &animation->output, error)) &&
           (animation->is_rendered || frame_pattern_parse(input, &animation->input, error));
}

/**
 * Says whether what is to be written could be, before time is spent on drawing it.
 * @param[out] error  What is wrong or missing.
 * @return Whether it could.
 */
static bool check_output(const Animation *animation, Error *error) {
    char path[PATH_MAX];
    if (animation->is_film) {
        return film_check(animation->options->output, error);
    }
    return frame_pattern_path(&animation->output, animation->frames.last, path, error) &&
           image_file_check(path, error);
}

/**
 * Draws a frame. Where the scene asks for no time, the frame before is it, too.
 * @param job  What is to be drawn.
 * @return Whether all of it is drawn.
 */
static bool render_frame(Animation *animation, const RenderJob *job, Error *error) {
    RenderStats report = {.is_finished = true};
    if (animation->scene && !animation->scene->is_time_dependent) {
        progress_done(animation->progress);
        return true;
    }
    Scene *scene = command_load_scene_at(job->options, job->time, animation->cache, NULL, error);
    scene_destroy(animation->scene);
    animation->scene = scene;
    picture_deinit(&animation->picture);
    return scene &&
           command_render(job, scene, &animation->renderer, &animation->picture, &report, error) &&
           (report.is_finished || error_set(error, STATUS_INTERRUPTED, "interrupted"));
}

/** Reads a frame from its numbered file. @return Whether it is read. */
static bool read_frame(Animation *animation, int number, Error *error) {
    char path[PATH_MAX];
    picture_deinit(&animation->picture);
    bool is_read = frame_pattern_path(&animation->input, number, path, error) &&
                   image_file_read(path, &animation->picture, error);
    progress_done(animation->progress);
    return is_read;
}

/** Adds the newest frame to the film, which is begun with the first one. @return Whether it is
 *  added. */
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

/** Writes the newest frame where it belongs. @return Whether it is there. */
static bool write_frame(Animation *animation, const RenderJob *job, Error *error) {
    if (animation->is_film) {
        return add_frame(animation, error);
    }
    return animation->is_rendered
               ? command_write_image(job, animation->scene, &animation->picture, error)
               : image_file_write(job->output, &animation->picture, error);
}

/** Makes a frame. @return Whether it is where it belongs. */
static bool produce_frame(Animation *animation, int number, Error *error) {
    char path[PATH_MAX];
    const Options *options = animation->options;
    RenderJob job = {.options = options,
                     .output = animation->is_film ? options->output : path,
                     .time = options->time + number / animation->fps,
                     .progress = animation->progress};
    if (!animation->is_film && !frame_pattern_path(&animation->output, number, path, error)) {
        return false;
    }
    if (options->skip_existing && access(path, F_OK) == 0) {
        progress_skip(animation->progress);
        return true;
    }
    bool is_there = animation->is_rendered ? render_frame(animation, &job, error)
                                           : read_frame(animation, number, error);
    return is_there && write_frame(animation, &job, error);
}

/** Makes all frames, until anything goes wrong or somebody interrupts. @return Whether all are
 *  there. */
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

/** Makes all frames and ends the film. */
static void animate(Animation *animation, Error *error) {
    int count = frame_range_count(&animation->frames);
    const atomic_bool *stop = interrupt_flag();
    animation->progress = progress_begin(animation->options, count);
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
