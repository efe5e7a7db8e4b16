/**
 * @file
 * @brief A scene as plain data in double precision.
 *
 * A scene lives in one block of memory of its own, which one call gives back. Pointers in it lead
 * into it. So a worker process can make a scene at the address where the program wants it, and send
 * the bytes (script/script_worker.h).
 */
#ifndef DIOPTRE_SCENE_H
#define DIOPTRE_SCENE_H

#include "dioptre/camera.h"
#include "dioptre/encoding.h"
#include "dioptre/light.h"
#include "dioptre/material.h"
#include "dioptre/shape.h"
#include "dioptre/texture.h"
#include "dioptre/transform.h"

/** Largest width and height of a picture, in pixels. */
enum { IMAGE_SIZE_MAXIMUM = 16384 };
/** Largest number of samples per pixel. */
enum { SAMPLES_MAXIMUM = 65536 };
/** Largest recursion depth: a guard for the stack. */
enum { DEPTH_MAXIMUM = 256 };
/** Default of #SceneImage.depth: until a ray cannot change the picture (see
 *  render/precision_estimate.h). */
enum { IMAGE_DEPTH_AUTO = -1 };

/** Size and quality of the picture. Filled through #scene_image_keyword. */
typedef struct SceneImage {
    int width;    /**< Pixels, 1 to #IMAGE_SIZE_MAXIMUM. */
    int height;   /**< Pixels, 1 to #IMAGE_SIZE_MAXIMUM. */
    int encoding; /**< An #Encoding. */
    int samples;  /**< Samples per pixel, 1 to #SAMPLES_MAXIMUM. */
    int depth;    /**< Recursion depth, 0 to #DEPTH_MAXIMUM, or #IMAGE_DEPTH_AUTO. */
} SceneImage;

/** The scene language's `image`. */
extern const Keyword scene_image_keyword;

/** The background. Filled through #scene_sky_keyword. */
typedef struct SceneSky {
    Rgbd color;        /**< Uniform colour, if `color` is given. */
    Rgbd horizon;      /**< Colour at the horizon and below it. */
    Rgbd zenith;       /**< Colour at the zenith; interpolated by the sine of the elevation. */
    size_t texture_id; /**< Index of a panorama in #Scene.textures, plus one; 0: none. */
    double rotate;     /**< Rotation of the panorama about y, degrees, to the left. */
} SceneSky;

/** The scene language's `sky`. */
extern const Keyword scene_sky_keyword;

/** A shape of a scene. */
typedef struct SceneShape {
    size_t class_index;         /**< Its kind: index in #scene_shape_classes. */
    const void *parameters;     /**< Parameter struct of its kind; owned by the scene. */
    size_t material_index;      /**< Index in #Scene.materials. */
    const Transform *transform; /**< Its transform; NULL: none. Owned by the scene. */
    int line;                   /**< Line in the scene file; 0: unknown, or in an included file. */
} SceneShape;

/** A file that a scene names; one per file, however often the scene names it. */
typedef struct SceneFile {
    const char *path;     /**< Absolute path without links. */
    const char *name;     /**< Name in the scene. */
    const char *location; /**< `FILE:LINE` of its first use, the prefix of errors about it. */
} SceneFile;

/** A mesh file that a scene names. */
typedef struct SceneMesh {
    SceneFile file; /**< The file. */
    Mesh *mesh;     /**< Its content, retained. NULL until it is read, after the run of the scene
                         file. */
} SceneMesh;

/** A picture file that a scene names. */
typedef struct SceneTexture {
    SceneFile file;   /**< The file. */
    Texture *texture; /**< Its content, retained. NULL until it is read, after the run of the scene
                           file. */
} SceneTexture;

/** A scene. It owns its arrays. */
typedef struct Scene {
    SceneCamera camera;     /**< Camera. */
    bool has_camera;        /**< Whether the file gives a camera; a scene needs one. */
    bool is_time_dependent; /**< Whether its file uses the time. */
    SceneImage image;       /**< Size and quality of the picture. */
    Rgbd ambient;           /**< Ambient light. */
    SceneSky sky;           /**< Background. */
    SceneLight *lights;     /**< Lights. */
    size_t light_count;     /**< Number of lights. */
    SceneMaterial
        *materials;         /**< Materials; the first, matt white, is that of shapes without one. */
    size_t material_count;  /**< Number of materials, at least 1. */
    SceneShape *shapes;     /**< Shapes. */
    size_t shape_count;     /**< Number of shapes. */
    SceneMesh *meshes;      /**< Meshes of the shapes. */
    size_t mesh_count;      /**< Number of meshes. */
    SceneTexture *textures; /**< Textures of materials and sky. */
    size_t texture_count;   /**< Number of textures. */
} Scene;

