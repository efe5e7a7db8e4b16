/**
 * @file
 * @brief Numbered files.
 */
#include "view/commands/numbered_file.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

/**
 * Writes the path of a file.
 * @param number  Its number, from 1.
 * @param[out] path  The path; within the folder `.` only the file's name.
 * @return false if that is too long for a path.
 */
static bool format_path(const NumberedFile *file, int number, char path[NUMBERED_FILE_PATH_SIZE]) {
    bool is_here = strcmp(file->folder, ".") == 0;
    int length =
        snprintf(path, NUMBERED_FILE_PATH_SIZE, "%s%s%s-%04d.%s", is_here ? "" : file->folder,
                 is_here ? "" : "/", file->name, number, file->extension);
    return length >= 0 && length < NUMBERED_FILE_PATH_SIZE;
}

/** @return Whether there is anything at a path, be it a broken link. */
static bool path_exists(const char *path) {
    struct stat information;
    return lstat(path, &information) == 0;
}

bool numbered_file_write(const NumberedFile *file, char path[NUMBERED_FILE_PATH_SIZE],
                         Error *error) {
    for (int number = 1; number <= NUMBERED_FILE_MAXIMUM; number++) {
        if (!format_path(file, number, path)) {
            return error_set(error, STATUS_FAILED, "%.200s...: the path is too long", file->folder);
        }
        if (path_exists(path)) {
            continue;
        }
        bool exists = false;
        if (file->write(file->context, path, &exists, error)) {
            return true;
        }
        /* Somebody else may have taken the number since it was looked at; then on to the next. */
        if (!exists) {
            return false;
        }
    }
    return error_set(error, STATUS_FAILED, "%s: no number is free for a file", file->folder);
}
