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

/** The points of one surface that the rays of a packet meet. */
typedef struct PlainPoints {
    Vec3 normal;                 /**< Of all points; rays come from its side. */
    Vec3 points[PACKET_VECTORS]; /**< The points. */
    real errors[PACKET_VECTORS]; /**< See #Hit.error. */
} PlainPoints;

/** Finds where the rays of a beam meet a plane that all meet from its front. */
static void plain_points_find(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
                              GridPosition first, const PlaneEquation *seen, PlainPoints *found) {
    const PlaneEquation plane = *seen;
    const PixelJitter shifted = camera_shifted(camera, jitter);
    const real height = plane_equation_height(&plane, vec3s_first_lane(camera->origin));
    found->normal = vec3_splat(plane.normal);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Ray ray = camera_grid_ray(camera, grid, shifted, grid_vector_position(first, v));
        real distance = height / plane_equation_slope(&plane, ray.direction);
        SurfacePoint surface = plane_equation_surface(&plane, &ray, distance);
        found->points[v] = surface.point;
        found->errors[v] = surface.error;
    }
}

/** How a lamp stands to the points of a packet. */
typedef struct PlainLight {
    real cosine[PACKET_VECTORS];           /**< n . l */
    real distance_squared[PACKET_VECTORS]; /**< Scene units squared. */
    bool is_any_lit;                       /**< Whether any point faces the lamp. */
    bool is_all_lit;                       /**< Whether all do. */
    Vec3 low;                              /**< Least origins of shadow rays, per lane. */
    Vec3 high;                             /**< Greatest. */
} PlainLight;

/** Finds how a lamp stands to the points. */
static void plain_light_find(const RayOffset *offset, const PlainPoints *points, Vec3 lamp,
                             PlainLight *light) {
    const RayOffset offset_of_all = *offset;
    const Vec3 normal = points->normal;
    const real most = real_of(INFINITE), least = real_of(-INFINITE);
    Vec3 low = {most, most, most}, high = {least, least, least};
    mask any_lit = mask_of(false), all_lit = mask_of(true);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Hit hit = {.point = points->points[v], .normal = normal, .error = points->errors[v]};
        Vec3 to_light = vec3_subtract(lamp, hit.point);
        Vec3 origin = ray_offset_origin(&offset_of_all, &hit, to_light);
        real distance_squared = light_distance_squared(to_light);
        real cosine = vec3_dot(normal, to_light) / real_sqrt(distance_squared);
        light->distance_squared[v] = distance_squared;
        light->cosine[v] = cosine;
        any_lit |= cosine > 0;
        all_lit &= cosine > 0;
        low = vec3_min(origin, low);
        high = vec3_max(origin, high);
    }
    light->is_any_lit = any(any_lit);
    light->is_all_lit = mask_bits(all_lit) == ALL_LANES;
    light->low = low;
    light->high = high;
}

/** Adds what a lamp gives to all points. */
static void plain_light_add(const Light *lamp, const PlainLight *light, Rgb *diffuse) {
    const Rgb intensity = lamp->intensity;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real attenuation = light_attenuation(lamp, real_of(1), light->distance_squared[v]);
        diffuse[v] = rgb_add(diffuse[v], rgb_scale(intensity, attenuation * light->cosine[v]));
    }
}

/** Adds up the light of all lamps. @return Whether each reaches all points, or faces none. */
static bool plain_points_light(const Tracer *tracer, const PlainPoints *points, Rgb *diffuse,
                               RayCounts *counts) {
    const Rgb black = {real_of(0), real_of(0), real_of(0)};
    uint64_t rays = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        diffuse[v] = black;
    }
    for (size_t i = 0; i < tracer->light_count; i++) {
        const Light *lamp = &tracer->lights[i];
        PlainLight light;
        if (!lamp->is_point) {
            return false;
        }
        plain_light_find(&tracer->ray_offset, points, lamp->position, &light);
        if (!light.is_any_lit) {
            continue;
        }
        const PacketIntervals intervals =
            intervals_to_point(light.low, light.high, &lamp->position, 1);
        if (!light.is_all_lit || shape_set_may_meet(&tracer->shapes, &intervals, NULL)) {
            return false;
        }
        plain_light_add(lamp, &light, diffuse);
        rays += PACKET_RAYS;
    }
    counts->shadow += rays;
    return true;
}

/** @return The plane of a shape that is the first that all rays of a beam meet, from the front;
 * NULL: nobody knows. @param candidates The shapes that they may meet; at least one. */
static const PlaneEquation *plain_plane(const Tracer *tracer, const Beam *beam,
                                        const BeamCandidates *candidates) {
    const Shape *shape = candidates->nearest;
    if (!shape->class->plane || tracer->materials[shape->material].traits) {
        return NULL;
    }
    const PlaneEquation *plane = shape->class->plane(shape);
    scalar farthest = plane_equation_farthest(plane, beam);
    return farthest < candidates->next_distance && shape->class->covers(shape, beam) ? plane : NULL;
}

bool plain_packet_shade(const Tracer *tracer, const PixelGrid *grid, PixelJitter jitter, int index,
                        Rgb *colors, RayCounts *counts) {
    const GridPosition first = grid_packet_position(grid, index);
    const Beam beam = camera_packet_beam(&tracer->camera, grid, jitter, index);
    BeamCandidates candidates;
    if (!grid_has_whole_packet(grid, first)) {
        return false;
    }
    shape_set_find_in_beam(&tracer->shapes, &beam, &candidates);
    if (!candidates.nearest) {
        return plain_packet_fill_sky(tracer, colors);
    }
    const PlaneEquation *plane = plain_plane(tracer, &beam, &candidates);
    PlainPoints points;
    Rgb diffuse[PACKET_VECTORS];
    if (!plane) {
        return false;
    }
    plain_points_find(&tracer->camera, grid, jitter, first, plane, &points);
    if (!plain_points_light(tracer, &points, diffuse, counts)) {
        return false;
    }
    const MaterialPack material =
        material_pack_splat(&tracer->materials[candidates.nearest->material]);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        colors[v] = diffuse_color(&material, diffuse[v]);
    }
    return true;
}
