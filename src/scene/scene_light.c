/**
 * @file
 * @brief Lights of any class.
 */
#include "dioptre/scene.h"

/** Declares a class of the registry. */
#define DECLARE_CLASS(name) extern const SceneLightClass scene_##name##_class;
SCENE_LIGHT_CLASSES(DECLARE_CLASS)

/** The address of a class of the registry. */
#define CLASS_ADDRESS(name) &scene_##name##_class,
const SceneLightClass *const scene_light_classes[] = {SCENE_LIGHT_CLASSES(CLASS_ADDRESS) NULL};

/** @return The class of a light. */
static const SceneLightClass *scene_light_class(const SceneLight *light) {
    return scene_light_classes[light->class_index];
}

const Keyword *scene_light_keyword_for(const SceneLight *light) {
    return scene_light_class(light)->keyword;
}

bool scene_light_center(const SceneLight *light, Vec3d *center) {
    const SceneLightClass *class = scene_light_class(light);
    if (class->center) {
        *center = class->center(light);
    }
    return class->center != NULL;
}

size_t scene_light_outline(const SceneLight *light, Vec3d *points) {
    const SceneLightClass *class = scene_light_class(light);
    return class->outline ? class->outline(light, points) : 0;
}

Vec3d scene_light_offset_from(const SceneLight *light, Vec3d point) {
    const SceneLightClass *class = scene_light_class(light);
    return class->offset_from ? class->offset_from(light, point)
                              : vec3d_subtract(class->center(light), point);
}

void scene_light_move(SceneLight *light, Vec3d offset, double distance) {
    const SceneLightClass *class = scene_light_class(light);
    if (class->move) {
        class->move(light, offset, distance);
    } else {
        keyword_translate(class->keyword, light, offset);
    }
}

/** Copies all points of a light. See #SceneLightClass.copy_position. */
static void copy_points(SceneLight *light, const SceneLight *source) {
    for (const Parameter *row = scene_light_keyword_for(light)->parameters; row->name; row++) {
        if (row->type == PARAMETER_POINT) {
            *(Vec3d *)((char *)light + row->offset) =
                *(const Vec3d *)((const char *)source + row->offset);
        }
    }
}

void scene_light_copy_position(SceneLight *light, const SceneLight *source) {
    const SceneLightClass *class = scene_light_class(light);
    if (class == scene_light_class(source)) {
        (class->copy_position ? class->copy_position : copy_points)(light, source);
    }
}
