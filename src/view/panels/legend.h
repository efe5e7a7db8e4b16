/**
 * @file
 * @brief The legend of a layer or of a difference: title, unit, bar of colours, counts.
 */
#ifndef DIOPTRE_VIEW_PANELS_LEGEND_H
#define DIOPTRE_VIEW_PANELS_LEGEND_H

#include "dioptre/renderer.h"
#include "dioptre/scene.h"
#include "render/difference_map.h"

/** Colours of the bar, from its lower end to its upper end. */
enum { LEGEND_BAR_COLORS = 65 };
/** Most notes of a legend. */
enum { LEGEND_NOTES = 4 };
/** Bytes of a text of a legend with the final zero. */
enum { LEGEND_TEXT_SIZE = 160 };

/** What a legend is of. */
typedef struct LegendContent {
    const Scene *scene;              /**< The scene; NULL: shapes have no names. */
    const RenderStats *report;       /**< The picture that is shown. */
    const RenderSettings *settings;  /**< Its settings. */
    const LayerMarks *marks;         /**< Where its artefacts are. */
    const DifferenceMap *difference; /**< The difference that is shown instead; NULL: none. */
    double progress;                 /**< Completed fraction of the work, 0 to 1. */
    bool cannot_round;               /**< Whether numbers are rounded to nearest only. */
} LegendContent;

/** A legend. */
typedef struct Legend {
    char title[LEGEND_TEXT_SIZE];                         /**< What is shown; empty: no legend. */
    char unit[LEGEND_TEXT_SIZE];                          /**< Its unit and scale; empty: none. */
    uint8_t bar[LEGEND_BAR_COLORS][3];                    /**< Colours of the bar, sRGB. */
    bool has_bar;                                         /**< Whether there is a bar. */
    LegendEntry entries[LEGEND_ENTRIES_MAXIMUM];          /**< Ticks, then colours apart. */
    char texts[LEGEND_ENTRIES_MAXIMUM][LEGEND_TEXT_SIZE]; /**< Their texts, translated. */
    size_t entry_count;                                   /**< Number of them. */
    char notes[LEGEND_NOTES][LEGEND_TEXT_SIZE];           /**< Counts, reference. */
    size_t note_count;                                    /**< Number of them. */
} Legend;

/** Writes the legend of a picture; it has no title where the picture needs none. */
void legend_write(const LegendContent *content, Legend *legend);

#endif
