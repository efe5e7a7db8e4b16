/**
 * @file
 * @brief The command line: one table of options for parsing, for help and for errors.
 */
#ifndef DIOPTRE_CLI_OPTIONS_H
#define DIOPTRE_CLI_OPTIONS_H

#include "cli/frames.h"
#include "dioptre/renderer.h"

/** The commands, as bits of a set. */
typedef enum {
    COMMAND_VIEW = 1 << 0,    /**< `view` */
    COMMAND_RENDER = 1 << 1,  /**< `render` */
    COMMAND_ANIMATE = 1 << 2, /**< `animate` */
    COMMAND_PROBE = 1 << 3,   /**< `probe` */
    COMMAND_INFO = 1 << 4,    /**< `info` */
    COMMAND_COMPARE = 1 << 5, /**< `compare` */
    COMMAND_BENCH = 1 << 6,   /**< `bench` */
    COMMAND_NEEDS = 1 << 7,   /**< `needs` */
    COMMAND_CHART = 1 << 8,   /**< `chart` */
    COMMAND_LAB = 1 << 9      /**< `lab` */
} CommandId;

/** How progress is reported. */
typedef enum {
    PROGRESS_AUTO, /**< A line with an estimate, only on a terminal. */
    PROGRESS_JSON, /**< One JSON object per line. */
    PROGRESS_NONE  /**< Not at all. */
} ProgressStyle;

/** Which rays `bench` times. */
typedef enum {
    BENCH_IMAGE,   /**< The whole picture. */
    BENCH_PRIMARY, /**< Closest hits of the camera rays. */
    BENCH_RANDOM   /**< Closest hits of random rays. */
} BenchRays;

/** What the window's keys for the light are bound to. */
typedef enum {
    KEYS_BY_POSITION, /**< Positions on the keyboard, whatever is printed there. */
    KEYS_BY_LETTER    /**< The letters themselves. */
} KeyBinding;

/** Most arguments that a command takes besides options. */
enum { ARGUMENTS_MAXIMUM = 64 };

/** The values of a command line. Without an option its number is 0 and its word NULL, unless the
 *  member names another default. */
typedef struct Options {
    const char *arguments[ARGUMENTS_MAXIMUM]; /**< Scene or picture files, or tests. */
    int argument_count;                       /**< Number of arguments. */
    const char *output;                       /**< `-o`: file to write. */
    const char *out_dir;                      /**< `--out`: folder to write into. */
    const char *base_dir;                     /**< `--base-dir` */
    const char *svg;                          /**< `--svg`: drawing to write. */
    const char *map;                          /**< `--map`: difference picture to write. */
    const char *lesson;                       /**< `--lesson`: lesson to play. */
    const char *lesson_snapshots;             /**< `--lesson-snapshots`: folder to write into. */
    const char *predictions;                  /**< `--predictions`: digits; NULL: right ones. */
    const char *answers;                      /**< `--answers`: file to append to. */
    const Engine *engine;                     /**< `--engine`; NULL: automatic. */
    int width;                                /**< `--size` */
    int height;                               /**< `--size` */
    int samples;                              /**< `--samples` */
    int sampling;                             /**< `--sampling`: a #Sampling. */
    int depth;                                /**< `--depth`; default -1. */
    double cutoff;                            /**< `--cutoff`, 8-bit steps; default -1. */
    int threads;                              /**< `--threads` */
    FrameRange frames;                        /**< `--frames`; default: step 0. */
    double seconds;                           /**< `--seconds`; default -1. */
    double fps;                               /**< `--fps` */
    int ray;                                  /**< `--ray`; default -1: none. */
    int threshold;                            /**< `--threshold`, steps of 8 bits. */
    double time;                              /**< `--time`, seconds; default NaN: #options_time. */
    int offset;                               /**< `--offset`: an #OffsetStrategy; default -1. */
    double epsilon;                           /**< `--epsilon`, scene units; default -1. */
    int pixel;                                /**< `--pixel`: a #PixelPoint. */
    int methods;                              /**< `--methods`: a #MethodSet. */
    double error;                             /**< `--error`, 8-bit steps; 0: not given. */
    double budget;                            /**< `--budget`, milliseconds; 0: not given. */
    int progress;                             /**< `--progress`: a #ProgressStyle. */
    int rays;                                 /**< `--rays`: a #BenchRays. */
    int keys;                                 /**< `--keys`: a #KeyBinding. */
    bool skip_existing;                       /**< `--skip-existing` */
    bool no_sync;                             /**< `--no-sync` */
    bool quiet;                               /**< `--quiet` */
    bool json;                                /**< `--json` */
    bool timing;                              /**< `--timing` */
    bool opens_list;                          /**< Whether the list of scenes is open at first. */
    bool kernels;                             /**< `--kernels` */
    bool help;                                /**< `--help` */
    bool version;                             /**< `--version` */
} Options;

/** A command. */
typedef struct Command {
    CommandId id;                /**< Its bit in #OptionSpec.commands. */
    const char *name;            /**< Such as `render`. */
    const char *usage;           /**< Its arguments in one line, in English. */
    const char *help;            /**< Its purpose in one line, in English. */
    int arguments;               /**< Number of arguments. */
    int optional_arguments;      /**< How many of these may be left out. */
    bool accepts_more_arguments; /**< Whether any number of further arguments is allowed. */

    /**
     * Runs the command.
     * @param options     The parsed command line.
     * @param[out] error  Its status is the exit status of the program; #STATUS_OK if left alone.
     */
    void (*run)(const Options *options, Error *error);
} Command;

/** @return Options as an empty command line gives them. */
Options options_default(void);

/** @return The time of the scene, seconds: that of `--time`, or 0. */
double options_time(const Options *options);

/**
 * Parses a command line.
 * @param command  The command, or NULL: only `--help` and `--version` are known.
 * @param argc  Number of words, the command's own first.
 * @return false if anything is wrong (#STATUS_USAGE).
 */
bool options_parse(const Command *command, int argc, char **argv, Options *options, Error *error);

/** Prints the options of a command, one per line. */
void options_print(const Command *command);

#endif
