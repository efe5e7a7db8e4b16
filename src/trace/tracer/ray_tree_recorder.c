/**
 * @file
 * @brief Recording of the tree of rays of one pixel.
 */
#include "trace/tracer/ray_tree_recorder.h"

#include "trace/lights/emitters.h"

#include <stdlib.h>
#include <string.h>

/** Rays that memory is allocated for at first. */
enum { RAY_TREE_INITIAL_CAPACITY = 64 };

/* --- conversion to double --------------------------------------------------------------------- */

/** @return The vector in the first lane. */
static Vec3d vec3_first_lane(Vec3 v) {
    return (Vec3d){(double)real_lane(v.x, 0), (double)real_lane(v.y, 0), (double)real_lane(v.z, 0)};
}

/** @return The colour in the first lane. */
static Rgbd rgb_first_lane(Rgb color) {
    return (Rgbd){(double)real_lane(color.red, 0), (double)real_lane(color.green, 0),
                  (double)real_lane(color.blue, 0)};
}

/** @return The number in the first lane. */
static double real_first_lane(real x) {
    return (double)real_lane(x, 0);
}

/** @return A length in ulps of a number of the engine. */
static double in_ulps(double length, double x) {
    int exponent;
    frexp(x, &exponent);
    return x > 0 ? length / ldexp(1, exponent - MANTISSA_BITS) : 0;
}

/* --- the list of rays ------------------------------------------------------------------------- */

/** Makes room for one more ray. @return Whether there is; false if memory is exhausted. */
static bool ray_tree_reserve(RayTree *ray_tree) {
    if (ray_tree->count < ray_tree->capacity) {
        return true;
    }
    size_t capacity = ray_tree->capacity ? 2 * ray_tree->capacity : RAY_TREE_INITIAL_CAPACITY;
    RayTreeNode *rays =
        capacity <= RAY_TREE_MAX_NODES ? realloc(ray_tree->nodes, capacity * sizeof *rays) : NULL;
    if (rays) {
        ray_tree->nodes = rays;
        ray_tree->capacity = capacity;
    }
    return rays != NULL;
}

/**
 * Adds a ray as a child of the current one.
 * @param ray  The ray, in the first lane.
 * @param limit  The largest distance that counts, in lengths of its direction.
 * @return Its node; NULL if memory is exhausted.
 */
static RayTreeNode *ray_tree_add(RayTree *ray_tree, RayType kind, const Ray *ray, real limit) {
    ray_tree->is_truncated = ray_tree->is_truncated || !ray_tree_reserve(ray_tree);
    if (ray_tree->is_truncated) {
        return NULL;
    }
    bool is_first = ray_tree->count == 0;
    Vec3d direction = vec3_first_lane(ray->direction);
    RayTreeNode *added = &ray_tree->nodes[ray_tree->count++];
    *added = (RayTreeNode){.parent = is_first ? -1 : ray_tree->current,
                           .kind = kind,
                           .depth = is_first ? 0 : ray_tree->nodes[ray_tree->current].depth + 1,
                           .origin = vec3_first_lane(ray->origin),
                           .direction = vec3d_normalize(vec3d_scale_exponent(direction)),
                           .limit = real_first_lane(limit) * vec3d_length(direction),
                           .engine_origin = vec3_first_lane(ray->origin),
                           .engine_direction = direction,
                           .shape = -1,
                           .light = -1,
                           .distance = HUGE_VAL};
    return added;
}

/** @return The current ray; NULL if memory was exhausted. */
static RayTreeNode *ray_tree_current(const RayTree *ray_tree) {
    return ray_tree->is_truncated ? NULL : &ray_tree->nodes[ray_tree->current];
}

void ray_tree_push(RayTree *ray_tree, RayType type, const RayState *rays, Rgb weight) {
    const Packet *packet = &rays->packet;
    RayTreeNode *ray = ray_tree_add(ray_tree, type, &packet->rays[0], packet->limit[0]);
    if (ray) {
        ray->weight = rgb_first_lane(weight);
        ray->throughput = real_first_lane(rgb_max(rays->throughput[0]));
        ray_tree->current = (int)(ray - ray_tree->nodes);
    }
}

