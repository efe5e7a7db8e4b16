/**
 * @file
 * @brief The chart of the settings that were tried: time against error, and which are best.
 */
#ifndef DIOPTRE_VIEW_STATE_SETTINGS_CHART_H
#define DIOPTRE_VIEW_STATE_SETTINGS_CHART_H

#include "dioptre/renderer.h"

/** Most points; the oldest goes. */
enum { SETTINGS_CHART_POINTS = 24 };
/** Bytes of the name of a point with the final zero. */
enum { SETTINGS_NAME_SIZE = 64 };

/** One setting. */
typedef struct SettingsPoint {
    RenderSettings settings; /**< The settings; no other point of a chart has the same name. */
    double seconds;          /**< Time of a whole picture. */
    double error;            /**< Error of its picture, RMS in steps of 255. */
    bool is_pareto;          /**< Whether none is both faster and more accurate. */
} SettingsPoint;

/** The chart. Starts as `{0}`: empty. */
typedef struct SettingsChart {
    SettingsPoint points[SETTINGS_CHART_POINTS]; /**< The points, the oldest first. */
    size_t count;                                /**< Number of them. */
} SettingsChart;

/** Names settings in the user's language by what keys change of them, such as `float, bound, 8 ×
 * 16`: depth and samples. */
void settings_name_write(const RenderSettings *settings, char name[SETTINGS_NAME_SIZE]);

/** @return Whether two settings have the same name. */
bool settings_have_same_name(const RenderSettings *a, const RenderSettings *b);

/** @return Whether settings have a point. */
bool settings_chart_has(const SettingsChart *chart, const RenderSettings *settings);

/** Adds a point, or replaces that of the same name, and finds the Pareto front. */
void settings_chart_add(SettingsChart *chart, const RenderSettings *settings, double seconds,
                        double error);

#endif
