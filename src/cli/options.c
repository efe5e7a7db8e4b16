/**
 * @file
 * @brief The command line.
 */
#include "cli/options.h"

#include "base/language.h"
#include "cli/commands.h"
#include "dioptre/offset_strategy.h"

#include <errno.h>
#include <getopt.h>
#include <libintl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** One option. Its key is its short letter, or a capital letter that is not offered as one. */
typedef struct OptionSpec {
    char key;          /**< What #Command.accepts names it by. */
    bool is_short;     /**< Whether the key is a short option, too. */
    const char *name;  /**< The long name. */
    const char *value; /**< What its value is called in the help; NULL: it takes none. */
    const char *help;  /**< What it does. */
} OptionSpec;

/** All options of all commands. */
static const OptionSpec option_specs[] = {
    {'o', true, "output", N_("FILE"), N_("write there; the ending names the format")},
    {'U', false, "out", N_("DIR"), N_("write there; the folder is made where it is not there")},
    {'s', true, "size", N_("WxH"), N_("size of the picture, pixels")},
    {'A', false, "samples", N_("N"), N_("rays a pixel")},
    {'S', false, "sampling", N_("WAY"),
     N_("adaptive or full: whether every pixel gets all its rays")},
    {'D', false, "depth", N_("N"), N_("how often a ray may be mirrored or refracted")},
    {'t', true, "time", N_("SECONDS"), N_("the scene's t")},
    {'j', true, "threads", N_("N"), N_("worker threads (default: all cores)")},
    {'E', false, "engine", N_("NAME"),
     N_("auto, f32x16, f32x8, f32x4, f32x1, f64x4, f64x1 or f128x1")},
    {'O', false, "offset", N_("WAY"), N_("none, fixed or bound: how rays leave a surface")},
    {'X', false, "epsilon", N_("LENGTH"), N_("for --offset fixed, scene units")},
    {'B', false, "base-dir", N_("DIR"), N_("where the files lie that the scene names")},
    {'C', false, "seconds", N_("S"), N_("how long the film lasts (default: 10)")},
    {'G', false, "fps", N_("F"), N_("frames a second (default: 25)")},
    {'F', false, "frames", N_("A-B[:STEP]"),
     N_("which frames, from 0; for bench how many (default: 10)")},
    {'N', false, "skip-existing", NULL, N_("leave out frames whose file is there")},
    {'R', false, "rays", N_("KIND"), N_("image, primary or random")},
    {'T', false, "threshold", N_("STEPS"),
     N_("largest difference that still counts as alike (default: 0)")},
    {'M', false, "map", N_("FILE"), N_("write a picture of the differences")},
    {'Y', false, "svg", N_("FILE"), N_("draw the rays there, as seen from beside")},
    {'K', false, "keys", N_("WAY"), N_("places or letters: what the light's keys are bound to")},
    {'I', false, "lesson", N_("FILE"), N_("play that lesson; its scene is the one that it names")},
    {'W', false, "lesson-snapshots", N_("DIR"),
     N_("play it without waiting, and write a picture at each caption there")},
    {'L', false, "timing", NULL, N_("say at the end how long pictures took to come")},
    {'Z', false, "kernels", NULL, N_("chart methods of the laboratory and not scenes")},
    {'J', false, "json", NULL, N_("print one JSON object a line")},
    {'P', false, "progress", N_("WAY"), N_("auto, json or none")},
    {'q', true, "quiet", NULL, N_("say nothing but errors")},
    {'h', true, "help", NULL, N_("print this")},
    {'V', true, "version", NULL, N_("print the version")},
};

/** Letters that the column of names is wide in the help. */
static const int NAME_WIDTH = 22;

/** How many options there are. */
enum { OPTION_COUNT = sizeof option_specs / sizeof *option_specs };

/**
 * @return Whether a command takes an option.
 * @param command  The command, or NULL.
 */
static bool command_accepts(const Command *command, int key) {
    return strchr("hV", key) || (command && strchr(command->accepts, key));
}

/** Reads a whole number. @return Whether it is one, in range. */
static bool read_integer(const char *name, const char *text, int minimum, int maximum, int *value,
                         Error *error) {
    char *end = NULL;
    errno = 0;
    long number = strtol(text, &end, 10);
    if (errno || end == text || *end || number < minimum || number > maximum) {
        return error_set(error, STATUS_USAGE, "--%s takes a whole number from %d to %d, not '%s'",
                         name, minimum, maximum, text);
    }
    *value = (int)number;
    return true;
}

