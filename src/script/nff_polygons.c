/**
 * @file
 * @brief The polygons of an NFF text, which become meshes.
 *
 * Tens of thousands of polygons of one material are one mesh, with one hierarchy of triangles.
 */
#include "script/nff_polygons.h"

#include "assets/meshes/mesh_builder.h"
#include "assets/meshes/triangulate.h"
#include "base/sanitize.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** First capacity of arrays. */
enum { FIRST_CAPACITY = 256 };

/** Largest number of meshes: each takes a mapping of memory, of which Linux allows 65530. */
enum { NFF_MESHES_MAXIMUM = 16384 };

/** Doubles the capacity of an array if it is full. @return false without memory. */
static bool grow(void **array, size_t *capacity, size_t count, size_t size, Error *error) {
    if (count < *capacity) {
        return true;
    }
    size_t new_capacity = *capacity ? 2 * *capacity : FIRST_CAPACITY;
    void *larger = realloc(*array, new_capacity * size);
    if (!larger) {
        return error_set(error, STATUS_SCENE,
                         "the polygons need more memory than a scene may take");
    }
    *array = larger;
    *capacity = new_capacity;
    return true;
}

bool nff_polygons_add(NffPolygons *polygons, const NffPolygon *polygon, Error *error) {
    void *array = polygons->polygons;
    bool has_room =
        grow(&array, &polygons->polygon_capacity, polygons->polygon_count, sizeof *polygon, error);
    polygons->polygons = array;
    if (has_room) {
        polygons->polygons[polygons->polygon_count++] = *polygon;
    }
    return has_room;
}

bool nff_polygons_add_vertex(NffPolygons *polygons, const double *numbers, Error *error) {
    const size_t size = NFF_VERTEX_NUMBERS * sizeof *numbers;
    void *array = polygons->vertices;
    bool has_room = grow(&array, &polygons->vertex_capacity, polygons->vertex_count, size, error);
    polygons->vertices = array;
    if (has_room) {
        memcpy(polygons->vertices + NFF_VERTEX_NUMBERS * polygons->vertex_count++, numbers, size);
    }
    return has_room;
}

void nff_polygons_deinit(NffPolygons *polygons) {
    free(polygons->vertices);
    free(polygons->polygons);
    *polygons = (NffPolygons){0};
}

/** Compares two numbers, for qsort. */
static int compare(size_t a, size_t b) {
    return (a > b) - (a < b);
}

/** Orders polygons by mesh, then as in the file. See qsort. */
static int compare_polygons(const void *first, const void *second) {
    const NffPolygon *a = first, *b = second;
    int order = compare(a->material, b->material);
    order = order ? order : compare(a->has_normals, b->has_normals);
    return order ? order : compare(a->first, b->first);
}

/** @return Whether two polygons belong to the same mesh. */
static bool shares_mesh(const NffPolygon *a, const NffPolygon *b) {
    return a->material == b->material && a->has_normals == b->has_normals;
}

/** Memory for the triangulation of a polygon. */
typedef struct Triangulation {
    Vec3d *positions;    /**< Positions of the vertices; owned. */
    uint32_t *work;      /**< An index per vertex; owned. */
    uint32_t *triangles; /**< Three indices per triangle; owned. */
} Triangulation;

/** Frees the memory. */
static void triangulation_deinit(Triangulation *memory) {
    free(memory->positions);
    free(memory->work);
    free(memory->triangles);
}

/** Allocates memory. @param count Largest number of vertices. @return false without memory. */
static bool triangulation_init(Triangulation *memory, size_t count, Error *error) {
    *memory = (Triangulation){.positions = malloc(count * sizeof *memory->positions),
                              .work = malloc(count * sizeof *memory->work),
                              .triangles = malloc(3 * count * sizeof *memory->triangles)};
    return (memory->positions && memory->work && memory->triangles) ||
           error_set(error, STATUS_SCENE, "the polygons need more memory than a scene may take");
}

/** Adds the triangles of a polygon to a mesh. @return false without memory, or if a number is out
 *  of range. */
