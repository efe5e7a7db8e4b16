/**
 * @file
 * @brief Any shape, stretched, turned and moved.
 *
 * Not the shape is transformed but the ray, the other way round: into the space in which the shape
 * is as its own fields say it. The direction keeps its new length there, so that t is the same in
 * both. The point comes back by the matrix; the normal by the transpose of the inverse, which keeps
 * it at right angles and outwards, also in a mirror.
 *
 * Rays are transformed in the wide precision, and a ray that comes from afar starts anew just
 * before it reaches the shape: else its start, rounded, would be off by an ulp of all of the way.
 */
#include "trace/shapes/transformed.h"
#include "trace/slab.h"

/** Half ulps of the coordinates that a point, and a ray that leaves it, can be off by transforming
 *  them; the shape's own error comes on top. */
#define TRANSFORMED_ERROR 8

/** How much farther than the shape reaches a ray starts anew: more than all roundings. */
#define TRANSFORMED_MARGIN ((wide_scalar)1.0625f)

/** Rays to a shape of triangles that start no farther than this from its middle, in units of how
 * far it reaches, go the whole way: differences to its corners are taken in the wide precision, and
 *  what is rounded of their start is a few ulps of the shape. Other shapes are less exact. */
#define TRANSFORMED_NEAR ((wide_scalar)8)

/** A matrix by its rows. */
typedef struct Matrix {
    WidePoint row[3]; /**< The rows. */
} Matrix;

/** Any shape, transformed. @extends Shape */
typedef struct Transformed {
    Shape base;           /**< What all shapes have. */
    const Shape *inner;   /**< The shape before it is transformed. */
    Matrix forth;         /**< From its space to the scene's, but for the move. */
    Matrix back;          /**< The inverse. */
    WidePoint move;       /**< Where the zero of its space goes. */
    WidePoint middle;     /**< Middle of the shape's box, in its space. */
    wide_scalar distance; /**< A little more than how far the shape reaches from there. */
    wide_scalar near;     /**< Rays that start no farther from there start anew nowhere. */
    scalar reach;         /**< Largest coordinate of the move. */
    Bounds bounds;        /**< The box around it, in the scene. */
} Transformed;

/** LANES rays in a shape's own space. */
typedef struct Local {
    Ray ray;      /**< The rays. */
    wide skipped; /**< How much of each was left out at its start, in lengths of the direction. */
} Local;

/** @return The matrix of a transform. @param t The transform. */
static Matrix matrix_of(const Transform *t) {
    Matrix matrix;
    for (int i = 0; i < 3; i++) {
        matrix.row[i] = (WidePoint){(wide_scalar)t->linear[i][0], (wide_scalar)t->linear[i][1],
                                    (wide_scalar)t->linear[i][2]};
    }
    return matrix;
}

/** @return The rows as columns. @param m A matrix. */
static Matrix matrix_transpose(Matrix m) {
    const WidePoint *r = m.row;
    return (Matrix){{{r[0].x, r[1].x, r[2].x}, {r[0].y, r[1].y, r[2].y}, {r[0].z, r[1].z, r[2].z}}};
}

/** @return The inverse: products of two columns, over the determinant. @param m A matrix that has
 *          one. */
static Matrix matrix_inverse(Matrix m) {
    Matrix columns = matrix_transpose(m), inverse;
    const WidePoint *c = columns.row;
    wide_scalar determinant = wide_point_dot(c[0], wide_point_cross(c[1], c[2]));
    for (int i = 0; i < 3; i++) {
        WidePoint product = wide_point_cross(c[(i + 1) % 3], c[(i + 2) % 3]);
        inverse.row[i] = wide_point_scale(product, 1 / determinant);
    }
    return inverse;
}

/** @return Vectors transformed. @param m The matrix. @param v Vectors. */
INLINE WideVector matrix_apply(const Matrix *m, WideVector v) {
    return (WideVector){wide_dot(wide_vector_of(m->row[0]), v),
                        wide_dot(wide_vector_of(m->row[1]), v),
                        wide_dot(wide_vector_of(m->row[2]), v)};
}

/** @return Vectors transformed by the transpose. @param m The matrix. @param v Vectors. */
INLINE WideVector matrix_apply_transposed(const Matrix *m, WideVector v) {
    WideVector sum = wide_scale(wide_vector_of(m->row[0]), v.x);
    sum = wide_add_scaled(sum, wide_vector_of(m->row[1]), v.y);
    return wide_add_scaled(sum, wide_vector_of(m->row[2]), v.z);
}

