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
