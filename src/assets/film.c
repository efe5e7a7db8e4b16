/**
 * @file
 * @brief Films, by ffmpeg.
 *
 * The same pictures give the same bytes with the same version of ffmpeg and its libraries: one
 * encoding thread, no date and no encoder name in the file, and exact colour conversion instead of
 * the fast one, which depends on the processor.
 */
#include "assets/film.h"

#include "base/atomic_file.h"
#include "base/process/pipe_process.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

/** The program that encodes films, and the Debian package of the same name. */
#define FFMPEG_PROGRAM "ffmpeg"

/** A film format. */
typedef struct FilmFormat {
    const char *extension;     /**< Extension of the file name, without the dot. */
    const char *arguments[16]; /**< Arguments of ffmpeg for the encoder, ended by NULL. */
} FilmFormat;

/** All formats; NULL ends the list. */
static const FilmFormat formats[] = {
    {"mp4",
     {"-c:v", "libx264", "-preset", "medium", "-crf", "18", "-movflags", "+faststart", "-f",
      "mp4"}},
    {"webm",
     {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-deadline", "good", "-cpu-used", "4", "-f",
      "webm"}},
    {0},
};

struct Film {
    AtomicFile file;       /**< The output file. */
    PipeProcess encoder;   /**< The process of ffmpeg. */
    FilmSettings settings; /**< Settings. */
};

/** @return The format of a file's extension; NULL: unknown. */
static const FilmFormat *find_format(const char *path) {
    const char *dot = strrchr(path + output_path_dir_length(path), '.');
    for (const FilmFormat *format = formats; dot && format->extension; format++) {
        if (strcasecmp(dot + 1, format->extension) == 0) {
            return format;
        }
    }
    return NULL;
}

bool film_has_extension(const char *path) {
    return find_format(path) != NULL;
}

/** Adds the path to an error. @return false, always. */
static bool set_path_error(Error *error, const char *path) {
    return error_prefix(error, "cannot write '%s': ", path);
}

bool film_check(const char *path, Error *error) {
    if (!pipe_process_is_installed(FFMPEG_PROGRAM)) {
        error_set(error, STATUS_FAILED, "%s is missing: sudo apt-get install %s", FFMPEG_PROGRAM,
                  FFMPEG_PROGRAM);
        return set_path_error(error, path);
    }
    return atomic_file_check(path, error) || set_path_error(error, path);
}

/** Arguments for the input: raw frames from standard input. Any output of ffmpeg is an error. */
static const char *const input_arguments[] = {
    FFMPEG_PROGRAM, "-hide_banner", "-nostats", "-loglevel", "error", "-xerror",
    "-y",           "-f",           "rawvideo", "-pix_fmt",  "rgb24", NULL};
/** Arguments after frame size and rate. */
static const char *const pipe_arguments[] = {"-threads", "1", "-i", "pipe:0", NULL};
/** Arguments for the conversion to the colour space of video, with its tags. */
static const char *const color_arguments[] = {
    "-an",
    "-filter_threads",
    "1",
    "-vf",
    "scale=out_color_matrix=bt709:out_range=tv:flags=bitexact+accurate_rnd+full_chroma_int",
    "-pix_fmt",
    "yuv420p",
    "-colorspace",
    "bt709",
    "-color_primaries",
    "bt709",
    "-color_trc",
    "iec61966-2-1",
    "-color_range",
    "tv",
    NULL};
/** Arguments for reproducible output: one thread, no date, no version. */
static const char *const reproducible_arguments[] = {
    "-threads", "1", "-map_metadata", "-1", "-flags:v", "+bitexact", "-fflags", "+bitexact", NULL};

/** A command line under construction. */
typedef struct ArgumentList {
    const char *arguments[PIPE_PROCESS_ARGUMENTS_MAXIMUM]; /**< The arguments, ended by NULL. */
    int count;                                             /**< Number of arguments. */
} ArgumentList;

/** Appends arguments. @param list The command line. @param more The arguments, ended by NULL. */
static void add_arguments(ArgumentList *list, const char *const *more) {
    while (*more && list->count < PIPE_PROCESS_ARGUMENTS_MAXIMUM - 1) {
        list->arguments[list->count++] = *more++;
    }
}

