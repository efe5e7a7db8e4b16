/**
 * @file
 * @brief Checks of a scene that another process has made.
 */
#include "base/untrusted.h"
#include "base/utf8.h"
#include "dioptre/sdf_tape.h"
#include "scene/scene_arena.h"

#include <limits.h>
#include <stdalign.h>
#include <stdlib.h>
#include <string.h>

/** Alignment of all that lies in a block: that of #scene_arena_allocate. */
enum { GRANULE = alignof(max_align_t) };

/** A block being checked. */
typedef struct BlockCheck {
    const char *start;              /**< The block. */
    size_t used;                    /**< Its bytes in use. */
    const Scene *scene;             /**< The scene at its start. */
    const Keyword *const *keywords; /**< Keywords of the classes of shapes; NULL ends them. */
    size_t keyword_count;           /**< Number of #keywords. */
    unsigned char *claims;          /**< A bit for each granule: it has an owner. */
} BlockCheck;

/** @return Whether an object of some bytes, at least 1, lies in the block, aligned. */
static bool is_placed(const BlockCheck *check, const void *pointer, size_t size) {
    return untrusted_lies_in(check->start, check->used, pointer, size) &&
           ((uintptr_t)pointer - (uintptr_t)check->start) % GRANULE == 0;
}

/**
 * Claims memory of the block for one owner.
 * @param pointer  Its address.
 * @param count    Number of items.
 * @param size     Bytes of an item, at least 1.
 * @return false if it is not aligned, not in the block, or has an owner.
 */
static bool claim(BlockCheck *check, const void *pointer, size_t count, size_t size) {
    if (count == 0) {
        return true;
    }
    if (count > check->used / size || !is_placed(check, pointer, count * size)) {
        return false;
    }
    size_t start = (size_t)((uintptr_t)pointer - (uintptr_t)check->start);
    size_t last = (start + count * size - 1) / GRANULE;
    for (size_t granule = start / GRANULE; granule <= last; granule++) {
        unsigned char *byte = &check->claims[granule / CHAR_BIT];
        unsigned bit = 1u << granule % CHAR_BIT;
        if (*byte & bit) {
            return false;
        }
        *byte = (unsigned char)(*byte | bit);
    }
    return true;
}

/** Claims a string. @return false if it is not in the block, does not end, or has an owner. */
static bool claim_string(BlockCheck *check, const char *string) {
    if (!untrusted_lies_in(check->start, check->used, string, 1)) {
        return false;
    }
    size_t start = (size_t)((uintptr_t)string - (uintptr_t)check->start);
    const char *end = memchr(string, '\0', check->used - start);
    return end && claim(check, string, (size_t)(end - string) + 1, 1);
}

/** Claims a string that is printed. @return false as #claim_string, or if it holds a control. */
static bool claim_printed(BlockCheck *check, const char *string) {
    return claim_string(check, string) && utf8_is_printable(string);
}

/** @return Whether all of some numbers are finite. */
static bool check_finite(const double *numbers, size_t count) {
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            return false;
        }
    }
    return true;
}

/** Claims the field of a row, if there is one. @return Whether it is valid. */
static bool check_field(BlockCheck *check, const void *value) {
    const Sdf *field;
    memcpy(&field, value, sizeof field);
    return is_placed(check, field, sizeof *field) && field->node_count >= 1 &&
           field->node_count <= SDF_NODES_MAXIMUM &&
           claim(check, field, 1, sdf_size(field->node_count)) && sdf_check(field);
}

/** @return Whether the origin of a thing is valid. */
static bool check_origin(const SceneOrigin *origin) {
    return origin->number >= 0 && origin->line >= 0;
}

/** @return Number of words of a choice. */
static int choice_count(const Parameter *row) {
    int count = 0;
    while (row->choices[count]) {
        count++;
    }
    return count;
}

/** @return Number of doubles of a row; 0: it has none. */
static size_t number_count(ParameterType type) {
    static const size_t counts[] = {
        [PARAMETER_NUMBER] = 1,    [PARAMETER_POINT] = 3, [PARAMETER_VECTOR] = 3,
        [PARAMETER_DIRECTION] = 3, [PARAMETER_SCALE] = 3, [PARAMETER_UV] = 2,
        [PARAMETER_COLOR] = 3};
    return type < sizeof counts / sizeof *counts ? counts[type] : 0;
}

