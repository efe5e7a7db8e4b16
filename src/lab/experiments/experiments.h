/**
 * @file
 * @brief The experiments there are.
 */
#ifndef DIOPTRE_LAB_EXPERIMENTS_H
#define DIOPTRE_LAB_EXPERIMENTS_H

#include "lab/experiment.h"

extern const Experiment sphere_distance_experiment; /**< Spheres far from the eye. */
extern const Experiment sphere_world_experiment;    /**< Spheres far from the origin. */
extern const Experiment sphere_scale_experiment;    /**< Spheres small and large. */
extern const Experiment sphere_ground_experiment;   /**< Spheres that one stands on. */

#endif
