/**
 * @file
 * @brief Transformed shape: any shape, scaled, rotated and translated.
 *
 * The inverse transform is applied to the ray: it leads to the local space, where the shape is as
 * its own fields describe it. The direction keeps its new length there, so that t is the same in
 * both spaces. Points come back by the matrix; normals by the transpose of the inverse, which keeps
 * them perpendicular and outwards, also in a reflection.
 *
 * Rays are transformed in the wide precision. A ray from far away restarts just before the shape:
 * its origin, rounded, would else be wrong by an ulp of the whole distance.
 */
#include "trace/shapes/transformed.h"
#include "trace/bvh/slab.h"
#include "trace/shapes/support.h"

/** Bound on the error by transforming a point and a ray that leaves it, in half ulps of their
 *  coordinates. The error of the inner shape adds to it. */
#define TRANSFORMED_ERROR 8

/** Ratio of the restart distance and the radius of the shape: larger than all roundings. */
#define TRANSFORMED_MARGIN ((wide_scalar)1.0625f)

/** Rays to a mesh restart only if they start farther than so many radii from its centre:
 * differences to its vertices are computed in the wide precision, and the rounding of a near origin
 * is a few ulps of the shape. Other shapes are less exact. */
#define TRANSFORMED_NEAR ((wide_scalar)8)

/** A matrix. */
typedef struct Matrix3 {
    Vec3sw rows[3]; /**< The rows. */
} Matrix3;

/** Any shape, transformed. @extends Shape */
typedef struct TransformedShape {
    Shape base;                   /**< Base. */
    const Shape *inner;           /**< The shape in its local space. */
    Matrix3 to_world;             /**< From local to scene coordinates, without the translation. */
    Matrix3 to_local;             /**< Inverse of #to_world. */
    Vec3sw translation;           /**< Origin of the local space, in the scene. */
    Vec3sw center;                /**< Centre of the local bounding box. */
    wide_scalar radius;           /**< Radius of a sphere around that box, with a margin. */
    wide_scalar restart_distance; /**< Rays that start farther from the centre restart. */
    scalar magnitude;             /**< Largest coordinate of #translation. */
    Aabbs bounds;                 /**< Bounding box in the scene. */
} TransformedShape;

/** LANES rays in the local space. */
typedef struct LocalRay {
    Ray ray;      /**< The rays. */
    wide skipped; /**< Distance between the old and the new origin, in lengths of the direction. */
} LocalRay;

/** @return Scale and rotation of a transform. */
static Matrix3 matrix3_of_transform(const Transform *t) {
    Matrix3 matrix;
    for (int i = 0; i < 3; i++) {
        matrix.rows[i] = (Vec3sw){(wide_scalar)t->matrix[i][0], (wide_scalar)t->matrix[i][1],
                                  (wide_scalar)t->matrix[i][2]};
    }
    return matrix;
}

/** @return The transpose. */
static Matrix3 matrix3_transpose(Matrix3 m) {
    const Vec3sw *r = m.rows;
    return (Matrix3){
        {{r[0].x, r[1].x, r[2].x}, {r[0].y, r[1].y, r[2].y}, {r[0].z, r[1].z, r[2].z}}};
}

/** @return The inverse: cross products of columns, over the determinant. @param m A regular matrix.
 */
static Matrix3 matrix3_inverse(Matrix3 m) {
    Matrix3 columns = matrix3_transpose(m), inverse;
    const Vec3sw *c = columns.rows;
    wide_scalar determinant = vec3sw_dot(c[0], vec3sw_cross(c[1], c[2]));
    for (int i = 0; i < 3; i++) {
        Vec3sw product = vec3sw_cross(c[(i + 1) % 3], c[(i + 2) % 3]);
        inverse.rows[i] = vec3sw_scale(product, 1 / determinant);
    }
    return inverse;
}

/** @return Vectors transformed by a matrix. */
INLINE Vec3w matrix3_apply(const Matrix3 *m, Vec3w v) {
    return (Vec3w){vec3w_dot(vec3w_splat(m->rows[0]), v), vec3w_dot(vec3w_splat(m->rows[1]), v),
                   vec3w_dot(vec3w_splat(m->rows[2]), v)};
}

/** @return Vectors transformed by the transpose of a matrix. */
INLINE Vec3w matrix3_apply_transposed(const Matrix3 *m, Vec3w v) {
    Vec3w sum = vec3w_scale(vec3w_splat(m->rows[0]), v.x);
    sum = vec3w_add_scaled(sum, vec3w_splat(m->rows[1]), v.y);
    return vec3w_add_scaled(sum, vec3w_splat(m->rows[2]), v.z);
}

