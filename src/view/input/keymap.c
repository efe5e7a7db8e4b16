/**
 * @file
 * @brief Which key asks for what.
 *
 * The light's keys stand at fixed places: those of the letters z s q d e w on an AZERTY keyboard,
 * wherever the letters are on the keyboard in use; so do the two that step the time, right of M or
 * N, which on an AZERTY keyboard are ; and :. SDL names places by the US keyboard. All other
 * keys go by what is printed on them.
 */
#include "view/input/keymap.h"

#include "base/language.h"

#include <libintl.h>
#include <string.h>

/** One key, or one other thing that the help tells of. */
typedef struct KeyBinding {
    Action action;         /**< What it asks for. */
    SDL_Scancode scancode; /**< Its place, where it goes by that; otherwise 0, SDL's "unknown". */
    SDL_Keycode keycode; /**< Its letter or name; 0 with a place: it always goes by that; 0 without:
                             not a key, only a row of the help. */
    const char *label;   /**< What to call it in the help, in English; NULL: as SDL does; empty: not
                            at  all. */
    const char *group;   /**< The help's heading that it stands under. */
    const char *help;    /**< What it does. Neighbours with the same words share a row. */
} KeyBinding;

/** Heading of the help: the lights. */
static const char GROUP_LIGHT[] = N_("Light");
/** Heading of the help: the camera. */
static const char GROUP_CAMERA[] = N_("Camera");
/** Heading of the help: the time. */
static const char GROUP_TIME[] = N_("Time");
/** Heading of the help: what is shown, and how it is drawn. */
static const char GROUP_PICTURE[] = N_("Picture");
/** Heading of the help: the rays of one pixel. */
static const char GROUP_RAYS[] = N_("Rays of one pixel");
/** Heading of the help: everything else. */
static const char GROUP_PROGRAM[] = N_("Program");

/** What the first keys of layers do. */
#define FIRST_LAYERS_HELP N_("light, normals, distance, shapes, (u, v)")
/** What the other keys of layers do. */
#define LAST_LAYERS_HELP N_("rays, marching, time, error, acne")
/** What the keys of epsilon do. */
#define EPSILON_HELP N_("epsilon half, twice (Shift: 1/10, 10 times)")
/** The key of a layer. */
#define LAYER_KEY(layer) (Action)(ACTION_LAYER_FIRST + LAYER_##layer)

