/**
 * @file
 * @brief Creation of the shapes of a scene, and of the BVH over them where there are many.
 */
#include "trace/bvh/shape_set.h"
#include "trace/mesh/mesh_bvh.h"

#include <stdlib.h>
#include <string.h>

/**
 * Number of bounded shapes from which on a BVH pays, measured with `f32x8` (doc/tree-pays.svg).
 * Coherent rays test a list quickly, eight boxes at a time: relative to a BVH, a list takes 0.95
 * times as long for a picture of 128 spheres, 1.04 times for 192 and 1.10 times for 256.
 */
enum { BVH_MIN_SHAPES = 192 };

/**
 * The same for reflective or transparent shapes, whose rays are incoherent: a list takes 0.97 times
 * as long for a picture of 20 mirroring spheres, 1.03 times for 24 and 3.8 times for 256.
 */
enum { BVH_MIN_SHAPES_REFLECTIVE = 24 };

/** @return Bytes of all shapes of a scene. @param methods A set of #ReportMethod. */
static size_t shapes_size(const Scene *scene, unsigned methods) {
    size_t size = 0;
    for (size_t i = 0; i < scene->shape_count; i++) {
        size += shape_size(&scene->shapes[i], methods);
    }
    return size;
}

/** Creates the shapes in #ShapeSet.memory. @return false without memory. */
static bool shapes_create(ShapeSet *set, const Scene *scene, MeshBvhCache *meshes, Error *error) {
    char *next = set->memory;
    for (size_t i = 0; i < scene->shape_count; i++) {
        Shape *shape = shape_init_from_scene(next, &scene->shapes[i], (int)i, meshes, error);
        if (!shape) {
            return false;
        }
        set->shapes[i] = shape;
        next += shape_size(&scene->shapes[i], meshes->methods);
    }
    return true;
}

/** @return Memory for shapes or boxes, set to zero; NULL without. */
static void *shapes_allocate(size_t size) {
    size_t whole = shape_aligned_size(size);
    void *memory = aligned_alloc(SHAPE_ALIGNMENT, whole + SHAPE_ALIGNMENT);
    return memory ? memset(memory, 0, whole) : NULL;
}

/** @return Whether so many shapes have a BVH of their own that the BVH of the set contains them,
 * too. Else a whole packet is intersected with each of them. */
static bool bvh_takes_instances(const ShapeSet *set) {
    /** Number of boxes of one test in the wider engines. */
    const size_t few = 8;
    size_t count = 0;
    for (size_t i = 0; i < set->count; i++) {
        count += shape_has_bvh(set->shapes[i]);
    }
    return count > few;
}

/** @return Whether a shape can be in the BVH. @param include_instances Whether shapes with a BVH of
 *  their own can be. */
static bool shape_goes_in_bvh(const Shape *shape, bool include_instances) {
    Aabbs box = shape->class->bounds(shape);
    return aabbs_is_bounded(&box) && (include_instances || !shape_has_bvh(shape));
}

/** @return Number of shapes that can be in the BVH. */
static size_t count_bvh_shapes(const ShapeSet *set) {
    size_t count = 0;
    for (size_t i = 0; i < set->count; i++) {
        count += shape_goes_in_bvh(set->shapes[i], set->bvh_over_instances);
    }
    return count;
}

/** @return See #ShapeSet.bvh_threshold. */
static size_t bvh_threshold_of(const Scene *scene, const TraceSettings *settings) {
    if (settings->bvh != BVH_AUTO) {
        return settings->bvh == BVH_ALWAYS ? 1 : SIZE_MAX;
    }
    bool is_mirrored = settings->depth > 0 && scene_has_secondary_rays(scene);
    return is_mirrored ? BVH_MIN_SHAPES_REFLECTIVE : BVH_MIN_SHAPES;
}

/** The shapes for the BVH. */
typedef struct BvhInput {
    Aabbs *boxes;      /**< Bounding boxes; owned. */
    uint32_t *indices; /**< Indices in #ShapeSet.shapes; owned. */
    size_t count;      /**< Number of shapes. */
} BvhInput;

/** Divides the shapes between BVH and list. @param[in,out] input The shapes for the BVH; NULL:
 * there is none. */
