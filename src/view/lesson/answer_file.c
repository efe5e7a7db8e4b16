/**
 * @file
 * @brief Appending answers as CSV: a locked file, one write per line.
 *
 * The programs of a class may share a file. Each holds its lock for one write only, so a lock that
 * stays is that of another kind of program, or of a machine that has hung: the window does not wait
 * for it.
 */
#include "view/lesson/answer_file.h"

#include <errno.h>
#include <fcntl.h>
#include <libintl.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/** Names of the columns. */
static const char HEADER[] = "time,lesson,question,choice,right\n";
/** Bytes of a line: a quoted name of a file, and the numbers. */
enum { LINE_SIZE = 2 * NAME_MAX + 128 };
/** How often a lock is tried for, and the time between, nanoseconds: half a second in all. */
enum { LOCK_TRIES = 50, LOCK_INTERVAL = 10000000 };
/** Permissions of a new file, before the user's mask. */
static const mode_t PERMISSIONS = 0666;

/** Writes a text at the end of a file. @return false with `errno` if not all is written. */
static bool write_all(int file, const char *text, size_t size) {
    ssize_t written = write(file, text, size);
    if (written >= 0 && (size_t)written < size) {
        errno = ENOSPC;
    }
    return written == (ssize_t)size;
}

/** Locks a file, and waits a little while others have it. @return false with `errno`. */
static bool lock_soon(int file) {
    for (int i = 0; i < LOCK_TRIES; i++) {
        if (flock(file, LOCK_EX | LOCK_NB) == 0) {
            return true;
        }
        if (errno != EWOULDBLOCK && errno != EINTR) {
            return false;
        }
        nanosleep(&(struct timespec){.tv_nsec = LOCK_INTERVAL}, NULL);
    }
    errno = EWOULDBLOCK;
    return false;
}

/** @return Whether a file ends within a line, as one that was cut or edited. One that can only be
 *  written is taken as it is. */
static bool ends_within_line(const char *path, off_t size) {
    char last = '\n';
    int file = size > 0 ? open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK) : -1;
    if (file >= 0) {
        bool is_read = pread(file, &last, 1, size - 1) == 1;
        close(file);
        return is_read && last != '\n';
    }
    return false;
}

/**
 * Appends a line to an open file, below the names of the columns.
 * @param file  The file, which is locked until it is closed.
 * @param path  Its name.
 * @param line  The line; empty: none.
 * @return false with `errno`.
 */
static bool append_locked(int file, const char *path, const char *line) {
    struct stat info;
    if (!lock_soon(file) || fstat(file, &info) != 0) {
        return false;
    }
    bool is_regular = S_ISREG(info.st_mode), is_empty = is_regular && info.st_size == 0;
    bool is_cut = is_regular && line[0] != '\0' && ends_within_line(path, info.st_size);
    bool is_written = (!is_empty || write_all(file, HEADER, sizeof HEADER - 1)) &&
                      (!is_cut || write_all(file, "\n", 1)) &&
                      (line[0] == '\0' || write_all(file, line, strlen(line)));
    int code = errno;
    if (!is_written && is_regular && ftruncate(file, info.st_size) == 0) {
        errno = code; // No half line stays.
    }
    return is_written;
}

/** Appends a line to a file. See #append_locked. */
static bool append(const char *path, const char *line, Error *error) {
    int file = open(path, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NONBLOCK, PERMISSIONS);
    bool is_written = file >= 0 && append_locked(file, path, line);
    int code = errno;
    if (file >= 0 && close(file) != 0 && is_written) {
        code = errno;
        is_written = false;
    }
    return is_written || error_set(error, STATUS_FAILED, "cannot write '%s': %s", path,
                                   code == EWOULDBLOCK ? gettext("another program has locked it")
                                                       : error_errno_text(code));
}

bool answer_file_prepare(const char *path, Error *error) {
    return append(path, "", error);
}

/**
 * Writes a name as a field of CSV, in quotes, each quote in it doubled. A name that a spreadsheet
 * would compute, as it begins like a formula, gets an apostrophe before it.
 */
static void quote_name(char *out, size_t size, const char *name) {
    size_t used = 0;
    out[used++] = '"';
    if (name[0] != '\0' && strchr("=+-@", name[0])) {
        out[used++] = '\'';
    }
    for (; *name && used + 3 < size; name++) {
        if (*name == '"') {
            out[used++] = '"';
        }
        out[used++] = (unsigned char)*name < ' ' ? ' ' : *name;
    }
    out[used++] = '"';
    out[used] = '\0';
}

bool answer_file_append(const char *path, const AnswerRecord *record, Error *error) {
    char name[2 * NAME_MAX + 4], moment[sizeof "-2147483648-12-31T23:59:60+0000"], line[LINE_SIZE];
    time_t now = time(NULL);
    struct tm calendar;
    if (!localtime_r(&now, &calendar) ||
        strftime(moment, sizeof moment, "%Y-%m-%dT%H:%M:%S%z", &calendar) == 0) {
        strcpy(moment, "");
    }
    quote_name(name, sizeof name, record->lesson);
    snprintf(line, sizeof line, "%s,%s,%zu,%d,%d\n", moment, name, record->question, record->answer,
             record->is_right);
    return append(path, line, error);
}
