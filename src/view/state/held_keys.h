/**
 * @file
 * @brief Which keys are held, and how far that moves the light and the camera.
 *
 * A movement is the real time that a key was held, so its speed is the same on a slow machine as on
 * a fast one. Times are seconds on any monotonic clock.
 */
#ifndef DIOPTRE_VIEW_STATE_HELD_KEYS_H
#define DIOPTRE_VIEW_STATE_HELD_KEYS_H

#include <stdbool.h>

/**
 * Seconds that a key counts as held at least: a frame of a 60 Hz screen. A tap is often shorter
 * than the time between two polls of the keyboard, and must move by a visible amount.
 */
#define HELD_KEYS_MINIMUM_HOLD (1.0 / 60)

/** What a key moves. */
typedef enum {
    MOVE_NOTHING, /**< Nothing: the key is no move. */
    MOVE_LIGHT,   /**< The selected light. */
    MOVE_CAMERA   /**< The camera. */
} MoveSubject;

/** The axes of the picture. */
typedef enum {
    MOVE_RIGHT,     /**< To the right. */
    MOVE_UP,        /**< Up. */
    MOVE_FORWARD,   /**< Away from the viewer. */
    MOVE_AXIS_COUNT /**< Number of axes. */
} MoveAxis;

/** What a key moves, and in which direction. */
typedef struct Move {
    MoveSubject subject; /**< What. */
    MoveAxis axis;       /**< Along which axis. */
    int sign;            /**< 1: along the axis; -1: against it. */
} Move;

/** One key that moves something. */
typedef struct HeldKey {
    bool is_down;            /**< Whether it is held. */
    double integrated_until; /**< Time up to which #pending_seconds counts, seconds. */
    double pending_seconds;  /**< Seconds held, times the speed, not consumed yet. */
} HeldKey;

/** All keys that move something. Starts as `{.speed = 1}`: none held. */
typedef struct HeldKeys {
    HeldKey light[MOVE_AXIS_COUNT][2];  /**< By #MoveAxis; then along it, against it. */
    HeldKey camera[MOVE_AXIS_COUNT][2]; /**< The same. */
    double speed;                       /**< Factor of the time held: Shift fast, Ctrl fine. */
} HeldKeys;

/** A movement along the three axes of the picture, in seconds at normal speed. */
typedef struct Movement {
    double right;   /**< To the right. */
    double up;      /**< Up. */
    double forward; /**< Away from the viewer. */
} Movement;

/** A key goes down: #HELD_KEYS_MINIMUM_HOLD is added at once. Does nothing if it is down already.
 *  @param move Not of #MOVE_NOTHING. */
void held_keys_press(HeldKeys *held_keys, Move move, double time);

/** A key goes up. @param move Not of #MOVE_NOTHING. */
void held_keys_release(HeldKeys *held_keys, Move move, double time);

/** All keys go up: the window lost the keyboard. */
void held_keys_release_all(HeldKeys *held_keys, double time);

/** Forgets which keys are held, and the movement not consumed yet. */
void held_keys_clear(HeldKeys *held_keys);

/** Changes the speed from a time on. @param speed Factor of the time held. */
void held_keys_set_speed(HeldKeys *held_keys, double speed, double time);

/** @return Whether a key is down. @param move Not of #MOVE_NOTHING. */
bool held_keys_is_down(const HeldKeys *held_keys, Move move);

/** @return Whether a key is held or has movement that was not consumed. */
bool held_keys_is_active(const HeldKeys *held_keys);

/** Returns the movement since the last call; opposite keys cancel. @param[out] light Movement of
 *  the light. @param[out] camera Movement of the camera. */
void held_keys_consume(HeldKeys *held_keys, double time, Movement *light, Movement *camera);

/** @return Whether a movement is not zero. */
bool movement_is_nonzero(Movement movement);

#endif
