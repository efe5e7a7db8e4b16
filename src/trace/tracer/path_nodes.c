/**
 * @file
 * @brief Sums along the paths of a wavefront.
 */
#include "trace/tracer/path_nodes.h"

/** Sums of LANES nodes. */
typedef struct NodeSums {
    Rgb color;   /**< See #NODE_SUM. */
    Rgb dropped; /**< See #NODE_SUM_DROPPED. */
    Rgb guarded; /**< See #NODE_SUM_GUARDED. */
    real rays;   /**< See #PathNodes.rays. */
} NodeSums;

/** Where LANES children are. Mostly the children of neighbours are neighbours: they fit into LANES
 *  places, and are loaded as a vector. Only where another pass traced some of them, they are
 *  gathered one by one. */
typedef struct ChildPlaces {
    mask lanes;      /**< The lanes with a child; at least one. */
    bool are_near;   /**< Whether all offsets are 0 to LANES - 1, where that helps. */
    unsigned first;  /**< The place of the first child. */
    integer offsets; /**< Places after #first; 0 in other lanes. */
} ChildPlaces;

/** @return Where children are. @param places Their places, in those lanes. */
INLINE ChildPlaces child_places_of(mask lanes, integer places) {
    const int first = integer_lane(places, mask_first(lanes));
    integer offsets = integer_select(lanes, places - first, integer_of(0));
    bool are_near = HAS_GATHER_NEAR && !any((offsets < 0) | (offsets >= LANES));
    return (ChildPlaces){lanes, are_near, (unsigned)first, offsets};
}

/** @return Numbers of children, from a column. @param are_near A constant: what #ChildPlaces says.
 */
INLINE real child_numbers(const scalar *column, const ChildPlaces *places, bool are_near) {
    return are_near ? real_gather_near(column + places->first, places->offsets)
                    : real_gather(column + places->first, places->offsets);
}

/** @return Colours of children, from columns. See child_numbers(). */
INLINE Rgb child_colors(const scalar *red, const scalar *green, const scalar *blue,
                        const ChildPlaces *places, bool are_near) {
    return (Rgb){child_numbers(red, places, are_near), child_numbers(green, places, are_near),
                 child_numbers(blue, places, are_near)};
}

/** @return Colours of children that are nodes. See child_numbers(). */
INLINE Rgb child_node_colors(const PathNodes *nodes, NodeColor which, const ChildPlaces *places,
                             bool are_near) {
    const scalar(*columns)[NODE_ROOMS] = nodes->colors[which];
    return child_colors(columns[0], columns[1], columns[2], places, are_near);
}

/** @return A sum, with more in some lanes. */
INLINE Rgb rgb_add_lanes(Rgb sum, mask lanes, Rgb more) {
    return rgb_select(lanes, rgb_add(sum, more), sum);
}

/** Adds what children saw that were traced. See child_numbers(). */
INLINE void node_sums_add_traced(const PathNodes *nodes, const ChildPlaces *places, bool are_near,
                                 NodeSums *sums) {
    const mask lanes = places->lanes;
    Rgb weight = child_node_colors(nodes, NODE_WEIGHT, places, are_near);
    Rgb color = rgb_multiply(weight, child_node_colors(nodes, NODE_SUM, places, are_near));
    Rgb dropped = child_node_colors(nodes, NODE_SUM_DROPPED, places, are_near);
    Rgb guarded = child_node_colors(nodes, NODE_SUM_GUARDED, places, are_near);
    real rays = child_numbers(nodes->rays, places, are_near) + 1;
    sums->color = rgb_add_lanes(sums->color, lanes, color);
    sums->dropped = rgb_add_lanes(sums->dropped, lanes, dropped);
    sums->guarded = rgb_add_lanes(sums->guarded, lanes, guarded);
    sums->rays += real_select(lanes, rays, real_of(0));
}

/** Adds the losses of children that were kept. See child_numbers(). */
INLINE void node_sums_add_kept(const RayColumns *kept, const ChildPlaces *places, bool are_near,
                               NodeSums *sums) {
    const scalar(*columns)[RAY_COLUMN_ROOMS] = kept->numbers[RAY_COLUMN_THROUGHPUT];
    Rgb throughput = child_colors(columns[0] + RAY_COLUMN_FIRST, columns[1] + RAY_COLUMN_FIRST,
                                  columns[2] + RAY_COLUMN_FIRST, places, are_near);
    sums->dropped = rgb_add_lanes(sums->dropped, places->lanes, throughput);
}

/** Adds what the children of one kind saw, or lost. @param places Their nodes: see #NODE_NONE. */
INLINE void node_sums_add_children(const PathNodes *nodes, const RayColumns *kept, integer places,
                                   NodeSums *sums) {
    mask is_traced = places > NODE_NONE, is_kept = places < NODE_NONE;
    if (any(is_traced)) {
        const ChildPlaces traced = child_places_of(is_traced, places);
        if (traced.are_near) {
            node_sums_add_traced(nodes, &traced, true, sums);
        } else {
            node_sums_add_traced(nodes, &traced, false, sums);
        }
    }
    if (any(is_kept)) {
        const ChildPlaces among_kept = child_places_of(is_kept, NODE_KEPT_FIRST - places);
        if (among_kept.are_near) {
            node_sums_add_kept(kept, &among_kept, true, sums);
        } else {
            node_sums_add_kept(kept, &among_kept, false, sums);
        }
    }
}

void path_nodes_add_up(PathNodes *nodes, const RayColumns *const kept[CHILD_COUNT]) {
    for (unsigned first = nodes->count; first > 0;) {
        first -= LANES;
        NodeSums sums = {path_nodes_color(nodes, NODE_LOCAL, first),
                         path_nodes_color(nodes, NODE_DROPPED, first),
                         path_nodes_color(nodes, NODE_GUARDED, first), real_of(0)};
        for (int child = 0; child < CHILD_COUNT; child++) {
            node_sums_add_children(nodes, kept[child], integer_load(&nodes->children[child][first]),
                                   &sums);
        }
        path_nodes_set_color(nodes, NODE_SUM, first, sums.color);
        path_nodes_set_color(nodes, NODE_SUM_DROPPED, first, sums.dropped);
        path_nodes_set_color(nodes, NODE_SUM_GUARDED, first, sums.guarded);
        real_store(&nodes->rays[first], sums.rays);
    }
}
