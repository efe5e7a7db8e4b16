/**
 * @file
 * @brief The rays of a pixel, drawn over what a second camera sees.
 */
#ifndef DIOPTRE_VIEW_RAY_DRAWING_H
#define DIOPTRE_VIEW_RAY_DRAWING_H

#include "dioptre/ray_view.h"

#include <SDL.h>

/** What is drawn. */
typedef struct RayDrawing {
    const Vector3 *lamps; /**< Where lamps are, which are marked. */
    size_t lamp_count;    /**< How many. */
    const Probe *probe;   /**< The rays. */
    const RayView *view;  /**< How they are looked at. */
    size_t chosen;        /**< Which of them is drawn thicker. */
} RayDrawing;

/**
 * Draws rays, their numbers, the eye and the lamps.
 * @param drawing   What.
 * @param renderer  What draws in the window.
 * @param room      Where the picture of the second camera lies, pixels of the window.
 */
void ray_drawing_show(const RayDrawing *drawing, SDL_Renderer *renderer, const SDL_Rect *room);

/**
 * Marks a pixel by a cross that leaves it free.
 * @param renderer  What draws in the window.
 * @param x         Where its middle is, pixels of the window.
 * @param y         Where its middle is.
 * @param size      Length of an arm, pixels of the window.
 */
void ray_drawing_mark(SDL_Renderer *renderer, double x, double y, double size);

#endif