/** Reads a number. @return Whether it is one, finite and in range. */
static bool read_number(const char *name, const char *text, double minimum, double *value,
                        Error *error) {
    char *end = NULL;
    double number = strtod(text, &end);
    if (end == text || *end || !isfinite(number) || number < minimum) {
        return error_set(error, STATUS_USAGE,
                         minimum >= 0 ? N_("--%s takes a number, at least 0, not '%s'")
                                      : N_("--%s takes a number, not '%s'"),
                         name, text);
    }
    *value = number;
    return true;
}

/** Reads a number of frames a second. @return Whether it is one, in range. */
static bool read_fps(const char *text, double *fps, Error *error) {
    Error ignored;
    return (read_number("fps", text, 0, fps, &ignored) && *fps > 0 && *fps <= FRAMES_FPS_MAXIMUM) ||
           error_set(error, STATUS_USAGE, "--fps takes a number above 0, at most %g, not '%s'",
                     FRAMES_FPS_MAXIMUM, text);
}

/**
 * Reads a size.
 * @param text  What was said: two whole numbers with an x between them.
 * @param[out] options  Gets width and height.
 * @return Whether it is a size that can be drawn.
 */
static bool read_size(const char *text, Options *options, Error *error) {
    char *end = NULL;
    long width = strtol(text, &end, 10);
    long height = 0;
    bool is_pair = end != text && (*end == 'x' || *end == 'X');
    if (is_pair) {
        const char *second = end + 1;
        height = strtol(second, &end, 10);
        is_pair = end != second && !*end;
    }
    if (!is_pair || width < 1 || height < 1 || width > IMAGE_SIZE_MAXIMUM ||
        height > IMAGE_SIZE_MAXIMUM) {
        return error_set(error, STATUS_USAGE,
                         "--size takes WxH with both from 1 to %d, such as 800x600, not '%s'",
                         IMAGE_SIZE_MAXIMUM, text);
    }
    options->width = (int)width;
    options->height = (int)height;
    return true;
}

/**
 * Reads one of a few words.
 * @param words  The words, ended by NULL.
 * @return Whether it is one of them.
 */
static bool read_word(const char *name, const char *text, const char *const *words, int *index,
                      Error *error) {
    char choices[128] = "";
    for (int i = 0; words[i]; i++) {
        if (strcmp(text, words[i]) == 0) {
            *index = i;
            return true;
        }
        const char *separator = i == 0 ? "" : words[i + 1] ? ", " : gettext(" or ");
        strncat(choices, separator, sizeof choices - strlen(choices) - 1);
        strncat(choices, words[i], sizeof choices - strlen(choices) - 1);
    }
    return error_set(error, STATUS_USAGE, "--%s takes %s, not '%s'", name, choices, text);
}

/** Takes an option whose value is a word. @return Whether it is good. */
static bool set_word_option(const OptionSpec *option, const char *text, Options *options,
                            Error *error) {
    static const char *const rays[] = {"image", "primary", "random", NULL};
    static const char *const styles[] = {"auto", "json", "none", NULL};
    static const char *const samplings[] = {"adaptive", "full", NULL};
    static const char *const keys[] = {"places", "letters", NULL};
    int index = 0;
    switch (option->key) {
    case 'O':
        return read_word(option->name, text, offset_strategy_names, &options->offset, error);
    case 'S':
        if (!read_word(option->name, text, samplings, &index, error)) {
            return false;
        }
        options->sampling = (Sampling)index;
        return true;
    case 'R':
        if (!read_word(option->name, text, rays, &index, error)) {
            return false;
        }
        options->rays = (BenchRays)index;
        return true;
    case 'P':
        if (!read_word(option->name, text, styles, &index, error)) {
            return false;
        }
        options->progress = (ProgressStyle)index;
        return true;
    default:
        if (!read_word(option->name, text, keys, &index, error)) {
            return false;
        }
        options->keys_by_letter = index == 1;
        return true;
    }
}

/** @return Where an option's value goes as it is; NULL: it is no text. */
static const char **text_option_target(char key, Options *options) {
    switch (key) {
    case 'o':
        return &options->output;
    case 'U':
        return &options->out_dir;
    case 'B':
        return &options->base_dir;
    case 'M':
        return &options->map;
    case 'I':
        return &options->lesson;
    case 'W':
        return &options->lesson_snapshots;
    case 'Y':
        return &options->svg;
    default:
        return NULL;
    }
}

