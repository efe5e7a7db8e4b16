/**
 * @file
 * @brief Draws the rays of a pixel over the picture of a second camera.
 */
#ifndef DIOPTRE_VIEW_PANELS_RAY_OVERLAY_H
#define DIOPTRE_VIEW_PANELS_RAY_OVERLAY_H

#include "render/ray_pane.h"

#include <SDL.h>

/** What is drawn. */
typedef struct RayOverlay {
    const Vec3d *light_positions; /**< Positions of lights, which are marked. */
    size_t light_count;           /**< Number of #light_positions. */
    RayDrawing drawing;           /**< The rays; the target is set here. */
} RayOverlay;

/** A drawing that is kept until it changes. Starts as `{0}`: none. */
typedef struct OverlayImage {
    SDL_Texture *texture; /**< The drawing; NULL: it must be drawn; owned. */
    int width;            /**< Its size, pixels. */
    int height;           /**< The same. */
} OverlayImage;

/**
 * Shows rays, the camera and the lights; draws them first if the image has none of that size. Draws
 * nothing without memory.
 * @param rect  Rectangle of the second camera's picture, pixels of the window.
 */
void ray_overlay_show(OverlayImage *image, const RayOverlay *overlay, SDL_Renderer *renderer,
                      const SDL_Rect *rect);

/** Draws a drawing beside the rays into an image. @param width Its size, pixels. */
void ray_overlay_draw_pane(OverlayImage *image, RayPane pane, const RayPaneInput *input,
                           SDL_Renderer *renderer, int width, int height);

/** Frees the drawing: it has changed. */
void ray_overlay_release(OverlayImage *image);

/**
 * Marks a pixel by a cross that leaves the pixel itself free.
 * @param x     Centre of the pixel, pixels of the window.
 * @param y     See x.
 * @param size  Length of an arm, pixels of the window.
 */
void ray_overlay_mark_pixel(SDL_Renderer *renderer, double x, double y, double size);

#endif
