/**
 * @file
 * @brief Opening of the files that a scene names.
 */
#include "script/asset_path.h"

#include "base/regular_file.h"

#include <errno.h>
#include <linux/openat2.h>
#include <stdio.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

/** Size of the path of a descriptor, `/proc/self/fd/N`. */
enum { DESCRIPTOR_PATH_SIZE = sizeof "/proc/self/fd/-2147483648" };

/**
 * Finds the folder of the files of a scene.
 * @param request   The request.
 * @param[out] dir  The folder as the user gave it, with a slash at its end; empty: the working
 *                  directory.
 */
static void find_base_dir(const ScriptRequest *request, char dir[PATH_MAX]) {
    if (request->base_dir) {
        snprintf(dir, PATH_MAX, "%s/", request->base_dir);
        return;
    }
    const char *slash = strrchr(request->path, '/');
    int length = slash ? (int)(slash + 1 - request->path) : 0;
    snprintf(dir, PATH_MAX, "%.*s", length, request->path);
}

/** @return Whether a path lies below a folder. */
static bool is_inside(const char *dir, const char *path) {
    size_t length = strlen(dir);
    if (strcmp(dir, "/") == 0) {
        return true;
    }
    return strncmp(dir, path, length) == 0 && path[length] == '/';
}

/** Formats the path by which this process can open what a descriptor refers to. */
static void format_descriptor_path(int file, char path[DESCRIPTOR_PATH_SIZE]) {
    snprintf(path, DESCRIPTOR_PATH_SIZE, "/proc/self/fd/%d", file);
}

/**
 * Finds the path of an open file.
 * @param file           Its descriptor.
 * @param[out] real_path Its absolute path without links.
 * @return false if the system does not tell it, as without `/proc`.
 */
static bool find_real_path(int file, char real_path[PATH_MAX]) {
    char link[DESCRIPTOR_PATH_SIZE];
    format_descriptor_path(file, link);
    ssize_t length = readlink(link, real_path, PATH_MAX);
    if (length <= 0 || length >= PATH_MAX) {
        return false;
    }
    real_path[length] = '\0';
    return true;
}

/**
 * Leaves out of a name what cancels out: parts of one dot, and of two with the part before them.
 * @param name           The name.
 * @param[out] shortened  What is left but the parts of two dots at its beginning, each part after a
 *                        slash.
 * @return Number of these parts of two dots.
 */
static int shorten_name(const char *name, char shortened[PATH_MAX + 1]) {
    size_t length = 0;
    int ups = 0;
    for (const char *part = name; *part;) {
        size_t size = strcspn(part, "/");
        bool is_up = size == 2 && strncmp(part, "..", 2) == 0;
        bool is_here = size == 0 || (size == 1 && *part == '.');
        if (is_up && length == 0) {
            ups++;
        } else if (is_up) {
            length = (size_t)((char *)memrchr(shortened, '/', length) - shortened);
        } else if (!is_here) {
            shortened[length] = '/';
            memcpy(shortened + length + 1, part, size);
            length += 1 + size;
        }
        part += size + (part[size] == '/');
    }
    shortened[length] = '\0';
    return ups;
}

/** @return The last parts of an absolute path, from the slash before them; NULL: it has fewer. */
static const char *last_parts(const char *path, int count) {
    const char *tail = path[1] != '\0' ? path + strlen(path) : NULL; // The root has none.
    while (tail && count-- > 0) {
        tail = memrchr(path, '/', (size_t)(tail - path));
    }
    return tail;
}

/**
 * Finds the name within a folder of a file that is named from outside, as `../scenes/die.png` from
 * the folder `scenes`. Nothing outside is looked at: a scene cannot find out what lies there.
 * @param folder       Descriptor of the folder.
 * @param name         The name.
 * @param[out] inside  The name, or that within the folder.
 * @return false if the file lies outside, or the path of the folder is not known.
 */
static bool find_name_inside(int folder, const char *name, char inside[PATH_MAX]) {
    char dir[PATH_MAX], shortened[PATH_MAX + 1]; // A slash goes before the first part.
    int ups = shorten_name(name, shortened);
    if (ups == 0) {
        // As it is: a part that cancels out may be a link, which leads elsewhere.
        snprintf(inside, PATH_MAX, "%s", name);
        return true;
    }
    const char *own = find_real_path(folder, dir) ? last_parts(dir, ups) : NULL;
    if (!own || !is_inside(own, shortened)) {
        return false;
    }
    snprintf(inside, PATH_MAX, "%s", shortened + strlen(own) + 1);
    return true;
}

/**
 * Opens a file, and then checks by its descriptor that it is beneath a folder. It serves where
 * openat2 does not: kernels before 5.6, and absolute links.
 * @param folder  Descriptor of the folder.
 * @param name    The name.
 * @return A descriptor for reading; -1 on errors, with errno. ENOENT says nothing about files
 *         outside.
 */
static int open_and_compare(int folder, const char *name) {
    char dir[PATH_MAX], path[PATH_MAX], link[DESCRIPTOR_PATH_SIZE];
    // O_PATH touches nothing: no device or FIFO outside notices it.
    int found = openat(folder, name, O_PATH | O_CLOEXEC);
    bool is_beneath = found >= 0 && find_real_path(folder, dir) && find_real_path(found, path) &&
                      is_inside(dir, path);
    bool is_exhausted = found < 0 && (errno == EMFILE || errno == ENFILE || errno == ENOMEM);
    int file = -1, failure = is_exhausted ? errno : ENOENT;
    if (is_beneath) {
        format_descriptor_path(found, link);
        file = open(link, REGULAR_FILE_FLAGS);
        failure = errno;
    }
    if (found >= 0) {
        close(found);
    }
    errno = failure;
    return file;
}

/** Opens a file beneath a folder. @return See #open_and_compare. */
static int open_beneath(int folder, const char *name) {
    char inside[PATH_MAX];
    if (!find_name_inside(folder, name, inside)) {
        errno = ENOENT;
        return -1;
    }
    const struct open_how how = {.flags = REGULAR_FILE_FLAGS,
                                 .resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS};
    int file = (int)syscall(SYS_openat2, folder, inside, &how, sizeof how);
    return file >= 0 ? file : open_and_compare(folder, inside);
}

int asset_path_open(const ScriptRequest *request, const char *name, char display_path[PATH_MAX],
                    char real_path[PATH_MAX], struct stat *info, Error *error) {
    char dir[PATH_MAX];
    find_base_dir(request, dir);
    bool is_short = snprintf(display_path, PATH_MAX, "%s%s", dir, name) < PATH_MAX;
    if (!is_short || name[0] == '/') {
        error_set(error, STATUS_SCENE, "its name must say where it is from the scene file");
        return -1;
    }
    int folder = open(dir[0] ? dir : ".", O_PATH | O_DIRECTORY | O_CLOEXEC);
    int file = folder >= 0 ? open_beneath(folder, name) : -1;
    int failure = errno;
    if (folder >= 0) {
        close(folder);
    }
    if (file < 0) {
        if (failure == ENOENT) {
            error_set(error, STATUS_SCENE,
                      "No such file in the scene's folder; files outside it are not read");
        } else {
            error_set_errno(error, failure);
        }
        return -1;
    }
    if (!regular_file_check(file, info, error)) {
        close(file);
        return -1;
    }
    if (!find_real_path(file, real_path)) {
        snprintf(real_path, PATH_MAX, "%s", display_path);
    }
    return file;
}
