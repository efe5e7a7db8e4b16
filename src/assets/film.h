/**
 * @file
 * @brief Films: sequences of pictures in one file, encoded by ffmpeg in a child process.
 */
#ifndef DIOPTRE_ASSETS_FILM_H
#define DIOPTRE_ASSETS_FILM_H

#include "base/picture.h"

#include <stdatomic.h>

/** A film being written; opaque. */
typedef struct Film Film;

/** Settings of a film. */
typedef struct FilmSettings {
    int width;               /**< Width in pixels, even. */
    int height;              /**< Height in pixels, even. */
    double fps;              /**< Frames per second. */
    const atomic_bool *stop; /**< Stop flag: once it is true, the encoder is killed; or NULL. */
} FilmSettings;

/** @return Whether a file's extension is that of a film: mp4 or webm. @param path The file. */
bool film_has_extension(const char *path);

/**
 * Checks whether a film can be written to a path, before it is rendered.
 * @param path        The file, see #film_has_extension.
 * @param[out] error  What is wrong (#STATUS_FAILED), such as missing ffmpeg.
 * @return Whether it can.
 */
bool film_check(const char *path, Error *error);

/**
 * Begins a film, in a temporary file.
 * @param path        The file, see #film_has_extension.
 * @param settings    Its settings.
 * @param[out] error  What is wrong (#STATUS_FAILED; #STATUS_USAGE for an odd size).
 * @return The film, to be ended with #film_commit or #film_discard; NULL on errors.
 */
Film *film_begin(const char *path, const FilmSettings *settings, Error *error);

/**
 * Appends a frame.
 * @param film        The film.
 * @param picture     The picture, of the film's size.
 * @param[out] error  What is wrong (#STATUS_FAILED), with the encoder's message if it has one.
 * @return false if the film cannot be completed.
 */
bool film_add_frame(Film *film, const Picture *picture, Error *error);

/**
 * Ends a film and renames it to its path. On failure, the temporary file is removed.
 * @param film        The film; freed.
 * @param[out] error  What is wrong (#STATUS_FAILED), such as a full disk.
 * @return Whether the film is complete.
 */
bool film_commit(Film *film, Error *error);

/** Frees a film and removes its file. @param film The film, or NULL. */
void film_discard(Film *film);

#endif
