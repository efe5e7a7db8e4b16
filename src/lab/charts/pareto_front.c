/**
 * @file
 * @brief Finds a Pareto front.
 */
#include "lab/charts/pareto_front.h"

void pareto_front_find(ParetoPoint *points, size_t count, double equal_factor) {
    for (size_t i = 0; i < count; i++) {
        ParetoPoint *point = &points[i];
        point->is_pareto = true;
        for (size_t k = 0; k < count; k++) {
            const ParetoPoint *other = &points[k];
            bool dominates =
                (other->cost < point->cost && other->error <= equal_factor * point->error) ||
                (other->cost <= point->cost && other->error < point->error);
            point->is_pareto = point->is_pareto && !dominates;
        }
    }
}
