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
