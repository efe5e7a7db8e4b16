/**
 * @file
 * @brief Waiting without threads: the fiber of the window lets the others run.
 */
#include "web/waits.h"

#include "web/single/fibers.h"

#include <emscripten.h>

/** What the window waits for. */
static const char event_tag;

void waits_yield(void) {
    fibers_yield();
}

void waits_sleep(double until) {
    fibers_wait(&event_tag, until);
}

void waits_wake(void) {
    fibers_notify(&event_tag);
}

/** Lets the window look for events. Called by the page, after it has got some. */
EMSCRIPTEN_KEEPALIVE void web_wake(void) {
    waits_wake();
}

int waits_processor_count(void) {
    return 1;
}
