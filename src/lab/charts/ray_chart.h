/**
 * @file
 * @brief Draws the rays of a pixel, seen from the side, as an SVG file.
 */
#ifndef DIOPTRE_LAB_CHARTS_RAY_CHART_H
#define DIOPTRE_LAB_CHARTS_RAY_CHART_H

#include "render/orbit_camera.h"

/** In place of the index of a chosen ray: there is none. */
#define RAY_CHART_NO_RAY SIZE_MAX

/** What is drawn. */
typedef struct RayChart {
    const Scene *scene;             /**< The scene. */
    const RenderSettings *settings; /**< How it is traced. */
    const Renderer *renderer;       /**< The renderer that traced it. */
    const RayTree *probe;           /**< The rays, at least one. */
    const char *title;              /**< Drawn above it. */
    size_t selected;                /**< Index of the chosen ray; #RAY_CHART_NO_RAY: none. */
} RayChart;

/**
 * Draws the rays over a faint drawing of the scene, with a plan and a view from the side beside it.
 * If a ray is chosen, all others are dim; below are its formulas, and its march or its hit under
 * the microscope.
 * @param path        The file to write; an old one stays whole until the new one is.
 * @param[out] error  What is wrong.
 * @return Whether the file is written.
 */
bool ray_chart_write(const RayChart *chart, const char *path, Error *error);

#endif
