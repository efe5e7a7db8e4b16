/**
 * @file
 * @brief The bar at the upper edge: buttons, lists and sliders that issue commands.
 *
 * A widget never changes anything itself: it requests the command that its key would issue, so
 * lessons record and replay it like the key.
 */
#ifndef DIOPTRE_VIEW_PANELS_TOOLBAR_H
#define DIOPTRE_VIEW_PANELS_TOOLBAR_H

#include "view/gui/gui.h"
#include "view/panels/help.h"
#include "view/panels/ray_view.h"
#include "view/state/settings_override.h"
#include "view/window/split_view.h"

/** The bar. Starts as `{0}`: open. */
typedef struct Toolbar {
    bool is_folded;      /**< Whether only the button that unfolds it is shown. */
    float height;        /**< Its height in the last frame, pixels of the window. */
    float usual_height;  /**< The same, without rays; with them: before they were shown. */
    const char *command; /**< Name of the command that the user requests; NULL: none. */
    int repetitions;     /**< How many times it is to be issued. */
    bool continues;      /**< Whether it belongs to the change before: a slider is still held. */
    bool is_continuing;  /**< Whether the slider that is held has changed anything yet. */
} Toolbar;

/** What the bar shows. */
typedef struct ToolbarContent {
    const Help *help;               /**< Names the keys in tooltips. */
    const RenderSettings *settings; /**< The settings asked for in the active picture. */
    Layer layer;                    /**< Its layer. */
    SplitMode split;                /**< How many pictures are shown. */
    bool shows_settings;            /**< Whether settings and costs are shown. */
    RayView *rays;                  /**< The rays that are shown; NULL: none. */
    bool shows_chart;               /**< Whether the chart of settings is shown. */
    bool shows_magnifier;           /**< Whether pixels are magnified. */
    bool lists_things;              /**< Whether the things of the scene are listed. */
    bool is_animated;               /**< Whether the scene depends on time. */
    bool is_running;                /**< Whether its time runs. */
    bool is_recording;              /**< Whether a lesson is recorded. */
    bool is_playing;                /**< Whether a lesson plays. */
    bool shows_scenes;              /**< Whether the list of scenes is shown. */
    bool can_undo;                  /**< Whether a change can be taken back. */
    bool can_redo;                  /**< Whether one can be done again. */
} ToolbarContent;

/** Shows the bar, and sets #Toolbar.command if the user requests one. */
void toolbar_show(Toolbar *toolbar, const ToolbarContent *content);

/** @return The name of the command that shows a layer. */
const char *toolbar_layer_command(Layer layer);

#endif