void ray_tree_pop(RayTree *ray_tree, Rgb color) {
    RayTreeNode *ray = ray_tree_current(ray_tree);
    if (ray) {
        ray->color = rgb_first_lane(color);
        ray->local_color = ray->shape < 0 ? ray->color : ray->local_color;
        ray_tree->current = ray->parent;
    }
}

void ray_tree_set_pixel(RayTree *ray_tree, Rgb color) {
    if (!ray_tree->is_truncated) {
        RayTreeNode *first = &ray_tree->nodes[0];
        const Rgbd pixel = rgb_first_lane(color), sum = first->color;
        ray_tree->merged_light =
            (Rgbd){pixel.red - sum.red, pixel.green - sum.green, pixel.blue - sum.blue};
        first->color = pixel;
    }
}

/* --- hits ------------------------------------------------------------------------------------- */

/** Records a hit. @param length Length of the ray's direction in the engine. */
static void ray_tree_node_set_hit(RayTreeNode *ray, const Hit *hit, double length) {
    int shape = integer_lane(hit->shape, 0), light = emitter_light_index(shape);
    ray->is_hit = shape >= 0 || light >= 0;
    if (ray->is_hit) {
        ray->shape = shape >= 0 ? shape : -1;
        ray->light = shape >= 0 ? ray->light : light;
        ray->distance = real_first_lane(hit->distance) * length;
        ray->point = ray->engine_point = vec3_first_lane(hit->point);
        ray->normal = vec3_first_lane(hit->normal);
    }
}

void ray_tree_record_surface(const SurfaceHit *surface, const RayOffset *offset) {
    RayTreeNode *ray = ray_tree_current(surface->packet->context.recorders->ray_tree);
    const Hit *hit = &surface->hits[0];
    if (!ray) {
        return;
    }
    ray_tree_node_set_hit(ray, hit, 1);
    if (ray->shape >= 0) {
        real along = vec3_dot(surface->packet->rays[0].direction, surface->n_front[0]);
        double epsilon = real_first_lane(ray_offset_length(offset, hit));
        ray->surface = (RayTreeSurface){
            .epsilon = epsilon,
            .ulps = in_ulps(epsilon, real_first_lane(vec3_max_abs(hit->point))),
            .cosine = -real_first_lane(along),
            .is_inside = vec3d_dot(vec3_first_lane(surface->n_front[0]), ray->normal) < 0};
    }
}

/* --- sphere tracing --------------------------------------------------------------------------- */

/** Most steps that are recorded of a ray. */
enum { MARCH_STEPS_MAXIMUM = 1024 };

/** The march that is kept, and whose it is. */
typedef struct MarchRecord {
    RayTree *tree;     /**< The tree; its steps have room for two marches. */
    int hit_shape;     /**< The shape that the ray hits; negative: none. */
    int shape;         /**< The shape whose march is kept; -1: none yet. */
    size_t step_count; /**< Steps of the march that is kept. */
} MarchRecord;

/** Records the march in a shape behind the one that is kept, and keeps the better one. See
 *  #ShapeVisitor. */
static void shape_record_march(const Shape *shape, const Packet *packet, int v, mask active,
                               void *found) {
    MarchRecord *record = found;
    bool is_final = record->shape >= 0 && record->shape == record->hit_shape;
    if (v > 0 || !shape_has_steps(shape) || is_final || !mask_lane(active, 0)) {
        return;
    }
    RayMarchStep *kept = record->tree->steps + record->tree->step_count;
    bool is_hit = shape->index == record->hit_shape;
    const Ray *ray = &packet->rays[0];
    MarchLog log = {.steps = kept + record->step_count,
                    .capacity = MARCH_STEPS_MAXIMUM,
                    .length = vec3d_length(vec3_first_lane(ray->direction))};
    shape->class->extension->count_steps(shape, ray, active,
                                         is_hit ? real_of(INFINITE) : packet->limit[0], &log);
    if (is_hit || log.count > record->step_count) {
        memmove(kept, log.steps, log.count * sizeof *kept);
        record->step_count = log.count;
        record->shape = (int)shape->index;
    }
}

