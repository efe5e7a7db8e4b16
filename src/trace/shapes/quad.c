/**
 * @file
 * @brief Quad: a parallelogram, visible from both sides.
 *
 * The edges decide whether a ray meets it (watertight.h), its plane decides where.
 */

#include "trace/shapes/plane_equation.h"
#include "trace/shapes/watertight.h"

/** A quad. @extends Shape */
typedef struct Quad {
    Shape base;          /**< Base. */
    PlaneEquation plane; /**< The plane of the quad; its normal is u x v. */
    QuadCorners corners; /**< Its corners. */
    PolygonEdges edges;  /**< The edges between them. */
    Aabbs bounds;        /**< Bounding box. */
} Quad;

/** See #ShapeClass.init. */
static void quad_init(Shape *self, const void *parameters) {
    Quad *quad = (Quad *)self;
    const QuadParameters *p = parameters;
    Vec3d next = vec3d_add(p->corner, p->u), last = vec3d_add(p->corner, p->v);
    Vec3sw u = vec3sw_of(vec3d_scale_exponent(p->u)), v = vec3sw_of(vec3d_scale_exponent(p->v));
    quad->plane = plane_equation_of(p->corner, vec3sw_cross(u, v));
    const Vertex corners[QUAD_CORNERS] = {vertex_of(p->corner), vertex_of(next),
                                          vertex_of(vec3d_add(next, p->v)), vertex_of(last)};
    quad->corners = quad_corners_of(corners);
    quad->edges = quad_edges_of(corners);
    quad->bounds = vertices_bounds(corners, QUAD_CORNERS);
}

/** Finds rays whose line passes inside the edges. See #IntersectFunction. */
INLINE mask quad_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                           void *roots) {
    (void)roots;
    const Quad *quad = (const Quad *)self;
    mask inside = quad_contains_ray(&quad->corners, ray, active);
    if (any(inside)) {
        inside = polygon_rays_in_box(&quad->bounds, ray, inside);
        *distance = plane_equation_distance(&quad->plane, ray);
    }
    return inside;
}

/** See #SurfaceFunction. */
INLINE SurfacePoint quad_surface(const Shape *self, const Ray *ray, real distance,
                                 const void *roots) {
    (void)roots;
    return plane_equation_surface(&((const Quad *)self)->plane, ray, distance);
}

/** See #ShapeClass.is_hit. @callgraph */
static mask quad_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    return primitive_is_hit(self, ray, active, hit, quad_intersect, quad_surface, NULL);
}

/** See #ShapeClass.covers. */
static bool quad_covers(const Shape *self, const Beam *beam) {
    return polygon_covers_beam(&((const Quad *)self)->edges, beam);
}

/** See #ShapeClass.plane. */
static const PlaneEquation *quad_plane(const Shape *self) {
    return &((const Quad *)self)->plane;
}

/** Finds where rays meet the plane, if all pass inside the edges. See #ShapeClass.beam_hits. */
static bool quad_beam_hits(const Shape *self, const Packet *packet, Hit *hits) {
    bool is_covered = quad_covers(self, &packet->beam);
    if (is_covered) {
        plane_equation_beam_hits(quad_plane(self), self, packet, hits);
    }
    return is_covered;
}

/** See #ShapeClass.is_occluding. */
static mask quad_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    return primitive_is_occluding(self, ray, active, limit, quad_intersect, NULL);
}

/** See #ShapeClass.bounds. */
static Aabbs quad_bounds(const Shape *self) {
    return ((const Quad *)self)->bounds;
}

/** @return Coordinates of points along the edges u and v. See #ShapeClass.texture_uv. */
static TextureUv quad_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    (void)lanes;
    const Quad *quad = (const Quad *)self;
    Vec3sw corner = vertex_widen(quad->corners.vertices[0]);
    Vec3sw u = vec3sw_subtract(vertex_widen(quad->corners.vertices[1]), corner);
    Vec3sw v = vec3sw_subtract(vertex_widen(quad->corners.vertices[3]), corner);
    DualBasis dual_basis = dual_basis_of(u, v);
    Vec3w from_corner = vec3w_subtract(vec3_widen(hit->point), vec3w_splat(corner));
    return (TextureUv){.u = narrow(vec3w_dot(from_corner, vec3w_splat(dual_basis.first))),
                       .v = narrow(vec3w_dot(from_corner, vec3w_splat(dual_basis.second))),
                       .wrap_u = mask_of(false),
                       .wrap_v = mask_of(false)};
}

/** Methods of `quad`. */
const ShapeClass quad_class = {
    .size = sizeof(Quad),
    .form = FORM_FLAT,
    .init = quad_init,
    .is_hit = quad_is_hit,
    .is_occluding = quad_is_occluding,
    .bounds = quad_bounds,
    .covers = METHOD_OF_BEAMS(quad_covers),
    .beam_hits = METHOD_OF_BEAMS(quad_beam_hits),
    .plane = METHOD_OF_BEAMS(quad_plane),
    .texture_uv = quad_texture_uv,
};
