/**
 * @file
 * @brief The rays of a pixel, drawn over what a second camera sees.
 */
#ifndef DIOPTRE_VIEW_PANELS_RAY_OVERLAY_H
#define DIOPTRE_VIEW_PANELS_RAY_OVERLAY_H

#include "render/orbit_camera.h"

#include <SDL.h>

/** What is drawn. */
typedef struct RayOverlay {
    const Vec3d *light_positions; /**< Where lamps are, which are marked. */
    size_t light_count;           /**< How many. */
    const RayTree *ray_tree;      /**< The rays. */
    const OrbitCamera *orbit;     /**< How they are looked at. */
    size_t selected;              /**< Which of them is drawn thicker. */
} RayOverlay;

/**
 * Draws rays, their numbers, the eye and the lamps.
 * @param renderer  What draws in the window.
 * @param rect  Where the picture of the second camera lies, pixels of the window.
 */
void ray_overlay_draw(const RayOverlay *overlay, SDL_Renderer *renderer, const SDL_Rect *rect);

/**
 * Marks a pixel by a cross that leaves it free.
 * @param renderer  What draws in the window.
 * @param x         Where its middle is, pixels of the window.
 * @param y         Where its middle is.
 * @param size      Length of an arm, pixels of the window.
 */
void ray_overlay_mark_pixel(SDL_Renderer *renderer, double x, double y, double size);

#endif
