/**
 * @file
 * @brief Distance fields: their construction and their properties.
 *
 * The primitives and operations are those of Inigo Quilez (*Distance functions*).
 * doc/scene-reference.md lists which fields are exact and which are bounds; tests check it.
 */
#include "dioptre/sdf.h"

#include <string.h>

/** Largest number of nodes that an operation adds per field. */
enum { NODES_ADDED = 1 };

size_t sdf_size(int node_count) {
    return sizeof(Sdf) + (size_t)node_count * sizeof(SdfNode);
}

int sdf_combined_capacity(const Sdf *const *sdfs, int count) {
    int capacity = 0;
    for (int i = 0; i < count; i++) {
        capacity += sdfs[i]->node_count + NODES_ADDED;
    }
    return capacity;
}

/* --- what methods take ------------------------------------------------------------------------ */

const Parameter sdf_period_parameter = {.name = "repeat_every",
                                        .type = PARAMETER_VECTOR,
                                        .minimum = 0,
                                        .maximum = LENGTH_MAXIMUM,
                                        .unit = "scene units",
                                        .help = "from one copy to the next; 0: not repeated"};
const Parameter sdf_count_parameter = {.name = "count",
                                       .type = PARAMETER_VECTOR,
                                       .minimum = 0,
                                       .maximum = 1000000,
                                       .unit = "copies",
                                       .help = "how many copies; 0: without end"};
const Parameter sdf_scale_parameter = {.name = "scale",
                                       .type = PARAMETER_NUMBER,
                                       .minimum = SCALE_MINIMUM,
                                       .maximum = 1 / SCALE_MINIMUM,
                                       .unit = "times",
                                       .help = "how many times as large"};
const Parameter sdf_round_parameter = {.name = "round",
                                       .type = PARAMETER_NUMBER,
                                       .minimum = 0,
                                       .maximum = LENGTH_MAXIMUM,
                                       .unit = "scene units",
                                       .help = "how far the surface is moved outwards"};
const Parameter sdf_radius_parameter = {.name = "radius",
                                        .type = PARAMETER_NUMBER,
                                        .minimum = LENGTH_MINIMUM,
                                        .maximum = LENGTH_MAXIMUM,
                                        .unit = "scene units",
                                        .help = "how far from both the seam is filled"};

/* --- how they are put together ---------------------------------------------------------------- */

/**
 * Appends a node and its body to a field.
 * @param[in,out] out  The field.
 * @param node         The node; its body count is set in the copy.
 * @param body         The body.
 */
static void sdf_append(Sdf *out, const SdfNode *node, const Sdf *body) {
    SdfNode *copy = &out->nodes[out->node_count];
    *copy = *node;
    copy->body_count = body->node_count;
    memcpy(copy + 1, body->nodes, (size_t)body->node_count * sizeof *copy);
    out->node_count += body->node_count + 1;
}

/** Says that a field is made of too many others. @return false */
static bool reject_node_count(Error *error) {
    return error_set(error, STATUS_SCENE, "a field may be made of at most %d fields",
                     SDF_NODES_MAXIMUM);
}

/**
 * Creates a field of a node and its body.
 * @param[out] out    The field.
 * @param node        The node.
 * @param sdf         The body; its other properties are copied.
 * @param[out] error  What is wrong.
 * @return false if it has too many nodes or is too deep.
 */
static bool sdf_wrap(Sdf *out, const SdfNode *node, const Sdf *sdf, Error *error) {
    *out = *sdf;
    out->node_count = 0;
    out->depth = sdf->depth + 1;
    if (out->depth > SDF_DEPTH_MAXIMUM) {
        return error_set(error, STATUS_SCENE, "fields stand in fields more than %d deep",
                         SDF_DEPTH_MAXIMUM);
    }
    if (sdf->node_count >= SDF_NODES_MAXIMUM) {
        return reject_node_count(error);
    }
    sdf_append(out, node, sdf);
    return true;
}

/** @return The product of a matrix and a point. */
static Vec3d matrix3x3_apply(const double m[3][3], Vec3d p) {
    return (Vec3d){m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z,
                   m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z,
                   m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z};
}

