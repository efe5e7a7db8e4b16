/**
 * @file
 * @brief What a picture file says of how its picture came about.
 */
#ifndef DIOPTRE_CLI_RENDER_METADATA_H
#define DIOPTRE_CLI_RENDER_METADATA_H

#include "cli/options.h"

/** Most notes, with the one that ends them. */
enum { RENDER_METADATA_MAXIMUM = 12 };
/** Bytes of a note's text. */
enum { RENDER_METADATA_TEXT_SIZE = 512 };

/** Notes of a picture, with their texts. Must stay where it is. */
typedef struct RenderMetadata {
    MetadataEntry entries[RENDER_METADATA_MAXIMUM]; /**< The notes, ended by one without a name. */
    char texts[RENDER_METADATA_MAXIMUM][RENDER_METADATA_TEXT_SIZE]; /**< Their texts. */
    int count;                                                      /**< How many. */
} RenderMetadata;

/** Notes how a picture comes about. There is no date, no path and nothing of the machine in it: the
 *  same scene and settings make the same file. @param time The scene's `t`, seconds. */
void render_metadata_init(RenderMetadata *metadata, const Options *options, double time,
                          const RenderSettings *settings);

#endif
