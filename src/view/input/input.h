/**
 * @file
 * @brief What keys, mouse and window do to the view.
 */
#ifndef DIOPTRE_VIEW_INPUT_INPUT_H
#define DIOPTRE_VIEW_INPUT_INPUT_H

#include "view/app.h"

/** Bytes of a step of a lesson with two numbers. */
enum { LESSON_STEP_TEXT_SIZE = 80 };

/** Does what an event asks for. */
void input_handle_event(App *app, const SDL_Event *event);

/**
 * Moves the light that keys move, and the camera, along the axes of the picture.
 * @param light  How far the light goes.
 * @param camera  How far the camera goes.
 */
void app_move(App *app, Movement light, Movement camera);

/** Turns the camera, or the second one around the rays that are shown. @param right Degrees to the
 *  right. */
void app_turn(App *app, double right, double up);

/** Makes the field of view narrower, or brings the second camera nearer to the rays that are shown.
 *  @param notches Notches of the wheel; below 0: the other way. */
void app_zoom(App *app, double notches);

/**
 * Shows the rays of a pixel.
 * @param x  The pixel, as a share of the picture's width.
 * @param y  As a share of its height, from its upper edge.
 */
void app_pick_pixel(App *app, double x, double y);

/** Goes to a pixel beside the one whose rays are shown. @param right Pixels to the right. */
void app_step_pixel(App *app, int right, int down);

#endif