/** @return Whether the numbers of a row are in its range. */
static bool check_numbers(const Parameter *row, const char *value) {
    double sum = 0;
    for (size_t i = 0; i < number_count(row->type); i++) {
        double number;
        memcpy(&number, value + i * sizeof number, sizeof number);
        if (!parameter_check_range(row, number, NULL)) {
            return false;
        }
        sum += fabs(number);
    }
    return row->type != PARAMETER_DIRECTION || sum > 0;
}

/** @return Whether an integer, a flag, an index or a field is valid. */
static bool check_discrete(BlockCheck *check, const Parameter *row, const char *value) {
    int integer;
    size_t index;
    switch (row->type) {
    case PARAMETER_INTEGER:
        memcpy(&integer, value, sizeof integer);
        return integer >= row->minimum && integer <= row->maximum;
    case PARAMETER_CHOICE:
        memcpy(&integer, value, sizeof integer);
        return integer >= 0 && integer < choice_count(row);
    case PARAMETER_MESH:
        memcpy(&index, value, sizeof index);
        return index < check->scene->mesh_count;
    case PARAMETER_TEXTURE:
        memcpy(&index, value, sizeof index);
        return index <= check->scene->texture_count;
    case PARAMETER_BOOLEAN:
        return untrusted_is_bool(value);
    case PARAMETER_SDF:
        return check_field(check, value);
    default:
        return true;
    }
}

/** @return Bytes of the value of a row that may have its default outside of its range. */
static size_t plain_size(ParameterType type) {
    return type == PARAMETER_INTEGER ? sizeof(int) : number_count(type) * sizeof(double);
}

/** @return Whether the struct of a keyword is valid. */
static bool check_values(BlockCheck *check, const Keyword *keyword, const void *values) {
    for (const Parameter *row = keyword->parameters; row->name; row++) {
        const char *value = (const char *)values + row->offset;
        size_t size = plain_size(row->type);
        bool is_default =
            size > 0 && memcmp(value, (const char *)keyword->defaults + row->offset, size) == 0;
        if (!is_default && (!check_numbers(row, value) || !check_discrete(check, row, value))) {
            return false;
        }
    }
    return true;
}

/** @return Whether a transform is NULL or valid. */
static bool check_transform(BlockCheck *check, const Transform *transform) {
    return !transform || (claim(check, transform, 1, sizeof *transform) &&
                          check_values(check, &transform_keyword, transform) &&
                          check_finite(&transform->matrix[0][0],
                                       sizeof transform->matrix / sizeof transform->matrix[0][0]));
}

/** @return Whether the shapes are valid. */
static bool check_shapes(BlockCheck *check) {
    const Scene *scene = check->scene;
    bool is_valid = claim(check, scene->shapes, scene->shape_count, sizeof *scene->shapes);
    for (size_t i = 0; i < scene->shape_count && is_valid; i++) {
        const SceneShape *shape = &scene->shapes[i];
        const Keyword *keyword =
            shape->class_index < check->keyword_count ? check->keywords[shape->class_index] : NULL;
        is_valid = keyword && shape->material_index < scene->material_count &&
                   check_origin(&shape->origin) &&
                   claim(check, shape->parameters, 1, keyword->size) &&
                   check_values(check, keyword, shape->parameters) &&
                   check_transform(check, shape->transform);
    }
    return is_valid;
}

/** @return Whether a light is valid. */
static bool check_light(BlockCheck *check, const SceneLight *light) {
    size_t class_count = 0;
    while (scene_light_classes[class_count]) {
        class_count++;
    }
    return light->class_index < class_count && light->falloff >= FALLOFF_NONE &&
           light->falloff <= FALLOFF_INVERSE_LINEAR && isfinite(light->intensity) &&
           isfinite(light->falloff_constant) && isfinite(light->radius) &&
           check_finite(light->own, SCENE_LIGHT_OWN_DOUBLES) &&
           check_finite(&light->position.x, 3) && check_finite(&light->direction.x, 3) &&
           check_finite(&light->color.red, 3) && check_origin(&light->origin) &&
           check_values(check, scene_light_keyword_for(light), light);
}

/** @return Whether lights and materials are valid. */
static bool check_lights_and_materials(BlockCheck *check) {
    const Scene *scene = check->scene;
    bool is_valid = scene->material_count >= 1 &&
                    claim(check, scene->lights, scene->light_count, sizeof *scene->lights) &&
                    claim(check, scene->materials, scene->material_count, sizeof *scene->materials);
    for (size_t i = 0; i < scene->light_count && is_valid; i++) {
        is_valid = check_light(check, &scene->lights[i]);
    }
    for (size_t i = 0; i < scene->material_count && is_valid; i++) {
        is_valid = check_origin(&scene->materials[i].origin) &&
                   check_values(check, &scene_material_keyword, &scene->materials[i]);
    }
    return is_valid;
}

