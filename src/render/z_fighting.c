/**
 * @file
 * @brief Search for surfaces that float cannot tell apart.
 *
 * Shapes whose bounding boxes overlap are compared face by face. Where two faces are nearly
 * parallel, one is clipped by the edges of the other, by the borders of the picture, and to the
 * part where the gap is below the roundings. The area of the rest in the picture, times the chance
 * that rounding inverts the order, is the fraction of wrong pixels.
 */
#include "render/z_fighting.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Half an ulp of 1 in float. */
#define FLOAT_ROUNDOFF 0x1p-24

/** Roundings of the two distances that are compared: of height, slope and quotient each. */
#define DISTANCE_ROUNDINGS 4

/** Roundings of coordinates: each shape's own are rounded once, and the origin of rays in the
 *  space of a transformed shape once. */
#define COORDINATE_ROUNDINGS 1

/** Roundings of directions in the spaces of two transformed shapes. They move a hit along the
 *  surface, which shows in the distance itself, not in its part across the surface. */
#define DIRECTION_ROUNDINGS 1

/** Roundings of a ray's offset from the surface that it leaves, in the largest coordinate, and as
 *  many again for those of the next surface. Light that leaves glass may start behind a surface
 *  that is nearer. */
#define GLASS_ROUNDINGS 32

/** Chance that a pixel is wrong where light in glass may miss a surface. */
#define GLASS_CHANCE 0.5

/** Relative gap below which faces coincide: roundings of a few operations on the scene's numbers.
 *  Double cannot tell them apart. */
#define COINCIDENT 0x1p-48

/** Cosine from which on two planes are nearly parallel. At larger angles they cross in a line
 *  whose rounding is a small fraction of a pixel. */
#define PARALLEL_COSINE 0.9999

/** Largest number of corners of a clipped face: each of the 8 + 2 + 4 + 2 clips adds one. */
enum { CORNERS_MAXIMUM = 32 };

/** Number of boxes that are compared without further division. */
enum { LEAF_BOXES = 16 };

/** Largest number of pairs of boxes that are compared, about 5 ms. Later pairs are not seen. */
enum { BOX_PAIRS_MAXIMUM = 1 << 20 };

/** Largest number of pairs of shapes whose faces are compared, about 20 ms. */
enum { SHAPE_PAIRS_MAXIMUM = 1 << 15 };

/** Difference of two spheres' boxes, in bounds, from which on they fight in a thin ring only. */
#define SPHERES_APART 256

/** Largest number of vertices of meshes that are compared with faces: about 5 ms. */
enum { VERTICES_MAXIMUM = 1 << 22 };

/** Half the side of the square that stands for a whole plane, in heights of the eye: to where it
 *  is far below a pixel under the horizon. */
#define PLANE_REACH 1e4

/** A convex polygon. */
typedef struct Polygon {
    Vec3d corners[CORNERS_MAXIMUM]; /**< Corners, in turn. */
    int count;                      /**< Number of corners; fewer than 3: empty. */
} Polygon;

/** A bounded shape. */
typedef struct BoundedShape {
    Aabbd box;               /**< Its bounding box, enlarged by #bound. */
    const SceneShape *shape; /**< The shape. */
    const Mesh *mesh;        /**< Its triangles; NULL: no mesh. */
    double bound;            /**< Largest gap that matters, scene units. */
} BoundedShape;

/** The state of the search. */
typedef struct Search {
    const Scene *scene; /**< The scene. */
    Vec3d origin;       /**< #scene_local_origin */
    Vec3d right;        /**< To the right in the picture. */
    double half_width;  /**< Half the width of the picture at distance 1. */
    double half_height; /**< Half its height. */
    bool has_secondary; /**< Whether rays are reflected or refracted. */
    bool has_glass;     /**< Whether rays are refracted. */
    Aabbd secondary;    /**< Box from which they start. */
    Aabbd centers;      /**< Box around the centres of the shapes from which they start. */
    long box_pairs;     /**< Pairs of boxes compared. */
    long shape_pairs;   /**< Pairs of shapes compared. */
    size_t vertices;    /**< Vertices compared. */
    ZFighting result;   /**< What is found. */
} Search;

/** A face, with what its roundings depend on. */
typedef struct FacePair {
    const ShapeFace *faces[2];   /**< The faces; the second is bounded unless both are not. */
    const SceneShape *shapes[2]; /**< Their shapes; NULL: a light. */
    bool has_transform;          /**< Whether one of the shapes is transformed. */
    bool is_glass;               /**< Whether one of the shapes is transparent. */
    double bound;                /**< Largest gap that matters, scene units. */
} FacePair;

/* --- geometry --------------------------------------------------------------------------------- */

/** @return The height of a point above the plane of a face, signed. */
static double height_above(const ShapeFace *face, Vec3d point) {
    return vec3d_dot(face->normal, vec3d_subtract(point, face->corners[0]));
}

/** @return A corner of a box. @param index 0 to 7. */
static Vec3d aabbd_corner(const Aabbd *box, int index) {
    return (Vec3d){index & 1 ? box->high.x : box->low.x, index & 2 ? box->high.y : box->low.y,
                   index & 4 ? box->high.z : box->low.z};
}

/** @return Whether two boxes overlap. */
static bool aabbd_overlaps(const Aabbd *a, const Aabbd *b) {
    return a->low.x <= b->high.x && b->low.x <= a->high.x && a->low.y <= b->high.y &&
           b->low.y <= a->high.y && a->low.z <= b->high.z && b->low.z <= a->high.z;
}

/** Keeps the part of a polygon on one side of a plane: normal . p >= at least. */
static void polygon_clip(Polygon *polygon, Vec3d normal, double least) {
    Polygon clipped = {.count = 0};
    for (int i = 0; i < polygon->count; i++) {
        Vec3d here = polygon->corners[i], next = polygon->corners[(i + 1) % polygon->count];
        double inside = vec3d_dot(normal, here) - least,
               next_inside = vec3d_dot(normal, next) - least;
        if (inside >= 0 && clipped.count < CORNERS_MAXIMUM) {
            clipped.corners[clipped.count++] = here;
        }
        if ((inside >= 0) != (next_inside >= 0) && clipped.count < CORNERS_MAXIMUM) {
            double part = inside / (inside - next_inside);
            Vec3d step = vec3d_scale(vec3d_subtract(next, here), part);
            clipped.corners[clipped.count++] = vec3d_add(here, step);
        }
    }
    *polygon = clipped;
}

