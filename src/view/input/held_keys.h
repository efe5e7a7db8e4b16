/**
 * @file
 * @brief Which keys are held, and how far that moves the light and the camera.
 *
 * Movement is reckoned from the real time that a key was held, so it is as smooth and as fast on
 * a slow machine as on a fast one. Times are seconds on any clock that only goes forward.
 */
#ifndef DIOPTRE_VIEW_INPUT_HELD_KEYS_H
#define DIOPTRE_VIEW_INPUT_HELD_KEYS_H

#include "view/commands/action.h"

#include <stdbool.h>

/**
 * Seconds that a key counts as held at least: a frame of a common screen. A tap is often shorter
 * than the time between two looks at the keyboard, and must move by an amount one can see.
 */
#define HELD_KEYS_MINIMUM_HOLD (1.0 / 60)

/** One key that moves something. */
typedef struct HeldKey {
    bool is_down; /**< Whether it is held. */
    double
        integrated_until;   /**< Time up to which its being held is in #pending_seconds, seconds. */
    double pending_seconds; /**< Seconds held, times the speed, that nothing was moved for yet. */
} HeldKey;

/** All keys that move something. Starts as `{.speed = 1}`: none held. */
typedef struct HeldKeys {
    HeldKey keys[ACTION_MOVE_COUNT]; /**< By #Action. */
    double speed;                    /**< Factor for the time held: Shift fast, Ctrl fine. */
} HeldKeys;

/** A movement along the three axes of the picture, in seconds at plain speed. */
typedef struct Movement {
    double right;   /**< To the right. */
    double up;      /**< Up. */
    double forward; /**< Away from the viewer. */
} Movement;

/** Takes note that a key went down; it is paid for #HELD_KEYS_MINIMUM_HOLD in advance. @param
 *  action What the key asks for, a move. A key that is down already is left alone. */
void held_keys_press(HeldKeys *held_keys, Action action, double time);

/** Takes note that a key went up. @param action What the key asks for, a move. */
void held_keys_release(HeldKeys *held_keys, Action action, double time);

/** Takes note that no key is held any more: the window lost the keyboard. */
void held_keys_release_all(HeldKeys *held_keys, double time);

/** Forgets what keys are held, and what was not moved yet for them. */
void held_keys_clear(HeldKeys *held_keys);

/** Makes the movement faster or slower from now on. */
void held_keys_set_speed(HeldKeys *held_keys, double speed, double time);

/** @return Whether a key is held or was, so that #held_keys_consume is worth asking. */
bool held_keys_is_active(const HeldKeys *held_keys);

/**
 * Takes the movement since the last time; keys for opposite ways cancel each other.
 * @param[out] light  How far the light goes.
 * @param[out] camera  How far the camera goes.
 */
void held_keys_consume(HeldKeys *held_keys, double time, Movement *light, Movement *camera);

/** @return Whether a movement leads anywhere. */
bool movement_is_nonzero(Movement movement);

#endif
