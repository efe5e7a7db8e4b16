/**
 * @file
 * @brief Names of temporary files, and removal of those that killed processes have left.
 */
#include "base/stale_files.h"

#include "base/output_path.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/magic.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

/**
 * Bytes of a file's name kept in its temporary name; with the ending, it stays below NAME_MAX
 * (255).
 */
enum { NAME_BYTES_KEPT = 200 };

/** Mark of the program in the names of temporary files: a file of the user's is never removed. */
#define PROGRAM_MARK ".dioptre-"

bool temporary_path(const char *target, pid_t process, int attempt, char path[PATH_MAX]) {
    int dir_length = output_path_dir_length(target);
    int length = snprintf(path, PATH_MAX, "%.*s%.*s" PROGRAM_MARK "%ld-%d", dir_length, target,
                          NAME_BYTES_KEPT, target + dir_length, (long)process, attempt);
    return length < PATH_MAX;
}

/**
 * @return Whether a folder lies on a file system of this machine alone, where locks and process
 *         numbers tell who writes. Unlisted ones count as shared.
 * @param folder  Its descriptor.
 */
static bool is_local(int folder) {
    /** ZFS, which linux/magic.h lacks. */
    enum { ZFS_MAGIC = 0x2FC12FC1 };
    static const long local[] = {EXT4_SUPER_MAGIC,      XFS_SUPER_MAGIC,  BTRFS_SUPER_MAGIC,
                                 F2FS_SUPER_MAGIC,      TMPFS_MAGIC,      RAMFS_MAGIC,
                                 OVERLAYFS_SUPER_MAGIC, ZFS_MAGIC,        REISERFS_SUPER_MAGIC,
                                 MSDOS_SUPER_MAGIC,     EXFAT_SUPER_MAGIC};
    struct statfs found;
    if (fstatfs(folder, &found) != 0) {
        return false;
    }
    for (size_t i = 0; i < sizeof local / sizeof *local; i++) {
        if ((long)found.f_type == local[i]) {
            return true;
        }
    }
    return false;
}

/**
 * Finds the process of a temporary file by its name.
 * @param name    The name of a file.
 * @param prefix  What the names of the target's temporary files begin with.
 * @return The process; 0: it is no temporary file of the target.
 */
static pid_t process_of(const char *name, const char *prefix) {
    size_t length = strlen(prefix);
    if (strncmp(name, prefix, length) != 0 || name[length] < '1' || name[length] > '9') {
        return 0;
    }
    char *end;
    errno = 0;
    long process = strtol(name + length, &end, 10);
    bool is_ours = errno == 0 && process <= INT_MAX && end[0] == '-' && end[1] >= '0' &&
                   end[1] <= '9' && end[2] == '\0';
    return is_ours ? (pid_t)process : 0;
}

/**
 * Removes a temporary file if nobody writes it.
 * @param folder  Descriptor of its folder.
 */
static void remove_unless_locked(int folder, const char *name) {
    struct stat opened, named;
    int file = openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    bool is_stale = file >= 0 && fstat(file, &opened) == 0 && S_ISREG(opened.st_mode) &&
                    opened.st_uid == geteuid() && flock(file, LOCK_EX | LOCK_NB) == 0;
    // Another process may have removed it and created one of that name before the lock.
    if (is_stale && fstatat(folder, name, &named, AT_SYMLINK_NOFOLLOW) == 0 &&
        named.st_ino == opened.st_ino && named.st_dev == opened.st_dev) {
        unlinkat(folder, name, 0);
    }
    if (file >= 0) {
        close(file);
    }
}

void stale_files_remove(const char *target) {
    char path[PATH_MAX], prefix[NAME_BYTES_KEPT + sizeof PROGRAM_MARK];
    int dir_length = output_path_dir_length(target);
    snprintf(path, PATH_MAX, "%.*s.", dir_length, target);
    snprintf(prefix, sizeof prefix, "%.*s" PROGRAM_MARK, NAME_BYTES_KEPT, target + dir_length);
    DIR *folder = opendir(path);
    if (!folder) {
        return;
    }
    for (struct dirent *entry; (entry = readdir(folder));) {
        pid_t process = process_of(entry->d_name, prefix);
        bool is_dead = process > 0 && kill(process, 0) != 0 && errno == ESRCH;
        if (is_dead && is_local(dirfd(folder))) {
            remove_unless_locked(dirfd(folder), entry->d_name);
        }
    }
    closedir(folder);
}