/** Keeps the part of a polygon above or below a face. */
static void polygon_clip_by_face(Polygon *polygon, const ShapeFace *face) {
    int count = face->corner_count;
    for (int i = 0; i < count && count > 1; i++) {
        Vec3d edge = vec3d_subtract(face->corners[(i + 1) % count], face->corners[i]);
        Vec3d inwards = vec3d_cross(face->normal, edge);
        Vec3d across = vec3d_subtract(face->corners[(i + 2) % count], face->corners[i]);
        inwards = vec3d_dot(inwards, across) < 0 ? vec3d_scale(inwards, -1) : inwards;
        polygon_clip(polygon, inwards, vec3d_dot(inwards, face->corners[i]));
    }
}

/** Keeps the part of a polygon whose height above a face is at most a bound, up or down. */
static void polygon_clip_to_gap(Polygon *polygon, const ShapeFace *face, double bound) {
    double level = vec3d_dot(face->normal, face->corners[0]);
    polygon_clip(polygon, face->normal, level - bound);
    polygon_clip(polygon, vec3d_scale(face->normal, -1), -level - bound);
}

/** @return The area of a polygon. */
static double polygon_area(const Polygon *polygon) {
    Vec3d sum = {0, 0, 0};
    for (int i = 2; i < polygon->count; i++) {
        Vec3d a = vec3d_subtract(polygon->corners[i - 1], polygon->corners[0]),
              b = vec3d_subtract(polygon->corners[i], polygon->corners[0]);
        sum = vec3d_add(sum, vec3d_cross(a, b));
    }
    return vec3d_length(sum) / 2;
}

/** @return The mean distance of the corners of a polygon from the eye. */
static double polygon_distance(const Search *search, const Polygon *polygon) {
    double sum = 0;
    for (int i = 0; i < polygon->count; i++) {
        sum += vec3d_length(vec3d_subtract(polygon->corners[i], search->scene->camera.position));
    }
    return sum / polygon->count;
}

/** Keeps the part of a polygon that the picture shows. */
static void polygon_clip_to_picture(const Search *search, Polygon *polygon) {
    const SceneCamera *camera = &search->scene->camera;
    const Vec3d sides[] = {search->right, vec3d_scale(search->right, -1), camera->up,
                           vec3d_scale(camera->up, -1)};
    for (int i = 0; i < 4; i++) {
        double half = i < 2 ? search->half_width : search->half_height;
        Vec3d inwards = vec3d_add(vec3d_scale(camera->direction, half), sides[i]);
        polygon_clip(polygon, inwards, vec3d_dot(inwards, camera->position));
    }
}

/** @return The fraction of the picture that a polygon covers, which is clipped to it. */
static double polygon_picture_share(const Search *search, const Polygon *polygon) {
    const SceneCamera *camera = &search->scene->camera;
    Polygon flat = {.count = polygon->count};
    for (int i = 0; i < polygon->count; i++) {
        Vec3d from_eye = vec3d_subtract(polygon->corners[i], camera->position);
        double depth = fmax(vec3d_dot(from_eye, camera->direction), LENGTH_MINIMUM);
        flat.corners[i] = (Vec3d){vec3d_dot(from_eye, search->right) / depth,
                                  vec3d_dot(from_eye, camera->up) / depth, 0};
    }
    return fmin(1, polygon_area(&flat) / (4 * search->half_width * search->half_height));
}

/** @return The fraction of the picture that a polygon covers in a mirror: about as if the eye saw
 *          all of it from the front. 0 if there is no mirror. */
static double polygon_mirrored_share(const Search *search, const Polygon *polygon) {
    double distance = polygon_distance(search, polygon);
    double picture = 4 * search->half_width * search->half_height * distance * distance;
    return search->has_secondary ? fmin(1, polygon_area(polygon) / picture) : 0;
}

/* --- roundings -------------------------------------------------------------------------------- */

/** @return The largest coordinate of a point relative to the origin of tracers. */
static double magnitude_of(const Search *search, Vec3d point) {
    return vec3d_max_abs(vec3d_subtract(point, search->origin));
}

/** What the rounding of a gap depends on. */
typedef struct GapScale {
    double height;    /**< Distance of the eye from the surfaces. */
    double distance;  /**< If one of them is transformed: distance of the eye from the point where
                           they are met. Else 0. */
    double magnitude; /**< Largest coordinate there. */
    bool is_glass;    /**< Whether one of them is transparent. */
} GapScale;

/** @return The largest gap between surfaces that float may see wrongly, scene units. */
static double gap_bound(GapScale scale) {
    double coordinates = scale.is_glass ? GLASS_ROUNDINGS : COORDINATE_ROUNDINGS;
    return FLOAT_ROUNDOFF * (DISTANCE_ROUNDINGS * scale.height +
                             DIRECTION_ROUNDINGS * scale.distance + coordinates * scale.magnitude);
}

/** @return The integral of (1 - |t|)^2 / 2, the chance of an inverted order at a gap of t bounds,
 *          from 0 to t. */
static double chance_integral(double t) {
    double rest = 1 - fmin(1, fabs(t));
    return copysign((1 - rest * rest * rest) / 6, t);
}

/** @return The mean chance that rounding inverts the order of two surfaces whose gap runs from one
 *          value to another. @param bound See gap_bound(). */
static double chance_between(double low, double high, double bound) {
    /** Smallest difference of gaps for which the integrals differ by more than roundings. */
    const double least = 1e-6;
    double from = low / bound, to = high / bound, middle = (from + to) / 2;
    double rest = 1 - fmin(1, fabs(middle));
    return to - from > least ? (chance_integral(to) - chance_integral(from)) / (to - from)
                             : rest * rest / 2;
}

/* --- flat faces ------------------------------------------------------------------------------- */

