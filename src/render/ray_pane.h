/**
 * @file
 * @brief Drawings beside the view of rays: from above and from the side, the march of a ray, a hit
 * under the microscope.
 */
#ifndef DIOPTRE_RENDER_RAY_PANE_H
#define DIOPTRE_RENDER_RAY_PANE_H

#include "render/ray_drawing.h"

/** A drawing. */
typedef enum {
    RAY_PANE_NONE,       /**< None. */
    RAY_PANE_PLAN,       /**< The rays from above, and from the side of the camera ray. */
    RAY_PANE_MARCH,      /**< Free distances along the selected ray. */
    RAY_PANE_MICROSCOPE, /**< The hit of the selected ray. */
    RAY_PANE_COUNT       /**< Number of drawings. */
} RayPane;

/** What is drawn. */
typedef struct RayPaneInput {
    const Renderer *renderer; /**< Traced the rays; it draws the shapes. */
    const Scene *scene;       /**< Its scene. */
    const Engine *engine;     /**< Its engine. */
    RayDrawing drawing;       /**< The rays, with their target; the view is set here. */
    double text_size;         /**< Height of letters, pixels. */
} RayPaneInput;

/** Draws a drawing on a light ground. @param width Its size, pixels, from the target's origin. */
void ray_pane_draw(RayPane pane, const RayPaneInput *input, int width, int height);

/** A view by parallel light. */
typedef struct ParallelView {
    Vec3d right;   /**< To the right in the drawing; of length 1. */
    Vec3d up;      /**< Up in the drawing; of length 1. */
    Vec3d forward; /**< Into the drawing; of length 1. */
} ParallelView;

/** @return The view from above, with what is far from the camera ray's origin up. */
ParallelView ray_plan_view(void);

/** @return The view from the side of the camera ray: its vertical plane is the drawing's. */
ParallelView ray_side_view(const RayTree *tree);

/** Draws the rays by parallel light, and the shapes behind a plane just before the rays: what lies
 *  before it is cut away. @param width Of the drawing, pixels. */
void ray_pane_parallel(const RayPaneInput *input, const ParallelView *view, int width, int height);

#endif