/** All keys, in the help's order. */
static const KeyBinding bindings[] = {
    {ACTION_LIGHT_UP, SDL_SCANCODE_W, SDLK_z, NULL, GROUP_LIGHT, N_("up, down")},
    {ACTION_LIGHT_DOWN, SDL_SCANCODE_S, SDLK_s, NULL, GROUP_LIGHT, N_("up, down")},
    {ACTION_LIGHT_LEFT, SDL_SCANCODE_A, SDLK_q, NULL, GROUP_LIGHT, N_("left, right")},
    {ACTION_LIGHT_RIGHT, SDL_SCANCODE_D, SDLK_d, NULL, GROUP_LIGHT, N_("left, right")},
    {ACTION_LIGHT_AWAY, SDL_SCANCODE_E, SDLK_e, NULL, GROUP_LIGHT, N_("away from you, nearer")},
    {ACTION_LIGHT_NEARER, SDL_SCANCODE_Z, SDLK_w, NULL, GROUP_LIGHT, N_("away from you, nearer")},
    {ACTION_NEXT_LIGHT, 0, SDLK_TAB, N_("Tab"), GROUP_LIGHT, N_("next light")},
    {ACTION_CAMERA_UP, 0, SDLK_UP, "↑", GROUP_CAMERA, N_("up, down")},
    {ACTION_CAMERA_DOWN, 0, SDLK_DOWN, "↓", GROUP_CAMERA, N_("up, down")},
    {ACTION_CAMERA_LEFT, 0, SDLK_LEFT, "←", GROUP_CAMERA, N_("left, right")},
    {ACTION_CAMERA_RIGHT, 0, SDLK_RIGHT, "→", GROUP_CAMERA, N_("left, right")},
    {ACTION_CAMERA_FORWARD, 0, SDLK_PAGEUP, N_("Page Up"), GROUP_CAMERA, N_("forward, back")},
    {ACTION_CAMERA_BACK, 0, SDLK_PAGEDOWN, N_("Page Down"), GROUP_CAMERA, N_("forward, back")},
    {ACTION_NONE, 0, 0, N_("Mouse drag"), GROUP_CAMERA, N_("look around")},
    {ACTION_NONE, 0, 0, N_("Wheel"), GROUP_CAMERA, N_("field of view")},
    {ACTION_TOGGLE_TIME, 0, SDLK_SPACE, N_("Space"), GROUP_TIME, N_("run, hold")},
    {ACTION_TIME_BACK, SDL_SCANCODE_COMMA, SDLK_COMMA, NULL, GROUP_TIME, N_("a step back, on")},
    {ACTION_TIME_FORWARD, SDL_SCANCODE_PERIOD, SDLK_PERIOD, NULL, GROUP_TIME,
     N_("a step back, on")},
    {LAYER_KEY(SHADED), SDL_SCANCODE_1, 0, "1", GROUP_PICTURE, FIRST_LAYERS_HELP},
    {LAYER_KEY(NORMALS), SDL_SCANCODE_2, 0, "2", GROUP_PICTURE, FIRST_LAYERS_HELP},
    {LAYER_KEY(DISTANCE), SDL_SCANCODE_3, 0, "3", GROUP_PICTURE, FIRST_LAYERS_HELP},
    {LAYER_KEY(SHAPES), SDL_SCANCODE_4, 0, "4", GROUP_PICTURE, FIRST_LAYERS_HELP},
    {LAYER_KEY(UV), SDL_SCANCODE_5, 0, "5", GROUP_PICTURE, FIRST_LAYERS_HELP},
    {LAYER_KEY(RAYS), SDL_SCANCODE_6, 0, "6", GROUP_PICTURE, LAST_LAYERS_HELP},
    {LAYER_KEY(STEPS), SDL_SCANCODE_7, 0, "7", GROUP_PICTURE, LAST_LAYERS_HELP},
    {LAYER_KEY(TIME), SDL_SCANCODE_8, 0, "8", GROUP_PICTURE, LAST_LAYERS_HELP},
    {LAYER_KEY(ERROR), SDL_SCANCODE_9, 0, "9", GROUP_PICTURE, LAST_LAYERS_HELP},
    {LAYER_KEY(ACNE), SDL_SCANCODE_0, 0, "0", GROUP_PICTURE, LAST_LAYERS_HELP},
    {ACTION_OFFSET_NEXT, 0, SDLK_o, NULL, GROUP_PICTURE, N_("offset: none, fixed, bound")},
    {ACTION_EPSILON_HALF, SDL_SCANCODE_LEFTBRACKET, 0, NULL, GROUP_PICTURE, EPSILON_HELP},
    {ACTION_EPSILON_TWICE, SDL_SCANCODE_RIGHTBRACKET, 0, NULL, GROUP_PICTURE, EPSILON_HELP},
    {ACTION_ENGINE_NEXT, 0, SDLK_g, NULL, GROUP_PICTURE, N_("float, double, quad; which light")},
    {ACTION_LIGHT_MODE_NEXT, 0, SDLK_m, NULL, GROUP_PICTURE,
     N_("float, double, quad; which light")},
    {ACTION_DEPTH_MORE, 0, SDLK_b, NULL, GROUP_PICTURE, N_("deeper, more samples (Shift: less)")},
    {ACTION_SAMPLES_TWICE, 0, SDLK_n, NULL, GROUP_PICTURE,
     N_("deeper, more samples (Shift: less)")},
    {ACTION_TOGGLE_SETTINGS, 0, SDLK_i, NULL, GROUP_PICTURE,
     N_("settings and costs; all as at first")},
    {ACTION_RESET_SETTINGS, 0, SDLK_BACKSPACE, N_("Backspace"), GROUP_PICTURE,
     N_("settings and costs; all as at first")},
    {ACTION_SPLIT_NEXT, 0, SDLK_x, NULL, GROUP_PICTURE, N_("side by side, difference; which side")},
    {ACTION_SWAP_SIDE, 0, SDLK_t, NULL, GROUP_PICTURE, N_("side by side, difference; which side")},
    {ACTION_BAR_LEFT, 0, SDLK_F6, NULL, GROUP_PICTURE, N_("bar left, right; or the mouse")},
    {ACTION_BAR_RIGHT, 0, SDLK_F7, NULL, GROUP_PICTURE, N_("bar left, right; or the mouse")},
    {ACTION_TOGGLE_RAYS, 0, SDLK_v, NULL, GROUP_RAYS, N_("show them, or the picture again")},
    {ACTION_NONE, 0, 0, N_("Click"), GROUP_RAYS, N_("of that pixel")},
    {ACTION_NONE, 0, 0, "Ctrl ←↑↓→", GROUP_RAYS, N_("of the pixel beside")},
    {ACTION_RAY_PREVIOUS, 0, SDLK_j, NULL, GROUP_RAYS, N_("numbers of the ray before, after")},
    {ACTION_RAY_NEXT, 0, SDLK_k, NULL, GROUP_RAYS, N_("numbers of the ray before, after")},
    {ACTION_NONE, 0, 0, "←↑↓→", GROUP_RAYS, N_("around them; or the mouse")},
    {ACTION_NONE, 0, 0, N_("Shift"), GROUP_PROGRAM, N_("with a move: fast, fine")},
    {ACTION_NONE, 0, 0, N_("Ctrl"), GROUP_PROGRAM, N_("with a move: fast, fine")},
    {ACTION_RESET_VIEW, 0, SDLK_HOME, N_("Home"), GROUP_PROGRAM, N_("the scene's own view")},
    {ACTION_SNAPSHOT, 0, SDLK_p, NULL, GROUP_PROGRAM, N_("snapshot")},
    {ACTION_SNAPSHOT, 0, SDLK_F12, NULL, GROUP_PROGRAM, N_("snapshot")},
    {ACTION_COPY_VIEW, 0, SDLK_c, NULL, GROUP_PROGRAM, N_("camera and light as text, to paste")},
    {ACTION_TEXT_LARGER, 0, SDLK_PLUS, "+", GROUP_PROGRAM, N_("larger, smaller letters")},
    {ACTION_TEXT_LARGER, 0, SDLK_EQUALS, "", GROUP_PROGRAM, N_("larger, smaller letters")},
    {ACTION_TEXT_LARGER, 0, SDLK_KP_PLUS, "", GROUP_PROGRAM, N_("larger, smaller letters")},
    {ACTION_TEXT_SMALLER, 0, SDLK_MINUS, "-", GROUP_PROGRAM, N_("larger, smaller letters")},
    {ACTION_TEXT_SMALLER, 0, SDLK_KP_MINUS, "", GROUP_PROGRAM, N_("larger, smaller letters")},
    {ACTION_LANGUAGE, 0, SDLK_l, NULL, GROUP_PROGRAM, N_("English, français")},
    {ACTION_BROWSE_SCENES, 0, SDLK_f, NULL, GROUP_PROGRAM,
     N_("other scenes: a list with pictures")},
    {ACTION_RECORD, 0, SDLK_r, NULL, GROUP_PROGRAM, N_("record a lesson, or end it")},
    {ACTION_CAPTION, 0, SDLK_RETURN, N_("Enter"), GROUP_PROGRAM, N_("words for that lesson")},
    {ACTION_HELP, 0, SDLK_F1, NULL, GROUP_PROGRAM, N_("this help")},
    {ACTION_HELP, 0, SDLK_h, NULL, GROUP_PROGRAM, N_("this help")},
    {ACTION_FULL_SCREEN, 0, SDLK_F11, NULL, GROUP_PROGRAM, N_("full screen")},
    {ACTION_QUIT, 0, SDLK_ESCAPE, N_("Esc"), GROUP_PROGRAM, N_("leave")},
};

