/**
 * @file
 * @brief The scene's time while the window is open.
 */
#include "view/commands/timeline.h"

#include <math.h>

/** @return A time rounded to milliseconds, as far as there are any. */
static double round_to_milliseconds(double time) {
    /** Seconds beyond which a double may have no milliseconds to be rounded to. */
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
