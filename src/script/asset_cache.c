/**
 * @file
 * @brief What a scene file needs that no time changes.
 */
#include "script/asset_cache.h"

#include <stdlib.h>
#include <string.h>

/** A file that was read: a model or a picture. */
typedef struct CacheEntry {
    char *path;       /**< Where it is, absolute and without links; owned. */
    Mesh *mesh;       /**< What is in it; NULL: it is a picture. */
    Texture *texture; /**< What is in it; NULL: it is a model. */
} CacheEntry;

struct AssetCache {
    ScriptText text;     /**< The text of the scene file. */
    CacheEntry *entries; /**< The models and pictures of the scene that was loaded last; owned. */
    size_t count;        /**< How many. */
};

AssetCache *asset_cache_create(Error *error) {
    AssetCache *cache = calloc(1, sizeof *cache);
    if (!cache) {
        error_set(error, STATUS_FAILED, "no memory for a scene file");
    }
    return cache;
}

/** Gives items back. @param entries The items, or NULL. */
static void entries_destroy(CacheEntry *entries, size_t count) {
    for (size_t i = 0; i < count; i++) {
        free(entries[i].path);
        mesh_release(entries[i].mesh);
        texture_release(entries[i].texture);
    }
    free(entries);
}

void asset_cache_destroy(AssetCache *cache) {
    if (cache) {
        entries_destroy(cache->entries, cache->count);
        script_text_deinit(&cache->text);
        free(cache);
    }
}

ScriptText *asset_cache_text(AssetCache *cache) {
    return &cache->text;
}

/**
 * Finds a file in a stock.
 * @param cache  The stock, or NULL.
 * @param path   The file, absolute and without links.
 * @return It; an item with nothing in it if it is not there.
 */
static CacheEntry find_entry(const AssetCache *cache, const char *path) {
    for (size_t i = 0; cache && i < cache->count; i++) {
        if (strcmp(cache->entries[i].path, path) == 0) {
            return cache->entries[i];
        }
    }
    return (CacheEntry){0};
}

void asset_cache_fill_scene(const AssetCache *cache, Scene *scene) {
    for (size_t i = 0; i < scene->mesh_count; i++) {
        scene->meshes[i].mesh = mesh_retain(find_entry(cache, scene->meshes[i].file.path).mesh);
    }
    for (size_t i = 0; i < scene->texture_count; i++) {
        scene->textures[i].texture =
            texture_retain(find_entry(cache, scene->textures[i].file.path).texture);
    }
}

/**
 * Fills items with the models and pictures of a scene.
 * @param[out] entries  Room for all of them, zero.
 * @return false without memory.
 */
static bool entries_fill(const Scene *scene, CacheEntry *entries) {
    bool is_complete = true;
    for (size_t i = 0; i < scene->mesh_count; i++, entries++) {
        *entries = (CacheEntry){.path = strdup(scene->meshes[i].file.path),
                                .mesh = mesh_retain(scene->meshes[i].mesh)};
        is_complete = is_complete && entries->path;
    }
    for (size_t i = 0; i < scene->texture_count; i++, entries++) {
        *entries = (CacheEntry){.path = strdup(scene->textures[i].file.path),
                                .texture = texture_retain(scene->textures[i].texture)};
        is_complete = is_complete && entries->path;
    }
    return is_complete;
}

bool asset_cache_store(AssetCache *cache, const Scene *scene, Error *error) {
    if (!cache) {
        return true;
    }
    size_t count = scene->mesh_count + scene->texture_count;
    CacheEntry *entries = calloc(count + 1, sizeof *entries);
    if (!entries || !entries_fill(scene, entries)) {
        entries_destroy(entries, entries ? count : 0);
        return error_set(error, STATUS_FAILED, "no memory for the files of a scene");
    }
    entries_destroy(cache->entries, cache->count);
    cache->entries = entries;
    cache->count = count;
    return true;
}
