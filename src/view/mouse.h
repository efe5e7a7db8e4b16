/**
 * @file
 * @brief What the mouse does to the view.
 */
#ifndef DIOPTRE_VIEW_MOUSE_H
#define DIOPTRE_VIEW_MOUSE_H

#include "view/state.h"

/** A button of the mouse went down or up: the bar between two pictures may be under it, or it is a
 *  click, which shows the rays of a pixel. @param[in,out] view The view. @param button The event.
 */
void mouse_button(View *view, const SDL_MouseButtonEvent *button);

/**
 * The mouse has moved. Where it is dragged, the bar goes with it, if it has begun there; else the
 * camera turns the way it goes, by the angle that it crosses. Where rays are shown, the second
 * camera goes around them.
 * @param[in,out] view  The view.
 * @param mouse         The event.
 */
void mouse_motion(View *view, const SDL_MouseMotionEvent *mouse);

/** The wheel was turned: away from the user comes closer. @param[in,out] view The view.
 *  @param wheel The event. */
void mouse_wheel(View *view, const SDL_MouseWheelEvent *wheel);

#endif
