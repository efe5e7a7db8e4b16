/**
 * @file
 * @brief Noting the rays of one pixel while they are followed: see dioptre/probe.h.
 *
 * The packet that is noted has one ray, in its first lane, and so have those that come of it.
 * Where nobody asks, a packet costs a few looks at a pointer.
 */
#ifndef DIOPTRE_TRACE_PROBE_H
#define DIOPTRE_TRACE_PROBE_H

#include "trace/crossing.h"
#include "trace/lamp.h"

/**
 * Notes a ray that is about to be followed, as a child of the current one. It is the current one
 * now.
 * @param[in,out] probe  The tree; the ray is the camera's where it is empty.
 * @param kind           What it is.
 * @param packet         The ray.
 * @param share          Of what it brings back, that goes to its parent.
 * @param weight         See #ProbeRay.weight.
 */
void probe_send(Probe *probe, ProbeKind kind, const Packet *packet, Light3 share, real weight);

/** Notes what the current ray has met. @param met The surface; its packet has a probe.
 *  @param departure How rays leave it. */
void probe_surface(const Encounter *met, const Departure *departure);

/** Notes what becomes of the current ray at glass. @param met The surface.
 *  @param crossing What becomes of it. */
void probe_crossing(const Encounter *met, const Crossing *crossing);

/**
 * Notes a shadow ray from the current ray's surface.
 * @param list    All shapes.
 * @param met     The surface.
 * @param lamp    Which lamp.
 * @param shine   What the lamp would give, with the ray.
 * @param blocked Whether it does not reach the point.
 * @param light   What it gives.
 */
void probe_shadow(const ShapeList *list, const Encounter *met, size_t lamp, const Shine *shine,
                  mask blocked, const Lighting *light);

/**
 * Notes what the body of the current ray's surface sends back.
 * @param met       The surface.
 * @param crossing  What becomes of the ray at glass; NULL: there is none.
 * @param paint     The picture's colour; NULL: it shows none.
 * @param color     What it sends back.
 */
void probe_body(const Encounter *met, const Crossing *crossing, const Light3 *paint, Light3 color);

/** Notes what the current ray has brought back; its parent is the current one now.
 *  @param probe The tree. @param color It. */
void probe_return(Probe *probe, Light3 color);

/**
 * Ends a tree: names the lamps that were met, and gives places in the scene.
 * @param probe   The tree.
 * @param origin  Where in the scene the tracer's coordinates begin.
 * @param lamps   The lamps.
 * @param count   How many.
 */
void probe_finish(Probe *probe, Vector3 origin, const Lamp *lamps, size_t count);

#endif
