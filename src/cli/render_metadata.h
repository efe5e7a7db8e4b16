/**
 * @file
 * @brief Metadata of a rendered picture: its scene and settings.
 */
#ifndef DIOPTRE_CLI_RENDER_METADATA_H
#define DIOPTRE_CLI_RENDER_METADATA_H

#include "cli/options.h"

/** Most entries, with the one that ends them. */
enum { RENDER_METADATA_MAXIMUM = 14 };
/** Bytes of a text. */
enum { RENDER_METADATA_TEXT_SIZE = 512 };

/** Metadata with its texts. It must not move. */
typedef struct RenderMetadata {
    MetadataEntry entries[RENDER_METADATA_MAXIMUM]; /**< The entries, ended by an empty one. */
    char texts[RENDER_METADATA_MAXIMUM][RENDER_METADATA_TEXT_SIZE]; /**< Their texts. */
    int count;                                                      /**< Number of entries. */
} RenderMetadata;

/** Initialises the metadata of a picture. They hold no date, no path and nothing of the machine, so
 *  the same scene and settings make the same file. @param time The scene's `t`, seconds. */
void render_metadata_init(RenderMetadata *metadata, const Options *options, double time,
                          const RenderSettings *settings);

#endif
