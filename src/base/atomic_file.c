/**
 * @file
 * @brief Files that are written completely or not at all.
 */
#include "base/atomic_file.h"

#include "base/stale_files.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

/** Permissions of new files, reduced by the user's umask. */
enum { NEW_FILE_MODE = 0666 };
/** The permission bits of a file's mode. */
enum { PERMISSION_BITS = 0777 };

/** Sets an error from errno. A signal may end the wait for the reader of a FIFO. @return false,
 *  always. */
static bool set_system_error(Error *error) {
    if (errno == EINTR) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    return error_set(error, STATUS_FAILED, "%s", error_errno_text(errno));
}

/**
 * Creates a file that does not exist, and locks it as long as it is open: see #stale_files_remove.
 * @return The file descriptor, or -1 with errno set; EEXIST: the name is taken.
 */
static int create_locked(const char *path) {
    struct stat created;
    int descriptor = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, NEW_FILE_MODE);
    // Some file systems have no locks. Nothing is removed there.
    bool is_taken =
        descriptor >= 0 && flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    // Between both calls, another process may have taken it for stale.
    if (is_taken ||
        (descriptor >= 0 && fstat(descriptor, &created) == 0 && created.st_nlink == 0)) {
        close(descriptor);
        errno = EEXIST;
        return -1;
    }
    return descriptor;
}

/**
 * Creates the temporary file in the folder of the target, with an unused name. Files that killed
 * processes have left of the same target are removed.
 * @param[in,out] file  The file; its temporary path is set.
 * @return The file descriptor, or -1 with errno set.
 */
static int create_temporary(AtomicFile *file) {
    const char *path = file->target.path;
    stale_files_remove(path);
    for (int attempt = 0; attempt < TEMPORARY_ATTEMPTS; attempt++) {
        if (!temporary_path(path, getpid(), attempt, file->temporary_path)) {
            errno = ENAMETOOLONG;
            break;
        }
        int descriptor = create_locked(file->temporary_path);
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

/** @return Whether a file is synced. Devices and FIFOs need not be. */
static bool is_synced(const AtomicFile *file) {
    return file->mode != ATOMIC_REPLACE_UNSYNCED && file->temporary_path[0] != '\0';
}

/**
 * Waits until the bytes of a file are on the disk: a power cut after the rename must not leave a
 * new name without bytes.
 * @return 0, or -1 with errno set: the disk is full or broken. Pipes and some file systems cannot
 *         sync; that is no error.
 */
static int sync_bytes(const AtomicFile *file) {
    int failed = fflush(file->stream);
    if (!failed && is_synced(file) && fsync(fileno(file->stream)) != 0) {
        failed = errno == EIO || errno == ENOSPC || errno == EDQUOT ? -1 : 0;
    }
    return failed;
}

/** Waits until the name of a file is on the disk. The file is in its place: errors are ignored. */
static void sync_folder(const char *path) {
    char folder[PATH_MAX];
    snprintf(folder, PATH_MAX, "%.*s.", output_path_dir_length(path), path);
    int descriptor = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        fsync(descriptor);
        close(descriptor);
    }
}

/**
 * @return Why an earlier write failed, whose errno is lost: one byte more most likely fails for the
 *         same reason. It goes to files that are discarded, and to devices; not to pipes, which
 *         somebody reads.
 */
static int find_lost_reason(const AtomicFile *file) {
    struct stat status;
    int descriptor = fileno(file->stream);
    bool is_pipe =
        fstat(descriptor, &status) != 0 || !(S_ISREG(status.st_mode) || S_ISCHR(status.st_mode));
    return !is_pipe && write(descriptor, "", 1) < 0 ? errno : EIO;
}

/**
 * Closes the stream of a file with all its bytes.
 * @return 0, or -1 with errno set.
 */
static int close_stream(AtomicFile *file) {
    bool is_whole = !ferror(file->stream);
    int lost_reason = is_whole ? 0 : find_lost_reason(file);
    int failed = sync_bytes(file), reason = errno;
    if (fclose(file->stream) != 0 && !failed) {
        failed = -1;
        reason = errno;
    }
    file->stream = NULL;
    errno = is_whole ? reason : lost_reason;
    return is_whole ? failed : -1;
}

bool atomic_file_commit(AtomicFile *file, Error *error) {
    // A second descriptor keeps the lock until the file has its name.
    int lock = fcntl(fileno(file->stream), F_DUPFD_CLOEXEC, 0);
    bool is_renamed = close_stream(file) == 0 && rename_to_target(file) == 0;
    int reason = errno;
    if (lock >= 0) {
        close(lock);
    }
    if (!is_renamed) {
        errno = reason;
        set_system_error(error);
        atomic_file_discard(file);
        return false;
    }
    if (is_synced(file)) {
        sync_folder(file->target.path);
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
