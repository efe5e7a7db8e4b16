/**
 * @file
 * @brief `cylinder_light`: a light with the shape of a cylinder.
 */
#include "scene/lights/cylinder_light.h"

#include "scene/lights/light_rows.h"

_Static_assert(sizeof(CylinderLightFields) <= SCENE_LIGHT_OWN_DOUBLES * sizeof(double),
               "the fields of a cylinder light must fit into a light");

/** Fields of `cylinder_light`. */
static const Parameter cylinder_light_parameters[] = {
    LIGHT_LENGTH_ROW("base", PARAMETER_POINT, offsetof(SceneLight, position), -LENGTH_MAXIMUM,
                     N_("centre of one end")),
    LIGHT_LENGTH_ROW("top", PARAMETER_POINT, SCENE_LIGHT_OWN_OFFSET(CylinderLightFields, top),
                     -LENGTH_MAXIMUM, N_("centre of the other end")),
    LIGHT_LENGTH_ROW("radius", PARAMETER_NUMBER, offsetof(SceneLight, radius), LENGTH_MINIMUM,
                     N_("its radius")),
    LIGHT_COLOR_ROW,
    LIGHT_INTENSITY_ROW,
    LIGHT_FALLOFF_ROW,
    LIGHT_FALLOFF_CONSTANT_ROW,
    {0}};

/** A white cylinder of length 1, just under a ceiling at height 2. */
static const SceneLight cylinder_light_defaults = {.color = {1, 1, 1},
                                                   .intensity = 1,
                                                   .falloff = FALLOFF_NONE,
                                                   .falloff_constant = LIGHT_FALLOFF_CONSTANT,
                                                   .position = {-0.5, 1.9, 0},
                                                   .radius = 0.05,
                                                   .own = {0.5, 1.9, 0}};

/** Rejects cylinders without length. See #Keyword.finish. @return Whether it has a length. */
static bool cylinder_light_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const SceneLight *light = values;
    const CylinderLightFields *own = scene_light_own(light);
    return vec3d_length(vec3d_subtract(own->top, light->position)) >= LENGTH_MINIMUM ||
           error_set(error, STATUS_SCENE,
                     "cylinder_light has no length: base and top are the same");
}

/** The scene language's `cylinder_light`. */
static const Keyword cylinder_light_keyword = {.name = "cylinder_light",
                                               .help = "a lamp: a glowing tube",
                                               .parameters = cylinder_light_parameters,
                                               .size = sizeof(SceneLight),
                                               .defaults = &cylinder_light_defaults,
                                               .finish = cylinder_light_finish};

/** @return The centre of the axis. See #SceneLightClass.center. */
static Vec3d cylinder_light_center(const SceneLight *light) {
    const CylinderLightFields *own = scene_light_own(light);
    return vec3d_scale(vec3d_add(light->position, own->top), 0.5);
}

/** Fills in the axis. See #SceneLightClass.outline. @return Number of points. */
static size_t cylinder_light_outline(const SceneLight *light, Vec3d *points) {
    points[0] = light->position;
    points[1] = ((const CylinderLightFields *)scene_light_own(light))->top;
    return 2;
}

/** @return The size of a cylinder light. See #SceneLightClass.size. */
static SceneLightSize cylinder_light_size(const SceneLight *light) {
    const CylinderLightFields *own = scene_light_own(light);
    double length = vec3d_length(vec3d_subtract(own->top, light->position));
    return (SceneLightSize){hypot(length / 2, light->radius), 2 * light->radius * length};
}

/** The class of `cylinder_light`. */
extern const SceneLightClass scene_cylinder_light_class;

const SceneLightClass scene_cylinder_light_class = {.keyword = &cylinder_light_keyword,
                                                    .center = cylinder_light_center,
                                                    .size = cylinder_light_size,
                                                    .outline = cylinder_light_outline};
