/**
 * @file
 * @brief Makes a mesh of triangles that come one by one.
 */
#include "assets/mesh_builder.h"

#include "dioptre/language.h"
#include "dioptre/parameter.h"

#include <stdlib.h>
#include <string.h>

/** Triangles that fit at first. */
enum { FIRST_CAPACITY = 1024 };
/** A triangle none of whose corners has a place. */
#define NOWHERE ((MeshTriangle){{POOL_NOWHERE, POOL_NOWHERE, POOL_NOWHERE}})

void mesh_builder_init(MeshBuilder *builder, Error *error) {
    *builder = (MeshBuilder){
        .positions = {.width = 3}, .normals = {.width = 3}, .uvs = {.width = 2}, .error = error};
}

void mesh_builder_release(MeshBuilder *builder) {
    pool_release(&builder->positions);
    pool_release(&builder->normals);
    pool_release(&builder->uvs);
    free(builder->triangles);
    free(builder->normal_at);
    free(builder->uv_at);
    *builder = (MeshBuilder){0};
}

/** Says that there is no memory. @param builder The builder. @return false, always. */
static bool fail_memory(MeshBuilder *builder) {
    return error_set(builder->error, STATUS_SCENE, "it needs more memory than a model may take");
}

/** @return Whether numbers are finite and not too large. @param numbers They. @param count How
 * many.
 */
static bool are_sane(const double *numbers, int count) {
    for (int i = 0; i < count; i++) {
        if (!(fabs(numbers[i]) <= LENGTH_MAXIMUM)) {
            return false;
        }
    }
    return true;
}

/** @return Three numbers as a vector. @param numbers They. */
static Vector3 vector_of(const double numbers[3]) {
    return (Vector3){numbers[0], numbers[1], numbers[2]};
}

/**
 * @return A vector at right angles to a triangle, of twice its area. Exactly zero where the corners
 *         lie on a line and are floats of like size: their differences and products fit a double.
 * @param a  A corner.
 * @param b  Another.
 * @param c  The third.
 */
static Vector3 area_of(Vector3 a, Vector3 b, Vector3 c) {
    return vector3_cross(vector3_subtract(b, a), vector3_subtract(c, a));
}

/**
 * Makes an array of triangles longer.
 * @param array     The array.
 * @param capacity  How many shall fit.
 * @return false without memory.
 */
static bool lengthen(MeshTriangle **array, size_t capacity) {
    MeshTriangle *longer = realloc(*array, capacity * sizeof *longer);
    if (longer) {
        *array = longer;
    }
    return longer != NULL;
}

/** Makes room for one more triangle. @param builder The builder. @return false without memory. */
static bool grow(MeshBuilder *builder) {
    if (builder->count < builder->capacity) {
        return true;
    }
    size_t capacity = builder->capacity ? 2 * builder->capacity : FIRST_CAPACITY;
    if (!lengthen(&builder->triangles, capacity) || !lengthen(&builder->normal_at, capacity) ||
        !lengthen(&builder->uv_at, capacity)) {
        return false;
    }
    builder->capacity = capacity;
    return true;
}

/**
 * Adds a corner's normal, if it has one that says a direction.
 * @param builder     The builder.
 * @param corner      The corner.
 * @param[out] place  Its place; untouched where there is none.
 * @return false without memory.
 */
static bool add_normal(MeshBuilder *builder, const MeshesCorner *corner, uint32_t *place) {
    builder->has_normals |= corner->has_normal;
    Vector3 normal = vector_of(corner->normal);
    if (!corner->has_normal || !are_sane(corner->normal, 3) || !(vector3_length(normal) > 0)) {
        return true;
    }
    normal = vector3_normalize(normal);
    return pool_add(&builder->normals, (const double[]){normal.x, normal.y, normal.z}, place);
}

/**
 * Adds a corner's (u, v), if it has one.
 * @param builder     The builder.
 * @param corner      The corner.
 * @param[out] place  Its place; untouched where there is none.
 * @return false without memory.
 */
static bool add_uv(MeshBuilder *builder, const MeshesCorner *corner, uint32_t *place) {
    builder->has_uvs |= corner->has_uv;
    return !corner->has_uv || !are_sane(corner->uv, 2) ||
           pool_add(&builder->uvs, corner->uv, place);
}

/**
 * Adds a triangle that has an area.
 * @param builder  The builder.
 * @param corners  Its corners.
 * @return false without memory.
 */
static bool append(MeshBuilder *builder, const MeshesCorner corners[3]) {
    MeshTriangle at, normal_at = NOWHERE, uv_at = NOWHERE;
    bool is_added = grow(builder);
    for (int k = 0; is_added && k < 3; k++) {
        is_added = pool_add(&builder->positions, corners[k].position, &at.at[k]) &&
                   add_normal(builder, &corners[k], &normal_at.at[k]) &&
                   add_uv(builder, &corners[k], &uv_at.at[k]);
    }
    if (!is_added) {
        return fail_memory(builder);
    }
    builder->triangles[builder->count] = at;
    builder->normal_at[builder->count] = normal_at;
    builder->uv_at[builder->count] = uv_at;
    builder->count++;
    return true;
}

