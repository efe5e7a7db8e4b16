/**
 * @file
 * @brief Snapshots: the picture on screen into a file of its own.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_SNAPSHOT_H
#define DIOPTRE_VIEW_COMMANDS_SNAPSHOT_H

#include "dioptre/picture.h"
#include "view/commands/numbered_file.h"

/**
 * Writes a picture as NAME-0001.bmp, with the first number that is free, never over another file.
 * @param name  First part of its name.
 * @param[out] path  The path that it got.
 * @return Whether it is there, all of it.
 */
bool snapshot_write(const char *folder, const char *name, const Picture *picture,
                    char path[NUMBERED_FILE_PATH_SIZE], Error *error);

/**
 * Turns what a screen shows into a picture.
 * @param bgrx          Blue, green, red and an unused byte for each pixel, row by row, no gaps.
 * @param[out] picture  A picture of that size, made already; its pixels are written.
 */
void snapshot_from_bgrx(const uint8_t *bgrx, Picture *picture);

#endif
