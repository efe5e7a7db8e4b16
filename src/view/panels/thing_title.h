/**
 * @file
 * @brief The names of shapes, lights and materials: what they are, and where the scene makes them.
 */
#ifndef DIOPTRE_VIEW_PANELS_THING_TITLE_H
#define DIOPTRE_VIEW_PANELS_THING_TITLE_H

#include "dioptre/scene_override.h"

/** Bytes of a name with the final zero. */
enum { THING_TITLE_SIZE = 128 };

/** Names an object, such as `sphere (line 35 of the scene)`, in the user's language; with its
 *  number among those of its kind where its line makes several. */
void thing_title(const Scene *scene, const SceneObject *object, char title[THING_TITLE_SIZE]);

/** The same where there is little room, such as `sphere (line 35)`. */
void thing_short_title(const Scene *scene, const SceneObject *object, char title[THING_TITLE_SIZE]);

/** Names an object always with its number, such as `sphere 3 (line 35)`: for a list, in which no
 *  other row is looked at. */
void thing_row_title(const SceneObject *object, char title[THING_TITLE_SIZE]);

/** Names objects that one line of the scene file has made together: `▶ sphere × 120 (line 35)`.
 *  @param object One of them. @param is_open Whether each is named below, too. */
void thing_group_title(const SceneObject *object, size_t count, bool is_open,
                       char title[THING_TITLE_SIZE]);

/** Names a shape. See #thing_title. @param shape Its index. */
void shape_title(const Scene *scene, int shape, char title[THING_TITLE_SIZE]);

#endif
