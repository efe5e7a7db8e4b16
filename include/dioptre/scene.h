/**
 * @file
 * @brief A scene as plain data in double precision.
 *
 * A scene lies in one block of memory with all its arrays, and all its pointers lead into that
 * block. A worker process can therefore create a scene at the address where the program needs it,
 * and send the bytes (script/script_worker.h).
 */
#ifndef DIOPTRE_SCENE_H
#define DIOPTRE_SCENE_H

#include "base/encoding.h"
#include "base/error.h"
#include "dioptre/mesh.h"
#include "dioptre/parameter.h"
#include "dioptre/sdf.h"

#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

/* --- Where things come from ------------------------------------------------------------------- */

/** The call of a scene file that made a light, a material or a shape. */
typedef struct SceneOrigin {
    int number; /**< Its place among the calls of its keyword in one run of the file, from 1; 0: no
                     call made it. */
    int line;   /**< Its line in the scene file; 0: unknown, or in an included file. */
    uint64_t given; /**< Bit i: the call gives row i of the keyword's table. */
} SceneOrigin;

/* --- Textures --------------------------------------------------------------------------------- */

/** Colours of a texel: red, green, blue. */
enum { TEXEL_CHANNELS = 3 };

/**
 * An image for materials and skies. Its texels follow it in memory: #texture_ldr_texels or
 * #texture_hdr_texels.
 */
typedef struct Texture {
    int width;       /**< Width in texels, 1 to `IMAGE_SIZE_MAXIMUM`. */
    int height;      /**< Height in texels, 1 to `IMAGE_SIZE_MAXIMUM`. */
    bool is_hdr;     /**< Whether texels are floats in linear light; else bytes in sRGB. */
    bool is_damaged; /**< Whether the file ends early or is damaged: some texels are guesses. */
    atomic_uint reference_count; /**< Number of references. */
} Texture;

/**
 * @return Bytes of the block of a texture: the struct and its texels.
 * @param head  The texture; only its size and #Texture.is_hdr are read.
 */
size_t texture_block_size(const Texture *head);

/** @return The texels of a texture in sRGB, 8 bits per channel. @param texture The texture. */
static inline uint8_t *texture_ldr_texels(const Texture *texture) {
    return (uint8_t *)(uintptr_t)(texture + 1);
}

/** @return The texels of a texture in linear light. @param texture The texture. */
static inline float *texture_hdr_texels(const Texture *texture) {
    return (float *)(uintptr_t)(texture + 1);
}

/**
 * Creates a black texture with one reference.
 * @param width       Width in texels.
 * @param height      Height in texels.
 * @param is_hdr      Whether its texels are in linear light.
 * @param[out] error  What is wrong.
 * @return The texture, to be freed with #texture_release; NULL without memory.
 */
Texture *texture_create(int width, int height, bool is_hdr, Error *error);

/** Adds a reference. @param texture The texture, or NULL. @return The same. */
Texture *texture_retain(Texture *texture);

/** Removes a reference; the last one frees the memory. @param texture The texture, or NULL. */
void texture_release(Texture *texture);

/**
 * Limits the texels in linear light to valid values: NaN and negative numbers become 0, and numbers
 * above #INTENSITY_MAXIMUM, infinity too, become that maximum.
 * @param[in,out] texture  The texture.
 */
void texture_sanitize(Texture *texture);

/* --- The camera ------------------------------------------------------------------------------- */

/** A pinhole camera. Filled from a scene file through #scene_camera_keyword. */
typedef struct SceneCamera {
    Vec3d position;  /**< Position, scene units. */
    Vec3d look_at;   /**< A point in the middle of the image, if `look_at` is given. */
    Vec3d direction; /**< Viewing direction; after #Keyword.finish a unit vector. */
    Vec3d up;        /**< Up in the image; after #Keyword.finish a unit vector, perpendicular. */
    double pan;      /**< Degrees to the right of -z, if `pan` is given. */
    double tilt;     /**< Degrees above the horizon, if `tilt` is given. */
    double fov;      /**< Horizontal field of view, degrees; the height follows from it. */
    double target_distance; /**< Distance of the point it looks at, scene units; the keys move it in
                               proportion. */
} SceneCamera;

