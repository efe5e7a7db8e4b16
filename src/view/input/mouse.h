/**
 * @file
 * @brief What the mouse does to the view.
 */
#ifndef DIOPTRE_VIEW_INPUT_MOUSE_H
#define DIOPTRE_VIEW_INPUT_MOUSE_H

#include "view/app.h"

/** A button of the mouse went down or up: the bar between two pictures may be under it, or it is a
 *  click, which shows the rays of a pixel. */
void mouse_on_button(App *app, const SDL_MouseButtonEvent *button);

/** The mouse has moved. Where it is dragged, the bar goes with it, if it has begun there; else the
 *  camera turns the way it goes, by the angle that it crosses. Where rays are shown, the second
 *  camera goes around them. */
void mouse_on_motion(App *app, const SDL_MouseMotionEvent *mouse);

/** The wheel was turned: away from the user comes closer. */
void mouse_on_wheel(App *app, const SDL_MouseWheelEvent *wheel);

#endif