/** @return Whether rays may meet a face: the side of a solid is met from outside only. */
static bool face_is_seen(const Search *search, const ShapeFace *face) {
    double highest = height_above(face, search->scene->camera.position);
    for (int i = 0; i < 8 && search->has_secondary; i++) {
        highest = fmax(highest, height_above(face, aabbd_corner(&search->centers, i)));
    }
    double magnitude = magnitude_of(search, face->corners[0]);
    return !face->is_solid || highest > COORDINATE_ROUNDINGS * FLOAT_ROUNDOFF * magnitude;
}

/** @return The largest distance of the starts of secondary rays from the plane of a face. */
static double secondary_height(const Search *search, const ShapeFace *face) {
    double height = 0;
    for (int i = 0; i < 8; i++) {
        height = fmax(height, fabs(height_above(face, aabbd_corner(&search->secondary, i))));
    }
    return height;
}

/** @return A polygon that covers a face as far as it can be seen. */
static Polygon polygon_of_face(const Search *search, const ShapeFace *face) {
    Polygon polygon = {.count = face->corner_count};
    if (face->corner_count > 1) {
        for (int i = 0; i < face->corner_count; i++) {
            polygon.corners[i] = face->corners[i];
        }
        return polygon;
    }
    Vec3d eye = search->scene->camera.position;
    double height = height_above(face, eye);
    Vec3d foot = vec3d_subtract(eye, vec3d_scale(face->normal, height));
    Vec3d aside = fabs(face->normal.x) < 0.5 ? (Vec3d){1, 0, 0} : (Vec3d){0, 1, 0};
    double reach = PLANE_REACH * fmax(fabs(height), LENGTH_MINIMUM);
    Vec3d right = vec3d_scale(vec3d_normalize(vec3d_cross(face->normal, aside)), reach),
          up = vec3d_cross(face->normal, right);
    polygon.count = 4;
    for (int i = 0; i < 4; i++) {
        Vec3d corner = vec3d_add(foot, vec3d_scale(right, i == 0 || i == 3 ? -1 : 1));
        polygon.corners[i] = vec3d_add(corner, vec3d_scale(up, i < 2 ? -1 : 1));
    }
    return polygon;
}

/** @return The chance that a pixel of a polygon is wrong, which is clipped to a gap. */
static double polygon_chance(const Polygon *polygon, const FacePair *pair, double bound) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int i = 0; i < polygon->count; i++) {
        double gap = height_above(pair->faces[0], polygon->corners[i]);
        low = fmin(low, gap);
        high = fmax(high, gap);
    }
    return pair->is_glass ? GLASS_CHANCE : chance_between(low, high, bound);
}

/**
 * Adds the pixels of the overlap of two faces.
 * @param overlap    The common part of both.
 * @param magnitude  Its largest coordinate.
 */
static void add_overlap(Search *search, const Polygon *overlap, const FacePair *pair,
                        double magnitude) {
    const ShapeFace *face = pair->faces[0];
    Polygon seen = *overlap;
    polygon_clip_to_picture(search, &seen);
    double fraction = 0;
    if (seen.count >= 3) {
        double height = fabs(height_above(face, search->scene->camera.position));
        double distance = pair->has_transform ? polygon_distance(search, &seen) : 0;
        double bound = gap_bound((GapScale){height, distance, magnitude, pair->is_glass});
        polygon_clip_to_gap(&seen, face, bound);
        if (seen.count >= 3) {
            fraction += polygon_picture_share(search, &seen) * polygon_chance(&seen, pair, bound);
        }
    }
    if (search->has_secondary) {
        Polygon mirrored = *overlap;
        double height = secondary_height(search, face);
        double distance = pair->has_transform ? height : 0;
        double bound = gap_bound((GapScale){height, distance, magnitude, pair->is_glass});
        polygon_clip_to_gap(&mirrored, face, bound);
        if (mirrored.count >= 3) {
            fraction +=
                polygon_mirrored_share(search, &mirrored) * polygon_chance(&mirrored, pair, bound);
        }
    }
    search->result.fraction += fmin(1, fraction);
}

/** @return Whether two surfaces of the same place look alike. */
static bool look_alike(const Scene *scene, const SceneShape *a, const SceneShape *b) {
    const SceneMaterial *first = &scene->materials[a->material_index],
                        *second = &scene->materials[b->material_index];
    return first->texture_id == 0 && memcmp(first, second, sizeof *first) == 0;
}

/** Remembers opaque faces that coincide and look different. @param overlap Their common part. */
static void add_coincident(Search *search, const Polygon *overlap, const FacePair *pair) {
    if (pair->is_glass || !pair->shapes[0] ||
        look_alike(search->scene, pair->shapes[0], pair->shapes[1])) {
        return;
    }
    Polygon seen = *overlap;
    polygon_clip_to_picture(search, &seen);
    double direct = seen.count >= 3 ? polygon_picture_share(search, &seen) : 0;
    double share = fmax(direct, polygon_mirrored_share(search, overlap));
    if (share > search->result.coincident) {
        int first = pair->shapes[0]->line, second = pair->shapes[1]->line;
        search->result.coincident = share;
        search->result.lines[0] = first < second ? first : second;
        search->result.lines[1] = first < second ? second : first;
    }
}

/** Compares two faces. */
static void compare_faces(Search *search, const FacePair *pair) {
    const ShapeFace *a = pair->faces[0], *b = pair->faces[1];
    double cosine = vec3d_dot(a->normal, b->normal);
    if (fabs(cosine) < PARALLEL_COSINE || (a->is_solid && b->is_solid && cosine < 0)) {
        return;
    }
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int i = 0; i < b->corner_count && b->corner_count > 1; i++) {
        double gap = height_above(a, b->corners[i]);
        low = fmin(low, gap);
        high = fmax(high, gap);
    }
    bool is_apart = b->corner_count > 1 && (low > pair->bound || high < -pair->bound);
    if (is_apart || !face_is_seen(search, a) || !face_is_seen(search, b)) {
        return;
    }
    Polygon overlap = polygon_of_face(search, b);
    double magnitude = 0, farthest = 0, plane_magnitude = magnitude_of(search, a->corners[0]);
    polygon_clip_by_face(&overlap, a);
    for (int i = 0; i < overlap.count; i++) {
        magnitude = fmax(magnitude, magnitude_of(search, overlap.corners[i]));
        farthest = fmax(farthest, fabs(height_above(a, overlap.corners[i])));
    }
    double height = fabs(height_above(a, search->scene->camera.position));
    if (overlap.count < 3) {
        return;
    }
    if (farthest <= COINCIDENT * (height + magnitude + plane_magnitude)) {
        add_coincident(search, &overlap, pair);
    } else {
        bool is_plane = a->corner_count == 1 && b->corner_count == 1;
        add_overlap(search, &overlap, pair, is_plane ? plane_magnitude : magnitude);
    }
}

