/**
 * @file
 * @brief Metadata of picture files; in plain C types, for the image plug-in, too.
 */
#ifndef DIOPTRE_BASE_IMAGE_METADATA_H
#define DIOPTRE_BASE_IMAGE_METADATA_H

/** An entry of metadata. */
typedef struct MetadataEntry {
    const char *name;  /**< Its name in OpenImageIO, such as `Software`. */
    const char *value; /**< The text, one line. */
} MetadataEntry;

#endif
