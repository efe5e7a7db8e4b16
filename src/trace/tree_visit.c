/**
 * @file
 * @brief Going through a tree with a packet of rays.
 *
 * The boxes of a node are first tested by intervals, for the whole packet at once; those that are
 * left, ray by ray, for the vectors of rays that reached the node. Children wait on a stack, the
 * nearest on top.
 */
#include "trace/slab.h"
#include "trace/tree.h"

/** Rays that go one by one when no more than these are left: mirrored ones are a third faster so
 *  (measured: 4, 16, 24, 40). */
enum { FEW_RAYS = 16 };

/** A child that waits. */
typedef struct Waiting {
    scalar near;    /**< No ray of the packet meets anything in it nearer than this. */
    uint32_t child; /**< A node or a leaf, see #TreeNode.children. */
    Lanes lanes;    /**< The rays that may meet it. */
} Waiting;

/** A packet on its way through a tree. */
typedef struct Journey {
    const Packet *packet;      /**< The rays. */
    Spans spans;               /**< What is known of all of them. */
    real *limits;              /**< How far each still looks. */
    Waiting stack[TREE_STACK]; /**< What waits. */
    int waiting;               /**< How many. */
} Journey;

/** Puts a child where its distance belongs, above all that are farther. @param journey The journey.
 *  @param first The stack's first entry that is of the same node. @param entry The child. */
static void journey_push(Journey *journey, int first, Waiting entry) {
    int i = journey->waiting++;
    for (; i > first && journey->stack[i - 1].near < entry.near; i--) {
        journey->stack[i] = journey->stack[i - 1];
    }
    journey->stack[i] = entry;
}

/** Finds the rays that meet a child's box. @param journey The journey. @param box The box, in all
 * lanes.
 *  @param lanes The rays that reached the node. @param[out] meeting Those that meet the box.
 *  @return Whether there are any. */
static bool child_meets(const Journey *journey, const BoundsBlock *box, const Lanes *lanes,
                        Lanes *meeting) {
    unsigned met = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        meeting->of[v] = 0;
        if (lanes->of[v]) {
            real near;
            mask meets = slab_meets(&journey->packet->rays[v], box, journey->limits[v], &near);
            meeting->of[v] = (uint16_t)(mask_bits(meets) & lanes->of[v]);
            met |= meeting->of[v];
        }
    }
    return met != 0;
}

/** Puts the children that rays may meet on the stack. @param journey The journey. @param node The
 *  node. @param lanes The rays that reached it. */
static void node_open(Journey *journey, const TreeNode *node, const Lanes *lanes) {
    int first = journey->waiting;
    for (int b = 0; b < NODE_VECTORS; b++) {
        real near;
        unsigned left = mask_bits(spans_may_meet(&journey->spans, &node->bounds[b], &near));
        for (; left; left &= left - 1) {
            int lane = __builtin_ctz(left);
            Waiting entry = {real_at(&near, lane), node->children[b * LANES + lane], {{0}}};
            BoundsBlock box = slab_spread(&node->bounds[b], lane);
            if (child_meets(journey, &box, lanes, &entry.lanes)) {
                journey_push(journey, first, entry);
            }
        }
    }
}

/** Drops the rays that no longer look as far as something is. @param journey The journey.
 *  @param[in,out] entry What waits. @return Whether any is left. */
static bool entry_is_wanted(const Journey *journey, Waiting *entry) {
    unsigned left = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        if (entry->lanes.of[v]) {
            unsigned looks = mask_bits(journey->limits[v] >= real_of(entry->near));
            entry->lanes.of[v] = (uint16_t)(entry->lanes.of[v] & looks);
            left |= entry->lanes.of[v];
        }
    }
    return left != 0;
}

/** Asks the owner about a leaf. @param journey The journey. @param owner The owner.
 *  @param leaf The leaf. @param[in,out] found The owner's. */
static void leaf_ask(Journey *journey, const TreeOwner *owner, const Waiting *leaf, void *found) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        if (leaf->lanes.of[v]) {
            TreeRays rays = {journey->packet, v, leaf->lanes.of[v], journey->limits};
            owner->ask(owner->items, tree_leaf(leaf->child), &rays, found);
        }
    }
}

/** @return Whether the rays of a packet go about the same way: up or down along one axis at least.
 *  @param spans What is known of it. */
static bool spans_are_coherent(const Spans *spans) {
    bool is_coherent = false;
    for (int axis = 0; axis < 3; axis++) {
        const Span *span = &spans->axis[axis];
        is_coherent = is_coherent || span->inverse_low > 0 || span->inverse_high < 0;
    }
    return is_coherent;
}

/** @return How many rays. @param lanes Which. */
static int lanes_count(const Lanes *lanes) {
    int count = 0;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        count += __builtin_popcount(lanes->of[v]);
    }
    return count;
}

/** Takes what waits on top: for all its rays together, or one by one where they are few.
 *  @param journey The journey. @param tree The tree. @param owner The owner.
 *  @param[in,out] found The owner's. */
static void journey_step(Journey *journey, const Tree *tree, const TreeOwner *owner, void *found) {
    Waiting entry = journey->stack[--journey->waiting];
    if (journey->waiting > 0) {
        tree_fetch(tree, owner, journey->stack[journey->waiting - 1].child);
    }
    if (!entry_is_wanted(journey, &entry)) {
        return;
    }
    if (entry.child & TREE_LEAF) {
        leaf_ask(journey, owner, &entry, found);
    } else if (!owner->asks_vectors && lanes_count(&entry.lanes) <= FEW_RAYS) {
        tree_visit_singly(tree, entry.child, &entry.lanes, journey->packet, journey->limits, owner,
                          found);
    } else {
        node_open(journey, &tree->nodes[entry.child], &entry.lanes);
    }
}

void tree_visit(const Tree *tree, const Packet *packet, real *limits, const TreeOwner *owner,
                void *found) {
    Journey journey;
    journey.packet = packet;
    journey.limits = limits;
    journey.stack[0] = (Waiting){0};
    for (int v = 0; v < PACKET_VECTORS; v++) {
        journey.stack[0].lanes.of[v] = (uint16_t)mask_bits(packet->active[v]);
    }
    if (LANES > 1) {
        journey.spans = packet_spans(packet);
    }
    if (LANES == 1 || (!owner->asks_vectors && !spans_are_coherent(&journey.spans))) {
        tree_visit_singly(tree, 0, &journey.stack[0].lanes, packet, limits, owner, found);
        return;
    }
    journey.waiting = 1;
    while (journey.waiting > 0) {
        journey_step(&journey, tree, owner, found);
    }
}
