/**
 * @file
 * @brief Draws the rays of a pixel, seen from the side, as an SVG file.
 */
#ifndef DIOPTRE_LAB_CHARTS_RAY_CHART_H
#define DIOPTRE_LAB_CHARTS_RAY_CHART_H

#include "render/orbit_camera.h"

/** What is drawn. */
typedef struct RayChart {
    const Scene *scene;             /**< The scene. */
    const RenderSettings *settings; /**< How it is traced. */
    const Renderer *renderer;       /**< The renderer that traced it. */
    const RayTree *probe;           /**< The rays, at least one. */
    const char *title;              /**< Drawn above it. */
} RayChart;

/**
 * Draws the rays over a faint drawing of the scene.
 * @param path        The file to write; an old one stays whole until the new one is.
 * @param[out] error  What is wrong.
 * @return Whether the file is written.
 */
bool ray_chart_write(const RayChart *chart, const char *path, Error *error);

#endif
