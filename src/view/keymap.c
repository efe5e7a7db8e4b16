/**
 * @file
 * @brief Which key asks for what.
 *
 * The light's keys stand at fixed places: those of the letters z s q d e w on an AZERTY keyboard,
 * wherever the letters are on the keyboard in use; so do the two that step the time, right of M or
 * N, which on an AZERTY keyboard are ; and :. SDL names places by the US keyboard. All other
 * keys go by what is printed on them.
 */
#include "view/keymap.h"

#include "dioptre/language.h"

#include <libintl.h>
#include <string.h>

/** One key, or one other thing that the help tells of. */
typedef struct Binding {
    Action action;      /**< What it asks for. */
    SDL_Scancode place; /**< Its place, where it goes by that; otherwise 0, SDL's "unknown". */
    SDL_Keycode letter; /**< Its letter or name; 0 with a place: it always goes by that; 0 without:
                             not a key, only a row of the help. */
    const char *label;  /**< What to call it in the help, in English; NULL: as SDL does; empty: not
                           at  all. */
    const char *group;  /**< The help's heading that it stands under. */
    const char *help;   /**< What it does. Neighbours with the same words share a row. */
} Binding;

/** Heading of the help: the lights. */
static const char LIGHT[] = N_("Light");
/** Heading of the help: the camera. */
static const char CAMERA[] = N_("Camera");
/** Heading of the help: the time. */
static const char TIME[] = N_("Time");
/** Heading of the help: what is shown, and how it is drawn. */
static const char PICTURE[] = N_("Picture");
/** Heading of the help: the rays of one pixel. */
static const char RAYS[] = N_("Rays of one pixel");
/** Heading of the help: everything else. */
static const char PROGRAM[] = N_("Program");

/** What the first keys of layers do. */
#define FIRST_LAYERS N_("light, normals, distance, shapes, (u, v)")
/** What the other keys of layers do. */
#define LAST_LAYERS N_("rays, marching, time, error, acne")
/** What the keys of epsilon do. */
#define EPSILON N_("epsilon half, twice (Shift: 1/10, 10 times)")
/** The key of a layer. */
#define LAYER_KEY(layer) (Action)(ACTION_LAYER + LAYER_##layer)

