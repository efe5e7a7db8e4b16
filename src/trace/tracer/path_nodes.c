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

/** @return Colours from anywhere. @param places Of each lane. */
INLINE Rgb rgb_gather(const scalar *red, const scalar *green, const scalar *blue, integer places) {
    return (Rgb){real_gather(red, places), real_gather(green, places), real_gather(blue, places)};
}

/** @return Colours of nodes. @param places The nodes. */
INLINE Rgb path_nodes_gather(const PathNodes *nodes, NodeColor which, integer places) {
    const scalar(*columns)[NODE_ROOMS] = nodes->colors[which];
    return rgb_gather(columns[0], columns[1], columns[2], places);
}

/** @return A sum, with more in some lanes. */
INLINE Rgb rgb_add_lanes(Rgb sum, mask lanes, Rgb more) {
    return rgb_select(lanes, rgb_add(sum, more), sum);
}

/** Adds what children saw. @param lanes Where they were traced. @param places Their nodes. */
INLINE void node_sums_add_traced(const PathNodes *nodes, mask lanes, integer places,
                                 NodeSums *sums) {
    integer safe = integer_select(lanes, places, integer_of(0));
    Rgb weight = path_nodes_gather(nodes, NODE_WEIGHT, safe);
    Rgb color = rgb_multiply(weight, path_nodes_gather(nodes, NODE_SUM, safe));
    sums->color = rgb_add_lanes(sums->color, lanes, color);
    sums->dropped =
        rgb_add_lanes(sums->dropped, lanes, path_nodes_gather(nodes, NODE_SUM_DROPPED, safe));
    sums->guarded =
        rgb_add_lanes(sums->guarded, lanes, path_nodes_gather(nodes, NODE_SUM_GUARDED, safe));
    real rays = real_gather(nodes->rays, safe) + 1;
    sums->rays += real_select(lanes, rays, real_of(0));
}

/** Adds the losses of children that were kept. @param lanes Where they were. @param places Theirs,
 *  among those that were kept. */
INLINE void node_sums_add_kept(const RayColumns *kept, mask lanes, integer places, NodeSums *sums) {
    const scalar(*columns)[RAY_COLUMN_ROOMS] = kept->numbers[RAY_COLUMN_THROUGHPUT];
    integer safe = integer_select(lanes, places, integer_of(0));
    Rgb throughput = rgb_gather(columns[0] + RAY_COLUMN_FIRST, columns[1] + RAY_COLUMN_FIRST,
                                columns[2] + RAY_COLUMN_FIRST, safe);
    sums->dropped = rgb_add_lanes(sums->dropped, lanes, throughput);
}

void path_nodes_add_up(PathNodes *nodes, const RayColumns *const kept[CHILD_COUNT]) {
    for (unsigned first = nodes->count; first > 0;) {
        first -= LANES;
        NodeSums sums = {path_nodes_color(nodes, NODE_LOCAL, first),
                         path_nodes_color(nodes, NODE_DROPPED, first),
                         path_nodes_color(nodes, NODE_GUARDED, first), real_of(0)};
        for (int child = 0; child < CHILD_COUNT; child++) {
            integer places = integer_load(&nodes->children[child][first]);
            mask is_traced = places > NODE_NONE, is_kept = places < NODE_NONE;
            if (any(is_traced)) {
                node_sums_add_traced(nodes, is_traced, places, &sums);
            }
            if (any(is_kept)) {
                node_sums_add_kept(kept[child], is_kept, NODE_KEPT_FIRST - places, &sums);
            }
        }
        path_nodes_set_color(nodes, NODE_SUM, first, sums.color);
        path_nodes_set_color(nodes, NODE_SUM_DROPPED, first, sums.dropped);
        path_nodes_set_color(nodes, NODE_SUM_GUARDED, first, sums.guarded);
        real_store(&nodes->rays[first], sums.rays);
    }
}
