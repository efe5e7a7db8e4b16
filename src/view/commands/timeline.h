/**
 * @file
 * @brief The scene's time while the window is open: held, or running as real time does.
 *
 * Times on the clock are seconds that only go forward. The scene's time is rounded to milliseconds,
 * so that a command line can say it: `--time` with the number of the title gives the same picture.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_TIMELINE_H
#define DIOPTRE_VIEW_COMMANDS_TIMELINE_H

#include <stdbool.h>

/** Seconds of a step: a frame of a film, where nothing else is said. */
#define TIMELINE_STEP_SECONDS (1.0 / 25)

/** The scene's time. Starts as `{.time = ...}`: held. */
typedef struct Timeline {
    double time;       /**< The scene's time when it was last held or let run, seconds. */
    double started_at; /**< When that was, on the clock. */
    bool is_running;   /**< Whether it runs. */
} Timeline;

/**
 * @return The scene's time, seconds.
 * @param now  Now, on the clock.
 */
double timeline_time_at(const Timeline *timeline, double now);

/** Lets the time run. @param now Now, on the clock. */
void timeline_run(Timeline *timeline, double now);

/** Holds the time. @param now Now, on the clock. */
void timeline_pause(Timeline *timeline, double now);

/**
 * Holds the time some steps from where it is.
 * @param steps  How many of #TIMELINE_STEP_SECONDS; below 0: back.
 * @param now  Now, on the clock.
 */
void timeline_step(Timeline *timeline, int steps, double now);

#endif
