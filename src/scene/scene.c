/**
 * @file
 * @brief The scene and its block of memory.
 */
#include "scene/scene_arena.h"

#include <stdalign.h>
#include <string.h>
#include <sys/mman.h>

/**
 * Allocates memory in the block; it is freed with the block.
 * @return The memory, set to zero and aligned for any type; NULL if the block is full.
 */
static void *scene_arena_allocate(SceneArena *arena, size_t size, Error *error) {
    size_t start = (arena->used + alignof(max_align_t) - 1) & ~(alignof(max_align_t) - 1);
    if (size > SCENE_MEMORY_SIZE - start) {
        error_set(error, STATUS_SCENE,
                  "the scene has more shapes, lights and materials than %zu MiB hold",
                  SCENE_MEMORY_SIZE >> 20);
        return NULL;
    }
    arena->used = start + size;
    return (char *)arena + start;
}

/**
 * Adds an item to an array of the block, whose capacity doubles when it is full.
 * @param[in,out] array     The array.
 * @param[in,out] capacity  Its capacity.
 * @param count             Number of its items.
 * @param size              Bytes per item.
 * @return The new item, not filled; NULL if the block is full.
 */
static void *scene_arena_append(SceneArena *arena, void **array, size_t *capacity, size_t count,
                                size_t size, Error *error) {
    /** Capacity of a new array: enough for most scenes. */
    const size_t first_capacity = 16;
    if (count == *capacity) {
        size_t new_capacity = count ? 2 * count : first_capacity;
        void *new_array = scene_arena_allocate(arena, new_capacity * size, error);
        if (!new_array) {
            return NULL;
        }
        if (count) {
            memcpy(new_array, *array, count * size);
        }
        *array = new_array;
        *capacity = new_capacity;
    }
    return (char *)*array + count * size;
}

/**
 * Creates an empty block.
 * @param address     Required address; NULL: any.
 * @param[out] error  What is wrong.
 * @return The block; NULL without memory, or if the address is not free.
 */
static SceneArena *scene_arena_create(void *address, Error *error) {
    int placement = address ? MAP_FIXED_NOREPLACE : 0;
    SceneArena *arena = mmap(address, SCENE_MEMORY_SIZE, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | placement, -1, 0);
    if (arena != MAP_FAILED && address && arena != address) { // Linux before 4.17.
        munmap(arena, SCENE_MEMORY_SIZE);
        arena = MAP_FAILED;
    }
    if (arena == MAP_FAILED) {
        error_set(error, STATUS_FAILED, "no memory for a scene");
        return NULL;
    }
    arena->used = sizeof *arena;
    return arena;
}

size_t scene_block_size(const Scene *scene) {
    return ((const SceneArena *)scene)->used;
}

Scene *scene_create(Error *error) {
    return scene_create_at(NULL, error);
}

Scene *scene_create_at(void *address, Error *error) {
    SceneArena *arena = scene_arena_create(address, error);
    if (!arena) {
        return NULL;
    }
    arena->scene.image = *(const SceneImage *)scene_image_keyword.defaults;
    arena->scene.sky = *(const SceneSky *)scene_sky_keyword.defaults;
    scene_add_material(&arena->scene, scene_material_keyword.defaults, error);
    return &arena->scene;
}

void scene_destroy(Scene *scene) {
    if (scene) {
        for (size_t i = 0; i < scene->mesh_count; i++) {
            mesh_release(scene->meshes[i].mesh);
        }
        for (size_t i = 0; i < scene->texture_count; i++) {
            texture_release(scene->textures[i].texture);
        }
        munmap(scene, SCENE_MEMORY_SIZE);
    }
}

bool scene_add_light(Scene *scene, const SceneLight *light, Error *error) {
    SceneArena *arena = (SceneArena *)scene;
    void *array = scene->lights;
    SceneLight *slot = scene_arena_append(arena, &array, &arena->light_capacity, scene->light_count,
                                          sizeof *light, error);
    if (slot) {
        *slot = *light;
        scene->lights = array;
        scene->light_count++;
    }
    return slot != NULL;
}

