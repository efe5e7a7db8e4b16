/**
 * @file
 * @brief Meshes: their memory, their checks, and normals that make them look smooth.
 */
#include "dioptre/mesh.h"

#include "dioptre/parameter.h"

#include <string.h>
#include <sys/mman.h>

/** How far the square of a unit normal's length may be off 1. */
#define UNIT_TOLERANCE 1e-9
/** Shortest sum of weighted unit normals, angles in radians, that still says a direction. */
#define SUM_MINIMUM 1e-9

size_t mesh_size(const Mesh *counts) {
    size_t arrays = 1u + (counts->normal_count > 0) + (counts->uv_count > 0);
    return sizeof(Mesh) + counts->position_count * sizeof(Vector3) +
           counts->normal_count * sizeof(Vector3) + counts->uv_count * sizeof(MeshUv) +
           arrays * counts->triangle_count * sizeof(MeshTriangle);
}

void mesh_lay_out(Mesh *mesh) {
    mesh->positions = (Vector3 *)(mesh + 1);
    mesh->normals = mesh->positions + mesh->position_count;
    mesh->uvs = (MeshUv *)(mesh->normals + mesh->normal_count);
    mesh->triangles = (MeshTriangle *)(mesh->uvs + mesh->uv_count);
    MeshTriangle *next = mesh->triangles + mesh->triangle_count;
    mesh->triangle_normals = mesh->normal_count > 0 ? next : NULL;
    next += mesh->normal_count > 0 ? mesh->triangle_count : 0;
    mesh->triangle_uvs = mesh->uv_count > 0 ? next : NULL;
}

