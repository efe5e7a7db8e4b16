/**
 * @file
 * @brief What experiments pose their cases with.
 */
#include "lab/experiments/pose.h"

Quad3 rounded(const NumberType *type, Quad3 v) {
    return (Quad3){type->round(v.x), type->round(v.y), type->round(v.z)};
}

Quad3 write_vector(Writer *writer, Quad3 v) {
    Quad3 r = rounded(writer->type, v);
    *writer->next++ = r.x;
    *writer->next++ = r.y;
    *writer->next++ = r.z;
    return r;
}

Quadruple write_number(Writer *writer, Quadruple x) {
    return *writer->next++ = writer->type->round(x);
}

Quad3 place_far(double far) {
    // A direction of length 1 but for rounding, without a zero or two equal coordinates.
    Quad3 place = quad3_scale(quad3_normalize((Quad3){0.61, -0.47, 0.64}), far);
    return rounded(number_types()[0], place);
}

void to_numbers(Quad3 v, double numbers[3]) {
    numbers[0] = (double)v.x;
    numbers[1] = (double)v.y;
    numbers[2] = (double)v.z;
}

Quadruple sphere_truth(Quad3 origin, Quad3 direction, Quad3 center, Quadruple radius) {
    Quad3 f = quad3_subtract(origin, center);
    Quadruple a = quad3_dot(direction, direction), b = -quad3_dot(f, direction);
    Quad3 nearest = quad3_add(f, quad3_scale(direction, b / a));
    Quadruple discriminant = radius * radius - quad3_dot(nearest, nearest);
    if (discriminant < 0) {
        return QUAD_NONE;
    }
    Quadruple root = quad_sqrt(a * discriminant), c = quad3_dot(f, f) - radius * radius;
    Quadruple sum = b > 0 ? b + root : b - root;
    Quadruple near = b > 0 ? c / sum : sum / a, far = b > 0 ? sum / a : c / sum;
    return near > 0 ? near : far > 0 ? far : QUAD_NONE;
}

Scene *sphere_scene(Quad3 center, double radius, Error *error) {
    StageValue values[] = {{.name = "center"}, {.name = "radius", .numbers = {radius}}, {0}};
    to_numbers(center, values[0].numbers);
    return stage_with("sphere", values, error);
}

void engine_ask(const Engine *engine, const Tracer *tracer, const Quad3 ray[2], RayAnswer *answer) {
    RayQuery query = {{ray[0].x, ray[0].y, ray[0].z}, {ray[1].x, ray[1].y, ray[1].z}};
    engine->intersect(tracer, 1, &query, answer);
}

Quad3 quad3_of(const Quadruple numbers[3]) {
    return (Quad3){numbers[0], numbers[1], numbers[2]};
}

void judge_count(const Case *posed, const Quadruple *answers, Score *score) {
    (void)posed;
    score_outcome(score, OUTCOME_LEAK, answers[1] == 0);
    if (answers[1] != COUNT_UNKNOWN) {
        score_outcome(score, OUTCOME_DOUBLE_HIT, answers[1] > 1);
    }
}

void ask_count(const Engine *engine, Tracer *tracer, const Case *posed, Quadruple *answers) {
    RayAnswer answer;
    const Quad3 ray[2] = {quad3_of(posed->questions), quad3_of(posed->questions + 3)};
    engine_ask(engine, tracer, ray, &answer);
    answers[0] = answer.distance;
    answers[1] = answer.shape >= 0 ? COUNT_UNKNOWN : 0;
}

void judge_distance(const Case *posed, const Quadruple *answers, Score *score) {
    score_distance(score, answers[0], posed->truth[0]);
}
