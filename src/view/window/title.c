/**
 * @file
 * @brief The window's title.
 */
#include "view/window/title.h"

#include <libintl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/** Adds words to a title. @param format The words in English, as for printf, looked up here. */
static void title_add(char title[TITLE_SIZE], const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void title_add(char title[TITLE_SIZE], const char *format, ...) {
    size_t used = strlen(title);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(title + used, TITLE_SIZE - used, gettext(format), arguments);
    va_end(arguments);
}

/** Adds how a drawing stands. */
static void add_report(char title[TITLE_SIZE], const RenderStats *report) {
    /** Rays in a million, and a guard against a clock that stood still. */
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
