/**
 * @file
 * @brief Construction of a mesh from single triangles.
 */
#include "assets/meshes/mesh_builder.h"

#include "base/language.h"
#include "dioptre/parameter.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/** First capacity of the arrays of triangles. */
enum { FIRST_CAPACITY = 1024 };
/** Bound of the rounding error of an area, see #has_area. */
#define AREA_NOISE (3 * DBL_EPSILON)
/** A triangle without indices. */
#define NO_INDICES ((MeshTriangle){{VERTEX_WELDER_NONE, VERTEX_WELDER_NONE, VERTEX_WELDER_NONE}})

void mesh_builder_init(MeshBuilder *builder, Error *error) {
    *builder = (MeshBuilder){.positions = {.dimension = 3},
                             .normals = {.dimension = 3},
                             .uvs = {.dimension = 2},
                             .error = error};
}

void mesh_builder_deinit(MeshBuilder *builder) {
    vertex_welder_deinit(&builder->positions);
    vertex_welder_deinit(&builder->normals);
    vertex_welder_deinit(&builder->uvs);
    free(builder->triangles);
    free(builder->triangle_normals);
    free(builder->triangle_uvs);
    *builder = (MeshBuilder){0};
}

/** Sets the error that memory is exhausted. @return false, always. */
static bool set_out_of_memory(MeshBuilder *builder) {
    return error_set(builder->error, STATUS_SCENE, "it needs more memory than a model may take");
}

/** @return Whether numbers are finite and within the range of coordinates. */
static bool are_in_range(const double *numbers, int count) {
    for (int i = 0; i < count; i++) {
        if (!(fabs(numbers[i]) <= LENGTH_MAXIMUM)) {
            return false;
        }
    }
    return true;
}

/** @return Three numbers as a vector. */
static Vec3d vector_from_array(const double numbers[3]) {
    return (Vec3d){numbers[0], numbers[1], numbers[2]};
}

/** @return A vector perpendicular to a triangle, of twice its area as length. */
static Vec3d area_vector(Vec3d a, Vec3d b, Vec3d c) {
    return vec3d_cross(vec3d_subtract(b, a), vec3d_subtract(c, a));
}

/** @return The absolute values of a vector. */
static Vec3d absolute(Vec3d v) {
    return (Vec3d){fabs(v.x), fabs(v.y), fabs(v.z)};
}

/** @return The sizes of the products in a cross product, added instead of subtracted. */
static Vec3d cross_sizes(Vec3d a, Vec3d b) {
    return (Vec3d){a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x};
}

/**
 * @return Whether a triangle has an area above its rounding error, so that its normal is not noise.
 *
 * Corners on a straight line in decimal are seldom so in double. With u = epsilon / 2, a coordinate
 * is off by at most u times its size, and an edge by 2 u of that and u of its own length. The
 * products of edges are at most as large as those of sizes and edges; so a component of the area
 * vector is off by at most 6 u times the latter.
 */
static bool has_area(Vec3d a, Vec3d b, Vec3d c) {
    Vec3d size = vec3d_max(absolute(a), vec3d_max(absolute(b), absolute(c)));
    Vec3d first = absolute(vec3d_subtract(b, a)), second = absolute(vec3d_subtract(c, a));
    Vec3d area = absolute(area_vector(a, b, c));
    Vec3d noise = vec3d_scale(cross_sizes(size, vec3d_add(first, second)), AREA_NOISE);
    return vec3d_has_direction(area) && (area.x > noise.x || area.y > noise.y || area.z > noise.z);
}

/**
 * Changes the capacity of an array of triangles.
 * @param[in,out] array  The array.
 * @param capacity       New capacity.
 * @return false without memory.
 */
static bool resize_triangles(MeshTriangle **array, size_t capacity) {
    MeshTriangle *resized = realloc(*array, capacity * sizeof *resized);
    if (resized) {
        *array = resized;
    }
    return resized != NULL;
}

