/**
 * @file
 * @brief Error of trapped light.
 *
 * The factors were compared with whole pictures of overlapping balls, boxes and cylinders, at
 * depths from 4 to 256, and of single bodies and balls of mirror in glass of index 1.33, 1.5 and
 * 2.42 (tests/test_precision_estimate.c).
 */
#include "render/trapped_light.h"

#include "base/encoding.h"
#include "render/precision_estimate.h"
#include "render/roundoff.h"

#include <math.h>

/** Factor per turn by which two rays diverge where glass overlaps: walls that curve inwards let
 *  rays converge in between. */
#define OVERLAP_SPREAD 1.4

/** The same with one bubble in the glass: it curves outwards, and all rays diverge. */
#define BUBBLE_SPREAD 2.0

/** The same with several bubbles. */
#define BUBBLES_SPREAD 2.5

/** Largest error of glass that overlaps, 8-bit steps. Beyond it, more turns make no more pixels
 *  wrong: about 0.6 % of those that show the glass. */
#define OVERLAP_MAXIMUM 2.5

/** The same of bubbles, with up to 24 % of the pixels. */
#define BUBBLE_MAXIMUM 25.0

/** Share of the picture from which on a growth counts in full. */
#define SHARE_IN_FULL 0.05

/** Fraction of the rays into an irregular body that float sends astray, over the square of its
 * index less 1: at most 1, 2 and 16 % were measured at 1.33, 1.5 and 2.42. The denser the glass,
 * the fewer directions leave it. */
#define ASTRAY_FRACTION 0.1

/** Light that is lost on a path without being missed: a quarter of an 8-bit step. */
#define WEIGHT_MINIMUM 1e-3

/** Relative difference of lengths that count as equal. */
#define SAME_LENGTH 1e-6

/** Ratio of the diagonal of a box to the radius of the shape in it, as large as a ball. */
#define DIAGONAL_PER_RADIUS 3.46

/** Pairs of shapes that trap light. */
typedef struct GlassPairs {
    double share; /**< Part of the picture that shows the smaller shapes. */
    int count;    /**< Number of pairs. */
} GlassPairs;

/** @return Whether two lengths are equal. */
static bool is_same(double a, double b, double scale) {
    return fabs(a - b) <= SAME_LENGTH * scale;
}

/** @return The size of a box along the axes. */
static Vec3d box_size(const Aabbd *box) {
    return vec3d_subtract(box->high, box->low);
}

/** @return Whether the box of a shape is a cube, as that of a ball is. */
static bool is_cubic(const GlassShape *shape) {
    Vec3d size = box_size(&shape->bounds);
    return is_same(size.x, size.y, size.x) && is_same(size.x, size.z, size.x);
}

/** @return Twice the distance between the middles of two boxes. */
static Vec3d twice_between(const GlassShape *a, const GlassShape *b) {
    return vec3d_subtract(vec3d_add(a->bounds.low, a->bounds.high),
                          vec3d_add(b->bounds.low, b->bounds.high));
}

/** @return Whether two shapes overlap by more than roundings: their boxes, or the balls in them. */
static bool shapes_overlap(const GlassShape *a, const GlassShape *b) {
    Vec3d size_a = box_size(&a->bounds), size_b = box_size(&b->bounds);
    double least = SAME_LENGTH * vec3d_max_abs(size_a);
    if (!a->is_flat && !b->is_flat && is_cubic(a) && is_cubic(b)) {
        return size_a.x + size_b.x - vec3d_length(twice_between(a, b)) > least;
    }
    Vec3d common = vec3d_subtract(vec3d_min(a->bounds.high, b->bounds.high),
                                  vec3d_max(a->bounds.low, b->bounds.low));
    return fmin(common.x, fmin(common.y, common.z)) > least;
}

/**
 * @return Whether two shapes of a kind share their axis, or as balls their centre, such as the
 * walls of a hollow ball or of a tumbler. Light between them keeps to regular paths.
 */
static bool is_coaxial(const GlassShape *a, const GlassShape *b) {
    Vec3d size_a = box_size(&a->bounds), size_b = box_size(&b->bounds);
    Vec3d twice = twice_between(a, b);
    double scale = vec3d_max_abs(size_a);
    const bool same[3] = {is_same(twice.x, 0, scale), is_same(twice.y, 0, scale),
                          is_same(twice.z, 0, scale)};
    bool is_centered = is_cubic(a) && is_cubic(b) && same[0] && same[1] && same[2];
    // A cylinder along an axis: as wide in two directions, and centred in both.
    const bool round_a[3] = {is_same(size_a.y, size_a.z, scale), is_same(size_a.x, size_a.z, scale),
                             is_same(size_a.x, size_a.y, scale)};
    const bool round_b[3] = {is_same(size_b.y, size_b.z, scale), is_same(size_b.x, size_b.z, scale),
                             is_same(size_b.x, size_b.y, scale)};
    bool has_axis = false;
    for (int axis = 0; axis < 3 && !is_cubic(a); axis++) {
        has_axis = has_axis ||
                   (round_a[axis] && round_b[axis] && same[(axis + 1) % 3] && same[(axis + 2) % 3]);
    }
    return a->class_index == b->class_index && (is_centered || has_axis);
}

