/**
 * @file
 * @brief What keys, mouse and window do to the view.
 */
#ifndef DIOPTRE_VIEW_CONTROLS_H
#define DIOPTRE_VIEW_CONTROLS_H

#include "view/state.h"

/** Bytes of a step of a lesson with two numbers. */
enum { STEP_SIZE = 80 };

/**
 * Does what an event asks for.
 * @param[in,out] view  The view.
 * @param event         The event.
 */
void controls_handle(View *view, const SDL_Event *event);

/**
 * Moves the light that keys move, and the camera, along the axes of the picture.
 * @param[in,out] view  The view.
 * @param light         How far the light goes.
 * @param camera        How far the camera goes.
 */
void controls_move(View *view, Movement light, Movement camera);

/** Turns the camera, or the second one around the rays that are shown. @param[in,out] view The
 * view.
 *  @param right Degrees to the right. @param up Degrees up. */
void controls_turn(View *view, double right, double up);

/** Makes the field of view narrower, or brings the second camera nearer to the rays that are shown.
 *  @param[in,out] view The view. @param notches Notches of the wheel; below 0: the other way. */
void controls_zoom(View *view, double notches);

/** Shows the rays of a pixel. @param[in,out] view The view. @param x The pixel, as a share of the
 *  picture's width. @param y As a share of its height, from its upper edge. */
void controls_pick(View *view, double x, double y);

/** Goes to a pixel beside the one whose rays are shown. @param[in,out] view The view. @param right
 *  Pixels to the right. @param down Pixels down. */
void controls_walk(View *view, int right, int down);

#endif
