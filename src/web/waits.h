/**
 * @file
 * @brief Waiting for events of the window, with threads and without.
 */
#ifndef DIOPTRE_WEB_WAITS_H
#define DIOPTRE_WEB_WAITS_H

/** Lets the browser hand over its events, and others have their turn if they are due. A window that
 * has no time to wait, as a frame takes longer than it may, calls this nevertheless. */
void waits_yield(void);

/** Waits until #waits_wake, or a time; earlier for no reason, too. @param until Of the clock,
 * seconds. */
void waits_sleep(double until);

/** Lets the window look for events: one has been pushed. */
void waits_wake(void);

/** @return Number of processors that the program has. */
int waits_processor_count(void);

#endif