/**
 * Creates an empty scene: no shape, no light, a black sky, one matt white material, no camera.
 * @param[out] error  What is wrong.
 * @return The scene, to be freed with #scene_destroy; NULL without memory.
 */
Scene *scene_create(Error *error);

/** Makes an empty scene at an address of its own, in a worker process. @return NULL where the
 *  address is taken. */
Scene *scene_create_at(void *address, Error *error);

/** @return Bytes of a scene's block that are used: all that another process needs of it. */
size_t scene_block_size(const Scene *scene);

/**
 * Copies a scene and translates all of it: shapes, camera and lights.
 * @param scene       The scene; the copy shares its strings, so it must live as long.
 * @param offset      Translation, scene units.
 * @param[out] error  What is wrong.
 * @return The copy, to be freed with #scene_destroy; NULL without memory. Its meshes are the
 * original ones, followed by translated copies of those that need it.
 */
Scene *scene_translated(const Scene *scene, Vec3d offset, Error *error);

/** Frees a scene. @param scene The scene, or NULL. */
void scene_destroy(Scene *scene);

/**
 * Adds a light.
 * @param[in,out] scene  The scene.
 * @param light          The light; copied.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_add_light(Scene *scene, const SceneLight *light, Error *error);

/**
 * Adds a material; its index is #Scene.material_count - 1 afterwards.
 * @param[in,out] scene  The scene.
 * @param material       The material; copied.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_add_material(Scene *scene, const SceneMaterial *material, Error *error);

/**
 * Adds a shape.
 * @param[in,out] scene  The scene.
 * @param class_index    Index in #scene_shape_classes.
 * @param keyword        Its keyword.
 * @param parameters     Its parameter struct, finished; copied.
 * @param material_index Index in #Scene.materials.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_add_shape(Scene *scene, size_t class_index, const Keyword *keyword,
                     const void *parameters, size_t material_index, Error *error);

/**
 * Adds a mesh file, unless the scene has it already.
 * @param[in,out] scene  The scene.
 * @param file           The file; its strings are copied.
 * @param[out] index     Its index in #Scene.meshes.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_add_mesh(Scene *scene, const SceneFile *file, size_t *index, Error *error);

/**
 * Adds a picture file, unless the scene has it already.
 * @param[in,out] scene  The scene.
 * @param file           The file; its strings are copied.
 * @param[out] index     Its index in #Scene.textures.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_add_texture(Scene *scene, const SceneFile *file, size_t *index, Error *error);

/**
 * Adds a distance field.
 * @param[in,out] scene  The scene.
 * @param sdf            The field; copied.
 * @param[out] error     What is wrong.
 * @return The copy, owned by the scene; NULL when the scene's memory is full.
 */
const Sdf *scene_add_sdf(Scene *scene, const Sdf *sdf, Error *error);

/**
 * Transforms the last shape.
 * @param[in,out] scene  The scene, with at least one shape.
 * @param transform      The transform, finished; copied.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_set_last_transform(Scene *scene, const Transform *transform, Error *error);

/** @return Whether any shape is reflective. @param scene The scene. */
bool scene_has_reflection(const Scene *scene);

/** @return Whether any shape has a texture. @param scene The scene. */
bool scene_has_textures(const Scene *scene);

/** @return Whether any shape is transparent. @param scene The scene. */
bool scene_has_transparency(const Scene *scene);

/** @return Whether any shape has specular highlights. @param scene The scene. */
bool scene_has_specular(const Scene *scene);

/**
 * Bytes of the block of a scene: reserved, but only used as far as it is filled. It holds a million
 * spheres, and limits scene files that never stop.
 */
#define SCENE_MEMORY_SIZE ((size_t)256 << 20)

#endif
