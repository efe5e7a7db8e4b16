/**
 * @file
 * @brief The registry: one line a shape class.
 */
#include "trace/shapes/registry.h"

const Keyword *const shape_keywords[] = {
    &sphere_class.keyword,   &plane_class.keyword,
    &quad_class.keyword,     &box_class.keyword,
    &disk_class.keyword,     &cylinder_class.keyword,
    &triangle_class.keyword, &mesh_class.keyword,
    &sdf_class.keyword,      NULL,
};
