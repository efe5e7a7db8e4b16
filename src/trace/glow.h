/**
 * @file
 * @brief Lamps that are seen: glowing balls (row D4).
 *
 * They are met by rays that look, the camera's and those that come after them, and never by shadow
 * rays: a lamp is in no light's way. So they are not in the list of shapes, and can move without
 * it.
 */
#ifndef DIOPTRE_TRACE_GLOW_H
#define DIOPTRE_TRACE_GLOW_H

#include "trace/lamp.h"

/** The glowing balls of a scene. */
typedef struct Glow {
    Shape **balls;   /**< Spheres; owned, in one piece of memory. */
    Scalar3 *colors; /**< How bright each is; owned. */
    void *memory;    /**< What the balls lie in; owned. */
    size_t count;    /**< How many. */
} Glow;

/**
 * Makes room for the balls of a scene.
 * @param[out] glow   The balls, without place yet; give them back with #glow_release.
 * @param scene       The scene.
 * @param[out] error  What is wrong.
 * @return false without memory.
 */
bool glow_init(Glow *glow, const Scene *scene, Error *error);

/** Gives the balls back. @param glow The balls. */
void glow_release(Glow *glow);

/** Takes places, sizes and colours of the balls anew. @param glow The balls.
 *  @param scene The scene, with as many of them as before. @param origin Where in it the tracer's
 *  coordinates begin. */
void glow_look(Glow *glow, const Scene *scene, Vector3 origin);

/** Finds the balls that rays meet before anything else. Hits of them are no hits of a shape.
 *  @param glow The balls. @param packet The rays. @param[in,out] hits What they have met so far. */
void glow_nearest(const Glow *glow, const Packet *packet, Hit *hits);

/** @return Which ball it is that a hit names in the place of a shape; -1: none. @param shape It. */
int glow_ball(int shape);

/** Shows the balls to the rays that met them. @param glow The balls. @param hits What rays have
 *  met. @param[in,out] colors What they see. */
void glow_show(const Glow *glow, const Hit *hits, Light3 *colors);

#endif
