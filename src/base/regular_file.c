/**
 * @file
 * @brief Opening of regular files without blocking.
 */
#include "base/regular_file.h"

#include "base/language.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

bool regular_file_check(int file, struct stat *info, Error *error) {
    if (fstat(file, info) != 0) {
        return error_set_errno(error, errno);
    }
    return S_ISREG(info->st_mode) ||
           error_set(error, STATUS_SCENE,
                     S_ISDIR(info->st_mode) ? N_("this is a folder, not a regular file")
                                            : N_("this is a pipe or a device, not a regular file"));
}

int regular_file_open(const char *path, struct stat *info, Error *error) {
    int file = open(path, REGULAR_FILE_FLAGS);
    if (file < 0) {
        error_set_errno(error, errno);
        return -1;
    }
    if (!regular_file_check(file, info, error)) {
        close(file);
        return -1;
    }
    return file;
}

bool regular_file_read(int file, char *bytes, size_t size, Error *error) {
    size_t done = 0;
    while (done < size) {
        ssize_t count = pread(file, bytes + done, size - done, (off_t)done);
        if (count < 0 && errno != EINTR) {
            return error_set_errno(error, errno);
        }
        if (count == 0) {
            return error_set(error, STATUS_SCENE, "it has become shorter");
        }
        done += count > 0 ? (size_t)count : 0;
    }
    return true;
}

bool regular_file_is_unchanged(int file, const struct stat *before, Error *error) {
    struct stat after;
    bool is_same = fstat(file, &after) == 0 && after.st_size == before->st_size &&
                   after.st_mtim.tv_sec == before->st_mtim.tv_sec &&
                   after.st_mtim.tv_nsec == before->st_mtim.tv_nsec;
    return is_same || error_set(error, STATUS_SCENE, "it has changed while it was read");
}
