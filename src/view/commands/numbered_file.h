/**
 * @file
 * @brief Files with the first number that is free, never over another file.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_NUMBERED_FILE_H
#define DIOPTRE_VIEW_COMMANDS_NUMBERED_FILE_H

#include "dioptre/error.h"

/** Longest path of such a file, bytes with the final zero. */
enum { NUMBERED_FILE_PATH_SIZE = 4096 };

/** Highest number: a guard against looking for a free one for ever. */
enum { NUMBERED_FILE_MAXIMUM = 999999 };

/** What such a file is called, and who writes it. */
typedef struct NumberedFile {
    const char *folder;    /**< Its folder. */
    const char *name;      /**< First part of its name. */
    const char *extension; /**< Last part of its name. */
    /**
     * Writes it.
     * @param[out] exists  Whether there is such a file: nothing is written then.
     * @return Whether it is there, all of it.
     */
    bool (*write)(const void *context, const char *path, bool *exists, Error *error);
    const void *context; /**< Handed to it. */
} NumberedFile;

/**
 * Writes a file as FOLDER/NAME-0001.ENDING, with the first number that is free.
 * @param[out] path  The path that it got; within the folder `.` only its name.
 * @return Whether it is there, all of it.
 */
bool numbered_file_write(const NumberedFile *file, char path[NUMBERED_FILE_PATH_SIZE],
                         Error *error);

#endif
