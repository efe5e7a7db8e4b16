/**
 * @file
 * @brief Description of disks.
 */
#include "scene/shapes/fields.h"

/** Fields of `disk`. */
static const Parameter disk_parameters[] = {
    POINT_FIELD("center", DiskParameters, center, N_("its centre")),
    NORMAL_FIELD("normal", DiskParameters, normal, N_("its normal")),
    LENGTH_FIELD("radius", DiskParameters, radius, N_("its radius")),
    {0}};

/** A disk of radius 1 in the plane y = 0. */
static const DiskParameters disk_defaults = {.normal = {0, 1, 0}, .radius = 1};

/** @return Facts of a disk. See #SceneShapeClass.facts. */
static ShapeFacts disk_facts(const void *parameters, const Scene *scene) {
    (void)scene;
    const DiskParameters *p = parameters;
    Vec3d extent = circle_extent(vec3d_normalize(p->normal), p->radius);
    return (ShapeFacts){.bounds = {vec3d_subtract(p->center, extent), vec3d_add(p->center, extent)},
                        .is_flat = true};
}

/** @return The distance of a point from the plane of a disk. See #SceneShapeClass.distance. */
static double disk_distance(const void *parameters, const Scene *scene, Vec3d point) {
    (void)scene;
    const DiskParameters *p = parameters;
    return distance_from_plane(p->normal, p->center, point);
}

ShapeFace face_of_disk(Vec3d normal, Vec3d center, double radius) {
    /** Radius of a regular octagon around its corners, over that of a circle of the same area. */
    const double per_radius = sqrt(M_PI / (2 * M_SQRT2));
    Vec3d unit = vec3d_normalize(normal);
    Vec3d aside = fabs(unit.x) < 0.5 ? (Vec3d){1, 0, 0} : (Vec3d){0, 1, 0};
    Vec3d right = vec3d_normalize(vec3d_cross(unit, aside)), up = vec3d_cross(unit, right);
    ShapeFace face = {.corner_count = FACE_CORNERS_MAXIMUM, .normal = unit};
    for (int i = 0; i < FACE_CORNERS_MAXIMUM; i++) {
        double angle = 2 * M_PI * i / FACE_CORNERS_MAXIMUM, reach = radius * per_radius;
        Vec3d from_center =
            vec3d_add(vec3d_scale(right, reach * cos(angle)), vec3d_scale(up, reach * sin(angle)));
        face.corners[i] = vec3d_add(center, from_center);
    }
    return face;
}

/** Gives the disk. See #SceneShapeClass.faces. @return 1. */
static size_t disk_faces(const void *parameters, ShapeFace *faces) {
    const DiskParameters *p = parameters;
    faces[0] = face_of_disk(p->normal, p->center, p->radius);
    return 1;
}

/** Description of `disk`. */
const SceneShapeClass scene_disk_class = {
    .keyword = {.name = "disk",
                .help = "the inside of a circle",
                .parameters = disk_parameters,
                .size = sizeof(DiskParameters),
                .defaults = &disk_defaults},
    .facts = disk_facts,
    .distance = disk_distance,
    .faces = disk_faces,
};
