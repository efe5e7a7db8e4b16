/**
 * @file
 * @brief Names of temporary files, and removal of those that killed processes have left.
 *
 * The temporary file of `NAME` is `NAME.dioptre-PID-N`: in the same folder, with the mark of the
 * program, the process and a digit.
 */
#ifndef DIOPTRE_BASE_STALE_FILES_H
#define DIOPTRE_BASE_STALE_FILES_H

#include <limits.h>
#include <stdbool.h>
#include <sys/types.h>

/** Number of temporary names per file and process: the digits. */
enum { TEMPORARY_ATTEMPTS = 10 };

/**
 * Writes the name of a temporary file.
 * @param target     The file to be written.
 * @param process    The process that writes it.
 * @param attempt    0 to #TEMPORARY_ATTEMPTS - 1.
 * @param[out] path  The path. A name is cut, so that it stays below NAME_MAX.
 * @return false if the path is too long.
 */
bool temporary_path(const char *target, pid_t process, int attempt, char path[PATH_MAX]);

/**
 * Removes temporary files of a target that no process writes any more. A file is removed only if
 * its name has exactly the form above, no process of that number runs here, it is a regular file of
 * this user, nobody holds its lock (flock), and it lies on a file system of this machine: what
 * another machine writes is never touched. Errors are ignored.
 * @param target  The file to be written.
 */
void stale_files_remove(const char *target);

#endif
