/**
 * @file
 * @brief The two clocks of a window: the scene's time, and the fixed time step of lessons.
 */
#ifndef DIOPTRE_VIEW_STATE_CLOCKS_H
#define DIOPTRE_VIEW_STATE_CLOCKS_H

#include "view/state/held_keys.h"

#include <stdint.h>

/** Seconds of a step of the scene's time: a frame of a film at the default frame rate. */
#define TIMELINE_STEP_SECONDS (1.0 / 25)

/**
 * The scene's time: paused, or running in real time. Starts as `{.time = ...}`: paused. It is
 * rounded to milliseconds, so that `--time` with the number of the title gives the same picture.
 */
typedef struct Timeline {
    double time;       /**< The scene's time when it was last paused or started, seconds. */
    double started_at; /**< When that was, on a monotonic clock, seconds. */
    bool is_running;   /**< Whether it runs. */
} Timeline;

/** @return The scene's time, seconds. @param now Now, on the monotonic clock, seconds. */
double timeline_time_at(const Timeline *timeline, double now);

/** Lets the time run. */
void timeline_run(Timeline *timeline, double now);

/** Pauses the time. */
void timeline_pause(Timeline *timeline, double now);

/** Pauses the time, and moves it. @param steps Number of #TIMELINE_STEP_SECONDS; negative: back. */
void timeline_step(Timeline *timeline, int steps, double now);

/** Milliseconds of a tick: a frame of a 60 Hz screen. */
enum { STEP_CLOCK_TICK = 16 };

/** Moves light and camera at a tick. @param context #StepClock.context. */
typedef void StepClockMoveFn(void *context, Movement light, Movement camera);

/**
 * The clock of a lesson: movements happen at its ticks, so that a replayed lesson is equal to the
 * bit to the recorded one, however fast the machines are. Its time is whole milliseconds from the
 * lesson's beginning. Events between two ticks are done in the order of time; an event at the time
 * of a tick is done before it. Starts as `{.held_keys = {.speed = 1}}`, with its function.
 */
typedef struct StepClock {
    StepClockMoveFn *move; /**< Moves light and camera. */
    void *context;         /**< Its argument. */
    int64_t now;           /**< Time up to which all is done, milliseconds. */
    int64_t next_tick;     /**< Time of the next tick, milliseconds. */
    HeldKeys held_keys;    /**< The keys that are held. */
} StepClock;

/** @return The time up to which all is done, seconds. */
double step_clock_seconds(const StepClock *step_clock);

/** Does all ticks before a time. @param until The time, milliseconds; not before #StepClock.now. */
void step_clock_advance(StepClock *step_clock, int64_t until);

/** @return The time until which the clock advances by the next tick that moves anything,
 *  milliseconds; INT64_MAX while no key is held. */
int64_t step_clock_next_due(const StepClock *step_clock);

#endif
