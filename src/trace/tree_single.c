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
    size_t enter[3];           /**< Which of a node's planes it meets first, of each pair. */
    size_t leave[3];           /**< Which it meets last. */
    bool is_flying;            /**< Whether it has not come to its end. */
    scalar limit;              /**< How far it still looks. */
    int waiting;               /**< How many children wait. */
    Waiting stack[TREE_STACK]; /**< What waits, the nearest on top. */
} Flight;

/** What a packet of rays and a tree share while its rays fly. */
typedef struct Field {
    const Tree *tree;       /**< The tree. */
    uint32_t child;         /**< Where they begin. */
    const Packet *packet;   /**< The rays. */
    Lanes left;             /**< Those that have not flown yet. */
    int vector;             /**< The first vector of those. */
    real *limits;           /**< How far they look. */
    const TreeOwner *owner; /**< Who is asked. */
    void *found;            /**< The owner's. */
} Field;

/** Notes which of two planes a ray meets first. @param[in,out] flight The ray. @param axis The
 * axis.
 *  @param is_down Whether it goes down along it. */
INLINE void flight_sort(Flight *flight, size_t axis, bool is_down) {
    flight->enter[axis] = is_down ? axis + 3 : axis;
    flight->leave[axis] = is_down ? axis : axis + 3;
}

/** Puts a ray of a packet where the rays begin. @param field The field. @param[out] flight The
 *  ray. @param v Its vector. @param lane Its lane. */
static void flight_begin(const Field *field, Flight *flight, int v, int lane) {
    const Vector *inverse = &field->packet->rays[v].inverse;
    flight->rays = &field->packet->rays[v];
    flight_sort(flight, 0, real_at(&inverse->x, lane) < 0);
    flight_sort(flight, 1, real_at(&inverse->y, lane) < 0);
    flight_sort(flight, 2, real_at(&inverse->z, lane) < 0);
    flight->vector = v;
    flight->lane = lane;
    flight->limit = real_at(&field->limits[v], lane);
    flight->stack[0] = (Waiting){.child = field->child};
    flight->waiting = 1;
}

/** Lets the next ray of a packet fly, if there is one. @param field The field.
 *  @param[out] flight The ray. */
static void flight_start(Field *field, Flight *flight) {
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

/**
 * @return The children whose boxes a ray may meet before its limit.
 * @param flight     The ray.
 * @param block      The boxes.
 * @param[out] near  Where it meets each.
 */
INLINE unsigned boxes_met(const Flight *flight, const BoundsBlock *block, real *near) {
    real from = real_of(0), to = real_of(flight->limit);
    const Vector *o = &flight->rays->origin, *i = &flight->rays->inverse;
    const real *origin[3] = {&o->x, &o->y, &o->z}, *inverse[3] = {&i->x, &i->y, &i->z};
    for (int axis = 0; axis < 3; axis++) {
        slab_narrow(&from, &to, block->planes[flight->enter[axis]],
                    block->planes[flight->leave[axis]],
                    real_of(real_at(origin[axis], flight->lane)),
                    real_of(real_at(inverse[axis], flight->lane)));
    }
    *near = from * (1 - SLAB_SLACK);
    return mask_bits(*near <= to * (1 + SLAB_SLACK));
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
    int first = flight->waiting;
    for (int b = 0; b < NODE_VECTORS; b++) {
        real near;
        unsigned left = boxes_met(flight, &node->bounds[b], &near);
        for (; left; left &= left - 1) {
            int lane = __builtin_ctz(left);
            Waiting entry = {real_at(&near, lane), node->children[b * LANES + lane]};
            flight_push(flight, first, entry);
        }
    }
}

/** Fetches memory that will be needed. @param at Where. @param bytes How much. */
INLINE void memory_fetch(const void *at, size_t bytes) {
    /** Bytes that one fetch brings. */
    enum { LINE = 64 };
    for (size_t i = 0; i < bytes; i += LINE) {
        __builtin_prefetch((const char *)at + i);
    }
}

/** Fetches what a ray's next step needs. @param field The field. @param flight The ray. */
INLINE void flight_fetch(const Field *field, const Flight *flight) {
    if (flight->waiting == 0) {
        return;
    }
    uint32_t child = flight->stack[flight->waiting - 1].child;
    const TreeOwner *owner = field->owner;
    if (!(child & TREE_LEAF)) {
        memory_fetch(&field->tree->nodes[child], sizeof(TreeNode));
    } else if (owner->blocks) {
        size_t first = (child & ~TREE_LEAF) >> TREE_BLOCK_BITS;
        memory_fetch((const char *)owner->blocks + first * owner->block_bytes, owner->block_bytes);
    }
}

/** Takes one step. @param field The field. @param flight The ray. @return false at the end of its
 *  way. */
static bool flight_step(Field *field, Flight *flight) {
    Waiting entry;
    do {
        if (flight->waiting == 0) {
            return false;
        }
        entry = flight->stack[--flight->waiting];
    } while (entry.near > flight->limit);
    if (entry.child & TREE_LEAF) {
        size_t first = (entry.child & ~TREE_LEAF) >> TREE_BLOCK_BITS;
        real limits =
            field->owner->ask(field->owner->items, first, entry.child & TREE_LEAF_BLOCKS,
                              field->packet, flight->vector, 1u << flight->lane, field->found);
        flight->limit = real_at(&limits, flight->lane);
        // A shadow ray that is blocked looks no further.
        flight->waiting = flight->limit < 0 ? 0 : flight->waiting;
    } else {
        flight_open(flight, &field->tree->nodes[entry.child]);
    }
    flight_fetch(field, flight);
    return true;
}

void tree_visit_singly(const Tree *tree, uint32_t child, const Lanes *lanes, const Packet *packet,
                       real *limits, const TreeOwner *owner, void *found) {
    Field field = {tree, child, packet, *lanes, 0, limits, owner, found};
    Flight flights[FLIGHTS], *const end = flights + FLIGHTS;
    int flying = 0;
    for (Flight *flight = flights; flight < end; flight++) {
        flight_start(&field, flight);
        flying += flight->is_flying;
    }
    for (Flight *flight = flights; flying > 0; flight = flight + 1 < end ? flight + 1 : flights) {
        if (flight->is_flying && !flight_step(&field, flight)) {
            real_set_lane(&limits[flight->vector], flight->lane, flight->limit);
            flight_start(&field, flight);
            flying -= !flight->is_flying;
        }
    }
}
