/**
 * @file
 * @brief Lights: what a scene says of them, and the classes of lights.
 *
 * A new kind of light is one line in #SCENE_LIGHT_CLASSES, one file in `scene/lights/` for its
 * fields, one file in `trace/lights/` for its samples, one row in the contract test and one scene.
 */
#ifndef DIOPTRE_LIGHT_H
#define DIOPTRE_LIGHT_H

#include "dioptre/parameter.h"

/**
 * The registry: one line per class of lights. `CLASS(x)` stands for `scene_x_class`, a
 * #SceneLightClass, and in each engine for `x_class`, a LightClass.
 */
#define SCENE_LIGHT_CLASSES(CLASS)                                                                 \
    CLASS(point_light)                                                                             \
    CLASS(sun)                                                                                     \
    CLASS(rectangle_light)                                                                         \
    CLASS(cylinder_light)

/** How light decreases with the distance. */
typedef enum {
    FALLOFF_NONE,          /**< Not at all. */
    FALLOFF_INVERSE_SQUARE /**< With the square of the distance. */
} Falloff;

/** Doubles that a class may store in a light besides the common fields. */
enum { SCENE_LIGHT_OWN_DOUBLES = 8 };

/** A light of a scene, of any class. Filled through #SceneLightClass.keyword. */
typedef struct SceneLight {
    size_t class_index; /**< Index in #scene_light_classes; 0 is the point light. */
    Rgbd color;         /**< Linear colour. */
    double intensity;   /**< Multiplies the colour. */
    int falloff;        /**< A #Falloff; lights at infinity have none. */
    Vec3d position;     /**< Centre, corner or base, scene units; not of lights at infinity. */
    double radius;      /**< Of round lights, scene units; 0: a point. */
    Vec3d direction;    /**< Of lights at infinity: where the light travels; not zero. */
    double own[SCENE_LIGHT_OWN_DOUBLES]; /**< The class's own struct; see #scene_light_own. */
} SceneLight;

/** Offset in #SceneLight of a field of a class's own struct, for its parameter table. */
#define SCENE_LIGHT_OWN_OFFSET(type, field) (offsetof(SceneLight, own) + offsetof(type, field))

/** A class of lights, as a scene sees it: the vtable. */
typedef struct SceneLightClass {
    const Keyword *keyword; /**< Name, fields and checks; its struct is a #SceneLight. */

    /**
     * Moves the light. NULL: all of its points move.
     * @param offset    Scene units.
     * @param distance  Distance at which a light at infinity is assumed, scene units.
     */
    void (*move)(SceneLight *light, Vec3d offset, double distance);

    /** Puts the light where another one of its class is. NULL: all points are copied. */
    void (*copy_position)(SceneLight *light, const SceneLight *source);

    /** @return The middle of the light, scene units. NULL: the light is at infinity. */
    Vec3d (*center)(const SceneLight *light);

    /** @return The vector to the light, of any length. NULL: to its #center. */
    Vec3d (*offset_from)(const SceneLight *light, Vec3d point);
} SceneLightClass;

/** The classes of lights, in the order of #SCENE_LIGHT_CLASSES, ended by NULL. */
extern const SceneLightClass *const scene_light_classes[];

/** The scene language's `light`. */
extern const Keyword scene_light_keyword;

/** @return A class's own struct in a light of that class. */
static inline const void *scene_light_own(const SceneLight *light) {
    return light->own;
}

/** @return The keyword of a light's class. @param light The light. */
const Keyword *scene_light_keyword_for(const SceneLight *light);

/**
 * Finds the middle of a light, for drawings.
 * @param light        The light.
 * @param[out] center  The middle, scene units.
 * @return false if the light is at infinity.
 */
bool scene_light_center(const SceneLight *light, Vec3d *center);

/**
 * @return The vector from a point to a light, of any length.
 * @param light  The light.
 * @param point  The point, scene units.
 */
Vec3d scene_light_offset_from(const SceneLight *light, Vec3d point);

/**
 * Moves a light. A light at infinity turns as though it were at a distance, so that the same
 * movement moves its shadows alike.
 * @param[in,out] light  The light.
 * @param offset         Scene units.
 * @param distance       Distance at which a light at infinity is assumed, scene units.
 */
void scene_light_move(SceneLight *light, Vec3d offset, double distance);

/**
 * Puts a light where another one is; its colour and size stay. Does nothing if the classes differ.
 * @param[in,out] light  The light.
 * @param source         The other one.
 */
void scene_light_copy_position(SceneLight *light, const SceneLight *source);

#endif
