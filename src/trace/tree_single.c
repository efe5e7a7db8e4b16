/**
 * @file
 * @brief Going through a tree ray by ray, several in flight.
 *
 * Rays that share nothing wait for memory at nearly every node. So several are on their way at
 * once, each takes one step in turn, and what its next step needs is fetched while the others take
 * theirs. A node's boxes are tested side by side against the one ray.
 */
#include "trace/slab.h"
#include "trace/tree.h"

/** Rays in flight: more gain nothing (measured on a mesh that fits no cache). */
enum { FLIGHTS = 8 };

/** A child that waits. */
typedef struct Waiting {
    scalar near;    /**< The ray meets nothing in it nearer than this. */
    uint32_t child; /**< A node or a leaf, see #TreeNode.children. */
} Waiting;

/** A ray on its way. */
typedef struct Flight {
    const Ray *rays;           /**< Its vector of the packet. */
    int vector;                /**< Which that is. */
    int lane;                  /**< Its lane of it. */
    SlabOrder order;           /**< Which of a box's planes it meets first. */
    bool is_flying;            /**< Whether it has not come to its end. */
    scalar limit;              /**< How far it still looks. */
    int waiting;               /**< How many children wait. */
    Waiting stack[TREE_STACK]; /**< What waits, the nearest on top. */
} Flight;

/** What a packet of rays and a tree share while its rays fly. */
typedef struct Airfield {
    const Tree *tree;       /**< The tree. */
    uint32_t child;         /**< Where they begin. */
    const Packet *packet;   /**< The rays. */
    Lanes left;             /**< Those that have not flown yet. */
    int vector;             /**< The first vector of those. */
    real *limits;           /**< How far they look. */
    const TreeOwner *owner; /**< Who is asked. */
    void *found;            /**< The owner's. */
} Airfield;

/** @return One of LANES points in all lanes. @param v The points. @param lane Which. */
INLINE Vector lane_spread(const Vector *v, int lane) {
    return (Vector){real_of(real_at(&v->x, lane)), real_of(real_at(&v->y, lane)),
                    real_of(real_at(&v->z, lane))};
}

/** Puts a ray of a packet where the rays begin. @param field The field. @param[out] flight The
 *  ray. @param v Its vector. @param lane Its lane. */
static void flight_begin(const Airfield *field, Flight *flight, int v, int lane) {
    const Vector *inverse = &field->packet->rays[v].inverse;
    flight->rays = &field->packet->rays[v];
    slab_sort(&flight->order, 0, real_at(&inverse->x, lane) < 0);
    slab_sort(&flight->order, 1, real_at(&inverse->y, lane) < 0);
    slab_sort(&flight->order, 2, real_at(&inverse->z, lane) < 0);
    flight->vector = v;
    flight->lane = lane;
    flight->limit = real_at(&field->limits[v], lane);
    flight->stack[0] = (Waiting){.child = field->child};
    flight->waiting = 1;
}

/** Lets the next ray of a packet fly, if there is one. @param field The field.
 *  @param[out] flight The ray. */
static void flight_start(Airfield *field, Flight *flight) {
    while (field->vector < PACKET_VECTORS && field->left.of[field->vector] == 0) {
        field->vector++;
    }
    flight->is_flying = field->vector < PACKET_VECTORS;
    if (flight->is_flying) {
        uint16_t *left = &field->left.of[field->vector];
        flight_begin(field, flight, field->vector, __builtin_ctz(*left));
        *left = (uint16_t)(*left & (*left - 1));
    }
}

/** Puts a child where its distance belongs. @param flight The ray. @param first The stack's first
 *  entry of the same node. @param entry The child. */
INLINE void flight_push(Flight *flight, int first, Waiting entry) {
    int i = flight->waiting++;
    for (; i > first && flight->stack[i - 1].near < entry.near; i--) {
        flight->stack[i] = flight->stack[i - 1];
    }
    flight->stack[i] = entry;
}

/** Puts the children that a ray may meet on its stack. @param flight The ray. @param node The node.
 */
static void flight_open(Flight *flight, const TreeNode *node) {
    int first = flight->waiting, ray = flight->lane;
    Vector origin = lane_spread(&flight->rays->origin, ray);
    Vector inverse = lane_spread(&flight->rays->inverse, ray);
    for (int b = 0; b < NODE_VECTORS; b++) {
        real near;
        unsigned left = slab_meets_in_order(origin, inverse, &node->bounds[b], &flight->order,
                                            real_of(flight->limit), &near);
        for (; left; left &= left - 1) {
            int lane = __builtin_ctz(left);
            Waiting entry = {real_at(&near, lane), node->children[b * LANES + lane]};
            flight_push(flight, first, entry);
        }
    }
}

/** Takes one step. @param field The field. @param flight The ray. @return false at the end of its
 *  way. */
static bool flight_step(Airfield *field, Flight *flight) {
    Waiting entry;
    do {
        if (flight->waiting == 0) {
            return false;
        }
        entry = flight->stack[--flight->waiting];
    } while (entry.near > flight->limit);
    if (entry.child & TREE_LEAF) {
        TreeRays rays = {field->packet, flight->vector, 1u << flight->lane, field->limits};
        field->owner->ask(field->owner->items, tree_leaf(entry.child), &rays, field->found);
        flight->limit = real_at(&field->limits[flight->vector], flight->lane);
        // A shadow ray that is blocked looks no further.
        flight->waiting = flight->limit < 0 ? 0 : flight->waiting;
    } else {
        flight_open(flight, &field->tree->nodes[entry.child]);
    }
    if (flight->waiting > 0) {
        tree_fetch(field->tree, field->owner, flight->stack[flight->waiting - 1].child);
    }
    return true;
}

void tree_visit_singly(const Tree *tree, uint32_t child, const Lanes *lanes, const Packet *packet,
                       real *limits, const TreeOwner *owner, void *found) {
    Airfield field = {tree, child, packet, *lanes, 0, limits, owner, found};
    Flight flights[FLIGHTS], *const end = flights + FLIGHTS;
    int flying = 0;
    for (Flight *flight = flights; flight < end; flight++) {
        flight_start(&field, flight);
        flying += flight->is_flying;
    }
    for (Flight *flight = flights; flying > 0; flight = flight + 1 < end ? flight + 1 : flights) {
        if (flight->is_flying && !flight_step(&field, flight)) {
            flight_start(&field, flight);
            flying -= !flight->is_flying;
        }
    }
}
