/**
 * @file
 * @brief Shafts.
 */
#include "trace/tracer/shaft.h"

#include "trace/bvh/slab.h"
#include "trace/math/columns.h"

/** Two coordinates of a point. */
typedef struct Point2 {
    scalar u; /**< Along the first axis. */
    scalar v; /**< Along the second axis. */
} Point2;

/** The numbers of the planes of a shaft; those of LANES planes are loaded at once. */
typedef struct ShaftColumns {
    scalar normal[3][SHAFT_VECTORS * LANES]; /**< Components of the normals. */
} ShaftColumns;

/**
 * Sets a plane through a line from the apex to a corner.
 * @param plane      Its index.
 * @param u, v       The two axes.
 * @param from_apex  From the apex to the corner.
 * @param sign       1 or -1: for a normal that points inwards.
 */
static void shaft_set_plane(ShaftColumns *columns, int plane, int u, int v, Point2 from_apex,
                            scalar sign) {
    columns->normal[u][plane] = sign * from_apex.v;
    columns->normal[v][plane] = -sign * from_apex.u;
}

/**
 * Sets the two planes along one axis: in the plane of the two others, they are the tangents from
 * the apex to the rectangle of the origins. From inside the rectangle there are none.
 * @param low, high  Opposite corners of the rectangle, relative to the apex.
 */
static void shaft_set_tangents(ShaftColumns *columns, int plane, int u, int v, Point2 low,
                               Point2 high) {
    bool is_right = high.u<0, is_left = low.u> 0, is_above = high.v<0, is_below = low.v> 0;
    Point2 first, second;
    if (is_right || is_left) { // Seen from there, one corner of the near side or its neighbour.
        scalar near_side = is_right ? high.u : low.u, far_side = is_right ? low.u : high.u;
        first = (Point2){is_above ? far_side : near_side, high.v};
        second = (Point2){is_below ? far_side : near_side, low.v};
    } else if (is_above || is_below) {
        scalar near_side = is_above ? high.v : low.v;
        first = (Point2){low.u, near_side};
        second = (Point2){high.u, near_side};
    } else {
        return;
    }
    scalar sign = is_right || (is_above && !is_left) ? 1 : -1;
    shaft_set_plane(columns, plane, u, v, first, -sign);
    shaft_set_plane(columns, plane + 1, u, v, second, sign);
}

void intervals_shaft(const PacketIntervals *intervals, Shaft *shaft) {
    const scalar apex[3] = {intervals->target.x, intervals->target.y, intervals->target.z};
    ShaftColumns columns = {{{0}}};
    scalar low[3], high[3], slack = 0;
    for (int axis = 0; axis < 3; axis++) {
        scalar wider = REGION_SLACK * (intervals->region.high[axis] - intervals->region.low[axis]);
        low[axis] = (intervals->axis[axis].origin_low - apex[axis]) - wider;
        high[axis] = (intervals->axis[axis].origin_high - apex[axis]) + wider;
        slack += wider;
    }
    for (int axis = 0; axis < 3; axis++) {
        int u = (axis + 1) % 3, v = (axis + 2) % 3;
        shaft_set_tangents(&columns, 2 * axis, u, v, (Point2){low[u], low[v]},
                           (Point2){high[u], high[v]});
    }
    for (int i = 0; i < SHAFT_VECTORS; i++) {
        shaft->inward[i] = vec3_load(columns.normal[0] + i * LANES, columns.normal[1] + i * LANES,
                                     columns.normal[2] + i * LANES);
        shaft->slack[i] = slack * vec3_abs_sum(shaft->inward[i]);
    }
    shaft->apex = intervals->target;
    shaft->vector_count = SHAFT_VECTORS;
}
