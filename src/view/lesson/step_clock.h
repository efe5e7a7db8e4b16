/**
 * @file
 * @brief The clock of a lesson: what keys do falls on its beats, so that a lesson that is played
 *        does to the bit what was done when it was recorded, however fast the machines are.
 *
 * Its time is whole milliseconds from the lesson's beginning. What happens between two beats is
 * done in the order of time; what happens on a beat is done before it.
 */
#ifndef DIOPTRE_VIEW_LESSON_STEP_CLOCK_H
#define DIOPTRE_VIEW_LESSON_STEP_CLOCK_H

#include "view/input/held_keys.h"

#include <stdint.h>

/** Milliseconds from one beat to the next: a frame of a common screen. */
enum { STEP_CLOCK_TICK = 16 };

/**
 * What is moved at a beat.
 * @param light  How far the light goes.
 * @param camera  How far the camera goes.
 */
typedef void StepClockMoveFn(void *context, Movement light, Movement camera);

/** The clock. Starts as `{.motion = {.speed = 1}}`, with who moves things. */
typedef struct StepClock {
    StepClockMoveFn *move; /**< Moves things. */
    void *context;         /**< Handed to it. */
    int64_t now;           /**< Up to when all is done, milliseconds. */
    int64_t next_tick;     /**< The next beat, milliseconds. */
    HeldKeys held_keys;    /**< The keys that are held. */
} StepClock;

/** @return The time up to which all is done, seconds. */
double step_clock_seconds(const StepClock *step_clock);

/** Does what is to be done before a moment. @param until The moment, milliseconds; not before what
 *  is done. */
void step_clock_advance(StepClock *step_clock, int64_t until);

/** @return The next moment at which something is to be done, milliseconds; INT64_MAX: none, until a
 *  key goes down. */
int64_t step_clock_next_tick(const StepClock *step_clock);

#endif
