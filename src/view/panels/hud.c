/**
 * @file
 * @brief Writing the panel on a picture, and the title.
 */
#include "view/panels/hud.h"

#include "base/language.h"
#include "dioptre/scene.h"

#include <libintl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/** Minimum seconds between two changes while a picture is drawn. */
static const double UPDATE_INTERVAL = 0.2;
/** Smallest percentage that is shown. */
static const double MINIMUM_PERCENT = 0.001;

/** Adds a row. @param format Its text, as for printf. @return The row; the last one if all rows are
 *  used. */
static GuiRow *hud_add_row(Hud *hud, const char *label, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static GuiRow *hud_add_row(Hud *hud, const char *label, const char *format, ...) {
    size_t index = hud->count < HUD_ROWS ? hud->count++ : HUD_ROWS - 1;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(hud->row_texts[index], HUD_TEXT_SIZE, format, arguments);
    va_end(arguments);
    hud->rows[index] = (GuiRow){.text = hud->row_texts[index]};
    SDL_strlcpy(hud->rows[index].label, label, GUI_LABEL_SIZE);
    return &hud->rows[index];
}

/** Adds the offset strategy. */
static void add_offset(Hud *hud, const TraceSettings *trace) {
    const char *name = offset_strategy_names[trace->offset];
    if (trace->offset == OFFSET_FIXED) {
        hud_add_row(hud, gettext("offset"), "%s, ε = %.3g", name, trace->epsilon);
    } else {
        hud_add_row(hud, gettext("offset"), "%s", name);
    }
}

/** Adds the time of a picture, and the cost of the last change. */
static void add_cost(Hud *hud, const Viewport *viewport) {
    double milliseconds = viewport->render_seconds * 1e3,
           previous = viewport->previous_render_seconds * 1e3;
    /** A million rays. */
    const double million = 1e6;
    if (milliseconds > 0 && previous > 0) {
        hud_add_row(hud, gettext("picture"), "%.1f ms, %+.1f (× %.2g)", milliseconds,
                    milliseconds - previous, milliseconds / previous);
    } else if (milliseconds > 0) {
        hud_add_row(hud, gettext("picture"), "%.1f ms", milliseconds);
    }
    if (viewport->report.is_finished) {
        double rays = (double)ray_counts_sum(&viewport->report.rays) / million;
        hud_add_row(hud, gettext("rays"), gettext("%.3g million"), rays);
        if (viewport->report.rays.unresolved > 0) {
            hud_add_row(hud, gettext("lacking light"), gettext("%.2g %%, up to %.2g steps"),
                        100 * (double)viewport->report.rays.unresolved /
                            (double)viewport->report.rays.camera,
                        viewport->report.rays.unresolved_steps);
        }
    }
}

/** Adds the settings of a picture. */
static void add_settings(Hud *hud, const Viewport *viewport) {
    const RenderSettings *settings = &viewport->settings;
    unsigned long count = (unsigned long)settings->samples;
    hud_add_row(hud, gettext("engine"), "%s", settings->engine->name);
    add_offset(hud, &settings->trace);
    hud_add_row(hud, gettext("depth"), ngettext("%d, %d sample", "%d, %d samples", count),
                settings->trace.depth, settings->samples);
    hud_add_row(hud, gettext("light"), "%s", gettext(light_mode_name(settings->lighting)));
    if (settings->trace.pixel_point != PIXEL_CENTER) {
        hud_add_row(hud, gettext("rays go"), "%s",
                    gettext(pixel_point_name(settings->trace.pixel_point)));
    }
    if (settings->method_set != METHODS_OWN) {
        hud_add_row(hud, gettext("methods"), "%s", gettext(method_set_name(settings->method_set)));
    }
    add_cost(hud, viewport);
}

/** Adds a heading. @param more Its second part, translated; empty: none. */
static void add_heading(Hud *hud, const char *name, const char *more) {
    hud_add_row(hud, "", "%s%s%s", name, more[0] != '\0' ? ", " : "", more)->is_heading = true;
}

/** Adds a colour to a row. */
static void add_swatch(GuiRow *row, const LegendEntry *tick) {
    row->has_swatch = true;
    memcpy(row->swatch, tick->rgb, sizeof row->swatch);
}

/** Adds the rows of a legend. */
static void add_ticks(Hud *hud, const LegendEntry *ticks, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const char *text = ticks[i].label ? gettext(ticks[i].label) : ticks[i].number;
        add_swatch(hud_add_row(hud, "", "%s", text), &ticks[i]);
    }
}

/** Adds a number of pixels. @return The row. */
static GuiRow *add_fraction(Hud *hud, const char *kind, uint64_t count, uint64_t all) {
    double percent = all > 0 ? 100 * (double)count / (double)all : 0;
    unsigned long long number = count;
    if (percent < MINIMUM_PERCENT) {
        return hud_add_row(hud, "", gettext("%s: %llu"), kind, number);
    }
    return hud_add_row(hud, "", gettext("%s: %llu (%.3g %%)"), kind, number, percent);
}

/** Adds the numbers of faulty pixels. @param ticks The colours of acne and of leaks. */
static void add_faults(Hud *hud, const LayerStats *report, const LegendEntry ticks[2]) {
    const uint64_t counts[] = {report->artifact_pixels, report->leak_pixels};
    for (int i = 0; i < 2; i++) {
        const char *kind = gettext(ticks[i].label);
        add_swatch(add_fraction(hud, kind, counts[i], report->pixel_count), &ticks[i]);
    }
}