/** @return Whether the strings of a file are valid. */
static bool check_file(BlockCheck *check, const SceneFile *file) {
    return claim_string(check, file->path) && claim_string(check, file->name) &&
           claim_printed(check, file->location);
}

/**
 * Checks a mesh in the block, and sets the pointers of its arrays.
 * @return Whether its counts agree with the block and its numbers are valid.
 */
static bool check_built_mesh(BlockCheck *check, const Mesh *built) {
    Mesh *mesh = (Mesh *)(uintptr_t)built;
    bool has_head = is_placed(check, mesh, sizeof *mesh) && mesh->position_count <= UINT32_MAX &&
                    mesh->normal_count <= UINT32_MAX && mesh->uv_count <= UINT32_MAX &&
                    mesh->triangle_count <= UINT32_MAX;
    if (!has_head || !claim(check, mesh, 1, mesh_block_size(mesh))) {
        return false;
    }
    mesh_bind_arrays(mesh);
    return mesh_validate(mesh, NULL);
}

/** @return Whether meshes, textures and notes are valid; none of their files is read yet. */
static bool check_files(BlockCheck *check) {
    const Scene *scene = check->scene;
    bool is_valid = claim(check, scene->meshes, scene->mesh_count, sizeof *scene->meshes) &&
                    claim(check, scene->textures, scene->texture_count, sizeof *scene->textures) &&
                    claim(check, scene->notes, scene->note_count, sizeof *scene->notes);
    for (size_t i = 0; i < scene->mesh_count && is_valid; i++) {
        const SceneMesh *mesh = &scene->meshes[i];
        is_valid = !mesh->mesh && check_file(check, &mesh->file) &&
                   (!mesh->built || check_built_mesh(check, mesh->built));
    }
    for (size_t i = 0; i < scene->texture_count && is_valid; i++) {
        is_valid = !scene->textures[i].texture && check_file(check, &scene->textures[i].file);
    }
    for (size_t i = 0; i < scene->note_count && is_valid; i++) {
        is_valid = claim_printed(check, scene->notes[i]);
    }
    return is_valid;
}

/** @return Whether the parts of the scene that are no arrays are valid. */
static bool check_head(BlockCheck *check) {
    const Scene *scene = check->scene;
    return untrusted_is_bool(&scene->has_camera) && scene->has_camera &&
           untrusted_is_bool(&scene->is_time_dependent) &&
           check_values(check, &scene_camera_keyword, &scene->camera) &&
           isfinite(scene->camera.target_distance) &&
           check_values(check, &scene_image_keyword, &scene->image) &&
           check_values(check, &scene_sky_keyword, &scene->sky) &&
           check_finite(&scene->ambient.red, 3);
}

/** Removes all that a scene that is not valid seems to own. */
static void disown(Scene *scene) {
    scene->mesh_count = 0;
    scene->texture_count = 0;
}

bool scene_validate(Scene *scene, size_t size, const Keyword *const *keywords, Error *error) {
    SceneArena *arena = (SceneArena *)scene;
    BlockCheck check = {.start = (const char *)scene, .scene = scene, .keywords = keywords};
    bool has_size = size >= sizeof *arena && arena->used == size && size <= SCENE_MEMORY_SIZE;
    check.used = has_size ? size : 0;
    check.claims = has_size ? calloc(1, size / GRANULE / CHAR_BIT + 1) : NULL;
    if (has_size && !check.claims) {
        disown(scene);
        return error_set(error, STATUS_FAILED, "no memory for a scene");
    }
    while (keywords[check.keyword_count]) {
        check.keyword_count++;
    }
    bool is_valid = has_size && claim(&check, arena, 1, sizeof *arena) && check_head(&check) &&
                    check_lights_and_materials(&check) && check_shapes(&check) &&
                    check_files(&check);
    free(check.claims);
    arena->light_capacity = scene->light_count;
    arena->material_capacity = scene->material_count;
    arena->shape_capacity = scene->shape_count;
    arena->mesh_capacity = scene->mesh_count;
    arena->texture_capacity = scene->texture_count;
    arena->note_capacity = scene->note_count;
    if (!is_valid) {
        disown(scene);
    }
    return is_valid || error_set(error, STATUS_SCENE, "the scene is damaged");
}
