/**
 * @file
 * @brief What all meshes and pictures of a scene may take together.
 *
 * Each file has limits of its own, but a scene can name any number of files.
 */
#ifndef DIOPTRE_ASSETS_ASSET_BUDGET_H
#define DIOPTRE_ASSETS_ASSET_BUDGET_H

#include "base/error.h"

#include <stddef.h>
#include <sys/stat.h>

/**
 * Memory of all meshes and textures of a scene, bytes: the largest mesh that a file may hold, and
 * half the memory of a small computer.
 */
#define ASSET_MEMORY_LIMIT ((size_t)2 << 30)
/** Sizes of all mesh and picture files of a scene, bytes: no file is much larger than its content.
 */
#define ASSET_FILE_LIMIT ((size_t)2 << 30)
/**
 * Processor time of reading all files of a scene, seconds: twice what a text of #ASSET_FILE_LIMIT
 * takes on a usual computer.
 */
#define ASSET_TIME_LIMIT 120.0
/** Largest number of mesh and picture files of a scene: more than any flip book needs. */
enum { ASSET_COUNT_LIMIT = 4096 };

/** What is left for the files of a scene. */
typedef struct AssetBudget {
    size_t memory;     /**< Bytes of meshes and textures. */
    size_t file_bytes; /**< Bytes of files. */
    double seconds;    /**< Processor time, seconds. */
    int count;         /**< Number of files. */
} AssetBudget;

/** An open file of a scene. */
typedef struct AssetFile {
    const char *path; /**< Path, for its extension and its name. */
    int descriptor;   /**< Its descriptor. */
    struct stat info; /**< Its properties when it was opened. */
} AssetFile;

/** Fills a budget. */
void asset_budget_init(AssetBudget *budget);

/**
 * Takes a file.
 * @param[in,out] budget  The budget.
 * @param[out] error      What is wrong.
 * @return false if the scene names too many.
 */
bool asset_budget_take_file(AssetBudget *budget, Error *error);

/**
 * Takes the size of a file.
 * @param[in,out] budget  The budget.
 * @param size            Bytes.
 * @param[out] error      What is wrong.
 * @return false if it is more than what is left.
 */
bool asset_budget_take_file_bytes(AssetBudget *budget, size_t size, Error *error);

/** Takes memory of a mesh or texture. @return See #asset_budget_take_file_bytes. */
bool asset_budget_take_memory(AssetBudget *budget, size_t size, Error *error);

/** Takes processor time; what is left may become negative. */
void asset_budget_take_seconds(AssetBudget *budget, double seconds);

/** Sets the error of too much memory. @return false, always. */
bool asset_budget_set_memory_error(Error *error);

/** Sets the error of too much processor time. @return false, always. */
bool asset_budget_set_time_error(Error *error);

#endif
