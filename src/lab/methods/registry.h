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
extern const Method sphere_haines;              /**< A discriminant that does not cancel. */
extern const Method sphere_mixed;               /**< The same in the next better precision. */
extern const Method sphere_compensated;         /**< The same with errors carried along. */
extern const Method cylinder_wall_textbook;     /**< B^2 - A C. */
extern const Method cylinder_wall_cross;        /**< By how far the ray passes beside the axis. */
extern const Method cylinder_solid_parts;       /**< A wall and two disks. */
extern const Method cylinder_solid_interval;    /**< What two intervals have in common. */
extern const Method plane_point;                /**< By a point of it. */
extern const Method plane_offset;               /**< By N.Q, worked out once. */
extern const Method triangle_cramer;            /**< Determinants of 3 x 3. */
extern const Method triangle_moeller;           /**< Edges counted in. */
extern const Method triangle_moeller_strict;    /**< Edges left out. */
extern const Method triangle_moeller_tolerant;  /**< A little larger. */
extern const Method triangle_moeller_cut;       /**< Small determinants are zero. */
extern const Method triangle_volumes;           /**< Signed volumes. */
extern const Method triangle_watertight;        /**< By shear. */
extern const Method box_slabs_rejecting;        /**< NaN is a miss. */
extern const Method box_slabs_dropping;         /**< NaN drops out. */
extern const Method box_slabs_robust;           /**< A little longer. */
extern const Method box_quads;                  /**< Six quads. */
extern const Method box_cube_slabs;             /**< What three intervals have in common. */
extern const Method leaving_none;               /**< From the very point. */
extern const Method leaving_tmin;               /**< Nothing nearer than 1e-4. */
extern const Method leaving_normal;             /**< 1e-4 to the side it goes to. */
extern const Method leaving_outwards;           /**< 1e-4 outwards. */
extern const Method leaving_ulps;               /**< 256 ulps. */
extern const Method leaving_bound;              /**< A bound of the error. */
extern const Method latitude_acos;              /**< Arc cosine. */
extern const Method latitude_acos_held;         /**< Of what is held to -1 to 1. */
extern const Method latitude_atan2;             /**< Arc tangent. */
extern const Method fresnel_one;                /**< One polarisation. */
extern const Method fresnel_schlick;            /**< Approximated. */
extern const Method fresnel_schlick_inner;      /**< By the wrong cosine. */
extern const Method fresnel_exact;              /**< Both polarisations. */
extern const Method fresnel_both;               /**< The same, by what is mirrored or not. */
extern const Method gradient_forward;           /**< Forward differences. */
extern const Method gradient_tetrahedral;       /**< At four corners. */
extern const Method gradient_central;           /**< Central differences. */
extern const Method gradient_exact;             /**< In closed form. */
extern const Method marching_plain;             /**< Steps as long as is safe. */
extern const Method marching_relaxed;           /**< Longer, and back. */
extern const Method cells_own;                  /**< The own cell alone. */
extern const Method cells_near;                 /**< All cells around. */
extern const Method bounces_plain;              /**< As the formula gives it. */
extern const Method bounces_normalized;         /**< Made of length 1. */

#endif
