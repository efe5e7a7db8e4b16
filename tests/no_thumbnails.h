/**
 * @file
 * @brief A list of scenes without pictures, which tests of the window open.
 */
#ifndef DIOPTRE_TESTS_NO_THUMBNAILS_H
#define DIOPTRE_TESTS_NO_THUMBNAILS_H

#include "dioptre/view.h"

/** @return No scene. See #ViewPreviewLoader. */
static inline Scene *load_nothing(void *context, const char *path, const atomic_bool *stop,
                                  RenderSettings *render, Error *error) {
    (void)context, (void)path, (void)stop, (void)render;
    error_set(error, STATUS_SCENE, "%s", "no picture");
    return NULL;
}

#endif
