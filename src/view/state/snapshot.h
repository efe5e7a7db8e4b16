/**
 * @file
 * @brief Snapshots and recorded lessons: files with the first free number, never over another file.
 */
#ifndef DIOPTRE_VIEW_STATE_SNAPSHOT_H
#define DIOPTRE_VIEW_STATE_SNAPSHOT_H

#include "base/picture.h"

/** Longest path of a numbered file, bytes with the final zero. */
enum { NUMBERED_FILE_PATH_SIZE = 4096 };

/** Highest number of a file: ends the search for a free one. */
enum { NUMBERED_FILE_MAXIMUM = 999999 };

/** The name of a numbered file, and what writes it. */
typedef struct NumberedFile {
    const char *folder;    /**< Its folder. */
    const char *name;      /**< First part of its name. */
    const char *extension; /**< Last part of its name. */
    /**
     * Writes the file.
     * @param[out] exists  Whether there is such a file already: nothing is written then.
     * @return Whether it is written completely.
     */
    bool (*write)(const void *context, const char *path, bool *exists, Error *error);
    const void *context; /**< First argument of #write. */
} NumberedFile;

/**
 * Writes a file as FOLDER/NAME-0001.EXTENSION, with the first free number.
 * @param[out] path  Its path; in the folder `.` only its name.
 * @return Whether it is written completely.
 */
bool numbered_file_write(const NumberedFile *file, char path[NUMBERED_FILE_PATH_SIZE],
                         Error *error);

/**
 * Writes a picture as NAME-0001.EXTENSION, with the first free number.
 * @param name       First part of its name.
 * @param extension  Of a format that pictures are written in.
 * @param[out] path  Its path.
 * @return Whether it is written completely.
 */
bool snapshot_write_as(const char *folder, const char *name, const char *extension,
                       const Picture *picture, char path[NUMBERED_FILE_PATH_SIZE], Error *error);

/** Writes a picture as NAME-0001.bmp. See #snapshot_write_as. */
bool snapshot_write(const char *folder, const char *name, const Picture *picture,
                    char path[NUMBERED_FILE_PATH_SIZE], Error *error);

/**
 * Converts the pixels of the screen to those of a picture.
 * @param bgrx  Blue, green, red and an unused byte per pixel, row by row, without gaps.
 * @param[in,out] picture  A picture of that size; its pixels are written.
 */
void snapshot_from_bgrx(const uint8_t *bgrx, Picture *picture);

#endif
