/**
 * @file
 * @brief The window's title.
 */
#include "view/title.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/** Adds words to a title. @param[in,out] title The title. @param format The words, as for printf.
 */
static void add(char title[TITLE_SIZE], const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void add(char title[TITLE_SIZE], const char *format, ...) {
    size_t used = strlen(title);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(title + used, TITLE_SIZE - used, format, arguments);
    va_end(arguments);
}

/** Adds how a drawing stands. @param[in,out] title The title. @param report How it stands. */
static void add_report(char title[TITLE_SIZE], const RenderReport *report) {
    /** Rays in a million, and a guard against a clock that stood still. */
    const double million = 1e6, instant = 1e-9;
    uint64_t rays = ray_counts_sum(&report->rays);
    double seconds = report->seconds > instant ? report->seconds : instant;
    add(title, ", pass %d px, %d sample%s, %.1f ms, %.0f Mrays/s%s", report->stride,
        report->samples, report->samples == 1 ? "" : "s", report->seconds * 1e3,
        (double)rays / seconds / million, report->is_finished ? ", finished" : "");
}

void title_write(const TitleFacts *facts, char title[TITLE_SIZE]) {
    title[0] = '\0';
    add(title, "%s — %d×%d", facts->name, facts->width, facts->height);
    if (facts->report) {
        add_report(title, facts->report);
    }
    if (facts->time) {
        add(title, " — t %.15g s%s", *facts->time, facts->is_running ? ", running" : "");
    }
    if (facts->light_count > 1) {
        add(title, " — light %zu of %zu", facts->light + 1, facts->light_count);
    }
    if (facts->note[0] != '\0') {
        add(title, " — %s", facts->note);
    }
}
