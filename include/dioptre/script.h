/**
 * @file
 * @brief Scene and lesson files: Lua 5.4 in a sandbox, run in a worker process.
 */
#ifndef DIOPTRE_SCRIPT_H
#define DIOPTRE_SCRIPT_H

#include "dioptre/lesson.h"
#include "dioptre/scene.h"
#include "dioptre/scene_override.h"

#include <stdatomic.h>

/** Limit of the processor time of a scene file, seconds; library calls count, too. */
#define SCRIPT_TIME_LIMIT 10.0

/** Memory limit of a scene file, bytes of its Lua data. */
#ifndef SCRIPT_MEMORY_LIMIT // A page has less: src/web/memory.h.
#define SCRIPT_MEMORY_LIMIT ((size_t)256 << 20)
#endif

/**
 * The cache of a scene file: its text, and the meshes and textures of its last load. When the file
 * is run again, as for the next frame, they are not read again. Included files are read by each
 * run, in the worker, in less than a millisecond.
 */
typedef struct AssetCache AssetCache;

/**
 * Creates an empty cache for one scene file.
 * @param[out] error  What is wrong.
 * @return The cache, to be freed with #asset_cache_destroy; NULL without memory.
 */
AssetCache *asset_cache_create(Error *error);

/** Frees a cache. @param cache The cache, or NULL. */
void asset_cache_destroy(AssetCache *cache);

/** A request to load a scene file. */
typedef struct ScriptRequest {
    const char *path;     /**< The scene file; `-` reads standard input. */
    const char *base_dir; /**< Folder of the files that it names; NULL: that of the scene file. */
    double time;          /**< The scene's `t`, seconds. */
    double time_limit;    /**< Limit of processor time, seconds; #SCRIPT_TIME_LIMIT. */
    size_t memory_limit;  /**< Limit of its Lua data, bytes; #SCRIPT_MEMORY_LIMIT. */
    const Keyword *const *shape_keywords; /**< Shapes it can create; NULL ends the list. NULL:
                                               those of the program, #scene_shape_keywords. */
    const MeshProgress *progress;   /**< Receives the progress of reading mesh files; NULL: none. */
    AssetCache *cache;              /**< Files of earlier loads, updated by this one; NULL: none. */
    const atomic_bool *stop;        /**< Loading stops once this is true; NULL: never. */
    const SceneOverride *overrides; /**< Values in place of those of the file; NULL: none. */
    size_t override_count;          /**< Their number, at most #SCENE_OVERRIDES_MAXIMUM. */
    bool is_quiet;                  /**< Whether what the scene prints is left out. */
    const char
        *worker; /**< Program of the worker, see script/script_worker.h; NULL: dioptre-worker. */
} ScriptRequest;

/** Names of the window's actions, for lessons. */
typedef struct ActionNames {
    const char *const *names; /**< The names, ended by NULL; the moves first. */
    int move_count;           /**< Number of moves, which last as long as their key is held. */
} ActionNames;

/**
 * Runs a lesson file.
 * @param path        The file.
 * @param actions     Names of the window's actions.
 * @param[out] error  `FILE:LINE: what is wrong`, with #STATUS_SCENE.
 * @return The lesson, to be freed with #lesson_destroy; NULL on errors. Its scene file exists.
 */
Lesson *script_load_lesson(const char *path, const ActionNames *actions, Error *error);

/**
 * Runs a scene file, and reads the mesh and picture files that it names.
 * @param request     What to load.
 * @param[out] error  `FILE:LINE: what is wrong`, with #STATUS_SCENE.
 * @return The scene, with a camera, to be freed with #scene_destroy; NULL on errors.
 */
Scene *script_load(const ScriptRequest *request, Error *error);

#endif
