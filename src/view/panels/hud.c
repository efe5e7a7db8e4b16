/**
 * @file
 * @brief Writing the panel on a picture, and the title.
 */
#include "view/panels/hud.h"

#include "base/language.h"
#include "base/typeset_numbers.h"
#include "dioptre/scene.h"
#include "view/state/settings_words.h"

#include <libintl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/** Minimum seconds between two changes while a picture is drawn. */
static const double UPDATE_INTERVAL = 0.2;

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
    typeset_numbers(hud->row_texts[index], HUD_TEXT_SIZE);
    hud->rows[index] = (GuiRow){.text = hud->row_texts[index]};
    SDL_strlcpy(hud->rows[index].label, label, GUI_LABEL_SIZE);
    return &hud->rows[index];
}

/** Adds the offset strategy. */
static void add_offset(Hud *hud, const TraceSettings *trace) {
    const char *name = offset_strategy_word(trace->offset);
    if (trace->offset == OFFSET_FIXED) {
        hud_add_row(hud, gettext("offset"), "%s, ε = %.3g", name, trace->epsilon);
    } else {
        hud_add_row(hud, gettext("offset"), "%s", name);
    }
}

/** @return How many of the camera rays lack light, %: their paths met a guard. See
 *          #RayCounts.unresolved. */
static double lacking_percent(const RayCounts *rays) {
    return 100 * (double)rays->unresolved / (double)rays->camera;
}

/** Adds the time until all pixels had a ray, which changes are compared by, as it is known soonest;
 *  and that of the finished picture, which the title has. */
static void add_cost(Hud *hud, const Viewport *viewport) {
    double milliseconds = viewport->render_seconds * 1e3,
           previous = viewport->previous_render_seconds * 1e3;
    /** A million rays. */
    const double million = 1e6;
    if (milliseconds > 0 && previous > 0) {
        hud_add_row(hud, gettext("first pass"), "%.1f ms, %+.1f (× %.2g)", milliseconds,
                    milliseconds - previous, milliseconds / previous);
    } else if (milliseconds > 0) {
        hud_add_row(hud, gettext("first pass"), "%.1f ms", milliseconds);
    }
    if (viewport->report.is_finished) {
        hud_add_row(hud, gettext("in all"), "%.1f ms", viewport->report.seconds * 1e3);
        double rays = (double)ray_counts_sum(&viewport->report.rays) / million;
        hud_add_row(hud, gettext("rays"), gettext("%.3g million"), rays);
        if (viewport->report.rays.unresolved > 0) {
            hud_add_row(hud, gettext("lacking light"), gettext("%.2g %%, up to %.2g steps"),
                        lacking_percent(&viewport->report.rays),
                        viewport->report.rays.unresolved_steps);
        }
    }
}

/** Adds the settings of a picture. */
static void add_settings(Hud *hud, const Viewport *viewport) {
    const RenderSettings *settings = &viewport->settings;
    // A layer has one ray per pixel, whatever the picture has.
    int samples = viewport->layer == LAYER_SHADED ? settings->samples : 1;
    unsigned long count = (unsigned long)samples;
    char engine[ENGINE_WORDS_SIZE];
    engine_words_write(settings->engine->name, engine);
    hud_add_row(hud, gettext("engine"), "%s", engine);
    add_offset(hud, &settings->trace);
    hud_add_row(hud, gettext("depth"), ngettext("%d, %d sample", "%d, %d samples", count),
                settings->trace.depth, samples);
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

/** Writes all rows. */
static void write_rows(Hud *hud, const HudContent *content) {
    const Viewport *viewport = content->viewport;
    hud->count = 0;
    if (content->title) {
        hud_add_row(hud, "", "%s", gettext(content->title))->is_heading = true;
    }
    if (content->shows_settings) {
        add_settings(hud, viewport);
    }
}

/** @return Whether two panels have equal rows. */
static bool hud_is_equal(const Hud *a, const Hud *b) {
    bool is_equal = a->count == b->count;
    for (size_t i = 0; is_equal && i < a->count; i++) {
        is_equal = strcmp(a->row_texts[i], b->row_texts[i]) == 0 &&
                   strcmp(a->rows[i].label, b->rows[i].label) == 0;
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

/** Appends layer, pass and, unless the title is to be short, samples and speed. */
static void add_report(char title[TITLE_SIZE], const RenderStats *report, bool is_short) {
    /** A million rays; the shortest time that is divided by, seconds. */
    const double million = 1e6, instant = 1e-9;
    uint64_t rays = ray_counts_sum(&report->rays);
    double seconds = report->seconds > instant ? report->seconds : instant;
    int samples = report->samples;
    if (report->layer.layer != LAYER_SHADED) {
        title_add(title, ", %s", gettext(layer_name(report->layer.layer)));
    }
    title_add(title, ", pass %d px", report->stride);
    if (!is_short) {
        title_add(title, ngettext(", %d sample", ", %d samples", (unsigned long)samples), samples);
        title_add(title, ", %.1f ms, %.0f Mrays/s", report->seconds * 1e3,
                  (double)rays / seconds / million);
    }
    if (report->is_finished) {
        title_add(title, ", finished");
    }
    if (report->is_finished && report->rays.unresolved > 0) {
        title_add(title, ", %.2g %% lack light", lacking_percent(&report->rays));
    }
}

/** Writes the title. @param is_short See #add_report. */
static void write_title(const TitleContent *content, bool is_short, char title[TITLE_SIZE]) {
    title[0] = '\0';
    title_add(title, "%s", content->name);
    const size_t name_length = strlen(title);
    title_add(title, " — %d×%d", content->width, content->height);
    if (content->report) {
        add_report(title, content->report, is_short);
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
    language_localize_numbers(title + name_length, TITLE_SIZE - name_length);
    if (content->status_text[0] != '\0') {
        title_add(title, " — %s", content->status_text);
    }
}

void title_write(const TitleContent *content, char title[TITLE_SIZE]) {
    write_title(content, false, title);
    // The window manager would cut it anywhere, also in the message, which a reader looks for.
    if (content->room > 0 && SDL_utf8strlen(title) > content->room) {
        write_title(content, true, title);
    }
}
