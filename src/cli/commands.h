/**
 * @file
 * @brief The commands, and what they share: loading a scene, settings, interruption, progress.
 */
#ifndef DIOPTRE_CLI_COMMANDS_H
#define DIOPTRE_CLI_COMMANDS_H

#include "cli/options.h"
#include "dioptre/script.h"

#include <stdio.h>

/* The commands; see Command.run. */

void cli_view(const Options *options, Error *error);    /**< `view` */
void cli_render(const Options *options, Error *error);  /**< `render` */
void cli_animate(const Options *options, Error *error); /**< `animate` */
void cli_probe(const Options *options, Error *error);   /**< `probe` */
void cli_info(const Options *options, Error *error);    /**< `info` */
void cli_compare(const Options *options, Error *error); /**< `compare` */
void cli_bench(const Options *options, Error *error);   /**< `bench` */
void cli_needs(const Options *options, Error *error);   /**< `needs` */
void cli_chart(const Options *options, Error *error);   /**< `chart` */
void cli_lab(const Options *options, Error *error);     /**< `lab` */

/** Loads the scene that a command line names. @return The scene, to be given back with
 *  #scene_destroy; NULL if anything is wrong. */
Scene *command_load_scene(const Options *options, Error *error);

/**
 * Loads the scene that a command line names once more, for another time.
 * @param time  The scene's `t`, seconds.
 * @param[in,out] cache  What an earlier call has left; may be NULL.
 * @param stop  It is given up once this is true; may be NULL.
 * @return See #command_load_scene.
 */
Scene *command_load_scene_at(const Options *options, double time, AssetCache *cache,
                             const atomic_bool *stop, Error *error);

/** @return What a command line asks of the renderer, over what the scene asks for. */
RenderSettings command_render_settings(const Options *options, const Scene *scene);

/**
 * Finds a test of the laboratory.
 * @param[out] error  That there is no such test, and which there are (#STATUS_USAGE).
 * @return Whether there is such a test.
 */
bool command_find_test(const char *name, size_t *index, Error *error);

/** @return How many threads a command uses. */
int command_threads(const Options *options);

/**
 * Says whether charts are missing.
 * @param[out] error  That they are, and how to get them (#STATUS_FAILED).
 * @return Whether none is.
 */
bool command_check_charts(size_t count, Error *error);

/** Prints a text with blanks after it, up to the width of a column. @param width Letters that the
 *  column is wide; a longer text sticks out. */
void print_padded(const char *text, int width);

/** Prints a text for people, without what could move the cursor. @param text The text; control
 *  characters become `?`. */
void print_sanitized(const char *text, FILE *stream);

/**
 * @return A flag that becomes true at SIGINT or SIGTERM from now on.
 */
const atomic_bool *interrupt_flag(void);

/** What is kept to tell how far models are read. */
typedef struct MeshReadProgress {
    MeshProgress callbacks; /**< Who tells. */
    bool is_json;           /**< JSON lines, not one line for people. */
    bool is_shown;          /**< Whether there is a line to be cleared. */
} MeshReadProgress;

/**
 * Prepares to tell on standard error how far models are read: those that take more than half a
 * second.
 * @param[out] progress  What is kept; must stay where it is.
 * @return Who tells, owned by \p models; NULL where nothing is to be told.
 */
const MeshProgress *mesh_read_progress_init(MeshReadProgress *progress, const Options *options);

/** A thread that tells how far one picture or several are. */
typedef struct Progress Progress;

/**
 * Begins to tell progress on standard error.
 * @param pictures  How many pictures there will be.
 * @return To be given to #progress_end; NULL where nothing is to be told.
 */
Progress *progress_begin(const Options *options, int pictures);

/** The next picture is begun. @param progress What #progress_begin returned, or NULL.
 *  @param renderer Who draws it; must stay there until it is done. */
void progress_set_renderer(Progress *progress, const Renderer *renderer);

/** A picture is done. @param progress What #progress_begin returned, or NULL. */
void progress_done(Progress *progress);

/** A picture will not be drawn. @param progress What #progress_begin returned, or NULL. */
void progress_skip(Progress *progress);

/** Ends it and clears its line. @param progress What #progress_begin returned, or NULL. */
void progress_end(Progress *progress);

/** A picture that is to be drawn. */
typedef struct RenderJob {
    const Options *options; /**< The command line. */
    const char *output;     /**< The file that it is meant for. */
    double time;            /**< The scene's `t`, seconds. */
    Progress *progress;     /**< Who tells how far it is; may be NULL. */
} RenderJob;

/**
 * Draws a scene into a picture.
 * @param job  What is to be drawn.
 * @param[in,out] renderer  Who drew the picture before, or NULL: what both need is made once. Then
 *         who drew this one, or NULL; to be given back with #renderer_destroy.
 * @param[out] picture  The picture; to be released also when anything is wrong.
 * @return false if it could not be drawn.
 */
bool command_render(const RenderJob *job, const Scene *scene, Renderer **renderer, Picture *picture,
                    RenderStats *report, Error *error);

/**
 * Writes a picture into its file, with how it came about.
 * @param[in,out] picture  The picture; its notes are not there afterwards.
 * @return Whether it is there.
 */
bool command_write_image(const RenderJob *job, const Scene *scene, Picture *picture, Error *error);

#endif
