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

/** @return A block of which nothing is handed out; NULL without memory. @param[out] error What is
 *  wrong. */
static Block *block_create(Error *error) {
    Block *block = mmap(NULL, SCENE_MEMORY, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (block == MAP_FAILED) {
        error_set(error, STATUS_FAILED, "no memory for a scene");
        return NULL;
    }
    block->used = sizeof *block;
    return block;
}

Scene *scene_create(Error *error) {
    Block *block = block_create(error);
    if (!block) {
        return NULL;
    }
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

/* --- a scene elsewhere -------------------------------------------------------------------------
 */

/**
 * Copies an array into a block.
 * @param block           The block.
 * @param array           The array.
 * @param count           Items that are in it.
 * @param size            Bytes an item.
 * @param[out] capacity   Items that fit into the copy.
 * @param[out] error      What is wrong.
 * @return The copy; NULL when the block is full.
 */
static void *block_copy(Block *block, const void *array, size_t count, size_t size,
                        size_t *capacity, Error *error) {
    void *copy = block_allocate(block, count * size, error);
    *capacity = count;
    return copy && count ? memcpy(copy, array, count * size) : copy;
}

/** Copies the lamps, materials and pictures of a scene. @param block The block of the new scene.
 *  @param scene The scene. @param[out] error What is wrong. @return false without memory. */
static bool copy_arrays(Block *block, const Scene *scene, Error *error) {
    Scene *copy = &block->scene;
    copy->lights = block_copy(block, scene->lights, scene->light_count, sizeof *copy->lights,
                              &block->light_capacity, error);
    copy->materials = block_copy(block, scene->materials, scene->material_count,
                                 sizeof *copy->materials, &block->material_capacity, error);
    copy->textures = block_copy(block, scene->textures, scene->texture_count,
                                sizeof *copy->textures, &block->texture_capacity, error);
    if (!copy->lights || !copy->materials || !copy->textures) {
        return false;
    }
    copy->texture_count = scene->texture_count;
    for (size_t i = 0; i < copy->texture_count; i++) {
        texture_share(copy->textures[i].texture);
    }
    return true;
}

/** Copies the models of a scene twice: as they are, and behind them places for those that are
 *  moved. @param block The block of the new scene. @param scene The scene. @param[out] error What
 *  is wrong. @return false without memory. */
static bool copy_meshes(Block *block, const Scene *scene, Error *error) {
    size_t count = scene->mesh_count;
    block->mesh_capacity = 2 * count;
    SceneMesh *meshes = block_allocate(block, 2 * count * sizeof *meshes, error);
    for (size_t i = 0; meshes && i < count; i++) {
        SceneFile file = scene->meshes[i].file;
        meshes[i] = (SceneMesh){file, mesh_share(scene->meshes[i].mesh)};
        meshes[count + i] = (SceneMesh){.file = file};
    }
    block->scene.meshes = meshes;
    block->scene.mesh_count = meshes ? 2 * count : 0;
    return meshes != NULL;
}

/** Lets a shape show the moved one of a model, which is made when first asked for. @param scene The
 *  moved scene. @param[in,out] place Of the model. @param way How far. @param[out] error What is
 *  wrong. @return false without memory. */
static bool move_mesh(Scene *scene, size_t *place, Vector3 way, Error *error) {
    const Mesh *mesh = scene->meshes[*place].mesh;
    *place += scene->mesh_count / 2;
    SceneMesh *moved = &scene->meshes[*place];
    if (!moved->mesh) {
        moved->mesh = mesh_moved(mesh, way, error);
    }
    return moved->mesh != NULL;
}

/** Lets a shape be the surface of a moved field. @param scene The moved scene. @param[in,out] field
 *  The field. @param way How far. @param[out] error What is wrong. @return false without memory. */
static bool move_field(Scene *scene, const Field **field, Vector3 way, Error *error) {
    Field *moved = block_allocate((Block *)scene, field_size(2 * (*field)->count), error);
    if (moved) {
        field_move(moved, *field, way);
        *field = moved;
    }
    return moved != NULL;
}

/**
 * Moves a shape: its places, its model or its field.
 * @param scene       The moved scene.
 * @param keyword     The shape's keyword.
 * @param values      Its struct.
 * @param way         How far.
 * @param[out] error  What is wrong.
 * @return false without memory.
 */
static bool move_shape(Scene *scene, const Keyword *keyword, void *values, Vector3 way,
                       Error *error) {
    bool is_moved = true;
    keyword_move(keyword, values, way);
    for (const Parameter *row = keyword->parameters; row->name && is_moved; row++) {
        void *value = (char *)values + row->offset;
        if (row->type == PARAMETER_MESH) {
            is_moved = move_mesh(scene, value, way, error);
        } else if (row->type == PARAMETER_FIELD) {
            is_moved = move_field(scene, value, way, error);
        }
    }
    return is_moved;
}

/** Adds a shape to a moved scene. Of one that is transformed only the transform moves: its own
 * space stays. @param scene The moved scene. @param shape The shape. @param keyword Its keyword.
 * @param way How far. @param[out] error What is wrong. @return false without memory. */
static bool add_moved(Scene *scene, const SceneShape *shape, const Keyword *keyword, Vector3 way,
                      Error *error) {
    if (!scene_add_shape(scene, shape->kind, keyword, shape->parameters, shape->material, error)) {
        return false;
    }
    if (shape->transform) {
        Transform transform = *shape->transform;
        keyword_move(&transform_keyword, &transform, way);
        return scene_transform_shape(scene, &transform, error);
    }
    void *values = (void *)scene->shapes[scene->shape_count - 1].parameters;
    return move_shape(scene, keyword, values, way, error);
}

Scene *scene_moved(const Scene *scene, const Keyword *const *kinds, Vector3 way, Error *error) {
    Block *block = block_create(error);
    if (!block) {
        return NULL;
    }
    Scene *moved = &block->scene;
    *moved = *scene;
    moved->shape_count = moved->mesh_count = moved->texture_count = 0;
    bool is_made = copy_arrays(block, scene, error) && copy_meshes(block, scene, error);
    for (size_t i = 0; i < scene->shape_count && is_made; i++) {
        const SceneShape *shape = &scene->shapes[i];
        is_made = add_moved(moved, shape, kinds[shape->kind], way, error);
    }
    if (!is_made) {
        scene_destroy(moved);
        return NULL;
    }
    keyword_move(&camera_keyword, &moved->camera, way);
    for (size_t i = 0; i < moved->light_count; i++) {
        keyword_move(light_keyword_of(&moved->lights[i]), &moved->lights[i], way);
    }
    return moved;
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
