/**
 * @file
 * @brief Where rays meet the triangles of a model.
 */
#ifndef DIOPTRE_TRACE_MODEL_POINT_H
#define DIOPTRE_TRACE_MODEL_POINT_H

#include "trace/model.h"

/**
 * @return Where rays meet the triangles that they met: the point of the ray, put back on the plane,
 *         with the triangle's own normal or the one between its corners'.
 * @param model     The model.
 * @param ray       The rays.
 * @param distance  How far away.
 * @param slots     Which triangles, by their places in the model's blocks.
 * @param met       The lanes that met any.
 * @param place     The shape's place in the scene.
 */
Hit model_hit(const Model *model, const Ray *ray, real distance, integer slots, mask met,
              int place);

#endif
