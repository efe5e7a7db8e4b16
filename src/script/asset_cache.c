/**
 * @file
 * @brief The cache of a scene file: its text, its meshes and its textures.
 */
#include "script/asset_cache.h"

#include <stdlib.h>
#include <string.h>

/** A file that was read: a mesh or a texture. */
typedef struct CacheEntry {
    char *path;       /**< Absolute path without links; owned. */
    dev_t device;     /**< See #SceneFile.device. */
    ino_t inode;      /**< See #SceneFile.device. */
    Mesh *mesh;       /**< The mesh, retained; NULL: it is a texture. */
    Texture *texture; /**< The texture, retained; NULL: it is a mesh. */
} CacheEntry;

struct AssetCache {
    ScriptText text;     /**< The text of the scene file. */
    CacheEntry *entries; /**< The meshes and textures of the last scene; owned. */
    size_t count;        /**< Number of entries. */
};

AssetCache *asset_cache_create(Error *error) {
    AssetCache *cache = calloc(1, sizeof *cache);
    if (!cache) {
        error_set(error, STATUS_FAILED, "no memory for a scene file");
    }
    return cache;
}

/** Releases entries. @param entries The entries, or NULL. @param count Number of entries. */
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
 * Finds a file in a cache.
 * @param cache  The cache, or NULL.
 * @param path   Absolute path without links.
 * @return The entry; all its pointers are NULL if the file is not in the cache.
 */
static CacheEntry find_entry(const AssetCache *cache, const char *path) {
    for (size_t i = 0; cache && i < cache->count; i++) {
        if (strcmp(cache->entries[i].path, path) == 0) {
            return cache->entries[i];
        }
    }
    return (CacheEntry){0};
}

/** Finds a file of a scene in a cache, and sets which file it is. @return See #find_entry. */
static CacheEntry find_file(const AssetCache *cache, SceneFile *file) {
    CacheEntry entry = find_entry(cache, file->path);
    file->device = entry.device;
    file->inode = entry.inode;
    return entry;
}

void asset_cache_fill_scene(const AssetCache *cache, Scene *scene) {
    for (size_t i = 0; i < scene->mesh_count; i++) {
        SceneMesh *it = &scene->meshes[i];
        it->mesh = mesh_retain(find_file(cache, &it->file).mesh);
    }
    for (size_t i = 0; i < scene->texture_count; i++) {
        SceneTexture *it = &scene->textures[i];
        it->texture = texture_retain(find_file(cache, &it->file).texture);
    }
}

/**
 * Fills entries with the meshes and textures of a scene.
 * @param scene         The scene.
 * @param[out] entries  Memory for all of them, set to zero.
 * @return false without memory.
 */
static bool entries_fill(const Scene *scene, CacheEntry *entries) {
    bool is_complete = true;
    for (size_t i = 0; i < scene->mesh_count; i++, entries++) {
        const SceneFile *file = &scene->meshes[i].file;
        *entries = (CacheEntry){.path = strdup(file->path),
                                .device = file->device,
                                .inode = file->inode,
                                .mesh = mesh_retain(scene->meshes[i].mesh)};
        is_complete = is_complete && entries->path;
    }
    for (size_t i = 0; i < scene->texture_count; i++, entries++) {
        const SceneFile *file = &scene->textures[i].file;
        *entries = (CacheEntry){.path = strdup(file->path),
                                .device = file->device,
                                .inode = file->inode,
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
