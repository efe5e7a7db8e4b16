/**
 * @file
 * @brief The child process that makes a film file of raw pictures.
 */
#include "assets/ffmpeg.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
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

/** Bytes of an encoder's words that are shown. */
enum { WORDS_SIZE = 400 };

bool ffmpeg_is_there(void) {
    const char *path = getenv("PATH");
    char file[PATH_MAX];
    while (path && *path) {
        int length = (int)strcspn(path, ":");
        snprintf(file, sizeof file, "%.*s/%s", length, path, FFMPEG_PROGRAM);
        if (access(file, X_OK) == 0) {
            return true;
        }
        path += length + (path[length] == ':');
    }
    return false;
}

/**
 * Says what an encoder finds when it starts: its pipe, its file for errors, no output, and signals
 * as usual, since this program ignores a broken pipe and the encoder should not.
 * @param encoder          The encoder; its files are open.
 * @param input            The pipe's end to read from.
 * @param[out] files       The files; to be destroyed.
 * @param[out] attributes  The signals and the process group; to be destroyed.
 */
static void arrange(const Ffmpeg *encoder, int input, posix_spawn_file_actions_t *files,
                    posix_spawnattr_t *attributes) {
    sigset_t all, none;
    sigfillset(&all);
    sigemptyset(&none);
    posix_spawn_file_actions_init(files);
    posix_spawn_file_actions_adddup2(files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(files, encoder->words, STDERR_FILENO);
    posix_spawnattr_init(attributes);
    posix_spawnattr_setsigdefault(attributes, &all);
    posix_spawnattr_setsigmask(attributes, &none);
    posix_spawnattr_setflags(attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK |
                                             POSIX_SPAWN_SETPGROUP);
}

/**
 * Starts the process.
 * @param[in,out] encoder  The encoder; its files are open.
 * @param input            The pipe's end to read from.
 * @param words            The command line.
 * @return 0, or an error number.
 */
static int spawn(Ffmpeg *encoder, int input, const char *const *words) {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    char *arguments[FFMPEG_WORDS_MAXIMUM];
    int count = 0;
    do {
        arguments[count] = (char *)(uintptr_t)words[count]; // posix_spawn changes nothing there.
    } while (words[count++]);
    arrange(encoder, input, &files, &attributes);
    int failed = posix_spawnp(&encoder->process, words[0], &files, &attributes, arguments, environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    return failed;
}

/** Closes what is open of an encoder's files. @param[in,out] encoder The encoder. */
static void close_files(Ffmpeg *encoder) {
    if (encoder->input >= 0) {
        close(encoder->input);
    }
    if (encoder->words >= 0) {
        close(encoder->words);
    }
    encoder->input = encoder->words = -1;
}

bool ffmpeg_start(Ffmpeg *encoder, const atomic_bool *stop, const char *const *words,
                  Error *error) {
    int ends[2];
    *encoder = (Ffmpeg){.input = -1, .stop = stop, .words = memfd_create("errors", MFD_CLOEXEC)};
    int failed = encoder->words < 0 || pipe2(ends, O_CLOEXEC) != 0 ? errno : 0;
    if (!failed) {
        encoder->input = ends[1];
        fcntl(ends[1], F_SETFL, O_NONBLOCK);
        failed = spawn(encoder, ends[0], words);
        close(ends[0]);
    }
    if (failed) {
        close_files(encoder);
        return error_set(error, STATUS_FAILED, "%s does not start: %s", words[0], strerror(failed));
    }
    return true;
}

/** @return Whether an encoder is not to be waited for any more. @param encoder The encoder. */
static bool is_stopped(const Ffmpeg *encoder) {
    return encoder->stop && atomic_load(encoder->stop);
}

/** Waits until an encoder takes bytes, but not for long. @param encoder The encoder. */
static void wait_for_room(const Ffmpeg *encoder) {
    /** Milliseconds until it is looked again whether to stop. */
    const int patience = 200;
    struct pollfd watched = {.fd = encoder->input, .events = POLLOUT};
    poll(&watched, 1, patience);
}

bool ffmpeg_feed(Ffmpeg *encoder, const void *bytes, size_t size) {
    const char *next = bytes;
    while (size > 0 && !is_stopped(encoder)) {
        ssize_t count = write(encoder->input, next, size);
        if (count < 0 && errno == EAGAIN) {
            wait_for_room(encoder);
        } else if (count < 0 && errno != EINTR) {
            return false;
        }
        next += count > 0 ? count : 0;
        size -= count > 0 ? (size_t)count : 0;
    }
    return size == 0;
}

/**
 * Waits until an encoder has ended; kills it where that is to be waited for no more.
 * @param[in,out] encoder  The encoder; ended.
 * @return As waitpid says it.
 */
static int reap(Ffmpeg *encoder) {
    int status = 0;
    do {
        if (is_stopped(encoder)) {
            kill(encoder->process, SIGKILL);
        }
    } while (waitpid(encoder->process, &status, 0) < 0 && errno == EINTR);
    encoder->process = 0;
    return status;
}

/**
 * Reads the first words that an encoder has said, on one line and without what moves a cursor.
 * @param encoder      The encoder.
 * @param[out] words   The words; empty if there are none.
 */
static void read_words(const Ffmpeg *encoder, char words[WORDS_SIZE]) {
    ssize_t count = pread(encoder->words, words, WORDS_SIZE - 1, 0);
    count = count > 0 ? count : 0;
    while (count > 0 && isspace((unsigned char)words[count - 1])) {
        count--;
    }
    words[count] = '\0';
    for (char *c = words; *c; c++) {
        *c = iscntrl((unsigned char)*c) ? ' ' : *c;
    }
}

bool ffmpeg_finish(Ffmpeg *encoder, Error *error) {
    char words[WORDS_SIZE];
    close(encoder->input);
    encoder->input = -1;
    int status = reap(encoder);
    read_words(encoder, words);
    close_files(encoder);
    if (WIFSIGNALED(status)) {
        return error_set(error, STATUS_FAILED, "ffmpeg died (%s)%s%s", strsignal(WTERMSIG(status)),
                         words[0] ? ": " : "", words);
    }
    if (WEXITSTATUS(status) != 0) {
        return error_set(error, STATUS_FAILED, "ffmpeg gave up (status %d)%s%s",
                         WEXITSTATUS(status), words[0] ? ": " : "", words);
    }
    return true;
}

void ffmpeg_kill(Ffmpeg *encoder) {
    if (encoder->process > 0) {
        kill(encoder->process, SIGKILL);
        reap(encoder);
        close_files(encoder);
    }
}
