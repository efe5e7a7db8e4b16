/**
 * @file
 * @brief The commands, and what they share: scene loading, settings, interruption, progress.
 */
#ifndef DIOPTRE_CLI_COMMANDS_H
#define DIOPTRE_CLI_COMMANDS_H

#include "cli/options.h"
#include "dioptre/script.h"

#include <stdio.h>

/* The commands; see Command.run. */

void cli_view(const Options *options, Error *error); /**< `view` */
/** Shows the list of scenes over the first one. @param options The command line, which names no
 *  scene. @return false without a display or without scenes: nothing was shown. */
bool cli_browse(const Options *options, Error *error);
void cli_render(const Options *options, Error *error);  /**< `render` */
void cli_animate(const Options *options, Error *error); /**< `animate` */
void cli_probe(const Options *options, Error *error);   /**< `probe` */
void cli_info(const Options *options, Error *error);    /**< `info` */
void cli_compare(const Options *options, Error *error); /**< `compare` */
void cli_bench(const Options *options, Error *error);   /**< `bench` */
void cli_needs(const Options *options, Error *error);   /**< `needs` */
void cli_chart(const Options *options, Error *error);   /**< `chart` */
void cli_lab(const Options *options, Error *error);     /**< `lab` */

/** Loads the scene of a command line and prints its notes. @param[out] settings See
 *  #command_render_settings. @return The scene, to be freed with #scene_destroy; NULL on failure.
 */
Scene *command_load_scene(const Options *options, RenderSettings *settings, Error *error);

/** Prints the notes of a scene on standard error, and which of its surfaces coincide, unless the
 *  command line asks for quiet. @return See #command_render_settings. */
RenderSettings command_print_notes(const Options *options, const Scene *scene);

/** How the scene of a command line is run. */
typedef struct SceneRun {
    double time;                    /**< The scene's `t`, seconds. */
    AssetCache *cache;              /**< The assets of earlier runs; may be NULL. */
    const atomic_bool *stop;        /**< Loading ends early once this is true; may be NULL. */
    const SceneOverride *overrides; /**< See #ScriptRequest.overrides. */
    size_t override_count;          /**< Their number. */
} SceneRun;

/** Loads the scene of a command line. A size that this asks for becomes that of the scene. @return
 *  See #command_load_scene. */
Scene *command_run_scene(const Options *options, const SceneRun *run, Error *error);

/** @return The settings of a scene, with those of the command line over them. */
RenderSettings command_render_settings(const Options *options, const Scene *scene);

/**
 * Finds a test of the laboratory by name.
 * @param[out] error  Names the tests that there are (#STATUS_USAGE).
 * @return false if there is no such test.
 */
bool command_find_test(const char *name, size_t *index, Error *error);

/** @return Number of threads of a command. */
int command_threads(const Options *options);

/** Prints a text, padded with blanks. @param width Width of the column, letters; longer texts are
 * not cut. */
void print_padded(const char *text, int width);

/**
 * Handles SIGINT, SIGTERM and, unless it is ignored, SIGHUP: they end the program with
 * #STATUS_INTERRUPTED, at once until the first call of #interrupt_flag.
 */
void interrupt_init(void);

/**
 * @return A flag that becomes true at one of the signals of #interrupt_init, which no longer end
 * the program by themselves.
 */
const atomic_bool *interrupt_flag(void);

/** From now on the signals of #interrupt_init no longer end the program: it ends what it writes. */
void interrupt_defer(void);

/** Progress of reading mesh files. */
typedef struct MeshReadProgress {
    MeshProgress callbacks; /**< The callbacks of the reader. */
    bool is_json;           /**< JSON lines instead of one line of text. */
    bool is_shown;          /**< Whether there is a line to clear. */
} MeshReadProgress;

/**
 * Prepares progress of mesh files on standard error, for those that take over half a second.
 * @param[out] progress  The progress; must not move afterwards.
 * @return The callbacks, owned by \p progress; NULL where progress is off.
 */
