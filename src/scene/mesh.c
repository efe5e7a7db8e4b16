/**
 * @file
 * @brief Meshes: their memory, their checks, and smooth normals.
 */
#include "dioptre/mesh.h"

#include "dioptre/parameter.h"

#include <string.h>
#include <sys/mman.h>

/** Tolerance of the squared length of a unit normal. */
#define UNIT_TOLERANCE 1e-9
/** Shortest sum of weighted unit normals, angles in radians, that has a direction. */
#define NORMAL_SUM_MINIMUM 1e-9

size_t mesh_block_size(const Mesh *counts) {
    size_t arrays = 1u + (counts->normal_count > 0) + (counts->uv_count > 0);
    return sizeof(Mesh) + counts->position_count * sizeof(Vec3d) +
           counts->normal_count * sizeof(Vec3d) + counts->uv_count * sizeof(MeshUv) +
           arrays * counts->triangle_count * sizeof(MeshTriangle);
}

void mesh_bind_arrays(Mesh *mesh) {
    mesh->positions = (Vec3d *)(mesh + 1);
    mesh->normals = mesh->positions + mesh->position_count;
    mesh->uvs = (MeshUv *)(mesh->normals + mesh->normal_count);
    mesh->triangles = (MeshTriangle *)(mesh->uvs + mesh->uv_count);
    MeshTriangle *next = mesh->triangles + mesh->triangle_count;
    mesh->triangle_normals = mesh->normal_count > 0 ? next : NULL;
    next += mesh->normal_count > 0 ? mesh->triangle_count : 0;
    mesh->triangle_uvs = mesh->uv_count > 0 ? next : NULL;
}