/** @return The distance of a point from the farthest point of a box. */
static double farthest_distance(const Aabbd *box, Vec3d point) {
    Vec3d below = vec3d_subtract(point, box->low), above = vec3d_subtract(box->high, point);
    return vec3d_length(vec3d_max(below, above));
}

/** @return The largest gap of a bounded shape that float may see the wrong way round, scene units.
 *  @param box Its bounding box. */
static double shape_gap_bound(const Search *search, const Aabbd *box) {
    Vec3d half = vec3d_scale(vec3d_subtract(box->high, box->low), 0.5),
          center = vec3d_subtract(box->high, half);
    double distance = farthest_distance(box, search->scene->camera.position);
    if (search->has_secondary) {
        double from_start = farthest_distance(&search->secondary, center) + vec3d_length(half);
        distance = fmax(distance, from_start);
    }
    double magnitude = magnitude_of(search, center) + vec3d_max_abs(half);
    return gap_bound((GapScale){distance, distance, magnitude, search->has_glass});
}

/** @return Whether a shape is transparent. */
static bool is_glass(const Search *search, const SceneShape *shape) {
    return scene_material_is_transparent(&search->scene->materials[shape->material_index]);
}

/** Lists the faces of a shape. The inside of glass is seen. @param[out] faces
 *  #SHAPE_FACES_MAXIMUM of them. @return Their number. */
static size_t visible_faces(const Search *search, const SceneShape *shape, ShapeFace *faces) {
    size_t count = scene_shape_faces(shape, faces);
    for (size_t i = 0; i < count; i++) {
        faces[i].is_solid = faces[i].is_solid && !is_glass(search, shape);
    }
    return count;
}

/** @return A pair of faces of two shapes, to be filled in. @param bound See #FacePair.bound. */
static FacePair face_pair_of(const Search *search, const SceneShape *a, const SceneShape *b,
                             double bound) {
    return (FacePair){.shapes = {a, b},
                      .has_transform = a->transform || b->transform,
                      .is_glass = is_glass(search, a) || is_glass(search, b),
                      .bound = bound};
}

/** Compares the faces of two shapes. @param bound See #FacePair.bound. */
static void compare_flat_shapes(Search *search, const SceneShape *a, const SceneShape *b,
                                double bound) {
    ShapeFace faces_a[SHAPE_FACES_MAXIMUM], faces_b[SHAPE_FACES_MAXIMUM];
    size_t count_a = visible_faces(search, a, faces_a),
           count_b = count_a > 0 ? visible_faces(search, b, faces_b) : 0;
    FacePair pair = face_pair_of(search, a, b, bound);
    for (size_t i = 0; i < count_a * count_b; i++) {
        pair.faces[0] = &faces_a[i / count_b];
        pair.faces[1] = &faces_b[i % count_b];
        compare_faces(search, &pair);
    }
}

/* --- meshes ----------------------------------------------------------------------------------- */

/** A plane in the space of a mesh: points p with normal . p = level. */
typedef struct MeshPlane {
    Vec3d normal; /**< The normal; heights above the plane are those in the scene. */
    double level; /**< Its product with the points of the plane. */
} MeshPlane;

/** @return The plane of a face in the space of a mesh. @param transform Of the mesh; NULL: none. */
static MeshPlane mesh_plane_of(const ShapeFace *face, const Transform *transform) {
    MeshPlane plane = {face->normal, vec3d_dot(face->normal, face->corners[0])};
    if (transform) {
        const double(*m)[3] = transform->matrix;
        Vec3d n = face->normal;
        plane.normal = (Vec3d){m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z,
                               m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
                               m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z};
        plane.level -= vec3d_dot(n, transform->translate);
    }
    return plane;
}

/** @return Whether a vertex of a mesh is near a plane. @param bound Scene units. */
static bool vertex_is_near(const Mesh *mesh, size_t index, const MeshPlane *plane, double bound) {
    return fabs(vec3d_dot(plane->normal, mesh->positions[index]) - plane->level) <= bound;
}

/** Compares a triangle of a mesh with a face. @param shape The mesh. */
static void compare_triangle(Search *search, const SceneShape *shape, const Mesh *mesh,
                             const MeshTriangle *triangle, const FacePair *plane) {
    ShapeFace face = {.corner_count = 3};
    for (int k = 0; k < 3; k++) {
        Vec3d position = mesh->positions[triangle->index[k]];
        face.corners[k] = shape->transform ? transform_point(shape->transform, position) : position;
    }
    Vec3d u = vec3d_subtract(face.corners[1], face.corners[0]),
          v = vec3d_subtract(face.corners[2], face.corners[0]);
    face.normal = vec3d_normalize(vec3d_cross(u, v));
    FacePair pair = *plane;
    pair.faces[1] = &face;
    compare_faces(search, &pair);
}

/** Compares the triangles of a mesh with a face. @param shape The mesh. @param pair Its first face
 *  is that face. */
static void compare_mesh_with_face(Search *search, const SceneShape *shape, const Mesh *mesh,
                                   const FacePair *pair) {
    MeshPlane plane = mesh_plane_of(pair->faces[0], shape->transform);
    size_t near = 0;
    search->vertices += mesh->position_count;
    for (size_t i = 0; i < mesh->position_count && search->vertices <= VERTICES_MAXIMUM; i++) {
        near += vertex_is_near(mesh, i, &plane, pair->bound);
    }
    for (size_t i = 0; i < mesh->triangle_count && near >= 3; i++) {
        const MeshTriangle *triangle = &mesh->triangles[i];
        if (vertex_is_near(mesh, triangle->index[0], &plane, pair->bound) &&
            vertex_is_near(mesh, triangle->index[1], &plane, pair->bound) &&
            vertex_is_near(mesh, triangle->index[2], &plane, pair->bound)) {
            compare_triangle(search, shape, mesh, triangle, pair);
        }
    }
}