bool mesh_builder_add(void *context, const MeshesCorner corners[3]) {
    MeshBuilder *builder = context;
    for (int k = 0; k < 3; k++) {
        const double *at = corners[k].position;
        if (!are_sane(at, 3)) {
            return error_set(builder->error, STATUS_SCENE,
                             "a vertex lies at (%g, %g, %g): coordinates must be finite and at "
                             "most %g",
                             at[0], at[1], at[2], LENGTH_MAXIMUM);
        }
    }
    Vector3 area = area_of(vector_of(corners[0].position), vector_of(corners[1].position),
                           vector_of(corners[2].position));
    if (!(vector3_length(area) > 0)) {
        builder->repairs.degenerate++;
        return true;
    }
    return append(builder, corners);
}

/** @return A position. @param builder The builder. @param place Its place. */
static Vector3 position_at(const MeshBuilder *builder, uint32_t place) {
    return vector_of(builder->positions.points + builder->positions.width * place);
}

/**
 * Puts a triangle's own normal where a corner lacks one.
 * @param builder  The builder.
 * @param i        The triangle.
 * @return false without memory.
 */
static bool complete_normals(MeshBuilder *builder, size_t i) {
    const uint32_t *at = builder->triangles[i].at;
    Vector3 area = area_of(position_at(builder, at[0]), position_at(builder, at[1]),
                           position_at(builder, at[2]));
    Vector3 normal = vector3_normalize(area);
    const double numbers[] = {normal.x, normal.y, normal.z};
    for (int k = 0; k < 3; k++) {
        uint32_t *place = &builder->normal_at[i].at[k];
        if (*place == POOL_NOWHERE && !pool_add(&builder->normals, numbers, place)) {
            return false;
        }
    }
    return true;
}

/**
 * Puts (0, 0) where a corner lacks a (u, v).
 * @param builder  The builder.
 * @param i        The triangle.
 * @return false without memory.
 */
static bool complete_uvs(MeshBuilder *builder, size_t i) {
    for (int k = 0; k < 3; k++) {
        uint32_t *place = &builder->uv_at[i].at[k];
        if (*place == POOL_NOWHERE && !pool_add(&builder->uvs, (const double[]){0, 0}, place)) {
            return false;
        }
    }
    return true;
}

/**
 * @return How many corners have no place.
 * @param triangles  Their triangles.
 * @param count      How many triangles.
 */
static size_t count_nowhere(const MeshTriangle *triangles, size_t count) {
    size_t missing = 0;
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++) {
            missing += triangles[i].at[k] == POOL_NOWHERE;
        }
    }
    return missing;
}

/** Puts in what corners lack and others have. @param builder The builder. @return false without
 *  memory. */
static bool complete(MeshBuilder *builder) {
    MeshRepairs *repairs = &builder->repairs;
    size_t count = builder->count;
    repairs->lost_normals = builder->has_normals ? count_nowhere(builder->normal_at, count) : 0;
    repairs->lost_uvs = builder->has_uvs ? count_nowhere(builder->uv_at, count) : 0;
    bool has_memory = true;
    for (size_t i = 0; has_memory && i < count; i++) {
        has_memory = (builder->normals.count == 0 || complete_normals(builder, i)) &&
                     (builder->uvs.count == 0 || complete_uvs(builder, i));
    }
    return has_memory || fail_memory(builder);
}

bool mesh_builder_finish(MeshBuilder *builder, Mesh *counts) {
    if (builder->count == 0) {
        return error_set(builder->error, STATUS_SCENE,
                         builder->repairs.degenerate
                             ? N_("there is no triangle in it that has an area")
                             : N_("there is no triangle in it"));
    }
    bool is_complete = complete(builder);
    *counts = (Mesh){.position_count = builder->positions.count,
                     .normal_count = builder->normals.count,
                     .uv_count = builder->uvs.count,
                     .triangle_count = builder->count,
                     .repairs = builder->repairs};
    return is_complete;
}

/** Copies triangles. @param[out] to Where to; NULL: nowhere. @param from They. @param count How
 *  many. */
static void copy_triangles(MeshTriangle *to, const MeshTriangle *from, size_t count) {
    if (to) {
        memcpy(to, from, count * sizeof *to);
    }
}

void mesh_builder_copy(const MeshBuilder *builder, Mesh *mesh) {
    const double *p = builder->positions.points, *n = builder->normals.points;
    const double *uv = builder->uvs.points;
    for (size_t i = 0; i < mesh->position_count; i++) {
        mesh->positions[i] = vector_of(p + 3 * i);
    }
    for (size_t i = 0; i < mesh->normal_count; i++) {
        mesh->normals[i] = vector_of(n + 3 * i);
    }
    for (size_t i = 0; i < mesh->uv_count; i++) {
        mesh->uvs[i] = (MeshUv){uv[2 * i], uv[2 * i + 1]};
    }
    copy_triangles(mesh->triangles, builder->triangles, builder->count);
    copy_triangles(mesh->triangle_normals, builder->normal_at, builder->count);
    copy_triangles(mesh->triangle_uvs, builder->uv_at, builder->count);
}