/**
 * Starts the encoder of a film.
 * @param[in,out] film  The film; its file is open.
 * @param format        Its format.
 * @param[out] error    What is wrong.
 * @return Whether it runs.
 */
static bool start_encoder(Film *film, const FilmFormat *format, Error *error) {
    char size[32], rate[32], output[PATH_MAX + sizeof "file:"];
    snprintf(size, sizeof size, "%dx%d", film->settings.width, film->settings.height);
    snprintf(rate, sizeof rate, "%.17g", film->settings.fps);
    snprintf(output, sizeof output, "file:%s", film->file.temporary_path);
    ArgumentList command_line = {.count = 0};
    add_arguments(&command_line, input_arguments);
    add_arguments(&command_line,
                  (const char *const[]){"-video_size", size, "-framerate", rate, NULL});
    add_arguments(&command_line, pipe_arguments);
    add_arguments(&command_line, color_arguments);
    add_arguments(&command_line, reproducible_arguments);
    add_arguments(&command_line, format->arguments);
    add_arguments(&command_line, (const char *const[]){output, NULL});
    return pipe_process_start(&film->encoder, film->settings.stop, command_line.arguments, error);
}

/** @return Whether the size of a film is valid. */
static bool check_size(const FilmSettings *settings, Error *error) {
    int width = settings->width, height = settings->height;
    if (width % 2 != 0 || height % 2 != 0) {
        return error_set(error, STATUS_USAGE,
                         "a film's width and height are even numbers, not %dx%d; try --size %dx%d",
                         width, height, width + width % 2, height + height % 2);
    }
    return true;
}

/**
 * Opens the file of a film.
 * @return Whether it is open. Devices are rejected: encoders seek in their output.
 */
static bool open_film_file(Film *film, const char *path, Error *error) {
    if (!atomic_file_open(&film->file, path, ATOMIC_REPLACE, error)) {
        return false;
    }
    if (film->file.temporary_path[0] == '\0') {
        atomic_file_discard(&film->file);
        return error_set(error, STATUS_FAILED, "a film needs a plain file");
    }
    return true;
}

Film *film_begin(const char *path, const FilmSettings *settings, Error *error) {
    Film *film = calloc(1, sizeof *film);
    if (!film) {
        error_set(error, STATUS_FAILED, "no memory for a film");
        return NULL;
    }
    film->settings = *settings;
    bool is_open = check_size(settings, error) && open_film_file(film, path, error);
    if (!is_open || !start_encoder(film, find_format(path), error)) {
        if (is_open) {
            atomic_file_discard(&film->file);
        }
        free(film);
        set_path_error(error, path);
        return NULL;
    }
    return film;
}

bool film_add_frame(Film *film, const Picture *picture, Error *error) {
    size_t size = (size_t)picture->width * (size_t)picture->height * 3;
    if (picture->width != film->settings.width || picture->height != film->settings.height) {
        return error_set(error, STATUS_SCENE, "a frame of %dx%d in a film of %dx%d", picture->width,
                         picture->height, film->settings.width, film->settings.height);
    }
    if (pipe_process_write(&film->encoder, picture->pixels, size)) {
        return true;
    }
    if (pipe_process_finish(&film->encoder, error)) {
        error_set(error, STATUS_FAILED, "ffmpeg ended before the film did");
    }
    return set_path_error(error, film->file.target.path);
}

/**
 * @return Whether a film's file has content.
 * @param film        The film, after the end of ffmpeg.
 * @param[out] error  What is wrong.
 */
static bool check_written(const Film *film, Error *error) {
    struct stat found;
    bool is_written = fstat(fileno(film->file.stream), &found) == 0 && found.st_size > 0;
    return is_written || error_set(error, STATUS_FAILED, "ffmpeg wrote nothing");
}

bool film_commit(Film *film, Error *error) {
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s", film->file.target.path);
    bool is_written = pipe_process_finish(&film->encoder, error) && check_written(film, error);
    if (is_written) {
        is_written = atomic_file_commit(&film->file, error);
    } else {
        atomic_file_discard(&film->file);
    }
    free(film);
    return is_written || set_path_error(error, path);
}

void film_discard(Film *film) {
    if (film) {
        pipe_process_kill(&film->encoder);
        atomic_file_discard(&film->file);
        free(film);
    }
}
