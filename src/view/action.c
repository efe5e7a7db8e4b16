/**
 * @file
 * @brief What actions are called in lesson files.
 */
#include "view/action.h"

#include <assert.h>
#include <stddef.h>

/** The names. */
static const char *const names[] = {
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
    [ACTION_HOME] = "home",
    [ACTION_NEXT_LIGHT] = "next light",
    [ACTION_TIME] = "time",
    [ACTION_TIME_BACK] = "time back",
    [ACTION_TIME_ON] = "time on",
    [ACTION_RAYS] = "rays",
    [ACTION_RAY_BACK] = "ray back",
    [ACTION_RAY_ON] = "ray on",
    [ACTION_COPY] = "copy",
    [ACTION_TEXT_LARGER] = "text larger",
    [ACTION_TEXT_SMALLER] = "text smaller",
    [ACTION_LANGUAGE] = "language",
    [ACTION_SCENES] = "scenes",
    [ACTION_RECORD] = "record",
    [ACTION_CAPTION] = "caption",
    [ACTION_ENGINE] = "engine",
    [ACTION_ENGINE_BACK] = "engine back",
    [ACTION_OFFSET] = "offset",
    [ACTION_OFFSET_BACK] = "offset back",
    [ACTION_EPSILON_HALF] = "epsilon half",
    [ACTION_EPSILON_TENTH] = "epsilon tenth",
    [ACTION_EPSILON_TWICE] = "epsilon twice",
    [ACTION_EPSILON_TEN] = "epsilon ten times",
    [ACTION_DEPTH] = "deeper",
    [ACTION_DEPTH_BACK] = "less deep",
    [ACTION_SAMPLES] = "samples twice",
    [ACTION_SAMPLES_BACK] = "samples half",
    [ACTION_LIGHT_MODE] = "light mode",
    [ACTION_LIGHT_BACK] = "light mode back",
    [ACTION_SPLIT] = "split",
    [ACTION_SPLIT_BACK] = "split back",
    [ACTION_AS_ASKED] = "as at first",
    [ACTION_SETTINGS] = "settings",
    [ACTION_SIDE] = "other side",
    [ACTION_BAR_LEFT] = "bar left",
    [ACTION_BAR_RIGHT] = "bar right",
    [ACTION_LAYER + LAYER_SHADED] = "layer light",
    [ACTION_LAYER + LAYER_NORMALS] = "layer normals",
    [ACTION_LAYER + LAYER_DISTANCE] = "layer distance",
    [ACTION_LAYER + LAYER_SHAPES] = "layer shapes",
    [ACTION_LAYER + LAYER_PLACE] = "layer places",
    [ACTION_LAYER + LAYER_RAYS] = "layer rays",
    [ACTION_LAYER + LAYER_STEPS] = "layer steps",
    [ACTION_LAYER + LAYER_TIME] = "layer time",
    [ACTION_LAYER + LAYER_ERROR] = "layer error",
    [ACTION_LAYER + LAYER_ACNE] = "layer acne",
    [ACTION_HELP] = "help",
    [ACTION_FULL_SCREEN] = "full screen",
    [ACTION_LEAVE] = "leave",
    [ACTION_NONE] = NULL,
};

static_assert(sizeof names / sizeof *names == ACTION_NONE + 1, "every action has a name");

const char *const *action_names(void) {
    return names;
}

bool action_is_taught(Action action) {
    switch (action) {
    case ACTION_COPY:
    case ACTION_LANGUAGE:
    case ACTION_SCENES:
    case ACTION_RECORD:
    case ACTION_CAPTION:
    case ACTION_LEAVE:
    case ACTION_NONE:
        return false;
    default:
        return true;
    }
}
