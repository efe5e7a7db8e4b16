/**
 * @file
 * @brief What picture files say of their pictures; plain enough for the picture module, too.
 */
#ifndef DIOPTRE_IMAGE_METADATA_H
#define DIOPTRE_IMAGE_METADATA_H

/** Something that a picture file says of its picture. */
typedef struct MetadataEntry {
    const char *name;  /**< What it is, such as `Software`; as OpenImageIO names it. */
    const char *value; /**< The text, in one line. */
} MetadataEntry;

#endif
