/**
 * @file
 * @brief Collecting points of time and error, and finding their Pareto front.
 */
#include "view/state/settings_chart.h"

#include "base/language.h"
#include "base/pareto_front.h"
#include "dioptre/scene.h"
#include "dioptre/scene_words.h"
#include "view/state/settings_override.h"

#include <libintl.h>
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
             offset_strategy_names[trace->offset], trace->epsilon);
    snprintf(name, SETTINGS_NAME_SIZE, "%s, %s, %d × %d%s%s",
             number_type_names[number_type_of(settings->engine)], offset, trace->depth,
             settings->samples, settings->method_set != METHODS_OWN ? ", " : "",
             settings->method_set != METHODS_OWN ? method_set_words[settings->method_set] : "");
}

void settings_name_translate(const char *name, char text[SETTINGS_NAME_SIZE]) {
    char type[SETTINGS_NAME_SIZE] = "", offset[SETTINGS_NAME_SIZE] = "";
    int length = 0;
    // 63: SETTINGS_NAME_SIZE without the final zero.
    if (sscanf(name, "%63[^,], %63[a-z]%n", type, offset, &length) == 2) {
        snprintf(text, SETTINGS_NAME_SIZE, "%s, %s%s", scene_value_word("number", type),
                 scene_value_word("offset", offset), name + length);
    } else {
        snprintf(text, SETTINGS_NAME_SIZE, "%s", name);
    }
    language_localize_numbers(text, SETTINGS_NAME_SIZE);
}

/** @return The point of a name; NULL: none. */
static SettingsPoint *find_point(SettingsChart *chart, const char *name) {
    for (size_t i = 0; i < chart->count; i++) {
        if (strcmp(chart->points[i].name, name) == 0) {
            return &chart->points[i];
        }
    }
    return NULL;
}

bool settings_chart_has(const SettingsChart *chart, const char *name) {
    SettingsChart copy = *chart;
    return find_point(&copy, name) != NULL;
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

void settings_chart_add(SettingsChart *chart, const char *name, double seconds, double error) {
    SettingsPoint *point = find_point(chart, name);
    if (!point && chart->count == SETTINGS_CHART_POINTS) {
        memmove(chart->points, chart->points + 1,
                (SETTINGS_CHART_POINTS - 1) * sizeof *chart->points);
        chart->count--;
    }
    point = point ? point : &chart->points[chart->count++];
    *point = (SettingsPoint){.seconds = seconds, .error = error};
    snprintf(point->name, sizeof point->name, "%s", name);
    find_front(chart);
}