/** Reserves memory for one more triangle. @return false without memory. */
static bool grow(MeshBuilder *builder) {
    if (builder->count < builder->capacity) {
        return true;
    }
    size_t capacity = builder->capacity ? 2 * builder->capacity : FIRST_CAPACITY;
    if (!resize_triangles(&builder->triangles, capacity) ||
        !resize_triangles(&builder->triangle_normals, capacity) ||
        !resize_triangles(&builder->triangle_uvs, capacity)) {
        return false;
    }
    builder->capacity = capacity;
    return true;
}

/**
 * Adds the normal of a corner, if it has one with a direction.
 * @param builder     The builder.
 * @param corner      The corner.
 * @param[out] index  Index of the normal; unchanged without one.
 * @return false without memory.
 */
static bool add_normal(MeshBuilder *builder, const MeshCorner *corner, uint32_t *index) {
    builder->has_normals |= corner->has_normal;
    Vec3d normal = vector_from_array(corner->normal);
    if (!corner->has_normal || !are_in_range(corner->normal, 3) || !vec3d_has_direction(normal)) {
        return true;
    }
    normal = vec3d_normalize(normal);
    return vertex_welder_add(&builder->normals, (const double[]){normal.x, normal.y, normal.z},
                             index);
}

/**
 * Adds the (u, v) of a corner, if it has valid ones.
 * @param builder     The builder.
 * @param corner      The corner.
 * @param[out] index  Index of the (u, v); unchanged without them.
 * @return false without memory.
 */
static bool add_uv(MeshBuilder *builder, const MeshCorner *corner, uint32_t *index) {
    builder->has_uvs |= corner->has_uv;
    return !corner->has_uv || !are_in_range(corner->uv, 2) ||
           vertex_welder_add(&builder->uvs, corner->uv, index);
}

/** Appends a triangle with an area above zero. @return false without memory. */
static bool append_triangle(MeshBuilder *builder, const MeshCorner corners[3]) {
    MeshTriangle position_indices, normal_indices = NO_INDICES, uv_indices = NO_INDICES;
    bool is_added = grow(builder);
    for (int k = 0; is_added && k < 3; k++) {
        is_added = vertex_welder_add(&builder->positions, corners[k].position,
                                     &position_indices.index[k]) &&
                   add_normal(builder, &corners[k], &normal_indices.index[k]) &&
                   add_uv(builder, &corners[k], &uv_indices.index[k]);
    }
    if (!is_added) {
        return set_out_of_memory(builder);
    }
    builder->triangles[builder->count] = position_indices;
    builder->triangle_normals[builder->count] = normal_indices;
    builder->triangle_uvs[builder->count] = uv_indices;
    builder->count++;
    return true;
}

bool mesh_builder_check(const MeshBuilder *builder, const double position[3]) {
    return are_in_range(position, 3) ||
           error_set(builder->error, STATUS_SCENE,
                     "a vertex lies at (%g, %g, %g): coordinates must be finite and at most %g",
                     position[0], position[1], position[2], LENGTH_MAXIMUM);
}

bool mesh_builder_add(void *context, const MeshCorner corners[3]) {
    MeshBuilder *builder = context;
    for (int k = 0; k < 3; k++) {
        if (!mesh_builder_check(builder, corners[k].position)) {
            return false;
        }
    }
    if (!has_area(vector_from_array(corners[0].position), vector_from_array(corners[1].position),
                  vector_from_array(corners[2].position))) {
        builder->repairs.degenerate_triangles++;
        return true;
    }
    return append_triangle(builder, corners);
}

/** @return A position. */
static Vec3d position_at(const MeshBuilder *builder, uint32_t index) {
    return vector_from_array(builder->positions.points + builder->positions.dimension * index);
}

