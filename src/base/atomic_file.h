/**
 * @file
 * @brief Files that are written completely or not at all.
 *
 * The bytes are written to a temporary file in the same folder, which is renamed to the target when
 * they are on the disk. After a crash, a power cut or on a full disk, the old file is intact.
 * Devices and FIFOs, such as `/dev/stdout`, cannot be renamed and are written directly.
 */
#ifndef DIOPTRE_BASE_ATOMIC_FILE_H
#define DIOPTRE_BASE_ATOMIC_FILE_H

#include "base/error.h"
#include "base/output_path.h"

#include <stdio.h>

/** Treatment of an existing file. */
typedef enum {
    ATOMIC_REPLACE,          /**< It is replaced; if it is a symbolic link, its target is. */
    ATOMIC_REPLACE_UNSYNCED, /**< The same, without waiting for the disk: after a power cut, the new
                                file may be missing or empty. */
    ATOMIC_NEW               /**< It is kept: opening fails. */
} AtomicMode;

/** A file being written. */
typedef struct AtomicFile {
    FILE *stream;                  /**< Stream for its bytes; owned. */
    AtomicMode mode;               /**< Treatment of an existing file. */
    bool exists;                   /**< Whether #ATOMIC_NEW failed because the file exists. */
    OutputPath target;             /**< The target. */
    char temporary_path[PATH_MAX]; /**< Temporary file; empty: the target is written directly. */
} AtomicFile;

/**
 * Checks whether a file can be written, without writing.
 * @param path        The path.
 * @param[out] error  What is wrong (#STATUS_FAILED), without the path.
 * @return Whether #atomic_file_open with #ATOMIC_REPLACE would succeed.
 */
bool atomic_file_check(const char *path, Error *error);

/**
 * Opens a file for writing.
 * @param[out] file   The file, to be ended with #atomic_file_commit or #atomic_file_discard.
 * @param path        The path.
 * @param mode        Treatment of an existing file.
 * @param[out] error  What is wrong (#STATUS_FAILED), without the path.
 * @return Whether #AtomicFile.stream is open; if not, there is nothing to end.
 */
bool atomic_file_open(AtomicFile *file, const char *path, AtomicMode mode, Error *error);

/**
 * Closes a file and renames it to its target. On failure, the temporary file is removed.
 * @param[in,out] file  An open file with all its bytes.
 * @param[out] error    What is wrong (#STATUS_FAILED), such as a full disk, without the path.
 * @return Whether the file is complete.
 */
bool atomic_file_commit(AtomicFile *file, Error *error);

/** Closes a file and removes it. @param[in,out] file An open file. */
void atomic_file_discard(AtomicFile *file);

#endif
