/**
 * @file
 * @brief Ranges of frames, and patterns of their file names.
 */
#ifndef DIOPTRE_CLI_FRAMES_H
#define DIOPTRE_CLI_FRAMES_H

#include "base/error.h"

#include <limits.h>
#include <stddef.h>

/** Default frames per second: a whole number of milliseconds each. */
#define FRAMES_FPS_DEFAULT 25.0
/** Default length of a film, seconds. */
#define FRAMES_SECONDS_DEFAULT 10.0
/** Most frames per second. */
#define FRAMES_FPS_MAXIMUM 1000.0
/** Greatest number of a frame. */
enum { FRAMES_MAXIMUM = 99999999 };

/** A range of frames: `A`, `A-B` or `A-B:STEP`. */
typedef struct FrameRange {
    int first; /**< The first number, from 0. */
    int last;  /**< The last, unless the steps go past it. */
    int step;  /**< From one to the next; below 0: backwards; 0: unset. */
} FrameRange;

/** Parses a range. @return false if it is wrong or empty. */
bool frame_range_parse(const char *text, FrameRange *range, Error *error);

/** @return Number of frames of a range. */
int frame_range_count(const FrameRange *range);

/** A pattern of file names with one number, such as `frames/%05d.png`. */
typedef struct FramePattern {
    const char *text;    /**< The pattern; not owned. */
    size_t start;        /**< Bytes of it before the number. */
    size_t end;          /**< Where it goes on after the number. */
    int width;           /**< Least number of digits. */
    bool is_zero_padded; /**< Whether it is padded with zeros instead of blanks. */
} FramePattern;

/** @return Whether a path is a pattern: it has a `%`. */
bool frame_pattern_is_in(const char *path);

/** Parses a pattern, which is never passed to printf. @return false unless there is one `%d`,
 * perhaps with a width as in `%5d` or `%05d`, and no other `%`. */
bool frame_pattern_parse(const char *text, FramePattern *pattern, Error *error);

/**
 * Writes the file name of a frame.
 * @return false if it is too long.
 */
bool frame_pattern_path(const FramePattern *pattern, int number, char path[PATH_MAX], Error *error);

#endif
