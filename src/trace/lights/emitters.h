/**
 * @file
 * @brief Emitters: visible lights.
 *
 * Camera, reflected and refracted rays meet them. Shadow rays never do, so no light hides another
 * or itself. They are not in the set of shapes and can move without a new BVH.
 */
#ifndef DIOPTRE_TRACE_LIGHTS_EMITTERS_H
#define DIOPTRE_TRACE_LIGHTS_EMITTERS_H

#include "trace/lights/light.h"

/** A light that is seen. */
typedef struct Emitter {
    const Light *light; /**< The light. */
    int light_index;    /**< Its index in the scene. */
    Shape *shape;       /**< As what it is seen. */
} Emitter;

/** The lights of a scene that are seen. */
typedef struct Emitters {
    Emitter *items; /**< Owned. */
    size_t count;   /**< Number of items. */
    char *memory;   /**< Their shapes; owned. */
    size_t stride;  /**< Bytes from one shape to the next. */
} Emitters;

/**
 * Allocates room for all lights of a scene.
 * @param[out] emitters  Empty; free it with #emitters_deinit.
 * @param scene  The scene.
 * @param error  What is wrong.
 * @return false without memory.
 */
bool emitters_init(Emitters *emitters, const Scene *scene, Error *error);

/** Frees emitters. */
void emitters_deinit(Emitters *emitters);

/**
 * Finds the lights that are seen, and where they are.
 * @param emitters  Emitters of the same scene, which may have been moved since.
 * @param scene   The scene.
 * @param lights  Its lights in the engine's number type.
 * @param light_count  Number of those: 0 if the tracer was created without the scene's lights.
 * @param origin  Origin of the tracer's coordinates, scene units.
 */
void emitters_set(Emitters *emitters, const Scene *scene, const Light *lights, size_t light_count,
                  Vec3d origin);

/** Finds the emitters that rays meet before any shape. In #Hit.shape they are negative numbers,
 *  below -1. @param[in,out] hits The nearest hits so far. */
void emitters_closest_hits(const Emitters *emitters, const Packet *packet, Hit *hits);

/** @return The index of the light that a #Hit.shape represents; -1: none. */
int emitter_light_index(int shape);

/** Sets the colours of rays that met emitters. @param lights The lights of the scene. @param packet
 *  The rays. */
void emitters_shade(const Light *lights, const Packet *packet, const Hit *hits, Rgb *colors);

#endif