const MeshProgress *mesh_read_progress_init(MeshReadProgress *progress, const Options *options);

/** @return Whether progress is reported. */
bool progress_is_wanted(const Options *options);

/** A thread that reports how many of some items are done. */
typedef struct Progress Progress;

/** What items are. */
typedef enum {
    PROGRESS_FRAMES, /**< Pictures. */
    PROGRESS_TESTS,  /**< Tests of the laboratory, which print rows of a table. */
    PROGRESS_CHARTS  /**< Charts, which print rows of a table, too. */
} ProgressItem;

/**
 * Begins to report progress on standard error.
 * @param count  Number of items.
 * @return The progress, to be ended with #progress_end; NULL where it is off: also as text beside a
 *         table on a terminal, which tells how far it is.
 */
Progress *progress_begin(const Options *options, ProgressItem item, int count);

/** Begins the first item. @param progress The progress, or NULL. */
void progress_start(Progress *progress);

/** Begins a picture. @param progress The progress, or NULL. @param renderer Its renderer, which
 * must exist until #progress_done. */
void progress_set_renderer(Progress *progress, const Renderer *renderer);

/** Ends an item. @param progress The progress, or NULL. */
void progress_done(Progress *progress);

/** Notes that a picture was stopped. @param fraction What is done of it, 0 to 1. */
void progress_stop(Progress *progress, double fraction);

/** Skips an item. @param progress The progress, or NULL. */
void progress_skip(Progress *progress);

/** Ends the reports and clears the line. @param progress The progress, or NULL. */
void progress_end(Progress *progress);

/** Makes a table and its chart. @param index Which one. @param[out] has_chart Whether there is a
 *  chart. @return false on failure. */
typedef bool ChartedRun(const void *context, size_t index, bool *has_chart, Error *error);

/** Makes tables and their charts, and reports how many are done. @param item What they are.
 *  @return false on failure, also if charts are missing; what was made before is kept. */
bool command_run_each(const Options *options, ProgressItem item, size_t count, ChartedRun *run,
                      const void *context, Error *error);

/** A picture to render. */
typedef struct RenderJob {
    const Options *options;  /**< The command line. */
    const char *output;      /**< The output file. */
    double time;             /**< The scene's `t`, seconds. */
    RenderSettings settings; /**< See #command_render_settings. */
    Progress *progress;      /**< Progress; may be NULL. */
} RenderJob;

/**
 * Renders a scene. Before the first picture it says what light will be missing.
 * @param job  The picture.
 * @param[in,out] renderer  The renderer of the previous picture, whose mesh BVHs are reused, or
 * NULL; then that of this one, to be freed with #renderer_destroy.
 * @param[out] picture  The picture; to be freed also on failure.
 * @return false on failure.
 */
bool command_render(const RenderJob *job, const Scene *scene, Renderer **renderer, Picture *picture,
                    RenderStats *report, Error *error);

/** Time for a forecast of the light that a picture will lack, seconds. */
#define FORECAST_SECONDS 0.3

/**
 * Says on standard error, before a picture, that some of its camera rays will lack more light than
 * the cutoff allows, if one of those that are tried does and the options do not ask for quiet.
 */
void command_forecast_light(const Options *options, Renderer *renderer);

/**
 * Says on standard error that camera rays lack more light than the cutoff allows, if any does and
 * the options do not ask for quiet.
 * @param rays  The rays of all pictures.
 */
void command_print_unresolved(const Options *options, const RayCounts *rays);

/** Writes a picture into its file; waits for the disk unless the options ask not to. @return false
 * on failure. */
bool command_write_file(const RenderJob *job, const Picture *picture, Error *error);

/**
 * Writes a picture into its file, with the settings as metadata.
 * @param[in,out] picture  The picture; without metadata afterwards.
 * @return false on failure.
 */
bool command_write_image(const RenderJob *job, Picture *picture, Error *error);

#endif
