/**
 * @file
 * @brief A scene: what is to be drawn, as plain data in double precision.
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
/** Largest number of rays a pixel. */
enum { SAMPLES_MAXIMUM = 65536 };
/** Largest number of times that a ray may be mirrored or refracted: a guard for the stack. */
enum { DEPTH_MAXIMUM = 256 };
/** #SceneImage.depth where nobody says: until no more can be seen (see
 * render/precision_estimate.h). */
enum { IMAGE_DEPTH_AUTO = -1 };

/** Size and quality of the picture that a scene asks for. Filled through #scene_image_keyword. */
typedef struct SceneImage {
    int width;    /**< Pixels, 1 to #IMAGE_SIZE_MAXIMUM. */
    int height;   /**< Pixels, 1 to #IMAGE_SIZE_MAXIMUM. */
    int encoding; /**< An #Encoding. */
    int samples;  /**< Rays a pixel, 1 to #SAMPLES_MAXIMUM. */
    int depth;    /**< How often a ray may be mirrored or refracted, 0 to #DEPTH_MAXIMUM, or
                       #IMAGE_DEPTH_AUTO. */
} SceneImage;

/** The scene language's `image`. */
extern const Keyword scene_image_keyword;

/** What a ray that meets nothing sees. Filled through #scene_sky_keyword. */
typedef struct SceneSky {
    Rgbd color;        /**< One colour all around, when `color` was given. */
    Rgbd horizon;      /**< Colour at the horizon and below it. */
    Rgbd zenith;       /**< Colour straight up; between the two by the sine of the height. */
    size_t texture_id; /**< Place in #Scene.textures, plus one, of a panorama; 0: there is none. */
    double rotate;     /**< How far the panorama is turned about y, degrees, to the left. */
} SceneSky;

/** The scene language's `sky`. */
extern const Keyword scene_sky_keyword;

/** One shape of a scene: which kind, with what parameters and which material. */
typedef struct SceneShape {
    size_t class_index;         /**< Place in the engines' list of shape classes. */
    const void *parameters;     /**< The class's own parameter struct; owned by the scene. */
    size_t material_index;      /**< Place in #Scene.materials. */
    const Transform *transform; /**< How it is stretched, turned and moved; NULL: not at all.
                                     Owned by the scene. */
    int line;                   /**< Of the scene file, that it stands in; 0: not known, or in a
                                     file that the scene file includes. */
} SceneShape;

/** A file that a scene names; once, however often it is named. */
typedef struct SceneFile {
    const char *path;     /**< Where it is, absolute and without links. */
    const char *name;     /**< As the scene names it. */
    const char *location; /**< `FILE:LINE` where it is named first: errors about it begin so. */
} SceneFile;

/** A model file that a scene names. */
typedef struct SceneMesh {
    SceneFile file; /**< The file. */
    Mesh *mesh;     /**< What is in it; the scene is one of its owners. NULL until it is read, which
                         is after the scene file has run. */
} SceneMesh;

/** A picture file that a scene names. */
typedef struct SceneTexture {
    SceneFile file;   /**< The file. */
    Texture *texture; /**< What is in it; the scene is one of its owners. NULL until it is read,
                           which is after the scene file has run. */
} SceneTexture;

/** A whole scene. The arrays are owned by the scene. */
typedef struct Scene {
    SceneCamera camera;     /**< From where it is seen. */
    bool has_camera;        /**< Whether a camera was given; a scene needs one. */
    bool is_time_dependent; /**< Whether its file asked what time it is: else no time changes it. */
    SceneImage image;       /**< The picture that it asks for. */
    Rgbd ambient;           /**< Light from everywhere. */
    SceneSky sky;           /**< What is behind everything. */
    SceneLight *lights;     /**< The lamps. */
    size_t light_count;     /**< How many. */
    SceneMaterial
        *materials;         /**< The surfaces; the first is the matt white of shapes without one. */
    size_t material_count;  /**< How many, at least 1. */
    SceneShape *shapes;     /**< What stands in it. */
    size_t shape_count;     /**< How many. */
    SceneMesh *meshes;      /**< The models that the shapes name. */
    size_t mesh_count;      /**< How many. */
    SceneTexture *textures; /**< The pictures that materials and the sky name. */
    size_t texture_count;   /**< How many. */
} Scene;

