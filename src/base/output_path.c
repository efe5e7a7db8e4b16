/**
 * @file
 * @brief Targets of output paths.
 */
#include "base/output_path.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/** Largest number of symbolic links to follow, that of the Linux kernel. */
enum { LINKS_MAXIMUM = 40 };

/**
 * @return Whether a path names an open file of this process, such as `/dev/stdout`. Such paths look
 *         like symbolic links, but their targets, such as pipes, may have no name.
 */
static bool is_descriptor_path(const char *path) {
    static const char *const prefixes[] = {"/dev/std", "/dev/fd/", "/proc/"};
    for (size_t i = 0; i < sizeof prefixes / sizeof *prefixes; i++) {
        if (strncmp(path, prefixes[i], strlen(prefixes[i])) == 0) {
            return true;
        }
    }
    return false;
}

int output_path_dir_length(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? (int)(slash - path) + 1 : 0;
}

/**
 * Replaces the path of a symbolic link by that of its target, for one link.
 * @param[in,out] path  The path; unchanged if it is no link.
 * @return Whether it was a link that could be followed.
 */
static bool follow_link(char path[PATH_MAX]) {
    char target[PATH_MAX];
    ssize_t length = readlink(path, target, sizeof target - 1);
    if (length < 0) {
        return false;
    }
    target[length] = '\0';
    size_t start = target[0] == '/' ? 0 : (size_t)output_path_dir_length(path);
    if (start + (size_t)length >= PATH_MAX) {
        return false;
    }
    memcpy(path + start, target, (size_t)length + 1);
    return true;
}

/**
 * Follows all symbolic links at the end of a path.
 * @return false with errno set if they form a cycle.
 */
static bool follow_links(char path[PATH_MAX]) {
    for (int links = 0; links < LINKS_MAXIMUM; links++) {
        if (is_descriptor_path(path) || !follow_link(path)) {
            return true;
        }
    }
    errno = ELOOP;
    return false;
}

/**
 * Reads the mode of a target.
 * @param[in,out] output  The target; its mode is set.
 * @return false with errno set if it is a folder or not writable.
 */
static bool stat_output_path(OutputPath *output) {
    struct stat found;
    if (stat(output->path, &found) != 0) {
        output->mode = 0;
        return errno == ENOENT;
    }
    output->mode = found.st_mode;
    if (S_ISDIR(found.st_mode)) {
        errno = EISDIR;
        return false;
    }
    return faccessat(AT_FDCWD, output->path, W_OK, AT_EACCESS) == 0;
}

bool output_path_resolve(OutputPath *output, const char *path) {
    if (snprintf(output->path, PATH_MAX, "%s", path) >= PATH_MAX) {
        errno = ENAMETOOLONG;
        return false;
    }
    return follow_links(output->path) && stat_output_path(output);
}

bool output_path_is_direct(const OutputPath *output) {
    return output->mode != 0 && (is_descriptor_path(output->path) || !S_ISREG(output->mode));
}

bool output_path_dir_is_writable(const OutputPath *output) {
    char folder[PATH_MAX];
    int length = output_path_dir_length(output->path);
    snprintf(folder, PATH_MAX, "%.*s.", length, output->path);
    return faccessat(AT_FDCWD, folder, W_OK | X_OK, AT_EACCESS) == 0;
}
