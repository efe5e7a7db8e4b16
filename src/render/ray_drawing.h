/**
 * @file
 * @brief Draws the rays of a pixel with cairo: over a picture in the window, or into an SVG file.
 *
 * A drawing's units are the pixels of its #RayDrawing.view.
 */
#ifndef DIOPTRE_RENDER_RAY_DRAWING_H
#define DIOPTRE_RENDER_RAY_DRAWING_H

#include "render/orbit_camera.h"

#include <cairo.h>

/** How a kind of rays is drawn: in colours that the colour-blind tell apart (Okabe, Ito, *Color
 *  Universal Design*, 2008), and by dashes. */
typedef struct RayStyle {
    unsigned color;   /**< 0xRRGGBB. */
    double dash;      /**< Length of a dash, in widths of the line; 0: the line is solid. */
    double gap;       /**< Length of a gap, in widths of the line. */
    const char *name; /**< What it is called, in English. */
} RayStyle;

/** How many styles there are. */
enum { RAY_STYLE_COUNT = 5 };

/** @return All styles, in the order of a legend. */
const RayStyle *ray_styles(void);

/** @return How a ray is drawn. */
const RayStyle *ray_style(const RayTreeNode *ray);

/** @return Whether any ray of a tree is drawn in a style. */
bool ray_style_is_used(const RayTree *tree, const RayStyle *style);

/** Colours of what #ray_drawing_mark marks: 0xRRGGBB. */
enum { RAY_MARK_EYE = 0xffffff, RAY_MARK_LIGHT = 0xf0e442 };

/** In place of the index of a selected ray: there is none. */
#define RAY_DRAWING_UNSELECTED SIZE_MAX

/** A drawing. */
typedef struct RayDrawing {
    cairo_t *cairo;           /**< Draws it. */
    const RayTree *tree;      /**< The rays. */
    const OrbitCamera *orbit; /**< The camera's orbit. */
    ProjectedView view;       /**< What the camera sees. */
    size_t selected;          /**< Index of a ray that is drawn thicker. */
} RayDrawing;

/** Draws all rays, each with a light border, an arrowhead, and its index in the tree. */
void ray_drawing_rays(const RayDrawing *drawing);

/** Marks a point by a spot. @param color 0xRRGGBB. @param label Beside it; NULL: none. */
void ray_drawing_mark(const RayDrawing *drawing, Vec3d point, unsigned color, const char *label);

/** Draws a legend of the styles that occur, in the lower left corner. */
void ray_drawing_legend(const RayDrawing *drawing);

/** Draws a line of text with a light border. @param x Left end. @param y Its base line. */
void ray_drawing_text(const RayDrawing *drawing, double x, double y, const char *text);

#endif
