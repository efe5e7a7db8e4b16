/**
 * @file
 * @brief The scene's time, and the fixed time step of lessons.
 */
#include "view/state/clocks.h"

#include <math.h>

/** @return A time rounded to milliseconds, where a double has that resolution. */
static double round_to_milliseconds(double time) {
    /** Seconds beyond which a double may not resolve milliseconds. */
    const double far = 1e12;
    const double per_second = 1000;
    return fabs(time) < far ? round(time * per_second) / per_second : time;
}

double timeline_time_at(const Timeline *timeline, double now) {
    return timeline->is_running
               ? round_to_milliseconds(timeline->time + (now - timeline->started_at))
               : timeline->time;
}

void timeline_run(Timeline *timeline, double now) {
    *timeline =
        (Timeline){.time = timeline_time_at(timeline, now), .started_at = now, .is_running = true};
}

void timeline_pause(Timeline *timeline, double now) {
    *timeline = (Timeline){.time = timeline_time_at(timeline, now)};
}

void timeline_step(Timeline *timeline, int steps, double now) {
    timeline_pause(timeline, now);
    timeline->time = round_to_milliseconds(timeline->time + steps * TIMELINE_STEP_SECONDS);
}

/** @return A time of a lesson in seconds. */
static double milliseconds_to_seconds(int64_t milliseconds) {
    return (double)milliseconds / 1000;
}

double step_clock_seconds(const StepClock *step_clock) {
    return milliseconds_to_seconds(step_clock->now);
}

/** Does the next tick. */
static void step_clock_tick(StepClock *step_clock) {
    Movement light, camera;
    held_keys_consume(&step_clock->held_keys, milliseconds_to_seconds(step_clock->next_tick),
                      &light, &camera);
    step_clock->move(step_clock->context, light, camera);
    step_clock->next_tick += STEP_CLOCK_TICK;
}

void step_clock_advance(StepClock *step_clock, int64_t until) {
    while (step_clock->next_tick < until && held_keys_is_active(&step_clock->held_keys)) {
        step_clock_tick(step_clock);
    }
    if (step_clock->next_tick < until) {
        int64_t ticks = (until - step_clock->next_tick + STEP_CLOCK_TICK - 1) / STEP_CLOCK_TICK;
        step_clock->next_tick += ticks * STEP_CLOCK_TICK;
    }
    step_clock->now = until;
}

int64_t step_clock_next_due(const StepClock *step_clock) {
    return held_keys_is_active(&step_clock->held_keys) ? step_clock->next_tick + 1 : INT64_MAX;
}
