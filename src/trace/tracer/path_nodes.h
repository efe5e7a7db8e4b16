/**
 * @file
 * @brief What the rays of a wavefront saw, and the sums of that along their paths.
 *
 * A node is a ray that was traced. Its children are the rays that start at its surface. They are
 * traced later, so they come after it, and one run from the last node to the first adds up all
 * colours and losses: first what the reflected ray brings, then the refracted one, as the recursion
 * does.
 */
#ifndef DIOPTRE_TRACE_TRACER_PATH_NODES_H
#define DIOPTRE_TRACE_TRACER_PATH_NODES_H

#include "trace/tracer/ray_columns.h"

/** Most nodes. */
enum { NODES_MAXIMUM = 1 << 17 };
/** Rooms of a column of nodes. */
enum { NODE_ROOMS = COLUMN_ROOMS(NODES_MAXIMUM) };

/** A secondary ray of a surface; also the order in which their light is added. */
typedef enum Child { CHILD_REFLECTED, CHILD_REFRACTED, CHILD_COUNT } Child;

/** Instead of the node of a child: there is none. */
enum { NODE_NONE = -1 };
/** The child is the first of the rays of its kind that were kept; -3 is the second, and so on. */
enum { NODE_KEPT_FIRST = -2 };

/** What a node knows in colours. */
typedef enum NodeColor {
    NODE_WEIGHT,      /**< The factor of its colour in that of its parent. */
    NODE_LOCAL,       /**< The colour of its surface alone. */
    NODE_DROPPED,     /**< What ended at its surface: see #Losses. */
    NODE_GUARDED,     /**< See #Losses. */
    NODE_SUM,         /**< Its colour, with that of the rays below. */
    NODE_SUM_DROPPED, /**< What ended below, with #NODE_DROPPED. */
    NODE_SUM_GUARDED, /**< What ended below, with #NODE_GUARDED. */
    NODE_COLOR_COUNT
} NodeColor;

/** Nodes, in columns. The nodes of a vector of rays begin at a multiple of LANES. */
typedef struct PathNodes {
    scalar colors[NODE_COLOR_COUNT][3][NODE_ROOMS];   /**< Red, green and blue of each. */
    scalar rays[NODE_ROOMS];                          /**< Number of rays below. */
    integer_scalar children[CHILD_COUNT][NODE_ROOMS]; /**< Their nodes; see #NODE_NONE. */
    unsigned count;                                   /**< Number of nodes. */
} PathNodes;

/** @return Colours of LANES nodes. @param first The first of them. */
INLINE Rgb path_nodes_color(const PathNodes *nodes, NodeColor which, unsigned first) {
    const scalar(*columns)[NODE_ROOMS] = nodes->colors[which];
    return (Rgb){real_load(&columns[0][first]), real_load(&columns[1][first]),
                 real_load(&columns[2][first])};
}

/** Sets colours of LANES nodes. */
INLINE void path_nodes_set_color(PathNodes *nodes, NodeColor which, unsigned first, Rgb color) {
    scalar(*columns)[NODE_ROOMS] = nodes->colors[which];
    real_store(&columns[0][first], color.red);
    real_store(&columns[1][first], color.green);
    real_store(&columns[2][first], color.blue);
}

/** @return Where nodes keep a child, as one number. */
INLINE integer node_link(integer nodes, Child child) {
    return nodes * CHILD_COUNT + (int)child;
}

/** Sets the node of a child. @param link By node_link(). */
INLINE void path_nodes_set_child(PathNodes *nodes, int link, int node) {
    nodes->children[link % CHILD_COUNT][link / CHILD_COUNT] = node;
}

/** Adds nodes of a vector of rays, without children. @param weight See #NODE_WEIGHT. @return The
 *  first of them. */
INLINE unsigned path_nodes_add(PathNodes *nodes, Rgb weight, Rgb local, Rgb dropped, Rgb guarded) {
    unsigned first = nodes->count;
    path_nodes_set_color(nodes, NODE_WEIGHT, first, weight);
    path_nodes_set_color(nodes, NODE_LOCAL, first, local);
    path_nodes_set_color(nodes, NODE_DROPPED, first, dropped);
    path_nodes_set_color(nodes, NODE_GUARDED, first, guarded);
    for (int child = 0; child < CHILD_COUNT; child++) {
        integer_store(&nodes->children[child][first], integer_of(NODE_NONE));
    }
    nodes->count += LANES;
    return first;
}

/**
 * Adds up colours and losses, from the last nodes to the first.
 * @param kept  Per child, rays that were not traced: their throughput is a loss.
 */
void path_nodes_add_up(PathNodes *nodes, const RayColumns *const kept[CHILD_COUNT]);

#endif
