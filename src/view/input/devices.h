/**
 * @file
 * @brief What keyboard, mouse and fingers do: they issue commands, which lessons record.
 */
#ifndef DIOPTRE_VIEW_INPUT_DEVICES_H
#define DIOPTRE_VIEW_INPUT_DEVICES_H

#include "view/app.h"

/** Modifiers with which a key is for the window manager. */
enum { WINDOW_MANAGER_MODIFIERS = KMOD_LALT | KMOD_GUI };

/** @return When an event happened, seconds on #clock_now_seconds; it may have waited in the queue.
 *  @param timestamp SDL's time of the event, milliseconds. */
double input_event_time(Uint32 timestamp);

/** Handles a key that goes down or up. */
void keyboard_on_key(App *app, const SDL_KeyboardEvent *key);

/** Ends the move that a key began, which goes up: whatever else is held by now, and whoever else
 *  uses the key. */
void keyboard_on_release(App *app, const SDL_KeyboardEvent *key);

/** All keys go up: the window lost the keyboard, or its layout changed. @param time Seconds. */
void keyboard_release_all(App *app, double time);

/** Handles a mouse button. */
void mouse_on_button(App *app, const SDL_MouseButtonEvent *button);

/** Handles a mouse motion: drags what the mouse holds, or turns the camera by the angle that the
 *  mouse crosses. */
void mouse_on_motion(App *app, const SDL_MouseMotionEvent *mouse);

/** Handles the wheel: away from the user zooms in. */
void mouse_on_wheel(App *app, const SDL_MouseWheelEvent *wheel);

/** Handles two fingers: their middle pans, their distance zooms. The first of them was a mouse
 *  button until now. */
void mouse_on_fingers(App *app, const SDL_MultiGestureEvent *fingers);

#endif