/** @return Whether light is refracted irregularly between two shapes. */
static bool may_trap(const GlassShape *a, const GlassShape *b) {
    bool is_curved = !a->is_flat || !b->is_flat, is_glass = fmax(a->ior, b->ior) > 1;
    return is_curved && is_glass && shapes_overlap(a, b) && !is_coaxial(a, b);
}

/** @return The part of the picture that shows a shape. */
static double picture_share(const GlassShape *shape, const GlassView *view) {
    double radius = vec3d_length(box_size(&shape->bounds)) / DIAGONAL_PER_RADIUS;
    Vec3d middle = vec3d_scale(vec3d_add(shape->bounds.low, shape->bounds.high), 0.5);
    double distance = vec3d_length(vec3d_subtract(middle, view->position));
    double pixels = M_PI * pow(radius / fmax(distance, radius) / view->pixel_angle, 2);
    return fmin(1, pixels / view->pixels);
}

/** @return The turns after which a path still has light. @param weight Light left per turn. */
static double turns_of(int depth, double weight) {
    return weight < 1 ? fmin(depth, log(WEIGHT_MINIMUM) / log(weight)) : depth;
}

/** @return The error of pairs. @param growth Factor between rays at the end of a path. */
static double pairs_error(const GlassPairs *pairs, double growth, double maximum) {
    double error = fmin(ENCODING_CODE_MAXIMUM * FLOAT_ROUNDOFF * growth, maximum);
    return error * fmin(1, pairs->share / SHARE_IN_FULL);
}

/**
 * @return The error of rays that are astray at the end of their paths.
 * @param share   Part of the picture that shows the body.
 * @param ior     Its index of refraction.
 * @param growth  Factor between rays at the end of a path.
 */
static double astray_error(double share, double ior, double growth) {
    double beyond_air = fmax(0, ior - 1);
    double fraction = share * fmin(1, ASTRAY_FRACTION * beyond_air * beyond_air);
    return fmin(ENCODING_CODE_MAXIMUM * FLOAT_ROUNDOFF * growth,
                PRECISION_VISIBLE_ERROR * fraction / PRECISION_FRACTION_ALLOWED);
}

/** @return The error of all single bodies in which paths are irregular. */
static double bodies_error(const GlassShape *shapes, size_t count, const GlassView *view) {
    double error = 0;
    for (size_t i = 0; i < count; i++) {
        const GlassShape *body = &shapes[i];
        double growth = pow(body->ray_growth, turns_of(view->depth, body->transmittance));
        error += astray_error(picture_share(body, view), body->ior, growth);
    }
    return error;
}

double mirrored_light_error(const GlassShape *shapes, size_t count, const GlassShape *mirrors,
                            size_t mirror_count, const GlassView *view) {
    double error = 0;
    for (size_t i = 0; i < count * mirror_count; i++) {
        const GlassShape *glass = &shapes[i / mirror_count], *mirror = &mirrors[i % mirror_count];
        if (shapes_overlap(glass, mirror) && !is_coaxial(glass, mirror)) {
            // Every other turn is in the mirror, which curves outwards as a bubble does.
            double weight = sqrt(glass->transmittance * mirror->reflectance);
            double growth = pow(BUBBLES_SPREAD, turns_of(view->depth, weight));
            double share = fmin(picture_share(glass, view), picture_share(mirror, view));
            error += astray_error(share, glass->ior, growth);
        }
    }
    return error;
}

double trapped_light_error(const GlassShape *shapes, size_t count, const GlassView *view) {
    GlassPairs overlaps = {0}, bubbles = {0};
    double weight = 0;
    for (size_t later = 0; later < count; later++) {
        for (size_t earlier = 0; earlier < later; earlier++) {
            const GlassShape *a = &shapes[earlier], *b = &shapes[later];
            if (!may_trap(a, b)) {
                continue;
            }
            // A later shape of less index takes a bite out of the earlier one.
            GlassPairs *pairs = b->ior < a->ior && !b->is_flat ? &bubbles : &overlaps;
            pairs->share += fmin(picture_share(a, view), picture_share(b, view));
            pairs->count++;
            weight = fmax(weight, fmax(a->transmittance, b->transmittance));
        }
    }
    double turns = turns_of(view->depth, weight);
    double bubble_growth = pow(bubbles.count > 1 ? BUBBLES_SPREAD : BUBBLE_SPREAD, turns);
    double paired = fmax(pairs_error(&overlaps, pow(OVERLAP_SPREAD, turns), OVERLAP_MAXIMUM),
                         pairs_error(&bubbles, bubble_growth, BUBBLE_MAXIMUM));
    return fmax(paired, bodies_error(shapes, count, view));
}
