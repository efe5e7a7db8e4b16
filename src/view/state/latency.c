/**
 * @file
 * @brief The latency from a key to its picture.
 */
#include "view/state/latency.h"

#include "base/median.h"

#include <stdlib.h>
#include <string.h>

/** First capacity; it is doubled when it is full. */
enum { FIRST_CAPACITY = 128 };

void latency_on_input(Latency *latency, double time) {
    if (latency->pending_count < LATENCY_PENDING_MAXIMUM) {
        latency->pending[latency->pending_count++] = time;
    }
}

void latency_on_draw_started(Latency *latency) {
    latency->in_flight_count = latency->pending_count;
}

void latency_discard_pending(Latency *latency) {
    latency->pending_count = latency->in_flight_count = 0;
}

/** Appends one latency. */
static void latency_record(Latency *latency, double wait) {
    if (latency->count == latency->capacity) {
        size_t capacity = latency->capacity > 0 ? 2 * latency->capacity : FIRST_CAPACITY;
        double *waits = realloc(latency->waits, capacity * sizeof *waits);
        if (!waits) {
            return;
        }
        latency->waits = waits;
        latency->capacity = capacity;
    }
    latency->waits[latency->count++] = wait;
}

void latency_on_presented(Latency *latency, double time) {
    for (size_t i = 0; i < latency->in_flight_count; i++) {
        latency_record(latency, time - latency->pending[i]);
    }
    latency->pending_count -= latency->in_flight_count;
    memmove(latency->pending, latency->pending + latency->in_flight_count,
            latency->pending_count * sizeof latency->pending[0]);
    latency->in_flight_count = 0;
}

LatencySummary latency_summary(Latency *latency) {
    size_t n = latency->count;
    if (n == 0) {
        return (LatencySummary){0};
    }
    double median = median_sort(latency->waits, n);
    return (LatencySummary){.count = n, .median = median, .worst = latency->waits[n - 1]};
}

void latency_deinit(Latency *latency) {
    free(latency->waits);
    *latency = (Latency){0};
}