/** Computes the bounding sphere in the local space. @param[in,out] self Sets centre and radius. */
static void transformed_compute_sphere(TransformedShape *self) {
    Aabbs box = self->inner->class->bounds(self->inner);
    if (!aabbs_is_bounded(&box)) {
        self->radius = (wide_scalar)INFINITE;
        return;
    }
    Vec3sw low = {(wide_scalar)box.low[0], (wide_scalar)box.low[1], (wide_scalar)box.low[2]};
    Vec3sw high = {(wide_scalar)box.high[0], (wide_scalar)box.high[1], (wide_scalar)box.high[2]};
    Vec3sw half = vec3sw_scale(vec3sw_subtract(high, low), (wide_scalar)0.5f);
    self->center = vec3sw_subtract(high, half);
    self->radius = (wide_scalar)WIDE_SQRT(vec3sw_dot(half, half)) * TRANSFORMED_MARGIN;
}

/**
 * @return The lowest or the highest value of a coordinate of a transformed box.
 * @param row   Row of the matrix for the coordinate.
 * @param sign  1: the highest; -1: the lowest.
 */
static wide_scalar box_extreme_coordinate(Vec3sw row, const scalar low[3], const scalar high[3],
                                          int sign) {
    const wide_scalar factors[3] = {row.x, row.y, row.z};
    wide_scalar sum = 0;
    for (int axis = 0; axis < 3; axis++) {
        bool takes_high = factors[axis] * (wide_scalar)sign > 0;
        sum += factors[axis] * (wide_scalar)(takes_high ? high[axis] : low[axis]);
    }
    return sum;
}

/** @return The bounding box of the transformed local box. */
static Aabbs transformed_compute_bounds(const TransformedShape *transformed) {
    const Vec3sw *rows = transformed->to_world.rows;
    Aabbs inner = transformed->inner->class->bounds(transformed->inner);
    if (!aabbs_is_bounded(&inner)) {
        return aabbs_infinite(); // It may be turned: no axis keeps its ends.
    }
    Vec3sw corners[2];
    for (int i = 0; i < 2; i++) {
        int sign = i == 0 ? -1 : 1;
        corners[i] = (Vec3sw){box_extreme_coordinate(rows[0], inner.low, inner.high, sign),
                              box_extreme_coordinate(rows[1], inner.low, inner.high, sign),
                              box_extreme_coordinate(rows[2], inner.low, inner.high, sign)};
    }
    Vec3d move = vec3d_of(transformed->translation);
    return aabbs_padded_by_largest(aabbs_from_corners(vec3d_add(vec3d_of(corners[0]), move),
                                                      vec3d_add(vec3d_of(corners[1]), move)));
}

/** See #ShapeClass.init. */
static void transformed_init(Shape *self, const void *parameters) {
    TransformedShape *transformed = (TransformedShape *)self;
    const TransformedParameters *p = parameters;
    transformed->inner = p->inner;
    transformed->to_world = matrix3_of_transform(p->transform);
    transformed->to_local = matrix3_inverse(transformed->to_world);
    transformed->translation = vec3sw_of(p->transform->translate);
    transformed->magnitude = (scalar)vec3d_max_abs(p->transform->translate);
    transformed_compute_sphere(transformed);
    transformed->restart_distance =
        shape_has_bvh(p->inner) ? TRANSFORMED_NEAR * transformed->radius : 0;
    transformed->bounds = transformed_compute_bounds(transformed);
}

/**
 * @return The distance to the bounding sphere, by which the origin of a ray moves; 0 if it starts
 *         near the shape, or if the shape is unbounded.
 * @param origin     Origins in the local space.
 * @param direction  Directions in the local space.
 */
INLINE wide transformed_skipped_length(const TransformedShape *self, Vec3w origin,
                                       Vec3w direction) {
    const wide zero = wide_of(0);
    Vec3w to_middle = vec3w_subtract(vec3w_splat(self->center), origin);
    wide_mask is_far = wide_less(wide_of(self->restart_distance * self->restart_distance),
                                 vec3w_dot(to_middle, to_middle));
    if (!any(narrow_mask(is_far))) {
        return zero;
    }
    wide per_length_squared = 1 / vec3w_dot(direction, direction);
    wide to_nearest = vec3w_dot(to_middle, direction) * per_length_squared;
    wide skipped = to_nearest - wide_of(self->radius) * wide_sqrt(per_length_squared);
    return wide_select(is_far & wide_less(zero, skipped), skipped, zero);
}

/** @return Rays in the local space. */
INLINE LocalRay transformed_to_local(const TransformedShape *self, const Ray *ray) {
    Vec3w from_zero = vec3w_subtract(vec3_widen(ray->origin), vec3w_splat(self->translation));
    Vec3w origin = matrix3_apply(&self->to_local, from_zero);
    Vec3w direction = matrix3_apply(&self->to_local, vec3_widen(ray->direction));
    wide skipped = transformed_skipped_length(self, origin, direction);
    origin = vec3w_add_scaled(origin, direction, skipped);
    return (LocalRay){ray_of(vec3_narrow(origin), vec3_narrow(direction)), skipped};
}

