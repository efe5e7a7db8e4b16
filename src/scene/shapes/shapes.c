/**
 * @file
 * @brief The list of all kinds of shapes, and the bounds of a scene.
 */
#include "dioptre/scene.h"

#include <string.h>

/** Ratio of distance and size of a scene above which tracers move their origin: its coordinates
 *  then share their two leading bits. */
#define REBASE_MIN_SIZES 4

/**
 * The new origin is a multiple of a power of two, at most this fraction of the size. It has few
 * digits, so that differences to it are exact in double.
 */
#define REBASE_SIZE_GRAINS 8

/** Declares a description, which its own file defines. */
#define DECLARE_SHAPE(name) extern const SceneShapeClass scene_##name##_class;
SHAPES(DECLARE_SHAPE)

/** An entry of #scene_shape_classes. */
#define LIST_CLASS(name) &scene_##name##_class,
const SceneShapeClass *const scene_shape_classes[] = {SHAPES(LIST_CLASS) NULL};

/** An entry of #scene_shape_keywords. */
#define LIST_KEYWORD(name) &scene_##name##_class.keyword,
const Keyword *const scene_shape_keywords[] = {SHAPES(LIST_KEYWORD) NULL};

size_t scene_shape_find(const char *name) {
    size_t index = 0;
    while (scene_shape_keywords[index] && strcmp(scene_shape_keywords[index]->name, name) != 0) {
        index++;
    }
    return index;
}

/** @return The bounding box of a transformed box, which must be bounded. */
static Aabbd aabbd_transform(const Transform *transform, Aabbd box) {
    Aabbd transformed = aabbd_empty();
    for (int corner = 0; corner < 8; corner++) {
        Vec3d point = {corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                       corner & 4 ? box.high.z : box.low.z};
        transformed = aabbd_add_point(transformed, transform_point(transform, point));
    }
    return transformed;
}

ShapeFacts scene_shape_facts(const Scene *scene, const SceneShape *shape) {
    ShapeFacts facts = scene_shape_classes[shape->class_index]->facts(shape->parameters, scene);
    if (shape->transform && aabbd_is_bounded(facts.bounds)) {
        facts.bounds = aabbd_transform(shape->transform, facts.bounds);
    }
    return facts;
}

/** @return A transformed vector, which is no point: without the translation. */
static Vec3d transform_vector(const Transform *transform, Vec3d v) {
    const double(*m)[3] = transform->matrix;
    return (Vec3d){m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z,
                   m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
                   m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

/** @return Whether a transform is a reflection. */
static bool transform_is_reflection(const Transform *transform) {
    return transform->scale.x * transform->scale.y * transform->scale.z < 0;
}

/** @return The normal of a transformed plane: perpendicular to two of its transformed vectors. */
static Vec3d transform_normal(const Transform *transform, Vec3d normal) {
    Vec3d aside = fabs(normal.x) < 0.5 ? (Vec3d){1, 0, 0} : (Vec3d){0, 1, 0};
    Vec3d right = vec3d_cross(normal, aside), up = vec3d_cross(normal, right);
    Vec3d transformed =
        vec3d_cross(transform_vector(transform, right), transform_vector(transform, up));
    return vec3d_scale(vec3d_normalize(transformed), transform_is_reflection(transform) ? -1 : 1);
}

size_t scene_shape_faces(const SceneShape *shape, ShapeFace *faces) {
    const SceneShapeClass *class = scene_shape_classes[shape->class_index];
    size_t count = class->faces ? class->faces(shape->parameters, faces) : 0;
    for (size_t i = 0; shape->transform && i < count; i++) {
        faces[i].normal = transform_normal(shape->transform, faces[i].normal);
        for (int k = 0; k < faces[i].corner_count; k++) {
            faces[i].corners[k] = transform_point(shape->transform, faces[i].corners[k]);
        }
    }
    return count;
}

Aabbd scene_bounds(const Scene *scene) {
    Aabbd bounds = aabbd_empty();
    for (size_t i = 0; i < scene->shape_count; i++) {
        Aabbd box = scene_shape_facts(scene, &scene->shapes[i]).bounds;
        if (aabbd_is_bounded(box)) {
            bounds = aabbd_add_point(aabbd_add_point(bounds, box.low), box.high);
        }
    }
    return bounds;
}

/** @return The nearest multiple of a number. */
static double nearest_multiple(double x, double grain) {
    return floor(x / grain + 0.5) * grain;
}

Vec3d scene_local_origin(const Scene *scene) {
    Aabbd bounds = scene_bounds(scene);
    double size = vec3d_max_abs(vec3d_subtract(bounds.high, bounds.low));
    Vec3d center = vec3d_scale(vec3d_add(bounds.low, bounds.high), 0.5);
    // False also if no shape is bounded: the centre is then not a number.
    if (!(vec3d_max_abs(center) > REBASE_MIN_SIZES * size)) {
        return (Vec3d){0, 0, 0};
    }
    int exponent;
    frexp(size / REBASE_SIZE_GRAINS, &exponent);
    double grain = ldexp(0.5, exponent);
    return (Vec3d){nearest_multiple(center.x, grain), nearest_multiple(center.y, grain),
                   nearest_multiple(center.z, grain)};
}
