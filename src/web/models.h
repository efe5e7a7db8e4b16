/**
 * @file
 * @brief Triangles of a model file, as they go from the program that reads such files to the
 * page's.
 *
 * Both are of 32-bit WebAssembly, so that the layout is the same.
 */
#ifndef DIOPTRE_WEB_MODELS_H
#define DIOPTRE_WEB_MODELS_H

#include "assets/meshes/mesh_plugin.h"

#include <stdint.h>

/** What a model file holds. */
typedef struct ModelTriangles {
    uint32_t count;          /**< Number of triangles. */
    uint32_t is_read;        /**< Whether all were read; if not, #result says why. */
    MeshImportResult result; /**< Defects and errors. */
    MeshCorner corners[];    /**< Three of each triangle. */
} ModelTriangles;

#endif
