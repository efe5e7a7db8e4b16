/**
 * @file
 * @brief Transformed shape: any shape, scaled, rotated and translated.
 */
#ifndef DIOPTRE_TRACE_SHAPES_TRANSFORMED_H
#define DIOPTRE_TRACE_SHAPES_TRANSFORMED_H

#include "trace/shapes/shape.h"

/** Parameters of a transformed shape. */
typedef struct TransformedParameters {
    const Transform *transform; /**< The transform. */
    const Shape *inner;         /**< The shape in its local space; it must live as long. */
} TransformedParameters;

/** The class. It has no keyword: any shape with a field `scale`, `rotate` or `translate` becomes
 * one. #ShapeClass.init takes #TransformedParameters. */
extern const ShapeClass transformed_class;

/** The class around shapes with their own BVH: #shape_has_bvh. */
extern const ShapeClass transformed_bvh_class;

/** The class around fields: #shape_has_steps. */
extern const ShapeClass transformed_field_class;

#endif
