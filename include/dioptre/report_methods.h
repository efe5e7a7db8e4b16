/**
 * @file
 * @brief The methods of the four reports (doc/reports.md), in place of the tracer's own: so that
 *        their errors can be seen.
 */
#ifndef DIOPTRE_REPORT_METHODS_H
#define DIOPTRE_REPORT_METHODS_H

/** Methods that a tracer can use in place of its own, as bits of #TraceSettings.methods. */
typedef enum {
    /** Report A: a sphere by the quadratic formula, every product by itself. */
    METHOD_SPHERE_QUADRATIC = 1 << 0,
    /** Report C: the same with the centre subtracted in b, but not in c. */
    METHOD_SPHERE_QUADRATIC_C = 1 << 1,
    /** Report D: a sphere by projection, in coordinates of the world; rays that look away from its
        centre do not meet it. Rows of its texture are equal in height, not in latitude. */
    METHOD_SPHERE_PROJECTION = 1 << 2,
    /** Report A: whatever a shadow ray meets throws a shadow, also behind the light. */
    METHOD_SHADOW_BEYOND = 1 << 3,
    /** Report D: a point is lit if the first shape that a ray from the light meets is its own. */
    METHOD_SHADOW_BY_SHAPE = 1 << 4,
    /** Report A: what secondary rays bring back weakens with the square of their length; what they
        do not meet is black. */
    METHOD_FADING_MIRRORS = 1 << 5,
    /** Report A: after the first surface a reflected ray is only reflected, and a refracted ray
        only refracted. */
    METHOD_SEPARATE_CHAINS = 1 << 6,
    /** Report A: a surface mirrors and transmits constant fractions, without Fresnel's formula. */
    METHOD_CONSTANT_SHARES = 1 << 7,
    /** Report C: ambient light only where no light arrives. */
    METHOD_AMBIENT_IN_SHADOW = 1 << 8,
    /** Report D: white light of 5 / (2 + distance), added to the colour of the surface. */
    METHOD_ADDED_LIGHT = 1 << 9,
    /** Report D: a pixel is the mean of the colours of its first four rays. */
    METHOD_MEAN_OF_RAYS = 1 << 10
} ReportMethod;

/** Whose methods a picture is traced with. */
typedef enum {
    METHODS_OWN,      /**< The tracer's own: the default. */
    METHODS_REPORT_A, /**< Those of report A. */
    METHODS_REPORT_B, /**< Those of report B. */
    METHODS_REPORT_C, /**< Those of report C. */
    METHODS_REPORT_D, /**< Those of report D. */
    METHODS_COUNT     /**< Number of sets. */
} MethodSet;

#endif
