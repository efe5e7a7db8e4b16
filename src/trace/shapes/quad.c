/**
 * @file
 * @brief Quad: a parallelogram, seen from both sides.
 */
#include "trace/shapes/quad.h"

#include "trace/shapes/plane_equation.h"
#include "trace/shapes/registry.h"
#include "trace/shapes/watertight.h"

/** Corners of a quad. */
enum { QUAD_CORNERS = 4 };

/** A quad. @extends Shape */
typedef struct Quad {
    Shape base;                   /**< What all shapes have. */
    PlaneEquation plane;          /**< The plane that it lies in; its normal is u x v. */
    Vertex corners[QUAD_CORNERS]; /**< Its corners, in turn. */
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

/** Refuses quads without area. See #Keyword.finish. @return Whether the quad has an area. */
static bool quad_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const QuadParameters *p = values;
    /** Sine of the angle below which two edges count as parallel: a double cannot tell less. */
    const double parallel = 1e-12;
    Vec3d normal = vec3d_cross(vec3d_normalize(p->u), vec3d_normalize(p->v));
    return vec3d_length(normal) > parallel ||
           error_set(error, STATUS_SCENE, "quad has no area: u and v are parallel");
}

/** Makes a quad. */
static void quad_init(Shape *self, const void *parameters) {
    Quad *quad = (Quad *)self;
    const QuadParameters *p = parameters;
    Vec3d next = vec3d_add(p->corner, p->u), last = vec3d_add(p->corner, p->v);
    Vec3sw u = vec3sw_of(vec3d_scale_exponent(p->u)), v = vec3sw_of(vec3d_scale_exponent(p->v));
    quad->plane = plane_equation_of(p->corner, vec3sw_cross(u, v));
    quad->corners[0] = vertex_of(p->corner);
    quad->corners[1] = vertex_of(next);
    quad->corners[2] = vertex_of(vec3d_add(next, p->v));
    quad->corners[3] = vertex_of(last);
}

/** @return The lanes where the quad is nearer. See #ShapeClass.is_hit. @callgraph */
static mask quad_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Quad *quad = (const Quad *)self;
    mask inside = polygon_contains_ray(quad->corners, QUAD_CORNERS, ray, active);
    if (!any(inside)) {
        return inside;
    }
    real distance = plane_equation_distance(&quad->plane, ray);
    mask nearer = hit_is_nearer(hit, inside, distance, self->index);
    if (any(nearer)) {
        Hit found = plane_equation_hit(&quad->plane, ray, distance, self->index);
        hit_update(hit, nearer, &found);
    }
    return nearer;
}

/** @return The lanes where the quad is on the way. See #ShapeClass.is_occluding. */
static mask quad_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    const Quad *quad = (const Quad *)self;
    mask inside = polygon_contains_ray(quad->corners, QUAD_CORNERS, ray, active);
    if (!any(inside)) {
        return inside;
    }
    real distance = plane_equation_distance(&quad->plane, ray);
    return inside & (distance > 0) & (distance < limit);
}

/** @return The box around a quad. */
static Aabbs quad_bounds(const Shape *self) {
    return vertices_bounds(((const Quad *)self)->corners, QUAD_CORNERS);
}

/** @return Where on a picture points of a quad lie: how much of u and v it takes to get there. See
 *  #ShapeClass.texture_uv. */
static TextureUv quad_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Quad *quad = (const Quad *)self;
    Vec3sw corner = vertex_widen(quad->corners[0]);
    Vec3sw u = vec3sw_subtract(vertex_widen(quad->corners[1]), corner);
    Vec3sw v = vec3sw_subtract(vertex_widen(quad->corners[3]), corner);
    DualBasis dual_basis = dual_basis_of(u, v);
    Vec3w from_corner = vec3w_subtract(vec3_widen(hit->point), vec3w_splat(corner));
    return (TextureUv){.u = narrow(vec3w_dot(from_corner, vec3w_splat(dual_basis.first))),
                       .v = narrow(vec3w_dot(from_corner, vec3w_splat(dual_basis.second))),
                       .wrap_u = mask_of(false),
                       .wrap_v = mask_of(false)};
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
    .is_occluding = quad_is_occluding,
    .bounds = quad_bounds,
    .texture_uv = quad_texture_uv,
};
