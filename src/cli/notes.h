/**
 * @file
 * @brief What a picture file says of how its picture came about.
 */
#ifndef DIOPTRE_CLI_NOTES_H
#define DIOPTRE_CLI_NOTES_H

#include "cli/options.h"

/** Most notes, with the one that ends them. */
enum { NOTES_MAXIMUM = 12 };
/** Bytes of a note's text. */
enum { NOTE_SIZE = 512 };

/** Notes of a picture, with their texts. Must stay where it is. */
typedef struct Notes {
    PictureNote rows[NOTES_MAXIMUM];      /**< The notes, ended by one without a name. */
    char texts[NOTES_MAXIMUM][NOTE_SIZE]; /**< Their texts. */
    int count;                            /**< How many. */
} Notes;

/**
 * Notes how a picture comes about. There is no date, no path and nothing of the machine in it: the
 * same scene and settings make the same file.
 * @param[out] notes  The notes.
 * @param options     The command line.
 * @param time        The scene's `t`, seconds.
 * @param settings    The settings.
 */
void notes_make(Notes *notes, const Options *options, double time, const RenderSettings *settings);

#endif
