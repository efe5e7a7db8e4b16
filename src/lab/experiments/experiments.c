/**
 * @file
 * @brief The experiments there are.
 */
#include "lab/experiments/experiments.h"

const Experiment *const *experiment_list(void) {
    static const Experiment *const experiments[] = {&sphere_distance_experiment,
                                                    &sphere_offset_experiment,
                                                    &sphere_scale_experiment,
                                                    &sphere_ground_experiment,
                                                    &cylinder_distance_experiment,
                                                    &cylinder_rim_experiment,
                                                    &plane_angle_experiment,
                                                    &plane_point_experiment,
                                                    &triangle_edges_experiment,
                                                    &triangle_corners_experiment,
                                                    &triangle_grid_experiment,
                                                    &triangle_small_experiment,
                                                    &triangle_thin_experiment,
                                                    &box_touch_experiment,
                                                    &box_flat_experiment,
                                                    &cube_edges_experiment,
                                                    &disk_distance_experiment,
                                                    &cone_distance_experiment,
                                                    &ellipsoid_distance_experiment,
                                                    &torus_distance_experiment,
                                                    &capsule_distance_experiment,
                                                    &mirror_scale_experiment,
                                                    &mirror_offset_experiment,
                                                    &glass_scale_experiment,
                                                    &glass_offset_experiment,
                                                    &shells_gap_experiment,
                                                    &mirror_bounces_experiment,
                                                    &fresnel_into_experiment,
                                                    &fresnel_out_experiment,
                                                    &sphere_pole_experiment,
                                                    &sdf_normal_experiment,
                                                    &sdf_repetition_experiment,
                                                    &sphere_tracing_angle_experiment,
                                                    NULL};
    return experiments;
}