/** Takes an option that has a value. @return Whether it is good. */
static bool set_value_option(const OptionSpec *option, const char *text, Options *options,
                             Error *error) {
    const char **target = text_option_target(option->key, options);
    if (target) {
        *target = text;
        return true;
    }
    switch (option->key) {
    case 's':
        return read_size(text, options, error);
    case 'A':
        return read_integer(option->name, text, 1, SAMPLES_MAXIMUM, &options->samples, error);
    case 'D':
        return read_integer(option->name, text, 0, DEPTH_MAXIMUM, &options->depth, error);
    case 'j':
        return read_integer(option->name, text, 1, THREADS_MAXIMUM, &options->threads, error);
    case 'F':
        return frame_range_parse(text, &options->frames, error);
    case 'C':
        return read_number(option->name, text, 0, &options->seconds, error);
    case 'G':
        return read_fps(text, &options->fps, error);
    case 'T':
        return read_integer(option->name, text, 0, UINT8_MAX, &options->threshold, error);
    case 't':
        return read_number(option->name, text, -HUGE_VAL, &options->time, error);
    case 'X':
        return read_number(option->name, text, 0, &options->epsilon, error);
    case 'E':
        options->engine = strcmp(text, "auto") == 0 ? NULL : engine_find(text, error);
        return options->engine || strcmp(text, "auto") == 0;
    default:
        return set_word_option(option, text, options, error);
    }
}

/** Takes an option that has no value. */
static void set_flag_option(char key, Options *options) {
    options->json = options->json || key == 'J';
    options->timing = options->timing || key == 'L';
    options->kernels = options->kernels || key == 'Z';
    options->skip_existing = options->skip_existing || key == 'N';
    options->quiet = options->quiet || key == 'q';
    options->help = options->help || key == 'h';
    options->version = options->version || key == 'V';
}

/** Tables as getopt_long wants them. */
typedef struct GetoptTables {
    char short_options[2 * OPTION_COUNT +
                       2]; /**< Short options; first a colon: it prints nothing. */
    struct option long_options[OPTION_COUNT + 1]; /**< Long options. */
} GetoptTables;

/** @return The tables of all options. */
static GetoptTables getopt_tables(void) {
    GetoptTables tables = {.short_options = ":"};
    char *letter = tables.short_options + 1;
    for (int i = 0; i < OPTION_COUNT; i++) {
        const OptionSpec *spec = &option_specs[i];
        tables.long_options[i] = (struct option){
            spec->name, spec->value ? required_argument : no_argument, NULL, spec->key};
        if (spec->is_short) {
            *letter++ = spec->key;
            if (spec->value) {
                *letter++ = ':';
            }
        }
    }
    return tables;
}

/** @return The option with a key, or NULL. */
static const OptionSpec *find_option(int key) {
    for (int i = 0; i < OPTION_COUNT; i++) {
        if (option_specs[i].key == key) {
            return &option_specs[i];
        }
    }
    return NULL;
}

/**
 * Takes one option as getopt_long found it.
 * @param command  The command, or NULL.
 * @param word  The word that it came from.
 * @return Whether it is good.
 */
static bool set_option(const Command *command, int key, const char *word, Options *options,
                       Error *error) {
    const OptionSpec *option = key == '?' || key == ':' ? NULL : find_option(key);
    if (key == ':') {
        return error_set(error, STATUS_USAGE, "%s needs a value", word);
    }
    if (!option) {
        return error_set(error, STATUS_USAGE, "there is no option %s", word);
    }
    if (!command_accepts(command, key)) {
        return error_set(error, STATUS_USAGE, "%s does not take --%s",
                         command ? command->name : "dioptre", option->name);
    }
    if (option->value) {
        return set_value_option(option, optarg, options, error);
    }
    set_flag_option(option->key, options);
    return true;
}

bool options_parse(const Command *command, int argc, char **argv, Options *options, Error *error) {
    GetoptTables tables = getopt_tables();
    *options = (Options){.depth = -1, .offset = -1, .epsilon = -1, .seconds = -1};
    optind = 1;
    int key = 0;
    while ((key = getopt_long(argc, argv, tables.short_options, tables.long_options, NULL)) != -1) {
        if (!set_option(command, key, argv[optind - 1], options, error)) {
            return false;
        }
    }
    for (int i = optind; i < argc; i++, options->argument_count++) {
        if (options->argument_count == ARGUMENTS_MAXIMUM) {
            return error_set(error, STATUS_USAGE, "too many arguments: '%s'", argv[i]);
        }
        options->arguments[options->argument_count] = argv[i];
    }
    return true;
}

void options_print(const Command *command) {
    for (int i = 0; i < OPTION_COUNT; i++) {
        const OptionSpec *option = &option_specs[i];
        if (command_accepts(command, option->key)) {
            char name[64];
            snprintf(name, sizeof name, "--%s %s", option->name,
                     option->value ? gettext(option->value) : "");
            printf("  %c%c ", option->is_short ? '-' : ' ', option->is_short ? option->key : ' ');
            print_padded(name, NAME_WIDTH);
            printf(" %s\n", gettext(option->help));
        }
    }
}