/** Compares the triangles of a mesh with the faces of another shape, which may be none. */
static void compare_mesh(Search *search, const SceneShape *shape, const Mesh *mesh,
                         const SceneShape *other, double bound) {
    ShapeFace faces[SHAPE_FACES_MAXIMUM];
    size_t count = visible_faces(search, other, faces);
    FacePair plane = face_pair_of(search, shape, other, bound);
    for (size_t i = 0; i < count; i++) {
        plane.faces[0] = &faces[i];
        if (face_is_seen(search, &faces[i])) {
            compare_mesh_with_face(search, shape, mesh, &plane);
        }
    }
}

/* --- spheres, cylinders and cones ------------------------------------------------------------- */

/** The space of a shape relative to that of another. */
typedef struct RelativeSpace {
    Vec3d columns[3]; /**< Images of the unit vectors. */
    Vec3d origin;     /**< Image of the origin. */
} RelativeSpace;

/** @return The columns of a transform's matrix. @param transform NULL: the identity. */
static RelativeSpace space_of(const Transform *transform) {
    RelativeSpace space = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    for (int i = 0; transform && i < 3; i++) {
        const double(*m)[3] = transform->matrix;
        space.columns[i] = (Vec3d){m[0][i], m[1][i], m[2][i]};
    }
    space.origin = transform ? transform->translate : space.origin;
    return space;
}

/** @return A vector in the space of a shape, from one in the scene. @param columns Of the shape. */
static Vec3d vector_to_space(const Vec3d *columns, Vec3d v) {
    Vec3d yz = vec3d_cross(columns[1], columns[2]), zx = vec3d_cross(columns[2], columns[0]),
          xy = vec3d_cross(columns[0], columns[1]);
    double per_volume = 1 / vec3d_dot(columns[0], yz);
    return (Vec3d){vec3d_dot(yz, v) * per_volume, vec3d_dot(zx, v) * per_volume,
                   vec3d_dot(xy, v) * per_volume};
}

/** @return A vector of a space, in the space that it is relative to. */
static Vec3d vector_from_space(const RelativeSpace *space, Vec3d v) {
    Vec3d sum = vec3d_scale(space->columns[0], v.x);
    sum = vec3d_add(sum, vec3d_scale(space->columns[1], v.y));
    return vec3d_add(sum, vec3d_scale(space->columns[2], v.z));
}

/** @return The space of a shape, relative to that of another. */
static RelativeSpace relative_space(const Transform *from, const Transform *to) {
    RelativeSpace space = space_of(from), other = space_of(to);
    for (int i = 0; i < 3; i++) {
        space.columns[i] = vector_to_space(other.columns, space.columns[i]);
    }
    space.origin = vector_to_space(other.columns, vec3d_subtract(space.origin, other.origin));
    return space;
}

/** A range of numbers. */
typedef struct Range {
    double low;  /**< Lowest. */
    double high; /**< Highest. */
} Range;

/** @return By how much a space stretches the vectors across an axis, or all if the axis is 0: from
 *          Gershgorin's circles of the squared lengths. */
static Range stretch_across(const RelativeSpace *space, Vec3d axis) {
    Vec3d aside = fabs(axis.x) < 0.5 * vec3d_length(axis) ? (Vec3d){1, 0, 0} : (Vec3d){0, 1, 0};
    Vec3d right = vec3d_normalize(vec3d_cross(axis, aside)),
          up = vec3d_normalize(vec3d_cross(axis, right));
    bool is_sphere = vec3d_max_abs(axis) == 0;
    const Vec3d directions[] = {
        is_sphere ? (Vec3d){1, 0, 0} : right, is_sphere ? (Vec3d){0, 1, 0} : up, {0, 0, 1}};
    const int count = is_sphere ? 3 : 2;
    Range squared = {HUGE_VAL, 0};
    for (int i = 0; i < count; i++) {
        Vec3d image = vector_from_space(space, directions[i]);
        double length = vec3d_dot(image, image), others = 0;
        for (int k = 0; k < count; k++) {
            Vec3d other = vector_from_space(space, directions[k]);
            others += k == i ? 0 : fabs(vec3d_dot(image, other));
        }
        squared.low = fmin(squared.low, length - others);
        squared.high = fmax(squared.high, length + others);
    }
    return (Range){sqrt(fmax(0, squared.low)), sqrt(squared.high)};
}

/** Two shells in the space of the first. */
typedef struct ShellPair {
    ShapeShell a;  /**< The first. */
    ShapeShell b;  /**< The second; its radii are those of its own space. */
    Range stretch; /**< Factors from the second's space across its axis. */
} ShellPair;

/** The gap between two shells. */
typedef struct ShellGap {
    Range range;   /**< Its lowest and highest value; nothing in between if they do not meet. */
    double length; /**< Length that both have in common along the axis; 0 for spheres. */
} ShellGap;

/** Widens a range by the gap where two shells have given radii. @param apart Distance of their
 *  axes. */
static void range_add_gap(Range *range, double a, double b, const Range *stretch, double apart) {
    range->low = fmin(range->low, b * stretch->low - a - apart);
    range->high = fmax(range->high, b * stretch->high - a + apart);
}

/** @return The radius of a cone at a part of its length. */
static double radius_at(const ShapeShell *shell, double part) {
    return shell->radius + (shell->top_radius - shell->radius) * part;
}

