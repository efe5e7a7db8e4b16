/**
 * @file
 * @brief Time limits inside the functions of Lua's libraries: steps.patch makes their loops count.
 *
 * Lua's hook sees instructions of Lua, but no pattern that is tried in ever more ways. On a desktop
 * the worker process ends then; a page has none.
 */
#ifndef DIOPTRE_WEB_LIBRARIES_LUA_STEPS_H
#define DIOPTRE_WEB_LIBRARIES_LUA_STEPS_H

#include "assets/process/worker_main.h"

/** Steps between two looks at the clock: some tenths of a millisecond. */
#define STEPS_PER_CHECK ((size_t)1 << 16)

/** Counts steps of a loop; leaves the job if its time has passed. One job runs at a time. */
static inline void count_steps(size_t count) {
    static size_t steps;
    steps += count;
    if (steps >= STEPS_PER_CHECK) {
        steps = 0;
        worker_job_check();
    }
}

#endif
