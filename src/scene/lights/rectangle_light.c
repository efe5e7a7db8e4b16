/**
 * @file
 * @brief `rectangle_light`: a parallelogram that emits light on one side or on both.
 */
#include "scene/lights/rectangle_light.h"

#include "scene/lights/light_rows.h"

_Static_assert(sizeof(RectangleLightFields) <= SCENE_LIGHT_OWN_DOUBLES * sizeof(double),
               "the fields of a rectangle light must fit into a light");

/** Fields of `rectangle_light`. */
static const Parameter rectangle_light_parameters[] = {
    LIGHT_LENGTH_ROW("corner", PARAMETER_POINT, offsetof(SceneLight, position), -LENGTH_MAXIMUM,
                     N_("one corner")),
    LIGHT_LENGTH_ROW("u", PARAMETER_DIRECTION, SCENE_LIGHT_OWN_OFFSET(RectangleLightFields, u),
                     -LENGTH_MAXIMUM, N_("from it to the next corner")),
    LIGHT_LENGTH_ROW("v", PARAMETER_DIRECTION, SCENE_LIGHT_OWN_OFFSET(RectangleLightFields, v),
                     -LENGTH_MAXIMUM, N_("from it to the corner on the other side")),
    {.name = "two_sided",
     .type = PARAMETER_BOOLEAN,
     .offset = SCENE_LIGHT_OWN_OFFSET(RectangleLightFields, two_sided),
     .unit = N_("yes or no"),
     .help = N_("whether it glows on both sides; else on that of u × v")},
    LIGHT_COLOR_ROW,
    LIGHT_INTENSITY_ROW,
    LIGHT_FALLOFF_ROW,
    LIGHT_FALLOFF_CONSTANT_ROW,
    {0}};

/** A white square of side 1, just under a ceiling at height 2, that emits downwards. */
static const SceneLight rectangle_light_defaults = {.color = {1, 1, 1},
                                                    .intensity = 1,
                                                    .falloff = FALLOFF_NONE,
                                                    .falloff_constant = LIGHT_FALLOFF_CONSTANT,
                                                    .position = {-0.5, 1.9, -0.5},
                                                    .own = {1, 0, 0, 0, 0, 1}};

/** Rejects rectangles without area. See #Keyword.finish. @return Whether it has an area. */
static bool rectangle_light_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const RectangleLightFields *own = scene_light_own(values);
    /**
     * Sine of the angle below which two edges count as parallel: double cannot resolve smaller
     * ones.
     */
    const double parallel = 1e-12;
    Vec3d normal = vec3d_cross(vec3d_normalize(own->u), vec3d_normalize(own->v));
    return vec3d_length(normal) > parallel ||
           error_set(error, STATUS_SCENE, "rectangle_light has no area: u and v are parallel");
}

/** The scene language's `rectangle_light`. */
static const Keyword rectangle_light_keyword = {.name = "rectangle_light",
                                                .help = "a lamp: a glowing rectangle",
                                                .parameters = rectangle_light_parameters,
                                                .size = sizeof(SceneLight),
                                                .defaults = &rectangle_light_defaults,
                                                .finish = rectangle_light_finish};

/** @return The centre. See #SceneLightClass.center. */
static Vec3d rectangle_light_center(const SceneLight *light) {
    const RectangleLightFields *own = scene_light_own(light);
    return vec3d_add(light->position, vec3d_scale(vec3d_add(own->u, own->v), 0.5));
}

/** Fills in the edges. See #SceneLightClass.outline. @return Number of points. */
static size_t rectangle_light_outline(const SceneLight *light, Vec3d *points) {
    const RectangleLightFields *own = scene_light_own(light);
    points[0] = points[4] = light->position;
    points[1] = vec3d_add(light->position, own->u);
    points[2] = vec3d_add(points[1], own->v);
    points[3] = vec3d_add(light->position, own->v);
    return 5;
}

/** @return The size of a rectangle light. See #SceneLightClass.size. */
static SceneLightSize rectangle_light_size(const SceneLight *light) {
    const RectangleLightFields *own = scene_light_own(light);
    double diagonal =
        fmax(vec3d_length(vec3d_add(own->u, own->v)), vec3d_length(vec3d_subtract(own->u, own->v)));
    return (SceneLightSize){diagonal / 2, vec3d_length(vec3d_cross(own->u, own->v))};
}

/** @return The rectangle. See #SceneLightClass.face. */
static ShapeFace rectangle_light_face(const SceneLight *light) {
    const RectangleLightFields *own = scene_light_own(light);
    Vec3d corner = light->position, next = vec3d_add(corner, own->u);
    return (ShapeFace){
        .corners = {corner, next, vec3d_add(next, own->v), vec3d_add(corner, own->v)},
        .corner_count = 4,
        .normal = vec3d_normalize(vec3d_cross(own->u, own->v)),
        .is_solid = !own->two_sided};
}

/** The class of `rectangle_light`. */
extern const SceneLightClass scene_rectangle_light_class;

const SceneLightClass scene_rectangle_light_class = {.keyword = &rectangle_light_keyword,
                                                     .center = rectangle_light_center,
                                                     .size = rectangle_light_size,
                                                     .outline = rectangle_light_outline,
                                                     .face = rectangle_light_face};
