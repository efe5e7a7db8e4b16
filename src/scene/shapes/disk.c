/**
 * @file
 * @brief Description of disks.
 */
#include "scene/shapes/fields.h"

/** Fields of `disk`. */
static const Parameter disk_parameters[] = {
    POINT_FIELD("center", DiskParameters, center, "its centre"),
    NORMAL_FIELD("normal", DiskParameters, normal, "its normal"),
    LENGTH_FIELD("radius", DiskParameters, radius, "its radius"),
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

/** Description of `disk`. */
const SceneShapeClass scene_disk_class = {
    .keyword = {.name = "disk",
                .help = "the inside of a circle",
                .parameters = disk_parameters,
                .size = sizeof(DiskParameters),
                .defaults = &disk_defaults},
    .facts = disk_facts,
    .distance = disk_distance,
};
