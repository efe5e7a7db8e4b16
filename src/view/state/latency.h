/**
 * @file
 * @brief How long it takes from a key to its picture, measured by the program itself.
 */
#ifndef DIOPTRE_VIEW_STATE_LATENCY_H
#define DIOPTRE_VIEW_STATE_LATENCY_H

#include <stddef.h>

/** Keys that can wait for their picture at once; more than there are fingers. */
enum { LATENCY_PENDING_MAXIMUM = 16 };

/** Keys that wait for their picture, and how long others waited. Starts as `{0}`. */
typedef struct Latency {
    double pending[LATENCY_PENDING_MAXIMUM]; /**< When the keys came, the oldest first, seconds. */
    size_t pending_count;                    /**< How many wait. */
    size_t in_flight_count; /**< How many of them, from the first, are in the drawing under way. */
    double *waits;          /**< How long the others waited, seconds; owned. */
    size_t count;           /**< How many. */
    size_t capacity;        /**< How many fit. */
} Latency;

/** What the waits come to. */
typedef struct LatencySummary {
    size_t count;  /**< Keys. */
    double median; /**< Half of them waited at most so long, seconds; 0 without keys. */
    double worst;  /**< The longest wait, seconds; 0 without keys. */
} LatencySummary;

/** A key has come. @param[in,out] latency The statistics. More than #LATENCY_PENDING_MAXIMUM at
 *  once: not counted. */
void latency_on_key(Latency *latency, double time);

/** A drawing begins that shows all that came so far. */
void latency_on_draw_started(Latency *latency);

/** The keys that came so far will have no picture. */
void latency_discard_pending(Latency *latency);

/** The drawing under way is on screen for the first time. @param[in,out] latency The statistics. A
 *  wait is not counted when memory runs out. */
void latency_on_presented(Latency *latency, double time);

/** @return What the waits come to. @param[in,out] latency The statistics; sorted by this. */
LatencySummary latency_summary(Latency *latency);

/** Gives the memory back. */
void latency_deinit(Latency *latency);

#endif
