/**
 * @file
 * @brief Which keys are held, and how far that moves things.
 */
#include "view/input/held_keys.h"

#include <math.h>

/**
 * Seconds of movement that count as none: what rounding leaves when opposite keys cancel. Far
 * below a thousandth of a pixel.
 */
static const double NEGLIGIBLE_SECONDS = 1e-9;

/**
 * Adds the time that a key was held to what it is owed.
 * @param[in,out] key  A key that is down.
 * @param speed  Factor for that time.
 */
static void integrate_until(HeldKey *key, double speed, double time) {
    if (time > key->integrated_until) {
        key->pending_seconds += (time - key->integrated_until) * speed;
        key->integrated_until = time;
    }
}

void held_keys_press(HeldKeys *held_keys, Action action, double time) {
    HeldKey *key = &held_keys->keys[action];
    if (!key->is_down) {
        key->is_down = true;
        key->integrated_until = time + HELD_KEYS_MINIMUM_HOLD;
        key->pending_seconds += HELD_KEYS_MINIMUM_HOLD * held_keys->speed;
    }
}

void held_keys_release(HeldKeys *held_keys, Action action, double time) {
    HeldKey *key = &held_keys->keys[action];
    if (key->is_down) {
        integrate_until(key, held_keys->speed, time);
        key->is_down = false;
    }
}

void held_keys_release_all(HeldKeys *held_keys, double time) {
    for (int action = 0; action < ACTION_MOVE_COUNT; action++) {
        held_keys_release(held_keys, (Action)action, time);
    }
}

void held_keys_clear(HeldKeys *held_keys) {
    *held_keys = (HeldKeys){.speed = held_keys->speed};
}

void held_keys_set_speed(HeldKeys *held_keys, double speed, double time) {
    for (int action = 0; action < ACTION_MOVE_COUNT; action++) {
        if (held_keys->keys[action].is_down) {
            integrate_until(&held_keys->keys[action], held_keys->speed, time);
        }
    }
    held_keys->speed = speed;
}

bool held_keys_is_active(const HeldKeys *held_keys) {
    for (int action = 0; action < ACTION_MOVE_COUNT; action++) {
        if (held_keys->keys[action].is_down || held_keys->keys[action].pending_seconds > 0) {
            return true;
        }
    }
    return false;
}

/**
 * Takes what the two keys of one axis are owed.
 * @param[in,out] keys  The key along the axis, then the key against it.
 * @param speed  Factor for time not counted yet.
 * @return Seconds along the axis; negative against it.
 */
static double consume_axis(HeldKey keys[2], double speed, double time) {
    for (int i = 0; i < 2; i++) {
        if (keys[i].is_down) {
            integrate_until(&keys[i], speed, time);
        }
    }
    double along = keys[0].pending_seconds - keys[1].pending_seconds;
    keys[0].pending_seconds = keys[1].pending_seconds = 0;
    return fabs(along) > NEGLIGIBLE_SECONDS ? along : 0;
}

/**
 * Takes what the six keys of one thing are owed.
 * @param first  The first of the six: to the right.
 * @return The movement.
 */
static Movement consume_axes(HeldKeys *held_keys, Action first, double time) {
    HeldKey *keys = &held_keys->keys[first];
    return (Movement){.right = consume_axis(keys, held_keys->speed, time),
                      .up = consume_axis(keys + 2, held_keys->speed, time),
                      .forward = consume_axis(keys + 4, held_keys->speed, time)};
}

void held_keys_consume(HeldKeys *held_keys, double time, Movement *light, Movement *camera) {
    *light = consume_axes(held_keys, ACTION_LIGHT_RIGHT, time);
    *camera = consume_axes(held_keys, ACTION_CAMERA_RIGHT, time);
}

bool movement_is_nonzero(Movement movement) {
    return movement.right != 0 || movement.up != 0 || movement.forward != 0;
}
