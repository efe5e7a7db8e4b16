/**
 * @file
 * @brief What a key can ask the window for.
 */
#ifndef DIOPTRE_VIEW_ACTION_H
#define DIOPTRE_VIEW_ACTION_H

#include <stdbool.h>

/** What a key asks for. The moves come first: they last as long as their key is held. */
typedef enum Action {
    ACTION_LIGHT_RIGHT,    /**< The light to the right of the picture. */
    ACTION_LIGHT_LEFT,     /**< The light to the left. */
    ACTION_LIGHT_UP,       /**< The light up in the picture. */
    ACTION_LIGHT_DOWN,     /**< The light down. */
    ACTION_LIGHT_AWAY,     /**< The light away from the viewer. */
    ACTION_LIGHT_NEARER,   /**< The light towards the viewer. */
    ACTION_CAMERA_RIGHT,   /**< The camera to the right. */
    ACTION_CAMERA_LEFT,    /**< The camera to the left. */
    ACTION_CAMERA_UP,      /**< The camera up. */
    ACTION_CAMERA_DOWN,    /**< The camera down. */
    ACTION_CAMERA_FORWARD, /**< The camera ahead. */
    ACTION_CAMERA_BACK,    /**< The camera back. */
    ACTION_SNAPSHOT,       /**< The picture on screen into a file. */
    ACTION_HOME,           /**< Back to the scene's own view. */
    ACTION_NEXT_LIGHT,     /**< The light keys move the next light. */
    ACTION_TIME,           /**< The time is held, or runs. */
    ACTION_TIME_BACK,      /**< The time a step back. */
    ACTION_TIME_ON,        /**< The time a step on. */
    ACTION_COPY,           /**< Camera and lights as text, to be pasted. */
    ACTION_TEXT_LARGER,    /**< Larger letters. */
    ACTION_TEXT_SMALLER,   /**< Smaller letters. */
    ACTION_LANGUAGE,       /**< The words are in the other language. */
    ACTION_RECORD,         /**< A lesson is recorded from now on, or that ends. */
    ACTION_CAPTION,        /**< Words for the lesson that is recorded. */
    ACTION_HELP,           /**< The help opens or closes. */
    ACTION_FULL_SCREEN,    /**< The whole screen, or a window again. */
    ACTION_LEAVE,          /**< The window closes. */
    ACTION_NONE            /**< Nothing: a key without a meaning. */
} Action;

/** How many of the actions are moves: those before #ACTION_SNAPSHOT. */
enum { ACTION_MOVE_COUNT = ACTION_SNAPSHOT };

/** @return Whether an action is a move. @param action The action. */
static inline bool action_is_move(Action action) {
    return action < ACTION_SNAPSHOT;
}

/** @return The names of all actions, in their order, ended by NULL: English, in lesson files. */
const char *const *action_names(void);

/** @return Whether a lesson remembers an action: what changes what is seen, but for the language,
 *          which is the viewer's own. @param action The action. */
bool action_is_taught(Action action);

#endif