bool scene_add_material(Scene *scene, const SceneMaterial *material, Error *error) {
    SceneArena *arena = (SceneArena *)scene;
    void *array = scene->materials;
    SceneMaterial *slot = scene_arena_append(arena, &array, &arena->material_capacity,
                                             scene->material_count, sizeof *material, error);
    if (slot) {
        *slot = *material;
        scene->materials = array;
        scene->material_count++;
    }
    return slot != NULL;
}

bool scene_add_shape(Scene *scene, size_t class_index, const Keyword *keyword,
                     const void *parameters, size_t material_index, Error *error) {
    SceneArena *arena = (SceneArena *)scene;
    void *array = scene->shapes;
    void *copy = scene_arena_allocate(arena, keyword->size, error);
    SceneShape *slot = copy ? scene_arena_append(arena, &array, &arena->shape_capacity,
                                                 scene->shape_count, sizeof *slot, error)
                            : NULL;
    if (slot) {
        memcpy(copy, parameters, keyword->size);
        *slot = (SceneShape){
            .class_index = class_index, .parameters = copy, .material_index = material_index};
        scene->shapes = array;
        scene->shape_count++;
    }
    return slot != NULL;
}

/** Copies a string into the block. @return The copy; NULL if the block is full. */
static const char *scene_arena_copy_string(SceneArena *arena, const char *string, Error *error) {
    size_t size = strlen(string) + 1;
    char *copy = scene_arena_allocate(arena, size, error);
    return copy ? memcpy(copy, string, size) : NULL;
}

/** Copies the strings of a file into the block. @return false if the block is full. */
static bool scene_arena_copy_file(SceneArena *arena, const SceneFile *file, SceneFile *copy,
                                  Error *error) {
    *copy = (SceneFile){.path = scene_arena_copy_string(arena, file->path, error),
                        .name = scene_arena_copy_string(arena, file->name, error),
                        .location = scene_arena_copy_string(arena, file->location, error)};
    return copy->path && copy->name && copy->location;
}

/** Adds a mesh without content. @return The mesh; NULL if the block is full. */
static SceneMesh *scene_append_mesh(Scene *scene, const SceneFile *file, Error *error) {
    SceneArena *arena = (SceneArena *)scene;
    void *array = scene->meshes;
    SceneMesh *added = scene_arena_append(arena, &array, &arena->mesh_capacity, scene->mesh_count,
                                          sizeof *added, error);
    if (!added || !scene_arena_copy_file(arena, file, &added->file, error)) {
        return NULL;
    }
    scene->meshes = array;
    scene->mesh_count++;
    return added;
}

bool scene_add_mesh(Scene *scene, const SceneFile *file, size_t *index, Error *error) {
    for (*index = 0; *index < scene->mesh_count; (*index)++) {
        if (strcmp(scene->meshes[*index].file.path, file->path) == 0) {
            return true;
        }
    }
    return scene_append_mesh(scene, file, error) != NULL;
}

Mesh *scene_add_built_mesh(Scene *scene, const SceneFile *file, const Mesh *counts, size_t *index,
                           Error *error) {
    Mesh *mesh = scene_arena_allocate((SceneArena *)scene, mesh_block_size(counts), error);
    SceneMesh *added = mesh ? scene_append_mesh(scene, file, error) : NULL;
    if (!added) {
        return NULL;
    }
    mesh->position_count = counts->position_count;
    mesh->normal_count = counts->normal_count;
    mesh->uv_count = counts->uv_count;
    mesh->triangle_count = counts->triangle_count;
    mesh->repairs = counts->repairs;
    mesh_bind_arrays(mesh);
    added->built = mesh;
    *index = scene->mesh_count - 1;
    return mesh;
}

bool scene_add_texture(Scene *scene, const SceneFile *file, size_t *index, Error *error) {
    SceneArena *arena = (SceneArena *)scene;
    for (*index = 0; *index < scene->texture_count; (*index)++) {
        if (strcmp(scene->textures[*index].file.path, file->path) == 0) {
            return true;
        }
    }
    void *array = scene->textures;
    SceneTexture *added = scene_arena_append(arena, &array, &arena->texture_capacity,
                                             scene->texture_count, sizeof *added, error);
    if (!added || !scene_arena_copy_file(arena, file, &added->file, error)) {
        return false;
    }
    scene->textures = array;
    scene->texture_count++;
    return true;
}