/** How many there are. */
enum { BINDING_COUNT = sizeof bindings / sizeof bindings[0] };

/** @return Which of the groups a binding is in, from 1. */
static int group_number(const KeyBinding *binding) {
    int number = 1;
    for (const KeyBinding *other = bindings; other < binding; other++) {
        number += other->group != other[1].group;
    }
    return number;
}

KeyInfo keymap_lookup(SDL_Keysym key, bool by_letter) {
    for (size_t i = 0; i < BINDING_COUNT; i++) {
        const KeyBinding *binding = &bindings[i];
        bool by_scancode = binding->scancode != 0 && (!by_letter || binding->keycode == 0);
        if (by_scancode ? key.scancode == binding->scancode
                        : binding->keycode != 0 && key.sym == binding->keycode) {
            return (KeyInfo){binding->action, group_number(binding), binding->help};
        }
    }
    return (KeyInfo){.action = ACTION_NONE};
}

Action keymap_action(SDL_Keysym key, bool by_letter) {
    Action action = keymap_lookup(key, by_letter).action;
    return key.mod & KMOD_SHIFT ? action_shifted(action) : action;
}

/**
 * @return What is printed on a key of the keyboard in use.
 * @param by_letter  Whether the light's keys go by their letters.
 */
static const char *binding_label(const KeyBinding *binding, bool by_letter) {
    if (binding->label) {
        return binding->label[0] != '\0' ? gettext(binding->label) : "";
    }
    if (binding->scancode == 0 || (by_letter && binding->keycode != 0)) {
        return SDL_GetKeyName(binding->keycode);
    }
    const char *printed = SDL_GetKeyName(SDL_GetKeyFromScancode(binding->scancode));
    return printed[0] != '\0' ? printed : SDL_GetScancodeName(binding->scancode);
}

/** Adds one key to the names in a row. */
static void add_label(PanelRow *row, const char *label) {
    size_t used = strlen(row->label);
    const char *gap = used > 0 && label[0] != '\0' ? "  " : "";
    SDL_snprintf(row->label + used, sizeof row->label - used, "%s%s", gap, label);
}

size_t keymap_help_rows(bool by_letter, PanelRow rows[HELP_ROWS_MAXIMUM]) {
    size_t count = 0;
    const KeyBinding *before = NULL;
    for (const KeyBinding *binding = bindings; binding < bindings + BINDING_COUNT; binding++) {
        bool is_new_group = !before || before->group != binding->group;
        if (is_new_group && count < HELP_ROWS_MAXIMUM) {
            rows[count++] = (PanelRow){
                .is_heading = true, .text = gettext(binding->group), .tint = group_number(binding)};
        }
        bool is_new_row = is_new_group || strcmp(before->help, binding->help) != 0;
        if (is_new_row && count < HELP_ROWS_MAXIMUM) {
            rows[count++] =
                (PanelRow){.text = gettext(binding->help), .tint = group_number(binding)};
        }
        add_label(&rows[count - 1], binding_label(binding, by_letter));
        before = binding;
    }
    return count;
}