/** Makes room for the steps of two marches. @return Whether there is; false without memory. */
static bool ray_tree_reserve_steps(RayTree *ray_tree) {
    size_t needed = ray_tree->step_count + 2 * MARCH_STEPS_MAXIMUM;
    if (needed > ray_tree->step_capacity) {
        size_t capacity = 2 * needed;
        RayMarchStep *steps = realloc(ray_tree->steps, capacity * sizeof *steps);
        ray_tree->steps = steps ? steps : ray_tree->steps;
        ray_tree->step_capacity = steps ? capacity : ray_tree->step_capacity;
    }
    return needed <= ray_tree->step_capacity;
}

void ray_tree_record_march(const ShapeSet *shapes, const SurfaceHit *surface) {
    RayTree *ray_tree = surface->packet->context.recorders->ray_tree;
    RayTreeNode *ray = ray_tree_current(ray_tree);
    if (!ray || !ray_tree_reserve_steps(ray_tree)) {
        return;
    }
    Packet limited = *surface->packet;
    limited.limit[0] = surface->hits[0].distance;
    MarchRecord record = {.tree = ray_tree, .hit_shape = ray->shape, .shape = -1};
    shape_set_visit(shapes, &limited, shape_record_march, &record);
    ray->first_step = ray_tree->step_count;
    ray->step_count = record.step_count;
    ray_tree->step_count += record.step_count;
}

/* --- glass ------------------------------------------------------------------------------------ */

void ray_tree_record_dielectric(const SurfaceHit *surface) {
    const DielectricHit *dielectric = surface->dielectric;
    RayTreeNode *ray = ray_tree_current(surface->packet->context.recorders->ray_tree);
    MaterialPack material =
        material_pack_gather(surface->materials, &surface->material_ids[0], surface->is_hit[0]);
    mask is_transmitted = surface->is_hit[0] & (rgb_max(material.transmittance) > 0);
    if (!ray || !mask_lane(is_transmitted, 0)) {
        return;
    }
    InteriorList interior = surface->interior[0];
    integer shape_before = interior_list_cross(&interior, &surface->packet->rays[0],
                                               &surface->hits[0], is_transmitted);
    integer shape_behind = interior_list_top(&dielectric->interior_behind[0]);
    RayTreeSurface *record = &ray->surface;
    record->is_transparent = true;
    record->is_overridden = mask_lane(dielectric->is_overridden[0], 0);
    record->is_total = !mask_lane(dielectric->is_transmitted[0], 0);
    record->ior_from = real_first_lane(dielectrics_ior(surface->dielectrics, shape_before));
    record->ior_to = real_first_lane(dielectrics_ior(surface->dielectrics, shape_behind));
    record->fresnel = real_first_lane(dielectric->reflectance[0]);
}

/* --- light ------------------------------------------------------------------------------------ */

/**
 * Finds the first shape that a shadow ray hits.
 * @param surface  The surface that it starts from.
 * @param[out] hit  The hit; of a transparent shape only if no opaque one is hit.
 */
static void occluder_find(const ShapeSet *shapes, const SurfaceHit *surface, const Packet *shadow,
                          Hit *hit) {
    Packet rays = *shadow;
    Hit hits[PACKET_VECTORS];
    rays.wants_points = true;
    shape_set_closest_hits(surface->interior ? &surface->dielectrics->opaque : shapes, &rays, hits);
    if (integer_lane(hits[0].shape, 0) < 0 && surface->interior) {
        shape_set_closest_hits(&surface->dielectrics->transparent, &rays, hits);
    }
    *hit = hits[0];
}

