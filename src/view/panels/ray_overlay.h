/**
 * @file
 * @brief Draws the rays of a pixel over the picture of a second camera.
 */
#ifndef DIOPTRE_VIEW_PANELS_RAY_OVERLAY_H
#define DIOPTRE_VIEW_PANELS_RAY_OVERLAY_H

#include "render/orbit_camera.h"

#include <SDL.h>

/** What is drawn. */
typedef struct RayOverlay {
    const Vec3d *light_positions; /**< Positions of lights, which are marked. */
    size_t light_count;           /**< Number of #light_positions. */
    const RayTree *ray_tree;      /**< The rays. */
    const OrbitCamera *orbit;     /**< The second camera's orbit. */
    size_t selected;              /**< Index of a ray that is drawn thicker. */
} RayOverlay;

/**
 * Draws rays, their numbers, the camera and the lights. Draws nothing without memory.
 * @param rect  Rectangle of the second camera's picture, pixels of the window.
 */
void ray_overlay_draw(const RayOverlay *overlay, SDL_Renderer *renderer, const SDL_Rect *rect);

/**
 * Marks a pixel by a cross that leaves the pixel itself free.
 * @param x     Centre of the pixel, pixels of the window.
 * @param y     See x.
 * @param size  Length of an arm, pixels of the window.
 */
void ray_overlay_mark_pixel(SDL_Renderer *renderer, double x, double y, double size);

#endif
