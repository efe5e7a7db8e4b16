/**
 * @file
 * @brief Integration of the time that keys are held.
 */
#include "view/state/held_keys.h"

#include <math.h>

/**
 * Seconds of movement that count as zero: the rounding that is left when opposite keys cancel. Far
 * below a thousandth of a pixel.
 */
static const double NEGLIGIBLE_SECONDS = 1e-9;

/** Keys of one subject. */
enum { KEYS_PER_SUBJECT = 2 * MOVE_AXIS_COUNT };

/** Adds the time that a key was down to its pending movement. */
static void integrate_until(HeldKey *key, double speed, double time) {
    if (time > key->integrated_until) {
        key->pending_seconds += (time - key->integrated_until) * speed;
        key->integrated_until = time;
    }
}

/** @return The key of a move. */
static HeldKey *key_of(HeldKeys *held_keys, Move move) {
    HeldKey(*keys)[2] = move.subject == MOVE_LIGHT ? held_keys->light : held_keys->camera;
    return &keys[move.axis][move.sign < 0];
}

/** @return One of all keys. @param index Below twice #KEYS_PER_SUBJECT. */
static HeldKey *key_at(HeldKeys *held_keys, int index) {
    return index < KEYS_PER_SUBJECT ? &held_keys->light[0][0] + index
                                    : &held_keys->camera[0][0] + (index - KEYS_PER_SUBJECT);
}

void held_keys_press(HeldKeys *held_keys, Move move, double time) {
    HeldKey *key = key_of(held_keys, move);
    if (!key->is_down) {
        key->is_down = true;
        key->integrated_until = time + HELD_KEYS_MINIMUM_HOLD;
        key->pending_seconds += HELD_KEYS_MINIMUM_HOLD * held_keys->speed;
    }
}

/** A key goes up, if it is down. */
static void release_key(HeldKey *key, double speed, double time) {
    if (key->is_down) {
        integrate_until(key, speed, time);
        key->is_down = false;
    }
}

void held_keys_release(HeldKeys *held_keys, Move move, double time) {
    release_key(key_of(held_keys, move), held_keys->speed, time);
}

void held_keys_release_all(HeldKeys *held_keys, double time) {
    for (int i = 0; i < 2 * KEYS_PER_SUBJECT; i++) {
        release_key(key_at(held_keys, i), held_keys->speed, time);
    }
}

void held_keys_clear(HeldKeys *held_keys) {
    *held_keys = (HeldKeys){.speed = held_keys->speed};
}

void held_keys_set_speed(HeldKeys *held_keys, double speed, double time) {
    for (int i = 0; i < 2 * KEYS_PER_SUBJECT; i++) {
        HeldKey *key = key_at(held_keys, i);
        if (key->is_down) {
            integrate_until(key, held_keys->speed, time);
        }
    }
    held_keys->speed = speed;
}

bool held_keys_is_down(const HeldKeys *held_keys, Move move) {
    const HeldKey(*keys)[2] = move.subject == MOVE_LIGHT ? held_keys->light : held_keys->camera;
    return keys[move.axis][move.sign < 0].is_down;
}

/** @return Whether a key of a subject is held or has pending movement. */
static bool is_any_active(const HeldKey keys[MOVE_AXIS_COUNT][2]) {
    for (int axis = 0; axis < MOVE_AXIS_COUNT; axis++) {
        for (int i = 0; i < 2; i++) {
            if (keys[axis][i].is_down || keys[axis][i].pending_seconds > 0) {
                return true;
            }
        }
    }
    return false;
}

bool held_keys_is_active(const HeldKeys *held_keys) {
    return is_any_active(held_keys->light) || is_any_active(held_keys->camera);
}

/** Consumes the movement of one axis. @param[in,out] keys The key along the axis, then the key
 *  against it. @return Seconds along the axis. */
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

/** Consumes the movement of one subject. */
static Movement consume_axes(HeldKey keys[MOVE_AXIS_COUNT][2], double speed, double time) {
    return (Movement){.right = consume_axis(keys[MOVE_RIGHT], speed, time),
                      .up = consume_axis(keys[MOVE_UP], speed, time),
                      .forward = consume_axis(keys[MOVE_FORWARD], speed, time)};
}

void held_keys_consume(HeldKeys *held_keys, double time, Movement *light, Movement *camera) {
    *light = consume_axes(held_keys->light, held_keys->speed, time);
    *camera = consume_axes(held_keys->camera, held_keys->speed, time);
}

bool movement_is_nonzero(Movement movement) {
    return movement.right != 0 || movement.up != 0 || movement.forward != 0;
}
