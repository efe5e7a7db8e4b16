/**
 * @file
 * @brief Another program as a child process that takes bytes and leaves a file.
 */
#include "assets/program.h"

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
#include <unistd.h>

/** Bytes of a program's words that are shown. */
enum { WORDS_SIZE = 400 };

bool program_is_there(const char *name) {
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
 * Says what a program finds when it starts: its pipe, its file for errors, no output, and signals
 * as usual, since this program ignores a broken pipe and the program should not.
 * @param program          The program; its files are open.
 * @param input            The pipe's end to read from.
 * @param[out] files       The files; to be destroyed.
 * @param[out] attributes  The signals and the process group; to be destroyed.
 */
static void arrange(const Program *program, int input, posix_spawn_file_actions_t *files,
                    posix_spawnattr_t *attributes) {
    sigset_t all, none;
    sigfillset(&all);
    sigemptyset(&none);
    posix_spawn_file_actions_init(files);
    posix_spawn_file_actions_adddup2(files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(files, program->words, STDERR_FILENO);
    posix_spawnattr_init(attributes);
    posix_spawnattr_setsigdefault(attributes, &all);
    posix_spawnattr_setsigmask(attributes, &none);
    posix_spawnattr_setflags(attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK |
                                             POSIX_SPAWN_SETPGROUP);
}

/**
 * Starts the process.
 * @param[in,out] program  The program; its files are open.
 * @param input            The pipe's end to read from.
 * @param words            The command line.
 * @return 0, or an error number.
 */
static int spawn(Program *program, int input, const char *const *words) {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    char *arguments[PROGRAM_WORDS_MAXIMUM];
    int count = 0;
    do {
        arguments[count] = (char *)(uintptr_t)words[count]; // posix_spawn changes nothing there.
    } while (words[count++]);
    arrange(program, input, &files, &attributes);
    int failed = posix_spawnp(&program->process, words[0], &files, &attributes, arguments, environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    return failed;
}

/** Closes what is open of a program's files. @param[in,out] program The program. */
static void close_files(Program *program) {
    if (program->input >= 0) {
        close(program->input);
    }
    if (program->words >= 0) {
        close(program->words);
    }
    program->input = program->words = -1;
}

bool program_start(Program *program, const atomic_bool *stop, const char *const *words,
                   Error *error) {
    int ends[2];
    *program = (Program){
        .name = words[0], .input = -1, .stop = stop, .words = memfd_create("errors", MFD_CLOEXEC)};
    int failed = program->words < 0 || pipe2(ends, O_CLOEXEC) != 0 ? errno : 0;
    if (!failed) {
        program->input = ends[1];
        fcntl(ends[1], F_SETFL, O_NONBLOCK);
        failed = spawn(program, ends[0], words);
        close(ends[0]);
    }
    if (failed) {
        close_files(program);
        return error_set(error, STATUS_FAILED, "%s does not start: %s", words[0],
                         error_system(failed));
    }
    return true;
}

/** @return Whether a program is not to be waited for any more. @param program The program. */
static bool is_stopped(const Program *program) {
    return program->stop && atomic_load(program->stop);
}

/** Waits until a program takes bytes, but not for long. @param program The program. */
static void wait_for_room(const Program *program) {
    /** Milliseconds until it is looked again whether to stop. */
    const int patience = 200;
    struct pollfd watched = {.fd = program->input, .events = POLLOUT};
    poll(&watched, 1, patience);
}

bool program_feed(Program *program, const void *bytes, size_t size) {
    const char *next = bytes;
    while (size > 0 && !is_stopped(program)) {
        ssize_t count = write(program->input, next, size);
        if (count < 0 && errno == EAGAIN) {
            wait_for_room(program);
        } else if (count < 0 && errno != EINTR) {
            return false;
        }
        next += count > 0 ? count : 0;
        size -= count > 0 ? (size_t)count : 0;
    }
    return size == 0;
}

/**
 * Waits until a program has ended; kills it where that is to be waited for no more.
 * @param[in,out] program  The program; ended.
 * @return As waitpid says it.
 */
static int reap(Program *program) {
    int status = 0;
    do {
        if (is_stopped(program)) {
            kill(program->process, SIGKILL);
        }
    } while (waitpid(program->process, &status, 0) < 0 && errno == EINTR);
    program->process = 0;
    return status;
}

/**
 * Reads the first words that a program has said, on one line and without what moves a cursor.
 * @param program      The program.
 * @param[out] words   The words; empty if there are none.
 */
static void read_words(const Program *program, char words[WORDS_SIZE]) {
    ssize_t count = pread(program->words, words, WORDS_SIZE - 1, 0);
    count = count > 0 ? count : 0;
    while (count > 0 && isspace((unsigned char)words[count - 1])) {
        count--;
    }
    words[count] = '\0';
    for (char *c = words; *c; c++) {
        *c = iscntrl((unsigned char)*c) ? ' ' : *c;
    }
}

bool program_finish(Program *program, Error *error) {
    char words[WORDS_SIZE];
    close(program->input);
    program->input = -1;
    int status = reap(program);
    read_words(program, words);
    close_files(program);
    if (WIFSIGNALED(status)) {
        return error_set(error, STATUS_FAILED, "%s died (%s)%s%s", program->name,
                         strsignal(WTERMSIG(status)), words[0] ? gettext(": ") : "", words);
    }
    if (WEXITSTATUS(status) != 0) {
        return error_set(error, STATUS_FAILED, "%s gave up (status %d)%s%s", program->name,
                         WEXITSTATUS(status), words[0] ? gettext(": ") : "", words);
    }
    return true;
}

void program_kill(Program *program) {
    if (program->process > 0) {
        kill(program->process, SIGKILL);
        reap(program);
        close_files(program);
    }
}
