/**
 * @file
 * @brief The inspector of an object: widgets for all fields of the selected shape or light, and of
 *        its material; or the list of all things, if none is selected.
 *
 * It follows the parameter tables, so a new class has its inspector for free. It changes nothing
 * itself: it requests edits, which #edits_handle_requests carries out.
 */
#ifndef DIOPTRE_VIEW_PANELS_OBJECT_INSPECTOR_H
#define DIOPTRE_VIEW_PANELS_OBJECT_INSPECTOR_H

#include "view/gui/gui.h"
#include "view/state/edit_history.h"

/** What the user requests besides an edit. */
typedef enum {
    INSPECTOR_NO_REQUEST, /**< Nothing. */
    INSPECTOR_CLOSE,      /**< To close it: nothing is selected any more. */
    INSPECTOR_UNDO,       /**< To undo. */
    INSPECTOR_REDO,       /**< To redo. */
    INSPECTOR_COPY,       /**< The object as text, to paste. */
    INSPECTOR_WRITE,      /**< To write its changes into the file. */
    INSPECTOR_RAYS,       /**< The rays of the pixel that was clicked. */
    INSPECTOR_THINGS,     /**< The list of all things. */
    INSPECTOR_CHOOSE      /**< #ObjectInspector.chosen. */
} InspectorRequest;

/** The inspector. Starts as `{0}`: nothing is selected. */
typedef struct ObjectInspector {
    int keyword;              /**< Keyword of the selected object, see #SceneOverride.keyword. */
    int number;               /**< Its number; 0: nothing is selected. */
    bool is_camera;           /**< Whether the camera is selected, if no object is. */
    bool lists;               /**< Whether all things are listed while none is selected. */
    bool has_chosen;          /**< Whether #chosen is known. */
    size_t chosen;            /**< What was chosen last in that list, see #thing_list_object. */
    size_t open_first;        /**< First of the things of one line that are unfolded there. */
    size_t open_end;          /**< Behind the last of them; 0: none is. */
    bool has_pixel;           /**< Whether it was selected by a click on a pixel. */
    bool is_by_mouse;         /**< Whether that was by the mouse, not by keys. */
    bool was_shown;           /**< Whether it was shown since it was selected. */
    bool is_continuing;       /**< Whether the next edit belongs to the one before. */
    bool has_edit;            /**< Whether the user requests #edit. */
    bool continues;           /**< Whether it belongs to the edit before. */
    SceneOverride edit;       /**< A field and its new value. */
    InspectorRequest request; /**< What else the user requests. */
} ObjectInspector;

/** What the inspector shows. */
typedef struct ObjectInspectorContent {
    const Scene *scene;         /**< The scene on screen. */
    const EditHistory *history; /**< Edits, perhaps newer than the scene. */
    bool is_light_moved;        /**< Whether the light was moved since: the scene has its place. */
    bool is_read_only;          /**< Whether a lesson plays. */
    bool can_undo;              /**< Whether a change can be taken back. */
    bool can_redo;              /**< Whether one can be done again. */
    GuiRect area;               /**< The part of the window for it, screen units. */
    SDL_Rect picture;           /**< Where the picture is, pixels of the window. */
    Uvd pixel;                  /**< What was clicked if #ObjectInspector.has_pixel, fractions of
                                     the picture. */
} ObjectInspectorContent;

/** @return Whether anything is selected, the camera too. */
bool object_inspector_has_thing(const ObjectInspector *inspector);

/** @return Whether the inspector is shown: with a thing, or with the list. */
bool object_inspector_is_open(const ObjectInspector *inspector);

/** Shows the inspector if it is open, and sets what the user requests. */
void object_inspector_show(ObjectInspector *inspector, const ObjectInspectorContent *content);

/** Outlines the selected object by the edges of its bounding box. @param picture The picture's
 *  rectangle, pixels of the window. */
void object_inspector_outline(const ObjectInspector *inspector, const Scene *scene,
                              const SDL_Rect *picture);

#endif
