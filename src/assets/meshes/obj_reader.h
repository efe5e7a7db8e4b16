/**
 * @file
 * @brief Reading of OBJ files: the triangles of a text.
 *
 * All of the format that has triangles is read. What is known and has none is skipped: points,
 * lines, groups, smoothing groups, materials. What is not known, or has surfaces that are not
 * polygons, is skipped and counted.
 */
#ifndef DIOPTRE_ASSETS_MESHES_OBJ_READER_H
#define DIOPTRE_ASSETS_MESHES_OBJ_READER_H

#include "assets/meshes/mesh_plugin.h"
#include "base/error.h"
#include "dioptre/mesh.h"

/**
 * Reads a text in memory and passes its triangles to a sink, in the order of the file. Needs no
 * process and no file.
 * @param text             The text; any bytes, without a final zero.
 * @param size             Bytes of the text.
 * @param sink             Receives the triangles.
 * @param[in,out] repairs  What is left out is added to it.
 * @param[out] error       What is wrong (#STATUS_SCENE), with its line; unchanged if the sink
 *                         stopped.
 * @return Whether the sink took all.
 */
bool obj_read(const char *text, size_t size, const MeshSink *sink, MeshRepairs *repairs,
              Error *error);

#endif
