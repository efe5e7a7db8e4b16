/**
 * @file
 * @brief Samples of a line segment, denser where a light near the line is stronger.
 *
 * A point at the distance a from a line gets from the line's point at the position s, counted from
 * the point's foot, light that decreases like 1 / (a^2 + s^2) or faster. The densities here have
 * algebraic integrals, so that samples need no function of libm and are the same bits in all
 * engines of a number type.
 */
#ifndef DIOPTRE_TRACE_LIGHTS_SEGMENT_SAMPLE_H
#define DIOPTRE_TRACE_LIGHTS_SEGMENT_SAMPLE_H

#include "trace/math/vec3.h"

/** One sample of LANES segments. */
typedef struct SegmentSample {
    real at;      /**< Position on the line, from begin to begin + length. */
    real density; /**< Probability per length there, above 0. */
} SegmentSample;

/** LANES segments of lines, as points beside the lines see them. */
typedef struct Segment {
    real begin;  /**< Position of the first end, counted from the point's foot. */
    real length; /**< From the first to the last end, above 0. */
    real scale;  /**< Distance of the point from the line; larger where the foot lies outside. */
    mask is_far; /**< The segments so far away that uniform samples are as good and more exact. */
} Segment;

/** @return Segments. @param distance Of the points from the lines. */
INLINE Segment segment_of(real begin, real length, real distance) {
    /** How many times farther than long a segment is that counts as far. */
    const scalar far_lengths = 4;
    real end = begin + length, zero = real_of(0);
    // Both ends on one side of the foot: the density is flat up to the nearer end.
    real gap = real_max(real_max(begin, -end), zero);
    real scale = real_max(real_max(distance, gap), real_of((scalar)LENGTH_MINIMUM));
    return (Segment){begin, length, scale, scale > length * far_lengths};
}

/** @return Samples of uniform density. @param unit From 0 to 1. */
INLINE SegmentSample segment_sample_uniform(const Segment *segment, real unit) {
    return (SegmentSample){segment->begin + unit * segment->length, 1 / segment->length};
}

/** @return A sample, or a uniform one of far segments. */
INLINE SegmentSample segment_sample_select(const Segment *segment, real unit, real at,
                                           real density) {
    SegmentSample uniform = segment_sample_uniform(segment, unit);
    at = real_min(real_max(at, segment->begin), segment->begin + segment->length);
    return (SegmentSample){real_select(segment->is_far, uniform.at, at),
                           real_select(segment->is_far, uniform.density, density)};
}

/** @return Samples of the density c / (scale + |s|)^2. @param unit From 0 to 1. */
INLINE SegmentSample segment_sample_inverse_square(const Segment *segment, real unit) {
    real scale = segment->scale, begin = segment->begin, end = begin + segment->length;
    // The integral is s / (scale + |s|).
    real first = begin / (scale + real_abs(begin)), last = end / (scale + real_abs(end));
    real integral = first + unit * (last - first);
    real at = scale * integral / (1 - real_abs(integral));
    at = real_min(real_max(at, begin), end);
    real reach = scale + real_abs(at);
    return segment_sample_select(segment, unit, at, scale / reach / reach / (last - first));
}

/** @return Samples of the density c / (scale^2 + s^2)^(3/2). @param unit From 0 to 1. */
INLINE SegmentSample segment_sample_inverse_cube(const Segment *segment, real unit) {
    real scale = segment->scale, begin = segment->begin, end = begin + segment->length;
    real square = scale * scale;
    // The integral is s / sqrt(scale^2 + s^2).
    real first = begin / real_sqrt(square + begin * begin);
    real last = end / real_sqrt(square + end * end);
    real integral = first + unit * (last - first);
    real at = scale * integral / real_sqrt((1 - integral) * (1 + integral));
    at = real_min(real_max(at, begin), end);
    real reach = real_sqrt(square + at * at), ratio = scale / reach;
    return segment_sample_select(segment, unit, at, ratio * ratio / reach / (last - first));
}

#endif
