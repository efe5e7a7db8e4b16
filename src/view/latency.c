/**
 * @file
 * @brief How long it takes from a key to its picture.
 */
#include "view/latency.h"

#include <stdlib.h>
#include <string.h>

/** Waits that the first piece of memory holds; doubled when they are more. */
enum { FIRST_CAPACITY = 128 };

void latency_key(Latency *latency, double time) {
    if (latency->waiting_count < LATENCY_WAITING_MAXIMUM) {
        latency->waiting[latency->waiting_count++] = time;
    }
}

void latency_drawing(Latency *latency) {
    latency->asked_count = latency->waiting_count;
}

void latency_forget(Latency *latency) {
    latency->waiting_count = latency->asked_count = 0;
}

/**
 * Keeps one wait.
 * @param[in,out] latency  The statistics.
 * @param wait             How long, seconds.
 */
static void keep(Latency *latency, double wait) {
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

void latency_shown(Latency *latency, double time) {
    for (size_t i = 0; i < latency->asked_count; i++) {
        keep(latency, time - latency->waiting[i]);
    }
    latency->waiting_count -= latency->asked_count;
    memmove(latency->waiting, latency->waiting + latency->asked_count,
            latency->waiting_count * sizeof latency->waiting[0]);
    latency->asked_count = 0;
}

/** @return Below 0, 0 or above 0, for qsort. @param a A `double`. @param b Another. */
static int by_length(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

LatencySummary latency_summary(Latency *latency) {
    size_t n = latency->count;
    if (n == 0) {
        return (LatencySummary){0};
    }
    qsort(latency->waits, n, sizeof latency->waits[0], by_length);
    double median = (latency->waits[(n - 1) / 2] + latency->waits[n / 2]) / 2;
    return (LatencySummary){.count = n, .median = median, .worst = latency->waits[n - 1]};
}

void latency_release(Latency *latency) {
    free(latency->waits);
    *latency = (Latency){0};
}