/** Finds where a shape is in its own space. @param[in,out] self Its middle and how far it reaches
 *  are filled. */
static void transformed_measure(Transformed *self) {
    Bounds box = self->inner->class->bounds(self->inner);
    if (box.high[0] == INFINITE) {
        self->distance = (wide_scalar)INFINITE;
        return;
    }
    WidePoint low = {(wide_scalar)box.low[0], (wide_scalar)box.low[1], (wide_scalar)box.low[2]};
    WidePoint high = {(wide_scalar)box.high[0], (wide_scalar)box.high[1], (wide_scalar)box.high[2]};
    WidePoint half = wide_point_scale(wide_point_subtract(high, low), (wide_scalar)0.5f);
    self->middle = wide_point_subtract(high, half);
    self->distance = (wide_scalar)WIDE_SQRT(wide_point_dot(half, half)) * TRANSFORMED_MARGIN;
}

/**
 * @return The lowest, or the highest, that a coordinate of a transformed box can be.
 * @param row   The row of the matrix that makes the coordinate.
 * @param low   The box's lowest coordinates.
 * @param high  Its highest.
 * @param sign  1: the highest; -1: the lowest.
 */
static wide_scalar farthest(WidePoint row, const scalar low[3], const scalar high[3], int sign) {
    const wide_scalar factors[3] = {row.x, row.y, row.z};
    wide_scalar sum = 0;
    for (int axis = 0; axis < 3; axis++) {
        bool takes_high = factors[axis] * (wide_scalar)sign > 0;
        sum += factors[axis] * (wide_scalar)(takes_high ? high[axis] : low[axis]);
    }
    return sum;
}

/** @return The box around a shape's transformed box. @param transformed The shape, but for its
 *  bounds. */
static Bounds transformed_box(const Transformed *transformed) {
    const WidePoint *rows = transformed->forth.row;
    Bounds inner = transformed->inner->class->bounds(transformed->inner);
    if (inner.high[0] == INFINITE) {
        return inner;
    }
    WidePoint corners[2];
    for (int i = 0; i < 2; i++) {
        int sign = i == 0 ? -1 : 1;
        corners[i] = (WidePoint){farthest(rows[0], inner.low, inner.high, sign),
                                 farthest(rows[1], inner.low, inner.high, sign),
                                 farthest(rows[2], inner.low, inner.high, sign)};
    }
    Vector3 move = vector3_of(transformed->move);
    return bounds_slackened(bounds_around(vector3_add(vector3_of(corners[0]), move),
                                          vector3_add(vector3_of(corners[1]), move)));
}

/** Makes a transformed shape. @param self The shape. @param parameters #TransformedParameters. */
static void transformed_init(Shape *self, const void *parameters) {
    Transformed *transformed = (Transformed *)self;
    const TransformedParameters *p = parameters;
    transformed->inner = p->inner;
    transformed->forth = matrix_of(p->transform);
    transformed->back = matrix_inverse(transformed->forth);
    transformed->move = wide_point_of(p->transform->translate);
    transformed->reach = (scalar)vector3_largest(p->transform->translate);
    transformed_measure(transformed);
    transformed->near = p->inner->class->nearest ? TRANSFORMED_NEAR * transformed->distance : 0;
    transformed->bounds = transformed_box(transformed);
}

/**
 * @return How much of rays may be left out: the way to where they can first meet the shape; nothing
 *         where they start near it, or where the shape has no end.
 * @param self       The shape.
 * @param origin     Where they start, in its space.
 * @param direction  Which way, in its space.
 */
INLINE wide transformed_skip(const Transformed *self, WideVector origin, WideVector direction) {
    const wide zero = wide_of(0);
    WideVector to_middle = wide_subtract(wide_vector_of(self->middle), origin);
    wide_mask is_far = wide_below(wide_of(self->near * self->near), wide_dot(to_middle, to_middle));
    if (!any(narrow_mask(is_far))) {
        return zero;
    }
    wide per_length_squared = 1 / wide_dot(direction, direction);
    wide to_nearest = wide_dot(to_middle, direction) * per_length_squared;
    wide skip = to_nearest - wide_of(self->distance) * wide_sqrt(per_length_squared);
    return wide_select(is_far & wide_below(zero, skip), skip, zero);
}

