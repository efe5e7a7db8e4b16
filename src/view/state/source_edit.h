/**
 * @file
 * @brief Writing the value of an object's field into the text of its scene file.
 */
#ifndef DIOPTRE_VIEW_STATE_SOURCE_EDIT_H
#define DIOPTRE_VIEW_STATE_SOURCE_EDIT_H

#include "base/error.h"

#include <stddef.h>

/** A field of a constructor such as `sphere { radius = 1 }`. */
typedef struct SourceField {
    const char *keyword; /**< Name of the constructor. */
    int line;            /**< Line of its call, from 1. */
    const char *name;    /**< Name of the field. */
    const char *value;   /**< Its new value, as a scene file has it. */
} SourceField;

/**
 * Replaces the value of a field, or adds the field. Nothing else of the text changes.
 * @param text           The text; no final zero is needed.
 * @param size           Its bytes.
 * @param[out] new_size  Bytes of the new text.
 * @param[out] error     Why the value cannot be written: the line has no constructor of its own, or
 *                       the value there is computed (#STATUS_SCENE).
 * @return The new text, to be freed with `free`; NULL if the value cannot be written.
 */
char *source_edit_set(const char *text, size_t size, const SourceField *field, size_t *new_size,
                      Error *error);

#endif
