/**
 * @file
 * @brief What a scene file needs that no time changes.
 */
#ifndef DIOPTRE_SCRIPT_ASSET_CACHE_H
#define DIOPTRE_SCRIPT_ASSET_CACHE_H

#include "dioptre/script.h"
#include "script/script_text.h"

/** @return The text of the scene file, empty until it is read; owned by the stock. */
ScriptText *asset_cache_text(AssetCache *cache);

/**
 * Gives a scene the models and pictures that it names and that are in a stock.
 * @param cache          The stock; NULL: nothing is in it.
 * @param[in,out] scene  The scene; it becomes one of their owners.
 */
void asset_cache_fill_scene(const AssetCache *cache, Scene *scene);

/**
 * Keeps the models and pictures of a scene, and no others: a film whose every frame has a picture
 * of its own must not fill the memory.
 * @param[in,out] cache  The stock, which becomes one of their owners; NULL: nothing is kept.
 * @param scene  The scene, with all that it names.
 * @return false without memory; nothing is kept then.
 */
bool asset_cache_store(AssetCache *cache, const Scene *scene, Error *error);

#endif
