/**
 * @file
 * @brief What a scene file needs that no time changes.
 */
#include "script/stock.h"

#include <stdlib.h>
#include <string.h>

/** A file that was read: a model or a picture. */
typedef struct Item {
    char *path;       /**< Where it is, absolute and without links; owned. */
    Mesh *mesh;       /**< What is in it; NULL: it is a picture. */
    Texture *texture; /**< What is in it; NULL: it is a model. */
} Item;

struct Stock {
    Source source; /**< The text of the scene file. */
    Item *items;   /**< The models and pictures of the scene that was loaded last; owned. */
    size_t count;  /**< How many. */
};

Stock *stock_create(Error *error) {
    Stock *stock = calloc(1, sizeof *stock);
    if (!stock) {
        error_set(error, STATUS_FAILED, "no memory for a scene file");
    }
    return stock;
}

/**
 * Gives items back.
 * @param items  The items, or NULL.
 * @param count  How many.
 */
static void items_destroy(Item *items, size_t count) {
    for (size_t i = 0; i < count; i++) {
        free(items[i].path);
        mesh_destroy(items[i].mesh);
        texture_release(items[i].texture);
    }
    free(items);
}

void stock_destroy(Stock *stock) {
    if (stock) {
        items_destroy(stock->items, stock->count);
        source_release(&stock->source);
        free(stock);
    }
}

Source *stock_source(Stock *stock) {
    return &stock->source;
}

/**
 * Finds a file in a stock.
 * @param stock  The stock, or NULL.
 * @param path   The file, absolute and without links.
 * @return It; an item with nothing in it if it is not there.
 */
static Item find(const Stock *stock, const char *path) {
    for (size_t i = 0; stock && i < stock->count; i++) {
        if (strcmp(stock->items[i].path, path) == 0) {
            return stock->items[i];
        }
    }
    return (Item){0};
}

void stock_lend(const Stock *stock, Scene *scene) {
    for (size_t i = 0; i < scene->mesh_count; i++) {
        scene->meshes[i].mesh = mesh_share(find(stock, scene->meshes[i].file.path).mesh);
    }
    for (size_t i = 0; i < scene->texture_count; i++) {
        scene->textures[i].texture =
            texture_share(find(stock, scene->textures[i].file.path).texture);
    }
}

/**
 * Fills items with the models and pictures of a scene.
 * @param scene       The scene.
 * @param[out] items  Room for all of them, zero.
 * @return false without memory.
 */
static bool items_fill(const Scene *scene, Item *items) {
    bool is_full = true;
    for (size_t i = 0; i < scene->mesh_count; i++, items++) {
        *items = (Item){.path = strdup(scene->meshes[i].file.path),
                        .mesh = mesh_share(scene->meshes[i].mesh)};
        is_full = is_full && items->path;
    }
    for (size_t i = 0; i < scene->texture_count; i++, items++) {
        *items = (Item){.path = strdup(scene->textures[i].file.path),
                        .texture = texture_share(scene->textures[i].texture)};
        is_full = is_full && items->path;
    }
    return is_full;
}

bool stock_keep(Stock *stock, const Scene *scene, Error *error) {
    if (!stock) {
        return true;
    }
    size_t count = scene->mesh_count + scene->texture_count;
    Item *items = calloc(count + 1, sizeof *items);
    if (!items || !items_fill(scene, items)) {
        items_destroy(items, items ? count : 0);
        return error_set(error, STATUS_FAILED, "no memory for the files of a scene");
    }
    items_destroy(stock->items, stock->count);
    stock->items = items;
    stock->count = count;
    return true;
}