/** @return The gap between two spheres, or two cylinders or cones; else a range that is empty. */
static ShellGap shell_gap_of(const ShellPair *pair) {
    const ShapeShell *a = &pair->a, *b = &pair->b;
    Vec3d axis_a = vec3d_subtract(a->top, a->base), axis_b = vec3d_subtract(b->top, b->base);
    double length_a = vec3d_length(axis_a), length_b = vec3d_length(axis_b);
    ShellGap gap = {.range = {HUGE_VAL, -HUGE_VAL}};
    if (length_a == 0 && length_b == 0) {
        double apart = vec3d_length(vec3d_subtract(a->base, b->base));
        range_add_gap(&gap.range, a->radius, b->radius, &pair->stretch, apart);
    }
    if (!(fabs(vec3d_dot(axis_a, axis_b)) > PARALLEL_COSINE * length_a * length_b)) {
        return gap;
    }
    // Where the second axis starts and ends along the first, and how far from it.
    Vec3d unit = vec3d_scale(axis_a, 1 / length_a);
    Vec3d from_base = vec3d_subtract(b->base, a->base), from_top = vec3d_subtract(b->top, a->base);
    double base = vec3d_dot(from_base, unit), top = vec3d_dot(from_top, unit);
    double apart = fmax(vec3d_length(vec3d_subtract(from_base, vec3d_scale(unit, base))),
                        vec3d_length(vec3d_subtract(from_top, vec3d_scale(unit, top))));
    const double ends[] = {fmax(0, fmin(base, top)), fmin(length_a, fmax(base, top))};
    gap.length = ends[1] - ends[0];
    for (int i = 0; i < 2 && gap.length > 0; i++) {
        range_add_gap(&gap.range, radius_at(a, ends[i] / length_a),
                      radius_at(b, (ends[i] - base) / (top - base)), &pair->stretch, apart);
    }
    return gap;
}

/** Compares two shapes if both are spheres, or both cylinders or cones. The gap between them is
 *  taken to be spread evenly over its range. @param bound See #FacePair.bound. */
static void compare_shells(Search *search, const SceneShape *shape_a, const SceneShape *shape_b,
                           double bound) {
    const SceneShapeClass *class_a = scene_shape_classes[shape_a->class_index],
                          *class_b = scene_shape_classes[shape_b->class_index];
    if (!class_a->shell || !class_b->shell) {
        return;
    }
    ShellPair pair = {.a = class_a->shell(shape_a->parameters),
                      .b = class_b->shell(shape_b->parameters)};
    RelativeSpace space = relative_space(shape_b->transform, shape_a->transform);
    pair.stretch = stretch_across(&space, vec3d_subtract(pair.b.top, pair.b.base));
    pair.b.base = vec3d_add(space.origin, vector_from_space(&space, pair.b.base));
    pair.b.top = vec3d_add(space.origin, vector_from_space(&space, pair.b.top));
    ShellGap gap = shell_gap_of(&pair);
    // Back to the scene: gaps as small, and areas as large, as the scale may make them.
    const Transform *transform = shape_a->transform;
    Vec3d scale = transform ? transform->scale : (Vec3d){1, 1, 1},
          center = transform ? transform_point(transform, pair.a.base) : pair.a.base;
    double smallest = fmin(fabs(scale.x), fmin(fabs(scale.y), fabs(scale.z))),
           largest = vec3d_max_abs(scale);
    double radius = largest * fmax(pair.a.radius, pair.a.top_radius);
    double magnitude = magnitude_of(search, center) + radius;
    Vec3d to_eye = vec3d_subtract(search->scene->camera.position, center);
    double distance = fmax(vec3d_length(to_eye), radius);
    bool has_glass = is_glass(search, shape_a) || is_glass(search, shape_b);
    GapScale seen = {distance, transform || shape_b->transform ? distance : 0, magnitude,
                     has_glass};
    double reach = search->has_secondary ? bound : gap_bound(seen);
    double low = gap.range.low * smallest, high = gap.range.high * smallest;
    double from = fmax(low, -reach), to = fmin(high, reach);
    if (!(from <= to) || fmax(fabs(low), fabs(high)) <= COINCIDENT * (distance + magnitude)) {
        return;
    }
    double part = high > low ? (to - from) / (high - low) : 1;
    double picture = 4 * search->half_width * search->half_height * distance * distance;
    double area = M_PI * radius * radius + 2 * radius * gap.length * largest;
    search->result.fraction += fmin(1, area / picture) * fmin(1, part) *
                               (has_glass ? GLASS_CHANCE : chance_between(from, to, reach));
}

/* --- pairs of shapes -------------------------------------------------------------------------- */

/** @return Whether the common part of two boxes is thin in two directions: shapes in them touch in
 *          an edge or a corner at most. @param bound Length that counts as thin. */
static bool boxes_touch_in_edge(const Aabbd *a, const Aabbd *b, double bound) {
    Vec3d size = vec3d_subtract(vec3d_min(a->high, b->high), vec3d_max(a->low, b->low));
    return (size.x <= bound) + (size.y <= bound) + (size.z <= bound) >= 2;
}

/** Compares two bounded shapes. */
static void compare_shapes(Search *search, const BoundedShape *a, const BoundedShape *b) {
    search->box_pairs++;
    // Both boxes are enlarged by their bounds on each side.
    if (!aabbd_overlaps(&a->box, &b->box) ||
        boxes_touch_in_edge(&a->box, &b->box, 3 * (a->bound + b->bound)) ||
        search->shape_pairs++ >= SHAPE_PAIRS_MAXIMUM) {
        return;
    }
    double bound = a->bound > b->bound ? a->bound : b->bound;
    if (a->mesh || b->mesh) {
        const BoundedShape *mesh = a->mesh ? a : b, *other = a->mesh ? b : a;
        compare_mesh(search, mesh->shape, mesh->mesh, other->shape, bound);
        return;
    }
    compare_flat_shapes(search, a->shape, b->shape, bound);
    compare_shells(search, a->shape, b->shape, bound);
}

/** @return The box around the boxes of shapes. */
static Aabbd shapes_bounds(const BoundedShape *shapes, size_t count) {
    Aabbd bounds = aabbd_empty();
    for (size_t i = 0; i < count; i++) {
        bounds.low = vec3d_min(bounds.low, shapes[i].box.low);
        bounds.high = vec3d_max(bounds.high, shapes[i].box.high);
    }
    return bounds;
}

