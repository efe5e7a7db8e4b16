/**
 * @file
 * @brief A child process that reads bytes from a pipe and writes a file: ffmpeg, gnuplot.
 */
#ifndef DIOPTRE_BASE_PROCESS_PIPE_PROCESS_H
#define DIOPTRE_BASE_PROCESS_PIPE_PROCESS_H

#include "base/error.h"

#include <stdatomic.h>
#include <stddef.h>
#include <sys/types.h>

/** Largest number of words of a command line, with the final NULL. */
enum { PIPE_PROCESS_ARGUMENTS_MAXIMUM = 64 };

/** A program that reads bytes from a pipe. */
typedef struct PipeProcess {
    const char *name;        /**< Name of the program, as in #pipe_process_start. */
    pid_t pid;               /**< Process id; 0 once it is reaped. */
    int input_pipe;          /**< Pipe to its standard input; -1 once it is closed. */
    int error_file;          /**< Memory file of its standard error. */
    const atomic_bool *stop; /**< Stop flag: once it is true, the process is killed; or NULL. */
} PipeProcess;

/** @return Whether a program is in PATH and executable. @param name The program. */
bool pipe_process_is_installed(const char *name);

/**
 * Starts a program without a shell. It has its own process group, so that only this program
 * receives Ctrl-C.
 * @param[out] program  The program, to be ended with #pipe_process_finish or #pipe_process_kill.
 * @param stop          Stop flag: once it is true, the process is killed; may be NULL.
 * @param argv          Its command line, its name first, ended by NULL. The name must live as long
 *                      as the program runs.
 * @param[out] error    What is wrong (#STATUS_FAILED).
 * @return Whether it runs.
 */
bool pipe_process_start(PipeProcess *program, const atomic_bool *stop, const char *const *argv,
                        Error *error);

/**
 * Writes bytes to a program and waits until it has read them.
 * @param program  The program.
 * @param bytes    The bytes.
 * @param size     Their number.
 * @return false if the program has ended or its stop flag is set.
 */
bool pipe_process_write(PipeProcess *program, const void *bytes, size_t size);

/**
 * Closes the pipe and waits for the end of the program.
 * @param program     The program.
 * @param[out] error  What is wrong, with the start of the program's own messages (#STATUS_FAILED).
 * @return Whether its exit status is 0.
 */
bool pipe_process_finish(PipeProcess *program, Error *error);

/** Kills a program, unless it has ended, and reaps it. @param program The program. */
void pipe_process_kill(PipeProcess *program);

#endif
