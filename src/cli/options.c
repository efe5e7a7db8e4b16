/**
 * @file
 * @brief The command line.
 */
#include "cli/options.h"

#include "base/language.h"
#include "cli/commands.h"
#include "dioptre/scene.h"

#include <ctype.h>
#include <errno.h>
#include <getopt.h>
#include <libintl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/** An option: one row of the table. A new option is a row here and a member of #Options. */
typedef struct OptionSpec {
    const char *name;     /**< The long name. */
    char letter;          /**< The short name; 0: none. */
    const char *argument; /**< Name of its value in the help; NULL: a flag without value. */

    /** Parses the value and stores it; see the parsers below. */
    bool (*parse)(const struct OptionSpec *option, const char *text, Options *options,
                  Error *error);

    size_t offset;            /**< Where its member is in #Options, bytes. */
    double minimum;           /**< Least value of a number. */
    double maximum;           /**< Greatest value of a number. */
    const char *const *words; /**< Values of a word, ended by NULL. */
    const char *help;         /**< Its purpose in one line, in English. */
    unsigned commands;        /**< The commands that take it: a set of #CommandId. */
} OptionSpec;

/* --- parsers of values ------------------------------------------------------------------------ */

/** Takes the name of a file or a folder. See #OptionSpec.parse. */
static bool parse_name(const OptionSpec *option, const char *text, Options *options, Error *error) {
    *(const char **)((char *)options + option->offset) = text;
    // Scripts give an empty name where a variable of theirs is not set.
    return *text ||
           error_set(error, STATUS_USAGE, "--%s takes a name, not '%s'", option->name, text);
}

/** Takes the name of a folder that exists. See #OptionSpec.parse. */
static bool parse_folder(const OptionSpec *option, const char *text, Options *options,
                         Error *error) {
    struct stat info;
    if (!parse_name(option, text, options, error)) {
        return false;
    }
    return (stat(text, &info) == 0 && S_ISDIR(info.st_mode)) ||
           error_set(error, STATUS_USAGE, "--%s takes a folder that exists, not '%s'", option->name,
                     text);
}

/** Takes digits from 1 to 9. See #OptionSpec.parse. */
static bool parse_digits(const OptionSpec *option, const char *text, Options *options,
                         Error *error) {
    *(const char **)((char *)options + option->offset) = text;
    return (*text && !text[strspn(text, "123456789")]) ||
           error_set(error, STATUS_USAGE, "--%s takes digits from 1 to 9, not '%s'", option->name,
                     text);
}

/** Sets a flag. See #OptionSpec.parse. */
static bool parse_flag(const OptionSpec *option, const char *text, Options *options, Error *error) {
    (void)text, (void)error;
    *(bool *)((char *)options + option->offset) = true;
    return true;
}

/** Parses an integer. See #OptionSpec.parse. */
static bool parse_integer(const OptionSpec *option, const char *text, Options *options,
                          Error *error) {
    int minimum = (int)option->minimum, maximum = (int)option->maximum;
    char *end = NULL;
    errno = 0;
    long number = strtol(text, &end, 10);
    if (errno || end == text || *end || number < minimum || number > maximum) {
        return error_set(error, STATUS_USAGE, "--%s takes a whole number from %d to %d, not '%s'",
                         option->name, minimum, maximum, text);
    }
    *(int *)((char *)options + option->offset) = (int)number;
    return true;
}

/** Parses a finite number. See #OptionSpec.parse. */
static bool parse_number(const OptionSpec *option, const char *text, Options *options,
                         Error *error) {
    char *end = NULL;
    double number = strtod(text, &end);
    if (end == text || *end || !isfinite(number) || number < option->minimum) {
        return error_set(error, STATUS_USAGE,
                         option->minimum >= 0 ? N_("--%s takes a number, at least 0, not '%s'")
                                              : N_("--%s takes a number, not '%s'"),
                         option->name, text);
    }
    *(double *)((char *)options + option->offset) = number;
    return true;
}

