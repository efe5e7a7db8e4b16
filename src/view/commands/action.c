/**
 * @file
 * @brief What actions are called in lesson files.
 */
#include "view/commands/action.h"

#include <assert.h>
#include <stddef.h>

/** The names. */
static const char *const action_name_table[] = {
    [ACTION_LIGHT_RIGHT] = "light right",
    [ACTION_LIGHT_LEFT] = "light left",
    [ACTION_LIGHT_UP] = "light up",
    [ACTION_LIGHT_DOWN] = "light down",
    [ACTION_LIGHT_AWAY] = "light away",
    [ACTION_LIGHT_NEARER] = "light nearer",
    [ACTION_CAMERA_RIGHT] = "camera right",
    [ACTION_CAMERA_LEFT] = "camera left",
    [ACTION_CAMERA_UP] = "camera up",
    [ACTION_CAMERA_DOWN] = "camera down",
    [ACTION_CAMERA_FORWARD] = "camera forward",
    [ACTION_CAMERA_BACK] = "camera back",
    [ACTION_SNAPSHOT] = "snapshot",
    [ACTION_RESET_VIEW] = "home",
    [ACTION_NEXT_LIGHT] = "next light",
    [ACTION_TOGGLE_TIME] = "time",
    [ACTION_TIME_BACK] = "time back",
    [ACTION_TIME_FORWARD] = "time on",
    [ACTION_TOGGLE_RAYS] = "rays",
    [ACTION_RAY_PREVIOUS] = "ray back",
    [ACTION_RAY_NEXT] = "ray on",
    [ACTION_COPY_VIEW] = "copy",
    [ACTION_TEXT_LARGER] = "text larger",
    [ACTION_TEXT_SMALLER] = "text smaller",
    [ACTION_LANGUAGE] = "language",
    [ACTION_BROWSE_SCENES] = "scenes",
    [ACTION_RECORD] = "record",
    [ACTION_CAPTION] = "caption",
    [ACTION_ENGINE_NEXT] = "engine",
    [ACTION_ENGINE_PREVIOUS] = "engine back",
    [ACTION_OFFSET_NEXT] = "offset",
    [ACTION_OFFSET_PREVIOUS] = "offset back",
    [ACTION_EPSILON_HALF] = "epsilon half",
    [ACTION_EPSILON_TENTH] = "epsilon tenth",
    [ACTION_EPSILON_TWICE] = "epsilon twice",
    [ACTION_EPSILON_TEN_TIMES] = "epsilon ten times",
    [ACTION_DEPTH_MORE] = "deeper",
    [ACTION_DEPTH_LESS] = "less deep",
    [ACTION_SAMPLES_TWICE] = "samples twice",
    [ACTION_SAMPLES_HALF] = "samples half",
    [ACTION_LIGHT_MODE_NEXT] = "light mode",
    [ACTION_LIGHT_MODE_PREVIOUS] = "light mode back",
    [ACTION_SPLIT_NEXT] = "split",
    [ACTION_SPLIT_PREVIOUS] = "split back",
    [ACTION_RESET_SETTINGS] = "as at first",
    [ACTION_TOGGLE_SETTINGS] = "settings",
    [ACTION_SWAP_SIDE] = "other side",
    [ACTION_BAR_LEFT] = "bar left",
    [ACTION_BAR_RIGHT] = "bar right",
    [ACTION_LAYER_FIRST + LAYER_SHADED] = "layer light",
    [ACTION_LAYER_FIRST + LAYER_NORMALS] = "layer normals",
    [ACTION_LAYER_FIRST + LAYER_DISTANCE] = "layer distance",
    [ACTION_LAYER_FIRST + LAYER_SHAPES] = "layer shapes",
    [ACTION_LAYER_FIRST + LAYER_UV] = "layer places",
    [ACTION_LAYER_FIRST + LAYER_RAYS] = "layer rays",
    [ACTION_LAYER_FIRST + LAYER_STEPS] = "layer steps",
    [ACTION_LAYER_FIRST + LAYER_TIME] = "layer time",
    [ACTION_LAYER_FIRST + LAYER_ERROR] = "layer error",
    [ACTION_LAYER_FIRST + LAYER_ACNE] = "layer acne",
    [ACTION_HELP] = "help",
    [ACTION_FULL_SCREEN] = "full screen",
    [ACTION_QUIT] = "leave",
    [ACTION_NONE] = NULL,
};

static_assert(sizeof action_name_table / sizeof *action_name_table == ACTION_NONE + 1,
              "every action has a name");

const char *const *action_names(void) {
    return action_name_table;
}

bool action_is_recorded(Action action) {
    switch (action) {
    case ACTION_COPY_VIEW:
    case ACTION_LANGUAGE:
    case ACTION_BROWSE_SCENES:
    case ACTION_RECORD:
    case ACTION_CAPTION:
    case ACTION_QUIT:
    case ACTION_NONE:
        return false;
    default:
        return true;
    }
}
