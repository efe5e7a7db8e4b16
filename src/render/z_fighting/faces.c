/**
 * @file
 * @brief Flat faces that fight: those of shapes, meshes and lights.
 *
 * Where two faces are nearly parallel, one is clipped by the edges of the other, by the borders of
 * the picture, and to the part where the gap is below the roundings. The area of the rest in the
 * picture, times the chance that rounding inverts the order, is the fraction of wrong pixels.
 */
#include "render/z_fighting/polygon.h"
#include "render/z_fighting/search.h"

#include <math.h>
#include <string.h>

/** Half the side of the square that stands for a whole plane, in heights of the eye: to where it
 *  is far below a pixel under the horizon. */
#define PLANE_REACH 1e4

/** Largest number of vertices of meshes that are compared with faces: about 5 ms. Later meshes are
 *  not seen. */
enum { VERTICES_MAXIMUM = 1 << 22 };

/** Number of vertices of a mesh above which only a part is compared with a face. */
enum { MESH_VERTICES_COMPARED = 1 << 19 };

/** Number of triangles of a mesh near a face above which only a part is compared: about 2 ms. */
enum { TRIANGLES_COMPARED = 1 << 12 };

/** A face, with what its roundings depend on. */
typedef struct FacePair {
    const ShapeFace *faces[2];   /**< The faces; the second is bounded unless both are not. */
    const SceneShape *shapes[2]; /**< Their shapes; NULL: a light. */
    bool has_transform;          /**< Whether one of the shapes is transformed. */
    bool is_glass;               /**< Whether one of the shapes is transparent. */
    double bound;                /**< Largest gap that matters, scene units. */
    double weight;               /**< Number of pairs that it stands for. */
} FacePair;

/** @return A corner of a box. @param index 0 to 7. */
static Vec3d aabbd_corner(const Aabbd *box, int index) {
    return (Vec3d){index & 1 ? box->high.x : box->low.x, index & 2 ? box->high.y : box->low.y,
                   index & 4 ? box->high.z : box->low.z};
}

/* --- what the picture shows ------------------------------------------------------------------- */

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

/* --- flat faces ------------------------------------------------------------------------------- */

/** @return Whether rays may meet a face: the side of a solid is met from outside only. */
static bool face_is_seen(const Search *search, const ShapeFace *face) {
    double highest = height_above(face, search->scene->camera.position);
    for (int i = 0; i < 8 && search->has_secondary; i++) {
        highest = fmax(highest, height_above(face, aabbd_corner(&search->centers, i)));
    }
    double magnitude = magnitude_from(search->origin, face->corners[0]);
    return !face->is_solid || highest > gap_bound((GapScale){.magnitude = magnitude});
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
    search->result.fraction += pair->weight * fmin(1, fraction);
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
    double share = pair->weight * fmax(direct, polygon_mirrored_share(search, overlap));
    search->result.coincident += share;
    if (share > search->largest_coincident) {
        int first = pair->shapes[0]->origin.line, second = pair->shapes[1]->origin.line;
        search->largest_coincident = share;
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
    double magnitude = 0, farthest = 0,
           plane_magnitude = magnitude_from(search->origin, a->corners[0]);
    polygon_clip_by_face(&overlap, a);
    for (int i = 0; i < overlap.count; i++) {
        magnitude = fmax(magnitude, magnitude_from(search->origin, overlap.corners[i]));
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

double shape_gap_bound(const Search *search, const Aabbd *box) {
    Vec3d half = vec3d_scale(vec3d_subtract(box->high, box->low), 0.5),
          center = vec3d_subtract(box->high, half);
    double distance = farthest_distance(box, search->scene->camera.position);
    if (search->has_secondary) {
        double from_start = farthest_distance(&search->secondary, center) + vec3d_length(half);
        distance = fmax(distance, from_start);
    }
    double magnitude = magnitude_from(search->origin, center) + vec3d_max_abs(half);
    return gap_bound((GapScale){distance, distance, magnitude, search->has_glass});
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

/** @return A pair of faces of two shapes, to be filled in. @param bound Largest gap that matters,
 * scene units. */
static FacePair face_pair_of(const Search *search, const SceneShape *a, const SceneShape *b,
                             double bound) {
    return (FacePair){.shapes = {a, b},
                      .has_transform = a->transform || b->transform,
                      .is_glass = is_glass(search, a) || is_glass(search, b),
                      .bound = bound,
                      .weight = 1};
}

void compare_flat_shapes(Search *search, const SceneShape *a, const SceneShape *b, double bound) {
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
    size_t near = 0, stride = 1 + mesh->position_count / MESH_VERTICES_COMPARED;
    for (size_t i = 0; i < mesh->position_count && search->vertices < VERTICES_MAXIMUM;
         i += stride) {
        near += stride * vertex_is_near(mesh, i, &plane, pair->bound);
        search->vertices++;
    }
    // A closed mesh has twice as many triangles as vertices.
    const size_t wanted = 1 + 2 * near / TRIANGLES_COMPARED,
                 step = wanted > stride ? wanted : stride;
    FacePair weighted = *pair;
    weighted.weight = (double)step;
    for (size_t i = 0; i < mesh->triangle_count && near >= 3; i += step) {
        const MeshTriangle *triangle = &mesh->triangles[i];
        if (vertex_is_near(mesh, triangle->index[0], &plane, pair->bound) &&
            vertex_is_near(mesh, triangle->index[1], &plane, pair->bound) &&
            vertex_is_near(mesh, triangle->index[2], &plane, pair->bound)) {
            compare_triangle(search, shape, mesh, triangle, &weighted);
        }
    }
}

void compare_mesh(Search *search, const SceneShape *shape, const Mesh *mesh,
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

/* --- shapes and lights ------------------------------------------------------------------------ */

void compare_light_with_shape(Search *search, const ShapeFace *light, const SceneShape *shape,
                              const Mesh *mesh, double bound) {
    ShapeFace faces[SHAPE_FACES_MAXIMUM];
    size_t count = visible_faces(search, shape, faces);
    FacePair pair = {.faces = {light, NULL},
                     .shapes = {NULL, shape},
                     .has_transform = shape->transform != NULL,
                     .is_glass = is_glass(search, shape),
                     .bound = bound,
                     .weight = 1};
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
