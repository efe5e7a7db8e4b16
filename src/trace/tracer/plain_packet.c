/**
 * @file
 * @brief Plain packets.
 */
#include "trace/tracer/plain_packet.h"

#include "trace/lights/light.h"
#include "trace/shapes/plane_equation.h"

bool plain_packets_are_possible(const Tracer *tracer, const PixelGrid *grid) {
    const ShapeSet *shapes = &tracer->shapes;
    return LANES > 1 && !grid->selected && !grid->path_hashes && !grid->ray_tree &&
           !tracer->methods && !tracer->textures.material_maps && !tracer->dielectrics.iors &&
           tracer->emitters.count == 0 && !shapes->bvh.nodes && !shapes->may_exceed_box;
}

/** The points of one surface that the rays of a packet meet. */
typedef struct PlainPoints {
    const PlaneEquation *plane;  /**< The plane of all points; rays come from its front. */
    Vec3 points[PACKET_VECTORS]; /**< The points. */
    real errors[PACKET_VECTORS]; /**< See #Hit.error. */
} PlainPoints;

/** Fills a packet with the light of the sky. @return Whether that is the same everywhere. */
static bool plain_packet_fill_sky(const Tracer *tracer, Rgb *colors) {
    if (tracer->sky.is_gradient || tracer->textures.sky) {
        return false;
    }
    for (int v = 0; v < PACKET_VECTORS; v++) {
        colors[v] = tracer->sky.horizon;
    }
    return true;
}

/** Finds where the rays meet a shape that covers them. @return Whether all do, from the front. */
static bool plain_points_find(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
                              int index, const Beam *beam, PlainPoints *found) {
    const PlaneEquation plane = *found->plane;
    const Vec3 normal = vec3_splat(plane.normal);
    const GridPosition first = grid_packet_position(grid, index);
    const real height = plane_equation_height(&plane, beam->origin);
    const PixelJitter shifted = camera_shifted(camera, jitter);
    mask is_front = mask_of(true);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Ray ray = camera_grid_ray(camera, grid, shifted, grid_vector_position(first, v));
        real distance = height / plane_equation_slope(&plane, ray.direction);
        SurfacePoint surface = plane_equation_surface(&plane, &ray, distance);
        is_front &= (distance > 0) & (distance < INFINITE) &
                    mask_not(vec3_dot(ray.direction, normal) > 0);
        found->points[v] = surface.point;
        found->errors[v] = surface.error;
    }
    return mask_bits(is_front) == ALL_LANES;
}

/** What a lamp gives to the points of a packet. */
typedef struct PlainLight {
    real cosine[PACKET_VECTORS];           /**< n . l */
    real distance_squared[PACKET_VECTORS]; /**< Scene units squared. */
    unsigned lit;       /**< Number of points that face the lamp. */
    Vec3 low;           /**< Least coordinates of the origins of shadow rays, per lane. */
    Vec3 high;          /**< Greatest. */
} PlainLight;

/** Finds how a lamp stands to the points. */
static void plain_light_find(const RayOffset *offset, const PlainPoints *points, Vec3 lamp,
                             PlainLight *light) {
    const Vec3 normal = vec3_splat(points->plane->normal);
    const real most = real_of(INFINITE), least = real_of(-INFINITE);
    Vec3 low = {most, most, most}, high = {least, least, least};
    light->lit = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Hit hit = {.point = points->points[v], .normal = normal, .error = points->errors[v]};
        Vec3 to_light = vec3_subtract(lamp, hit.point);
        Vec3 origin = ray_offset_origin(offset, &hit, to_light);
        light->distance_squared[v] = light_distance_squared(to_light);
        light->cosine[v] = vec3_dot(normal, to_light) / real_sqrt(light->distance_squared[v]);
        light->lit += mask_count(light->cosine[v] > 0);
        low = vec3_min(origin, low);
        high = vec3_max(origin, high);
    }
    light->low = low;
    light->high = high;
}

/** Adds what a lamp gives to all points. */
static void plain_light_add(const Light *lamp, const PlainLight *light, Rgb *diffuse) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real attenuation = light_attenuation(lamp, real_of(1), light->distance_squared[v]);
        diffuse[v] =
            rgb_add(diffuse[v], rgb_scale(lamp->intensity, attenuation * light->cosine[v]));
    }
}

/** Adds up the light of all lamps. @return Whether each reaches all points, or faces none. */
static bool plain_points_light(const Tracer *tracer, const PlainPoints *points, Rgb *diffuse,
                               RayCounts *counts) {
    uint64_t rays = 0;
    for (size_t i = 0; i < tracer->light_count; i++) {
        const Light *lamp = &tracer->lights[i];
        PlainLight light;
        if (!lamp->is_point) {
            return false;
        }
        plain_light_find(&tracer->ray_offset, points, lamp->position, &light);
        if (light.lit == 0) {
            continue;
        }
        const PacketIntervals intervals =
            intervals_to_point(light.low, light.high, &lamp->position, 1);
        if (light.lit < PACKET_RAYS || shape_set_may_meet(&tracer->shapes, &intervals)) {
            return false;
        }
        plain_light_add(lamp, &light, diffuse);
        rays += PACKET_RAYS;
    }
    counts->shadow += rays;
    return true;
}

bool plain_packet_shade(const Tracer *tracer, const PixelGrid *grid, PixelJitter jitter, int index,
                        Rgb *colors, RayCounts *counts) {
    const Rgb black = {real_of(0), real_of(0), real_of(0)};
    const Beam beam = camera_packet_beam(&tracer->camera, grid, jitter, index);
    const Shape *shape;
    size_t candidates = shape_set_count_in_beam(&tracer->shapes, &beam, &shape);
    if (candidates == 0) {
        return plain_packet_fill_sky(tracer, colors);
    }
    if (candidates > 1 || !shape->class->plane || !shape->class->covers(shape, &beam)) {
        return false;
    }
    const Material *material = &tracer->materials[shape->material];
    PlainPoints points = {.plane = shape->class->plane(shape)};
    Rgb diffuse[PACKET_VECTORS];
    for (int v = 0; v < PACKET_VECTORS; v++) {
        diffuse[v] = black;
    }
    if (material->traits || !grid_has_whole_packet(grid, grid_packet_position(grid, index)) ||
        !plain_points_find(&tracer->camera, grid, jitter, index, &beam, &points) ||
        !plain_points_light(tracer, &points, diffuse, counts)) {
        return false;
    }
    const MaterialPack pack = material_pack_splat(material);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        colors[v] = diffuse_color(&pack, diffuse[v]);
    }
    return true;
}
