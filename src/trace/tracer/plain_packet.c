/**
 * @file
 * @brief Plain packets.
 */
#include "trace/tracer/plain_packet.h"

#include "trace/lights/light.h"
#include "trace/shapes/plane_equation.h"

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
INLINE void plain_points_find(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
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
    bool is_all_leaving;                   /**< Whether the rays from all of them to the lamp surely
                                                leave the surface: see #LEAVING_SLACK. */
} PlainLight;

/** Finds how a lamp stands to the points. */
INLINE void plain_light_find(const PlainPoints *points, Vec3 lamp, PlainLight *light) {
    const Vec3 normal = points->normal;
    mask any_lit = mask_of(false), all_lit = mask_of(true), all_leaving = mask_of(true);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Vec3 to_light = vec3_subtract(lamp, points->points[v]);
        real distance_squared = light_distance_squared(to_light);
        real cosine = vec3_dot(normal, to_light) / real_sqrt(distance_squared);
        light->distance_squared[v] = distance_squared;
        light->cosine[v] = cosine;
        any_lit |= cosine > 0;
        all_lit &= cosine > 0;
        all_leaving &= cosine > LEAVING_SLACK;
    }
    light->is_any_lit = any(any_lit);
    light->is_all_lit = mask_bits(all_lit) == ALL_LANES;
    light->is_all_leaving = mask_bits(all_leaving) == ALL_LANES;
}

/** @return Whether surely no shape is between the points and a lamp that shines on all of them.
 *  @param left The shape of the points, if rays to the lamp surely leave it; else NULL. */
static bool plain_light_is_clear(const Tracer *tracer, const PlainPoints *points, const Shape *left,
                                 const Light *lamp) {
    const RayOffset offset = tracer->ray_offset;
    const Vec3 normal = points->normal;
    const real most = real_of(INFINITE), least = real_of(-INFINITE);
    Vec3 low = {most, most, most}, high = {least, least, least};
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Hit hit = {.point = points->points[v], .normal = normal, .error = points->errors[v]};
        Vec3 origin = ray_offset_origin(&offset, &hit, normal);
        low = vec3_min(origin, low);
        high = vec3_max(origin, high);
    }
    const PacketIntervals intervals = intervals_to_point(low, high, &lamp->position, 1);
    return !shape_set_may_meet(&tracer->shapes, &intervals, left);
}

/** Adds what a lamp gives to all points. */
INLINE void plain_light_add(const Light *lamp, const PlainLight *light, Rgb *diffuse) {
    const Rgb intensity = lamp->intensity;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real attenuation = light_attenuation(lamp, real_of(1), light->distance_squared[v]);
        diffuse[v] = rgb_add(diffuse[v], rgb_scale(intensity, attenuation * light->cosine[v]));
    }
}

/** Adds up the light of all lamps. @param shape The shape of the points. @param is_clear Whether
 *  each lamp reaches all points, or faces none. Else that is found out. @return Whether it is so.
 */