/** The scene language's `camera`. */
extern const Keyword scene_camera_keyword;

/**
 * @return The unit vector to the right in the image.
 * @param camera  A finished camera.
 */
Vec3d scene_camera_right(const SceneCamera *camera);

/**
 * Translates the camera without rotation.
 * @param[in,out] camera  A finished camera.
 * @param right    Scene units to the right.
 * @param up       Scene units up in the image.
 * @param forward  Scene units ahead.
 */
void scene_camera_move(SceneCamera *camera, double right, double up, double forward);

/**
 * Translates the camera as one walks: along the ground, or straight up and down.
 * @param[in,out] camera  A finished camera.
 * @param vertical  Up in the scene, a unit vector along an axis.
 * @param right    Scene units to the right; the height stays the same, to the bit.
 * @param up       Scene units along the vertical.
 * @param forward  Scene units ahead at the same height. For a camera that looks straight down, the
 *                 top of its picture is ahead; for one that looks straight up, the bottom.
 */
void scene_camera_walk(SceneCamera *camera, Vec3d vertical, double right, double up,
                       double forward);

/**
 * Rotates the camera at its position: about the vertical, then up or down.
 * @param[in,out] camera  A finished camera.
 * @param vertical  Up in the scene, a unit vector.
 * @param pan       Degrees to the right.
 * @param tilt      Degrees up; it stops 1 degree before the vertical.
 */
void scene_camera_rotate(SceneCamera *camera, Vec3d vertical, double pan, double tilt);

/**
 * Rotates the camera around a point, which stays where it is in the picture.
 * @param[in,out] camera  A finished camera.
 * @param vertical  Up in the scene, a unit vector.
 * @param center    The point, scene units.
 * @param pan       Degrees that the camera turns to the right: what is before the point follows.
 * @param tilt      Degrees up; it stops 1 degree before the vertical.
 */
void scene_camera_orbit(SceneCamera *camera, Vec3d vertical, Vec3d center, double pan, double tilt);

/**
 * Changes the field of view.
 * @param[in,out] camera  A camera.
 * @param factor          Factor for the tangent of half the field of view; the result stays in
 *                        range.
 */
void scene_camera_zoom(SceneCamera *camera, double factor);

/* --- Lights ----------------------------------------------------------------------------------- */

/**
 * The registry of the classes of lights. `CLASS(x)` expands to a use of `scene_x_class`, a
 * #SceneLightClass, and in each engine of `x_class`, a LightClass.
 */
#define SCENE_LIGHT_CLASSES(CLASS)                                                                 \
    CLASS(point_light)                                                                             \
    CLASS(sun)                                                                                     \
    CLASS(rectangle_light)                                                                         \
    CLASS(cylinder_light)

/** How light decreases with distance. */
typedef enum {
    FALLOFF_NONE,           /**< Not at all. */
    FALLOFF_INVERSE_SQUARE, /**< With the square of the distance. */
    FALLOFF_INVERSE_LINEAR  /**< With the distance plus a constant, #SceneLight.falloff_constant. */
} Falloff;

/** Doubles that a class may store in a light besides the common fields. */
enum { SCENE_LIGHT_OWN_DOUBLES = 8 };

/** A light of a scene, of any class. Filled through #SceneLightClass.keyword. */
typedef struct SceneLight {
    size_t class_index;      /**< Index in #scene_light_classes; 0 is the point light. */
    Rgbd color;              /**< Colour, linear. */
    double intensity;        /**< Factor for the colour. */
    int falloff;             /**< A #Falloff; lights at infinity have none. */
    double falloff_constant; /**< For #FALLOFF_INVERSE_LINEAR, scene units, at least 0. */
    Vec3d position;  /**< Centre, corner or base, scene units; unused for lights at infinity. */
    double radius;   /**< Radius of spherical and cylindrical lights, scene units; 0: a point. */
    Vec3d direction; /**< For lights at infinity: the direction in which the light travels; not
                        zero. */
    double own[SCENE_LIGHT_OWN_DOUBLES]; /**< The struct of the class; see #scene_light_own. */
    SceneOrigin origin;                  /**< The call that made it. */
} SceneLight;

