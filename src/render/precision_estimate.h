/**
 * @file
 * @brief A forecast: what can be said of a scene's errors from its numbers, before any ray is
 *        traced.
 *
 * Float has 24 bits. How far that is off in the picture is the product of its half ulp and of what
 * makes it grow: lengths against lengths, and turns of rays on curved mirrors. The forecast takes
 * the largest of these products, in 8-bit steps. It is meant for what one ray in ten thousand may
 * be off: `dioptre needs` looks whether that is true.
 */
#ifndef DIOPTRE_RENDER_PRECISION_ESTIMATE_H
#define DIOPTRE_RENDER_PRECISION_ESTIMATE_H

#include "dioptre/engine.h"

/** Half an 8-bit step of the encoded picture: what is off by less, nobody can tell. */
#define PRECISION_VISIBLE_ERROR 0.5

/** What makes roundings grow. */
typedef enum {
    PRECISION_DISTANCE,    /**< How far away things are, in their own sizes. */
    PRECISION_PIXEL_ANGLE, /**< How narrow a pixel is: its angle against an ulp of a direction. */
    PRECISION_POSITION,    /**< How large coordinates are against what a pixel shows of them. */
    PRECISION_RAY_DIVERGENCE, /**< Curved mirrors and glass: each makes rays go apart. */
    PRECISION_HORIZON,        /**< A picture on a plane without end: far away its texels crowd. */
    PRECISION_FRACTAL,        /**< A fractal: normals that turn within a tolerance. */
    PRECISION_THIN_GLASS,     /**< Walls of glass that are thin against their coordinates. */
    PRECISION_SHADOW_TERMINATOR, /**< Faces of models that lamps see from a little behind. */
    PRECISION_CAUSE_COUNT        /**< How many there are. */
} PrecisionCause;

/** What is forecast. */
typedef struct PrecisionEstimate {
    double errors[PRECISION_CAUSE_COUNT]; /**< Steps that float may be off by, for each cause. */
    PrecisionCause cause;                 /**< The one with most. */
    double max_distance_in_radii; /**< How far away the farthest thing is, in its own radii; 0:
                                     nothing ends. */
    double pixel_angle;           /**< Angle of a pixel, radians. */
    double max_secondary_weight;  /**< The largest share that a surface mirrors or lets through. */
    int bounces;                  /**< How many turns on curved surfaces were counted with. */
    int depth; /**< How deep rays must be followed until none can change 8 bits. */
} PrecisionEstimate;

/** Looks at a scene's numbers. Takes no time to speak of. @return The forecast. */
PrecisionEstimate precision_estimate_of(const Scene *scene);

/** @return Steps that float may be off by. */
static inline double precision_estimate_error(const PrecisionEstimate *estimate) {
    return estimate->errors[estimate->cause];
}

/** Finds the engine for a scene. @return The fastest that this machine can run and that is exact
 *  enough. */
const Engine *precision_estimate_engine(const PrecisionEstimate *estimate);

#endif
