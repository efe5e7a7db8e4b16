/**
 * @file
 * @brief The output of `dioptre probe`: text and JSON.
 */
#ifndef DIOPTRE_CLI_PROBE_H
#define DIOPTRE_CLI_PROBE_H

#include "dioptre/renderer.h"

/** The probed pixel. */
typedef struct ProbeReport {
    const Scene *scene;      /**< The scene. */
    const char *path;        /**< Its file, or `-`. */
    RenderSettings settings; /**< Its settings. */
    int x;                   /**< The pixel's column. */
    int y;                   /**< Its row. */
    const RayTree *tree;     /**< Its rays, at least one. */
    int ray;                 /**< Index of the chosen ray; -1: none. */
} ProbeReport;

/** Prints it as text. */
void probe_print(const ProbeReport *report);

/** Prints the formulas of the chosen ray, and its sum. */
void probe_print_ray(const ProbeReport *report);

/** Prints it as JSON, one object per ray. */
void probe_print_json(const ProbeReport *report);

/** A colour of 8 bits per channel. */
typedef struct ProbePixel {
    int channels[3]; /**< Red, green and blue, 0 to 255. */
} ProbePixel;

/** @return The pixel as in a picture of one sample. */
ProbePixel probe_pixel(const ProbeReport *report);

#endif