/** @return Points of the scene. @param inner Hits in the local space. */
INLINE SurfacePoint transformed_surface(const TransformedShape *self, const Hit *inner) {
    Vec3w point = matrix3_apply(&self->to_world, vec3_widen(inner->point));
    point = vec3w_add_scaled(point, vec3w_splat(self->translation), wide_of(1));
    // A height e above the surface in local space is a height e / |normal| in the scene.
    Vec3w normal = matrix3_apply_transposed(&self->to_local, vec3_widen(inner->normal));
    wide per_length = 1 / wide_sqrt(vec3w_dot(normal, normal));
    SurfacePoint surface = {.point = vec3_narrow(point),
                            .normal = vec3_narrow(vec3w_scale(normal, per_length))};
    surface.error = inner->error * narrow(per_length) +
                    TRANSFORMED_ERROR * ROUNDOFF * (vec3_max_abs(surface.point) + self->magnitude);
    return surface;
}

/**
 * Writes the lanes in which the shape is nearer.
 * @param[in,out] hit  The nearest hits so far.
 * @param inner        Hits in the local space.
 * @param distance     Distances in the scene.
 */
INLINE void transformed_accept_hit(Hit *hit, mask nearer, const TransformedShape *self,
                                   const Hit *inner, real distance) {
    SurfacePoint surface = transformed_surface(self, inner);
    shape_update_hit(&self->base, hit, nearer, distance, &surface);
    hit->primitive = integer_select(nearer, inner->primitive, hit->primitive);
}

/** See #ShapeClass.is_hit. @callgraph */
static mask transformed_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const TransformedShape *transformed = (const TransformedShape *)self;
    const Shape *inner = transformed->inner;
    LocalRay local = transformed_to_local(transformed, ray);
    Hit local_hit = hit_none(real_of(INFINITE));
    mask is_hit_local = inner->class->is_hit(inner, &local.ray, active, &local_hit);
    if (!any(is_hit_local)) {
        return is_hit_local;
    }
    real distance = narrow(local.skipped + widen(local_hit.distance));
    mask nearer = hit_is_nearer(hit, is_hit_local, distance, self->index);
    if (any(nearer)) {
        transformed_accept_hit(hit, nearer, transformed, &local_hit, distance);
    }
    return nearer;
}

/** See #ShapeClass.is_occluding. */
static mask transformed_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    const TransformedShape *transformed = (const TransformedShape *)self;
    const Shape *inner = transformed->inner;
    LocalRay local = transformed_to_local(transformed, ray);
    real local_limit = narrow(widen(limit) - local.skipped);
    return inner->class->is_occluding(inner, &local.ray, active, local_limit);
}

/** @return How far the inner shape reaches in its local space. See #ShapeClass.support. */
INLINE real transformed_inner_support(const Shape *inner, Vec3 directions) {
    const Vec3s origin = {0, 0, 0};
    if (inner->class->support) {
        return inner->class->support(inner, origin, directions);
    }
    const Aabbs box = inner->class->bounds(inner);
    return support_of_box(box.low, box.high, origin, directions);
}

/** As far as the inner shape reaches along the directions in the local space. See
 *  #ShapeClass.support. */
static real transformed_support(const Shape *self, Vec3s from, Vec3 directions) {
    const TransformedShape *transformed = (const TransformedShape *)self;
    const Aabbs *box = &transformed->bounds;
    const scalar size =
        (box->high[0] - box->low[0]) + (box->high[1] - box->low[1]) + (box->high[2] - box->low[2]);
    Vec3 local =
        vec3_narrow(matrix3_apply_transposed(&transformed->to_world, vec3_widen(directions)));
    return support_of_point(support_vector(from, transformed->translation), size, directions) +
           transformed_inner_support(transformed->inner, local);
}

/** See #ShapeClass.bounds. */
static Aabbs transformed_bounds(const Shape *self) {
    return ((const TransformedShape *)self)->bounds;
}

/** @return The texture coordinates in the local space. See #ShapeClass.texture_uv. */
static TextureUv transformed_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    const TransformedShape *transformed = (const TransformedShape *)self;
    const Shape *inner = transformed->inner;
    Vec3w from_zero = vec3w_subtract(vec3_widen(hit->point), vec3w_splat(transformed->translation));
    // Normals go to the scene by the transpose of the inverse, and back by the transpose.
    Vec3w normal = matrix3_apply_transposed(&transformed->to_world, vec3_widen(hit->normal));
    Hit local = *hit;
    local.point = vec3_narrow(matrix3_apply(&transformed->to_local, from_zero));
    local.normal = vec3_narrow(vec3w_scale(normal, 1 / wide_sqrt(vec3w_dot(normal, normal))));
    return shape_texture_uv(inner, &local, lanes);
}