/** @return Rays in a shape's own space. @param self The shape. @param ray The rays. */
INLINE Local transformed_local(const Transformed *self, const Ray *ray) {
    WideVector from_zero = wide_subtract(vector_widen(ray->origin), wide_vector_of(self->move));
    WideVector origin = matrix_apply(&self->back, from_zero);
    WideVector direction = matrix_apply(&self->back, vector_widen(ray->direction));
    wide skipped = transformed_skip(self, origin, direction);
    origin = wide_add_scaled(origin, direction, skipped);
    return (Local){ray_of(vector_narrow(origin), vector_narrow(direction)), skipped};
}

/**
 * @return What was met in a shape's own space, as the scene sees it.
 * @param self      The shape.
 * @param inner     What was met.
 * @param distance  Where, in the scene.
 */
INLINE Hit transformed_hit(const Transformed *self, const Hit *inner, real distance) {
    WideVector point = matrix_apply(&self->forth, vector_widen(inner->point));
    point = wide_add_scaled(point, wide_vector_of(self->move), wide_of(1));
    // What lies e above the surface there lies e / |normal| above it here.
    WideVector normal = matrix_apply_transposed(&self->back, vector_widen(inner->normal));
    wide per_length = 1 / wide_sqrt(wide_dot(normal, normal));
    Hit found = hit_nothing(distance);
    found.point = vector_narrow(point);
    found.normal = vector_narrow(wide_scale(normal, per_length));
    found.error = inner->error * narrow(per_length) +
                  TRANSFORMED_ERROR * ROUNDOFF * (vector_largest(found.point) + self->reach);
    found.shape = integer_of(self->base.place);
    return found;
}

/**
 * Writes the lanes in which a shape is nearer.
 * @param[in,out] hit  What was met so far.
 * @param nearer       The lanes to write.
 * @param self         The shape.
 * @param inner        What was met in its own space.
 * @param distance     Where, in the scene.
 */
INLINE void transformed_take(Hit *hit, mask nearer, const Transformed *self, const Hit *inner,
                             real distance) {
    Hit found = transformed_hit(self, inner, distance);
    hit_take(hit, nearer, &found);
    hit->part = integer_select(nearer, inner->part, hit->part);
}

/** @return The lanes where the shape is nearer. See #ShapeClass.is_hit. @callgraph
 *  @param self The shape. @param ray The rays. @param active The lanes. @param[in,out] hit The hit.
 */
static mask transformed_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Transformed *transformed = (const Transformed *)self;
    const Shape *inner = transformed->inner;
    Local local = transformed_local(transformed, ray);
    Hit met = hit_nothing(real_of(INFINITE));
    mask is_met = inner->class->is_hit(inner, &local.ray, active, &met);
    if (!any(is_met)) {
        return is_met;
    }
    real distance = narrow(local.skipped + widen(met.distance));
    mask nearer = hit_is_nearer(hit, is_met, distance, self->place);
    if (any(nearer)) {
        transformed_take(hit, nearer, transformed, &met, distance);
    }
    return nearer;
}

/** @return The lanes where the shape is on the way. See #ShapeClass.is_blocking.
 *  @param self The shape. @param ray The rays. @param active The lanes. @param limit The way's end.
 */
static mask transformed_is_blocking(const Shape *self, const Ray *ray, mask active, real limit) {
    const Transformed *transformed = (const Transformed *)self;
    const Shape *inner = transformed->inner;
    Local local = transformed_local(transformed, ray);
    real left = narrow(widen(limit) - local.skipped);
    return inner->class->is_blocking(inner, &local.ray, active, left);
}

/** @return The box around it. @param self The shape. */
static Bounds transformed_bounds(const Shape *self) {
    return ((const Transformed *)self)->bounds;
}

/**
 * @return Where on a picture points of the shape lie: where they lie in its own space. See
 *         #ShapeClass.texture_place.
 * @param self   The shape.
 * @param hit    The points.
 * @param lanes  The lanes that count.
 */
static TexturePlace transformed_texture_place(const Shape *self, const Hit *hit, mask lanes) {
    const Transformed *transformed = (const Transformed *)self;
    const Shape *inner = transformed->inner;
    WideVector from_zero =
        wide_subtract(vector_widen(hit->point), wide_vector_of(transformed->move));
    // The normal went forth by the transpose of the inverse, and comes back by the transpose.
    WideVector normal = matrix_apply_transposed(&transformed->forth, vector_widen(hit->normal));
    Hit local = *hit;
    local.point = vector_narrow(matrix_apply(&transformed->back, from_zero));
    local.normal = vector_narrow(wide_scale(normal, 1 / wide_sqrt(wide_dot(normal, normal))));
    return shape_texture_place(inner, &local, lanes);
}

