/**
 * @file
 * @brief The whole tracer as one file for the compiler, in an order to read it in.
 *
 * An engine is this file, compiled for one number type and one number of lanes. As one file, its
 * headers are compiled once, and calls across files can be inlined. `make SPLIT=1` compiles each
 * file on its own.
 */
// The recursion: camera rays, hits, direct light, reflection, refraction.
#include "trace/tracer/camera.c"
#include "trace/tracer/loss_budget.c"
#include "trace/tracer/merged_rays.c"
#include "trace/tracer/packet.c"
#include "trace/tracer/path_nodes.c"
#include "trace/tracer/plain_packet.c"
#include "trace/tracer/report_methods.c"
#include "trace/tracer/retrace.c"
#include "trace/tracer/secondary_rays.c"
#include "trace/tracer/tile.c"
#include "trace/tracer/tracer.c"
#include "trace/tracer/wavefront.c"
#include "trace/tracer/wavefront_pool.c"
// Light and materials.
#include "trace/glass/contact.c"
#include "trace/glass/dielectric.c"
#include "trace/glass/interior_list.c"
#include "trace/lights/cylinder_light.c"
#include "trace/lights/direct_lighting.c"
#include "trace/lights/emitters.c"
#include "trace/lights/light.c"
#include "trace/lights/point_light.c"
#include "trace/lights/rectangle_light.c"
#include "trace/lights/report_shadows.c"
#include "trace/lights/shadow_transmittance.c"
#include "trace/lights/sun.c"
#include "trace/materials/material.c"
#include "trace/materials/textures.c"
// Shapes.
#include "trace/shapes/aabb.c"
#include "trace/shapes/box.c"
#include "trace/shapes/cone.c"
#include "trace/shapes/cylinder.c"
#include "trace/shapes/disk.c"
#include "trace/shapes/mesh.c"
#include "trace/shapes/plane.c"
#include "trace/shapes/quad.c"
#include "trace/shapes/report_sphere.c"
#include "trace/shapes/sdf.c"
#include "trace/shapes/shape.c"
#include "trace/shapes/sphere.c"
#include "trace/shapes/transformed.c"
#include "trace/shapes/triangle.c"
// Many shapes and triangles: bounding volume hierarchies.
#include "trace/bvh/bvh_build.c"
#include "trace/bvh/bvh_packet.c"
#include "trace/bvh/bvh_single.c"
#include "trace/bvh/bvh_split.c"
#include "trace/bvh/shape_set.c"
#include "trace/bvh/shape_set_query.c"
#include "trace/mesh/mesh_bvh.c"
#include "trace/mesh/mesh_bvh_hit.c"
#include "trace/mesh/mesh_bvh_intersect.c"
// Signed distance fields.
#include "trace/sdf/sdf_mandelbulb.c"
#include "trace/sdf/sdf_program.c"
#include "trace/sdf/sdf_solids.c"
#include "trace/sdf/sdf_tape.c"
#include "trace/sdf/sdf_union.c"
#include "trace/sdf/sdf_vm.c"
#include "trace/sdf/sphere_tracer.c"
#include "trace/sdf/sphere_tracer_init.c"
#include "trace/sdf/tape_octree.c"
// Recorders, and ray queries.
#include "trace/tracer/aov.c"
#include "trace/tracer/path_hash.c"
#include "trace/tracer/query.c"
#include "trace/tracer/ray_tree_recorder.c"
// The engine itself.
#include "trace/tracer/engine.c"