static void shapes_partition(ShapeSet *set, BvhInput *input) {
    for (size_t i = 0; i < set->count; i++) {
        Aabbs box = set->shapes[i]->class->bounds(set->shapes[i]);
        set->may_exceed_box |= shape_exceeds_box(set->shapes[i]);
        if (input && shape_goes_in_bvh(set->shapes[i], set->bvh_over_instances)) {
            input->boxes[input->count] = box;
            input->indices[input->count++] = (uint32_t)i;
        } else {
            size_t index = set->linear_count++;
            // A single ray is tested against this box only: see single_ray_candidates().
            box = LANES == 1 && shape_exceeds_box(set->shapes[i]) ? aabbs_infinite() : box;
            aabb_pack_set(&set->linear_bounds[index / AABB_PACK_SIZE], index % AABB_PACK_SIZE, box);
            set->linear[index] = set->shapes[i];
        }
    }
}

/** Builds the BVH. @return false without memory. */
static bool shapes_build_bvh(ShapeSet *set, const ParallelFor *parallel_for) {
    BvhInput input = {.boxes = malloc(set->count * sizeof *input.boxes),
                      .indices = malloc(set->count * sizeof *input.indices)};
    bool is_built = input.boxes && input.indices;
    if (is_built) {
        shapes_partition(set, &input);
        is_built = bvh_build(&set->bvh, input.boxes, input.count, 1, parallel_for);
        for (size_t i = 0; is_built && i < set->bvh.block_count; i++) {
            set->bvh.item_indices[i] = input.indices[set->bvh.item_indices[i]];
        }
    }
    free(input.boxes);
    free(input.indices);
    return is_built;
}

/** Allocates the arrays of a set. @param count Largest number of shapes. @return false without
 *  memory. */
static bool shapes_reserve(ShapeSet *set, size_t count) {
    set->shapes = calloc(count + 1, sizeof *set->shapes);
    set->linear = calloc(count + 1, sizeof *set->linear);
    set->linear_bounds = shapes_allocate(aabb_pack_count(count) * sizeof *set->linear_bounds);
    return set->shapes && set->linear && set->linear_bounds;
}

/** Builds the BVH if it pays, and fills the list. @return false without memory. */
static bool shapes_build_index(ShapeSet *set, const TraceSettings *settings) {
    set->bvh_over_instances = settings->bvh == BVH_ALWAYS || bvh_takes_instances(set);
    if (count_bvh_shapes(set) >= set->bvh_threshold) {
        return shapes_build_bvh(set, &settings->parallel_for);
    }
    shapes_partition(set, NULL);
    return true;
}

bool shape_set_init(ShapeSet *set, const Scene *scene, MeshBvhCache *meshes,
                    const TraceSettings *settings, Error *error) {
    size_t count = scene->shape_count;
    *set = (ShapeSet){.count = count, .bvh_threshold = bvh_threshold_of(scene, settings)};
    set->memory = shapes_allocate(shapes_size(scene, meshes->methods));
    if (!set->memory || !shapes_reserve(set, count) || !shapes_create(set, scene, meshes, error) ||
        !shapes_build_index(set, settings)) {
        shape_set_deinit(set);
        return error_set(error, STATUS_FAILED, "no memory for %zu shapes", count);
    }
    return true;
}

bool shape_set_filter(ShapeSet *subset, const ShapeSet *all, ShapePredicate predicate,
                      const void *context, const TraceSettings *settings) {
    *subset = (ShapeSet){.bvh_threshold = all->bvh_threshold};
    bool is_made = shapes_reserve(subset, all->count);
    for (size_t i = 0; is_made && i < all->count; i++) {
        if (predicate(all->shapes[i], context)) {
            subset->shapes[subset->count++] = all->shapes[i];
        }
    }
    if (!is_made || !shapes_build_index(subset, settings)) {
        shape_set_deinit(subset);
        return false;
    }
    return true;
}

Aabbd shape_set_bounds(const ShapeSet *set) {
    Aabbd bounds = aabbd_empty();
    for (size_t i = 0; i < set->count; i++) {
        Aabbs box = set->shapes[i]->class->bounds(set->shapes[i]);
        if (aabbs_is_bounded(&box)) {
            const scalar *low = box.low, *high = box.high;
            bounds =
                aabbd_add_point(bounds, (Vec3d){(double)low[0], (double)low[1], (double)low[2]});
            bounds =
                aabbd_add_point(bounds, (Vec3d){(double)high[0], (double)high[1], (double)high[2]});
        }
    }
    return bounds;
}

void shape_set_deinit(ShapeSet *set) {
    free(set->memory);
    free(set->shapes);
    free(set->linear);
    free(set->linear_bounds);
    bvh_deinit(&set->bvh);
    *set = (ShapeSet){0};
}