/** Parses a number above 0, which has a maximum. See #OptionSpec.parse. */
static bool parse_positive(const OptionSpec *option, const char *text, Options *options,
                           Error *error) {
    const double *number = (const double *)((const char *)options + option->offset);
    return (parse_number(option, text, options, NULL) && *number > 0 &&
            *number <= option->maximum) ||
           error_set(error, STATUS_USAGE, "--%s takes a number above 0, at most %g, not '%s'",
                     option->name, option->maximum, text);
}

/** Parses one of a few words; the value is its index. See #OptionSpec.parse. */
static bool parse_word(const OptionSpec *option, const char *text, Options *options, Error *error) {
    char choices[128] = "";
    for (int i = 0; option->words[i]; i++) {
        if (strcmp(text, option->words[i]) == 0) {
            *(int *)((char *)options + option->offset) = i;
            return true;
        }
        const char *separator = i == 0 ? "" : option->words[i + 1] ? ", " : gettext(" or ");
        strncat(choices, separator, sizeof choices - strlen(choices) - 1);
        strncat(choices, option->words[i], sizeof choices - strlen(choices) - 1);
    }
    return error_set(error, STATUS_USAGE, "--%s takes %s, not '%s'", option->name, choices, text);
}

/** Parses a size: two integers with an x between them. See #OptionSpec.parse. */
static bool parse_size(const OptionSpec *option, const char *text, Options *options, Error *error) {
    char *end = NULL;
    // strtol would take blanks and a sign.
    long width = isdigit((unsigned char)*text) ? strtol(text, &end, 10) : 0;
    long height = 0, maximum = (long)option->maximum;
    bool is_pair = end && (*end == 'x' || *end == 'X') && isdigit((unsigned char)end[1]);
    if (is_pair) {
        height = strtol(end + 1, &end, 10);
        is_pair = !*end;
    }
    if (!is_pair || width < 1 || height < 1 || width > maximum || height > maximum) {
        return error_set(error, STATUS_USAGE,
                         "--size takes WxH with both from 1 to %d, such as 800x600, not '%s'",
                         (int)maximum, text);
    }
    options->width = (int)width;
    options->height = (int)height;
    return true;
}

/** Parses the name of an engine. See #OptionSpec.parse. */
static bool parse_engine(const OptionSpec *option, const char *text, Options *options,
                         Error *error) {
    (void)option;
    bool is_automatic = strcmp(text, "auto") == 0;
    options->engine = is_automatic ? NULL : engine_find(text, error);
    return options->engine || is_automatic;
}

/** Parses a range of frames. See #OptionSpec.parse. */
static bool parse_frames(const OptionSpec *option, const char *text, Options *options,
                         Error *error) {
    (void)option;
    return frame_range_parse(text, &options->frames, error);
}

/* --- the table -------------------------------------------------------------------------------- */

/** Values of `--rays`, in the order of #BenchRays. */
static const char *const rays_words[] = {"image", "primary", "random", NULL};
/** Values of `--keys`, in the order of #KeyBinding. */
static const char *const keys_words[] = {"places", "letters", NULL};
/** Values of `--progress`, in the order of #ProgressStyle. */
static const char *const progress_words[] = {"auto", "json", "none", NULL};

/** Largest `--budget`, milliseconds: a day. */
#define BUDGET_MAXIMUM 86400e3

/** Commands that write pictures. */
#define PICTURES (COMMAND_RENDER | COMMAND_ANIMATE)
/** Commands that trace a scene. */
#define TRACING                                                                                    \
    (PICTURES | COMMAND_VIEW | COMMAND_PROBE | COMMAND_INFO | COMMAND_BENCH | COMMAND_CHART)
/** Commands that load a scene. */
#define SCENES (TRACING | COMMAND_NEEDS)
/** Commands whose results are files in a folder. */
#define FOLDERS (COMMAND_CHART | COMMAND_LAB)
/** Commands that report facts. */
#define REPORTS (COMMAND_PROBE | COMMAND_INFO | COMMAND_COMPARE | COMMAND_BENCH | COMMAND_NEEDS)
/** All commands. */
#define ALL (~0u)

/** The parser and the member of an option. */
#define STORES(parser, member) .parse = parse_##parser, .offset = offsetof(Options, member)