/**
 * Makes an empty scene: no shape, no light, a black sky, one matt white material, no camera.
 * @param[out] error  What is wrong.
 * @return The scene, to be given back with #scene_destroy; NULL without memory.
 */
Scene *scene_create(Error *error);

/** Makes an empty scene at an address of its own, in a worker process. @return NULL where the
 *  address is taken. */
Scene *scene_create_at(void *address, Error *error);

/** @return Bytes of a scene's block that are used: all that another process needs of it. */
size_t scene_block_size(const Scene *scene);

/**
 * Makes a scene of which all is as in another, but elsewhere: its shapes, camera and lamps.
 * @param scene       The other; its words, as of files, are shared, so it must live as long.
 * @param offset         How far it is moved, scene units.
 * @param[out] error  What is wrong.
 * @return The scene, to be given back with #scene_destroy; NULL without memory. Behind its models
 *         stand those that had to be moved themselves.
 */
Scene *scene_translated(const Scene *scene, Vec3d offset, Error *error);

/** Gives a scene back. @param scene The scene, or NULL. */
void scene_destroy(Scene *scene);

/**
 * Adds a lamp.
 * @param[in,out] scene  The scene.
 * @param light          The lamp; copied.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_add_light(Scene *scene, const SceneLight *light, Error *error);

/**
 * Adds a material; its place is #Scene.material_count - 1 afterwards.
 * @param[in,out] scene  The scene.
 * @param material       The material; copied.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_add_material(Scene *scene, const SceneMaterial *material, Error *error);

/**
 * Adds a shape.
 * @param[in,out] scene  The scene.
 * @param class_index           Its place in the engines' list of shape classes.
 * @param keyword        The keyword of that class.
 * @param parameters     Its parameter struct, finished; copied.
 * @param material_index       Place of its material.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_add_shape(Scene *scene, size_t class_index, const Keyword *keyword,
                     const void *parameters, size_t material_index, Error *error);

/**
 * Adds a model file, unless it is there already.
 * @param[in,out] scene  The scene.
 * @param file           The file; its words are copied.
 * @param[out] index     Its place in #Scene.meshes.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_add_mesh(Scene *scene, const SceneFile *file, size_t *index, Error *error);

/**
 * Adds a picture file, unless it is there already.
 * @param[in,out] scene  The scene.
 * @param file           The file; its words are copied.
 * @param[out] index     Its place in #Scene.textures.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_add_texture(Scene *scene, const SceneFile *file, size_t *index, Error *error);

/**
 * Keeps a distance field.
 * @param[in,out] scene  The scene.
 * @param sdf          The field; copied.
 * @param[out] error     What is wrong.
 * @return The copy, owned by the scene; NULL when the scene's memory is full.
 */
const Sdf *scene_add_sdf(Scene *scene, const Sdf *sdf, Error *error);

/**
 * Stretches, turns and moves the shape that was added last.
 * @param[in,out] scene  The scene, with at least one shape.
 * @param transform      How, finished; copied.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_set_last_transform(Scene *scene, const Transform *transform, Error *error);

/** @return Whether any shape of a scene mirrors. @param scene A scene. */
bool scene_has_reflection(const Scene *scene);

/** @return Whether any shape of a scene shows a picture. @param scene A scene. */
bool scene_has_textures(const Scene *scene);
/** @return Whether any shape of a scene lets light through. @param scene A scene. */
bool scene_has_transparency(const Scene *scene);

/** @return Whether any shape of a scene has highlights. @param scene A scene. */
bool scene_has_specular(const Scene *scene);

/**
 * Bytes of the block that holds a scene: reserved, but only used as far as it is filled. A million
 * spheres fit; a scene file that runs away does not fill the machine.
 */
#define SCENE_MEMORY_SIZE ((size_t)256 << 20)

#endif
