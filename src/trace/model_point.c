/**
 * @file
 * @brief From triangles to hits: where rays meet the triangles of a model, and with which normals.
 */
#include "trace/model_point.h"

#include "trace/corners.h"
#include "trace/shapes/smooth.h"

/** Half ulps of the coordinates that a point can be off its triangle. */
#define TRIANGLE_ERROR 8
/** @return The triangle that each lane met. @param model The model. @param slots Their slots.
 *  @param met The lanes that met any; the others get the first. */
static Corners corners_gather(const Model *model, integer slots, mask met) {
    slots = integer_select(met, slots, integer_of(0));
    // A block's numbers lie in rows of #LANES: the corners' x, y and z.
    integer lane = slots & integer_of(LANES - 1);
    integer place = (slots - lane) * (BLOCK_NUMBERS / LANES) + lane;
    const scalar *numbers = (const scalar *)(const void *)model->blocks;
    Corners corners;
    for (int i = 0; i < 3; i++) {
        const scalar *corner = numbers + 3 * i * LANES;
        corners.at[i] = (Vector){real_gather(corner, place), real_gather(corner + LANES, place),
                                 real_gather(corner + 2 * LANES, place)};
    }
    return corners;
}

/** @return The normals at the corners of the triangle that each lane met. @param model The model,
 *  not flat. @param slots Their slots. @param met The lanes that met any. */
static Corners normals_gather(const Model *model, integer slots, mask met) {
    Vector up = {real_of(0), real_of(1), real_of(0)};
    Corners normals = {{up, up, up}};
    for (unsigned left = mask_bits(met); left; left &= left - 1) {
        int lane = __builtin_ctz(left), slot = integer_lane(slots, lane);
        for (int i = 0; i < 3; i++) {
            const Point *normal = &model->normals[model->places[slot].at[i]];
            real_set_lane(&normals.at[i].x, lane, normal->x);
            real_set_lane(&normals.at[i].y, lane, normal->y);
            real_set_lane(&normals.at[i].z, lane, normal->z);
        }
    }
    return normals;
}

/**
 * @return Interpolated unit normals; the flat one where the three cancel out.
 * @param corners  Triangles.
 * @param normals  The normals at their corners.
 * @param ray      The rays that meet them.
 * @param flat     The triangles' own unit normals.
 */
static Vector normal_interpolate(const Corners *corners, const Corners *normals, const Ray *ray,
                                 Vector flat) {
    MainAxes along = shear_main_axes(ray, mask_of(true));
    Vector shares = corners_shares(corners, ray, 2);
    shares = vector_select(along.x, corners_shares(corners, ray, 0), shares);
    shares = vector_select(along.y, corners_shares(corners, ray, 1), shares);
    // The areas have one sign; what counts is how they compare.
    Vector sum = vector_scale(normals->at[0], real_abs(shares.x));
    sum = vector_add(sum, vector_scale(normals->at[1], real_abs(shares.y)));
    sum = vector_add(sum, vector_scale(normals->at[2], real_abs(shares.z)));
    real largest = vector_largest(sum);
    Vector normal = vector_normalize(vector_scale(sum, 1 / largest));
    mask is_good =
        (largest > 0) & (largest < INFINITE) & (vector_dot(normal, normal) > real_of((scalar)0.5));
    return vector_select(is_good, normal, flat);
}

Hit model_hit(const Model *model, const Ray *ray, real distance, integer slots, mask met,
              int place) {
    Corners corners = corners_gather(model, slots, met);
    Vector flat = corners_unit_normal(&corners), normal = flat;
    Vector point = vector_add(ray->origin, vector_scale(ray->direction, distance));
    real height = vector_dot(flat, vector_subtract(point, corners.at[0]));
    point = vector_subtract(point, vector_scale(flat, height));
    real reach = vector_largest(point) + real_of(model->reach);
    real error = TRIANGLE_ERROR * ROUNDOFF * reach;
    if (model->normals) {
        Corners normals = normals_gather(model, slots, met);
        normal = normal_interpolate(&corners, &normals, ray, flat);
        // Files disagree on the corners' order: which way is outwards their normals say.
        flat = vector_select(vector_dot(flat, normal) < 0, vector_scale(flat, real_of(-1)), flat);
        normal = normal_keep_side(normal, flat, ray->direction);
        // Along a normal that leans, it is farther out of the plane's error.
        error = error / vector_dot(normal, flat);
    }
    return (Hit){distance, point, normal, error, integer_of(place), slots};
}

/** @return How much of each corner is in points of triangles, 0 to 1. @param corners Triangles.
 *  @param point The points. */
static Vector shares_at(const Corners *corners, Vector point) {
    WideVector a = vector_widen(corners->at[0]), normal = corners_normal(corners);
    WideVector b = wide_subtract(vector_widen(corners->at[1]), a);
    WideVector c = wide_subtract(vector_widen(corners->at[2]), a);
    WideVector arm = wide_subtract(vector_widen(point), a);
    wide per_area = 1 / wide_dot(normal, normal);
    // The areas between the point and two corners each, over the whole one.
    real of_b = narrow(wide_dot(wide_cross(arm, c), normal) * per_area);
    real of_c = narrow(wide_dot(wide_cross(b, arm), normal) * per_area);
    const real zero = real_of(0), one = real_of(1);
    of_b = real_min(real_max(of_b, zero), one);
    of_c = real_min(real_max(of_c, zero), one);
    return (Vector){real_max(one - of_b - of_c, zero), of_b, of_c};
}

TexturePlace model_texture_place(const Model *model, const Hit *hit, mask lanes) {
    TexturePlace place = {real_of(0), real_of(0), mask_of(true), mask_of(true)};
    if (!model->spots) {
        return place;
    }
    Corners corners = corners_gather(model, hit->part, lanes);
    Vector shares = shares_at(&corners, hit->point);
    const real parts[3] = {shares.x, shares.y, shares.z};
    for (unsigned left = mask_bits(lanes); left; left &= left - 1) {
        int lane = __builtin_ctz(left), slot = integer_lane(hit->part, lane);
        scalar u = 0, v = 0;
        for (int i = 0; i < 3; i++) {
            const Spot *spot = &model->spots[model->spot_at[slot].at[i]];
            u += spot->u * real_lane(parts[i], lane);
            v += spot->v * real_lane(parts[i], lane);
        }
        real_set_lane(&place.u, lane, u);
        real_set_lane(&place.v, lane, v);
    }
    return place;
}
