/**
 * @file
 * @brief Curved surfaces that fight: spheres and ellipsoids, and the sides of cylinders and cones.
 */
#include "render/z_fighting/search.h"

#include <math.h>

/** The space of a shape relative to that of another. */
typedef struct RelativeSpace {
    Vec3d columns[3]; /**< Images of the unit vectors. */
    Vec3d origin;     /**< Image of the origin. */
} RelativeSpace;

/** @return The columns of a transform's matrix. @param transform NULL: the identity. */
static RelativeSpace space_of(const Transform *transform) {
    RelativeSpace space = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    for (int i = 0; transform && i < 3; i++) {
        const double(*m)[3] = transform->matrix;
        space.columns[i] = (Vec3d){m[0][i], m[1][i], m[2][i]};
    }
    space.origin = transform ? transform->translate : space.origin;
    return space;
}

/** @return A vector in the space of a shape, from one in the scene. @param columns Of the shape. */
static Vec3d vector_to_space(const Vec3d *columns, Vec3d v) {
    Vec3d yz = vec3d_cross(columns[1], columns[2]), zx = vec3d_cross(columns[2], columns[0]),
          xy = vec3d_cross(columns[0], columns[1]);
    double per_volume = 1 / vec3d_dot(columns[0], yz);
    return (Vec3d){vec3d_dot(yz, v) * per_volume, vec3d_dot(zx, v) * per_volume,
                   vec3d_dot(xy, v) * per_volume};
}

/** @return A vector of a space, in the space that it is relative to. */
static Vec3d vector_from_space(const RelativeSpace *space, Vec3d v) {
    Vec3d sum = vec3d_scale(space->columns[0], v.x);
    sum = vec3d_add(sum, vec3d_scale(space->columns[1], v.y));
    return vec3d_add(sum, vec3d_scale(space->columns[2], v.z));
}

/** @return The space of a shape, relative to that of another. */
static RelativeSpace relative_space(const Transform *from, const Transform *to) {
    RelativeSpace space = space_of(from), other = space_of(to);
    for (int i = 0; i < 3; i++) {
        space.columns[i] = vector_to_space(other.columns, space.columns[i]);
    }
    space.origin = vector_to_space(other.columns, vec3d_subtract(space.origin, other.origin));
    return space;
}

/** A range of numbers. */
typedef struct Range {
    double low;  /**< Lowest. */
    double high; /**< Highest. */
} Range;

/** @return By how much a space stretches the vectors across an axis, or all if the axis is 0: from
 *          Gershgorin's circles of the squared lengths. */
static Range stretch_across(const RelativeSpace *space, Vec3d axis) {
    Vec3d aside = fabs(axis.x) < 0.5 * vec3d_length(axis) ? (Vec3d){1, 0, 0} : (Vec3d){0, 1, 0};
    Vec3d right = vec3d_normalize(vec3d_cross(axis, aside)),
          up = vec3d_normalize(vec3d_cross(axis, right));
    bool is_sphere = vec3d_max_abs(axis) == 0;
    const Vec3d directions[] = {
        is_sphere ? (Vec3d){1, 0, 0} : right, is_sphere ? (Vec3d){0, 1, 0} : up, {0, 0, 1}};
    const int count = is_sphere ? 3 : 2;
    Range squared = {HUGE_VAL, 0};
    for (int i = 0; i < count; i++) {
        Vec3d image = vector_from_space(space, directions[i]);
        double length = vec3d_dot(image, image), others = 0;
        for (int k = 0; k < count; k++) {
            Vec3d other = vector_from_space(space, directions[k]);
            others += k == i ? 0 : fabs(vec3d_dot(image, other));
        }
        squared.low = fmin(squared.low, length - others);
        squared.high = fmax(squared.high, length + others);
    }
    return (Range){sqrt(fmax(0, squared.low)), sqrt(squared.high)};
}

/** Two shells in the space of the first. */
typedef struct ShellPair {
    ShapeShell a;  /**< The first. */
    ShapeShell b;  /**< The second; its radii are those of its own space. */
    Range stretch; /**< Factors from the second's space across its axis. */
} ShellPair;

/** The gap between two shells. */
typedef struct ShellGap {
    Range range;   /**< Its lowest and highest value; nothing in between if they do not meet. */
    double length; /**< Length that both have in common along the axis; 0 for spheres. */
} ShellGap;

/** Widens a range by the gap where two shells have given radii. @param apart Distance of their
 *  axes. */
static void range_add_gap(Range *range, double a, double b, const Range *stretch, double apart) {
    range->low = fmin(range->low, b * stretch->low - a - apart);
    range->high = fmax(range->high, b * stretch->high - a + apart);
}

