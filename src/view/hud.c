/**
 * @file
 * @brief Writing what is said beside a picture.
 */
#include "view/hud.h"

#include "dioptre/language.h"
#include "dioptre/offset.h"

#include <libintl.h>
#include <stdarg.h>
#include <string.h>

/** Seconds that words stand at least while a picture is drawn. */
static const double PAUSE = 0.2;
/** Smaller shares are not said beside their number. */
static const double LEAST_PERCENT = 0.001;
/** How large its letters are, of those of the help: there is a picture to be seen. */
static const double SCALE = 0.7;

/** Adds a row. @param[in,out] hud The panel. @param label Its label, translated. @param format Its
 *  words, as for printf. @return The row; the last one where there is no room. */
static PanelRow *add(Hud *hud, const char *label, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static PanelRow *add(Hud *hud, const char *label, const char *format, ...) {
    size_t place = hud->count < HUD_ROWS ? hud->count++ : HUD_ROWS - 1;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(hud->texts[place], HUD_TEXT, format, arguments);
    va_end(arguments);
    hud->rows[place] = (PanelRow){.text = hud->texts[place]};
    SDL_strlcpy(hud->rows[place].label, label, PANEL_LABEL_SIZE);
    return &hud->rows[place];
}

/** Says how rays leave surfaces. @param[in,out] hud The panel. @param trace The settings. */
static void add_offset(Hud *hud, const TraceSettings *trace) {
    const char *name = offset_names[trace->offset];
    if (trace->offset == OFFSET_FIXED) {
        add(hud, gettext("offset"), "%s, ε = %.3g", name, trace->epsilon);
    } else {
        add(hud, gettext("offset"), "%s", name);
    }
}

/** Says how long a picture takes, and what the last change has cost. @param[in,out] hud The panel.
 *  @param sight The picture. */
static void add_cost(Hud *hud, const Sight *sight) {
    double cost = sight->cost * 1e3, before = sight->cost_before * 1e3;
    /** Rays in a million. */
    const double million = 1e6;
    if (cost > 0 && before > 0) {
        add(hud, gettext("picture"), "%.1f ms, %+.1f (× %.2g)", cost, cost - before, cost / before);
    } else if (cost > 0) {
        add(hud, gettext("picture"), "%.1f ms", cost);
    }
    if (sight->report.is_finished) {
        double rays = (double)ray_counts_sum(&sight->report.rays) / million;
        add(hud, gettext("rays"), gettext("%.3g million"), rays);
    }
}

/** Says how a picture is drawn. @param[in,out] hud The panel. @param sight The picture. */
static void add_settings(Hud *hud, const Sight *sight) {
    const RenderSettings *settings = &sight->settings;
    unsigned long count = (unsigned long)settings->samples;
    add(hud, gettext("engine"), "%s", settings->engine->name);
    add_offset(hud, &settings->trace);
    add(hud, gettext("depth"), ngettext("%d, %d sample", "%d, %d samples", count),
        settings->trace.depth, settings->samples);
    add(hud, gettext("light"), "%s", gettext(tuning_light_name(settings->light)));
    add_cost(hud, sight);
}

/** Adds a heading. @param[in,out] hud The panel. @param name The first word, translated. @param
 * more More words, translated; empty: no more. */
static void add_heading(Hud *hud, const char *name, const char *more) {
    add(hud, "", "%s%s%s", name, more[0] != '\0' ? ", " : "", more)->is_heading = true;
}

/** Shows a colour in a row. @param[in,out] row The row. @param tick The colour. */
static void add_swatch(PanelRow *row, const LayerTick *tick) {
    row->has_swatch = true;
    memcpy(row->swatch, tick->rgb, sizeof row->swatch);
}

/** Adds the rows of a legend. @param[in,out] hud The panel. @param ticks They. @param count How
 *  many. */
static void add_ticks(Hud *hud, const LayerTick *ticks, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const char *words = ticks[i].words ? gettext(ticks[i].words) : ticks[i].number;
        add_swatch(add(hud, "", "%s", words), &ticks[i]);
    }
}

/** Says how many pixels there are of a kind. @param[in,out] hud The panel. @param kind The kind,
 *  translated. @param count How many. @param all Of how many. @return The row. */
