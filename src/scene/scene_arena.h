/**
 * @file
 * @brief The block of memory of a scene.
 */
#ifndef SCENE_SCENE_ARENA_H
#define SCENE_SCENE_ARENA_H

#include "dioptre/scene.h"

/** A block: a scene, followed by the memory for its data. */
typedef struct SceneArena {
    Scene scene;              /**< The scene; its address is that of the block. */
    size_t used;              /**< Allocated bytes, this header included. */
    size_t light_capacity;    /**< Capacity of #Scene.lights. */
    size_t material_capacity; /**< Capacity of #Scene.materials. */
    size_t shape_capacity;    /**< Capacity of #Scene.shapes. */
    size_t mesh_capacity;     /**< Capacity of #Scene.meshes. */
    size_t texture_capacity;  /**< Capacity of #Scene.textures. */
    size_t note_capacity;     /**< Capacity of #Scene.notes. */
} SceneArena;

#endif
