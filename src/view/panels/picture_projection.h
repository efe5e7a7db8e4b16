/**
 * @file
 * @brief From the scene to the picture on the screen and back: where a point is seen, how far a
 * drag moves it.
 */
#ifndef DIOPTRE_VIEW_PANELS_PICTURE_PROJECTION_H
#define DIOPTRE_VIEW_PANELS_PICTURE_PROJECTION_H

#include "dioptre/scene.h"
#include "view/gui/gui.h"

/** A drag in the picture. */
typedef struct PictureDrag {
    GuiPoint from; /**< Where the mouse was, pixels of the window. */
    GuiPoint to;   /**< Where it is. */
    bool is_along; /**< Whether the thing moves along the direction of view: up is away. */
} PictureDrag;

/**
 * Finds where a point is seen.
 * @param picture     The picture's rectangle, pixels of the window.
 * @param[out] place  Where it is, pixels of the window; perhaps outside the picture.
 * @return Whether it is in front of the camera.
 */
bool picture_point(const SceneCamera *camera, const SDL_Rect *picture, Vec3d point,
                   GuiPoint *place);

/**
 * Finds how far a thing moves that is dragged: across the view, or along its direction.
 * @param depth    How far ahead of the camera it is, scene units; at least #camera_near_depth.
 * @param picture  The picture's rectangle, pixels of the window.
 * @return How far it moves, scene units.
 */
Vec3d picture_drag_offset(const SceneCamera *camera, double depth, const SDL_Rect *picture,
                          const PictureDrag *drag);

/** #picture_drag_offset of a thing that is dragged at one of its points. @return false if that is
 *  behind the camera. */
bool picture_drag_offset_at(const SceneCamera *camera, Vec3d point, const SDL_Rect *picture,
                            const PictureDrag *drag, Vec3d *offset);

#endif