/** All options of all commands, in the order of the help. */
static const OptionSpec option_specs[] = {
    {"output", 'o', N_("FILE"), STORES(name, output), .commands = PICTURES,
     .help = N_("write there; the ending names the format")},
    {"out", 0, N_("DIR"), STORES(name, out_dir), .commands = FOLDERS,
     .help = N_("write there; the folder is made where it is not there")},
    {"size", 's', N_("WxH"), STORES(size, width), .maximum = IMAGE_SIZE_MAXIMUM, .commands = SCENES,
     .help = N_("size of the picture, pixels")},
    {"samples", 0, N_("N"), STORES(integer, samples), .minimum = 1, .maximum = SAMPLES_MAXIMUM,
     .commands = SCENES, .help = N_("rays per pixel")},
    {"sampling", 0, N_("WAY"), STORES(word, sampling), .words = sampling_words,
     .commands = TRACING & ~COMMAND_PROBE,
     .help = N_("adaptive or full: whether every pixel gets all its rays")},
    {"depth", 0, N_("N"), STORES(integer, depth), .maximum = DEPTH_MAXIMUM, .commands = SCENES,
     .help = N_("how often a ray may be mirrored or refracted")},
    {"cutoff", 0, N_("STEPS"), STORES(number, cutoff), .commands = TRACING,
     .help = N_("what all rays that end early may be worth in a pixel (default: 0.25)")},
    {"time", 't', N_("SECONDS"), STORES(number, time), .minimum = -HUGE_VAL, .commands = SCENES,
     .help = N_("the scene's t")},
    {"threads", 'j', N_("N"), STORES(integer, threads), .minimum = 1, .maximum = THREADS_MAXIMUM,
     .commands = SCENES | COMMAND_LAB, .help = N_("worker threads (default: all cores)")},
    {"engine", 0, N_("NAME"), STORES(engine, engine), .commands = TRACING,
     .help = N_("auto, f32x16, f32x8, f32x4, f32x1, f64x4, f64x1 or f128x1")},
    {"offset", 0, N_("WAY"), STORES(word, offset), .words = offset_strategy_names,
     .commands = TRACING, .help = N_("none, fixed or bound: how rays leave a surface")},
    {"epsilon", 0, N_("LENGTH"), STORES(number, epsilon), .commands = SCENES,
     .help = N_("for --offset fixed, scene units")},
    {"pixel", 0, N_("POINT"), STORES(word, pixel), .words = pixel_point_words,
     .commands = TRACING & ~(COMMAND_CHART | COMMAND_INFO),
     .help = N_("center or corner: where in its pixel a ray goes")},
    {"methods", 0, N_("WHOSE"), STORES(word, methods), .words = method_set_words,
     .commands = TRACING & ~(COMMAND_CHART | COMMAND_INFO),
     .help = N_("own, a, b, c or d: as one of the four reports did it")},
    {"error", 0, N_("STEPS"), STORES(positive, error), .maximum = UINT8_MAX,
     .commands = COMMAND_NEEDS,
     .help = N_("find the cheapest settings for that error of a pixel (default: 0.5)")},
    {"budget", 0, N_("MS"), STORES(positive, budget), .maximum = BUDGET_MAXIMUM,
     .commands = COMMAND_NEEDS,
     .help = N_("find the best picture that takes no more milliseconds than that")},
    {"base-dir", 0, N_("DIR"), STORES(folder, base_dir), .commands = SCENES,
     .help = N_("where the files lie that the scene names")},
    {"seconds", 0, N_("S"), STORES(number, seconds), .commands = COMMAND_ANIMATE,
     .help = N_("how long the film lasts (default: 10)")},
    {"fps", 0, N_("F"), STORES(positive, fps), .maximum = FRAMES_FPS_MAXIMUM,
     .commands = COMMAND_ANIMATE, .help = N_("frames per second (default: 25)")},
    {"frames", 0, N_("A-B[:STEP]"), STORES(frames, frames),
     .commands = COMMAND_ANIMATE | COMMAND_BENCH,
     .help = N_("which frames, from 0; for bench how many (default: 10)")},
    {"skip-existing", 0, NULL, STORES(flag, skip_existing), .commands = COMMAND_ANIMATE,
     .help = N_("leave out frames whose file is there and whole")},
    {"no-sync", 0, NULL, STORES(flag, no_sync), .commands = COMMAND_ANIMATE,
     .help = N_("do not wait for the disk after each frame")},
    {"rays", 0, N_("KIND"), STORES(word, rays), .words = rays_words, .commands = COMMAND_BENCH,
     .help = N_("image, primary or random")},
    {"threshold", 0, N_("STEPS"), STORES(integer, threshold), .maximum = UINT8_MAX,
     .commands = COMMAND_COMPARE,
     .help = N_("largest difference that still counts as alike (default: 0)")},
    {"map", 0, N_("FILE"), STORES(name, map), .commands = COMMAND_COMPARE,
     .help = N_("write a picture of the differences")},
    {"svg", 0, N_("FILE"), STORES(name, svg), .commands = COMMAND_PROBE,
     .help = N_("draw the rays there, as seen from beside")},
    {"ray", 0, N_("N"), STORES(integer, ray), .maximum = RAY_TREE_MAX_NODES,
     .commands = COMMAND_PROBE, .help = N_("only this ray: its formulas with their numbers")},
    {"keys", 0, N_("WAY"), STORES(word, keys), .words = keys_words, .commands = COMMAND_VIEW,
     .help = N_("places or letters: what the light's keys are bound to")},
    {"lesson", 0, N_("FILE"), STORES(name, lesson), .commands = COMMAND_VIEW,
     .help = N_("play that lesson; its scene is the one that it names")},
    {"lesson-snapshots", 0, N_("DIR"), STORES(name, lesson_snapshots), .commands = COMMAND_VIEW,
     .help = N_("play it without waiting, and write a picture at each caption there")},
    {"predictions", 0, N_("DIGITS"), STORES(digits, predictions), .commands = COMMAND_VIEW,
     .help = N_("played so, choose these answers, a digit each (default: right ones)")},
    {"answers", 0, N_("FILE"), STORES(name, answers), .commands = COMMAND_VIEW,
     .help = N_("append the answers to a lesson's questions there, as CSV")},
    {"timing", 0, NULL, STORES(flag, timing), .commands = COMMAND_VIEW,
     .help = N_("say at the end how long pictures took to come")},
    {"kernels", 0, NULL, STORES(flag, kernels), .commands = COMMAND_CHART,
     .help = N_("chart methods of the laboratory and not scenes")},
    {"json", 0, NULL, STORES(flag, json), .commands = REPORTS,
     .help = N_("print one JSON object per line")},
    {"progress", 0, N_("WAY"), STORES(word, progress), .words = progress_words,
     .commands = PICTURES | COMMAND_BENCH | COMMAND_CHART | COMMAND_LAB | COMMAND_NEEDS,
     .help = N_("auto, json or none")},
    {"quiet", 'q', NULL, STORES(flag, quiet), .commands = ALL,
     .help = N_("say nothing but errors")},
    {"help", 'h', NULL, STORES(flag, help), .commands = ALL, .help = N_("print this")},
    {"version", 'V', NULL, STORES(flag, version), .commands = ALL, .help = N_("print the version")},
};

