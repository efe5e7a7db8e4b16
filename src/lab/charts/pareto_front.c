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
