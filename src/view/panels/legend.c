/**
 * @file
 * @brief Writing legends.
 */
#include "view/panels/legend.h"

#include "base/typeset_numbers.h"
#include "render/palette.h"
#include "view/panels/thing_title.h"
#include "view/state/settings_words.h"

#include <libintl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/** Smallest percentage that is shown. */
static const double MINIMUM_PERCENT = 0.001;
/** Most shapes that the legend names. */
enum { NAMED_SHAPES = LEGEND_ENTRIES_MAXIMUM - 1 };

/** Adds a note. @param format Translated, as for printf. */
static void add_note(Legend *legend, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void add_note(Legend *legend, const char *format, ...) {
    if (legend->note_count < LEGEND_NOTES) {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(legend->notes[legend->note_count], LEGEND_TEXT_SIZE, format, arguments);
        va_end(arguments);
        typeset_numbers(legend->notes[legend->note_count++], LEGEND_TEXT_SIZE);
    }
}

/** Writes a number of pixels. @param kind What they are, translated. @param all Number of all. */
static void write_count(char text[LEGEND_TEXT_SIZE], const char *kind, uint64_t count,
                        uint64_t all) {
    double percent = all > 0 ? 100 * (double)count / (double)all : 0;
    unsigned long long number = count;
    if (percent < MINIMUM_PERCENT) {
        snprintf(text, LEGEND_TEXT_SIZE, gettext("%s: %llu"), kind, number);
    } else {
        snprintf(text, LEGEND_TEXT_SIZE, gettext("%s: %llu (%.3g %%)"), kind, number, percent);
    }
    typeset_numbers(text, LEGEND_TEXT_SIZE);
}

/** Adds a number of pixels, and that it is not the last word while the picture is drawn. */
static void add_count(Legend *legend, const LegendContent *content, const char *kind,
                      uint64_t count, uint64_t all) {
    char text[LEGEND_TEXT_SIZE];
    write_count(text, kind, count, all);
    if (content->report->is_finished) {
        add_note(legend, "%s", text);
    } else {
        add_note(legend, gettext("so far, %s"), text);
    }
}

/** Writes the texts of the rows: translated labels, or numbers. */
static void write_texts(Legend *legend) {
    for (size_t i = 0; i < legend->entry_count; i++) {
        const LegendEntry *entry = &legend->entries[i];
        snprintf(legend->texts[i], LEGEND_TEXT_SIZE, "%s",
                 entry->label ? gettext(entry->label) : entry->number);
        typeset_numbers(legend->texts[i], LEGEND_TEXT_SIZE);
        legend->has_bar = legend->has_bar || entry->position >= 0;
    }
}

/** Writes unit and scale. @param unit Translated; empty: none. */
static void write_unit(Legend *legend, const char *unit, bool is_log) {
    if (is_log && unit[0] != '\0') {
        snprintf(legend->unit, LEGEND_TEXT_SIZE, gettext("%s, log scale"), unit);
    } else {
        snprintf(legend->unit, LEGEND_TEXT_SIZE, "%s", is_log ? gettext("log scale") : unit);
    }
}

/** @return A text in the user's language; empty: none. */
static const char *translated(const char *text) {
    return text[0] != '\0' ? gettext(text) : "";
}

/* --- one layer -------------------------------------------------------------------------------- */

/** Writes the names of the shapes beside their colours. */
static void write_shapes(Legend *legend, const Scene *scene) {
    size_t count = scene->shape_count < NAMED_SHAPES ? scene->shape_count : NAMED_SHAPES;
    legend->entry_count = 0;
    for (size_t i = 0; i < count; i++) {
        LegendEntry *entry = &legend->entries[legend->entry_count];
        *entry = (LegendEntry){.position = LEGEND_APART};
        palette_category((unsigned)i, entry->rgb);
        shape_title(scene, (int)i, legend->texts[legend->entry_count++]);
    }
    if (count < scene->shape_count) {
        size_t more = scene->shape_count - count;
        add_note(legend, ngettext("and %zu more shape", "and %zu more shapes", more), more);
    }
    if (scene->shape_count > PALETTE_CATEGORIES) {
        add_note(legend, gettext("colours repeat after %d shapes"), PALETTE_CATEGORIES);
    }
}

/** Adds how much of the reference there is. */
static void add_reference(Legend *legend, const LegendContent *content) {
    const LayerStats *layer = &content->report->layer;
    char engine[ENGINE_WORDS_SIZE];
    if (!layer->reference) {
        return;
    }
    engine_words_write(layer->reference, engine);
    if (content->report->is_finished) {
        add_note(legend, gettext("reference: %s"), engine);
    } else {
        add_note(legend, gettext("reference %s: %.2g %% of the pixels, %.0f %% of the work"),
                 engine, 100 * layer->measured_fraction, 100 * content->progress);
    }
}

/** Adds how many places have rings. */
static void add_marks(Legend *legend, const LayerMarks *marks) {
    if (marks->count > 0) {
        add_note(legend, ngettext("%zu place has a ring", "%zu places have rings", marks->count),
                 marks->count);
    }
}

/** Adds the counts of acne and leaks to the texts of their colours. */
static void write_artifacts(Legend *legend, const LegendContent *content) {
    const LayerStats *layer = &content->report->layer;
    const uint64_t counts[] = {layer->artifact_pixels, layer->leak_pixels};
    for (size_t i = 0; i < legend->entry_count && i < sizeof counts / sizeof *counts; i++) {
        write_count(legend->texts[i], gettext(legend->entries[i].label), counts[i],
                    layer->pixel_count);
    }
}

/** Adds what a layer has to say beside its colours. */
static void add_notes(Legend *legend, const LegendContent *content) {
    const LayerStats *layer = &content->report->layer;
    int columns = 0, rows = 0;
    switch (layer->layer) {
    case LAYER_STEPS:
    case LAYER_OPERATIONS:
        if (!legend->has_bar) {
            add_note(legend, "%s", gettext("no ray marches: no distance field is in view"));
        }
        break;
    case LAYER_TIME:
        layer_timing_block(content->settings->engine, &columns, &rows);
        add_note(legend, gettext("one number per block of %d × %d pixels"), columns, rows);
        break;
    case LAYER_ERROR:
        add_count(legend, content, gettext("off by over a step"), layer->artifact_pixels,
                  layer->pixel_count);
        break;
    case LAYER_ROUNDING:
        if (content->cannot_round) {
            add_note(legend, "%s", gettext("not measured: numbers round to nearest only here"));
        } else {
            add_count(legend, content, gettext("change by over a step"), layer->artifact_pixels,
                      layer->pixel_count);
        }
        break;
    default:
        break;
    }
    add_reference(legend, content);
    add_marks(legend, content->marks);
}

/** Writes the legend of a layer. */
static void write_layer(Legend *legend, const LegendContent *content) {
    const LayerStats *layer = &content->report->layer;
    snprintf(legend->title, sizeof legend->title, "%s", gettext(layer_name(layer->layer)));
    write_unit(legend, translated(layer_unit(layer->layer)), layer->scale.is_log);
    legend->entry_count = layer_legend(layer->layer, &layer->scale, legend->entries);
    write_texts(legend);
    for (int i = 0; legend->has_bar && i < LEGEND_BAR_COLORS; i++) {
        palette_color(&palette_cividis, (double)i / (LEGEND_BAR_COLORS - 1), legend->bar[i]);
    }
    if (layer->layer == LAYER_SHAPES && content->scene) {
        write_shapes(legend, content->scene);
    }
    if (layer->layer == LAYER_ACNE) {
        write_artifacts(legend, content);
    }
    add_notes(legend, content);
}

/* --- a difference ----------------------------------------------------------------------------- */

/** Writes the legend of a difference. */
static void write_difference(Legend *legend, const LegendContent *content) {
    const DifferenceMap *map = content->difference;
    bool is_light = map->layer == LAYER_SHADED;
    const char *unit =
        is_light ? gettext("steps of 255") : translated(layer_difference_unit(map->layer));
    if (map->is_of_two_layers) {
        snprintf(legend->title, sizeof legend->title, "%s", gettext("two layers"));
        add_note(legend, "%s", gettext("no difference: choose the same layer on both sides"));
        return;
    }
    snprintf(legend->title, sizeof legend->title, gettext("left minus right: %s"),
             gettext(layer_name(map->layer)));
    write_unit(legend, unit, map->layer != LAYER_SHAPES && map->layer != LAYER_ACNE);
    legend->entry_count = difference_map_legend(map, legend->entries);
    write_texts(legend);
    for (int i = 0; i < LEGEND_BAR_COLORS; i++) {
        difference_map_bar_color((double)i / (LEGEND_BAR_COLORS - 1), legend->bar[i]);
    }
    add_count(legend, content,
              is_light ? gettext("off by over a step") : gettext("pixels that differ"),
              map->differing_pixels, map->pixel_count);
    add_note(legend, gettext("at most: %.4g %s"), map->max_difference, unit);
}

void legend_write(const LegendContent *content, Legend *legend) {
    *legend = (Legend){.entry_count = 0};
    if (content->difference) {
        write_difference(legend, content);
    } else if (content->report->layer.layer != LAYER_SHADED) {
        write_layer(legend, content);
    }
}
