/**
 * @file
 * @brief Words and signs on the drawn keyboard.
 */
#include "view/panels/key_labels.h"

#include "base/language.h"

#include <libintl.h>

/** What actions do, in a word; where there is none, the help's words stand there. */
static const char *const action_labels[] = {[ACTION_LIGHT_RIGHT] = N_("right"),
                                            [ACTION_LIGHT_LEFT] = N_("left"),
                                            [ACTION_LIGHT_UP] = N_("up"),
                                            [ACTION_LIGHT_DOWN] = N_("down"),
                                            [ACTION_LIGHT_AWAY] = N_("away"),
                                            [ACTION_LIGHT_NEARER] = N_("near"),
                                            [ACTION_CAMERA_RIGHT] = N_("right"),
                                            [ACTION_CAMERA_LEFT] = N_("left"),
                                            [ACTION_CAMERA_UP] = N_("up"),
                                            [ACTION_CAMERA_DOWN] = N_("down"),
                                            [ACTION_CAMERA_FORWARD] = N_("forward"),
                                            [ACTION_CAMERA_BACK] = N_("back"),
                                            [ACTION_SNAPSHOT] = N_("photo"),
                                            [ACTION_RESET_VIEW] = N_("reset"),
                                            [ACTION_NEXT_LIGHT] = N_("next"),
                                            [ACTION_TOGGLE_TIME] = N_("run, hold"),
                                            [ACTION_TIME_BACK] = N_("back"),
                                            [ACTION_TIME_FORWARD] = N_("on"),
                                            [ACTION_COPY_VIEW] = N_("copy"),
                                            [ACTION_TEXT_LARGER] = "A +",
                                            [ACTION_TEXT_SMALLER] = "A −",
                                            [ACTION_LANGUAGE] = "en / fr",
                                            [ACTION_BROWSE_SCENES] = N_("scenes"),
                                            [ACTION_RECORD] = N_("record"),
                                            [ACTION_TOGGLE_RAYS] = N_("rays"),
                                            [ACTION_RAY_PREVIOUS] = N_("ray −"),
                                            [ACTION_RAY_NEXT] = N_("ray +"),
                                            [ACTION_CAPTION] = N_("words"),
                                            [ACTION_ENGINE_NEXT] = N_("engine"),
                                            [ACTION_OFFSET_NEXT] = N_("offset"),
                                            [ACTION_EPSILON_HALF] = "ε / 2",
                                            [ACTION_EPSILON_TWICE] = "ε × 2",
                                            [ACTION_DEPTH_MORE] = N_("depth"),
                                            [ACTION_SAMPLES_TWICE] = N_("samples"),
                                            [ACTION_LIGHT_MODE_NEXT] = N_("light"),
                                            [ACTION_SPLIT_NEXT] = N_("split"),
                                            [ACTION_SWAP_SIDE] = N_("side"),
                                            [ACTION_BAR_LEFT] = N_("bar ←"),
                                            [ACTION_BAR_RIGHT] = N_("bar →"),
                                            [ACTION_TOGGLE_SETTINGS] = N_("costs"),
                                            [ACTION_RESET_SETTINGS] = N_("as at first"),
                                            [ACTION_LAYER_FIRST + LAYER_SHADED] = N_("light"),
                                            [ACTION_LAYER_FIRST + LAYER_NORMALS] = N_("normals"),
                                            [ACTION_LAYER_FIRST + LAYER_DISTANCE] = N_("distance"),
                                            [ACTION_LAYER_FIRST + LAYER_SHAPES] = N_("shapes"),
                                            [ACTION_LAYER_FIRST + LAYER_UV] = "(u, v)",
                                            [ACTION_LAYER_FIRST + LAYER_RAYS] = N_("rays"),
                                            [ACTION_LAYER_FIRST + LAYER_STEPS] = N_("march"),
                                            [ACTION_LAYER_FIRST + LAYER_TIME] = N_("time"),
                                            [ACTION_LAYER_FIRST + LAYER_ERROR] = N_("error"),
                                            [ACTION_LAYER_FIRST + LAYER_ACNE] = N_("acne"),
                                            [ACTION_HELP] = N_("help"),
                                            [ACTION_FULL_SCREEN] = N_("screen"),
                                            [ACTION_QUIT] = N_("leave"),
                                            [ACTION_NONE] = NULL};

const char *key_action_label(SDL_Scancode scancode, const KeyInfo *info) {
    switch (scancode) {
    case SDL_SCANCODE_LSHIFT:
    case SDL_SCANCODE_RSHIFT:
        return gettext("fast");
    case SDL_SCANCODE_LCTRL:
    case SDL_SCANCODE_RCTRL:
        return gettext("fine");
    default:
        break;
    }
    if (info->action == ACTION_NONE) {
        return "";
    }
    return gettext(action_labels[info->action] ? action_labels[info->action] : info->help);
}

const char *key_cap_label(SDL_Scancode scancode) {
    static const struct {
        SDL_Scancode scancode;
        const char *label;
    } signs[] = {{SDL_SCANCODE_LSHIFT, "⇧"},      {SDL_SCANCODE_RSHIFT, "⇧"},
                 {SDL_SCANCODE_BACKSPACE, "⌫"},   {SDL_SCANCODE_RETURN, "↵"},
                 {SDL_SCANCODE_CAPSLOCK, "⇪"},    {SDL_SCANCODE_SPACE, N_("Space")},
                 {SDL_SCANCODE_TAB, N_("Tab")},   {SDL_SCANCODE_LCTRL, "Ctrl"},
                 {SDL_SCANCODE_RCTRL, "Ctrl"},    {SDL_SCANCODE_LALT, "Alt"},
                 {SDL_SCANCODE_RALT, "Alt"},      {SDL_SCANCODE_LGUI, ""},
                 {SDL_SCANCODE_RGUI, ""},         {SDL_SCANCODE_APPLICATION, ""},
                 {SDL_SCANCODE_LEFT, "←"},        {SDL_SCANCODE_RIGHT, "→"},
                 {SDL_SCANCODE_UP, "↑"},          {SDL_SCANCODE_DOWN, "↓"},
                 {SDL_SCANCODE_INSERT, ""},       {SDL_SCANCODE_DELETE, ""},
                 {SDL_SCANCODE_END, ""},          {SDL_SCANCODE_HOME, N_("Home")},
                 {SDL_SCANCODE_PAGEUP, "Page↑"},  {SDL_SCANCODE_PAGEDOWN, "Page↓"},
                 {SDL_SCANCODE_ESCAPE, N_("Esc")}};
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++) {
        if (signs[i].scancode == scancode) {
            return signs[i].label[0] ? gettext(signs[i].label) : "";
        }
    }
    return SDL_GetKeyName(SDL_GetKeyFromScancode(scancode));
}
