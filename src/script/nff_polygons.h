/**
 * @file
 * @brief The polygons of an NFF text, which become meshes.
 */
#ifndef DIOPTRE_SCRIPT_NFF_POLYGONS_H
#define DIOPTRE_SCRIPT_NFF_POLYGONS_H

#include "dioptre/scene.h"

/** Numbers per vertex: position and normal. */
enum { NFF_VERTEX_NUMBERS = 6 };

/** A polygon or patch. */
typedef struct NffPolygon {
    size_t first;     /**< Index of its first vertex. */
    size_t count;     /**< Number of its vertices, at least 3. */
    size_t material;  /**< Index in #Scene.materials. */
    bool has_normals; /**< Whether its vertices have normals: a patch. */
    int line;         /**< Its line. */
} NffPolygon;

/** All polygons of a text. Starts as `{0}`; freed by #nff_polygons_deinit. */
typedef struct NffPolygons {
    double *vertices;        /**< #NFF_VERTEX_NUMBERS per vertex; owned. */
    size_t vertex_count;     /**< Number of vertices. */
    size_t vertex_capacity;  /**< Capacity of #vertices, in vertices. */
    NffPolygon *polygons;    /**< The polygons; owned. */
    size_t polygon_count;    /**< Number of polygons. */
    size_t polygon_capacity; /**< Capacity of #polygons. */
} NffPolygons;

/**
 * Adds a polygon whose vertices were just added.
 * @param[in,out] polygons  The polygons.
 * @param polygon           The polygon; copied.
 * @param[out] error        What is wrong.
 * @return false without memory.
 */
bool nff_polygons_add(NffPolygons *polygons, const NffPolygon *polygon, Error *error);

/**
 * Adds a vertex.
 * @param[in,out] polygons  The polygons.
 * @param numbers           Its #NFF_VERTEX_NUMBERS; copied.
 * @param[out] error        What is wrong.
 * @return false without memory.
 */
bool nff_polygons_add_vertex(NffPolygons *polygons, const double *numbers, Error *error);

/**
 * Adds the polygons to a scene: a mesh for all polygons of a material, another one for its patches.
 * @param[in,out] polygons  The polygons; sorted by mesh afterwards.
 * @param[in,out] scene     The scene.
 * @param path              Path of the file; the names of the meshes are `FILE:LINE`.
 * @param[out] line         Line of what is wrong.
 * @param[out] error        What is wrong.
 * @return Whether all were added.
 */
bool nff_polygons_add_to_scene(NffPolygons *polygons, Scene *scene, const char *path, int *line,
                               Error *error);

/** Frees the polygons. @param polygons The polygons. */
void nff_polygons_deinit(NffPolygons *polygons);

#endif
