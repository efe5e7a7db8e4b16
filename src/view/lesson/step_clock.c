/**
 * @file
 * @brief The clock of a lesson.
 */
#include "view/lesson/step_clock.h"

/** @return A time of a lesson in seconds. */
static double milliseconds_to_seconds(int64_t milliseconds) {
    return (double)milliseconds / 1000;
}

double step_clock_seconds(const StepClock *step_clock) {
    return milliseconds_to_seconds(step_clock->now);
}

/** Moves things as far as keys were held up to the next beat. */
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

int64_t step_clock_next_tick(const StepClock *step_clock) {
    return held_keys_is_active(&step_clock->held_keys) ? step_clock->next_tick : INT64_MAX;
}
