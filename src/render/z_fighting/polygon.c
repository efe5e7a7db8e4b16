/**
 * @file
 * @brief Convex polygons.
 */
#include "render/z_fighting/polygon.h"

void polygon_clip(Polygon *polygon, Vec3d normal, double least) {
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

void polygon_clip_by_face(Polygon *polygon, const ShapeFace *face) {
    int count = face->corner_count;
    for (int i = 0; i < count && count > 1; i++) {
        Vec3d edge = vec3d_subtract(face->corners[(i + 1) % count], face->corners[i]);
        Vec3d inwards = vec3d_cross(face->normal, edge);
        Vec3d across = vec3d_subtract(face->corners[(i + 2) % count], face->corners[i]);
        inwards = vec3d_dot(inwards, across) < 0 ? vec3d_scale(inwards, -1) : inwards;
        polygon_clip(polygon, inwards, vec3d_dot(inwards, face->corners[i]));
    }
}

void polygon_clip_to_gap(Polygon *polygon, const ShapeFace *face, double bound) {
    double level = vec3d_dot(face->normal, face->corners[0]);
    polygon_clip(polygon, face->normal, level - bound);
    polygon_clip(polygon, vec3d_scale(face->normal, -1), -level - bound);
}

double polygon_area(const Polygon *polygon) {
    Vec3d sum = {0, 0, 0};
    for (int i = 2; i < polygon->count; i++) {
        Vec3d a = vec3d_subtract(polygon->corners[i - 1], polygon->corners[0]),
              b = vec3d_subtract(polygon->corners[i], polygon->corners[0]);
        sum = vec3d_add(sum, vec3d_cross(a, b));
    }
    return vec3d_length(sum) / 2;
}
