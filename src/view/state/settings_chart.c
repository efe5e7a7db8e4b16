/**
 * @file
 * @brief Collecting points of time and error, and finding their Pareto front.
 */
#include "view/state/settings_chart.h"

#include "base/language.h"
#include "base/pareto_front.h"
#include "dioptre/scene.h"
#include "view/state/settings_words.h"

#include <stdio.h>
#include <string.h>

/** Times of one picture that differ by less than this fraction are equal: other programs run, too.
 */
static const double TIME_NOISE = 0.1;
/** Errors count as equal up to this factor. */
static const double EQUAL_ERROR_FACTOR = 1.02;

void settings_name_write(const RenderSettings *settings, char name[SETTINGS_NAME_SIZE]) {
    const TraceSettings *trace = &settings->trace;
    char offset[SETTINGS_NAME_SIZE / 2];
    snprintf(offset, sizeof offset, trace->offset == OFFSET_FIXED ? "%s %.2g" : "%s",
             offset_strategy_word(trace->offset), trace->epsilon);
    snprintf(name, SETTINGS_NAME_SIZE, "%s, %s, %d × %d%s%s",
             number_type_word(number_type_of(settings->engine)), offset, trace->depth,
             settings->samples, settings->method_set != METHODS_OWN ? ", " : "",
             settings->method_set != METHODS_OWN ? method_set_words[settings->method_set] : "");
    language_localize_numbers(name, SETTINGS_NAME_SIZE);
}

bool settings_have_same_name(const RenderSettings *a, const RenderSettings *b) {
    char names[2][SETTINGS_NAME_SIZE];
    settings_name_write(a, names[0]);
    settings_name_write(b, names[1]);
    return strcmp(names[0], names[1]) == 0;
}

/** @return The index of the point of settings; the number of points: there is none. */
static size_t find_point(const SettingsChart *chart, const RenderSettings *settings) {
    size_t i = 0;
    while (i < chart->count && !settings_have_same_name(&chart->points[i].settings, settings)) {
        i++;
    }
    return i;
}

bool settings_chart_has(const SettingsChart *chart, const RenderSettings *settings) {
    return find_point(chart, settings) < chart->count;
}

/** Finds the settings that no other beats in both time and error. */
static void find_front(SettingsChart *chart) {
    TiedPoint points[SETTINGS_CHART_POINTS];
    for (size_t i = 0; i < chart->count; i++) {
        const SettingsPoint *point = &chart->points[i];
        points[i] = (TiedPoint){.low = point->seconds * (1 - TIME_NOISE / 2),
                                .median = point->seconds,
                                .high = point->seconds * (1 + TIME_NOISE / 2),
                                .error = point->error};
    }
    pareto_front_find_ties(points, chart->count, EQUAL_ERROR_FACTOR);
    for (size_t i = 0; i < chart->count; i++) {
        chart->points[i].is_pareto = points[i].is_pareto;
    }
}

void settings_chart_add(SettingsChart *chart, const RenderSettings *settings, double seconds,
                        double error) {
    size_t index = find_point(chart, settings);
    if (index == SETTINGS_CHART_POINTS) {
        index--;
        memmove(chart->points, chart->points + 1, index * sizeof *chart->points);
    } else if (index == chart->count) {
        chart->count++;
    }
    chart->points[index] =
        (SettingsPoint){.settings = *settings, .seconds = seconds, .error = error};
    find_front(chart);
}
