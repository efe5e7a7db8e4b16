/**
 * @file
 * @brief Which transparent shapes rays are inside of.
 */
#include "trace/media.h"

#include <stdlib.h>

/** Takes the indices of a scene's shapes. @param[out] glass What the scene has. @param scene The
 *  scene. @return false without memory. */
static bool indices_take(Glass *glass, const Scene *scene) {
    glass->indices = calloc(scene->shape_count + 1, sizeof *glass->indices);
    if (!glass->indices) {
        return false;
    }
    glass->indices[0] = 1;
    for (size_t i = 0; i < scene->shape_count; i++) {
        const Material *material = &scene->materials[scene->shapes[i].material];
        bool is_glass = material_is_transparent(material);
        glass->indices[i + 1] = is_glass ? (scalar)material->ior : 0;
    }
    return true;
}

/** See #ShapeChoice. @return Whether a shape is transparent. @param shape The shape. @param context
 *  A #Glass. */
static bool is_clear(const Shape *shape, const void *context) {
    const Glass *glass = context;
    return glass->indices[shape->place + 1] > 0;
}

/** See #ShapeChoice. @return Whether a shape is not transparent. @param shape The shape.
 *  @param context A #Glass. */
static bool is_opaque(const Shape *shape, const void *context) {
    return !is_clear(shape, context);
}

bool glass_init(Glass *glass, const Scene *scene, const ShapeList *list,
                const TraceSettings *settings) {
    *glass = (Glass){.at_eye = media_air()};
    return !scene_has_glass(scene) ||
           (indices_take(glass, scene) &&
            shape_list_choose(&glass->clear, list, is_clear, glass, settings) &&
            shape_list_choose(&glass->opaque, list, is_opaque, glass, settings));
}

/** Tinted shapes from which on nobody looks whether a later shape meets them: one may. */
enum { SURVEY_MAXIMUM = 1000 };

/** @return Whether two boxes have a point in common. @param a A box. @param b Another. */
static bool bounds_meet(const Bounds *a, const Bounds *b) {
    bool meet = true;
    for (int axis = 0; axis < 3; axis++) {
        meet = meet && a->low[axis] <= b->high[axis] && b->low[axis] <= a->high[axis];
    }
    return meet;
}

/** @return Whether a surface takes a share of the light that goes through. @param s The surface. */
static bool is_tinted(const Surface *s) {
    return s->through.red < 1 || s->through.green < 1 || s->through.blue < 1;
}

void glass_survey(Glass *glass, const Surface *surfaces) {
    Bounds tinted[SURVEY_MAXIMUM];
    size_t count = 0;
    for (size_t i = 0; !glass->hides && i < glass->clear.count; i++) {
        const Shape *shape = glass->clear.shapes[i];
        Bounds box = shape->class->bounds(shape);
        for (size_t other = 0; other < count; other++) {
            glass->hides = glass->hides || bounds_meet(&tinted[other], &box);
        }
        if (is_tinted(&surfaces[shape->material])) {
            tinted[count++] = box;
            glass->hides = glass->hides || count == SURVEY_MAXIMUM;
        }
    }
}

void glass_release(Glass *glass) {
    free(glass->indices);
    glass->indices = NULL;
    shape_list_release(&glass->clear);
    shape_list_release(&glass->opaque);
}

/** @return The lanes in which rays meet a shape from inside. @param ray The rays. @param met The
 *  lanes that meet it. @param hit Where. */
INLINE mask is_from_inside(const Ray *ray, mask met, const Hit *hit) {
    return met & (vector_dot(ray->direction, hit->normal) > 0);
}

/* --- the camera ------------------------------------------------------------------------------ */

/** @return Rays along an axis. @param origin Where they start. @param axis 0 to 5: x, y, z, -x, -y,
 *  -z. */
static Ray axis_ray(Vector origin, int axis) {
    real along = real_of(axis < 3 ? 1 : -1), zero = real_of(0);
    Vector direction = {axis % 3 == 0 ? along : zero, axis % 3 == 1 ? along : zero,
                        axis % 3 == 2 ? along : zero};
    return ray_of(origin, direction);
}

/** @return Whether a point is inside of a shape. @param shape The shape. @param point The point. */
static mask is_inside(const Shape *shape, Vector point) {
    mask inside = mask_of(false);
    Hit nearest = hit_nothing(real_of(INFINITE));
    for (int axis = 0; axis < 6; axis++) {
        Ray ray = axis_ray(point, axis);
        mask nearer = shape->class->is_hit(shape, &ray, mask_of(true), &nearest);
        inside = is_from_inside(&ray, nearer, &nearest) | (inside & mask_not(nearer));
    }
    return inside;
}

void glass_look(Glass *glass, Vector eye) {
    glass->at_eye = media_air();
    for (size_t i = 0; i < glass->clear.count; i++) {
        const Shape *shape = glass->clear.shapes[i];
        media_enter(&glass->at_eye, is_inside(shape, eye), integer_of(shape->place));
    }
}

/* --- jumps ----------------------------------------------------------------------------------- */

/** Asks whether a shape's surface lies in jumps. See #ShapeVisitor. @param shape The shape.
 *  @param jumps The jumps, backwards. @param v Which vector. @param active Which lanes.
 *  @param[in,out] found A #Media for each vector: what the rays are inside of. */
static void jump_ask(const Shape *shape, const Packet *jumps, int v, mask active, void *found) {
    Media *media = (Media *)found + v;
    const Ray *back = &jumps->rays[v];
    Hit hit = hit_nothing(jumps->limit[v]);
    mask crossed = shape->class->is_hit(shape, back, active, &hit);
    if (any(crossed)) {
        mask inside = is_from_inside(back, crossed, &hit);
        integer place = integer_of(shape->place);
        media_enter(media, inside, place);
        media_leave(media, crossed & mask_not(inside), place);
    }
}

void glass_jump(const Glass *glass, const Packet *jumps, Media *media) {
    shape_list_visit(&glass->clear, jumps, jump_ask, media);
}
