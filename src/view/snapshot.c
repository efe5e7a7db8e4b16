/**
 * @file
 * @brief Snapshots.
 */
#include "view/snapshot.h"

#include "dioptre/image_file.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

/**
 * Writes the path of a snapshot.
 * @param folder     Its folder.
 * @param name       First part of its name.
 * @param number     Its number, from 1.
 * @param[out] path  The path; within the folder `.` only the file's name.
 * @return false if that is too long for a path.
 */
static bool write_path(const char *folder, const char *name, int number,
                       char path[SNAPSHOT_PATH_SIZE]) {
    bool is_here = strcmp(folder, ".") == 0;
    int length = snprintf(path, SNAPSHOT_PATH_SIZE, "%s%s%s-%04d.bmp", is_here ? "" : folder,
                          is_here ? "" : "/", name, number);
    return length >= 0 && length < SNAPSHOT_PATH_SIZE;
}

/** @return Whether there is anything at a path, be it a broken link. @param path The path. */
static bool is_taken(const char *path) {
    struct stat information;
    return lstat(path, &information) == 0;
}

bool snapshot_write(const char *folder, const char *name, const Picture *picture,
                    char path[SNAPSHOT_PATH_SIZE], Error *error) {
    for (int number = 1; number <= SNAPSHOT_NUMBER_MAXIMUM; number++) {
        if (!write_path(folder, name, number, path)) {
            return error_set(error, STATUS_FAILED, "%.200s...: the path is too long", folder);
        }
        if (is_taken(path)) {
            continue;
        }
        bool exists = false;
        if (image_file_write_new(path, picture, &exists, error)) {
            return true;
        }
        /* Somebody else may have taken the number since it was looked at; then on to the next. */
        if (!exists) {
            return false;
        }
    }
    return error_set(error, STATUS_FAILED, "%s: no number is free for a snapshot", folder);
}

void snapshot_convert(const uint8_t *bgrx, Picture *picture) {
    size_t count = (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < count; i++) {
        picture->pixels[3 * i] = bgrx[4 * i + 2];
        picture->pixels[3 * i + 1] = bgrx[4 * i + 1];
        picture->pixels[3 * i + 2] = bgrx[4 * i];
    }
}
