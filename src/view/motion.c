/**
 * @file
 * @brief Which keys are held, and how far that moves things.
 */
#include "view/motion.h"

#include <math.h>

/**
 * Seconds of movement that count as none: what rounding leaves when opposite keys cancel. Far
 * below a thousandth of a pixel.
 */
static const double NEGLIGIBLE = 1e-9;

/**
 * Adds the time that a key was held to what it is owed.
 * @param[in,out] key  A key that is down.
 * @param speed        Factor for that time.
 * @param time         Until when, seconds.
 */
static void count_until(HeldKey *key, double speed, double time) {
    if (time > key->counted_until) {
        key->owed += (time - key->counted_until) * speed;
        key->counted_until = time;
    }
}

void motion_press(Motion *motion, Action action, double time) {
    HeldKey *key = &motion->keys[action];
    if (!key->is_down) {
        key->is_down = true;
        key->counted_until = time + MOTION_TAP;
        key->owed += MOTION_TAP * motion->speed;
    }
}

void motion_release(Motion *motion, Action action, double time) {
    HeldKey *key = &motion->keys[action];
    if (key->is_down) {
        count_until(key, motion->speed, time);
        key->is_down = false;
    }
}

void motion_release_all(Motion *motion, double time) {
    for (int action = 0; action < ACTION_MOVE_COUNT; action++) {
        motion_release(motion, (Action)action, time);
    }
}

void motion_forget(Motion *motion) {
    *motion = (Motion){.speed = motion->speed};
}

void motion_set_speed(Motion *motion, double speed, double time) {
    for (int action = 0; action < ACTION_MOVE_COUNT; action++) {
        if (motion->keys[action].is_down) {
            count_until(&motion->keys[action], motion->speed, time);
        }
    }
    motion->speed = speed;
}

bool motion_is_active(const Motion *motion) {
    for (int action = 0; action < ACTION_MOVE_COUNT; action++) {
        if (motion->keys[action].is_down || motion->keys[action].owed > 0) {
            return true;
        }
    }
    return false;
}

/**
 * Takes what the two keys of one axis are owed.
 * @param[in,out] keys  The key along the axis, then the key against it.
 * @param speed         Factor for time not counted yet.
 * @param time          Now, seconds.
 * @return Seconds along the axis; negative against it.
 */
static double take_axis(HeldKey keys[2], double speed, double time) {
    for (int i = 0; i < 2; i++) {
        if (keys[i].is_down) {
            count_until(&keys[i], speed, time);
        }
    }
    double along = keys[0].owed - keys[1].owed;
    keys[0].owed = keys[1].owed = 0;
    return fabs(along) > NEGLIGIBLE ? along : 0;
}

/**
 * Takes what the six keys of one thing are owed.
 * @param[in,out] motion  The keys.
 * @param first           The first of the six: to the right.
 * @param time            Now, seconds.
 * @return The movement.
 */
static Movement take_axes(Motion *motion, Action first, double time) {
    HeldKey *keys = &motion->keys[first];
    return (Movement){.right = take_axis(keys, motion->speed, time),
                      .up = take_axis(keys + 2, motion->speed, time),
                      .forward = take_axis(keys + 4, motion->speed, time)};
}

void motion_take(Motion *motion, double time, Movement *light, Movement *camera) {
    *light = take_axes(motion, ACTION_LIGHT_RIGHT, time);
    *camera = take_axes(motion, ACTION_CAMERA_RIGHT, time);
}

bool movement_is_any(Movement movement) {
    return movement.right != 0 || movement.up != 0 || movement.forward != 0;
}
