/**
 * @file
 * @brief Which keys are held, and how far that moves the light and the camera.
 *
 * Movement is reckoned from the real time that a key was held, so it is as smooth and as fast on
 * a slow machine as on a fast one. Times are seconds on any clock that only goes forward.
 */
#ifndef DIOPTRE_VIEW_MOTION_H
#define DIOPTRE_VIEW_MOTION_H

#include "view/action.h"

#include <stdbool.h>

/**
 * Seconds that a key counts as held at least: a frame of a common screen. A tap is often shorter
 * than the time between two looks at the keyboard, and must move by an amount one can see.
 */
#define MOTION_TAP (1.0 / 60)

/** One key that moves something. */
typedef struct HeldKey {
    bool is_down;         /**< Whether it is held. */
    double counted_until; /**< Time up to which its being held is in #owed, seconds. */
    double owed;          /**< Seconds held, times the speed, that nothing was moved for yet. */
} HeldKey;

/** All keys that move something. Starts as `{.speed = 1}`: none held. */
typedef struct Motion {
    HeldKey keys[ACTION_MOVE_COUNT]; /**< By #Action. */
    double speed;                    /**< Factor for the time held: Shift fast, Ctrl fine. */
} Motion;

/** A movement along the three axes of the picture, in seconds at plain speed. */
typedef struct Movement {
    double right;   /**< To the right. */
    double up;      /**< Up. */
    double forward; /**< Away from the viewer. */
} Movement;

/**
 * Takes note that a key went down; it is paid for #MOTION_TAP in advance.
 * @param[in,out] motion  The keys.
 * @param action          What the key asks for, a move. A key that is down already is left alone.
 * @param time            When, seconds.
 */
void motion_press(Motion *motion, Action action, double time);

/**
 * Takes note that a key went up.
 * @param[in,out] motion  The keys.
 * @param action          What the key asks for, a move.
 * @param time            When, seconds.
 */
void motion_release(Motion *motion, Action action, double time);

/**
 * Takes note that no key is held any more: the window lost the keyboard.
 * @param[in,out] motion  The keys.
 * @param time            When, seconds.
 */
void motion_release_all(Motion *motion, double time);

/** Forgets what keys are held, and what was not moved yet for them. @param[in,out] motion The keys.
 */
void motion_forget(Motion *motion);

/**
 * Makes the movement faster or slower from now on.
 * @param[in,out] motion  The keys.
 * @param speed           Factor, above 0.
 * @param time            When, seconds.
 */
void motion_set_speed(Motion *motion, double speed, double time);

/** @return Whether a key is held or was, so that #motion_take is worth asking. @param motion It. */
bool motion_is_active(const Motion *motion);

/**
 * Takes the movement since the last time; keys for opposite ways cancel each other.
 * @param[in,out] motion  The keys.
 * @param time            Now, seconds.
 * @param[out] light      How far the light goes.
 * @param[out] camera     How far the camera goes.
 */
void motion_take(Motion *motion, double time, Movement *light, Movement *camera);

/** @return Whether a movement leads anywhere. @param movement The movement. */
bool movement_is_any(Movement movement);

#endif