/** @return How many steps rays take to the shape. See #ShapeClass.steps. @param self The shape.
 *  @param ray The rays. @param active The lanes. @param limit The way's end. */
static real transformed_steps(const Shape *self, const Ray *ray, mask active, real limit) {
    const Transformed *transformed = (const Transformed *)self;
    const Shape *inner = transformed->inner;
    if (!inner->class->steps) {
        return real_of(0);
    }
    Local local = transformed_local(transformed, ray);
    real left = narrow(widen(limit) - local.skipped);
    return inner->class->steps(inner, &local.ray, active, left);
}

/* --- shapes that take whole packets ---------------------------------------------------------- */

/** @return The same box for every ray. @param box The box. */
INLINE BoundsBlock bounds_spread(const Bounds *box) {
    BoundsBlock same;
    for (int axis = 0; axis < 3; axis++) {
        same.planes[axis] = real_of(box->low[axis]);
        same.planes[axis + 3] = real_of(box->high[axis]);
    }
    return same;
}

/**
 * @return A packet in a shape's own space; active are only the rays that may meet it.
 * @param self      The shape.
 * @param packet    The rays.
 * @param limits    How far each looks.
 * @param[out] skipped  How much of each ray was left out.
 */
static Packet transformed_packet(const Transformed *self, const Packet *packet, const real *limits,
                                 wide *skipped) {
    BoundsBlock box = bounds_spread(&self->bounds);
    Packet inside;
    inside.wants_points = packet->wants_points;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Ray *ray = &packet->rays[v];
        Local local = {*ray, wide_of(0)};
        real near;
        inside.active[v] = packet->active[v] & slab_meets(ray, &box, limits[v], &near);
        if (any(inside.active[v])) {
            local = transformed_local(self, ray);
        }
        inside.rays[v] = local.ray;
        inside.limit[v] = narrow(widen(packet->limit[v]) - local.skipped);
        skipped[v] = local.skipped;
    }
    return inside;
}

/** Finds where a packet meets the shape. See #ShapeClass.nearest. @callgraph @param self The shape.
 *  @param packet The rays. @param[in,out] hits What they met. */
static void transformed_nearest(const Shape *self, const Packet *packet, Hit *hits) {
    const Transformed *transformed = (const Transformed *)self;
    wide skipped[PACKET_VECTORS];
    real limits[PACKET_VECTORS];
    Hit met[PACKET_VECTORS];
    for (int v = 0; v < PACKET_VECTORS; v++) {
        limits[v] = hits[v].distance;
        met[v] = hit_nothing(real_of(INFINITE));
    }
    Packet inside = transformed_packet(transformed, packet, limits, skipped);
    if (packet_count(&inside) == 0) {
        return;
    }
    transformed->inner->class->nearest(transformed->inner, &inside, met);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        mask is_met = inside.active[v] & (met[v].shape >= integer_of(0));
        real distance = narrow(skipped[v] + widen(met[v].distance));
        mask nearer = hit_is_nearer(&hits[v], is_met, distance, self->place);
        if (any(nearer)) {
            transformed_take(&hits[v], nearer, transformed, &met[v], distance);
        }
    }
}

/** Finds which rays of a packet the shape blocks. See #ShapeClass.blocked. @param self The shape.
 *  @param packet The rays. @param[in,out] blocked Those that are. */
static void transformed_blocked(const Shape *self, const Packet *packet, mask *blocked) {
    const Transformed *transformed = (const Transformed *)self;
    wide skipped[PACKET_VECTORS];
    Packet inside = transformed_packet(transformed, packet, packet->limit, skipped);
    if (packet_count(&inside) > 0) {
        transformed->inner->class->blocked(transformed->inner, &inside, blocked);
    }
}

const ShapeClass transformed_packets_class = {
    .size = sizeof(Transformed),
    .init = transformed_init,
    .is_hit = transformed_is_hit,
    .is_blocking = transformed_is_blocking,
    .nearest = transformed_nearest,
    .blocked = transformed_blocked,
    .bounds = transformed_bounds,
    .texture_place = transformed_texture_place,
};

const ShapeClass transformed_class = {
    .size = sizeof(Transformed),
    .init = transformed_init,
    .is_hit = transformed_is_hit,
    .is_blocking = transformed_is_blocking,
    .bounds = transformed_bounds,
    .texture_place = transformed_texture_place,
    .steps = transformed_steps,
};