const Sdf *scene_add_sdf(Scene *scene, const Sdf *sdf, Error *error) {
    size_t size = sdf_size(sdf->node_count);
    Sdf *copy = scene_arena_allocate((SceneArena *)scene, size, error);
    return copy ? memcpy(copy, sdf, size) : NULL;
}

bool scene_add_note(Scene *scene, const char *note, Error *error) {
    SceneArena *arena = (SceneArena *)scene;
    void *array = scene->notes;
    const char *copy = scene_arena_copy_string(arena, note, error);
    const char **slot = copy ? scene_arena_append(arena, &array, &arena->note_capacity,
                                                  scene->note_count, sizeof *slot, error)
                             : NULL;
    if (slot) {
        *slot = copy;
        scene->notes = array;
        scene->note_count++;
    }
    return slot != NULL;
}

bool scene_set_last_transform(Scene *scene, const Transform *transform, Error *error) {
    Transform *copy = scene_arena_allocate((SceneArena *)scene, sizeof *copy, error);
    if (copy) {
        *copy = *transform;
        scene->shapes[scene->shape_count - 1].transform = copy;
    }
    return copy != NULL;
}

/* --- translation ------------------------------------------------------------------------------ */

/**
 * Copies an array into the block.
 * @param[out] capacity  Capacity of the copy.
 * @return The copy; NULL if the block is full.
 */
static void *scene_arena_copy(SceneArena *arena, const void *array, size_t count, size_t size,
                              size_t *capacity, Error *error) {
    void *copy = scene_arena_allocate(arena, count * size, error);
    *capacity = count;
    return copy && count ? memcpy(copy, array, count * size) : copy;
}

/**
 * Copies lights, materials and textures.
 * @param arena  The block of the copy.
 * @return false without memory.
 */
static bool scene_copy_arrays(SceneArena *arena, const Scene *scene, Error *error) {
    Scene *copy = &arena->scene;
    copy->lights = scene_arena_copy(arena, scene->lights, scene->light_count, sizeof *copy->lights,
                                    &arena->light_capacity, error);
    copy->materials = scene_arena_copy(arena, scene->materials, scene->material_count,
                                       sizeof *copy->materials, &arena->material_capacity, error);
    copy->textures = scene_arena_copy(arena, scene->textures, scene->texture_count,
                                      sizeof *copy->textures, &arena->texture_capacity, error);
    if (!copy->lights || !copy->materials || !copy->textures) {
        return false;
    }
    copy->texture_count = scene->texture_count;
    for (size_t i = 0; i < copy->texture_count; i++) {
        texture_retain(copy->textures[i].texture);
    }
    return true;
}

/**
 * Copies the meshes twice: as they are, and as empty entries for translated ones.
 * @param arena  The block of the copy.
 * @return false without memory.
 */
static bool scene_copy_meshes(SceneArena *arena, const Scene *scene, Error *error) {
    size_t count = scene->mesh_count;
    arena->mesh_capacity = 2 * count;
    SceneMesh *meshes = scene_arena_allocate(arena, 2 * count * sizeof *meshes, error);
    for (size_t i = 0; meshes && i < count; i++) {
        SceneFile file = scene->meshes[i].file;
        meshes[i] = (SceneMesh){.file = file, .mesh = mesh_retain(scene->meshes[i].mesh)};
        meshes[count + i] = (SceneMesh){.file = file};
    }
    arena->scene.meshes = meshes;
    arena->scene.mesh_count = meshes ? 2 * count : 0;
    return meshes != NULL;
}

/**
 * Translates the mesh of a shape, at its first use.
 * @param[in,out] index  Index of the mesh; afterwards that of the translated one.
 * @return false without memory.
 */
