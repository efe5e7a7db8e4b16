/**
 * @file
 * @brief Marks of the lights on the picture: each light is seen, and can be dragged.
 */
#ifndef DIOPTRE_VIEW_PANELS_LIGHT_MARKS_H
#define DIOPTRE_VIEW_PANELS_LIGHT_MARKS_H

#include "dioptre/scene.h"
#include "view/gui/gui.h"

/** Most lights that are marked: more would hide the picture. */
enum { LIGHT_MARKS_MAXIMUM = 32 };

/** One mark. */
typedef struct LightMark {
    size_t light;   /**< Index of the light in #Scene.lights. */
    GuiPoint point; /**< Where it is, pixels of the window; of an arrow: its middle. */
} LightMark;

/** The marks of the last frame. Starts as `{0}`: none. */
typedef struct LightMarks {
    LightMark marks[LIGHT_MARKS_MAXIMUM]; /**< Marks in the picture, and arrows at its edge. */
    size_t count;                         /**< Their number. */
} LightMarks;

/**
 * Shows the marks, and an arrow at the edge for each light outside the picture.
 * @param picture   The picture's rectangle, pixels of the window.
 * @param selected  Index of the light that keys move.
 */
void light_marks_show(LightMarks *marks, const Scene *scene, const SDL_Rect *picture,
                      size_t selected);

/** @return The mark at a position; NULL: none. */
const LightMark *light_marks_at(const LightMarks *marks, GuiPoint point, float reach);

/**
 * Finds how far a light moves while its mark is dragged: in the plane through the light that faces
 * the camera, or along the direction of view. A light outside the picture moves as if it were ahead
 * of the camera, as far away as it is.
 * @param picture    The picture's rectangle, pixels of the window.
 * @param from       Where the mouse was.
 * @param to         Where it is.
 * @param is_along   Whether it moves along the direction of view: up is away.
 * @param[out] offset  How far it moves, scene units.
 * @return false if the light has no position.
 */
bool light_marks_drag_offset(const Scene *scene, size_t light, const SDL_Rect *picture,
                             GuiPoint from, GuiPoint to, bool is_along, Vec3d *offset);

#endif
