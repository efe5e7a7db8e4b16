/**
 * @file
 * @brief The list of all things of a scene, in the inspector: camera, lights, shapes. Many things
 * that one line of the scene file has made share a row, which unfolds.
 */
#ifndef DIOPTRE_VIEW_PANELS_THING_LIST_H
#define DIOPTRE_VIEW_PANELS_THING_LIST_H

#include "view/panels/object_inspector.h"

/** Index of the camera in the list. */
enum { THING_CAMERA = 0 };

/** @return The number of things: the camera, the lights, the shapes. */
size_t thing_list_count(const Scene *scene);

/** @return A light or a shape. @param index Its index in the list, above #THING_CAMERA. */
SceneObject thing_list_object(const Scene *scene, size_t index);

/** Shows the list in the inspector, which has begun: only rows in sight are written. A row that is
 *  chosen is requested. */
void thing_list_show(ObjectInspector *inspector, const Scene *scene);

/** Shows the camera's values in the inspector, which has begun. */
void thing_list_show_camera(const Scene *scene);

#endif
