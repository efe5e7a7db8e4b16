/**
 * @file
 * @brief The Pareto front of costs and errors: what nothing else beats in both.
 */
#ifndef DIOPTRE_LAB_CHARTS_PARETO_FRONT_H
#define DIOPTRE_LAB_CHARTS_PARETO_FRONT_H

#include <stdbool.h>
#include <stddef.h>

/** What something costs, and how accurate it is. */
typedef struct ParetoPoint {
    double cost;      /**< Such as a time. */
    double error;     /**< At least 0. */
    bool is_pareto;   /**< Whether it is part of the front. */
    double cost_low;  /**< Lower quartile of the cost; 0: the cost is exact. */
    double cost_high; /**< Upper quartile of the cost; 0: the cost is exact. */
    bool is_tied; /**< Whether it is part of the front only because costs that overlap are ties. */
} ParetoPoint;

/**
 * Finds the front: points that no cheaper point equals in error, and no equally cheap one beats.
 * Where the quartiles of two costs overlap, both are as cheap: the smaller error beats the larger,
 * and equal errors are tied.
 * @param[in,out] points  The points; #ParetoPoint.is_pareto and #ParetoPoint.is_tied are set.
 * @param equal_factor    Errors count as equal up to this factor, at least 1.
 */
void pareto_front_find(ParetoPoint *points, size_t count, double equal_factor);

#endif
