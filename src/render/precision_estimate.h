/**
 * @file
 * @brief Estimate of the rounding errors of a picture from the numbers of its scene, before any ray
 *        is traced.
 *
 * Float has 24 bits. The error in the picture is half an ulp times what magnifies it: ratios of
 * lengths, and the divergence of rays on curved mirrors. The estimate is the largest of these
 * products, in 8-bit steps, for the worst ray of ten thousand. `dioptre needs` measures whether it
 * is right.
 */
#ifndef DIOPTRE_RENDER_PRECISION_ESTIMATE_H
#define DIOPTRE_RENDER_PRECISION_ESTIMATE_H

#include "dioptre/renderer.h"
#include "render/z_fighting/z_fighting.h"

/** Half an 8-bit step of the encoded picture: smaller errors are not visible. */
#define PRECISION_VISIBLE_ERROR 0.5

/** Fraction of the pixels that may be wrong. */
#define PRECISION_FRACTION_ALLOWED 1e-4

/** What magnifies rounding errors. */
typedef enum {
    PRECISION_DISTANCE,          /**< Distance of a shape relative to its size. */
    PRECISION_PIXEL_ANGLE,       /**< Narrow pixels: their angle against an ulp of a direction. */
    PRECISION_POSITION,          /**< Large coordinates against the size of a pixel in the scene. */
    PRECISION_RAY_DIVERGENCE,    /**< Curved mirrors and glass, which make rays diverge. */
    PRECISION_HORIZON,           /**< A texture on an infinite plane, dense at the horizon. */
    PRECISION_FRACTAL,           /**< A fractal, whose normals change within a tolerance. */
    PRECISION_THIN_GLASS,        /**< Walls of glass that are thin against their coordinates. */
    PRECISION_SHADOW_TERMINATOR, /**< Faces of smooth meshes at grazing angles to a light. */
    PRECISION_TRAPPED_LIGHT,     /**< Total reflections in glass with irregular paths. */
    PRECISION_Z_FIGHTING,        /**< Surfaces nearer together than float can tell. */
    PRECISION_CAUSE_COUNT        /**< Number of causes. */
} PrecisionCause;

/** An estimate. */
typedef struct PrecisionEstimate {
    double errors[PRECISION_CAUSE_COUNT]; /**< Error of float per cause, 8-bit steps. */
    PrecisionCause cause; /**< The cause to be named: that of the largest error, or thin glass
                               where its two sides would be named instead. */
    ZFighting z_fighting; /**< Surfaces that float, or nothing, can tell apart. */
    double max_distance_in_radii; /**< Largest distance of a shape, in its own radii; 0: no shape is
                                       bounded. */
    double pixel_angle;           /**< Angle of a pixel, radians. */
    double max_secondary_weight;  /**< Largest reflectance plus transmittance of a surface. */
    int bounces;                  /**< Number of bounces on curved surfaces that were counted. */
    int depth;             /**< Recursion depth beyond which no ray can change an 8-bit value. */
    int smooth_glass_line; /**< Line of the first transparent mesh with interpolated normals; 0:
                                there is none. A ray that is reflected by such a normal may leave
                                through the facet itself: then rounding decides, in every engine. */
} PrecisionEstimate;

/** @return The estimate for a scene. It takes the time of #z_fighting_of, and one in proportion to
 *          the number of shapes. */
PrecisionEstimate precision_estimate_of(const Scene *scene);

/** @return The largest error of float, 8-bit steps. */
double precision_estimate_error(const PrecisionEstimate *estimate);

/** @return #render_settings_default of a scene, from its estimate. */
RenderSettings precision_estimate_settings(const PrecisionEstimate *estimate, const Scene *scene);

/** @return The fastest engine that the processor supports and that is exact enough. */
const Engine *precision_estimate_engine(const PrecisionEstimate *estimate);

#endif