/** Width of the column of names in the help, letters. */
static const int NAME_WIDTH = 22;

/** Number of options. */
enum { OPTION_COUNT = sizeof option_specs / sizeof *option_specs };

/** @return Whether a command takes an option. @param command The command; NULL: a command line
 *  without one, which takes `--help` and `--version` alone. */
static bool command_accepts(const Command *command, const OptionSpec *option) {
    return command ? (option->commands & command->id) != 0
                   : option->offset == offsetof(Options, help) ||
                         option->offset == offsetof(Options, version);
}

/* --- parsing ---------------------------------------------------------------------------------- */

/** The value of getopt_long() for row 0; options count up from it, beyond all characters. */
enum { FIRST_OPTION_CODE = UCHAR_MAX + 1 };

/** The table in the form of getopt_long(). */
typedef struct GetoptTables {
    char short_options[2 * OPTION_COUNT + 2];     /**< A colon first: getopt prints nothing. */
    struct option long_options[OPTION_COUNT + 1]; /**< Long options. */
} GetoptTables;

/** @return The tables of all options. */
static GetoptTables getopt_tables(void) {
    GetoptTables tables = {.short_options = ":"};
    char *letter = tables.short_options + 1;
    for (int i = 0; i < OPTION_COUNT; i++) {
        const OptionSpec *spec = &option_specs[i];
        tables.long_options[i] =
            (struct option){spec->name, spec->argument ? required_argument : no_argument, NULL,
                            FIRST_OPTION_CODE + i};
        if (spec->letter) {
            *letter++ = spec->letter;
            if (spec->argument) {
                *letter++ = ':';
            }
        }
    }
    return tables;
}