/** Transforms the bounding box of a field. @param[in,out] sdf The field. @param t The transform. */
static void sdf_transform_bounds(Sdf *sdf, const Transform *t) {
    Vec3d corners[2] = {sdf->low, sdf->high};
    bool is_turned = t->rotate.x != 0 || t->rotate.y != 0 || t->rotate.z != 0;
    if (!is_turned) {
        sdf->low = vec3d_add(vec3d_scale(corners[0], t->scale.x), t->translate);
        sdf->high = vec3d_add(vec3d_scale(corners[1], t->scale.x), t->translate);
        return;
    }
    sdf->low = (Vec3d){HUGE_VAL, HUGE_VAL, HUGE_VAL};
    sdf->high = vec3d_scale(sdf->low, -1);
    if (!isfinite(vec3d_max_abs(corners[0])) || !isfinite(vec3d_max_abs(corners[1]))) {
        sdf->low = sdf->high;
        sdf->high = vec3d_scale(sdf->low, -1);
        return;
    }
    for (int i = 0; i < 8; i++) {
        Vec3d corner = {corners[i & 1].x, corners[i >> 1 & 1].y, corners[i >> 2].z};
        corner = vec3d_add(matrix3x3_apply(t->matrix, corner), t->translate);
        sdf->low = vec3d_min(sdf->low, corner);
        sdf->high = vec3d_max(sdf->high, corner);
    }
}

/**
 * Rejects fields too small or too large for the engines' number types.
 * @return Whether the size is valid.
 */
static bool sdf_check_size(const Sdf *sdf, Error *error) {
    double max_coordinate = fmax(vec3d_max_abs(sdf->low), vec3d_max_abs(sdf->high));
    double edge = vec3d_max_abs(vec3d_subtract(sdf->high, sdf->low));
    return (edge >= LENGTH_MINIMUM && max_coordinate <= LENGTH_MAXIMUM) ||
           !isfinite(max_coordinate) ||
           error_set(error, STATUS_SCENE,
                     "the field becomes %g long and reaches %g from zero; it must be at least %g "
                     "and at most %g",
                     edge, max_coordinate, LENGTH_MINIMUM, LENGTH_MAXIMUM);
}

/** Sets the bounding box of the body of a #SDF_TRANSFORM node. */
static void node_set_bounds(SdfNode *node, Vec3d low, Vec3d high) {
    const double box[6] = {low.x, low.y, low.z, high.x, high.y, high.z};
    memcpy(node->operands + 13, box, sizeof box);
}

bool sdf_transform(Sdf *out, const Sdf *sdf, const Transform *t, Error *error) {
    // The inverse of s R is its transpose over s^2.
    double s = t->scale.x, per_square = 1 / (s * s);
    SdfNode node = {.op = SDF_TRANSFORM};
    for (int i = 0; i < 9; i++) {
        node.operands[i] = t->matrix[i % 3][i / 3] * per_square;
    }
    node.operands[9] = t->translate.x;
    node.operands[10] = t->translate.y;
    node.operands[11] = t->translate.z;
    node.operands[12] = s;
    node_set_bounds(&node, sdf->low, sdf->high);
    if (!sdf_wrap(out, &node, sdf, error)) {
        return false;
    }
    sdf_transform_bounds(out, t);
    return sdf_check_size(out, error);
}

/**
 * @return Whether a node combines the previous result with its body, both at the same point; its
 *         first operands are then the body's bounding box.
 */
static bool is_combination(SdfOp op) {
    return op == SDF_UNION || op == SDF_SMOOTH_UNION || op == SDF_INTERSECTION ||
           op == SDF_DIFFERENCE;
}

/** Adds an offset to three operands. */
static void operands_translate(double *operands, Vec3d offset) {
    operands[0] += offset.x;
    operands[1] += offset.y;
    operands[2] += offset.z;
}

/**
 * Appends a node as the body of a translation: for primitives, which are centred at zero.
 * @param out     The field.
 * @param node    The node, followed by its body.
 * @param offset  Translation, scene units.
 */
static void node_wrap_translation(Sdf *out, const SdfNode *node, Vec3d offset) {
    int size = 1 + node->body_count;
    out->nodes[out->node_count++] = (SdfNode){
        SDF_TRANSFORM, size, {1, 0, 0, 0, 1, 0, 0, 0, 1, offset.x, offset.y, offset.z, 1}};
    memcpy(out->nodes + out->node_count, node, (size_t)size * sizeof *node);
    out->node_count += size;
}