/** Offset in #SceneLight of a field of the struct of a class, for its parameter table. */
#define SCENE_LIGHT_OWN_OFFSET(type, field) (offsetof(SceneLight, own) + offsetof(type, field))

/** Largest number of points of a light's outline. */
enum { SCENE_LIGHT_OUTLINE_POINTS = 5 };

/** The size of a light that can be seen. */
typedef struct SceneLightSize {
    double reach; /**< Largest distance of a glowing point from the centre, scene units; 0 where the
                       light is computed as from the centre. */
    double area;  /**< Intensity over radiance, scene units squared; 0: it is a point. */
} SceneLightSize;

typedef struct ShapeFace ShapeFace;

/** A class of lights in the description of a scene: the vtable. */
typedef struct SceneLightClass {
    const Keyword *keyword; /**< Name, fields and checks; its struct is a #SceneLight. */

    /**
     * Moves the light. NULL: all of its #PARAMETER_POINT fields are translated.
     * @param light     The light.
     * @param offset    Translation, scene units.
     * @param distance  Distance at which a light at infinity is assumed, scene units.
     */
    void (*move)(SceneLight *light, Vec3d offset, double distance);

    /**
     * Copies the position of another light of the class. NULL: all #PARAMETER_POINT fields are
     * copied.
     */
    void (*copy_position)(SceneLight *light, const SceneLight *source);

    /** @return The centre of the light, scene units. NULL: the light is at infinity. */
    Vec3d (*center)(const SceneLight *light);

    /**
     * Computes a polyline around the light, scene units; NULL: none.
     * @return The number of points, at most #SCENE_LIGHT_OUTLINE_POINTS.
     */
    size_t (*outline)(const SceneLight *light, Vec3d *points);

    /** @return The size of the light. NULL: it is never seen. */
    SceneLightSize (*size)(const SceneLight *light);

    /** @return The flat face that is seen of the light. NULL: there is none. */
    ShapeFace (*face)(const SceneLight *light);

    /** @return The vector to the light, of any length. NULL: to its #center. */
    Vec3d (*offset_from)(const SceneLight *light, Vec3d point);
} SceneLightClass;

/** The classes of lights, in the order of #SCENE_LIGHT_CLASSES, ended by NULL. */
extern const SceneLightClass *const scene_light_classes[];

/** The scene language's `light`. */
extern const Keyword scene_light_keyword;

/** @return The struct of a class in a light of that class. @param light The light. */
static inline const void *scene_light_own(const SceneLight *light) {
    return light->own;
}

/** @return The keyword of a light's class. @param light The light. */
const Keyword *scene_light_keyword_for(const SceneLight *light);

/**
 * Finds the centre of a light, for drawings.
 * @param light        The light.
 * @param[out] center  The centre, scene units.
 * @return false if the light is at infinity.
 */
bool scene_light_center(const SceneLight *light, Vec3d *center);

/**
 * Computes a polyline that shows the position of a light, for drawings.
 * @param light        The light.
 * @param[out] points  #SCENE_LIGHT_OUTLINE_POINTS of them, scene units.
 * @return The number of points; 0: the light has no outline.
 */
size_t scene_light_outline(const SceneLight *light, Vec3d *points);

/**
 * @return The vector from a point to a light, of any length.
 * @param light  The light.
 * @param point  The point, scene units.
 */
Vec3d scene_light_offset_from(const SceneLight *light, Vec3d point);

/**
 * Moves a light. A light at infinity is rotated as if it were at a given distance, so that its
 * shadows move as far as those of a light there.
 * @param[in,out] light  The light.
 * @param offset         Translation, scene units.
 * @param distance       Distance at which a light at infinity is assumed, scene units.
 */
