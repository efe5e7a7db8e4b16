/**
 * @file
 * @brief Limits of memory in a page, which has a quarter of what a desktop gives; included before
 *        every file.
 */
#ifndef DIOPTRE_WEB_MEMORY_H
#define DIOPTRE_WEB_MEMORY_H

/** Largest size of a scene, bytes: some sixty thousand spheres. All of it is set to zero for each
 * scene that is read, in 2 ms. */
#define SCENE_MEMORY_SIZE ((size_t)16 << 20)
/** Largest size of the Lua data of a scene, bytes. */
#define SCRIPT_MEMORY_LIMIT ((size_t)128 << 20)
/** Largest size of a picture of a scene, bytes. */
#define TEXTURE_FILE_CAPACITY ((size_t)64 << 20)
/** Largest size of a mesh, bytes. */
#define MESH_CAPACITY ((size_t)256 << 20)

#endif
