/**
 * @file
 * @brief What `dioptre probe` tells of a pixel: in words, as JSON, as a drawing.
 */
#ifndef DIOPTRE_CLI_PROBE_H
#define DIOPTRE_CLI_PROBE_H

#include "dioptre/renderer.h"

/** What is told. */
typedef struct ProbeReport {
    const Scene *scene;      /**< The scene. */
    const char *path;        /**< Its file, or `-`. */
    RenderSettings settings; /**< How it is drawn. */
    int x;                   /**< The pixel's column. */
    int y;                   /**< Its row. */
    const Probe *probe;      /**< Its rays, at least one. */
} ProbeReport;

/** Tells it in words. @param report What is told. */
void probe_print(const ProbeReport *report);

/** Tells it for programs, an object a ray. @param report What is told. */
void probe_print_json(const ProbeReport *report);

/**
 * Draws the rays as seen from beside.
 * @param report    What is told.
 * @param renderer  Who traced them.
 * @param path      The SVG file to write.
 * @param[out] error  What is wrong.
 * @return Whether it is there.
 */
bool probe_draw(const ProbeReport *report, const Renderer *renderer, const char *path,
                Error *error);

/** A light in 8-bit steps. */
typedef struct ProbeSteps {
    int step[3]; /**< Red, green and blue, 0 to 255. */
} ProbeSteps;

/** @return The pixel as a picture of one sample shows it. @param report What is told. */
ProbeSteps probe_steps(const ProbeReport *report);

/** @return The keyword of the shape that a ray met. @param report What is told. @param ray The ray,
 *  which met one. */
const char *probe_shape(const ProbeReport *report, const ProbeRay *ray);

/** @return The angle of incidence, degrees. @param ray A ray that met a surface. */
double probe_angle(const ProbeRay *ray);

#endif