void scene_light_move(SceneLight *light, Vec3d offset, double distance);

/**
 * Copies the position of a light; colour and size stay. Does nothing if the classes differ.
 * @param[in,out] light  The light.
 * @param source         The light whose position is copied.
 */
void scene_light_copy_position(SceneLight *light, const SceneLight *source);

/* --- Materials -------------------------------------------------------------------------------- */

/** A material. Filled through #scene_material_keyword; the model is in doc/scene-reference.md. */
typedef struct SceneMaterial {
    Rgbd color;        /**< Diffuse reflectance per channel, 0 to 1. */
    size_t texture_id; /**< Index in #Scene.textures, plus one, of the texture that multiplies the
                          colour; 0: none. */
    double ambient;    /**< Factor for the ambient light. */
    double diffuse;    /**< Factor for the diffuse reflection of each light. */
    double specular;   /**< Factor for the specular highlight of each light (Phong). */
    double shininess;  /**< Exponent of the highlight: the larger, the smaller the bright spot. */
    Rgbd reflectivity; /**< Fraction of the light that is reflected, per channel, 0 to 1. */
    Rgbd transparency; /**< Fraction that is transmitted, per channel; the sum with #reflectivity is
                          at most 1. */
    double ior;        /**< Index of refraction inside; that of air is 1. */
    Rgbd emission;     /**< Light that the surface emits, linear. */
    SceneOrigin origin; /**< The call that made it. */
} SceneMaterial;

/** The scene language's `material`. */
extern const Keyword scene_material_keyword;

/** @return Whether a material is reflective. @param material A material. */
bool scene_material_is_reflective(const SceneMaterial *material);

/** @return Whether a material is transparent. @param material A material. */
bool scene_material_is_transparent(const SceneMaterial *material);

/** @return Whether a material is reflective or transparent: secondary rays start there. @param
 * material A material. */
bool scene_material_is_secondary(const SceneMaterial *material);

/* --- Shapes ----------------------------------------------------------------------------------- */

typedef struct Scene Scene;
typedef struct SceneShape SceneShape;

/**
 * The registry: all kinds of shapes, in the order of the documentation. It defines
 * #SceneShape.class_index, #scene_shape_classes and the tracer's list of the same order.
 */
#define SHAPES(X)                                                                                  \
    X(sphere)                                                                                      \
    X(plane)                                                                                       \
    X(quad)                                                                                        \
    X(box)                                                                                         \
    X(disk)                                                                                        \
    X(cylinder)                                                                                    \
    X(cone)                                                                                        \
    X(triangle)                                                                                    \
    X(mesh)                                                                                        \
    X(sdf)

/** Parameters of `sphere`. */
typedef struct SphereParameters {
    Vec3d center;  /**< Centre. */
    double radius; /**< Radius, scene units. */
} SphereParameters;

/** Parameters of `plane`, which is infinite. */
typedef struct PlaneParameters {
    Vec3d point;  /**< A point of the plane. */
    Vec3d normal; /**< Normal, of any length. */
} PlaneParameters;

/** Parameters of `quad`, a parallelogram. */
typedef struct QuadParameters {
    Vec3d corner; /**< One corner. */
    Vec3d u;      /**< Edge to the next corner. */
    Vec3d v;      /**< Edge to the previous corner. */
} QuadParameters;

/** Parameters of `box`, whose edges are parallel to the axes. */
typedef struct BoxParameters {
    Vec3d low;  /**< Lowest corner: the field `min`. */
    Vec3d high; /**< Highest corner: the field `max`. */
} BoxParameters;

/** Parameters of `disk`, the inside of a circle. */
typedef struct DiskParameters {
    Vec3d center;  /**< Centre. */
    Vec3d normal;  /**< Normal, of any length. */
    double radius; /**< Radius, scene units. */
} DiskParameters;

