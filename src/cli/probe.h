/**
 * @file
 * @brief What `dioptre probe` tells of a pixel: in words and as JSON.
 */
#ifndef DIOPTRE_CLI_PROBE_H
#define DIOPTRE_CLI_PROBE_H

#include "render/orbit_camera.h"

/** What is told. */
typedef struct ProbeReport {
    const Scene *scene;      /**< The scene. */
    const char *path;        /**< Its file, or `-`. */
    RenderSettings settings; /**< How it is drawn. */
    int x;                   /**< The pixel's column. */
    int y;                   /**< Its row. */
    const RayTree *tree;     /**< Its rays, at least one. */
} ProbeReport;

/** Tells it in words. */
void probe_print(const ProbeReport *report);

/** Tells it for programs, an object a ray. */
void probe_print_json(const ProbeReport *report);

/** A light in 8-bit steps. */
typedef struct ProbePixel {
    int channels[3]; /**< Red, green and blue, 0 to 255. */
} ProbePixel;

/** @return The pixel as a picture of one sample shows it. */
ProbePixel probe_pixel(const ProbeReport *report);

#endif