static bool scene_translate_mesh(Scene *scene, size_t *index, Vec3d offset, Error *error) {
    const Mesh *mesh = scene->meshes[*index].mesh;
    *index += scene->mesh_count / 2;
    SceneMesh *moved = &scene->meshes[*index];
    if (!moved->mesh) {
        moved->mesh = mesh_translated(mesh, offset, error);
    }
    return moved->mesh != NULL;
}

/** Replaces the field of a shape by a translated copy. @return false without memory. */
static bool scene_translate_sdf(Scene *scene, const Sdf **sdf, Vec3d offset, Error *error) {
    Sdf *moved = scene_arena_allocate((SceneArena *)scene, sdf_size(2 * (*sdf)->node_count), error);
    if (moved) {
        sdf_translate(moved, *sdf, offset);
        *sdf = moved;
    }
    return moved != NULL;
}

/** Translates the points, the mesh or the field of a shape. @return false without memory. */
static bool scene_translate_shape(Scene *scene, const Keyword *keyword, void *values, Vec3d offset,
                                  Error *error) {
    bool is_moved = true;
    keyword_translate(keyword, values, offset);
    for (const Parameter *row = keyword->parameters; row->name && is_moved; row++) {
        void *value = (char *)values + row->offset;
        if (row->type == PARAMETER_MESH) {
            is_moved = scene_translate_mesh(scene, value, offset, error);
        } else if (row->type == PARAMETER_SDF) {
            is_moved = scene_translate_sdf(scene, value, offset, error);
        }
    }
    return is_moved;
}

/** Adds a translated shape. Of a transformed shape only the transform changes: its local space
 * stays.
 *  @return false without memory. */
static bool scene_add_translated(Scene *scene, const SceneShape *shape, Vec3d offset,
                                 Error *error) {
    const Keyword *keyword = scene_shape_keywords[shape->class_index];
    if (!scene_add_shape(scene, shape->class_index, keyword, shape->parameters,
                         shape->material_index, error)) {
        return false;
    }
    if (shape->transform) {
        Transform transform = *shape->transform;
        keyword_translate(&transform_keyword, &transform, offset);
        return scene_set_last_transform(scene, &transform, error);
    }
    void *values = (void *)scene->shapes[scene->shape_count - 1].parameters;
    return scene_translate_shape(scene, keyword, values, offset, error);
}

Scene *scene_translated(const Scene *scene, Vec3d offset, Error *error) {
    SceneArena *arena = scene_arena_create(NULL, error);
    if (!arena) {
        return NULL;
    }
    Scene *moved = &arena->scene;
    *moved = *scene;
    moved->shape_count = moved->mesh_count = moved->texture_count = 0;
    bool is_made = scene_copy_arrays(arena, scene, error) && scene_copy_meshes(arena, scene, error);
    for (size_t i = 0; i < scene->shape_count && is_made; i++) {
        is_made = scene_add_translated(moved, &scene->shapes[i], offset, error);
    }
    if (!is_made) {
        scene_destroy(moved);
        return NULL;
    }
    keyword_translate(&scene_camera_keyword, &moved->camera, offset);
    for (size_t i = 0; i < moved->light_count; i++) {
        keyword_translate(scene_light_keyword_for(&moved->lights[i]), &moved->lights[i], offset);
    }
    return moved;
}

/** @return Whether the material of any shape has a property. */
static bool scene_has_material(const Scene *scene, bool (*predicate)(const SceneMaterial *)) {
    for (size_t i = 0; i < scene->shape_count; i++) {
        if (predicate(&scene->materials[scene->shapes[i].material_index])) {
            return true;
        }
    }
    return false;
}

bool scene_has_textures(const Scene *scene) {
    for (size_t i = 0; i < scene->shape_count; i++) {
        if (scene->materials[scene->shapes[i].material_index].texture_id > 0) {
            return true;
        }
    }
    return false;
}

bool scene_has_reflection(const Scene *scene) {
    return scene_has_material(scene, scene_material_is_reflective);
}

bool scene_has_transparency(const Scene *scene) {
    return scene_has_material(scene, scene_material_is_transparent);
}

bool scene_has_secondary_rays(const Scene *scene) {
    return scene_has_material(scene, scene_material_is_secondary);
}
