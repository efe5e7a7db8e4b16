/**
 * @file
 * @brief Interior lists.
 */
#include "trace/glass/neighbours.h"

#include <stdlib.h>

/** Most transparent shapes that an opaque one is compared with; if there are more, they are
 *  assumed to touch. */
enum { MAX_TOUCH_TESTS = 64 };

/** Sets the indices of refraction of all shapes. @return Whether memory sufficed. */
static bool iors_init(Dielectrics *dielectrics, const Scene *scene) {
    dielectrics->iors = calloc(scene->shape_count + 1, sizeof *dielectrics->iors);
    if (!dielectrics->iors) {
        return false;
    }
    dielectrics->iors[0] = 1;
    for (size_t i = 0; i < scene->shape_count; i++) {
        const SceneMaterial *material = &scene->materials[scene->shapes[i].material_index];
        bool is_glass = scene_material_is_transparent(material);
        dielectrics->iors[i + 1] = is_glass ? (scalar)material->ior : 0;
    }
    return true;
}

/** See #ShapePredicate. @return Whether a shape is transparent. */
static bool shape_is_transparent(const Shape *shape, const void *context) {
    const Dielectrics *dielectrics = context;
    return dielectrics->iors[shape->index + 1] > 0;
}

/** See #ShapePredicate. @return Whether a shape is not transparent. */
static bool shape_is_opaque(const Shape *shape, const void *context) {
    return !shape_is_transparent(shape, context);
}

/** @return Whether a shape crosses a diagonal of a bounded box. A plane that meets the box does. */
static bool shape_crosses_diagonal(const Shape *shape, const Aabbs *box) {
    bool crosses = false;
    for (int corner = 0; corner < 4; corner++) {
        bool flips_x = corner & 1, flips_y = corner & 2;
        Vec3 from = {real_of(flips_x ? box->high[0] : box->low[0]),
                     real_of(flips_y ? box->high[1] : box->low[1]), real_of(box->low[2])};
        Vec3 to = {real_of(flips_x ? box->low[0] : box->high[0]),
                   real_of(flips_y ? box->low[1] : box->high[1]), real_of(box->high[2])};
        Ray ray = ray_of(from, vec3_subtract(to, from));
        Hit hit = hit_none(real_of(1));
        crosses = crosses || any(shape->class->is_hit(shape, &ray, mask_of(true), &hit));
    }
    return crosses;
}

/** @return Whether an opaque shape may touch a transparent one. */
static bool shapes_may_touch(const Shape *opaque, const Shape *transparent) {
    Aabbs box = opaque->class->bounds(opaque), glass = transparent->class->bounds(transparent);
    bool is_plane = opaque->class == &plane_class;
    if (!is_plane || !aabbs_is_bounded(&glass)) {
        return aabbs_overlap(&box, &glass);
    }
    glass = aabbs_padded_by_largest(glass);
    return shape_crosses_diagonal(opaque, &glass);
}

/** See #ShapePredicate. @return Whether an opaque shape may touch any transparent one. */
static bool shape_may_touch(const Shape *shape, const void *context) {
    const Dielectrics *dielectrics = context;
    const ShapeSet *transparent = &dielectrics->transparent;
    bool touches = false;
    for (size_t i = 0; shape_is_opaque(shape, context) && !touches && i < transparent->count; i++) {
        touches = i == MAX_TOUCH_TESTS || shapes_may_touch(shape, transparent->shapes[i]);
    }
    return touches;
}

/** Finds the opaque shapes that may touch a transparent one. @return Whether memory sufficed. */
static bool touching_init(Dielectrics *dielectrics, const ShapeSet *shapes,
                          const TraceSettings *settings) {
    if (!shape_set_filter(&dielectrics->touching, shapes, shape_may_touch, dielectrics, settings)) {
        return false;
    }
    if (dielectrics->touching.count == 0) {
        return true;
    }
    scalar *scales = calloc(shapes->count + 1, sizeof *scales);
    dielectrics->offset_scales = scales;
    if (!scales) {
        return false;
    }
    scales[0] = 1;
    for (size_t i = 0; i < shapes->count; i++) {
        scales[i + 1] = (scalar)(dielectrics->iors[i + 1] > 0 ? 0 : 1);
    }
    for (size_t i = 0; i < dielectrics->touching.count; i++) {
        scales[dielectrics->touching.shapes[i]->index + 1] = TOUCHING_OFFSET_SCALE;
    }
    return true;
}

bool dielectrics_init(Dielectrics *dielectrics, const Scene *scene, const ShapeSet *shapes,
                      const TraceSettings *settings) {
    *dielectrics = (Dielectrics){.camera_interior = interior_list_empty(), .all = shapes};
    return !scene_has_transparency(scene) ||
           (iors_init(dielectrics, scene) &&
            shape_set_filter(&dielectrics->transparent, shapes, shape_is_transparent, dielectrics,
                             settings) &&
            shape_set_filter(&dielectrics->opaque, shapes, shape_is_opaque, dielectrics,
                             settings) &&
            touching_init(dielectrics, shapes, settings) && neighbours_init(dielectrics));
}

/** Most tinted shapes that are tested for overlaps; if there are more, an override is assumed. */
enum { MAX_TINTED_SHAPES = 1000 };

