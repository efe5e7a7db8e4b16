/**
 * @file
 * @brief Filling and showing the chart of settings.
 */
#include "view/panels/settings_chart_panel.h"

#include "base/language.h"
#include "view/gui/gui.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Part of the window's width for the panel. */
static const float PANEL_WIDTH = 0.6F;
/** Its least width, in heights of letters: beside the inspector it takes what is left. */
static const float PANEL_WIDTH_MINIMUM = 18;
/** Room above it for a message, in heights of letters. */
static const float TOAST_ROOM = 2.5F;
/** Bytes of a note with the final zero. */
enum { NOTE_SIZE = 256 };

void settings_chart_panel_toggle(SettingsChartPanel *panel) {
    panel->is_open = !panel->is_open;
}

void settings_chart_panel_clear(SettingsChartPanel *panel) {
    error_meter_reset(&panel->meter);
    panel->chart.count = panel->pending_count = 0;
    panel->has_failed = false;
}

void settings_chart_panel_deinit(SettingsChartPanel *panel) {
    error_meter_reset(&panel->meter);
}

/** Takes a measured point. @return Whether there is one. */
static bool take_point(SettingsChartPanel *panel) {
    double error = 0;
    bool is_taken = error_meter_take(&panel->meter, &error);
    if (is_taken && !isnan(error) && panel->pending_count > 0) {
        const SettingsPoint *point = &panel->pending[0];
        settings_chart_add(&panel->chart, &point->settings, point->seconds, error);
        panel->pending_count--;
        memmove(panel->pending, panel->pending + 1, panel->pending_count * sizeof *panel->pending);
    }
    return is_taken;
}

/** Notes settings and time of the picture on screen, unless they have a point or will have one. */
static void note_picture(SettingsChartPanel *panel, const Viewport *viewport) {
    SettingsPoint next = {.settings = viewport->settings, .seconds = viewport->report.seconds};
    next.settings.width = viewport->width;
    next.settings.height = viewport->height;
    bool is_known = settings_chart_has(&panel->chart, &next.settings);
    for (size_t i = 0; i < panel->pending_count; i++) {
        is_known = is_known || settings_have_same_name(&panel->pending[i].settings, &next.settings);
    }
    if (!is_known && panel->pending_count < PENDING_SETTINGS) {
        panel->pending[panel->pending_count++] = next;
    }
}

/** Starts to measure what is pending. @return Whether it has started. */
static bool start_pending(SettingsChartPanel *panel, const Scene *scene) {
    Error error = {0};
    if (panel->pending_count == 0 || panel->meter.is_busy || panel->has_failed) {
        return false;
    }
    panel->has_failed =
        !error_meter_start(&panel->meter, scene, &panel->pending[0].settings, &error);
    return true;
}

bool settings_chart_panel_update(SettingsChartPanel *panel, const Viewport *viewport,
                                 const Scene *scene) {
    bool is_drawn =
        viewport_is_finished(viewport) && !viewport->needs_new_renderer && !viewport->is_report_old;
    if (viewport->settings.lighting != panel->lighting) {
        settings_chart_panel_clear(panel);
        panel->lighting = viewport->settings.lighting;
    }
    bool has_changed = take_point(panel);
    if (!is_drawn || !panel->is_open) {
        error_meter_stop(&panel->meter); // Or the picture would take longer than it does alone.
        return has_changed;
    }
    if (viewport->report.layer.layer == LAYER_SHADED) {
        note_picture(panel, viewport);
    }
    return start_pending(panel, scene) || has_changed;
}

/** Writes what is measured, and how. */
static void write_notes(const SettingsChartPanel *panel, char notes[2][NOTE_SIZE]) {
    snprintf(notes[0], NOTE_SIZE,
             gettext("Time: of this picture. Error: of a picture of %d pixels, against %d samples "
                     "in double."),
             ERROR_METER_PIXELS, ERROR_METER_SAMPLES);
    if (panel->meter.is_busy) {
        char name[SETTINGS_NAME_SIZE];
        settings_name_write(&panel->pending[0].settings, name);
        snprintf(notes[1], NOTE_SIZE, gettext("Measuring %s"), name);
    } else if (panel->has_failed) {
        snprintf(notes[1], NOTE_SIZE, "%s", gettext("There is no memory to measure."));
    } else {
        snprintf(notes[1], NOTE_SIZE, "%s",
                 gettext("Change number type, offset, depth or samples: each adds its point."));
    }
}

/** @return Why a chart has no point yet. */
static const char *reason_for_none(const Viewport *viewport) {
    return viewport->layer != LAYER_SHADED
               ? gettext(
                     "A layer has no error to compare: show the light (key 1), and its settings "
                     "get their points.")
               : gettext("The first point comes when the picture is finished and measured.");
}

float settings_chart_panel_width(float room) {
    return fminf(room, fmaxf(PANEL_WIDTH * room, PANEL_WIDTH_MINIMUM * gui_text_size()));
}

void settings_chart_panel_show(const SettingsChartPanel *panel, const Viewport *viewport,
                               const SDL_Rect *area) {
    GuiChartPoint points[SETTINGS_CHART_POINTS];
    char notes[2][NOTE_SIZE], rows[SETTINGS_CHART_POINTS][NOTE_SIZE];
    for (size_t i = 0; i < panel->chart.count; i++) {
        const SettingsPoint *point = &panel->chart.points[i];
        char name[SETTINGS_NAME_SIZE];
        settings_name_write(&point->settings, name);
        snprintf(rows[i], NOTE_SIZE, gettext("%s: %.4g ms, %.3g steps"), name, point->seconds * 1e3,
                 point->error);
        language_localize_numbers(rows[i], NOTE_SIZE);
        points[i] = (GuiChartPoint){
            .name = rows[i],
            .x = point->seconds * 1e3,
            .y = point->error,
            .is_front = point->is_pareto,
            .is_shown = settings_have_same_name(&point->settings, &viewport->settings)};
        snprintf(points[i].label, sizeof points[i].label, "%u", (unsigned)(i + 1) % 100);
    }
    write_notes(panel, notes);
    GuiChart chart = {.title = gettext("time against error"),
                      .x_label = gettext("ms per picture"),
                      .y_label = gettext("error, RMS in steps of 255"),
                      .points = points,
                      .count = (int)panel->chart.count,
                      .reason = reason_for_none(viewport),
                      .notes = (const char *const[]){notes[0], notes[1]},
                      .note_count = 2};
    float width = settings_chart_panel_width((float)area->w);
    float height = (float)area->h - TOAST_ROOM * gui_text_size();
    GuiPoint corner = {(float)(area->x + area->w) - width,
                       (float)area->y + TOAST_ROOM * gui_text_size()};
    gui_chart(&chart, corner, (GuiPoint){width, height});
}