/** Moves the shapes that overlap a box to the front. @return Their number. */
static size_t move_to_front(BoundedShape *shapes, size_t count, const Aabbd *overlapping) {
    size_t front = 0;
    for (size_t i = 0; i < count; i++) {
        if (aabbd_overlaps(&shapes[i].box, overlapping)) {
            BoundedShape moved = shapes[i];
            shapes[i] = shapes[front];
            shapes[front++] = moved;
        }
    }
    return front;
}

/** @return A coordinate of a point. @param axis 0, 1 or 2. */
static double coordinate(Vec3d p, int axis) {
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/** Divides shapes in two groups along the longest side of their box. @return The number in the
 *  first group, which is neither 0 nor all. */
static size_t divide_shapes(BoundedShape *shapes, size_t count) {
    Aabbd bounds = shapes_bounds(shapes, count);
    Vec3d size = vec3d_subtract(bounds.high, bounds.low);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    double twice_middle = coordinate(vec3d_add(bounds.low, bounds.high), axis);
    size_t front = 0;
    for (size_t i = 0; i < count; i++) {
        Vec3d twice_center = vec3d_add(shapes[i].box.low, shapes[i].box.high);
        if (coordinate(twice_center, axis) < twice_middle) {
            BoundedShape moved = shapes[i];
            shapes[i] = shapes[front];
            shapes[front++] = moved;
        }
    }
    return front > 0 && front < count ? front : count / 2;
}

/** Compares the shapes of one group with those of another. */
static void compare_groups(Search *search, BoundedShape *a, size_t count_a, BoundedShape *b,
                           size_t count_b) {
    Aabbd bounds_a = shapes_bounds(a, count_a), bounds_b = shapes_bounds(b, count_b);
    count_a = move_to_front(a, count_a, &bounds_b);
    count_b = move_to_front(b, count_b, &bounds_a);
    if (count_a == 0 || count_b == 0 || search->box_pairs >= BOX_PAIRS_MAXIMUM) {
        return;
    }
    if (count_a <= LEAF_BOXES && count_b <= LEAF_BOXES) {
        for (size_t i = 0; i < count_a * count_b; i++) {
            compare_shapes(search, &a[i / count_b], &b[i % count_b]);
        }
    } else if (count_a > count_b) {
        size_t front = divide_shapes(a, count_a);
        compare_groups(search, a, front, b, count_b);
        compare_groups(search, a + front, count_a - front, b, count_b);
    } else {
        size_t front = divide_shapes(b, count_b);
        compare_groups(search, a, count_a, b, front);
        compare_groups(search, a, count_a, b + front, count_b - front);
    }
}

/** Compares the shapes of a group with one another. */
static void compare_group(Search *search, BoundedShape *shapes, size_t count) {
    if (count > LEAF_BOXES) {
        size_t front = divide_shapes(shapes, count);
        compare_group(search, shapes, front);
        compare_group(search, shapes + front, count - front);
        compare_groups(search, shapes, front, shapes + front, count - front);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < i; k++) {
            compare_shapes(search, &shapes[k], &shapes[i]);
        }
    }
}

/** Orders shapes by the lowest x of their boxes, for qsort(). */
static int compare_low_x(const void *a, const void *b) {
    double x = ((const BoundedShape *)a)->box.low.x, y = ((const BoundedShape *)b)->box.low.x;
    return (x > y) - (x < y);
}

/** Compares spheres whose boxes are nearly the same. */
static void compare_spheres(Search *search, BoundedShape *spheres, size_t count) {
    qsort(spheres, count, sizeof *spheres, compare_low_x);
    for (size_t i = 0; i < count; i++) {
        const BoundedShape *a = &spheres[i], *end = spheres + count;
        double reach = SPHERES_APART * a->bound;
        for (const BoundedShape *b = a + 1; b < end && b->box.low.x - a->box.low.x <= reach; b++) {
            Vec3d low = vec3d_subtract(a->box.low, b->box.low),
                  high = vec3d_subtract(a->box.high, b->box.high);
            if (search->box_pairs++ < BOX_PAIRS_MAXIMUM && vec3d_max_abs(low) <= reach &&
                vec3d_max_abs(high) <= reach && search->shape_pairs++ < SHAPE_PAIRS_MAXIMUM) {
                compare_shells(search, a->shape, b->shape, a->bound);
            }
        }
    }
}

/** @return Whether a box reaches the plane of a face. */
static bool aabbd_touches_plane(const Aabbd *box, const ShapeFace *face) {
    Vec3d n = face->normal, half = vec3d_scale(vec3d_subtract(box->high, box->low), 0.5);
    double reach = fabs(n.x) * half.x + fabs(n.y) * half.y + fabs(n.z) * half.z;
    return fabs(height_above(face, vec3d_subtract(box->high, half))) <= reach;
}

/** Compares a plane with bounded shapes. */
static void compare_plane_with_shapes(Search *search, const SceneShape *shape,
                                      const BoundedShape *shapes, size_t count) {
    ShapeFace plane;
    scene_shape_faces(shape, &plane);
    for (size_t i = 0; i < count; i++) {
        const BoundedShape *other = &shapes[i];
        search->box_pairs++;
        if (!aabbd_touches_plane(&other->box, &plane) ||
            search->shape_pairs++ >= SHAPE_PAIRS_MAXIMUM) {
            continue;
        }
        if (other->mesh) {
            compare_mesh(search, other->shape, other->mesh, shape, other->bound);
        } else {
            compare_flat_shapes(search, shape, other->shape, other->bound);
        }
    }
}

/** Compares planes with one another. @param planes Their shapes. */
static void compare_planes(Search *search, const SceneShape *const *planes, size_t count) {
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < i && search->shape_pairs++ < SHAPE_PAIRS_MAXIMUM; k++) {
            compare_flat_shapes(search, planes[k], planes[i], HUGE_VAL);
        }
    }
}

/* --- lights --- */

