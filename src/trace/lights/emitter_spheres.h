/**
 * @file
 * @brief Lamps that are seen: glowing balls (row D4).
 *
 * They are met by rays that look, the camera's and those that come after them, and never by shadow
 * rays: a lamp is in no light's way. So they are not in the list of shapes, and can move without
 * it.
 */
#ifndef DIOPTRE_TRACE_LIGHTS_EMITTER_SPHERES_H
#define DIOPTRE_TRACE_LIGHTS_EMITTER_SPHERES_H

#include "trace/lights/light.h"

/** The glowing balls of a scene. */
typedef struct EmitterSpheres {
    Shape **spheres; /**< Spheres; owned, in one piece of memory. */
    Rgbs *colors;    /**< How bright each is; owned. */
    void *memory;    /**< What the balls lie in; owned. */
    size_t count;    /**< How many. */
} EmitterSpheres;

/**
 * Makes room for the balls of a scene.
 * @param[out] emitters  The balls, without place yet; give them back with #emitter_spheres_deinit.
 * @return false without memory.
 */
bool emitter_spheres_init(EmitterSpheres *emitters, const Scene *scene, Error *error);

/** Gives the balls back. */
void emitter_spheres_deinit(EmitterSpheres *emitters);

/**
 * Takes places, sizes and colours of the balls anew.
 * @param scene  The scene, with as many of them as before.
 * @param origin  Where in it the tracer's coordinates begin.
 */
void emitter_spheres_set(EmitterSpheres *emitters, const Scene *scene, Vec3d origin);

/** Finds the balls that rays meet before anything else. Hits of them are no hits of a shape.
 *  @param[in,out] hits What they have met so far. */
void emitter_spheres_closest_hits(const EmitterSpheres *emitters, const Packet *packet, Hit *hits);

/** @return Which ball it is that a hit names in the place of a shape; -1: none. */
int emitter_sphere_index(int shape);

/** Shows the balls to the rays that met them. */
void emitter_spheres_shade(const EmitterSpheres *emitters, const Hit *hits, Rgb *colors);

#endif
