/**
 * @file
 * @brief Films: pictures one after the other into a file, by ffmpeg, a program of its own.
 */
#ifndef DIOPTRE_ASSETS_FILM_H
#define DIOPTRE_ASSETS_FILM_H

#include "base/picture.h"

#include <stdatomic.h>

/** A film that is being written; its inside is its own. */
typedef struct Film Film;

/** How a film is to be. */
typedef struct FilmSettings {
    int width;               /**< Pixels, even. */
    int height;              /**< Pixels, even. */
    double fps;              /**< Frames a second. */
    const atomic_bool *stop; /**< Nothing is waited for any more once this is true; or NULL. */
} FilmSettings;

/** @return Whether a file's ending names a film: mp4 or webm. @param path The file. */
bool film_has_extension(const char *path);

/**
 * Says whether a film could be written to a path, before time is spent on drawing it.
 * @param path        The file, see #film_has_extension.
 * @param[out] error  What is wrong or missing (#STATUS_FAILED), such as ffmpeg.
 * @return Whether it could.
 */
bool film_check(const char *path, Error *error);

/**
 * Begins a film. It is written beside its place.
 * @param path        The file, see #film_has_extension.
 * @param settings       How it is to be.
 * @param[out] error  What is wrong (#STATUS_FAILED; #STATUS_USAGE for a size that is not even).
 * @return The film, to be ended with #film_commit or #film_discard; NULL if anything is wrong.
 */
Film *film_begin(const char *path, const FilmSettings *settings, Error *error);

/**
 * Adds a picture at the end.
 * @param film        The film.
 * @param picture     The picture, of the film's size.
 * @param[out] error  What is wrong (#STATUS_FAILED): the encoder's own words where it has any.
 * @return false when the film cannot be finished.
 */
bool film_add_frame(Film *film, const Picture *picture, Error *error);

/**
 * Ends a film and moves it into its place. Whatever fails, nothing is left of it.
 * @param film        The film; given back.
 * @param[out] error  What is wrong (#STATUS_FAILED), such as a full disk.
 * @return Whether it is there, all of it.
 */
bool film_commit(Film *film, Error *error);

/** Gives a film up: nothing is left of it. @param film The film, or NULL. */
void film_discard(Film *film);

#endif
