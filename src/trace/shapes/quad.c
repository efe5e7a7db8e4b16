/**
 * @file
 * @brief Quad: a parallelogram, seen from both sides.
 */
#include "trace/shapes/flat.h"
#include "trace/shapes/registry.h"
#include "trace/shapes/shear.h"

/** Corners of a quad. */
enum { QUAD_CORNERS = 4 };

/** What a scene file says of a quad. */
typedef struct QuadParameters {
    Vector3 corner; /**< One corner. */
    Vector3 u;      /**< From it to the next. */
    Vector3 v;      /**< From it to the one on the other side. */
} QuadParameters;

/** A quad. @extends Shape */
typedef struct Quad {
    Shape base;                   /**< What all shapes have. */
    Flat flat;                    /**< The plane that it lies in; its normal is u x v. */
    Corner corners[QUAD_CORNERS]; /**< Its corners, in turn. */
} Quad;

/** Fields of `quad`. */
static const Parameter quad_parameters[] = {{.name = "corner",
                                             .type = PARAMETER_POINT,
                                             .offset = offsetof(QuadParameters, corner),
                                             .minimum = -LENGTH_MAXIMUM,
                                             .maximum = LENGTH_MAXIMUM,
                                             .unit = "scene units",
                                             .help = "one corner"},
                                            {.name = "u",
                                             .type = PARAMETER_DIRECTION,
                                             .offset = offsetof(QuadParameters, u),
                                             .minimum = -LENGTH_MAXIMUM,
                                             .maximum = LENGTH_MAXIMUM,
                                             .unit = "scene units",
                                             .help = "from it to the next corner"},
                                            {.name = "v",
                                             .type = PARAMETER_DIRECTION,
                                             .offset = offsetof(QuadParameters, v),
                                             .minimum = -LENGTH_MAXIMUM,
                                             .maximum = LENGTH_MAXIMUM,
                                             .unit = "scene units",
                                             .help = "from it to the corner on the other side"},
                                            {0}};

/** A square of side 1 that faces the viewer. */
static const QuadParameters quad_defaults = {.u = {1, 0, 0}, .v = {0, 1, 0}};

/**
 * Refuses quads without area. See #Keyword.finish.
 * @param[in,out] values  A #QuadParameters.
 * @param given           Not looked at.
 * @param[out] error      What is wrong.
 * @return Whether the quad has an area.
 */
static bool quad_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const QuadParameters *p = values;
    /** Sine of the angle below which two edges count as parallel: a double cannot tell less. */
    const double parallel = 1e-12;
    Vector3 normal = vector3_cross(vector3_normalize(p->u), vector3_normalize(p->v));
    return vector3_length(normal) > parallel ||
           error_set(error, STATUS_SCENE, "quad has no area: u and v are parallel");
}

/** Makes a quad. @param self The quad. @param parameters A #QuadParameters. */
static void quad_init(Shape *self, const void *parameters) {
    Quad *quad = (Quad *)self;
    const QuadParameters *p = parameters;
    Vector3 next = vector3_add(p->corner, p->u), last = vector3_add(p->corner, p->v);
    WidePoint u = wide_point_of(vector3_scaled(p->u)), v = wide_point_of(vector3_scaled(p->v));
    quad->flat = flat_of(p->corner, wide_point_cross(u, v));
    quad->corners[0] = corner_of(p->corner);
    quad->corners[1] = corner_of(next);
    quad->corners[2] = corner_of(vector3_add(next, p->v));
    quad->corners[3] = corner_of(last);
}

/** @return The lanes where the quad is nearer. See #ShapeClass.is_hit. @callgraph
 *  @param self The quad. @param ray The rays. @param active The lanes. @param[in,out] hit The hit.
 */
static mask quad_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Quad *quad = (const Quad *)self;
    mask inside = shear_is_inside(quad->corners, QUAD_CORNERS, ray, active);
    if (!any(inside)) {
        return inside;
    }
    real distance = flat_distance(&quad->flat, ray);
    mask nearer = hit_is_nearer(hit, inside, distance, self->place);
    if (any(nearer)) {
        Hit found = flat_hit(&quad->flat, ray, distance, self->place);
        hit_take(hit, nearer, &found);
    }
    return nearer;
}

/** @return The lanes where the quad is on the way. See #ShapeClass.is_blocking.
 *  @param self The quad. @param ray The rays. @param active The lanes. @param limit The way's end.
 */
static mask quad_is_blocking(const Shape *self, const Ray *ray, mask active, real limit) {
    const Quad *quad = (const Quad *)self;
    mask inside = shear_is_inside(quad->corners, QUAD_CORNERS, ray, active);
    if (!any(inside)) {
        return inside;
    }
    real distance = flat_distance(&quad->flat, ray);
    return inside & (distance > 0) & (distance < limit);
}

/** @return The box around a quad. @param self The quad. */
static Bounds quad_bounds(const Shape *self) {
    return corners_bounds(((const Quad *)self)->corners, QUAD_CORNERS);
}

/** @return Where on a picture points of a quad lie: how much of u and v it takes to get there. See
 *  #ShapeClass.texture_place. @param self The quad. @param hit The points. @param lanes Not looked
 *  at. */
static TexturePlace quad_texture_place(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Quad *quad = (const Quad *)self;
    WidePoint corner = corner_widen(quad->corners[0]);
    WidePoint u = wide_point_subtract(corner_widen(quad->corners[1]), corner);
    WidePoint v = wide_point_subtract(corner_widen(quad->corners[3]), corner);
    Shares shares = shares_of(u, v);
    WideVector arm = wide_subtract(vector_widen(hit->point), wide_vector_of(corner));
    return (TexturePlace){.u = narrow(wide_dot(arm, wide_vector_of(shares.of_first))),
                          .v = narrow(wide_dot(arm, wide_vector_of(shares.of_second))),
                          .around_u = mask_of(false),
                          .around_v = mask_of(false)};
}

const ShapeClass quad_class = {
    .keyword = {.name = "quad",
                .help = "a parallelogram",
                .parameters = quad_parameters,
                .size = sizeof(QuadParameters),
                .defaults = &quad_defaults,
                .finish = quad_finish},
    .size = sizeof(Quad),
    .is_flat = true,
    .init = quad_init,
    .is_hit = quad_is_hit,
    .is_blocking = quad_is_blocking,
    .bounds = quad_bounds,
    .texture_place = quad_texture_place,
};