/** @return The radius of a cone at a part of its length. */
static double radius_at(const ShapeShell *shell, double part) {
    return shell->radius + (shell->top_radius - shell->radius) * part;
}

/** @return The gap between two spheres, or two cylinders or cones; else a range that is empty. */
static ShellGap shell_gap_of(const ShellPair *pair) {
    const ShapeShell *a = &pair->a, *b = &pair->b;
    Vec3d axis_a = vec3d_subtract(a->top, a->base), axis_b = vec3d_subtract(b->top, b->base);
    double length_a = vec3d_length(axis_a), length_b = vec3d_length(axis_b);
    ShellGap gap = {.range = {HUGE_VAL, -HUGE_VAL}};
    if (length_a == 0 && length_b == 0) {
        double apart = vec3d_length(vec3d_subtract(a->base, b->base));
        range_add_gap(&gap.range, a->radius, b->radius, &pair->stretch, apart);
    }
    if (!(fabs(vec3d_dot(axis_a, axis_b)) > PARALLEL_COSINE * length_a * length_b)) {
        return gap;
    }
    // Where the second axis starts and ends along the first, and how far from it.
    Vec3d unit = vec3d_scale(axis_a, 1 / length_a);
    Vec3d from_base = vec3d_subtract(b->base, a->base), from_top = vec3d_subtract(b->top, a->base);
    double base = vec3d_dot(from_base, unit), top = vec3d_dot(from_top, unit);
    double apart = fmax(vec3d_length(vec3d_subtract(from_base, vec3d_scale(unit, base))),
                        vec3d_length(vec3d_subtract(from_top, vec3d_scale(unit, top))));
    const double ends[] = {fmax(0, fmin(base, top)), fmin(length_a, fmax(base, top))};
    gap.length = ends[1] - ends[0];
    for (int i = 0; i < 2 && gap.length > 0; i++) {
        range_add_gap(&gap.range, radius_at(a, ends[i] / length_a),
                      radius_at(b, (ends[i] - base) / (top - base)), &pair->stretch, apart);
    }
    return gap;
}

void compare_shells(Search *search, const SceneShape *shape_a, const SceneShape *shape_b,
                    double bound) {
    const SceneShapeClass *class_a = scene_shape_classes[shape_a->class_index],
                          *class_b = scene_shape_classes[shape_b->class_index];
    if (!class_a->shell || !class_b->shell) {
        return;
    }
    ShellPair pair = {.a = class_a->shell(shape_a->parameters),
                      .b = class_b->shell(shape_b->parameters)};
    RelativeSpace space = relative_space(shape_b->transform, shape_a->transform);
    pair.stretch = stretch_across(&space, vec3d_subtract(pair.b.top, pair.b.base));
    pair.b.base = vec3d_add(space.origin, vector_from_space(&space, pair.b.base));
    pair.b.top = vec3d_add(space.origin, vector_from_space(&space, pair.b.top));
    ShellGap gap = shell_gap_of(&pair);
    // Back to the scene: gaps as small, and areas as large, as the scale may make them.
    const Transform *transform = shape_a->transform;
    Vec3d scale = transform ? transform->scale : (Vec3d){1, 1, 1},
          center = transform ? transform_point(transform, pair.a.base) : pair.a.base;
    double smallest = fmin(fabs(scale.x), fmin(fabs(scale.y), fabs(scale.z))),
           largest = vec3d_max_abs(scale);
    double radius = largest * fmax(pair.a.radius, pair.a.top_radius);
    double magnitude = magnitude_from(search->origin, center) + radius;
    Vec3d to_eye = vec3d_subtract(search->scene->camera.position, center);
    double distance = fmax(vec3d_length(to_eye), radius);
    bool has_glass = is_glass(search, shape_a) || is_glass(search, shape_b);
    GapScale seen = {distance, transform || shape_b->transform ? distance : 0, magnitude,
                     has_glass};
    double reach = search->has_secondary ? bound : gap_bound(seen);
    double low = gap.range.low * smallest, high = gap.range.high * smallest;
    double from = fmax(low, -reach), to = fmin(high, reach);
    if (!(from <= to) || fmax(fabs(low), fabs(high)) <= COINCIDENT * (distance + magnitude)) {
        return;
    }
    double part = high > low ? (to - from) / (high - low) : 1;
    double picture = 4 * search->half_width * search->half_height * distance * distance;
    double area = M_PI * radius * radius + 2 * radius * gap.length * largest;
    search->result.fraction += fmin(1, area / picture) * fmin(1, part) *
                               (has_glass ? GLASS_CHANCE : chance_between(from, to, reach));
}