/** Adds the legend of a layer. */
static void add_layer(Hud *hud, const LayerStats *report) {
    LegendEntry ticks[LEGEND_ENTRIES_MAXIMUM];
    const char *unit = layer_unit(report->layer);
    add_heading(hud, gettext(layer_name(report->layer)), unit[0] != '\0' ? gettext(unit) : "");
    size_t count = layer_legend(report->layer, &report->scale, ticks);
    if (report->layer == LAYER_ACNE) {
        add_faults(hud, report, ticks);
    } else {
        add_ticks(hud, ticks, count);
    }
    if (report->layer == LAYER_ERROR || report->layer == LAYER_ROUNDING) {
        const char *kind = report->layer == LAYER_ERROR ? gettext("off by over a step")
                                                        : gettext("change by over a step");
        add_fraction(hud, kind, report->artifact_pixels, report->pixel_count);
    }
}

/** Adds the legend of a difference. */
static void add_difference(Hud *hud, const DifferenceMap *difference) {
    LegendEntry ticks[LEGEND_ENTRIES_MAXIMUM];
    add_heading(hud, gettext("left minus right"), gettext("steps of 255"));
    add_ticks(hud, ticks, difference_map_legend(ticks));
    add_fraction(hud, gettext("off by over a step"), difference->differing_pixels,
                 difference->pixel_count);
    hud_add_row(hud, "", gettext("at most: %d"), difference->max_difference);
}

/** Writes all rows. */
static void write_rows(Hud *hud, const HudContent *content) {
    const Viewport *viewport = content->viewport;
    hud->count = 0;
    if (content->title) {
        add_heading(hud, gettext(content->title), "");
    }
    if (content->shows_settings) {
        add_settings(hud, viewport);
    }
    if (content->difference) {
        add_difference(hud, content->difference);
    } else if (!content->hides_layer && viewport->report.layer.layer != LAYER_SHADED) {
        add_layer(hud, &viewport->report.layer);
    }
}

/** @return Whether two panels have equal rows. */
static bool hud_is_equal(const Hud *a, const Hud *b) {
    bool is_equal = a->count == b->count;
    for (size_t i = 0; is_equal && i < a->count; i++) {
        is_equal = strcmp(a->row_texts[i], b->row_texts[i]) == 0 &&
                   strcmp(a->rows[i].label, b->rows[i].label) == 0 &&
                   memcmp(a->rows[i].swatch, b->rows[i].swatch, sizeof a->rows[i].swatch) == 0;
    }
    return is_equal;
}

void hud_update(Hud *hud, const HudContent *content, double now) {
    Hud next = {.count = 0};
    if (now < hud->next_update_time && !content->viewport->report.is_finished) {
        return;
    }
    write_rows(&next, content);
    if (!hud_is_equal(hud, &next)) {
        write_rows(hud, content);
        hud->next_update_time = now + UPDATE_INTERVAL;
    }
}

GuiRect hud_show(const Hud *hud, const char *id, const GuiPlace *place) {
    GuiRect extent = {place->room.x, place->room.y, 0, 0};
    if (hud->count > 0) {
        gui_rows_panel(id, place, hud->rows, hud->count, (GuiCell){-1, 0}, &extent);
    }
    return extent;
}

void hud_invalidate(Hud *hud) {
    hud->next_update_time = 0;
}

/* --- the window's title ----------------------------------------------------------------------- */

/** Appends to a title. @param format In English, as for printf; translated here. */
static void title_add(char title[TITLE_SIZE], const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void title_add(char title[TITLE_SIZE], const char *format, ...) {
    size_t used = strlen(title);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(title + used, TITLE_SIZE - used, gettext(format), arguments);
    va_end(arguments);
}

/** Appends layer, pass and speed. */
static void add_report(char title[TITLE_SIZE], const RenderStats *report) {
    /** A million rays; the shortest time that is divided by, seconds. */
    const double million = 1e6, instant = 1e-9;
    uint64_t rays = ray_counts_sum(&report->rays);
    double seconds = report->seconds > instant ? report->seconds : instant;
    int samples = report->samples;
    if (report->layer.layer != LAYER_SHADED) {
        title_add(title, ", %s", gettext(layer_name(report->layer.layer)));
    }
    title_add(title, ", pass %d px", report->stride);
    title_add(title, ngettext(", %d sample", ", %d samples", (unsigned long)samples), samples);
    title_add(title, ", %.1f ms, %.0f Mrays/s", report->seconds * 1e3,
              (double)rays / seconds / million);
    if (report->is_finished) {
        title_add(title, ", finished");
    }
}

void title_write(const TitleContent *content, char title[TITLE_SIZE]) {
    title[0] = '\0';
    title_add(title, "%s — %d×%d", content->name, content->width, content->height);
    if (content->report) {
        add_report(title, content->report);
    }
    if (content->time) {
        title_add(title, " — t %.15g s", *content->time);
    }
    if (content->is_running) {
        title_add(title, ", running");
    }
    if (content->is_recording) {
        title_add(title, " — recording a lesson");
    }
    if (content->light_count > 1) {
        title_add(title, " — light %zu of %zu", content->light + 1, content->light_count);
    }
    if (content->status_text[0] != '\0') {
        title_add(title, " — %s", content->status_text);
    }
}