/** Parameters of `cylinder`. */
typedef struct CylinderParameters {
    Vec3d base;    /**< Centre of one end. */
    Vec3d top;     /**< Centre of the other end. */
    double radius; /**< Radius, scene units. */
    bool capped;   /**< Whether two disks close the ends. */
} CylinderParameters;

/** Parameters of `cone`, pointed or a frustum. */
typedef struct ConeParameters {
    Vec3d base;        /**< Centre of one end. */
    Vec3d top;         /**< Centre of the other end. */
    double radius;     /**< Radius at the base, scene units; 0: a tip. */
    double top_radius; /**< Radius at the top, scene units; 0: a tip. */
    bool capped;       /**< Whether disks close the ends. */
} ConeParameters;

/** Parameters of `triangle`. */
typedef struct TriangleParameters {
    Vec3d corners[3]; /**< Vertices. */
    Vec3d normals[3]; /**< Normals at the vertices, of any length; used if #is_smooth. */
    Uvd uvs[3];       /**< Texture coordinates at the vertices. */
    int is_smooth;    /**< Not 0: the scene gives the normals; #Keyword.finish sets it. No bool,
                         which may hold any byte in a scene of another process. */
} TriangleParameters;

/** Source of the normals of a mesh. */
typedef enum {
    NORMALS_FROM_FILE, /**< Those of the file; smooth if it has none. */
    NORMALS_SMOOTH,    /**< Averages of the triangles around each vertex. */
    NORMALS_FLAT       /**< One normal per triangle. */
} NormalSource;

/** Number of values of #NormalSource. */
enum { NORMAL_SOURCE_COUNT = 3 };

/** Parameters of `mesh`. */
typedef struct MeshShapeParameters {
    size_t file; /**< Index of the mesh file in #Scene.meshes. */
    int normals; /**< A #NormalSource. */
} MeshShapeParameters;

/** Parameters of `sdf`, the surface of a distance field. */
typedef struct SdfShapeParameters {
    const Sdf *field; /**< Distance field; owned by the scene. */
    double tolerance; /**< Distance from the surface that counts as a hit, scene units. */
    int max_steps;    /**< Largest number of steps per ray. */
} SdfShapeParameters;

/** Properties of a shape that follow from its description, without a tracer. */
typedef struct ShapeFacts {
    Aabbd bounds;      /**< Bounding box; infinite along the axes where the shape is unbounded. */
    bool is_flat;      /**< Whether all faces are flat: reflections do not make rays diverge. */
    const Mesh *mesh;  /**< Its triangles; NULL: no mesh, or not read yet. */
    bool is_smooth;    /**< Whether #mesh is shaded with interpolated normals. */
    const Sdf *sdf;    /**< Its distance field; NULL: none. */
    double tolerance;  /**< For #sdf: distance that counts as a hit, scene units. */
    double ray_growth; /**< Factor per turn by which the distance of two rays grows that are totally
                            reflected in the solid, at most; 0: paths in it are regular, as in
                            balls, boxes and cylinders, and rays part slowly. */
} ShapeFacts;

/** Largest number of flat faces of a shape that is no mesh. */
enum { SHAPE_FACES_MAXIMUM = 6 };

/** Largest number of corners of a flat face. A disk is given as an octagon of the same area. */
enum { FACE_CORNERS_MAXIMUM = 8 };

/** A flat face of a shape: a convex polygon, or a whole plane. */
struct ShapeFace {
    Vec3d corners[FACE_CORNERS_MAXIMUM]; /**< Corners in turn; of a plane, one of its points. */
    int corner_count;                    /**< Number of #corners; 1: a whole plane. */
    Vec3d normal;                        /**< Unit normal; outwards on a solid. */
    bool is_solid; /**< Whether the face is seen from outside only: a solid is behind it. */
};

/** The curved surface of a sphere, or of a cylinder or cone. */
typedef struct ShapeShell {
    Vec3d base;        /**< Centre of a sphere, or of one end of a cylinder. */
    Vec3d top;         /**< The same of a sphere, or the centre of the other end. */
    double radius;     /**< Radius at the base, scene units. */
    double top_radius; /**< Radius at the top. */
} ShapeShell;

