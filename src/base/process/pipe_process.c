/**
 * @file
 * @brief A child process that reads bytes from a pipe and writes a file.
 */
#include "base/process/pipe_process.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <libintl.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/** Largest size of a program's error message. */
enum { ERROR_TEXT_SIZE = 400 };

bool pipe_process_is_installed(const char *name) {
    const char *path = getenv("PATH");
    char file[PATH_MAX];
    while (path && *path) {
        int length = (int)strcspn(path, ":");
        snprintf(file, sizeof file, "%.*s/%s", length, path, name);
        if (access(file, X_OK) == 0) {
            return true;
        }
        path += length + (path[length] == ':');
    }
    return false;
}

/**
 * Sets the files and signals of a program: its pipe, its file for errors, no output, default
 * signals. This program ignores SIGPIPE, but its children must not.
 * @param program             The program; its files are open.
 * @param input               Read end of the pipe.
 * @param[in,out] files       The files; initialized, to be destroyed.
 * @param[in,out] attributes  The signals and the process group; initialized, to be destroyed.
 * @return 0, or an error number. Without its pipe, ffmpeg would read this program's input, and end
 *         in peace with a film of no frame.
 */
static int set_spawn_attributes(const PipeProcess *program, int input,
                                posix_spawn_file_actions_t *files, posix_spawnattr_t *attributes) {
    sigset_t all, none;
    sigfillset(&all);
    sigemptyset(&none);
    int failed = posix_spawn_file_actions_adddup2(files, input, STDIN_FILENO);
    failed = failed
                 ? failed
                 : posix_spawn_file_actions_addopen(files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    failed = failed ? failed
                    : posix_spawn_file_actions_adddup2(files, program->error_file, STDERR_FILENO);
    posix_spawnattr_setsigdefault(attributes, &all);
    posix_spawnattr_setsigmask(attributes, &none);
    posix_spawnattr_setflags(attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK |
                                             POSIX_SPAWN_SETPGROUP);
    return failed;
}

/**
 * Starts the process.
 * @param[in,out] program  The program; its files are open.
 * @param input            Read end of the pipe.
 * @param argv             Its command line, ended by NULL.
 * @return 0, or an error number.
 */
static int spawn_process(PipeProcess *program, int input, const char *const *argv) {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    char *arguments[PIPE_PROCESS_ARGUMENTS_MAXIMUM];
    int count = 0;
    do {
        arguments[count] = (char *)(uintptr_t)argv[count]; // posix_spawn does not change the
                                                           // strings.
    } while (argv[count++]);
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
    int failed = set_spawn_attributes(program, input, &files, &attributes);
    failed = failed ? failed
                    : posix_spawnp(&program->pid, argv[0], &files, &attributes, arguments, environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    return failed;
}

/** Closes the open files of a program. */
static void close_files(PipeProcess *program) {
    if (program->input_pipe >= 0) {
        close(program->input_pipe);
    }
    if (program->error_file >= 0) {
        close(program->error_file);
    }
    program->input_pipe = program->error_file = -1;
}

bool pipe_process_start(PipeProcess *program, const atomic_bool *stop, const char *const *argv,
                        Error *error) {
    int ends[2];
    *program = (PipeProcess){.name = argv[0],
                             .input_pipe = -1,
                             .stop = stop,
                             .error_file = memfd_create("errors", MFD_CLOEXEC)};
    int failed = program->error_file < 0 || pipe2(ends, O_CLOEXEC) != 0 ? errno : 0;
    if (!failed) {
        program->input_pipe = ends[1];
        fcntl(ends[1], F_SETFL, O_NONBLOCK);
        failed = spawn_process(program, ends[0], argv);
        close(ends[0]);
    }
    if (failed) {
        close_files(program);
        return error_set(error, STATUS_FAILED, "%s does not start: %s", argv[0],
                         error_errno_text(failed));
    }
    return true;
}

/** @return Whether a program's stop flag is set. */
static bool process_is_stopped(const PipeProcess *program) {
    return program->stop && atomic_load(program->stop);
}

/** Waits until a program's pipe is writable, for a limited time. */
static void wait_until_writable(const PipeProcess *program) {
    /** Milliseconds between two checks of the stop flag. */
    const int timeout = 200;
    struct pollfd watched = {.fd = program->input_pipe, .events = POLLOUT};
    poll(&watched, 1, timeout);
}

bool pipe_process_write(PipeProcess *program, const void *bytes, size_t size) {
    const char *next = bytes;
    while (size > 0 && !process_is_stopped(program)) {
        ssize_t count = write(program->input_pipe, next, size);
        if (count < 0 && errno == EAGAIN) {
            wait_until_writable(program);
        } else if (count < 0 && errno != EINTR) {
            return false;
        }
        next += count > 0 ? count : 0;
        size -= count > 0 ? (size_t)count : 0;
    }
    return size == 0;
}

/**
 * Waits for the end of a program; kills it if its stop flag is set. It looks again and again: the
 * signal that sets the flag may interrupt another thread than this one.
 * @return Its status as of waitpid.
 */
static int wait_for_exit(PipeProcess *program) {
    /** Nanoseconds between two looks, 5 ms: too short to be noticed at the end of a film. */
    const struct timespec interval = {.tv_nsec = 5000000};
    int status = 0;
    pid_t ended = 0;
    while (ended == 0 || (ended < 0 && errno == EINTR)) {
        if (process_is_stopped(program)) {
            kill(program->pid, SIGKILL);
        }
        ended = waitpid(program->pid, &status, WNOHANG);
        if (ended == 0) {
            nanosleep(&interval, NULL);
        }
    }
    program->pid = 0;
    return status;
}

/**
 * Reads the start of a program's error messages, as one line without control characters.
 * @param program    The program.
 * @param[out] text  The text; empty if there is none.
 */
static void read_error_text(const PipeProcess *program, char text[ERROR_TEXT_SIZE]) {
    ssize_t count = pread(program->error_file, text, ERROR_TEXT_SIZE - 1, 0);
    count = count > 0 ? count : 0;
    while (count > 0 && isspace((unsigned char)text[count - 1])) {
        count--;
    }
    text[count] = '\0';
    for (char *c = text; *c; c++) {
        *c = iscntrl((unsigned char)*c) ? ' ' : *c;
    }
}

bool pipe_process_finish(PipeProcess *program, Error *error) {
    char error_text[ERROR_TEXT_SIZE];
    close(program->input_pipe);
    program->input_pipe = -1;
    int status = wait_for_exit(program);
    read_error_text(program, error_text);
    close_files(program);
    if (WIFSIGNALED(status)) {
        return error_set(error, STATUS_FAILED, "%s died (%s)%s%s", program->name,
                         strsignal(WTERMSIG(status)), error_text[0] ? gettext(": ") : "",
                         error_text);
    }
    if (WEXITSTATUS(status) != 0) {
        return error_set(error, STATUS_FAILED, "%s gave up (status %d)%s%s", program->name,
                         WEXITSTATUS(status), error_text[0] ? gettext(": ") : "", error_text);
    }
    return true;
}

void pipe_process_kill(PipeProcess *program) {
    if (program->pid > 0) {
        kill(program->pid, SIGKILL);
        wait_for_exit(program);
        close_files(program);
    }
}
