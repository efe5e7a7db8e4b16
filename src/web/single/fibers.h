/**
 * @file
 * @brief Threads of a page without shared memory: fibers that take turns.
 *
 * A fiber runs until it waits: for a condition, for another's end, for an event of the window, or,
 * between two tiles, for its next turn. A turn of all of them ends after #FIBERS_SLICE, so that the
 * browser stays alive.
 */
#ifndef DIOPTRE_WEB_SINGLE_FIBERS_H
#define DIOPTRE_WEB_SINGLE_FIBERS_H

/** Seconds that fibers run before the browser has its turn: less than a frame of its screen. */
#define FIBERS_SLICE 0.010

/**
 * Waits until something is notified, or a time comes. Only fibers may.
 * @param what  What #fibers_notify names.
 * @param until Time of the clock, seconds; infinite: only what is notified ends it.
 */
void fibers_wait(const void *what, double until);

/** Lets all fibers go on that wait for something. */
void fibers_notify(const void *what);

/** Gives the turn to others if the slice is over; the caller may be no fiber: then nothing happens.
 */
void fibers_yield(void);

#endif
