/**
 * @file
 * @brief Opening of regular files without blocking.
 */
#include "base/regular_file.h"

#include "base/language.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

/**
 * Checks that an open file is a regular file.
 * @param file        Its descriptor.
 * @param[out] info   Its properties.
 * @param[out] error  What is wrong.
 * @return Whether it is.
 */
static bool check_regular(int file, struct stat *info, Error *error) {
    if (fstat(file, info) != 0) {
        return error_set(error, STATUS_SCENE, "%s", error_errno_text(errno));
    }
    return S_ISREG(info->st_mode) ||
           error_set(error, STATUS_SCENE,
                     S_ISDIR(info->st_mode) ? N_("this is a folder, not a regular file")
                                            : N_("this is a pipe or a device, not a regular file"));
}

int regular_file_open(const char *path, struct stat *info, Error *error) {
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (file < 0) {
        error_set(error, STATUS_SCENE, "%s", error_errno_text(errno));
        return -1;
    }
    if (!check_regular(file, info, error)) {
        close(file);
        return -1;
    }
    return file;
}

bool regular_file_is_unchanged(int file, const struct stat *before, Error *error) {
    struct stat after;
    bool is_same = fstat(file, &after) == 0 && after.st_size == before->st_size &&
                   after.st_mtim.tv_sec == before->st_mtim.tv_sec &&
                   after.st_mtim.tv_nsec == before->st_mtim.tv_nsec;
    return is_same || error_set(error, STATUS_SCENE, "it has changed while it was read");
}
