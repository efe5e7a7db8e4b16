/**
 * @file
 * @brief Finds a Pareto front.
 */
#include "base/pareto_front.h"

/** @return Whether the quartiles of two costs overlap. */
static bool costs_are_tied(const ParetoPoint *a, const ParetoPoint *b) {
    return a->cost_low > 0 && b->cost_low > 0 && a->cost_low <= b->cost_high &&
           b->cost_low <= a->cost_high;
}

void pareto_front_find(ParetoPoint *points, size_t count, double equal_factor) {
    for (size_t i = 0; i < count; i++) {
        ParetoPoint *point = &points[i];
        bool is_beaten = false, is_tied = false;
        for (size_t k = 0; k < count; k++) {
            const ParetoPoint *other = &points[k];
            bool dominates =
                (other->cost < point->cost && other->error <= equal_factor * point->error) ||
                (other->cost <= point->cost && other->error < point->error);
            bool is_as_cheap = costs_are_tied(point, other);
            bool is_tie = is_as_cheap && other->error == point->error;
            bool is_better = is_as_cheap && other->error < point->error;
            is_beaten = is_beaten || is_better || (dominates && !is_tie);
            is_tied = is_tied || (dominates && is_tie);
        }
        point->is_pareto = !is_beaten;
        point->is_tied = !is_beaten && is_tied;
    }
}

/** @return Whether a point makes another one superfluous. @param is_first Whether it is the simpler
 *  one. */
static bool tied_point_dominates(const TiedPoint *a, const TiedPoint *b, bool is_first,
                                 double equal_factor) {
    bool is_tie = a->low <= b->high && b->low <= a->high, is_faster = a->high < b->low;
    bool is_better = equal_factor * a->error < b->error;
    bool is_alike = !is_better && a->error <= equal_factor * b->error;
    return is_faster ? is_better || is_alike : is_tie && (is_better || (is_alike && is_first));
}

void pareto_front_find_ties(TiedPoint *points, size_t count, double equal_factor) {
    for (size_t i = 0; i < count; i++) {
        points[i].is_pareto = true;
    }
    // Only points that stand themselves remove others, so that ties cannot remove all in a circle.
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < i; k++) {
            TiedPoint *old = &points[k], *new = &points[i];
            if (!old->is_pareto || !new->is_pareto) {
                continue;
            }
            if (tied_point_dominates(old, new, true, equal_factor)) {
                new->is_pareto = false;
            } else if (tied_point_dominates(new, old, false, equal_factor)) {
                old->is_pareto = false;
            }
        }
    }
}