/** Compares the face of a light with a shape. @param bound See #FacePair.bound. */
static void compare_light_with_shape(Search *search, const ShapeFace *light,
                                     const SceneShape *shape, const Mesh *mesh, double bound) {
    ShapeFace faces[SHAPE_FACES_MAXIMUM];
    size_t count = visible_faces(search, shape, faces);
    FacePair pair = {.faces = {light, NULL},
                     .shapes = {NULL, shape},
                     .has_transform = shape->transform != NULL,
                     .is_glass = is_glass(search, shape),
                     .bound = bound};
    if (mesh) {
        compare_mesh_with_face(search, shape, mesh, &pair);
    }
    for (size_t i = 0; i < count; i++) {
        bool is_plane = faces[i].corner_count == 1;
        pair.faces[0] = is_plane ? &faces[i] : light;
        pair.faces[1] = is_plane ? light : &faces[i];
        compare_faces(search, &pair);
    }
}

/** Compares the faces of lights with all shapes. @param planes The whole planes. */
static void compare_lights(Search *search, const BoundedShape *shapes, size_t count,
                           const SceneShape *const *planes, size_t plane_count) {
    const Scene *scene = search->scene;
    for (size_t i = 0; i < scene->light_count; i++) {
        const SceneLight *light = &scene->lights[i];
        if (!scene_light_classes[light->class_index]->face) {
            continue;
        }
        ShapeFace face = scene_light_classes[light->class_index]->face(light);
        Aabbd box = aabbd_empty();
        for (int k = 0; k < face.corner_count; k++) {
            box = aabbd_add_point(box, face.corners[k]);
        }
        double bound = shape_gap_bound(search, &box);
        for (size_t k = 0; k < plane_count; k++) {
            compare_light_with_shape(search, &face, planes[k], NULL, bound);
        }
        for (size_t k = 0; k < count; k++) {
            if (aabbd_overlaps(&shapes[k].box, &box)) {
                compare_light_with_shape(search, &face, shapes[k].shape, shapes[k].mesh, bound);
            }
        }
    }
}

/* --- the scene -------------------------------------------------------------------------------- */

/** @return Whether a shape reflects or transmits light. */
static bool is_secondary(const Scene *scene, const SceneShape *shape) {
    const SceneMaterial *material = &scene->materials[shape->material_index];
    return scene_material_is_reflective(material) || scene_material_is_transparent(material);
}

/** Finds where secondary rays start: on bounded mirrors and glass, or anywhere around the scene and
 *  the eye if a mirror is unbounded. */
static void find_secondary(Search *search) {
    const Scene *scene = search->scene;
    Aabbd *box = &search->secondary;
    *box = search->centers = aabbd_empty();
    bool is_bounded = true;
    for (size_t i = 0; i < scene->shape_count; i++) {
        const SceneShape *shape = &scene->shapes[i];
        if (!is_secondary(scene, shape)) {
            continue;
        }
        Aabbd bounds = scene_shape_facts(scene, shape).bounds;
        Vec3d center = vec3d_scale(vec3d_add(bounds.low, bounds.high), 0.5);
        if (!aabbd_is_bounded(bounds)) {
            ShapeFace face = {.corners = {scene->camera.position}};
            scene_shape_faces(shape, &face);
            double height = height_above(&face, scene->camera.position);
            center = vec3d_subtract(scene->camera.position, vec3d_scale(face.normal, height));
            is_bounded = false;
        }
        search->centers = aabbd_add_point(search->centers, center);
        box->low = vec3d_min(box->low, bounds.low);
        box->high = vec3d_max(box->high, bounds.high);
        search->has_secondary = true;
        search->has_glass = search->has_glass || is_glass(search, shape);
    }
    if (!is_bounded) {
        *box = aabbd_add_point(scene_bounds(scene), scene->camera.position);
    }
}

/** Memory of the search: arrays for as many shapes as the scene has. */
typedef struct SearchMemory {
    BoundedShape *shapes;      /**< Bounded shapes with flat faces, and meshes. */
    BoundedShape *spheres;     /**< Spheres. */
    const SceneShape **planes; /**< Whole planes. */
} SearchMemory;

/** Compares all shapes. */
static void search_scene(Search *search, const SearchMemory *memory) {
    const Scene *scene = search->scene;
    size_t count = 0, sphere_count = 0, plane_count = 0;
    for (size_t i = 0; i < scene->shape_count; i++) {
        const SceneShape *shape = &scene->shapes[i];
        const SceneShapeClass *class = scene_shape_classes[shape->class_index];
        ShapeFacts facts = scene_shape_facts(scene, shape);
        if (!aabbd_is_bounded(facts.bounds)) {
            if (class->faces) {
                memory->planes[plane_count++] = shape;
            }
        } else if (class->faces || class->shell || facts.mesh) {
            double bound = shape_gap_bound(search, &facts.bounds);
            const Vec3d reach = {bound, bound, bound};
            BoundedShape bounded = {
                {vec3d_subtract(facts.bounds.low, reach), vec3d_add(facts.bounds.high, reach)},
                shape,
                facts.mesh,
                bound};
            *(class->faces || facts.mesh ? &memory->shapes[count++]
                                         : &memory->spheres[sphere_count++]) = bounded;
        }
    }
    compare_planes(search, memory->planes, plane_count);
    for (size_t i = 0; i < plane_count; i++) {
        compare_plane_with_shapes(search, memory->planes[i], memory->shapes, count);
    }
    compare_group(search, memory->shapes, count);
    compare_lights(search, memory->shapes, count, memory->planes, plane_count);
    compare_spheres(search, memory->spheres, sphere_count);
}

ZFighting z_fighting_of(const Scene *scene) {
    const SceneCamera *camera = &scene->camera;
    double half_width = tan(camera->fov / 2 * (M_PI / 180));
    Search search = {.scene = scene,
                     .origin = scene_local_origin(scene),
                     .right = scene_camera_right(camera),
                     .half_width = half_width,
                     .half_height = half_width * scene->image.height / scene->image.width};
    size_t count = scene->shape_count + 1;
    SearchMemory memory = {calloc(count, sizeof *memory.shapes),
                           calloc(count, sizeof *memory.spheres),
                           calloc(count, sizeof *memory.planes)};
    if (memory.shapes && memory.spheres && memory.planes) {
        find_secondary(&search);
        search_scene(&search, &memory);
    }
    free(memory.planes);
    free(memory.spheres);
    free(memory.shapes);
    search.result.fraction = fmin(1, search.result.fraction);
    return search.result;
}