/** Description of a kind of shape. */
typedef struct SceneShapeClass {
    Keyword keyword; /**< Base: name, fields, defaults and checks in the scene language. */

    /**
     * Finds the properties of a shape before its transform.
     * @param parameters  The struct that #keyword describes, finished.
     * @param scene       The scene of the shape, for its meshes.
     * @return The properties.
     */
    ShapeFacts (*facts)(const void *parameters, const Scene *scene);

    /**
     * Multiplies the tolerance of sphere tracing, within the range of its field. NULL: shapes of
     * this kind have none.
     * @param[in,out] parameters  The struct that #keyword describes, finished.
     * @param factor              Factor, above 0.
     */
    void (*scale_tolerance)(void *parameters, double factor);

    /**
     * @return A lower bound of the distance of a point from the surface before its transform; that
     *         of the bounding box is known. NULL: none is known inside of the box.
     * @param parameters  The struct that #keyword describes, finished.
     * @param scene       The scene of the shape, for its meshes.
     * @param point       The point.
     */
    double (*distance)(const void *parameters, const Scene *scene, Vec3d point);

    /**
     * Lists the flat faces before the transform. NULL: there are none, or the shape is a mesh.
     * @param parameters  The struct that #keyword describes, finished.
     * @param[out] faces  #SHAPE_FACES_MAXIMUM faces.
     * @return Their number.
     */
    size_t (*faces)(const void *parameters, ShapeFace *faces);

    /** @return The curved surface before the transform. NULL: none, or none of #ShapeShell.
     *  @param parameters The struct that #keyword describes, finished. */
    ShapeShell (*shell)(const void *parameters);
} SceneShapeClass;

/** Descriptions of all kinds of shapes in the order of #SHAPES; NULL ends the list. */
extern const SceneShapeClass *const scene_shape_classes[];

/** Keywords of #scene_shape_classes in the same order; NULL ends the list. */
extern const Keyword *const scene_shape_keywords[];

/**
 * Finds a kind of shape by its keyword.
 * @param name  The keyword, such as `sphere`.
 * @return Its index in #scene_shape_classes; that of the final NULL if there is no such kind.
 */
size_t scene_shape_find(const char *name);

/**
 * Finds the properties of a shape of a scene.
 * @param scene  The scene.
 * @param shape  One of its shapes.
 * @return The properties; the bounding box is that of the transformed shape.
 */
ShapeFacts scene_shape_facts(const Scene *scene, const SceneShape *shape);

/**
 * Lists the flat faces of a shape of a scene, in the scene.
 * @param shape       The shape.
 * @param[out] faces  #SHAPE_FACES_MAXIMUM faces.
 * @return Their number; 0 for a mesh.
 */
size_t scene_shape_faces(const SceneShape *shape, ShapeFace *faces);

/**
 * @return A lower bound of the distance of a point from the surface of a shape.
 * @param scene  The scene.
 * @param shape  One of its shapes.
 * @param point  The point.
 */
double scene_shape_distance(const Scene *scene, const SceneShape *shape, Vec3d point);

/** @return The largest texel of a texture in linear light. @param texture The texture. */
double texture_peak(const Texture *texture);

/**
 * @return An upper bound of the radiance along any ray of a scene (see doc/cutoff.md).
 * @param scene          The scene.
 * @param texture_peaks  The #texture_peak of each of its textures.
 */
double scene_radiance_bound(const Scene *scene, const double *texture_peaks);

/**
 * Finds the bounding box of all bounded shapes of a scene.
 * @param scene  The scene.
 * @return The box; its lowest corner is above its highest one if no shape is bounded.
 */
Aabbd scene_bounds(const Scene *scene);