/** @return Whether a material absorbs some of the transmitted light. */
static bool material_is_tinted(const Material *s) {
    return s->transmittance.red < 1 || s->transmittance.green < 1 || s->transmittance.blue < 1;
}

/** Sets #Dielectrics.may_override. */
static void dielectrics_find_overrides(Dielectrics *dielectrics, const Material *materials) {
    Aabbs tinted[MAX_TINTED_SHAPES];
    size_t count = 0;
    for (size_t i = 0; !dielectrics->may_override && i < dielectrics->transparent.count; i++) {
        const Shape *shape = dielectrics->transparent.shapes[i];
        Aabbs box = shape->class->bounds(shape);
        for (size_t other = 0; other < count; other++) {
            dielectrics->may_override =
                dielectrics->may_override || aabbs_overlap(&tinted[other], &box);
        }
        if (material_is_tinted(&materials[shape->material])) {
            tinted[count++] = box;
            dielectrics->may_override = dielectrics->may_override || count == MAX_TINTED_SHAPES;
        }
    }
}

/** What makes a shape #Dielectrics.tinted. */
typedef struct TintQuery {
    const Dielectrics *dielectrics; /**< The transparent shapes. */
    const Material *materials;      /**< The materials. */
} TintQuery;

/** See #ShapePredicate. @return Whether a shape matters to shadow rays. */
static bool shape_is_tinted(const Shape *shape, const void *context) {
    const TintQuery *query = context;
    return shape_is_transparent(shape, query->dielectrics) &&
           (query->dielectrics->may_override ||
            material_is_tinted(&query->materials[shape->material]));
}

bool dielectrics_find_tints(Dielectrics *dielectrics, const Material *materials,
                            const TraceSettings *settings) {
    const TintQuery query = {dielectrics, materials};
    dielectrics_find_overrides(dielectrics, materials);
    return dielectrics->transparent.count == 0 ||
           shape_set_filter(&dielectrics->tinted, dielectrics->all, shape_is_tinted, &query,
                            settings);
}

void dielectrics_deinit(Dielectrics *dielectrics) {
    free(dielectrics->iors);
    free(dielectrics->offset_scales);
    free(dielectrics->neighbours);
    dielectrics->iors = dielectrics->offset_scales = NULL;
    dielectrics->neighbours = NULL;
    shape_set_deinit(&dielectrics->transparent);
    shape_set_deinit(&dielectrics->opaque);
    shape_set_deinit(&dielectrics->touching);
    shape_set_deinit(&dielectrics->tinted);
}

/** @return The lanes in which rays hit a shape from inside. @param hit_lanes The lanes that hit it.
 */
INLINE mask is_hit_from_inside(const Ray *ray, mask hit_lanes, const Hit *hit) {
    return hit_lanes & (vec3_dot(ray->direction, hit->normal) > 0);
}

/* --- the camera ------------------------------------------------------------------------------ */

/** @return Rays along an axis. @param axis 0 to 5: x, y, z, -x, -y, -z. */
static Ray axis_ray(Vec3 origin, int axis) {
    real along = real_of(axis < 3 ? 1 : -1), zero = real_of(0);
    Vec3 direction = {axis % 3 == 0 ? along : zero, axis % 3 == 1 ? along : zero,
                      axis % 3 == 2 ? along : zero};
    return ray_of(origin, direction);
}

/** @return The lanes whose point is inside of a shape. */
static mask shape_contains(const Shape *shape, Vec3 point) {
    mask inside = mask_of(false);
    Hit nearest = hit_none(real_of(INFINITE));
    for (int axis = 0; axis < 6; axis++) {
        Ray ray = axis_ray(point, axis);
        mask nearer = shape->class->is_hit(shape, &ray, mask_of(true), &nearest);
        inside = is_hit_from_inside(&ray, nearer, &nearest) | (inside & mask_not(nearer));
    }
    return inside;
}

void dielectrics_set_camera(Dielectrics *dielectrics, Vec3 camera_position) {
    dielectrics->camera_interior = interior_list_empty();
    for (size_t i = 0; i < dielectrics->transparent.count; i++) {
        const Shape *shape = dielectrics->transparent.shapes[i];
        interior_list_insert(&dielectrics->camera_interior, shape_contains(shape, camera_position),
                             integer_of(shape->index));
    }
}

/* --- offset segments ------------------------------------------------------------------------- */

/** Crosses the surface of a shape within offset segments. See #ShapeVisitor. @param[in,out] found
 * One #InteriorList per vector. */
static void segment_cross_shape(const Shape *shape, const Packet *segments, int v, mask active,
                                void *found) {
    InteriorList *interior = (InteriorList *)found + v;
    const Ray *ray = &segments->rays[v];
    Hit hit = hit_none(segments->limit[v]);
    mask crossed = shape->class->is_hit(shape, ray, active, &hit);
    if (any(crossed)) {
        mask inside = is_hit_from_inside(ray, crossed, &hit);
        integer shape_index = integer_of(shape->index);
        interior_list_insert(interior, inside, shape_index);
        interior_list_remove(interior, crossed & mask_not(inside), shape_index);
    }
}

void dielectrics_cross_segments(const Dielectrics *dielectrics, const Packet *segments,
                                const Hit *hits, InteriorList *interior) {
    neighbours_visit_segments(dielectrics, segments, hits, segment_cross_shape, interior);
}