/** Appends translated nodes to a field. */
static void nodes_translate(Sdf *out, const SdfNode *nodes, int count, Vec3d offset) {
    for (const SdfNode *node = nodes; node < nodes + count; node += 1 + node->body_count) {
        SdfNode *copy = &out->nodes[out->node_count];
        if (node->op == SDF_TRANSFORM) {
            memcpy(copy, node, (size_t)(1 + node->body_count) * sizeof *node);
            operands_translate(copy->operands + 9, offset);
            out->node_count += 1 + node->body_count;
        } else if (is_combination(node->op)) {
            *copy = *node;
            operands_translate(copy->operands, offset);
            operands_translate(copy->operands + 3, offset);
            int first = ++out->node_count;
            nodes_translate(out, node + 1, node->body_count, offset);
            copy->body_count = out->node_count - first;
        } else if (node->op == SDF_ROUND) {
            out->nodes[out->node_count++] = *node;
        } else {
            node_wrap_translation(out, node, offset);
        }
    }
}

void sdf_translate(Sdf *out, const Sdf *sdf, Vec3d offset) {
    *out = *sdf;
    out->node_count = 0;
    out->depth = sdf->depth + 1;
    out->low = vec3d_add(sdf->low, offset);
    out->high = vec3d_add(sdf->high, offset);
    nodes_translate(out, sdf->nodes, sdf->node_count, offset);
    // Only a node that is the whole field needs its box, which is that of the field.
    bool has_transform = sdf->nodes[0].op == SDF_TRANSFORM;
    if (!has_transform && out->nodes[0].body_count == out->node_count - 1) {
        node_set_bounds(out->nodes, sdf->low, sdf->high);
    }
}

/** Expands a bounding box. */
static void sdf_expand_bounds(Sdf *sdf, double distance) {
    Vec3d outwards = {distance, distance, distance};
    sdf->low = vec3d_subtract(sdf->low, outwards);
    sdf->high = vec3d_add(sdf->high, outwards);
}

void sdf_round(Sdf *out, const Sdf *sdf, double radius) {
    memcpy(out, sdf, sdf_size(sdf->node_count));
    out->nodes[out->node_count++] = (SdfNode){SDF_ROUND, 0, {radius}};
    sdf_expand_bounds(out, radius * sdf->bound_slack);
}

/** Repetition of a field along one axis. */
typedef struct AxisRepetition {
    double period; /**< Distance of two copies; 0: not repeated. */
    double half; /**< 0.5 if the number of copies is even, so that the middle lies between two; else
                    0. */
    double limit;     /**< Index of the last copy, counted from the middle. */
    double neighbors; /**< Number of neighbouring cells to evaluate: 0, the nearer one (1), or both
                         (2). */
} AxisRepetition;

/**
 * Computes the repetition along one axis.
 * @param[out] axis    The repetition.
 * @param[in,out] low  Lower end of the field; afterwards that of all copies.
 * @param[in,out] high Upper end of the field; afterwards that of all copies.
 * @param period       Distance of two copies.
 * @param count        Number of copies; 0: infinite.
 * @param is_exact     Whether the field is exact: then the nearer neighbour suffices.
 * @param[out] error   What is wrong.
 * @return false if copies overlap more than their neighbours.
 */
static bool axis_repetition_init(AxisRepetition *axis, double *low, double *high, double period,
                                 double count, bool is_exact, Error *error) {
    *axis = (AxisRepetition){0};
    if (period == 0 || count == 1) {
        return true;
    }
    double max_coordinate = fmax(-*low, *high);
    if (max_coordinate > period) {
        return error_set(error, STATUS_SCENE,
                         "copies every %g overlap more than their neighbours: the field reaches %g "
                         "from zero",
                         period, max_coordinate);
    }
    axis->period = period;
    axis->half = count > 0 && fmod(count, 2) == 0 ? 0.5 : 0;
    axis->limit = count > 0 ? 0.5 * (count - 1) : HUGE_VAL;
    axis->neighbors = max_coordinate > 0.5 * period || !is_exact ? 2 : 1;
    *low -= axis->limit * period;
    *high += axis->limit * period;
    return true;
}

bool sdf_repeat(Sdf *out, const Sdf *sdf, const SdfRepetition *repeat, Error *error) {
    Sdf box = *sdf;
    AxisRepetition x, y, z;
    Vec3d p = repeat->period, n = repeat->count, low = sdf->low, high = sdf->high;
    if (n.x != floor(n.x) || n.y != floor(n.y) || n.z != floor(n.z)) {
        return error_set(error, STATUS_SCENE, "count must be whole numbers");
    }
    if (!axis_repetition_init(&x, &box.low.x, &box.high.x, p.x, n.x, sdf->is_exact, error) ||
        !axis_repetition_init(&y, &box.low.y, &box.high.y, p.y, n.y, sdf->is_exact, error) ||
        !axis_repetition_init(&z, &box.low.z, &box.high.z, p.z, n.z, sdf->is_exact, error)) {
        return false;
    }
    SdfNode node = {SDF_REPEAT,
                    0,
                    {x.period, y.period, z.period, x.half, y.half, z.half, x.limit, y.limit,
                     z.limit, x.neighbors, y.neighbors, z.neighbors, low.x, low.y, low.z, high.x,
                     high.y, high.z}};
    if (!sdf_wrap(out, &node, sdf, error)) {
        return false;
    }
    out->low = box.low;
    out->high = box.high;
    return true;
}

