/**
 * @file
 * @brief Another program as a child process that takes bytes and leaves a file: ffmpeg, gnuplot.
 */
#ifndef DIOPTRE_BASE_PROCESS_PIPE_PROCESS_H
#define DIOPTRE_BASE_PROCESS_PIPE_PROCESS_H

#include "base/error.h"

#include <stdatomic.h>
#include <stddef.h>
#include <sys/types.h>

/** Most words of its command line, with the NULL that ends them. */
enum { PIPE_PROCESS_ARGUMENTS_MAXIMUM = 64 };

/** A program that takes bytes and leaves a file. */
typedef struct PipeProcess {
    const char *name;        /**< The program, as in #pipe_process_start. */
    pid_t pid;               /**< The process; 0 once it is reaped. */
    int input_pipe;          /**< Pipe to its standard input; -1 once it is closed. */
    int error_file;          /**< Memory file that its errors go to. */
    const atomic_bool *stop; /**< It is not waited for any more once this is true; or NULL. */
} PipeProcess;

/** @return Whether a program is there, in PATH, and may be run. */
bool pipe_process_is_installed(const char *name);

/**
 * Starts a program, without a shell, in a process group of its own: a Ctrl-C is ours to answer.
 * @param[out] program  The program, to be ended with #pipe_process_finish or #pipe_process_kill.
 * @param stop          It is not waited for any more once this is true; may be NULL.
 * @param argv         Its command line, its name first, ended by NULL. The name must live as long
 *                      as it runs.
 * @param[out] error    Why it cannot be started (#STATUS_FAILED).
 * @return Whether it runs.
 */
bool pipe_process_start(PipeProcess *program, const atomic_bool *stop, const char *const *argv,
                        Error *error);

/** Hands bytes to a program, waiting until it has taken them. @return false when it takes no more:
 *  it has ended, or is not waited for. */
bool pipe_process_write(PipeProcess *program, const void *bytes, size_t size);

/**
 * Says that there are no more bytes, and waits until the program has ended.
 * @param[out] error  Why it has failed, in its own first words (#STATUS_FAILED).
 * @return Whether it has ended well.
 */
bool pipe_process_finish(PipeProcess *program, Error *error);

/** Kills a program, unless it has ended, and reaps it. */
void pipe_process_kill(PipeProcess *program);

#endif
