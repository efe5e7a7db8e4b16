/**
 * @file
 * @brief Writing what is said beside a picture.
 */
#include "view/panels/hud.h"

#include "base/language.h"
#include "dioptre/offset_strategy.h"

#include <libintl.h>
#include <stdarg.h>
#include <string.h>

/** Seconds that words stand at least while a picture is drawn. */
static const double UPDATE_INTERVAL = 0.2;
/** Smaller shares are not said beside their number. */
static const double MINIMUM_PERCENT = 0.001;
/** How large its letters are, of those of the help: there is a picture to be seen. */
static const double FONT_SCALE = 0.7;

/**
 * Adds a row.
 * @param format  Its words, as for printf.
 * @return The row; the last one where there is no room.
 */
static PanelRow *hud_add_row(Hud *hud, const char *label, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static PanelRow *hud_add_row(Hud *hud, const char *label, const char *format, ...) {
    size_t index = hud->count < HUD_ROWS ? hud->count++ : HUD_ROWS - 1;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(hud->row_texts[index], HUD_TEXT_SIZE, format, arguments);
    va_end(arguments);
    hud->rows[index] = (PanelRow){.text = hud->row_texts[index]};
    SDL_strlcpy(hud->rows[index].label, label, PANEL_LABEL_SIZE);
    return &hud->rows[index];
}

/** Says how rays leave surfaces. */
static void add_offset(Hud *hud, const TraceSettings *trace) {
    const char *name = offset_strategy_names[trace->offset];
    if (trace->offset == OFFSET_FIXED) {
        hud_add_row(hud, gettext("offset"), "%s, ε = %.3g", name, trace->epsilon);
    } else {
        hud_add_row(hud, gettext("offset"), "%s", name);
    }
}

/** Says how long a picture takes, and what the last change has cost. */
static void add_cost(Hud *hud, const Viewport *viewport) {
    double milliseconds = viewport->render_seconds * 1e3,
           previous = viewport->previous_render_seconds * 1e3;
    /** Rays in a million. */
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
    }
}

/** Says how a picture is drawn. */
static void add_settings(Hud *hud, const Viewport *viewport) {
    const RenderSettings *settings = &viewport->settings;
    unsigned long count = (unsigned long)settings->samples;
    hud_add_row(hud, gettext("engine"), "%s", settings->engine->name);
    add_offset(hud, &settings->trace);
    hud_add_row(hud, gettext("depth"), ngettext("%d, %d sample", "%d, %d samples", count),
                settings->trace.depth, settings->samples);
    hud_add_row(hud, gettext("light"), "%s", gettext(light_mode_name(settings->lighting)));
    add_cost(hud, viewport);
}

/** Adds a heading. @param more More words, translated; empty: no more. */
static void add_heading(Hud *hud, const char *name, const char *more) {
    hud_add_row(hud, "", "%s%s%s", name, more[0] != '\0' ? ", " : "", more)->is_heading = true;
}

/** Shows a colour in a row. */
static void add_swatch(PanelRow *row, const LegendEntry *tick) {
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

/** Says how many pixels there are of a kind. @return The row. */
static PanelRow *add_fraction(Hud *hud, const char *kind, uint64_t count, uint64_t all) {
    double percent = all > 0 ? 100 * (double)count / (double)all : 0;
    unsigned long long number = count;
    if (percent < MINIMUM_PERCENT) {
        return hud_add_row(hud, "", gettext("%s: %llu"), kind, number);
    }
    return hud_add_row(hud, "", gettext("%s: %llu (%.3g %%)"), kind, number, percent);
}

/** Says how many pixels are wrong. @param ticks The colours of acne and of leaks. */
static void add_faults(Hud *hud, const LayerStats *report, const LegendEntry ticks[2]) {
    const uint64_t counts[] = {report->artifact_pixels, report->leak_pixels};
    for (int i = 0; i < 2; i++) {
        const char *kind = gettext(ticks[i].label);
        add_swatch(add_fraction(hud, kind, counts[i], report->pixel_count), &ticks[i]);
    }
}

/** Says what the colours of a layer mean. @param report How the layer stands. */
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
    if (report->layer == LAYER_ERROR) {
        add_fraction(hud, gettext("off by over a step"), report->artifact_pixels,
                     report->pixel_count);
    }
}

/** Says what the colours of a difference mean. */
static void add_difference(Hud *hud, const DifferenceMap *difference) {
    LegendEntry ticks[LEGEND_ENTRIES_MAXIMUM];
    add_heading(hud, gettext("left minus right"), gettext("steps of 255"));
    add_ticks(hud, ticks, difference_map_legend(ticks));
    add_fraction(hud, gettext("off by over a step"), difference->differing_pixels,
                 difference->pixel_count);
    hud_add_row(hud, "", gettext("at most: %d"), difference->max_difference);
}

/** Writes everything anew. @param content What there is to be said. */
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

/** @return Whether two panels say the same. */
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
    hud->width_fraction = content->title ? 0.5 : 1;
    write_rows(&next, content);
    if (!hud_is_equal(hud, &next)) {
        overlay_invalidate(&hud->overlay);
        write_rows(hud, content);
        hud->next_update_time = now + UPDATE_INTERVAL;
    }
}

void hud_show(Hud *hud, const OverlayTarget *target) {
    if (hud->count > 0) {
        if (overlay_is_stale(&hud->overlay)) {
            OverlayTarget smaller = {target->renderer, target->scale * FONT_SCALE,
                                     hud->width_fraction};
            overlay_draw(&hud->overlay, &smaller, hud->rows, hud->count);
        }
        overlay_show(&hud->overlay, target);
    }
}

void hud_invalidate(Hud *hud) {
    overlay_invalidate(&hud->overlay);
    hud->next_update_time = 0;
}
