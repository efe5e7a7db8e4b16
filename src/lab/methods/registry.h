/**
 * @file
 * @brief The methods there are.
 */
#ifndef DIOPTRE_LAB_METHODS_REGISTRY_H
#define DIOPTRE_LAB_METHODS_REGISTRY_H

#include "lab/methods/method.h"

extern const Method *const method_list[]; /**< All of the below, ended by NULL. */

extern const Method sphere_expanded;            /**< Every product of the quadratic by itself. */
extern const Method sphere_textbook;            /**< The quadratic, relative to the centre. */
extern const Method sphere_projection;          /**< By the nearest point of the line. */
extern const Method sphere_projection_relative; /**< The same, relative to the origin. */
extern const Method sphere_stable_quadratic;    /**< A discriminant that does not cancel. */
extern const Method sphere_mixed_precision;     /**< The same in the next better precision. */
extern const Method sphere_compensated;         /**< The same with errors carried along. */
extern const Method cylinder_wall_textbook;     /**< B^2 - A C. */
extern const Method cylinder_wall_cross;        /**< By how far the ray passes beside the axis. */
extern const Method cylinder_solid_parts;       /**< A wall and two disks. */
extern const Method cylinder_solid_interval;    /**< What two intervals have in common. */
extern const Method plane_point_normal;         /**< By a point of it. */
extern const Method plane_equation;             /**< By N.Q, worked out once. */
extern const Method triangle_cramer;            /**< Determinants of 3 x 3. */
extern const Method triangle_moller_trumbore;   /**< Edges counted in. */
extern const Method triangle_moller_trumbore_strict;   /**< Edges left out. */
extern const Method triangle_moller_trumbore_tolerant; /**< A little larger. */
extern const Method triangle_moller_trumbore_cutoff;   /**< Small determinants are zero. */
extern const Method triangle_signed_volumes;           /**< Signed volumes. */
extern const Method triangle_watertight;               /**< By shear. */
extern const Method box_slabs_nan_misses;              /**< NaN is a miss. */
extern const Method box_slabs_nan_ignored;             /**< NaN drops out. */
extern const Method box_slabs_robust;                  /**< A little longer. */
extern const Method box_six_quads;                     /**< Six quads. */
extern const Method box_cube_slabs;                    /**< What three intervals have in common. */
extern const Method ray_offset_none;                   /**< From the very point. */
extern const Method ray_offset_tmin;                   /**< Nothing nearer than 1e-4. */
extern const Method ray_offset_normal;                 /**< 1e-4 to the side it goes to. */
extern const Method ray_offset_outward;                /**< 1e-4 outwards. */
extern const Method ray_offset_ulps;                   /**< 256 ulps. */
extern const Method ray_offset_error_bound;            /**< A bound of the error. */
extern const Method sphere_uv_acos;                    /**< Arc cosine. */
extern const Method sphere_uv_acos_clamped;            /**< Of what is held to -1 to 1. */
extern const Method sphere_uv_atan2;                   /**< Arc tangent. */
extern const Method fresnel_s_polarized;               /**< One polarisation. */
extern const Method fresnel_schlick;                   /**< Approximated. */
extern const Method fresnel_schlick_wrong_cosine;      /**< By the wrong cosine. */
extern const Method fresnel_exact;                     /**< Both polarisations. */
extern const Method fresnel_smaller_fraction;          /**< The same, by what is mirrored or not. */
extern const Method gradient_forward;                  /**< Forward differences. */
extern const Method gradient_tetrahedral;              /**< At four corners. */
extern const Method gradient_central;                  /**< Central differences. */
extern const Method gradient_analytic;                 /**< In closed form. */
extern const Method sphere_tracing_plain;              /**< Steps as long as is safe. */
extern const Method sphere_tracing_relaxed;            /**< Longer, and back. */
extern const Method domain_repetition_own_cell;        /**< The own cell alone. */
extern const Method domain_repetition_neighbors;       /**< All cells around. */
extern const Method bounces_plain;                     /**< As the formula gives it. */
extern const Method bounces_normalized;                /**< Made of length 1. */

#endif