static bool plain_points_light(const Tracer *tracer, const PlainPoints *points, const Shape *shape,
                               bool is_clear, Rgb *diffuse, RayCounts *counts) {
    const bool is_offset = tracer->ray_offset.strategy == OFFSET_BOUND;
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
        plain_light_find(points, lamp->position, &light);
        if (!light.is_any_lit) {
            continue;
        }
        const Shape *left = is_offset && light.is_all_leaving ? shape : NULL;
        if (!light.is_all_lit || (!is_clear && !plain_light_is_clear(tracer, points, left, lamp))) {
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
    const ShapeClass *class = shape->class;
    if (!class->plane || tracer->materials[shape->material].traits) {
        return NULL;
    }
    const PlaneEquation *plane = class->plane(shape);
    scalar farthest = plane_equation_farthest(plane, beam);
    bool is_whole = !class->covers || class->covers(shape, beam);
    return farthest < candidates->next_distance && is_whole ? plane : NULL;
}

/* --- tiles ------------------------------------------------------------------------------------ */

/** The part of a plane that the rays of a narrow beam meet: all of it is between its corners. */
typedef struct PlaneSection {
    Vec3 normal;   /**< Of the plane. */
    Vec3 corners;  /**< The corners, in the first lanes; further lanes repeat them. */
    scalar slack;  /**< How far points and origins of shadow rays may lie beyond the corners. */
    scalar height; /**< How far points may lie from the plane. */
} PlaneSection;

/** @return The section of a beam. All of its rays meet the plane from the front. */
static PlaneSection plane_section_of(const PlaneEquation *plane, const Beam *beam) {
    const mask is_left = (lane_numbers() & 1) == 1, is_low = (lane_numbers() & 2) == 2;
    const real one = real_of(1);
    Vec3 across = vec3_scale(vec3_splat(beam->across), real_select(is_left, -one, one));
    Vec3 up = vec3_scale(vec3_splat(beam->up), real_select(is_low, -one, one));
    Vec3 sideways = vec3_add(across, up);
    Ray ray = ray_of(vec3_splat(beam->origin),
                     vec3_normalize(vec3_add(vec3_splat(beam->axis), sideways)));
    real slope = real_abs(plane_equation_slope(plane, ray.direction));
    real distance = real_abs(plane_equation_height(plane, beam->origin)) / slope;
    SurfacePoint corner = plane_equation_surface(plane, &ray, distance);
    scalar error = real_reduce_max(corner.error);
    // A ray beside the beam by d meets the plane d / slope from where it should, and d beside.
    real beside = NARROW_BEAM_SLACK * distance * (1 + 1 / slope);
    return (PlaneSection){.normal = corner.normal,
                          .corners = corner.point,
                          .slack = 4 * error + real_reduce_max(beside),
                          .height = 2 * error};
}

/** How a lamp stands to a section of a plane. */
typedef enum SectionLight { SECTION_DARK, SECTION_LIT, SECTION_MIXED } SectionLight;

/** @return How a lamp stands to a section: it is lit where the cosine of each point is surely above
 *          LEAVING_SLACK. */
static SectionLight section_light(const PlaneSection *section, Vec3 lamp) {
    Vec3 to_light = vec3_subtract(lamp, section->corners);
    real height = vec3_dot(section->normal, to_light);
    scalar distance = SCALAR_SQRT(real_reduce_max(vec3_dot(to_light, to_light))) + section->slack;
    scalar least = section->height + 2 * LEAVING_SLACK * distance;
    return real_reduce_min(height) > least    ? SECTION_LIT
           : real_reduce_max(height) < -least ? SECTION_DARK
                                              : SECTION_MIXED;
}

/** @return Whether surely no other shape is between a section of a plane and a lamp that shines on
 *          it. @param shape The one that the section is a part of: shadow rays leave it. */
static bool section_is_clear(const ShapeSet *shapes, const Shape *shape,
                             const PlaneSection *section, const Light *lamp) {
    const real slack = real_of(section->slack);
    const Vec3 beyond = {slack, slack, slack};
    const PacketIntervals intervals =
        intervals_to_point(vec3_subtract(section->corners, beyond),
                           vec3_add(section->corners, beyond), &lamp->position, 1);
    return !shape_set_may_meet(shapes, &intervals, shape);
}

/** @return Whether each lamp shines on all points of a section, or on none. */
static bool section_is_plain(const Tracer *tracer, const Shape *shape,
                             const PlaneSection *section) {
    for (size_t i = 0; i < tracer->light_count; i++) {
        const Light *lamp = &tracer->lights[i];
        if (!lamp->is_point) {
            return false;
        }
        SectionLight light = section_light(section, lamp->position);
        if (light == SECTION_MIXED ||
            (light == SECTION_LIT && !section_is_clear(&tracer->shapes, shape, section, lamp))) {
            return false;
        }
    }
    return true;
}

/** @return See #PlainTile.plane. Only rays from beyond the error bound of a point surely leave its
 *          shape. */
static const PlaneEquation *plain_tile_plane(const Tracer *tracer, const Beam *beam,
                                             const BeamCandidates *candidates) {
    if (!candidates->nearest || tracer->ray_offset.strategy != OFFSET_BOUND ||
        !beam_is_narrow(beam)) {
        return NULL;
    }
    const PlaneEquation *plane = plain_plane(tracer, beam, candidates);
    if (!plane) {
        return NULL;
    }
    const PlaneSection section = plane_section_of(plane, beam);
    return section_is_plain(tracer, candidates->nearest, &section) ? plane : NULL;
}

void plain_tile_find(const Tracer *tracer, const PixelGrid *grid, const Beam *beam,
                     const BeamCandidates *candidates, PlainTile *tile) {
    tile->is_possible = !grid->path_hashes && !grid->ray_tree && !tracer->textures.material_maps &&
                        !tracer->dielectrics.iors && tracer->emitters.count == 0;
    if (tile->is_possible) {
        tile->candidates = *candidates;
        tile->plane = plain_tile_plane(tracer, beam, candidates);
    }
}

/* --- packets ---------------------------------------------------------------------------------- */

/** Finds the colours of a packet that meets one plane. @param is_clear See plain_points_light().
 *  @return Whether it is plain. */
static bool plain_plane_shade(const Tracer *tracer, const PixelGrid *grid, PixelJitter jitter,
                              GridPosition first, const PlaneEquation *plane, const Shape *shape,
                              bool is_clear, Rgb *colors, RayCounts *counts) {
    PlainPoints points;
    Rgb diffuse[PACKET_VECTORS];
    plain_points_find(&tracer->camera, grid, jitter, first, plane, &points);
    if (!plain_points_light(tracer, &points, shape, is_clear, diffuse, counts)) {
        return false;
    }
    const MaterialPack material = material_pack_splat(&tracer->materials[shape->material]);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        colors[v] = diffuse_color(&material, diffuse[v]);
    }
    return true;
}

bool plain_packet_shade(const Tracer *tracer, const PlainTile *tile, const PixelGrid *grid,
                        PixelJitter jitter, int index, Rgb *colors, RayCounts *counts,
                        const Shape **only_shape) {
    const GridPosition first = grid_packet_position(grid, index);
    BeamCandidates candidates = tile->candidates;
    *only_shape = NULL;
    if (!grid_has_whole_packet(grid, first)) {
        return false;
    }
    if (tile->plane) {
        return plain_plane_shade(tracer, grid, jitter, first, tile->plane, candidates.nearest, true,
                                 colors, counts);
    }
    const Beam beam = camera_packet_beam(&tracer->camera, grid, jitter, index);
    shape_set_narrow_candidates(&tracer->shapes, &beam, &candidates);
    *only_shape = beam_only_shape(&candidates);
    if (!candidates.nearest) {
        return plain_packet_fill_sky(tracer, colors);
    }
    const PlaneEquation *plane = plain_plane(tracer, &beam, &candidates);
    return plane && plain_plane_shade(tracer, grid, jitter, first, plane, candidates.nearest, false,
                                      colors, counts);
}
