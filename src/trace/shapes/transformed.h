/**
 * @file
 * @brief Any shape, stretched, turned and moved.
 */
#ifndef DIOPTRE_TRACE_SHAPES_TRANSFORMED_H
#define DIOPTRE_TRACE_SHAPES_TRANSFORMED_H

#include "trace/shapes/shape.h"

/** What a transformed shape is made of. */
typedef struct TransformedParameters {
    const Transform *transform; /**< How it is stretched, turned and moved. */
    const Shape *inner;         /**< The shape before that; it must live as long. */
} TransformedParameters;

/** The class; it has no keyword, because the fields `scale`, `rotate` and `translate` of any shape
 *  ask for it. #ShapeClass.init takes #TransformedParameters. */
extern const ShapeClass transformed_class;

/** The same, around shapes that take whole packets of rays. */
extern const ShapeClass transformed_packet_class;

#endif