/** All keys, in the help's order. */
static const Binding bindings[] = {
    {ACTION_LIGHT_UP, SDL_SCANCODE_W, SDLK_z, NULL, LIGHT, N_("up, down")},
    {ACTION_LIGHT_DOWN, SDL_SCANCODE_S, SDLK_s, NULL, LIGHT, N_("up, down")},
    {ACTION_LIGHT_LEFT, SDL_SCANCODE_A, SDLK_q, NULL, LIGHT, N_("left, right")},
    {ACTION_LIGHT_RIGHT, SDL_SCANCODE_D, SDLK_d, NULL, LIGHT, N_("left, right")},
    {ACTION_LIGHT_AWAY, SDL_SCANCODE_E, SDLK_e, NULL, LIGHT, N_("away from you, nearer")},
    {ACTION_LIGHT_NEARER, SDL_SCANCODE_Z, SDLK_w, NULL, LIGHT, N_("away from you, nearer")},
    {ACTION_NEXT_LIGHT, 0, SDLK_TAB, N_("Tab"), LIGHT, N_("next light")},
    {ACTION_CAMERA_UP, 0, SDLK_UP, "↑", CAMERA, N_("up, down")},
    {ACTION_CAMERA_DOWN, 0, SDLK_DOWN, "↓", CAMERA, N_("up, down")},
    {ACTION_CAMERA_LEFT, 0, SDLK_LEFT, "←", CAMERA, N_("left, right")},
    {ACTION_CAMERA_RIGHT, 0, SDLK_RIGHT, "→", CAMERA, N_("left, right")},
    {ACTION_CAMERA_FORWARD, 0, SDLK_PAGEUP, N_("Page Up"), CAMERA, N_("forward, back")},
    {ACTION_CAMERA_BACK, 0, SDLK_PAGEDOWN, N_("Page Down"), CAMERA, N_("forward, back")},
    {ACTION_NONE, 0, 0, N_("Mouse drag"), CAMERA, N_("look around")},
    {ACTION_NONE, 0, 0, N_("Wheel"), CAMERA, N_("field of view")},
    {ACTION_TIME, 0, SDLK_SPACE, N_("Space"), TIME, N_("run, hold")},
    {ACTION_TIME_BACK, SDL_SCANCODE_COMMA, SDLK_COMMA, NULL, TIME, N_("a step back, on")},
    {ACTION_TIME_ON, SDL_SCANCODE_PERIOD, SDLK_PERIOD, NULL, TIME, N_("a step back, on")},
    {LAYER_KEY(SHADED), SDL_SCANCODE_1, 0, "1", PICTURE, FIRST_LAYERS},
    {LAYER_KEY(NORMALS), SDL_SCANCODE_2, 0, "2", PICTURE, FIRST_LAYERS},
    {LAYER_KEY(DISTANCE), SDL_SCANCODE_3, 0, "3", PICTURE, FIRST_LAYERS},
    {LAYER_KEY(SHAPES), SDL_SCANCODE_4, 0, "4", PICTURE, FIRST_LAYERS},
    {LAYER_KEY(PLACE), SDL_SCANCODE_5, 0, "5", PICTURE, FIRST_LAYERS},
    {LAYER_KEY(RAYS), SDL_SCANCODE_6, 0, "6", PICTURE, LAST_LAYERS},
    {LAYER_KEY(STEPS), SDL_SCANCODE_7, 0, "7", PICTURE, LAST_LAYERS},
    {LAYER_KEY(TIME), SDL_SCANCODE_8, 0, "8", PICTURE, LAST_LAYERS},
    {LAYER_KEY(ERROR), SDL_SCANCODE_9, 0, "9", PICTURE, LAST_LAYERS},
    {LAYER_KEY(ACNE), SDL_SCANCODE_0, 0, "0", PICTURE, LAST_LAYERS},
    {ACTION_OFFSET, 0, SDLK_o, NULL, PICTURE, N_("offset: none, fixed, bound")},
    {ACTION_EPSILON_HALF, SDL_SCANCODE_LEFTBRACKET, 0, NULL, PICTURE, EPSILON},
    {ACTION_EPSILON_TWICE, SDL_SCANCODE_RIGHTBRACKET, 0, NULL, PICTURE, EPSILON},
    {ACTION_ENGINE, 0, SDLK_g, NULL, PICTURE, N_("float, double, quad; which light")},
    {ACTION_LIGHT_MODE, 0, SDLK_m, NULL, PICTURE, N_("float, double, quad; which light")},
    {ACTION_DEPTH, 0, SDLK_b, NULL, PICTURE, N_("deeper, more samples (Shift: less)")},
    {ACTION_SAMPLES, 0, SDLK_n, NULL, PICTURE, N_("deeper, more samples (Shift: less)")},
    {ACTION_SETTINGS, 0, SDLK_i, NULL, PICTURE, N_("settings and costs; all as at first")},
    {ACTION_AS_ASKED, 0, SDLK_BACKSPACE, N_("Backspace"), PICTURE,
     N_("settings and costs; all as at first")},
    {ACTION_SPLIT, 0, SDLK_x, NULL, PICTURE, N_("side by side, difference; which side")},
    {ACTION_SIDE, 0, SDLK_t, NULL, PICTURE, N_("side by side, difference; which side")},
    {ACTION_BAR_LEFT, 0, SDLK_F6, NULL, PICTURE, N_("bar left, right; or the mouse")},
    {ACTION_BAR_RIGHT, 0, SDLK_F7, NULL, PICTURE, N_("bar left, right; or the mouse")},
    {ACTION_RAYS, 0, SDLK_v, NULL, RAYS, N_("show them, or the picture again")},
    {ACTION_NONE, 0, 0, N_("Click"), RAYS, N_("of that pixel")},
    {ACTION_NONE, 0, 0, "Ctrl ←↑↓→", RAYS, N_("of the pixel beside")},
    {ACTION_RAY_BACK, 0, SDLK_j, NULL, RAYS, N_("numbers of the ray before, after")},
    {ACTION_RAY_ON, 0, SDLK_k, NULL, RAYS, N_("numbers of the ray before, after")},
    {ACTION_NONE, 0, 0, "←↑↓→", RAYS, N_("around them; or the mouse")},
    {ACTION_NONE, 0, 0, N_("Shift"), PROGRAM, N_("with a move: fast, fine")},
    {ACTION_NONE, 0, 0, N_("Ctrl"), PROGRAM, N_("with a move: fast, fine")},
    {ACTION_HOME, 0, SDLK_HOME, N_("Home"), PROGRAM, N_("the scene's own view")},
    {ACTION_SNAPSHOT, 0, SDLK_p, NULL, PROGRAM, N_("snapshot")},
    {ACTION_SNAPSHOT, 0, SDLK_F12, NULL, PROGRAM, N_("snapshot")},
    {ACTION_COPY, 0, SDLK_c, NULL, PROGRAM, N_("camera and light as text, to paste")},
    {ACTION_TEXT_LARGER, 0, SDLK_PLUS, "+", PROGRAM, N_("larger, smaller letters")},
    {ACTION_TEXT_LARGER, 0, SDLK_EQUALS, "", PROGRAM, N_("larger, smaller letters")},
    {ACTION_TEXT_LARGER, 0, SDLK_KP_PLUS, "", PROGRAM, N_("larger, smaller letters")},
    {ACTION_TEXT_SMALLER, 0, SDLK_MINUS, "-", PROGRAM, N_("larger, smaller letters")},
    {ACTION_TEXT_SMALLER, 0, SDLK_KP_MINUS, "", PROGRAM, N_("larger, smaller letters")},
    {ACTION_LANGUAGE, 0, SDLK_l, NULL, PROGRAM, N_("English, français")},
    {ACTION_SCENES, 0, SDLK_f, NULL, PROGRAM, N_("other scenes: a list with pictures")},
    {ACTION_RECORD, 0, SDLK_r, NULL, PROGRAM, N_("record a lesson, or end it")},
    {ACTION_CAPTION, 0, SDLK_RETURN, N_("Enter"), PROGRAM, N_("words for that lesson")},
    {ACTION_HELP, 0, SDLK_F1, NULL, PROGRAM, N_("this help")},
    {ACTION_HELP, 0, SDLK_h, NULL, PROGRAM, N_("this help")},
    {ACTION_FULL_SCREEN, 0, SDLK_F11, NULL, PROGRAM, N_("full screen")},
    {ACTION_LEAVE, 0, SDLK_ESCAPE, N_("Esc"), PROGRAM, N_("leave")},
};

