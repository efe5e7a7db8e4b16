/**
 * @file
 * @brief The scene's time while the window is open.
 */
#include "view/timeline.h"

#include <math.h>

/** @return A time rounded to milliseconds, as far as there are any. @param time The time, seconds.
 */
static double in_milliseconds(double time) {
    /** Seconds beyond which a double may have no milliseconds to be rounded to. */
    const double far = 1e12;
    const double thousand = 1000;
    return fabs(time) < far ? round(time * thousand) / thousand : time;
}

double timeline_at(const Timeline *timeline, double now) {
    return timeline->is_running ? in_milliseconds(timeline->time + (now - timeline->since))
                                : timeline->time;
}

void timeline_run(Timeline *timeline, double now) {
    *timeline = (Timeline){.time = timeline_at(timeline, now), .since = now, .is_running = true};
}

void timeline_hold(Timeline *timeline, double now) {
    *timeline = (Timeline){.time = timeline_at(timeline, now)};
}

void timeline_step(Timeline *timeline, int steps, double now) {
    timeline_hold(timeline, now);
    timeline->time = in_milliseconds(timeline->time + steps * TIMELINE_STEP);
}
