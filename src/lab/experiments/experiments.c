/**
 * @file
 * @brief The experiments there are.
 */
#include "lab/experiments/experiments.h"

const Experiment *const *experiment_list(void) {
    static const Experiment *const experiments[] = {
        &sphere_distance_experiment, &sphere_world_experiment, &sphere_scale_experiment,
        &sphere_ground_experiment, NULL};
    return experiments;
}
