/**
 * @file
 * @brief Model files: from the path to a mesh that is checked.
 *
 * Libraries that read models do not expect hostile files. So the model is read in a worker process
 * with limits of time and memory; the mesh that it sends is checked again here.
 */
#ifndef DIOPTRE_ASSETS_MESHES_MESH_FILE_H
#define DIOPTRE_ASSETS_MESHES_MESH_FILE_H

#include "dioptre/mesh.h"

/** Seconds that reading any model may take: with all around it, a hostile one is over in 10. */
#define MESH_FILE_TIME_LIMIT 8.0
/** Bytes of a file for which it may take a second more: ten times what a usual machine needs. */
#define MESH_FILE_BYTES_PER_SECOND ((size_t)4 << 20)

/**
 * Says whether a file may be a model, by its name and kind; does not read it.
 * @param[out] error  Why not (#STATUS_SCENE), without the path.
 * @return Whether it is a regular file with the ending of a format that can be read.
 */
bool mesh_file_check(const char *path, Error *error);

/**
 * Reads a model file. No other file is opened, whatever it names.
 * @param progress  Who is told how far it is; NULL: nobody.
 * @param[out] mesh  The mesh, to be given back with #mesh_release; NULL if anything is wrong.
 * @param[out] error  What is wrong, without the path (#STATUS_SCENE; #STATUS_FAILED without module,
 *         memory or process).
 * @return Whether it was read.
 */
bool mesh_file_read(const char *path, const MeshProgress *progress, Mesh **mesh, Error *error);

#endif
