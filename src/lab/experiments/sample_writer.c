/**
 * @file
 * @brief What several experiments need to generate and score samples.
 */
#include "lab/experiments/sample_writer.h"

Vec3q vec3q_round(const NumberType *type, Vec3q v) {
    return (Vec3q){type->round(v.x), type->round(v.y), type->round(v.z)};
}

Vec3q sample_writer_vec3(SampleWriter *writer, Vec3q v) {
    Vec3q r = vec3q_round(writer->type, v);
    *writer->next++ = r.x;
    *writer->next++ = r.y;
    *writer->next++ = r.z;
    return r;
}

Quadruple sample_writer_number(SampleWriter *writer, Quadruple x) {
    return *writer->next++ = writer->type->round(x);
}

/** @return A vector with its axes rotated cyclically. @param axis 0, 1 or 2: becomes z. */
static Vec3q permute_axes(Vec3q v, int axis) {
    return axis == 0 ? (Vec3q){v.y, v.z, v.x} : axis == 1 ? (Vec3q){v.z, v.x, v.y} : v;
}

void sample_writer_triangle(SampleWriter *writer, const Vec3q corners[3]) {
    Vec3q rounded[3];
    for (int i = 0; i < 3; i++) {
        rounded[i] = sample_writer_vec3(writer, corners[i]);
    }
    Vec3q e1 = vec3q_subtract(rounded[1], rounded[0]), e2 = vec3q_subtract(rounded[2], rounded[0]);
    Vec3q n = vec3q_cross(e1, e2);
    Quadruple x = quad_abs(n.x), y = quad_abs(n.y), z = quad_abs(n.z);
    int axis = x > y && x > z ? 0 : y > z ? 1 : 2;
    Vec3q a = permute_axes(rounded[0], axis), normal = permute_axes(n, axis);
    e1 = permute_axes(e1, axis);
    e2 = permute_axes(e2, axis);
    // Across the fixed axis the triangle is one of two dimensions, with twice the area normal.z.
    Quadruple area = normal.z == 0 ? 1 : normal.z; // A triangle without area: any numbers.
    const Quadruple rows[9] = {e2.y / area,     -e2.x / area,    (e2.x * a.y - e2.y * a.x) / area,
                               -e1.y / area,    e1.x / area,     (e1.y * a.x - e1.x * a.y) / area,
                               normal.x / area, normal.y / area, -vec3q_dot(normal, a) / area};
    for (int i = 0; i < 9; i++) {
        sample_writer_number(writer, rows[i]);
    }
    sample_writer_number(writer, axis);
}

Vec3q far_point(double distance) {
    // A direction of length 1 but for rounding, without a zero or two equal coordinates.
    Vec3q position = vec3q_scale(vec3q_normalize((Vec3q){0.61, -0.47, 0.64}), distance);
    return vec3q_round(number_types()[0], position);
}

Vec3q far_whole_point(double distance) {
    Vec3q point = far_point(distance);
    return (Vec3q){(int)point.x, (int)point.y, (int)point.z};
}

void vec3q_to_doubles(Vec3q v, double numbers[3]) {
    numbers[0] = (double)v.x;
    numbers[1] = (double)v.y;
    numbers[2] = (double)v.z;
}

Quadruple sphere_expected(Vec3q origin, Vec3q direction, Vec3q center, Quadruple radius) {
    Vec3q f = vec3q_subtract(origin, center);
    Quadruple a = vec3q_dot(direction, direction), b = -vec3q_dot(f, direction);
    Vec3q nearest = vec3q_add(f, vec3q_scale(direction, b / a));
    Quadruple discriminant = radius * radius - vec3q_dot(nearest, nearest);
    if (discriminant < 0) {
        return QUAD_NO_HIT;
    }
    Quadruple root = quad_sqrt(a * discriminant), c = vec3q_dot(f, f) - radius * radius;
    Quadruple sum = b > 0 ? b + root : b - root;
    Quadruple near = b > 0 ? c / sum : sum / a, far = b > 0 ? sum / a : c / sum;
    return near > 0 ? near : far > 0 ? far : QUAD_NO_HIT;
}

Scene *sphere_scene(Vec3q center, double radius, Error *error) {
    FixtureValue values[] = {{.name = "center"}, {.name = "radius", .components = {radius}}, {0}};
    vec3q_to_doubles(center, values[0].components);
    return scene_fixture_with_shape("sphere", values, error);
}

Scene *create_far_sphere_scene(const ExperimentSetup *setup, Error *error) {
    return sphere_scene(far_point(setup->level), 1, error);
}

void intersect_ray(const Engine *engine, const Tracer *tracer, const Vec3q ray[2],
                   RayResult *answer) {
    RayQueryQuad query = {{ray[0].x, ray[0].y, ray[0].z}, {ray[1].x, ray[1].y, ray[1].z}};
    engine->intersect(tracer, 1, &query, answer);
}

Vec3q vec3q_from_array(const Quadruple numbers[3]) {
    return (Vec3q){numbers[0], numbers[1], numbers[2]};
}

void score_hit_count(const ExperimentSample *sample, const Quadruple *outputs, ScoreStats *score) {
    (void)sample;
    score_outcome(score, OUTCOME_LEAK, outputs[1] == 0);
    if (outputs[1] != COUNT_UNKNOWN) {
        score_outcome(score, OUTCOME_DOUBLE_HIT, outputs[1] > 1);
    }
}

void query_hit_count(const Engine *engine, Tracer *tracer, const ExperimentSample *sample,
                     Quadruple *outputs) {
    RayResult answer;
    const Vec3q ray[2] = {vec3q_from_array(sample->inputs), vec3q_from_array(sample->inputs + 3)};
    intersect_ray(engine, tracer, ray, &answer);
    outputs[0] = answer.distance;
    outputs[1] = answer.shape >= 0 ? COUNT_UNKNOWN : 0;
}

void score_expected_distance(const ExperimentSample *sample, const Quadruple *outputs,
                             ScoreStats *score) {
    score_distance(score, outputs[0], sample->expected[0]);
}

void score_absolute_error(const ExperimentSample *sample, const Quadruple *outputs,
                          ScoreStats *score) {
    bool is_number = quad_is_number(outputs[0]);
    score_outcome(score, OUTCOME_NAN, !is_number);
    if (is_number) {
        score_error(score, quad_abs(outputs[0] - sample->expected[0]));
    }
}