/** See #ShapeExtension.count_steps. */
static real transformed_count_steps(const Shape *self, const Ray *ray, mask active, real limit,
                                    MarchLog *log) {
    const TransformedShape *transformed = (const TransformedShape *)self;
    const Shape *inner = transformed->inner;
    LocalRay local = transformed_to_local(transformed, ray);
    real local_limit = narrow(widen(limit) - local.skipped);
    MarchLog counts = {0}; // A stretched sphere is none: its steps are counted, but not recorded.
    real steps = inner->class->extension->count_steps(inner, &local.ray, active, local_limit,
                                                      log ? &counts : NULL);
    if (log) {
        log->operations += counts.operations;
    }
    return steps;
}

/* --- whole packets --------------------------------------------------------------------------- */

/**
 * @return A packet in the local space; only rays that meet the bounding box stay active.
 * @param limits        Largest distances.
 * @param[out] skipped  See #LocalRay.skipped.
 */
static Packet transformed_packet_to_local(const TransformedShape *self, const Packet *packet,
                                          const real *limits, wide *skipped) {
    Aabb box = aabb_splat(self->bounds);
    Packet local_packet;
    packet_init(&local_packet, packet_vector_count(packet), packet->wants_points);
    for (int v = 0; v < packet_vector_count(packet); v++) {
        const Ray *ray = &packet->rays[v];
        LocalRay local_ray = {*ray, wide_of(0)};
        real near;
        local_packet.active[v] = packet->active[v] & slab_intersects(ray, &box, limits[v], &near);
        if (any(local_packet.active[v])) {
            local_ray = transformed_to_local(self, ray);
        }
        local_packet.rays[v] = local_ray.ray;
        local_packet.limit[v] = narrow(widen(packet->limit[v]) - local_ray.skipped);
        skipped[v] = local_ray.skipped;
    }
    return local_packet;
}

/** See #ShapeExtension.closest_hits. @callgraph */
static void transformed_closest_hits(const Shape *self, const Packet *packet, Hit *hits) {
    const TransformedShape *transformed = (const TransformedShape *)self;
    wide skipped[PACKET_VECTORS];
    real limits[PACKET_VECTORS];
    Hit local_hit[PACKET_VECTORS];
    for (int v = 0; v < packet_vector_count(packet); v++) {
        limits[v] = hits[v].distance;
        local_hit[v] = hit_none(real_of(INFINITE));
    }
    Packet local_packet = transformed_packet_to_local(transformed, packet, limits, skipped);
    if (packet_active_count(&local_packet) == 0) {
        return;
    }
    transformed->inner->class->extension->closest_hits(transformed->inner, &local_packet,
                                                       local_hit);
    for (int v = 0; v < packet_vector_count(packet); v++) {
        mask is_hit_local = local_packet.active[v] & (local_hit[v].shape >= integer_of(0));
        real distance = narrow(skipped[v] + widen(local_hit[v].distance));
        mask nearer = hit_is_nearer(&hits[v], is_hit_local, distance, self->index);
        if (any(nearer)) {
            transformed_accept_hit(&hits[v], nearer, transformed, &local_hit[v], distance);
        }
    }
}

/** See #ShapeExtension.occluded. */
static void transformed_occluded(const Shape *self, const Packet *packet, mask *occluded) {
    const TransformedShape *transformed = (const TransformedShape *)self;
    wide skipped[PACKET_VECTORS];
    Packet local_packet = transformed_packet_to_local(transformed, packet, packet->limit, skipped);
    if (packet_active_count(&local_packet) > 0) {
        transformed->inner->class->extension->occluded(transformed->inner, &local_packet, occluded);
    }
}

/** Around a shape with its own BVH. */
static const ShapeExtension transformed_bvh_extension = {
    .has_bvh = true,
    .closest_hits = transformed_closest_hits,
    .occluded = transformed_occluded,
};

/** Around a field. */
static const ShapeExtension transformed_field_extension = {.count_steps = transformed_count_steps};

/** The methods that all three classes share. */
#define TRANSFORMED_METHODS                                                                        \
    .size = sizeof(TransformedShape), .init = transformed_init, .is_hit = transformed_is_hit,      \
    .is_occluding = transformed_is_occluding, .bounds = transformed_bounds,                        \
    .texture_uv = transformed_texture_uv

const ShapeClass transformed_class = {TRANSFORMED_METHODS,
                                      .support = METHOD_OF_BEAMS(transformed_support)};

const ShapeClass transformed_bvh_class = {TRANSFORMED_METHODS,
                                          .support = METHOD_OF_BEAMS(transformed_support),
                                          .extension = &transformed_bvh_extension};

const ShapeClass transformed_field_class = {TRANSFORMED_METHODS,
                                            .extension = &transformed_field_extension};
