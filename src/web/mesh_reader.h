/**
 * @file
 * @brief The mesh module of the page.
 */
#ifndef DIOPTRE_WEB_MESH_READER_H
#define DIOPTRE_WEB_MESH_READER_H

#include "assets/meshes/mesh_plugin.h"

/** Reads PLY, STL and glTF files. */
extern const MeshPlugin web_mesh_plugin;

#endif
