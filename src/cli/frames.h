/**
 * @file
 * @brief The frames of a film: which, when, and what their files are called.
 */
#ifndef DIOPTRE_CLI_FRAMES_H
#define DIOPTRE_CLI_FRAMES_H

#include "dioptre/error.h"

#include <limits.h>
#include <stddef.h>

/** Frames a second where nothing is said: a whole number of milliseconds each. */
#define FRAMES_FPS_DEFAULT 25.0
/** Seconds of a film where nothing is said. */
#define FRAMES_SECONDS_DEFAULT 10.0
/** Most frames a second. */
#define FRAMES_FPS_MAXIMUM 1000.0
/** Largest number of a frame. */
enum { FRAMES_MAXIMUM = 99999999 };

/** Numbers from one to another: `A`, `A-B` or `A-B:STEP`. */
typedef struct FrameRange {
    int first; /**< The first number, from 0. */
    int last;  /**< The last, unless the steps go past it. */
    int step;  /**< From one to the next; below 0 from the end to the start. 0: nothing was said. */
} FrameRange;

/** Reads a range. @return Whether it is one, with at least one number. */
bool frame_range_parse(const char *text, FrameRange *range, Error *error);

/** @return How many frames a range has. */
int frame_range_count(const FrameRange *range);

/** A pattern of file names with one number, such as `frames/%05d.png`. */
typedef struct FramePattern {
    const char *text;    /**< The pattern; not owned. */
    size_t start;        /**< Bytes of it before the number. */
    size_t end;          /**< Where it goes on after the number. */
    int width;           /**< Digits of the number at least. */
    bool is_zero_padded; /**< Whether zeros, and not blanks, fill it up. */
} FramePattern;

/** @return Whether a path is meant as a pattern: there is a `%` in it. */
bool frame_pattern_is_in(const char *path);

/** Reads a pattern. It is never handed to printf. @return Whether there is one `%d`, perhaps with a
 *  width as in `%5d` or `%05d`, and no other `%`. */
bool frame_pattern_parse(const char *text, FramePattern *pattern, Error *error);

/**
 * Says what the file of a frame is called.
 * @param[out] error  That it is too long.
 * @return Whether it fits.
 */
bool frame_pattern_path(const FramePattern *pattern, int number, char path[PATH_MAX], Error *error);

#endif