/**
 * Finds the origin for the coordinates of a tracer.
 *
 * A float is exact to 1 / 2^24 of its value. At a distance of 10,000 from zero, coordinates are
 * wrong by up to a thousandth. The scene file gives them in double, which is enough. Tracers
 * therefore use coordinates relative to the middle of the shapes if it is far away.
 * @param scene  The scene.
 * @return The middle of all bounded shapes, rounded to few digits, if it is much farther from zero
 *         than the shapes are large; else zero.
 */
Vec3d scene_local_origin(const Scene *scene);

/**
 * @return Half the bounding box of a circle: radius * sqrt(1 - n_i^2) along each axis i, computed
 *         from the other two components, because 1 - n_i^2 would cancel.
 * @param normal  Unit normal of the plane of the circle.
 * @param radius  Radius, scene units.
 */
static inline Vec3d circle_extent(Vec3d normal, double radius) {
    double x = normal.x, y = normal.y, z = normal.z;
    return (Vec3d){radius * sqrt(y * y + z * z), radius * sqrt(z * z + x * x),
                   radius * sqrt(x * x + y * y)};
}

/** @return The bounding box of a cone. @param axis Unit vector along it. */
static inline Aabbd cone_bounds_of(const ConeParameters *cone, Vec3d axis) {
    Vec3d at_base = circle_extent(axis, cone->radius);
    Vec3d at_top = circle_extent(axis, cone->top_radius);
    return (Aabbd){
        vec3d_min(vec3d_subtract(cone->base, at_base), vec3d_subtract(cone->top, at_top)),
        vec3d_max(vec3d_add(cone->base, at_base), vec3d_add(cone->top, at_top))};
}

/* --- Offset strategies ------------------------------------------------------------------------ */

/** Distance from a surface at which secondary rays start. */
typedef enum {
    OFFSET_NONE,  /**< At the hit point: shows shadow acne. */
    OFFSET_FIXED, /**< At a constant distance from it. */
    OFFSET_BOUND  /**< At the error bound of the hit point: the default. */
} OffsetStrategy;

/** The names, in the order of #OffsetStrategy; ended by NULL. */
extern const char *const offset_strategy_names[];

/* --- The scene -------------------------------------------------------------------------------- */

/** Largest width and height of an image, in pixels. */
enum { IMAGE_SIZE_MAXIMUM = 16384 };
/** Largest number of samples per pixel. */
enum { SAMPLES_MAXIMUM = 65536 };
/** Largest recursion depth: a guard for the stack. */
enum { DEPTH_MAXIMUM = 256 };
/**
 * Default of #SceneImage.depth: until a ray cannot change the image (see
 * render/precision_estimate.h).
 */
enum { IMAGE_DEPTH_AUTO = -1 };

/**
 * Default of #SceneImage.cutoff, 8-bit steps: with half a step of rounding, a pixel of the encoded
 * picture is never off by more than one.
 */
#define CUTOFF_DEFAULT 0.25

/** Largest #SceneImage.cutoff, 8-bit steps: from black to white. */
#define CUTOFF_MAXIMUM 255

/** Size and quality of the image. Filled through #scene_image_keyword. */
typedef struct SceneImage {
    int width;     /**< Pixels, 1 to #IMAGE_SIZE_MAXIMUM. */
    int height;    /**< Pixels, 1 to #IMAGE_SIZE_MAXIMUM. */
    int encoding;  /**< An #Encoding. */
    int samples;   /**< Samples per pixel, 1 to #SAMPLES_MAXIMUM. */
    int depth;     /**< Recursion depth, 0 to #DEPTH_MAXIMUM, or #IMAGE_DEPTH_AUTO. */
    double cutoff; /**< See #TraceSettings.cutoff; 0 to #CUTOFF_MAXIMUM. */
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
    SceneOrigin origin;         /**< The call that made it; in NFF only its line is known. */
} SceneShape;

/** A file that a scene names; one per file, however often the scene names it. */
typedef struct SceneFile {
    const char *path;     /**< Absolute path without links. */
    const char *name;     /**< Name in the scene. */
    const char *location; /**< `FILE:LINE` of its first use, the prefix of errors about it. */
    dev_t device;         /**< With #inode: which file it is, by whatever name; 0 until opened. */
    ino_t inode;          /**< See #device. */
} SceneFile;

