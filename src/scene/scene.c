/**
 * @file
 * @brief The scene and the one block of memory that it lives in.
 */
#include "dioptre/scene.h"

#include <stdalign.h>
#include <string.h>
#include <sys/mman.h>

/** A scene at the head of its block, with what is handed out of it piece by piece. */
typedef struct Block {
    Scene scene;           /**< What the callers see; first, so that its address is the block's. */
    size_t used;           /**< Bytes handed out, this header included. */
    size_t light_capacity; /**< Lamps that fit before the array must grow. */
    size_t material_capacity; /**< Materials that fit. */
    size_t shape_capacity;    /**< Shapes that fit. */
    size_t mesh_capacity;     /**< Models that fit. */
    size_t texture_capacity;  /**< Pictures that fit. */
} Block;

/**
 * Hands out memory of a scene's block; it is given back with the block only.
 * @param block       The block.
 * @param size        Bytes.
 * @param[out] error  What is wrong.
 * @return The memory, zero and aligned for any type; NULL when the block is full.
 */
static void *block_allocate(Block *block, size_t size, Error *error) {
    size_t start = (block->used + alignof(max_align_t) - 1) & ~(alignof(max_align_t) - 1);
    if (size > SCENE_MEMORY - start) {
        error_set(error, STATUS_SCENE,
                  "the scene has more shapes, lights and materials than %zu MiB hold",
                  SCENE_MEMORY >> 20);
        return NULL;
    }
    block->used = start + size;
    return (char *)block + start;
}

/**
 * Finds room for one more item in an array of the block, which doubles when it is full.
 * @param block           The block.
 * @param[in,out] array   Address of the array.
 * @param[in,out] capacity  Items that fit.
 * @param count           Items that are in it.
 * @param size            Bytes an item.
 * @param[out] error      What is wrong.
 * @return Where the item goes; NULL when the block is full.
 */
static void *block_append(Block *block, void **array, size_t *capacity, size_t count, size_t size,
                          Error *error) {
    /** Items of a new array: enough for most scenes. */
    const size_t first_capacity = 16;
    if (count == *capacity) {
        size_t wanted = count ? 2 * count : first_capacity;
        void *larger = block_allocate(block, wanted * size, error);
        if (!larger) {
            return NULL;
        }
        if (count) {
            memcpy(larger, *array, count * size);
        }
        *array = larger;
        *capacity = wanted;
    }
    return (char *)*array + count * size;
}

