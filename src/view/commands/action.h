/**
 * @file
 * @brief What a key can ask the window for.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_ACTION_H
#define DIOPTRE_VIEW_COMMANDS_ACTION_H

#include "dioptre/layer.h"

#include <stdbool.h>

/** What a key asks for. The moves come first: they last as long as their key is held. */
typedef enum Action {
    ACTION_LIGHT_RIGHT,         /**< The light to the right of the picture. */
    ACTION_LIGHT_LEFT,          /**< The light to the left. */
    ACTION_LIGHT_UP,            /**< The light up in the picture. */
    ACTION_LIGHT_DOWN,          /**< The light down. */
    ACTION_LIGHT_AWAY,          /**< The light away from the viewer. */
    ACTION_LIGHT_NEARER,        /**< The light towards the viewer. */
    ACTION_CAMERA_RIGHT,        /**< The camera to the right. */
    ACTION_CAMERA_LEFT,         /**< The camera to the left. */
    ACTION_CAMERA_UP,           /**< The camera up. */
    ACTION_CAMERA_DOWN,         /**< The camera down. */
    ACTION_CAMERA_FORWARD,      /**< The camera ahead. */
    ACTION_CAMERA_BACK,         /**< The camera back. */
    ACTION_SNAPSHOT,            /**< The picture on screen into a file. */
    ACTION_RESET_VIEW,          /**< Back to the scene's own view. */
    ACTION_NEXT_LIGHT,          /**< The light keys move the next light. */
    ACTION_TOGGLE_TIME,         /**< The time is held, or runs. */
    ACTION_TIME_BACK,           /**< The time a step back. */
    ACTION_TIME_FORWARD,        /**< The time a step on. */
    ACTION_TOGGLE_RAYS,         /**< The rays of one pixel, or the picture again. */
    ACTION_RAY_PREVIOUS,        /**< The numbers of the ray before. */
    ACTION_RAY_NEXT,            /**< The numbers of the next ray. */
    ACTION_COPY_VIEW,           /**< Camera and lights as text, to be pasted. */
    ACTION_TEXT_LARGER,         /**< Larger letters. */
    ACTION_TEXT_SMALLER,        /**< Smaller letters. */
    ACTION_LANGUAGE,            /**< The words are in the other language. */
    ACTION_BROWSE_SCENES,       /**< The list of scenes opens. */
    ACTION_RECORD,              /**< A lesson is recorded from now on, or that ends. */
    ACTION_CAPTION,             /**< Words for the lesson that is recorded. */
    ACTION_ENGINE_NEXT,         /**< The next number type. With Shift, as with those that follow: */
    ACTION_ENGINE_PREVIOUS,     /**< the one before. */
    ACTION_OFFSET_NEXT,         /**< The next offset strategy. */
    ACTION_OFFSET_PREVIOUS,     /**< The one before. */
    ACTION_EPSILON_HALF,        /**< Epsilon is half of what it was. */
    ACTION_EPSILON_TENTH,       /**< A tenth. */
    ACTION_EPSILON_TWICE,       /**< Twice. */
    ACTION_EPSILON_TEN_TIMES,   /**< Ten times. */
    ACTION_DEPTH_MORE,          /**< More mirrors in mirrors. */
    ACTION_DEPTH_LESS,          /**< Fewer. */
    ACTION_SAMPLES_TWICE,       /**< Twice the rays a pixel. */
    ACTION_SAMPLES_HALF,        /**< Half of them. */
    ACTION_LIGHT_MODE_NEXT,     /**< Another light. */
    ACTION_LIGHT_MODE_PREVIOUS, /**< The one before. */
    ACTION_SPLIT_NEXT,          /**< One picture, two side by side, their difference. */
    ACTION_SPLIT_PREVIOUS,      /**< The other way round. */
    ACTION_RESET_SETTINGS,      /**< All that was changed of this is taken back. */
    ACTION_TOGGLE_SETTINGS,     /**< It is said how the picture is drawn, or not. */
    ACTION_SWAP_SIDE,           /**< Keys change the other of two pictures. */
    ACTION_BAR_LEFT,            /**< The bar between them to the left. */
    ACTION_BAR_RIGHT,           /**< The bar to the right. */
    ACTION_LAYER_FIRST,         /**< The first of the layers: the light itself. */
    /** The last of the layers; between them are all others in their order. */
    ACTION_LAYER_LAST = ACTION_LAYER_FIRST + LAYER_COUNT - 1,
    ACTION_HELP,        /**< The help opens or closes. */
    ACTION_FULL_SCREEN, /**< The whole screen, or a window again. */
    ACTION_QUIT,        /**< The window closes. */
    ACTION_NONE         /**< Nothing: a key without a meaning. */
} Action;

/** How many of the actions are moves: those before #ACTION_SNAPSHOT. */
enum { ACTION_MOVE_COUNT = ACTION_SNAPSHOT };

/** @return Whether an action is a move. */
static inline bool action_is_move(Action action) {
    return action < ACTION_SNAPSHOT;
}

/** @return Whether an action changes how a picture is drawn. */
static inline bool action_is_setting_change(Action action) {
    return action >= ACTION_ENGINE_NEXT && action < ACTION_SPLIT_NEXT;
}

/** @return What a key asks for while Shift is held: of actions with two ways, the other one.
 *  @param action What it asks for without. */
static inline Action action_shifted(Action action) {
    bool has_two = action >= ACTION_ENGINE_NEXT && action < ACTION_RESET_SETTINGS;
    return has_two ? (Action)(action + 1) : action;
}

/** @return The names of all actions, in their order, ended by NULL: English, in lesson files. */
const char *const *action_names(void);

/** @return Whether a lesson remembers an action: what changes what is seen, but for the language,
 *  which is the viewer's own. */
bool action_is_recorded(Action action);

#endif
