/**
 * @file
 * @brief The window's title: how the drawing stands.
 */
#ifndef DIOPTRE_VIEW_WINDOW_TITLE_H
#define DIOPTRE_VIEW_WINDOW_TITLE_H

#include "dioptre/renderer.h"

/** Longest title, bytes with the final zero; a longer one is cut. */
enum { TITLE_SIZE = 512 };

/** What the title tells of. */
typedef struct TitleContent {
    const char *name;          /**< Name of the scene. */
    int width;                 /**< Pixels of the picture. */
    int height;                /**< Pixels of the picture. */
    const RenderStats *report; /**< How the drawing stands; NULL before the first pass. */
    const double *time;        /**< The scene's time, seconds; NULL: it asks for none. */
    bool is_running;           /**< Whether it runs. */
    bool is_recording;         /**< Whether a lesson is recorded. */
    size_t light;              /**< Place of the light that the keys move. */
    size_t light_count;        /**< How many lights there are. */
    const char *status_text;   /**< What else is to be said; empty: nothing. */
} TitleContent;

/** Writes the title. */
void title_write(const TitleContent *content, char title[TITLE_SIZE]);

#endif
