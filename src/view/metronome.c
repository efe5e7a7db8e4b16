/**
 * @file
 * @brief The clock of a lesson.
 */
#include "view/metronome.h"

/** @return A time of a lesson in seconds. @param milliseconds It. */
static double seconds(int64_t milliseconds) {
    return (double)milliseconds / 1000;
}

double metronome_seconds(const Metronome *metronome) {
    return seconds(metronome->now);
}

/** Moves things as far as keys were held up to the next beat. @param[in,out] metronome The clock.
 */
static void strike(Metronome *metronome) {
    Movement light, camera;
    motion_take(&metronome->motion, seconds(metronome->beat), &light, &camera);
    metronome->move(metronome->context, light, camera);
    metronome->beat += METRONOME_BEAT;
}

void metronome_go(Metronome *metronome, int64_t until) {
    while (metronome->beat < until && motion_is_active(&metronome->motion)) {
        strike(metronome);
    }
    if (metronome->beat < until) {
        int64_t beats = (until - metronome->beat + METRONOME_BEAT - 1) / METRONOME_BEAT;
        metronome->beat += beats * METRONOME_BEAT;
    }
    metronome->now = until;
}

int64_t metronome_next(const Metronome *metronome) {
    return motion_is_active(&metronome->motion) ? metronome->beat : INT64_MAX;
}
