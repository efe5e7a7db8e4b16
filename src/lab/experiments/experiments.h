/**
 * @file
 * @brief The experiments there are.
 */
#ifndef DIOPTRE_LAB_EXPERIMENTS_H
#define DIOPTRE_LAB_EXPERIMENTS_H

#include "lab/experiment.h"

extern const Experiment sphere_distance_experiment;    /**< Spheres far from the viewpoint. */
extern const Experiment sphere_offset_experiment;      /**< Spheres far from the origin. */
extern const Experiment sphere_scale_experiment;       /**< Spheres small and large. */
extern const Experiment sphere_ground_experiment;      /**< A sphere as the ground. */
extern const Experiment cylinder_distance_experiment;  /**< A pipe far from the viewpoint. */
extern const Experiment cylinder_rim_experiment;       /**< The rim of a closed cylinder. */
extern const Experiment plane_angle_experiment;        /**< Grazing rays. */
extern const Experiment plane_point_experiment;        /**< A plane given by a point far away. */
extern const Experiment triangle_edges_experiment;     /**< Edges of a closed surface. */
extern const Experiment triangle_corners_experiment;   /**< Its corners. */
extern const Experiment triangle_grid_experiment;      /**< Corners and rays of whole numbers. */
extern const Experiment triangle_small_experiment;     /**< Ever smaller triangles. */
extern const Experiment triangle_thin_experiment;      /**< Ever thinner triangles. */
extern const Experiment box_touch_experiment;          /**< Rays that just touch a box. */
extern const Experiment box_flat_experiment;           /**< Flat boxes. */
extern const Experiment cube_edges_experiment;         /**< Edges of a cube. */
extern const Experiment disk_distance_experiment;      /**< A disk far away. */
extern const Experiment cone_distance_experiment;      /**< A cone far away. */
extern const Experiment ellipsoid_distance_experiment; /**< An ellipsoid far away. */
extern const Experiment torus_distance_experiment;     /**< A torus far away. */
extern const Experiment capsule_distance_experiment;   /**< A capsule far away. */
extern const Experiment mirror_scale_experiment;   /**< Rays leaving mirrors, small and large. */
extern const Experiment mirror_offset_experiment;  /**< Rays leaving mirrors far from the
                                                        origin. */
extern const Experiment glass_scale_experiment;    /**< Into glass, small and large. */
extern const Experiment glass_offset_experiment;   /**< Into glass far from the origin. */
extern const Experiment shells_gap_experiment;     /**< Through two spheres close to each
                                                        other. */
extern const Experiment mirror_bounces_experiment; /**< From mirror to mirror. */
extern const Experiment fresnel_into_experiment;   /**< Reflectance of glass, from air. */
extern const Experiment fresnel_out_experiment;    /**< From inside glass. */
extern const Experiment sphere_pole_experiment;    /**< Latitude near a pole. */
extern const Experiment sdf_normal_experiment;     /**< Normals of fields. */
extern const Experiment sdf_repetition_experiment; /**< Fields that are repeated. */
extern const Experiment sphere_tracing_angle_experiment; /**< Sphere tracing at small angles. */

#endif