Mesh *mesh_create(const Mesh *counts, Error *error) {
    Mesh *mesh = mmap(NULL, mesh_size(counts), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (mesh == MAP_FAILED) {
        error_set(error, STATUS_FAILED, "no memory for a mesh");
        return NULL;
    }
    mesh->position_count = counts->position_count;
    mesh->normal_count = counts->normal_count;
    mesh->uv_count = counts->uv_count;
    mesh->triangle_count = counts->triangle_count;
    atomic_init(&mesh->owners, 1);
    mesh_lay_out(mesh);
    return mesh;
}

Mesh *mesh_moved(const Mesh *mesh, Vector3 way, Error *error) {
    Mesh *moved = mesh_create(mesh, error);
    if (moved) {
        memcpy(moved + 1, mesh + 1, mesh_size(mesh) - sizeof *mesh);
        moved->repairs = mesh->repairs;
        for (size_t i = 0; i < moved->position_count; i++) {
            moved->positions[i] = vector3_add(mesh->positions[i], way);
        }
    }
    return moved;
}

Mesh *mesh_share(Mesh *mesh) {
    if (mesh) {
        atomic_fetch_add(&mesh->owners, 1);
    }
    return mesh;
}

void mesh_destroy(Mesh *mesh) {
    if (mesh && atomic_fetch_sub(&mesh->owners, 1) == 1) {
        munmap(mesh, mesh_size(mesh));
    }
}

/** @return Whether a number is finite and not too large for the engines. @param x The number. */
static bool is_sane(double x) {
    return fabs(x) <= LENGTH_MAXIMUM; // False for NaN.
}

/**
 * Looks at the positions, normals and (u, v) of a mesh.
 * @param mesh        The mesh.
 * @param[out] error  What is wrong.
 * @return Whether all of them are as they should be.
 */
static bool check_numbers(const Mesh *mesh, Error *error) {
    for (size_t i = 0; i < mesh->position_count; i++) {
        Vector3 p = mesh->positions[i];
        if (!is_sane(p.x) || !is_sane(p.y) || !is_sane(p.z)) {
            return error_set(error, STATUS_SCENE, "position %zu is not finite or too far", i);
        }
    }
    for (size_t i = 0; i < mesh->normal_count; i++) {
        Vector3 n = mesh->normals[i];
        if (!(fabs(vector3_dot(n, n) - 1) <= UNIT_TOLERANCE)) {
            return error_set(error, STATUS_SCENE, "normal %zu is not of unit length", i);
        }
    }
    for (size_t i = 0; i < mesh->uv_count; i++) {
        if (!is_sane(mesh->uvs[i].u) || !is_sane(mesh->uvs[i].v)) {
            return error_set(error, STATUS_SCENE, "(u, v) %zu is not finite or too far", i);
        }
    }
    return true;
}

/**
 * Looks at the places that triangles name.
 * @param triangles   The triangles; NULL is fine.
 * @param count       How many.
 * @param end         How many places there are.
 * @param[out] error  What is wrong.
 * @return Whether all are in range.
 */
static bool check_places(const MeshTriangle *triangles, size_t count, size_t end, Error *error) {
    for (size_t i = 0; triangles && i < count; i++) {
        const uint32_t *at = triangles[i].at;
        if (at[0] >= end || at[1] >= end || at[2] >= end) {
            return error_set(error, STATUS_SCENE, "triangle %zu names what is not there", i);
        }
    }
    return true;
}

bool mesh_check(const Mesh *mesh, Error *error) {
    if (mesh->triangle_count == 0) {
        return error_set(error, STATUS_SCENE, "there is no triangle in it");
    }
    size_t count = mesh->triangle_count;
    return check_numbers(mesh, error) &&
           check_places(mesh->triangles, count, mesh->position_count, error) &&
           check_places(mesh->triangle_normals, count, mesh->normal_count, error) &&
           check_places(mesh->triangle_uvs, count, mesh->uv_count, error);
}

/** A triangle while its normals are gathered. */
typedef struct Facet {
    Vector3 edges[3]; /**< From each corner to the next, any length. */
    Vector3 normal;   /**< Unit length. */
} Facet;

/**
 * Finds the edges and the normal of a triangle.
 * @param mesh        The mesh.
 * @param triangle    The triangle.
 * @param[out] facet  What was found.
 * @return false if it has no area that could be computed.
 */
static bool facet_find(const Mesh *mesh, const MeshTriangle *triangle, Facet *facet) {
    for (int i = 0; i < 3; i++) {
        Vector3 from = mesh->positions[triangle->at[i]];
        Vector3 to = mesh->positions[triangle->at[(i + 1) % 3]];
        facet->edges[i] = vector3_subtract(to, from);
    }
    Vector3 normal = vector3_cross(facet->edges[0], facet->edges[1]);
    if (!(vector3_length(normal) > 0)) {
        return false;
    }
    facet->normal = vector3_normalize(normal);
    return true;
}

/**
 * Weighs a triangle at a corner by its angle there (Thürmer and Wüthrich, *Computing Vertex Normals
 * from Polygonal Facets*, 1998).
 * @return The angle, radians; by the arc tangent, which is as good for very sharp and very blunt
 *         ones.
 * @param facet   The triangle.
 * @param corner  Which corner.
 */
static double facet_angle(const Facet *facet, int corner) {
    Vector3 out = facet->edges[corner], in = facet->edges[(corner + 2) % 3];
    Vector3 back = vector3_scale(in, -1);
    return atan2(vector3_length(vector3_cross(out, back)), vector3_dot(out, back));
}

/**
 * Puts a direction where the normals of a position's triangles cancel each other.
 * @param mesh             The mesh.
 * @param[in,out] normals  Their sums; those that are long enough become of unit length.
 */
static void make_unit(const Mesh *mesh, Vector3 *normals) {
    for (size_t i = 0; i < mesh->position_count; i++) {
        bool is_long = vector3_length(normals[i]) > SUM_MINIMUM;
        normals[i] = is_long ? vector3_normalize(normals[i]) : (Vector3){0};
    }
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        Facet facet;
        for (int k = 0; k < 3; k++) {
            Vector3 *normal = &normals[mesh->triangles[i].at[k]];
            bool is_missing = !(vector3_length(*normal) > 0);
            if (is_missing && facet_find(mesh, &mesh->triangles[i], &facet)) {
                *normal = facet.normal;
            }
        }
    }
    for (size_t i = 0; i < mesh->position_count; i++) {
        bool is_missing = !(vector3_length(normals[i]) > 0);
        normals[i] = is_missing ? (Vector3){0, 1, 0} : normals[i];
    }
}

void mesh_smooth_normals(const Mesh *mesh, Vector3 *normals) {
    memset(normals, 0, mesh->position_count * sizeof *normals);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        Facet facet;
        const MeshTriangle *triangle = &mesh->triangles[i];
        if (!facet_find(mesh, triangle, &facet)) {
            continue;
        }
        for (int k = 0; k < 3; k++) {
            Vector3 weighted = vector3_scale(facet.normal, facet_angle(&facet, k));
            Vector3 *sum = &normals[triangle->at[k]];
            *sum = vector3_add(*sum, weighted);
        }
    }
    make_unit(mesh, normals);
}
