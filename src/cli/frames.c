/**
 * @file
 * @brief The frames of a film.
 */
#include "cli/frames.h"

#include "dioptre/language.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/**
 * Reads a whole number at the start of a text.
 * @param[in,out] text  The text; after the number then.
 * @param minimum       Smallest.
 * @param[out] value    The number.
 * @return Whether there is one, from \p minimum to #FRAMES_MAXIMUM, that begins with a digit or,
 *         where it may be below 0, a sign.
 */
static bool read_number(const char **text, int minimum, int *value) {
    char *end = NULL;
    bool is_number = (**text >= '0' && **text <= '9') || (minimum < 0 && **text == '-');
    long number = is_number ? strtol(*text, &end, 10) : 0;
    if (!is_number || end == *text || number < minimum || number > FRAMES_MAXIMUM) {
        return false;
    }
    *value = (int)number;
    *text = end;
    return true;
}

bool frames_read(const char *text, FrameRange *range, Error *error) {
    const char *at = text;
    *range = (FrameRange){.step = 1};
    bool is_good = read_number(&at, 0, &range->first);
    range->last = range->first;
    if (is_good && *at == '-') {
        at++;
        is_good = read_number(&at, 0, &range->last);
        if (is_good && *at == ':') {
            at++;
            is_good = read_number(&at, -FRAMES_MAXIMUM, &range->step) && range->step != 0;
        }
    }
    if (!is_good || *at) {
        return error_set(error, STATUS_USAGE,
                         "--frames takes A, A-B or A-B:STEP with whole numbers from 0 to %d, "
                         "not '%s'",
                         FRAMES_MAXIMUM, text);
    }
    if (frames_count(range) < 1) {
        return error_set(
            error, STATUS_USAGE,
            range->step > 0 ? N_("--frames %s names no frame; to go backwards, the step is below 0")
                            : N_("--frames %s names no frame"),
            text);
    }
    return true;
}

int frames_count(const FrameRange *range) {
    int count = (range->last - range->first) / range->step + 1;
    bool is_wrong_way = (range->last - range->first < 0) != (range->step < 0);
    return is_wrong_way && range->last != range->first ? 0 : count;
}

bool frames_is_pattern(const char *path) {
    return strchr(path, '%') != NULL;
}

bool frames_read_pattern(const char *text, FramePattern *pattern, Error *error) {
    const char *sign = strchr(text, '%'), *at = sign ? sign + 1 : "";
    *pattern = (FramePattern){.text = text, .has_zeros = *at == '0'};
    at += *at == '0';
    if (*at >= '1' && *at <= '9') {
        pattern->width = *at++ - '0';
    }
    if (*at != 'd' || strchr(at, '%')) {
        return error_set(error, STATUS_USAGE,
                         "'%s' must hold one %%d for the number of a frame, such as %%05d, "
                         "and no other %%",
                         text);
    }
    pattern->start = (size_t)(sign - text);
    pattern->end = (size_t)(at + 1 - text);
    return true;
}

bool frames_path(const FramePattern *pattern, int number, char path[PATH_MAX], Error *error) {
    char digits[16];
    snprintf(digits, sizeof digits, pattern->has_zeros ? "%0*d" : "%*d", pattern->width, number);
    int length = snprintf(path, PATH_MAX, "%.*s%s%s", (int)pattern->start, pattern->text, digits,
                          pattern->text + pattern->end);
    return length < PATH_MAX ||
           error_set(error, STATUS_USAGE, "'%s' is too long for a file", pattern->text);
}
