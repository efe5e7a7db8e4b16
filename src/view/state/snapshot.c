/**
 * @file
 * @brief Numbered files, and pictures in them.
 */
#include "view/state/snapshot.h"

#include "assets/images/image_file.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

/** Writes the path of a numbered file. @param number From 1. @return false if it is too long. */
static bool format_path(const NumberedFile *file, int number, char path[NUMBERED_FILE_PATH_SIZE]) {
    bool is_here = strcmp(file->folder, ".") == 0;
    int length =
        snprintf(path, NUMBERED_FILE_PATH_SIZE, "%s%s%s-%04d.%s", is_here ? "" : file->folder,
                 is_here ? "" : "/", file->name, number, file->extension);
    return length >= 0 && length < NUMBERED_FILE_PATH_SIZE;
}

/** @return Whether there is anything at a path, a broken link included. */
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
        // Another process may have used the number since the check; then the next one is tried.
        if (!exists) {
            return false;
        }
    }
    return error_set(error, STATUS_FAILED, "%s: no number is free for a file", file->folder);
}

/** Writes a picture. See #NumberedFile.write. */
static bool write_picture(const void *context, const char *path, bool *exists, Error *error) {
    return image_file_write_new(path, context, exists, error);
}

bool snapshot_write_as(const char *folder, const char *name, const char *extension,
                       const Picture *picture, char path[NUMBERED_FILE_PATH_SIZE], Error *error) {
    const NumberedFile file = {folder, name, extension, write_picture, picture};
    return numbered_file_write(&file, path, error);
}

bool snapshot_write(const char *folder, const char *name, const Picture *picture,
                    char path[NUMBERED_FILE_PATH_SIZE], Error *error) {
    return snapshot_write_as(folder, name, "bmp", picture, path, error);
}

void snapshot_from_bgrx(const uint8_t *bgrx, Picture *picture) {
    size_t count = (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < count; i++) {
        picture->pixels[3 * i] = bgrx[4 * i + 2];
        picture->pixels[3 * i + 1] = bgrx[4 * i + 1];
        picture->pixels[3 * i + 2] = bgrx[4 * i];
    }
}