Scene *scene_create(Error *error) {
    Block *block = mmap(NULL, SCENE_MEMORY, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (block == MAP_FAILED) {
        error_set(error, STATUS_FAILED, "no memory for a scene");
        return NULL;
    }
    block->used = sizeof *block;
    block->scene.image = *(const Image *)image_keyword.defaults;
    block->scene.sky = *(const Sky *)sky_keyword.defaults;
    scene_add_material(&block->scene, material_keyword.defaults, error);
    return &block->scene;
}

void scene_destroy(Scene *scene) {
    if (scene) {
        for (size_t i = 0; i < scene->mesh_count; i++) {
            mesh_destroy(scene->meshes[i].mesh);
        }
        for (size_t i = 0; i < scene->texture_count; i++) {
            texture_release(scene->textures[i].texture);
        }
        munmap(scene, SCENE_MEMORY);
    }
}

bool scene_add_light(Scene *scene, const Light *light, Error *error) {
    Block *block = (Block *)scene;
    void *array = scene->lights;
    Light *place = block_append(block, &array, &block->light_capacity, scene->light_count,
                                sizeof *light, error);
    if (place) {
        *place = *light;
        scene->lights = array;
        scene->light_count++;
    }
    return place != NULL;
}

bool scene_add_material(Scene *scene, const Material *material, Error *error) {
    Block *block = (Block *)scene;
    void *array = scene->materials;
    Material *place = block_append(block, &array, &block->material_capacity, scene->material_count,
                                   sizeof *material, error);
    if (place) {
        *place = *material;
        scene->materials = array;
        scene->material_count++;
    }
    return place != NULL;
}

bool scene_add_shape(Scene *scene, size_t kind, const Keyword *keyword, const void *parameters,
                     size_t material, Error *error) {
    Block *block = (Block *)scene;
    void *array = scene->shapes;
    void *copy = block_allocate(block, keyword->size, error);
    SceneShape *place = copy ? block_append(block, &array, &block->shape_capacity,
                                            scene->shape_count, sizeof *place, error)
                             : NULL;
    if (place) {
        memcpy(copy, parameters, keyword->size);
        *place = (SceneShape){.kind = kind, .parameters = copy, .material = material};
        scene->shapes = array;
        scene->shape_count++;
    }
    return place != NULL;
}

/**
 * Copies words into a scene.
 * @param block       Its block.
 * @param words       The words.
 * @param[out] error  What is wrong.
 * @return The copy, owned by the scene; NULL when the block is full.
 */
static const char *copy_words(Block *block, const char *words, Error *error) {
    size_t size = strlen(words) + 1;
    char *copy = block_allocate(block, size, error);
    return copy ? memcpy(copy, words, size) : NULL;
}

/**
 * Copies what is known of a file into a scene.
 * @param block       Its block.
 * @param file        The file.
 * @param[out] copy   Where to.
 * @param[out] error  What is wrong.
 * @return false when the block is full.
 */
static bool copy_file(Block *block, const SceneFile *file, SceneFile *copy, Error *error) {
    *copy = (SceneFile){.path = copy_words(block, file->path, error),
                        .name = copy_words(block, file->name, error),
                        .where = copy_words(block, file->where, error)};
    return copy->path && copy->name && copy->where;
}

bool scene_add_mesh(Scene *scene, const SceneFile *file, size_t *place, Error *error) {
    Block *block = (Block *)scene;
    for (*place = 0; *place < scene->mesh_count; (*place)++) {
        if (strcmp(scene->meshes[*place].file.path, file->path) == 0) {
            return true;
        }
    }
    void *array = scene->meshes;
    SceneMesh *added =
        block_append(block, &array, &block->mesh_capacity, scene->mesh_count, sizeof *added, error);
    if (!added || !copy_file(block, file, &added->file, error)) {
        return false;
    }
    scene->meshes = array;
    scene->mesh_count++;
    return true;
}

bool scene_add_texture(Scene *scene, const SceneFile *file, size_t *place, Error *error) {
    Block *block = (Block *)scene;
    for (*place = 0; *place < scene->texture_count; (*place)++) {
        if (strcmp(scene->textures[*place].file.path, file->path) == 0) {
            return true;
        }
    }
    void *array = scene->textures;
    SceneTexture *added = block_append(block, &array, &block->texture_capacity,
                                       scene->texture_count, sizeof *added, error);
    if (!added || !copy_file(block, file, &added->file, error)) {
        return false;
    }
    scene->textures = array;
    scene->texture_count++;
    return true;
}

const Field *scene_keep_field(Scene *scene, const Field *field, Error *error) {
    size_t size = field_size(field->count);
    Field *copy = block_allocate((Block *)scene, size, error);
    return copy ? memcpy(copy, field, size) : NULL;
}

bool scene_transform_shape(Scene *scene, const Transform *transform, Error *error) {
    Transform *copy = block_allocate((Block *)scene, sizeof *copy, error);
    if (copy) {
        *copy = *transform;
        scene->shapes[scene->shape_count - 1].transform = copy;
    }
    return copy != NULL;
}

/** @return Whether the material of any shape is of a kind. @param scene The scene. @param is_it
 *  Whether one is. */
static bool scene_has_any(const Scene *scene, bool (*is_it)(const Material *)) {
    for (size_t i = 0; i < scene->shape_count; i++) {
        if (is_it(&scene->materials[scene->shapes[i].material])) {
            return true;
        }
    }
    return false;
}

bool scene_has_textures(const Scene *scene) {
    for (size_t i = 0; i < scene->shape_count; i++) {
        if (scene->materials[scene->shapes[i].material].texture > 0) {
            return true;
        }
    }
    return false;
}

bool scene_has_mirrors(const Scene *scene) {
    return scene_has_any(scene, material_is_mirror);
}

bool scene_has_glass(const Scene *scene) {
    return scene_has_any(scene, material_is_transparent);
}

bool scene_has_highlights(const Scene *scene) {
    for (size_t i = 0; i < scene->shape_count; i++) {
        if (scene->materials[scene->shapes[i].material].specular > 0) {
            return true;
        }
    }
    return false;
}
