/**
 * @file
 * @brief Lessons as text: what a recording writes.
 */
#ifndef DIOPTRE_VIEW_LESSON_LESSON_WRITER_H
#define DIOPTRE_VIEW_LESSON_LESSON_WRITER_H

#include "dioptre/renderer.h"

#include <stdint.h>
#include <stdio.h>

/** What the first words of a lesson tell. */
typedef struct LessonHeader {
    const char *scene;            /**< The scene's file, as seen from the lesson's folder. */
    const char *name;             /**< Its name. */
    double time;                  /**< Its `t`, seconds. */
    const RenderSettings *render; /**< How it is drawn. */
    int width;                    /**< The window's, in the screen's units. */
    int height;                   /**< The window's. */
} LessonHeader;

/** Writes the first words. */
void lesson_writer_begin(FILE *file, const LessonHeader *header);

/** Writes how long nothing happens. @param milliseconds How long; 0: nothing is written. */
void lesson_writer_wait(FILE *file, int64_t milliseconds);

/** Writes a caption. */
void lesson_writer_caption(char *step, size_t size, const char *caption);

#endif
