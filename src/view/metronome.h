/**
 * @file
 * @brief The clock of a lesson: what keys do falls on its beats, so that a lesson that is played
 *        does to the bit what was done when it was recorded, however fast the machines are.
 *
 * Its time is whole milliseconds from the lesson's beginning. What happens between two beats is
 * done in the order of time; what happens on a beat is done before it.
 */
#ifndef DIOPTRE_VIEW_METRONOME_H
#define DIOPTRE_VIEW_METRONOME_H

#include "view/motion.h"

#include <stdint.h>

/** Milliseconds from one beat to the next: a frame of a common screen. */
enum { METRONOME_BEAT = 16 };

/** What is moved at a beat. @param context Its own. @param light How far the light goes.
 *  @param camera How far the camera goes. */
typedef void MetronomeMover(void *context, Movement light, Movement camera);

/** The clock. Starts as `{.motion = {.speed = 1}}`, with who moves things. */
typedef struct Metronome {
    MetronomeMover *move; /**< Moves things. */
    void *context;        /**< Handed to it. */
    int64_t now;          /**< Up to when all is done, milliseconds. */
    int64_t beat;         /**< The next beat, milliseconds. */
    Motion motion;        /**< The keys that are held. */
} Metronome;

/** @return The time up to which all is done, seconds. @param metronome The clock. */
double metronome_seconds(const Metronome *metronome);

/** Does what is to be done before a moment. @param[in,out] metronome The clock.
 *  @param until The moment, milliseconds; not before what is done. */
void metronome_go(Metronome *metronome, int64_t until);

/** @return The next moment at which something is to be done, milliseconds; INT64_MAX: none, until a
 *          key goes down. @param metronome The clock. */
int64_t metronome_next(const Metronome *metronome);

#endif
