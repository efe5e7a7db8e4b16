/**
 * @file
 * @brief The command line: one table of options for parsing, for help and for errors.
 */
#ifndef DIOPTRE_CLI_OPTIONS_H
#define DIOPTRE_CLI_OPTIONS_H

#include "cli/frames.h"
#include "dioptre/renderer.h"

/** How progress is told. */
typedef enum {
    PROGRESS_AUTO, /**< A line with an estimate, only on a terminal. */
    PROGRESS_JSON, /**< One JSON object a line. */
    PROGRESS_NONE  /**< Not at all. */
} ProgressStyle;

/** Which rays `bench` times. */
typedef enum {
    BENCH_IMAGE,   /**< The whole picture. */
    BENCH_PRIMARY, /**< Nearest hits of the camera's rays. */
    BENCH_RANDOM   /**< Nearest hits of random rays. */
} BenchRays;

/** Most arguments that a command takes besides options. */
enum { ARGUMENTS_MAXIMUM = 64 };

/** Everything that a command line can say. Numbers are 0, and words NULL, where nothing was said.
 */
typedef struct Options {
    const char *arguments[ARGUMENTS_MAXIMUM]; /**< Scene or picture files, or tests. */
    int argument_count;                       /**< How many. */
    const char *output;                       /**< `-o`: file to write. */
    const char *out_dir;                      /**< `--out`: folder to write into. */
    const char *base_dir;                     /**< `--base-dir` */
    const char *svg;                          /**< `--svg`: drawing to write. */
    const char *map;                          /**< `--map`: difference picture to write. */
    const char *lesson;                       /**< `--lesson`: what is done in the window. */
    const char *lesson_snapshots;             /**< `--lesson-snapshots`: folder to write into. */
    const Engine *engine;                     /**< `--engine`; NULL: as the scene needs. */
    int width;                                /**< `--size` */
    int height;                               /**< `--size` */
    int samples;                              /**< `--samples` */
    Sampling sampling;                        /**< `--sampling` */
    int depth;                                /**< `--depth`; -1: not said. */
    int threads;                              /**< `--threads` */
    FrameRange frames;                        /**< `--frames`; step 0: not said. */
    double seconds;                           /**< `--seconds`; negative: not said. */
    double fps;                               /**< `--fps`; 0: not said. */
    int threshold;                            /**< `--threshold`, steps. */
    double time;                              /**< `--time`, seconds. */
    int offset;                               /**< `--offset`: an #OffsetStrategy; -1: not said. */
    double epsilon;                           /**< `--epsilon`, scene units; negative: not said. */
    ProgressStyle progress;                   /**< `--progress` */
    BenchRays rays;                           /**< `--rays` */
    bool skip_existing;                       /**< `--skip-existing` */
    bool quiet;                               /**< `--quiet` */
    bool json;                                /**< `--json` */
    bool keys_by_letter;                      /**< `--keys letters` */
    bool timing;                              /**< `--timing` */
    bool kernels;                             /**< `--kernels` */
    bool help;                                /**< `--help` */
    bool version;                             /**< `--version` */
} Options;

/** A command. */
typedef struct Command {
    const char *name;            /**< Such as `render`. */
    const char *usage;           /**< Its arguments, such as `SCENE -o FILE`, in English. */
    const char *help;            /**< What it does, in one line, in English. */
    const char *accepts;         /**< Keys of the options it takes; see #options_parse. */
    int arguments;               /**< How many arguments it takes. */
    int optional_arguments;      /**< How many of them may be left out. */
    bool accepts_more_arguments; /**< Whether it takes more than that, too. */
    /**
     * Does it.
     * @param options  What the command line says.
     * @return The exit status.
     */
    int (*run)(const Options *options, Error *error);
} Command;

/**
 * Reads a command line.
 * @param command  The command, or NULL: only `--help` and `--version` are known.
 * @param argc  Number of words, the command's own first.
 * @return false if anything is wrong.
 */
bool options_parse(const Command *command, int argc, char **argv, Options *options, Error *error);

/** Prints the options of a command, one a line. */
void options_print(const Command *command);

#endif
