/**
 * @file
 * @brief Files that are there whole or not at all.
 *
 * The bytes go into a file of another name in the same folder, which is renamed into its place
 * when all of them are written: a crash or a full disk never leaves half a file, nor harms the old
 * one. What is no plain file, such as `/dev/stdout` or a FIFO, cannot be renamed over, and is
 * written to directly.
 */
#ifndef DIOPTRE_BASE_ATOMIC_FILE_H
#define DIOPTRE_BASE_ATOMIC_FILE_H

#include "base/error.h"
#include "base/output_path.h"

#include <stdio.h>

/** What happens to a file that is there already. */
typedef enum {
    ATOMIC_REPLACE, /**< It is replaced; where it is a symbolic link, what it points to. */
    ATOMIC_NEW      /**< It stays as it is: to find one is a failure. */
} AtomicMode;

/** A file on its way to its place. */
typedef struct AtomicFile {
    FILE *stream;                  /**< Where to write; owned. */
    AtomicMode mode;               /**< What happens to a file that is there already. */
    bool exists;                   /**< Whether #ATOMIC_NEW failed because there is such a file. */
    OutputPath target;             /**< Where it will be. */
    char temporary_path[PATH_MAX]; /**< Where it is meanwhile; empty: written to its place directly.
                                    */
} AtomicFile;

/**
 * Says whether a file could be written, without writing anything.
 * @param[out] error  Why not (#STATUS_FAILED); the path is not named in it.
 * @return Whether #atomic_file_open with #ATOMIC_REPLACE would do.
 */
bool atomic_file_check(const char *path, Error *error);

/**
 * Begins a file.
 * @param[out] file  The file, to be ended with #atomic_file_commit or #atomic_file_discard.
 * @param mode  What happens to a file that is there already.
 * @param[out] error  Why not (#STATUS_FAILED); the path is not named in it.
 * @return Whether AtomicFile.stream can be written to; otherwise there is nothing to end.
 */
bool atomic_file_open(AtomicFile *file, const char *path, AtomicMode mode, Error *error);

/**
 * Ends a file: closes it and moves it into its place. Whatever fails, nothing is left of it.
 * @param[in,out] file  A file that was begun, with all its bytes.
 * @param[out] error    Why not (#STATUS_FAILED), such as a full disk; the path is not named in it.
 * @return Whether it is in its place, all of it.
 */
bool atomic_file_commit(AtomicFile *file, Error *error);

/** Gives a file up: nothing is left of it. @param[in,out] file A file that was begun. */
void atomic_file_discard(AtomicFile *file);

#endif
