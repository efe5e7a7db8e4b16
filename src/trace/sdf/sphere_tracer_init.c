/**
 * @file
 * @brief Preparation of a field for sphere tracing. Transforms and repetition at the beginning of
 * its program are hoisted: they apply once per ray, and not once per step.
 */
#include "trace/sdf/sphere_tracer.h"

#include "trace/bvh/slab.h"

/** A field without its first nodes. */
typedef struct TransformHoist {
    const Sdf *sdf; /**< The field. */
    int first_node; /**< First remaining node. */
    Vec3d low;      /**< Lowest corner of the bounding box of the rest. */
    Vec3d high;     /**< Highest corner. */
} TransformHoist;

/** @return The first remaining node, if it has an operation and all others are its body; else NULL.
 */
static const SdfNode *transform_hoist_match(const TransformHoist *hoist, SdfOp op) {
    const SdfNode *node = &hoist->sdf->nodes[hoist->first_node];
    bool is_whole =
        node->op == op && node->body_count == hoist->sdf->node_count - hoist->first_node - 1;
    return is_whole ? node : NULL;
}

/** Continues with the body of the first node. @param box Bounding box of the body: six operands. */
static void transform_hoist_enter_body(TransformHoist *hoist, const double *box) {
    hoist->first_node++;
    hoist->low = (Vec3d){box[0], box[1], box[2]};
    hoist->high = (Vec3d){box[3], box[4], box[5]};
}

/** Hoists all leading transforms. @return Their product. */
static Similarity transform_hoist_similarity(TransformHoist *hoist) {
    Similarity similarity = similarity_identity();
    const SdfNode *node;
    while ((node = transform_hoist_match(hoist, SDF_TRANSFORM))) {
        similarity_append(&similarity, node->operands);
        transform_hoist_enter_body(hoist, node->operands + 13);
    }
    return similarity;
}

/** @return Whether copies stay within their cells. @param numbers Operands of a #SDF_REPEAT node.
 */
static bool repeat_copies_fit_cells(const double *numbers) {
    bool stays = true;
    for (int axis = 0; axis < 3; axis++) {
        double half = 0.5 * numbers[axis],
               magnitude = fmax(-numbers[12 + axis], numbers[15 + axis]);
        stays = stays && (numbers[axis] == 0 || magnitude <= half);
    }
    return stays;
}

/** Hoists a leading repetition whose copies stay within their cells. @return The grid. */
static RepeatGrid transform_hoist_grid(TransformHoist *hoist) {
    RepeatGrid grid = {.is_repeated = false};
    const SdfNode *node = transform_hoist_match(hoist, SDF_REPEAT);
    if (!node || !repeat_copies_fit_cells(node->operands)) {
        return grid;
    }
    grid.is_repeated = true;
    for (int axis = 0; axis < 3; axis++) {
        grid.period[axis] = (scalar)node->operands[axis];
        grid.half[axis] = (scalar)node->operands[3 + axis];
        grid.limit[axis] = (scalar)node->operands[6 + axis];
    }
    transform_hoist_enter_body(hoist, node->operands + 12);
    return grid;
}

/** Computes the bounding sphere of a copy. @param low Lowest corner of its bounding box. */
static void repeat_grid_compute_sphere(RepeatGrid *grid, const Similarity *inner, Vec3d low,
                                       Vec3d high) {
    Vec3d half = vec3d_scale(vec3d_subtract(high, low), 0.5);
    double radius = vec3d_length(half) * (double)inner->scale;
    grid->radius = INFINITE;
    if (radius < HUGE_VAL) {
        Vec3sw middle = vec3sw_of(vec3d_add(low, half)), zero = {0, 0, 0};
        Vec3sw local_center = vec3sw_subtract(zero, similarity_direction_to_world_s(inner, middle));
        grid->center = vec3s_narrow(vec3sw_subtract(inner->translation, local_center));
        grid->radius = (scalar)radius;
    }
}

/** @return The largest finite coordinate of a box. */
static scalar aabbs_magnitude(const Aabbs *box) {
    scalar magnitude = 0;
    for (int axis = 0; axis < 3; axis++) {
        magnitude =
            box->high[axis] < INFINITE && box->high[axis] > magnitude ? box->high[axis] : magnitude;
        magnitude =
            -box->low[axis] < INFINITE && -box->low[axis] > magnitude ? -box->low[axis] : magnitude;
    }
    return magnitude;
}

void sphere_tracer_init(SphereTracer *tracer, const Sdf *sdf, void *memory, Aabbs *bounds) {
    TransformHoist hoist = {sdf, 0, sdf->low, sdf->high};
    *bounds = aabbs_from_corners(sdf->low, sdf->high);
    scalar roundings = SDF_ERROR * ROUNDOFF * aabbs_magnitude(bounds);
    tracer->tolerance = tracer->tolerance > roundings ? tracer->tolerance : roundings;
    // Rays enter the enlarged boxes outside the surface.
    scalar margin = SDF_ERROR_TOLERANCES * (scalar)sdf->bound_slack * tracer->tolerance;
    // The box by which rays are culled contains that in the field's own coordinates, rounded.
    *bounds = aabbs_padded_by_largest(aabbs_enlarged(*bounds, margin));
    tracer->outer = transform_hoist_similarity(&hoist);
    scalar scale = (scalar)tracer->outer.scale;
    Aabbs all = aabbs_from_corners(hoist.low, hoist.high);
    tracer->grid_box = aabb_splat(aabbs_enlarged(all, margin / scale));
    tracer->grid = transform_hoist_grid(&hoist);
    tracer->inner = similarity_identity();
    if (tracer->grid.is_repeated) {
        tracer->inner = transform_hoist_similarity(&hoist);
        repeat_grid_compute_sphere(&tracer->grid, &tracer->inner, hoist.low, hoist.high);
    }
    tracer->scale = scale * (scalar)tracer->inner.scale;
    tracer->local_tolerance = tracer->tolerance / tracer->scale;
    Aabbs one = aabbs_from_corners(hoist.low, hoist.high);
    tracer->box = aabb_splat(aabbs_enlarged(one, margin / tracer->scale));
    tracer->bound_slack = (scalar)sdf->bound_slack;
    tracer->program =
        sdf_compile(memory, &sdf->nodes[hoist.first_node], sdf->node_count - hoist.first_node);
}