/** A mesh file that a scene names. */
typedef struct SceneMesh {
    SceneFile file;    /**< The file. */
    Mesh *mesh;        /**< Its content, retained. NULL until it is read, after the run of the scene
                            file. */
    const Mesh *built; /**< In the block of the scene: the content, if the scene file itself has the
                          triangles. NULL: #file has them. */
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
    SceneImage image;       /**< Size and quality of the image. */
    Rgbd ambient;           /**< Ambient light. */
    SceneSky sky;           /**< Background. */
    SceneLight *lights;     /**< Lights. */
    size_t light_count;     /**< Number of lights. */
    SceneMaterial
        *materials; /**< Materials; the first, diffuse white, is that of shapes without one. */
    size_t material_count;  /**< Number of materials, at least 1. */
    SceneShape *shapes;     /**< Shapes. */
    size_t shape_count;     /**< Number of shapes. */
    SceneMesh *meshes;      /**< Meshes of the shapes. */
    size_t mesh_count;      /**< Number of meshes. */
    SceneTexture *textures; /**< Textures of materials and sky. */
    size_t texture_count;   /**< Number of textures. */
    const char **notes;     /**< What its author should know, as `FILE:LINE: text`. */
    size_t note_count;      /**< Number of notes. */
} Scene;

/**
 * Creates an empty scene: no shape, no light, a black sky, one diffuse white material, no camera.
 * @param[out] error  What is wrong.
 * @return The scene, to be freed with #scene_destroy; NULL without memory.
 */
Scene *scene_create(Error *error);

/**
 * Creates an empty scene at a given address, in a worker process.
 * @param address     The address.
 * @param[out] error  What is wrong.
 * @return The scene; NULL if the address is not free.
 */
Scene *scene_create_at(void *address, Error *error);

/**
 * Checks every pointer, index, number and flag of a scene that another process has made: a
 * stranger's file may have got hold of it. No two arrays share memory, so what changes later
 * changes nothing else.
 * @param[in,out] scene  The scene, at the address where it was made; its arrays are closed.
 * @param size           Bytes that the process sent.
 * @param keywords       Keywords of the classes of shapes; NULL ends them.
 * @param[out] error     What is wrong (#STATUS_SCENE).
 * @return Whether it is valid; if not, it has no meshes and textures.
 */
bool scene_validate(Scene *scene, size_t size, const Keyword *const *keywords, Error *error);

/**
 * @return Bytes in use of the block of a scene, all that another process needs.
 * @param scene  The scene.
 */
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
 * Adds a mesh whose triangles the scene file itself contains.
 * @param[in,out] scene  The scene.
 * @param file           A name for it, which no other mesh has; its strings are copied.
 * @param counts         The numbers of all items, and the repairs; the rest is not read.
 * @param[out] index     Its index in #Scene.meshes.
 * @param[out] error     What is wrong.
 * @return The mesh in the block of the scene, its arrays not filled; NULL when the block is full.
 */
Mesh *scene_add_built_mesh(Scene *scene, const SceneFile *file, const Mesh *counts, size_t *index,
                           Error *error);

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
 * Adds a note for the author of the scene.
 * @param[in,out] scene  The scene.
 * @param note           `FILE:LINE: text`; copied.
 * @param[out] error     What is wrong.
 * @return false when the scene's memory is full.
 */
bool scene_add_note(Scene *scene, const char *note, Error *error);

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

/** @return Whether any shape is reflective or transparent. @param scene The scene. */
bool scene_has_secondary_rays(const Scene *scene);

/**
 * Bytes reserved for the block of a scene; the system provides memory only where it is filled. It
 * holds a million spheres, and limits scene files that never stop.
 */
#ifndef SCENE_MEMORY_SIZE // A page has less: src/web/memory.h.
#define SCENE_MEMORY_SIZE ((size_t)256 << 20)
#endif

#endif
