/**
 * @file
 * @brief What the targets of scene texts, lessons and NFF share: a run inside this process.
 *
 * The program runs such texts in a worker, which ends afterwards. The targets are linked with
 * `--wrap` (see the Makefile), so that the Lua state is freed after each run, that each run ends
 * after a number of steps and not of seconds, and that no limit of the worker stays on this
 * process.
 */
#ifndef DIOPTRE_TESTS_FUZZ_SCRIPT_TARGET_H
#define DIOPTRE_TESTS_FUZZ_SCRIPT_TARGET_H

#include "fuzz.h"

#include "script/script_run.h"

/** Path of the text, as messages say it. */
#define FUZZ_SCRIPT_PATH "fuzz.lua"

/** A run of a text. */
typedef struct FuzzRun {
    ScriptText text;       /**< The text. */
    ScriptRequest request; /**< The request. */
    WorkerJob job;         /**< The job that a worker would have. */
    ScriptRun run;         /**< The run; its dialect, scene or lesson are set by the target. */
} FuzzRun;

/**
 * Prepares a run.
 * @param[out] run  The run, to be ended with #fuzz_run_deinit.
 * @param data      The text; copied.
 * @param size      Its bytes.
 * @return false if the program would refuse the text before any run.
 */
bool fuzz_run_init(FuzzRun *run, const uint8_t *data, size_t size);

/**
 * Executes a run and checks its report.
 * @param run      The run.
 * @param execute  Executes it.
 * @return Whether it ended without an error.
 */
bool fuzz_run_execute(FuzzRun *run, void (*execute)(ScriptRun *run));

/** Frees a run. @param run The run. */
void fuzz_run_deinit(FuzzRun *run);

/**
 * Runs a text that makes a scene.
 * @param data     The text.
 * @param size     Its bytes.
 * @param dialect  What the text is written in; NULL: no Lua.
 * @param execute  Executes the run.
 * @param check    Checks a scene that was accepted, beyond its camera and materials.
 */
void fuzz_run_scene(const uint8_t *data, size_t size, const ScriptDialect *dialect,
                    void (*execute)(ScriptRun *run), void (*check)(const Scene *scene));

#endif