static PanelRow *add_share(Hud *hud, const char *kind, uint64_t count, uint64_t all) {
    double percent = all > 0 ? 100 * (double)count / (double)all : 0;
    unsigned long long number = count;
    if (percent < LEAST_PERCENT) {
        return add(hud, "", gettext("%s: %llu"), kind, number);
    }
    return add(hud, "", gettext("%s: %llu (%.3g %%)"), kind, number, percent);
}

/** Says how many pixels are wrong. @param[in,out] hud The panel. @param report What is known.
 *  @param ticks The colours of acne and of leaks. */
static void add_faults(Hud *hud, const LayerReport *report, const LayerTick ticks[2]) {
    const uint64_t counts[] = {report->faults, report->leaks};
    for (int i = 0; i < 2; i++) {
        const char *kind = gettext(ticks[i].words);
        add_swatch(add_share(hud, kind, counts[i], report->pixels), &ticks[i]);
    }
}

/** Says what the colours of a layer mean. @param[in,out] hud The panel. @param report How the layer
 *  stands. */
static void add_layer(Hud *hud, const LayerReport *report) {
    LayerTick ticks[LAYER_TICKS];
    const char *unit = layer_unit(report->layer);
    add_heading(hud, gettext(layer_name(report->layer)), unit[0] != '\0' ? gettext(unit) : "");
    size_t count = layer_legend(report->layer, &report->scale, ticks);
    if (report->layer == LAYER_ACNE) {
        add_faults(hud, report, ticks);
    } else {
        add_ticks(hud, ticks, count);
    }
    if (report->layer == LAYER_ERROR) {
        add_share(hud, gettext("off by over a step"), report->faults, report->pixels);
    }
}

/** Says what the colours of a difference mean. @param[in,out] hud The panel. @param difference It.
 */
static void add_difference(Hud *hud, const Difference *difference) {
    LayerTick ticks[LAYER_TICKS];
    add_heading(hud, gettext("left minus right"), gettext("steps of 255"));
    add_ticks(hud, ticks, difference_legend(ticks));
    add_share(hud, gettext("off by over a step"), difference->off, difference->pixels);
    add(hud, "", gettext("at most: %d"), difference->worst);
}

/** Writes everything anew. @param[out] hud The panel. @param facts What there is to be said. */
static void write_rows(Hud *hud, const HudFacts *facts) {
    const Sight *sight = facts->sight;
    hud->count = 0;
    if (facts->title) {
        add_heading(hud, gettext(facts->title), "");
    }
    if (facts->has_settings) {
        add_settings(hud, sight);
    }
    if (facts->difference) {
        add_difference(hud, facts->difference);
    } else if (!facts->hides_layer && sight->report.layer.layer != LAYER_SHADED) {
        add_layer(hud, &sight->report.layer);
    }
}

/** @return Whether two panels say the same. @param a One. @param b The other. */
static bool is_same(const Hud *a, const Hud *b) {
    bool is_equal = a->count == b->count;
    for (size_t i = 0; is_equal && i < a->count; i++) {
        is_equal = strcmp(a->texts[i], b->texts[i]) == 0 &&
                   strcmp(a->rows[i].label, b->rows[i].label) == 0 &&
                   memcmp(a->rows[i].swatch, b->rows[i].swatch, sizeof a->rows[i].swatch) == 0;
    }
    return is_equal;
}

void hud_update(Hud *hud, const HudFacts *facts, double now) {
    Hud next = {.count = 0};
    if (now < hud->due && !facts->sight->report.is_finished) {
        return;
    }
    hud->share = facts->title ? 0.5 : 1;
    write_rows(&next, facts);
    if (!is_same(hud, &next)) {
        overlay_forget(&hud->overlay);
        write_rows(hud, facts);
        hud->due = now + PAUSE;
    }
}

void hud_show(Hud *hud, const OverlayScreen *screen) {
    if (hud->count > 0) {
        if (overlay_is_stale(&hud->overlay)) {
            OverlayScreen smaller = {screen->renderer, screen->scale * SCALE, hud->share};
            overlay_draw(&hud->overlay, &smaller, hud->rows, hud->count);
        }
        overlay_show(&hud->overlay, screen);
    }
}

void hud_forget(Hud *hud) {
    overlay_forget(&hud->overlay);
    hud->due = 0;
}
