/**
 * @file
 * @brief The commands, and what they share: loading a scene, settings, interruption, progress.
 */
#ifndef DIOPTRE_CLI_COMMANDS_H
#define DIOPTRE_CLI_COMMANDS_H

#include "cli/options.h"
#include "dioptre/scene.h"

#include <stdio.h>

extern const Command view_command;    /**< `view` */
extern const Command render_command;  /**< `render` */
extern const Command info_command;    /**< `info` */
extern const Command compare_command; /**< `compare` */
extern const Command bench_command;   /**< `bench` */

/**
 * Loads the scene that a command line names.
 * @param options     The command line.
 * @param[out] error  What is wrong.
 * @return The scene, to be given back with #scene_destroy; NULL if anything is wrong.
 */
Scene *command_scene(const Options *options, Error *error);

/**
 * @return What a command line asks of the renderer, over what the scene asks for.
 * @param options  The command line.
 * @param scene    The scene.
 */
RenderSettings command_settings(const Options *options, const Scene *scene);

/** @return A strategy's name. @param offset The strategy. */
const char *offset_name(OffsetStrategy offset);

/**
 * Prints a text as a JSON string, quotes included.
 * @param text    The text; bytes that are not printable ASCII are kept or escaped.
 * @param stream  Where to.
 */
void json_print_string(const char *text, FILE *stream);

/**
 * Prints a text for people, without what could move the cursor.
 * @param text    The text; control characters become `?`.
 * @param stream  Where to.
 */
void print_clean(const char *text, FILE *stream);

/**
 * @return A flag that becomes true at SIGINT or SIGTERM from now on.
 */
const atomic_bool *interrupt_flag(void);

/** What is kept to tell how far models are read. */
typedef struct ModelsProgress {
    MeshProgress teller; /**< Who tells. */
    bool is_json;        /**< JSON lines, not one line for people. */
    bool is_shown;       /**< Whether there is a line to be cleared. */
} ModelsProgress;

/**
 * Prepares to tell on standard error how far models are read: those that take more than half a
 * second.
 * @param[out] models  What is kept; must stay where it is.
 * @param options      Whether and how.
 * @return Who tells, owned by \p models; NULL where nothing is to be told.
 */
const MeshProgress *models_progress(ModelsProgress *models, const Options *options);

/** A thread that tells how far a renderer is. */
typedef struct Progress Progress;

/**
 * Begins to tell progress on standard error.
 * @param renderer  The renderer.
 * @param options   Whether and how.
 * @return To be given to #progress_end; NULL where nothing is to be told.
 */
Progress *progress_begin(const Renderer *renderer, const Options *options);

/** Ends it and clears its line. @param progress What #progress_begin returned, or NULL. */
void progress_end(Progress *progress);

#endif
