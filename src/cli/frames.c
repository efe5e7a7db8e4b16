/**
 * @file
 * @brief Ranges of frames, and patterns of their file names.
 */
#include "cli/frames.h"

#include "base/language.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/**
 * Parses an integer at the start of a text.
 * @param[in,out] text  The text; then the rest after the number.
 * @return false unless there is one from \p minimum to #FRAMES_MAXIMUM that begins with a digit or,
 *         where it may be negative, a minus sign.
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

bool frame_range_parse(const char *text, FrameRange *range, Error *error) {
    const char *next = text;
    *range = (FrameRange){.step = 1};
    bool is_good = read_number(&next, 0, &range->first);
    range->last = range->first;
    if (is_good && *next == '-') {
        next++;
        is_good = read_number(&next, 0, &range->last);
        if (is_good && *next == ':') {
            next++;
            is_good = read_number(&next, -FRAMES_MAXIMUM, &range->step) && range->step != 0;
        }
    }
    if (!is_good || *next) {
        return error_set(error, STATUS_USAGE,
                         "--frames takes A, A-B or A-B:STEP with whole numbers from 0 to %d, "
                         "not '%s'",
                         FRAMES_MAXIMUM, text);
    }
    if (frame_range_count(range) < 1) {
        return error_set(
            error, STATUS_USAGE,
            range->step > 0 ? N_("--frames %s names no frame; to go backwards, the step is below 0")
                            : N_("--frames %s names no frame"),
            text);
    }
    return true;
}

int frame_range_count(const FrameRange *range) {
    int count = (range->last - range->first) / range->step + 1;
    bool has_wrong_sign = (range->last - range->first < 0) != (range->step < 0);
    return has_wrong_sign && range->last != range->first ? 0 : count;
}

bool frame_pattern_is_in(const char *path) {
    return strchr(path, '%') != NULL;
}

bool frame_pattern_parse(const char *text, FramePattern *pattern, Error *error) {
    const char *percent = strchr(text, '%'), *next = percent ? percent + 1 : "";
    *pattern = (FramePattern){.text = text, .is_zero_padded = *next == '0'};
    next += *next == '0';
    if (*next >= '1' && *next <= '9') {
        pattern->width = *next++ - '0';
    }
    if (*next != 'd' || strchr(next, '%')) {
        return error_set(error, STATUS_USAGE,
                         "'%s' must hold one %%d for the number of a frame, such as %%05d, "
                         "and no other %%",
                         text);
    }
    pattern->start = (size_t)(percent - text);
    pattern->end = (size_t)(next + 1 - text);
    return true;
}

bool frame_pattern_path(const FramePattern *pattern, int number, char path[PATH_MAX],
                        Error *error) {
    char digits[16];
    snprintf(digits, sizeof digits, pattern->is_zero_padded ? "%0*d" : "%*d", pattern->width,
             number);
    int length = snprintf(path, PATH_MAX, "%.*s%s%s", (int)pattern->start, pattern->text, digits,
                          pattern->text + pattern->end);
    return length < PATH_MAX ||
           error_set(error, STATUS_USAGE, "'%s' is too long for a file", pattern->text);
}