Mesh *mesh_create(const Mesh *counts, Error *error) {
    Mesh *mesh = mmap(NULL, mesh_block_size(counts), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (mesh == MAP_FAILED) {
        error_set(error, STATUS_FAILED, "no memory for a mesh");
        return NULL;
    }
    mesh->position_count = counts->position_count;
    mesh->normal_count = counts->normal_count;
    mesh->uv_count = counts->uv_count;
    mesh->triangle_count = counts->triangle_count;
    atomic_init(&mesh->reference_count, 1);
    mesh_bind_arrays(mesh);
    return mesh;
}

Mesh *mesh_translated(const Mesh *mesh, Vec3d offset, Error *error) {
    Mesh *moved = mesh_create(mesh, error);
    if (moved) {
        memcpy(moved + 1, mesh + 1, mesh_block_size(mesh) - sizeof *mesh);
        moved->repairs = mesh->repairs;
        for (size_t i = 0; i < moved->position_count; i++) {
            moved->positions[i] = vec3d_add(mesh->positions[i], offset);
        }
        mesh_update_bounds(moved);
    }
    return moved;
}

Mesh *mesh_retain(Mesh *mesh) {
    if (mesh) {
        atomic_fetch_add(&mesh->reference_count, 1);
    }
    return mesh;
}

void mesh_release(Mesh *mesh) {
    if (mesh && atomic_fetch_sub(&mesh->reference_count, 1) == 1) {
        munmap(mesh, mesh_block_size(mesh));
    }
}

void mesh_update_bounds(Mesh *mesh) {
    mesh->bounds = aabbd_empty();
    for (size_t i = 0; i < mesh->position_count; i++) {
        mesh->bounds = aabbd_add_point(mesh->bounds, mesh->positions[i]);
    }
}

/** @return Whether a number is finite and not too large for the engines. */
static bool is_valid_coordinate(double x) {
    return fabs(x) <= LENGTH_MAXIMUM; // False for NaN.
}

/** Checks positions, normals and (u, v). @return Whether all are valid. */
static bool check_values(const Mesh *mesh, Error *error) {
    for (size_t i = 0; i < mesh->position_count; i++) {
        Vec3d p = mesh->positions[i];
        if (!is_valid_coordinate(p.x) || !is_valid_coordinate(p.y) || !is_valid_coordinate(p.z)) {
            return error_set(error, STATUS_SCENE, "position %zu is not finite or too far", i);
        }
    }
    for (size_t i = 0; i < mesh->normal_count; i++) {
        Vec3d n = mesh->normals[i];
        if (!(fabs(vec3d_dot(n, n) - 1) <= UNIT_TOLERANCE)) {
            return error_set(error, STATUS_SCENE, "normal %zu is not of unit length", i);
        }
    }
    for (size_t i = 0; i < mesh->uv_count; i++) {
        if (!is_valid_coordinate(mesh->uvs[i].u) || !is_valid_coordinate(mesh->uvs[i].v)) {
            return error_set(error, STATUS_SCENE, "(u, v) %zu is not finite or too far", i);
        }
    }
    return true;
}

/**
 * Checks indices.
 * @param triangles  The indices, or NULL.
 * @param end        Size of the indexed array.
 * @return Whether all are in range.
 */
static bool check_indices(const MeshTriangle *triangles, size_t count, size_t end, Error *error) {
    for (size_t i = 0; triangles && i < count; i++) {
        const uint32_t *index = triangles[i].index;
        if (index[0] >= end || index[1] >= end || index[2] >= end) {
            return error_set(error, STATUS_SCENE, "triangle %zu names what is not there", i);
        }
    }
    return true;
}

bool mesh_validate(const Mesh *mesh, Error *error) {
    if (mesh->triangle_count == 0) {
        return error_set(error, STATUS_SCENE, "there is no triangle in it");
    }
    size_t count = mesh->triangle_count;
    return check_values(mesh, error) &&
           check_indices(mesh->triangles, count, mesh->position_count, error) &&
           check_indices(mesh->triangle_normals, count, mesh->normal_count, error) &&
           check_indices(mesh->triangle_uvs, count, mesh->uv_count, error);
}

/** Geometry of a triangle. */
typedef struct TriangleGeometry {
    Vec3d edges[3]; /**< From each vertex to the next. */
    Vec3d normal;   /**< Unit normal. */
} TriangleGeometry;

/** Computes the edges and the normal of a triangle. @return false if its area is zero. */
static bool triangle_geometry_init(const Mesh *mesh, const MeshTriangle *triangle,
                                   TriangleGeometry *geometry) {
    for (int i = 0; i < 3; i++) {
        Vec3d from = mesh->positions[triangle->index[i]];
        Vec3d to = mesh->positions[triangle->index[(i + 1) % 3]];
        geometry->edges[i] = vec3d_subtract(to, from);
    }
    Vec3d normal = vec3d_cross(geometry->edges[0], geometry->edges[1]);
    if (!vec3d_has_direction(normal)) {
        return false;
    }
    geometry->normal = vec3d_normalize(normal);
    return true;
}

/** @return The weight of a triangle at a vertex: its angle there, radians (Thürmer and Wüthrich,
 *  *Computing Vertex Normals from Polygonal Facets*, 1998). The arc tangent is as exact for very
 *  acute and very obtuse angles. */
static double triangle_geometry_angle(const TriangleGeometry *geometry, int corner) {
    Vec3d outgoing = geometry->edges[corner], incoming = geometry->edges[(corner + 2) % 3];
    Vec3d incoming_reversed = vec3d_scale(incoming, -1);
    return atan2(vec3d_length(vec3d_cross(outgoing, incoming_reversed)),
                 vec3d_dot(outgoing, incoming_reversed));
}

/**
 * Normalises sums of normals; where a sum is zero, the position gets the normal of a triangle.
 * @param mesh             The mesh.
 * @param[in,out] normals  The sums.
 */
static void normalize_all(const Mesh *mesh, Vec3d *normals) {
    for (size_t i = 0; i < mesh->position_count; i++) {
        bool is_long = vec3d_length(normals[i]) > NORMAL_SUM_MINIMUM;
        normals[i] = is_long ? vec3d_normalize(normals[i]) : (Vec3d){0};
    }
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        TriangleGeometry geometry;
        for (int k = 0; k < 3; k++) {
            Vec3d *normal = &normals[mesh->triangles[i].index[k]];
            bool is_missing = !(vec3d_length(*normal) > 0);
            if (is_missing && triangle_geometry_init(mesh, &mesh->triangles[i], &geometry)) {
                *normal = geometry.normal;
            }
        }
    }
    for (size_t i = 0; i < mesh->position_count; i++) {
        bool is_missing = !(vec3d_length(normals[i]) > 0);
        normals[i] = is_missing ? (Vec3d){0, 1, 0} : normals[i];
    }
}

void mesh_smooth_normals(const Mesh *mesh, Vec3d *normals) {
    memset(normals, 0, mesh->position_count * sizeof *normals);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        TriangleGeometry geometry;
        const MeshTriangle *triangle = &mesh->triangles[i];
        if (!triangle_geometry_init(mesh, triangle, &geometry)) {
            continue;
        }
        for (int k = 0; k < 3; k++) {
            Vec3d weighted = vec3d_scale(geometry.normal, triangle_geometry_angle(&geometry, k));
            Vec3d *sum = &normals[triangle->index[k]];
            *sum = vec3d_add(*sum, weighted);
        }
    }
    normalize_all(mesh, normals);
}