void ray_tree_record_shadow(const ShapeSet *shapes, const SurfaceHit *surface, size_t light_index,
                            const Light *light, const LightSample *sample, mask occluded,
                            const DirectLighting *lighting) {
    const Packet *shadow = &sample->shadow_rays;
    RayTree *ray_tree = surface->packet->context.recorders->ray_tree;
    RayTreeNode *ray = ray_tree_add(ray_tree, RAY_SHADOW, &shadow->rays[0], shadow->limit[0]);
    if (!ray) {
        return;
    }
    const Rgbd one = {1, 1, 1};
    ray->light = (int)light_index;
    ray->throughput = ray_tree->nodes[ray->parent].throughput;
    ray->weight = one;
    ray->cosine = real_first_lane(sample->cosine[0]);
    ray->falloff =
        real_first_lane(light_attenuation(light, sample->weight[0], sample->distance_squared[0]));
    ray->diffuse = rgb_first_lane(lighting->diffuse[0]);
    ray->specular = rgb_first_lane(lighting->specular[0]);
    ray->transmittance = surface->interior ? rgb_first_lane(sample->transmittance[0]) : one;
    if (mask_lane(occluded, 0)) {
        Hit hit;
        occluder_find(shapes, surface, shadow, &hit);
        ray_tree_node_set_hit(ray, &hit, vec3d_length(vec3_first_lane(shadow->rays[0].direction)));
        ray->is_hit = true;
        ray->transmittance = (Rgbd){0, 0, 0};
    }
}

/** @return The same colour in all lanes. */
static Rgb rgb_of_color(Rgbd color) {
    return rgb_splat(rgbs_of(color));
}

/** Computes what each shadow ray adds to the colour of its surface. @param parent_index Index of
 *  the ray that hit the surface. */
static void ray_tree_weight_shadows(RayTree *ray_tree, int parent_index,
                                    const MaterialPack *material) {
    for (size_t i = (size_t)parent_index + 1; i < ray_tree->count; i++) {
        RayTreeNode *ray = &ray_tree->nodes[i];
        Rgb diffuse = rgb_scale(rgb_of_color(ray->diffuse), material->diffuse);
        Rgb specular = rgb_multiply(material->specular, rgb_of_color(ray->specular));
        ray->local_color =
            rgb_first_lane(rgb_add(rgb_multiply(material->albedo, diffuse), specular));
        ray->color = ray->local_color;
    }
}

void ray_tree_record_shading(const SurfaceHit *surface, const Rgb *texture_color, Rgb color) {
    RayTree *ray_tree = surface->packet->context.recorders->ray_tree;
    RayTreeNode *ray = ray_tree_current(ray_tree);
    if (!ray) {
        return;
    }
    MaterialPack material =
        material_pack_gather(surface->materials, &surface->material_ids[0], surface->is_hit[0]);
    material.albedo =
        texture_color ? rgb_multiply(material.albedo, texture_color[0]) : material.albedo;
    RayTreeSurface *record = &ray->surface;
    record->emission = rgb_first_lane(material.emission);
    record->albedo = rgb_first_lane(material.albedo);
    record->specular = rgb_first_lane(material.specular);
    record->ambient = rgb_first_lane(material.ambient);
    record->diffuse = real_first_lane(material.diffuse);
    record->reflect_weight = rgb_first_lane(surface_reflectance(surface, 0, &material));
    if (record->is_transparent) {
        record->refract_weight = rgb_first_lane(surface_transmittance(surface, 0, &material));
    }
    ray->local_color = rgb_first_lane(color);
    // The newest nodes are this surface's shadow rays: its secondary rays are not generated yet.
    ray_tree_weight_shadows(ray_tree, ray_tree->current, &material);
}

/* --- completion ------------------------------------------------------------------------------- */

void ray_tree_finish(RayTree *ray_tree, Vec3d origin) {
    ray_tree->origin = origin;
    for (size_t i = 0; i < ray_tree->count; i++) {
        RayTreeNode *ray = &ray_tree->nodes[i];
        ray->origin = vec3d_add(ray->origin, origin);
        ray->point = vec3d_add(ray->point, origin);
    }
}
