/**
 * @file
 * @brief The panel that charts time against error: one point for each setting that was tried.
 */
#ifndef DIOPTRE_VIEW_PANELS_SETTINGS_CHART_PANEL_H
#define DIOPTRE_VIEW_PANELS_SETTINGS_CHART_PANEL_H

#include "view/loading/error_meter.h"
#include "view/state/settings_chart.h"
#include "view/window/viewport.h"

/** Most settings whose error is still to be measured. */
enum { PENDING_SETTINGS = 8 };

/** The panel. Starts as `{0}`: closed. */
typedef struct SettingsChartPanel {
    bool is_open;                            /**< Whether it is shown; else nothing is added. */
    SettingsChart chart;                     /**< The points of this view. */
    ErrorMeter meter;                        /**< Measures the first of #pending. */
    SettingsPoint pending[PENDING_SETTINGS]; /**< Points whose error is to be measured, in turn. */
    size_t pending_count;                    /**< Number of them. */
    LightingMode lighting;                   /**< Under which light the points were measured. */
    bool has_failed; /**< Whether there was no memory: nothing is measured any more. */
} SettingsChartPanel;

/** Shows or hides it. */
void settings_chart_panel_toggle(SettingsChartPanel *panel);

/** Removes all points: the view has changed. */
void settings_chart_panel_clear(SettingsChartPanel *panel);

/** Ends its thread and frees its memory. */
void settings_chart_panel_deinit(SettingsChartPanel *panel);

/**
 * Takes a measured point, and measures the settings of a finished picture that have none.
 * @param viewport  The picture on screen.
 * @param scene     The scene as it is now.
 * @return Whether the panel has changed.
 */
bool settings_chart_panel_update(SettingsChartPanel *panel, const Viewport *viewport,
                                 const Scene *scene);

/** @return The width of the panel, which lies at the right. @param room That of its area, screen
 *  units. */
float settings_chart_panel_width(float room);

/** Shows the panel. @param area Where it may lie, screen units. */
void settings_chart_panel_show(const SettingsChartPanel *panel, const Viewport *viewport,
                               const SDL_Rect *area);

#endif
