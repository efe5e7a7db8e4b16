/**
 * @file
 * @brief The shape classes there are.
 */
#ifndef DIOPTRE_TRACE_SHAPES_REGISTRY_H
#define DIOPTRE_TRACE_SHAPES_REGISTRY_H

#include "trace/shapes/shape.h"

extern const ShapeClass sphere_class;   /**< `sphere` */
extern const ShapeClass plane_class;    /**< `plane`: without end */
extern const ShapeClass quad_class;     /**< `quad`: a parallelogram */
extern const ShapeClass box_class;      /**< `box`: along the axes */
extern const ShapeClass disk_class;     /**< `disk`: the inside of a circle */
extern const ShapeClass cylinder_class; /**< `cylinder`: solid, or a pipe */
extern const ShapeClass triangle_class; /**< `triangle`: flat, or with a normal a corner */
extern const ShapeClass mesh_class;     /**< `mesh`: from a model file */
extern const ShapeClass sdf_class;      /**< `sdf`: a distance field */

#endif
