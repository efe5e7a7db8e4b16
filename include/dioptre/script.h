/**
 * @file
 * @brief Scene and lesson files: Lua 5.4 in a sandbox, run in a worker process.
 */
#ifndef DIOPTRE_SCRIPT_H
#define DIOPTRE_SCRIPT_H

#include "dioptre/lesson.h"
#include "dioptre/scene.h"

#include <stdatomic.h>

/** Seconds that a scene file may run, inside library calls too. */
#define SCRIPT_TIME_LIMIT 10.0

/** Bytes that a scene file's own data may take. */
#define SCRIPT_MEMORY_LIMIT ((size_t)256 << 20)

/**
 * What a scene file needs that no time changes: its text, and the models and pictures of the scene
 * that was loaded last. Where a file is run again and again, each is read once. What it includes is
 * read by each run, in its worker: texts, in less than a millisecond.
 */
typedef struct AssetCache AssetCache;

/**
 * Makes an empty stock, for one scene file.
 * @param[out] error  What is wrong.
 * @return The stock, to be given back with #asset_cache_destroy; NULL without memory.
 */
AssetCache *asset_cache_create(Error *error);

/** Gives a stock back. @param cache The stock, or NULL. */
void asset_cache_destroy(AssetCache *cache);

/** What to load, and how. */
typedef struct ScriptRequest {
    const char *path;     /**< The scene file; `-` reads standard input. */
    const char *base_dir; /**< Where the files lie that it names; NULL: beside the scene file. */
    double time;          /**< The scene's `t`, seconds. */
    double time_limit;    /**< How long it may run; #SCRIPT_TIME_LIMIT. */
    size_t memory_limit;  /**< How many bytes its data may take; #SCRIPT_MEMORY_LIMIT. */
    const Keyword *const *shape_keywords; /**< Shapes it can create; NULL ends the list. NULL:
                                               those of the program, #scene_shape_keywords. */
    const MeshProgress *progress; /**< Told how far its model files are read; NULL: nobody is. */
    AssetCache *cache;       /**< What an earlier load left, and this one leaves; NULL: nothing. */
    const atomic_bool *stop; /**< The file is given up once this is true; NULL: never. */
    const char
        *worker; /**< Program that runs it, see script/script_worker.h; NULL: dioptre-worker. */
} ScriptRequest;

/** Names of what can be done in the window, for lessons. */
typedef struct ActionNames {
    const char *const *names; /**< The names, ended by NULL; the moves first. */
    int move_count;           /**< How many are moves, which last as long as their key is held. */
} ActionNames;

/**
 * Runs a lesson file.
 * @param path        The file.
 * @param actions     What can be done.
 * @param[out] error  `FILE:LINE: what is wrong`, with #STATUS_SCENE.
 * @return The lesson, whose scene is a file that is there, to be given back with #lesson_destroy;
 *         NULL if anything is wrong.
 */
Lesson *script_load_lesson(const char *path, const ActionNames *actions, Error *error);

/**
 * Runs a scene file, and reads the model files that it names.
 * @param request     What to load.
 * @param[out] error  `FILE:LINE: what is wrong`, with #STATUS_SCENE.
 * @return The scene, with a camera, to be given back with #scene_destroy; NULL if anything is
 *         wrong.
 */
Scene *script_load(const ScriptRequest *request, Error *error);

#endif
