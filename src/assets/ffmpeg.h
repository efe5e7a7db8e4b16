/**
 * @file
 * @brief The child process that makes a film file of raw pictures: ffmpeg.
 */
#ifndef ASSETS_FFMPEG_H
#define ASSETS_FFMPEG_H

#include "dioptre/error.h"

#include <stdatomic.h>
#include <stddef.h>
#include <sys/types.h>

/** Most words of its command line, with the NULL that ends them. */
enum { FFMPEG_WORDS_MAXIMUM = 64 };

/** A program that takes bytes and leaves a file. */
typedef struct Ffmpeg {
    pid_t process;           /**< The process; 0 once it is reaped. */
    int input;               /**< Pipe to its standard input; -1 once it is closed. */
    int words;               /**< Memory file that its errors go to. */
    const atomic_bool *stop; /**< It is not waited for any more once this is true; or NULL. */
} Ffmpeg;

/** The program, and the Debian package of the same name. */
#define FFMPEG_PROGRAM "ffmpeg"

/** @return Whether the program is there, in PATH, and may be run. */
bool ffmpeg_is_there(void);

/**
 * Starts an encoder, without a shell, in a process group of its own: a Ctrl-C is ours to answer.
 * @param[out] encoder  The encoder, to be ended with #ffmpeg_finish or #ffmpeg_kill.
 * @param stop          It is not waited for any more once this is true; may be NULL.
 * @param words         Its command line, #FFMPEG_PROGRAM first, ended by NULL.
 * @param[out] error    Why it cannot be started (#STATUS_FAILED).
 * @return Whether it runs.
 */
bool ffmpeg_start(Ffmpeg *encoder, const atomic_bool *stop, const char *const *words, Error *error);

/**
 * Hands bytes to an encoder, waiting until it has taken them.
 * @param encoder  The encoder.
 * @param bytes    The bytes.
 * @param size     How many.
 * @return false when it takes no more: it has ended, or is not waited for.
 */
bool ffmpeg_feed(Ffmpeg *encoder, const void *bytes, size_t size);

/**
 * Says that there are no more bytes, and waits until the encoder has ended.
 * @param[in,out] encoder  The encoder; ended.
 * @param[out] error       Why it has failed, in its own first words (#STATUS_FAILED).
 * @return Whether it has ended well.
 */
bool ffmpeg_finish(Ffmpeg *encoder, Error *error);

/** Kills an encoder, unless it has ended, and reaps it. @param[in,out] encoder The encoder; ended.
 */
void ffmpeg_kill(Ffmpeg *encoder);

#endif
