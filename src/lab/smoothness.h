/**
 * @file
 * @brief How smooth edges and soft shadows are with so many rays a pixel.
 */
#ifndef DIOPTRE_LAB_SMOOTHNESS_H
#define DIOPTRE_LAB_SMOOTHNESS_H

#include "lab/contrast.h"

/** What some samples leave. */
typedef struct Smoothness {
    int samples;  /**< Rays a pixel. */
    double rms;   /**< By how many steps pixels change with four times as many: root of the mean
                       square of those that change by half a step or more. */
    double share; /**< Share of the pixels that do. */
} Smoothness;

/**
 * Looks what the samples of a manner leave against four times as many; where half as many leave
 * nothing, those are enough, and so on.
 * @param studio           What is shot.
 * @param manner           How; #TraceSettings.samples are wanted.
 * @param[out] smoothness  What is left.
 * @param[out] error       What is wrong.
 * @return false if anything is.
 */
bool smoothness_find(const Studio *studio, const Manner *manner, Smoothness *smoothness,
                     Error *error);

#endif
