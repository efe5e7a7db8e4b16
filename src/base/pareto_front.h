/**
 * @file
 * @brief The Pareto front of costs and errors: what nothing else beats in both.
 */
#ifndef DIOPTRE_BASE_PARETO_FRONT_H
#define DIOPTRE_BASE_PARETO_FRONT_H

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

/** What something costs and how accurate it is, with the noise of the cost. */
typedef struct TiedPoint {
    double low;     /**< Lower quartile of the cost. */
    double median;  /**< Median of the cost. */
    double high;    /**< Upper quartile of the cost. */
    double error;   /**< At least 0. */
    bool is_pareto; /**< Whether it is part of the front. */
} TiedPoint;

/**
 * Finds the front where costs are noisy. Costs whose quartiles overlap are equal, and so are errors
 * up to a factor; of points that are equal in both the first one stands.
 * @param[in,out] points  The points, the simplest first; TiedPoint.is_pareto is set.
 * @param equal_factor    Errors count as equal up to this factor, at least 1.
 */
void pareto_front_find_ties(TiedPoint *points, size_t count, double equal_factor);

#endif