/** @return The option that getopt_long() has found, or NULL. */
static const OptionSpec *find_option(int code) {
    for (int i = 0; i < OPTION_COUNT; i++) {
        if (FIRST_OPTION_CODE + i == code || (option_specs[i].letter == code && code)) {
            return &option_specs[i];
        }
    }
    return NULL;
}

/**
 * Rejects what getopt_long() does not take.
 * @param code  What it returned: `:` for a value that is missing, else `?`. `optopt` is the letter
 *              or the code of the option; 0: no long name, or several, begin with the word.
 * @param word  The word of the command line; a word of letters may hold several options.
 * @return false
 */
static bool reject_option(int code, const char *word, Error *error) {
    char letter[] = {'-', (char)optopt, 0}, choices[ERROR_MESSAGE_SIZE / 2] = "";
    if (code == ':') {
        return error_set(error, STATUS_USAGE, "%s needs a value",
                         optopt < FIRST_OPTION_CODE ? letter : word);
    }
    if (optopt >= FIRST_OPTION_CODE) {
        return error_set(error, STATUS_USAGE, "--%s takes no value", find_option(optopt)->name);
    }
    if (optopt) {
        return error_set(error, STATUS_USAGE, "there is no option %s", letter);
    }
    size_t length = strcspn(word, "=");
    for (int i = 0; length > 2 && i < OPTION_COUNT; i++) {
        const OptionSpec *option = &option_specs[i];
        if (strncmp(word + 2, option->name, length - 2) == 0) {
            size_t used = strlen(choices);
            snprintf(choices + used, sizeof choices - used, "%s--%s", used ? ", " : "",
                     option->name);
        }
    }
    return choices[0] ? error_set(error, STATUS_USAGE, "%s is ambiguous: %s", word, choices)
                      : error_set(error, STATUS_USAGE, "there is no option %s", word);
}

/**
 * Parses one option as getopt_long() found it.
 * @param command  The command, or NULL.
 * @param word  The word of the command line.
 * @return false if it is wrong.
 */
static bool parse_option(const Command *command, int code, const char *word, Options *options,
                         Error *error) {
    const OptionSpec *option = find_option(code);
    if (!option) {
        return reject_option(code, word, error);
    }
    if (!command_accepts(command, option)) {
        return error_set(error, STATUS_USAGE, "%s does not take --%s",
                         command ? command->name : "dioptre", option->name);
    }
    return option->parse(option, optarg, options, error);
}

Options options_default(void) {
    return (Options){.time = (double)NAN,
                     .depth = -1,
                     .ray = -1,
                     .cutoff = -1,
                     .offset = -1,
                     .epsilon = -1,
                     .seconds = -1};
}

double options_time(const Options *options) {
    return isnan(options->time) ? 0 : options->time;
}

bool options_parse(const Command *command, int argc, char **argv, Options *options, Error *error) {
    GetoptTables tables = getopt_tables();
    *options = options_default();
    optind = 0; // Starts anew, whatever an earlier command line has left in getopt_long().
    int code = 0;
    while ((code = getopt_long(argc, argv, tables.short_options, tables.long_options, NULL)) !=
           -1) {
        if (!parse_option(command, code, argv[optind - 1], options, error)) {
            return false;
        }
        if (options->help || options->version) {
            return true; // Whatever follows is not looked at.
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
        if (command_accepts(command, option)) {
            char name[64];
            snprintf(name, sizeof name, "--%s %s", option->name,
                     option->argument ? gettext(option->argument) : "");
            printf("  %c%c ", option->letter ? '-' : ' ', option->letter ? option->letter : ' ');
            print_padded(name, NAME_WIDTH);
            printf(" %s\n", gettext(option->help));
        }
    }
}