/** Node of each combination. */
static const SdfOp combination_ops[] = {[SDF_COMBINE_UNION] = SDF_UNION,
                                        [SDF_COMBINE_INTERSECTION] = SDF_INTERSECTION,
                                        [SDF_COMBINE_DIFFERENCE] = SDF_DIFFERENCE,
                                        [SDF_COMBINE_SMOOTH_UNION] = SDF_SMOOTH_UNION};

/**
 * Extends the properties of a union by one more field.
 * @param[in,out] out  The union so far.
 * @param next         The field.
 */
static void sdf_union_bounds(Sdf *out, const Sdf *next) {
    out->low = vec3d_min(out->low, next->low);
    out->high = vec3d_max(out->high, next->high);
    out->bound_slack = fmax(out->bound_slack, next->bound_slack);
}

/**
 * Reduces the properties of an intersection by one more field.
 * @param[in,out] out  The intersection so far.
 * @param next         The field.
 * @param[out] error   What is wrong.
 * @return false if the intersection is empty.
 */
static bool sdf_intersect_bounds(Sdf *out, const Sdf *next, Error *error) {
    Vec3d low = out->low = vec3d_max(out->low, next->low);
    Vec3d high = out->high = vec3d_min(out->high, next->high);
    // The distance to the common box is at most sqrt(3) times the larger of the two distances.
    out->bound_slack = fmax(out->bound_slack, next->bound_slack) * sqrt(3);
    return (low.x <= high.x && low.y <= high.y && low.z <= high.z) ||
           error_set(error, STATUS_SCENE, "the fields lie apart: there is nothing in all of them");
}

/** Combines a field with the result so far. @return false if the result is empty. */
static bool sdf_combine_one(Sdf *out, SdfCombination combination, const Sdf *next, double radius,
                            Error *error) {
    Vec3d low = next->low, high = next->high;
    SdfNode node = {
        combination_ops[combination], 0, {low.x, low.y, low.z, high.x, high.y, high.z, radius}};
    sdf_append(out, &node, next);
    out->depth = out->depth > next->depth ? out->depth : next->depth + 1;
    out->is_exact = combination == SDF_COMBINE_UNION && out->is_exact && next->is_exact;
    if (combination == SDF_COMBINE_INTERSECTION) {
        return sdf_intersect_bounds(out, next, error);
    }
    if (combination != SDF_COMBINE_DIFFERENCE) {
        sdf_union_bounds(out, next);
    }
    if (combination == SDF_COMBINE_SMOOTH_UNION) {
        // The seam is filled by at most a quarter of its radius.
        sdf_expand_bounds(out, 0.25 * radius * out->bound_slack);
    }
    return true;
}

/** @return Index of the deepest field. */
static int deepest_sdf(const Sdf *const *sdfs, int count) {
    int deepest = 0;
    for (int i = 1; i < count; i++) {
        deepest = sdfs[i]->depth > sdfs[deepest]->depth ? i : deepest;
    }
    return deepest;
}

bool sdf_combine(Sdf *out, SdfCombination combination, const Sdf *const *sdfs, int count,
                 double radius, Error *error) {
    if (sdf_combined_capacity(sdfs, count) > SDF_NODES_MAXIMUM) {
        return reject_node_count(error);
    }
    // The deepest field first: a chain of unions then does not become deeper.
    int first = combination == SDF_COMBINE_DIFFERENCE ? 0 : deepest_sdf(sdfs, count);
    memcpy(out, sdfs[first], sdf_size(sdfs[first]->node_count));
    bool is_joined = true;
    for (int i = 0; i < count && is_joined; i++) {
        is_joined = i == first || sdf_combine_one(out, combination, sdfs[i], radius, error);
    }
    return is_joined && (out->depth <= SDF_DEPTH_MAXIMUM ||
                         error_set(error, STATUS_SCENE, "fields stand in fields more than %d deep",
                                   SDF_DEPTH_MAXIMUM));
}
