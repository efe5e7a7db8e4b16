/**
 * @file
 * @brief Files that are written completely or not at all.
 */
#include "base/atomic_file.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/** Number of temporary names tried; names are only taken by files that a crash left. */
enum { ATTEMPTS_MAXIMUM = 1000 };
/**
 * Bytes of a file's name kept in its temporary name; with the ending, it stays below NAME_MAX
 * (255).
 */
enum { NAME_BYTES_KEPT = 200 };
/** Permissions of new files, reduced by the user's umask. */
enum { NEW_FILE_MODE = 0666 };
/** The permission bits of a file's mode. */
enum { PERMISSION_BITS = 0777 };

/** Sets an error from errno. @return false, always. */
static bool set_system_error(Error *error) {
    return error_set(error, STATUS_FAILED, "%s", error_errno_text(errno));
}

/**
 * Creates the temporary file in the folder of the target, with an unused name.
 * @param[in,out] file  The file; its temporary path is set.
 * @return The file descriptor, or -1 with errno set.
 */
static int create_temporary(AtomicFile *file) {
    const char *path = file->target.path;
    int dir_length = output_path_dir_length(path);
    for (int attempt = 0; attempt < ATTEMPTS_MAXIMUM; attempt++) {
        int length = snprintf(file->temporary_path, PATH_MAX, "%.*s%.*s.%ld-%d", dir_length, path,
                              NAME_BYTES_KEPT, path + dir_length, (long)getpid(), attempt);
        if (length >= PATH_MAX) {
            errno = ENAMETOOLONG;
            break;
        }
        int flags = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC;
        int descriptor = open(file->temporary_path, flags, NEW_FILE_MODE);
        if (descriptor >= 0 || errno != EEXIST) {
            return descriptor;
        }
    }
    return -1;
}

/**
 * Opens the file for writing where it may replace another: a temporary file, or a device directly.
 * @param[in,out] file  The file; its target is set.
 * @param path          The path.
 * @return The file descriptor, or -1 with errno set.
 */
static int open_for_replace(AtomicFile *file, const char *path) {
    if (!output_path_resolve(&file->target, path)) {
        return -1;
    }
    if (output_path_is_direct(&file->target)) {
        return open(file->target.path, O_WRONLY | O_APPEND | O_CLOEXEC);
    }
    int descriptor = create_temporary(file);
    if (descriptor >= 0 && file->target.mode != 0) {
        // Keep the permissions of the old file. Some file systems have none, so errors are ignored.
        (void)fchmod(descriptor, file->target.mode & PERMISSION_BITS);
    }
    return descriptor;
}

/**
 * Opens the file for writing where no other may exist, not even a broken link.
 * @param[in,out] file  The file; its target is set.
 * @param path          The path.
 * @return The file descriptor, or -1 with errno set.
 */
static int open_for_create(AtomicFile *file, const char *path) {
    struct stat found;
    file->exists = lstat(path, &found) == 0;
    if (file->exists) {
        errno = EEXIST;
        return -1;
    }
    if (snprintf(file->target.path, PATH_MAX, "%s", path) >= PATH_MAX) {
        errno = ENAMETOOLONG;
        return -1;
    }
    return create_temporary(file);
}

bool atomic_file_open(AtomicFile *file, const char *path, AtomicMode mode, Error *error) {
    *file = (AtomicFile){.mode = mode};
    int descriptor =
        mode == ATOMIC_NEW ? open_for_create(file, path) : open_for_replace(file, path);
    if (descriptor < 0) {
        return set_system_error(error);
    }
    file->stream = fdopen(descriptor, "wb");
    if (!file->stream) {
        set_system_error(error);
        close(descriptor);
        atomic_file_discard(file);
        return false;
    }
    return true;
}

bool atomic_file_check(const char *path, Error *error) {
    OutputPath target = {.mode = 0};
    bool can_be_written = output_path_resolve(&target, path) &&
                          (output_path_is_direct(&target) || output_path_dir_is_writable(&target));
    return can_be_written || set_system_error(error);
}

/**
 * Renames the temporary file without replacing another. Some file systems lack that operation; a
 * hard link has the same effect, as it fails if the name exists.
 * @return 0, or -1 with errno set.
 */
static int rename_without_replacing(const AtomicFile *file) {
    int failed =
        renameat2(AT_FDCWD, file->temporary_path, AT_FDCWD, file->target.path, RENAME_NOREPLACE);
    if (failed && (errno == EINVAL || errno == ENOSYS)) {
        failed = link(file->temporary_path, file->target.path);
        if (!failed) {
            unlink(file->temporary_path);
        }
    }
    return failed;
}

/** Renames the temporary file to the target. @return 0, or -1 with errno set. */
static int rename_to_target(AtomicFile *file) {
    if (file->mode == ATOMIC_NEW) {
        int failed = rename_without_replacing(file);
        file->exists = failed && errno == EEXIST;
        return failed;
    }
    return file->temporary_path[0] == '\0' ? 0 : rename(file->temporary_path, file->target.path);
}

bool atomic_file_commit(AtomicFile *file, Error *error) {
    bool is_whole = !ferror(file->stream);
    int failed = fclose(file->stream);
    file->stream = NULL;
    if (!is_whole && !failed) {
        errno = EIO; // An earlier write failed, and its errno is lost.
    }
    if (!is_whole || failed || rename_to_target(file) != 0) {
        set_system_error(error);
        atomic_file_discard(file);
        return false;
    }
    return true;
}

void atomic_file_discard(AtomicFile *file) {
    if (file->stream) {
        fclose(file->stream);
        file->stream = NULL;
    }
    if (file->temporary_path[0] != '\0') {
        unlink(file->temporary_path);
        file->temporary_path[0] = '\0';
    }
}
