/**
 * @file
 * @brief Spheres as the reports intersect them (dioptre/report_methods.h).
 */
#ifndef DIOPTRE_TRACE_SHAPES_REPORT_SPHERE_H
#define DIOPTRE_TRACE_SHAPES_REPORT_SPHERE_H

#include "dioptre/report_methods.h"
#include "trace/shapes/shape.h"

/**
 * @return The class that intersects a shape by the methods of a report.
 * @param own  The tracer's own class.
 * @param methods  A set of #ReportMethod.
 */
const ShapeClass *report_shape_class(const ShapeClass *own, unsigned methods);

#endif
