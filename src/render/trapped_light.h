/**
 * @file
 * @brief Error of light that is totally reflected again and again in glass.
 *
 * A single ball, box or cylinder returns light on regular paths, whose errors grow with the number
 * of turns. In a cone, in most distance fields and models, where curved glass overlaps other glass,
 * and where it holds a bubble or a curved mirror, paths are chaotic: each turn multiplies the
 * distance between two rays. Total reflection takes no light from them. After some twenty turns a
 * rounding error of float is as large as a pixel.
 */
#ifndef DIOPTRE_RENDER_TRAPPED_LIGHT_H
#define DIOPTRE_RENDER_TRAPPED_LIGHT_H

#include "dioptre/scene.h"

/** A transparent or reflective shape. */
typedef struct GlassShape {
    Aabbd bounds;         /**< Its box; bounded. */
    bool is_flat;         /**< Whether its faces are flat. */
    size_t class_index;   /**< Its kind, #SceneShape.class_index. */
    double ior;           /**< Index of refraction. */
    double transmittance; /**< Largest channel of its transparency. */
    double reflectance;   /**< Largest channel of its reflectivity. */
    double ray_growth;    /**< #ShapeFacts.ray_growth */
} GlassShape;

/** The picture that shows the shapes. */
typedef struct GlassView {
    Vec3d position;     /**< The eye point. */
    double pixel_angle; /**< Angle of a pixel, radians. */
    double pixels;      /**< Number of pixels. */
    int depth;          /**< Recursion depth. */
} GlassView;

/**
 * @return The error of float in the picture, 8-bit steps: from half a step on, more than one pixel
 *         of ten thousand may be wrong.
 * @param shapes  The transparent shapes in the order of the scene.
 */
double trapped_light_error(const GlassShape *shapes, size_t count, const GlassView *view);

/**
 * @return The same of light between glass and curved mirrors in it.
 * @param shapes   The transparent shapes.
 * @param mirrors  Curved reflective shapes that are not transparent.
 */
double mirrored_light_error(const GlassShape *shapes, size_t count, const GlassShape *mirrors,
                            size_t mirror_count, const GlassView *view);

#endif
