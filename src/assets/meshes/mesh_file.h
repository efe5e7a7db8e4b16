/**
 * @file
 * @brief Reading of mesh files.
 *
 * Libraries that read meshes are not safe for malicious files. The file is therefore read in a
 * worker process with limits of time and memory, and its mesh is checked again here.
 */
#ifndef DIOPTRE_ASSETS_MESHES_MESH_FILE_H
#define DIOPTRE_ASSETS_MESHES_MESH_FILE_H

#include "assets/asset_budget.h"
#include "dioptre/mesh.h"

/** Limit of the processor time of reading any mesh, seconds. */
#define MESH_FILE_TIME_LIMIT 8.0
/** Bytes of a file per further second of the time limit: ten times the time on a usual computer. */
#define MESH_FILE_BYTES_PER_SECOND ((size_t)4 << 20)

/**
 * Checks the extension of a mesh file; nothing is opened.
 * @param path        The file.
 * @param[out] error  The known extensions (#STATUS_SCENE), without the path.
 * @return Whether it is that of a readable format.
 */
bool mesh_file_check(const char *path, Error *error);

/**
 * Reads a mesh file. Other files that it names are not opened.
 * @param file        The file.
 * @param[in,out] budget  What the scene has left.
 * @param progress    Receives the progress, or NULL.
 * @param[out] mesh   The mesh, to be freed with #mesh_release; NULL on errors.
 * @param[out] error  What is wrong, without the path (#STATUS_SCENE; #STATUS_FAILED without module,
 *                    memory or process).
 * @return Whether it was read.
 */
bool mesh_file_read(const AssetFile *file, AssetBudget *budget, const MeshProgress *progress,
                    Mesh **mesh, Error *error);

#endif
