/**
 * @file
 * @brief The latency from a key to its picture, measured by the program itself.
 */
#ifndef DIOPTRE_VIEW_STATE_LATENCY_H
#define DIOPTRE_VIEW_STATE_LATENCY_H

#include <stddef.h>

/** Most keys that wait for their picture at once. */
enum { LATENCY_PENDING_MAXIMUM = 16 };

/** Keys that wait for their picture, and the latencies of all others. Starts as `{0}`. */
typedef struct Latency {
    double pending[LATENCY_PENDING_MAXIMUM]; /**< When the keys went down, the oldest first,
                                                seconds. */
    size_t pending_count;                    /**< Number of waiting keys. */
    size_t
        in_flight_count; /**< Number of them, from the first, that the current render will show. */
    double *waits;       /**< Latencies of the others, seconds; owned. */
    size_t count;        /**< Number of #waits. */
    size_t capacity;     /**< Capacity of #waits. */
} Latency;

/** Statistics of the latencies. */
typedef struct LatencySummary {
    size_t count;  /**< Number of keys. */
    double median; /**< Median latency, seconds; 0 without keys. */
    double worst;  /**< Largest latency, seconds; 0 without keys. */
} LatencySummary;

/** A key went down, or the mouse has dragged something. Not counted beyond
 *  #LATENCY_PENDING_MAXIMUM of them. */
void latency_on_input(Latency *latency, double time);

/** A render begins that shows all waiting keys. */
void latency_on_draw_started(Latency *latency);

/** The waiting keys have no picture. */
void latency_discard_pending(Latency *latency);

/** The current render is on screen for the first time. Its latencies are not counted when memory
 * runs out. */
void latency_on_presented(Latency *latency, double time);

/** @return The statistics. @param[in,out] latency Its latencies are sorted. */
LatencySummary latency_summary(Latency *latency);

/** Frees the memory. */
void latency_deinit(Latency *latency);

#endif