/** Sets the missing normals of a triangle to its own normal. @return false without memory. */
static bool fill_missing_normals(MeshBuilder *builder, size_t i) {
    const uint32_t *indices = builder->triangles[i].index;
    Vec3d area = area_vector(position_at(builder, indices[0]), position_at(builder, indices[1]),
                             position_at(builder, indices[2]));
    Vec3d normal = vec3d_normalize(area);
    const double numbers[] = {normal.x, normal.y, normal.z};
    for (int k = 0; k < 3; k++) {
        uint32_t *index = &builder->triangle_normals[i].index[k];
        if (*index == VERTEX_WELDER_NONE && !vertex_welder_add(&builder->normals, numbers, index)) {
            return false;
        }
    }
    return true;
}

/** Sets the missing (u, v) of a triangle to (0, 0). @return false without memory. */
static bool fill_missing_uvs(MeshBuilder *builder, size_t i) {
    for (int k = 0; k < 3; k++) {
        uint32_t *index = &builder->triangle_uvs[i].index[k];
        if (*index == VERTEX_WELDER_NONE &&
            !vertex_welder_add(&builder->uvs, (const double[]){0, 0}, index)) {
            return false;
        }
    }
    return true;
}

/** @return Number of corners without an index. */
static size_t count_missing(const MeshTriangle *triangles, size_t count) {
    size_t missing = 0;
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++) {
            missing += triangles[i].index[k] == VERTEX_WELDER_NONE;
        }
    }
    return missing;
}

/** Fills in normals and (u, v) that some corners lack. @return false without memory. */
static bool fill_missing(MeshBuilder *builder) {
    MeshRepairs *repairs = &builder->repairs;
    size_t count = builder->count;
    repairs->missing_normals =
        builder->has_normals ? count_missing(builder->triangle_normals, count) : 0;
    repairs->missing_uvs = builder->has_uvs ? count_missing(builder->triangle_uvs, count) : 0;
    bool has_memory = true;
    for (size_t i = 0; has_memory && i < count; i++) {
        has_memory = (builder->normals.count == 0 || fill_missing_normals(builder, i)) &&
                     (builder->uvs.count == 0 || fill_missing_uvs(builder, i));
    }
    return has_memory || set_out_of_memory(builder);
}

bool mesh_builder_finish(MeshBuilder *builder, Mesh *counts) {
    if (builder->count == 0) {
        return error_set(builder->error, STATUS_SCENE,
                         builder->repairs.degenerate_triangles
                             ? N_("there is no triangle in it that has an area")
                             : N_("there is no triangle in it"));
    }
    bool is_complete = fill_missing(builder);
    *counts = (Mesh){.position_count = builder->positions.count,
                     .normal_count = builder->normals.count,
                     .uv_count = builder->uvs.count,
                     .triangle_count = builder->count,
                     .repairs = builder->repairs};
    return is_complete;
}

/** Copies triangles. @param[out] to The copy; NULL: nothing is copied. */
static void copy_triangles(MeshTriangle *to, const MeshTriangle *from, size_t count) {
    if (to) {
        memcpy(to, from, count * sizeof *to);
    }
}

void mesh_builder_copy(const MeshBuilder *builder, Mesh *mesh) {
    const double *p = builder->positions.points, *n = builder->normals.points;
    const double *uv = builder->uvs.points;
    for (size_t i = 0; i < mesh->position_count; i++) {
        mesh->positions[i] = vector_from_array(p + 3 * i);
    }
    for (size_t i = 0; i < mesh->normal_count; i++) {
        mesh->normals[i] = vector_from_array(n + 3 * i);
    }
    for (size_t i = 0; i < mesh->uv_count; i++) {
        mesh->uvs[i] = (MeshUv){uv[2 * i], uv[2 * i + 1]};
    }
    copy_triangles(mesh->triangles, builder->triangles, builder->count);
    copy_triangles(mesh->triangle_normals, builder->triangle_normals, builder->count);
    copy_triangles(mesh->triangle_uvs, builder->triangle_uvs, builder->count);
}
