/**
 * @file
 * @brief Draws the rays of a pixel with cairo: over a picture in the window, or into an SVG file.
 *
 * A drawing's units are the pixels of its #RayDrawing.view.
 */
#ifndef DIOPTRE_RENDER_RAY_DRAWING_H
#define DIOPTRE_RENDER_RAY_DRAWING_H

#include "render/label_layout.h"
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
    size_t selected;          /**< Index of a ray that is drawn thicker, and all others dim. */
    size_t hovered;           /**< Index of a ray that has its number anyway, plus 1; 0: none. */
    double text_size;         /**< Height of letters; 0: it follows from the size of the view. */
    unsigned hidden_kinds;    /**< Kinds of rays that are not drawn: bit i is #RayType i. */
    bool is_along_light;      /**< Whether arrows show the way of the light, not of the rays. */
    bool hides_selected;      /**< Whether the selected ray is not drawn either: it is in flight. */
} RayDrawing;

/** Draws all rays, each with a light border and an arrowhead; the way that a blocked shadow ray
 *  lacks to its lamp as dots; the normals where the selected ray starts and ends. */
void ray_drawing_rays(const RayDrawing *drawing);

/** Rays that have numbers, at most: more would hide the rays. */
enum { RAY_LABELS_MAXIMUM = 40 };
/** Bytes of the number of a ray with the final zero. */
enum { RAY_LABEL_SIZE = 24 };

/** The number of a ray in the drawing. */
typedef struct RayLabel {
    size_t ray;                /**< Index of the ray. */
    char text[RAY_LABEL_SIZE]; /**< The number. */
} RayLabel;

/**
 * Finds where the rays are whose numbers are shown, the selected one first. Where there are many
 * rays, and one is selected, the others that have one are those that it comes from, begins, and has
 * beside it: the numbers of all would hide what the rays go through.
 * @param[out] labels  The numbers.
 * @param[out] boxes   Their lines, the rays; the sizes of the texts are not set.
 * @return How many there are.
 */
size_t ray_drawing_labels(const RayDrawing *drawing, RayLabel labels[RAY_LABELS_MAXIMUM],
                          LabelBox boxes[RAY_LABELS_MAXIMUM]);

/** Draws the spheres of free distance along the selected ray, as circles that face the camera. */
void ray_drawing_march(const RayDrawing *drawing);

/** Draws the numbers of the rays, with leader lines. */
void ray_drawing_numbers(const RayDrawing *drawing);

/** Finds the ray that is drawn at a point. @param reach Largest distance, pixels. @return Its
 *  index; #RAY_DRAWING_UNSELECTED: none. */
size_t ray_drawing_at(const RayDrawing *drawing, double x, double y, double reach);

/** Projects a ray and clips it to the drawing. @return Whether any of it is in sight. */
bool ray_drawing_project(const RayDrawing *drawing, size_t index, ProjectedRay *line);

/** Marks a point by a spot. @param color 0xRRGGBB. @param label Beside it; NULL: none. */
void ray_drawing_mark(const RayDrawing *drawing, Vec3d point, unsigned color, const char *label);

/** Draws a legend of the styles that occur, in the lower left corner. */
void ray_drawing_legend(const RayDrawing *drawing);

/** Draws a line of text with a light border. @param x Left end. @param y Its base line. */
void ray_drawing_text(const RayDrawing *drawing, double x, double y, const char *text);

#endif
