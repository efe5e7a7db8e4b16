/**
 * @file
 * @brief The cache of a scene file: its text, its meshes and its textures.
 */
#ifndef DIOPTRE_SCRIPT_ASSET_CACHE_H
#define DIOPTRE_SCRIPT_ASSET_CACHE_H

#include "dioptre/script.h"
#include "script/script_text.h"

/** @return The text of the scene file, owned by the cache; empty until it is read. */
ScriptText *asset_cache_text(AssetCache *cache);

/**
 * Sets the meshes and textures of a scene that are in a cache.
 * @param cache          The cache; NULL: an empty one.
 * @param[in,out] scene  The scene; it retains them.
 */
void asset_cache_fill_scene(const AssetCache *cache, Scene *scene);

/**
 * Replaces the content of a cache with the meshes and textures of a scene. Others are released: a
 * film with one texture per frame must not fill the memory.
 * @param[in,out] cache  The cache; it retains them. NULL: nothing is kept.
 * @param scene          The scene, with all its files read.
 * @param[out] error     What is wrong.
 * @return false without memory; the cache keeps nothing then.
 */
bool asset_cache_store(AssetCache *cache, const Scene *scene, Error *error);

#endif
