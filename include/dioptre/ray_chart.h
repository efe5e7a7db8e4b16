/**
 * @file
 * @brief The rays of a pixel as a drawing: an SVG file, as seen from beside.
 */
#ifndef DIOPTRE_RAY_CHART_H
#define DIOPTRE_RAY_CHART_H

#include "render/orbit_camera.h"

/** What is drawn. */
typedef struct RayChart {
    const Scene *scene;             /**< The scene. */
    const RenderSettings *settings; /**< How it is traced. */
    const Renderer *renderer;       /**< Who traced it. */
    const RayTree *probe;           /**< The rays, at least one. */
    const char *title;              /**< Stands over it. */
} RayChart;

/**
 * Draws the rays over a faint drawing of the scene.
 * @param chart       What is drawn.
 * @param path        The file to write; an old one stays whole until the new one is.
 * @param[out] error  What is wrong.
 * @return Whether it is there.
 */
bool ray_chart_write(const RayChart *chart, const char *path, Error *error);

#endif