/** How many there are. */
enum { BINDING_COUNT = sizeof bindings / sizeof bindings[0] };

/** @return Which of the groups a binding is in, from 1. @param binding The binding. */
static int group_number(const Binding *binding) {
    int number = 1;
    for (const Binding *other = bindings; other < binding; other++) {
        number += other->group != other[1].group;
    }
    return number;
}

KeyMeaning keymap_meaning(SDL_Keysym key, bool by_letter) {
    for (size_t i = 0; i < BINDING_COUNT; i++) {
        const Binding *binding = &bindings[i];
        bool by_place = binding->place != 0 && (!by_letter || binding->letter == 0);
        if (by_place ? key.scancode == binding->place
                     : binding->letter != 0 && key.sym == binding->letter) {
            return (KeyMeaning){binding->action, group_number(binding), binding->help};
        }
    }
    return (KeyMeaning){.action = ACTION_NONE};
}

Action keymap_action(SDL_Keysym key, bool by_letter) {
    Action action = keymap_meaning(key, by_letter).action;
    return key.mod & KMOD_SHIFT ? action_shifted(action) : action;
}

/**
 * @return What is printed on a key of the keyboard in use.
 * @param binding    The key.
 * @param by_letter  Whether the light's keys go by their letters.
 */
static const char *binding_label(const Binding *binding, bool by_letter) {
    if (binding->label) {
        return binding->label[0] != '\0' ? gettext(binding->label) : "";
    }
    if (binding->place == 0 || (by_letter && binding->letter != 0)) {
        return SDL_GetKeyName(binding->letter);
    }
    const char *printed = SDL_GetKeyName(SDL_GetKeyFromScancode(binding->place));
    return printed[0] != '\0' ? printed : SDL_GetScancodeName(binding->place);
}

/**
 * Adds one key to the names in a row.
 * @param[in,out] row  The row.
 * @param label        The key's name.
 */
static void add_label(PanelRow *row, const char *label) {
    size_t used = strlen(row->label);
    const char *gap = used > 0 && label[0] != '\0' ? "  " : "";
    SDL_snprintf(row->label + used, sizeof row->label - used, "%s%s", gap, label);
}

size_t keymap_help(bool by_letter, PanelRow rows[HELP_ROWS_MAXIMUM]) {
    size_t count = 0;
    const Binding *before = NULL;
    for (const Binding *binding = bindings; binding < bindings + BINDING_COUNT; binding++) {
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
