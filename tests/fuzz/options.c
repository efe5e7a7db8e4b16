/**
 * @file
 * @brief Fuzz target: the command line. What is accepted lies within all limits.
 */
#include "fuzz.h"

#include "cli/commands.h"
#include "cli/options.h"
#include "dioptre/engine.h"

#include <math.h>

/** Most words of a command line: more than #ARGUMENTS_MAXIMUM. */
enum { WORDS_LIMIT = 96 };

/** Stands for the engines, which this target is built without. @return One of them, or NULL. */
const Engine *engine_find(const char *name, Error *error) {
    static const Engine any;
    if (strcmp(name, "f32x8") == 0) {
        return &any;
    }
    error_set(error, STATUS_USAGE, "there is no engine '%s'", name);
    return NULL;
}

/** Stands for the printing of help, which no target does. */
void print_padded(const char *text, int width) {
    (void)text, (void)width;
}

/** @return Whether a number is finite and not below a minimum. */
static bool is_at_least(double value, double minimum) {
    return isfinite(value) && value >= minimum;
}

/** Checks the options of an accepted command line. */
static void check_options(const Options *options) {
    FUZZ_REQUIRE(options->argument_count >= 0 && options->argument_count <= ARGUMENTS_MAXIMUM);
    for (int i = 0; i < options->argument_count; i++) {
        FUZZ_REQUIRE(options->arguments[i]);
    }
    FUZZ_REQUIRE(options->width >= 0 && options->width <= IMAGE_SIZE_MAXIMUM);
    FUZZ_REQUIRE(options->height >= 0 && options->height <= IMAGE_SIZE_MAXIMUM);
    FUZZ_REQUIRE((options->width == 0) == (options->height == 0));
    FUZZ_REQUIRE(options->samples >= 0 && options->samples <= SAMPLES_MAXIMUM);
    FUZZ_REQUIRE(options->depth >= -1 && options->depth <= DEPTH_MAXIMUM);
    FUZZ_REQUIRE(options->threads >= 0 && options->threads <= THREADS_MAXIMUM);
    FUZZ_REQUIRE(is_at_least(options->cutoff, -1) && is_at_least(options->epsilon, -1));
    FUZZ_REQUIRE(is_at_least(options->seconds, -1) && is_at_least(options->fps, 0));
    FUZZ_REQUIRE(is_at_least(options->error, 0) && is_at_least(options->budget, 0));
    FUZZ_REQUIRE(isfinite(options_time(options)));
    FUZZ_REQUIRE(options->threshold >= 0 && options->threshold <= UINT8_MAX);
    const FrameRange *frames = &options->frames;
    FUZZ_REQUIRE(frames->first >= 0 && frames->last >= 0 && frames->last <= FRAMES_MAXIMUM);
    FUZZ_REQUIRE(frames->step == 0 || frame_range_count(frames) >= 1);
}

/** Takes a word for a pattern of frames: their names must hold the number, and nothing else of it.
 */
static void check_pattern(const char *word) {
    Error error = {0};
    FramePattern pattern;
    char path[PATH_MAX];
    if (frame_pattern_parse(word, &pattern, &error)) {
        FUZZ_REQUIRE(pattern.start < pattern.end && pattern.end <= strlen(word));
        if (frame_pattern_path(&pattern, FRAMES_MAXIMUM, path, &error)) {
            FUZZ_REQUIRE(strncmp(path, word, pattern.start) == 0 && strstr(path, "99999999"));
            error.status = STATUS_USAGE;
        }
    }
    FUZZ_REQUIRE(error.status == STATUS_USAGE);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size == 0) {
        return 0;
    }
    // A copy of its own per word: the sanitizer sees what is read beyond its end.
    char *words[WORDS_LIMIT + 2] = {strdup("command")};
    int count = 1;
    const uint8_t *next = data + 1, *end = data + size;
    while (next < end && count < WORDS_LIMIT) {
        const uint8_t *newline = memchr(next, '\n', (size_t)(end - next));
        size_t length = (size_t)((newline ? newline : end) - next);
        words[count++] = strndup((const char *)next, length);
        next += length + 1;
    }
    const Command command = {.id = 1u << (data[0] % 10), .name = "command"};
    Error error = {0};
    Options options;
    char *shuffled[WORDS_LIMIT + 2]; // getopt_long changes the order.
    memcpy(shuffled, words, sizeof words);
    if (options_parse(data[0] < 250 ? &command : NULL, count, shuffled, &options, &error)) {
        check_options(&options);
    } else {
        FUZZ_REQUIRE(error.status == STATUS_USAGE && error.message[0]);
    }
    for (int i = 0; i < count; i++) {
        check_pattern(words[i]);
        free(words[i]);
    }
    return 0;
}