static bool add_polygon(const NffPolygons *polygons, const NffPolygon *polygon,
                        Triangulation *memory, MeshBuilder *builder) {
    const double *numbers = polygons->vertices + NFF_VERTEX_NUMBERS * polygon->first;
    for (size_t i = 0; i < polygon->count; i++) {
        const double *p = numbers + NFF_VERTEX_NUMBERS * i;
        if (!mesh_builder_check(builder, p)) {
            return false;
        }
        memory->positions[i] = (Vec3d){p[0], p[1], p[2]};
    }
    size_t missing, count = triangulate_polygon(memory->positions, polygon->count,
                                                memory->triangles, memory->work, &missing);
    builder->repairs.untriangulated_polygons += missing;
    builder->repairs.degenerate_triangles += polygon->count - 2 - count - missing;
    for (size_t i = 0; i < count; i++) {
        MeshCorner corners[3];
        for (int k = 0; k < 3; k++) {
            const double *vertex =
                numbers + NFF_VERTEX_NUMBERS * memory->triangles[3 * i + (size_t)k];
            corners[k] = (MeshCorner){.has_normal = polygon->has_normals};
            memcpy(corners[k].position, vertex, sizeof corners[k].position);
            memcpy(corners[k].normal, vertex + 3, sizeof corners[k].normal);
        }
        if (!mesh_builder_add(builder, corners)) {
            return false;
        }
    }
    return true;
}

/** Adds the mesh of a builder to a scene, and its shape. @param first Its first polygon. */
static bool add_mesh(Scene *scene, MeshBuilder *builder, const NffPolygon *first, const char *path,
                     Error *error) {
    char display_path[SANITIZED_PATH_SIZE], place[SANITIZED_PATH_SIZE + 16], key[PATH_MAX + 16];
    const char *slash = strrchr(path, '/');
    Mesh counts, *mesh;
    MeshShapeParameters shape = {.normals = first->has_normals ? NORMALS_FROM_FILE : NORMALS_FLAT};
    if (!mesh_builder_finish(builder, &counts)) {
        return false;
    }
    sanitize_path(display_path, path);
    snprintf(place, sizeof place, "%s:%d", display_path, first->line);
    snprintf(key, sizeof key, "%s:%d", path, first->line);
    const SceneFile file = {
        .path = key, .name = slash ? key + (slash + 1 - path) : key, .location = place};
    mesh = scene_add_built_mesh(scene, &file, &counts, &shape.file, error);
    if (!mesh) {
        return false;
    }
    mesh_builder_copy(builder, mesh);
    size_t class_index = scene_shape_find("mesh");
    bool is_added = scene_add_shape(scene, class_index, scene_shape_keywords[class_index], &shape,
                                    first->material, error);
    if (is_added) {
        scene->shapes[scene->shape_count - 1].origin.line = first->line;
    }
    return is_added;
}

/** Adds polygons of one mesh. @param count Number of the polygons. */
static bool add_group(const NffPolygons *polygons, const NffPolygon *group, size_t count,
                      Triangulation *memory, Scene *scene, const char *path, Error *error) {
    MeshBuilder builder;
    mesh_builder_init(&builder, error);
    bool is_good = true;
    for (size_t i = 0; is_good && i < count; i++) {
        is_good = add_polygon(polygons, &group[i], memory, &builder);
    }
    is_good = is_good && add_mesh(scene, &builder, group, path, error);
    mesh_builder_deinit(&builder);
    return is_good;
}

bool nff_polygons_add_to_scene(NffPolygons *polygons, Scene *scene, const char *path, int *line,
                               Error *error) {
    size_t count = polygons->polygon_count, largest = 0;
    const NffPolygon *sorted = polygons->polygons;
    if (count == 0) {
        return true;
    }
    qsort(polygons->polygons, count, sizeof *polygons->polygons, compare_polygons);
    for (size_t i = 0; i < count; i++) {
        largest = sorted[i].count > largest ? sorted[i].count : largest;
    }
    Triangulation memory;
    bool is_good = triangulation_init(&memory, largest, error);
    for (size_t i = 0, end; is_good && i < count; i = end) {
        for (end = i; end < count && shares_mesh(&sorted[i], &sorted[end]);) {
            end++;
        }
        *line = sorted[i].line;
        is_good = scene->mesh_count < NFF_MESHES_MAXIMUM
                      ? add_group(polygons, &sorted[i], end - i, &memory, scene, path, error)
                      : error_set(error, STATUS_SCENE,
                                  "polygons of more than %d materials: too many meshes",
                                  NFF_MESHES_MAXIMUM);
    }
    triangulation_deinit(&memory);
    return is_good;
}
