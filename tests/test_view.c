/**
 * @file
 * @brief Tests of the window's parts without a screen: commands, movement, snapshots, panels.
 *        tests/window.sh tests the window itself.
 */
#include "load_scene.h"
#include "testing.h"

#include "assets/images/image_file.h"
#include "dioptre/scene_override.h"
#include "dioptre/scene_words.h"
#include "dioptre/view.h"
#include "render/orbit_camera.h"
#include "view/commands/commands.h"
#include "view/loading/error_meter.h"
#include "view/panels/help.h"
#include "view/panels/hud.h"
#include "view/panels/legend.h"
#include "view/panels/light_marks.h"
#include "view/panels/magnifier.h"
#include "view/panels/pixel_readout.h"
#include "view/panels/toolbar.h"
#include "view/panels/tooltip.h"
#include "view/state/edit_history.h"
#include "view/state/scene_text.h"
#include "view/state/settings_chart.h"
#include "view/state/snapshot.h"
#include "view/state/source_edit.h"
#include "view/state/view_history.h"

#include <glob.h>
#include <pthread.h>
#include <stdlib.h>
#include <uchar.h>
#include <unistd.h>

/** Rounding error of a sum of times, seconds. */
static const double TIME_ROUNDING = 1e-12;

/** Rounding error of a place in a picture, pixels. */
static const double PIXEL_ROUNDING = 1e-9;

/** Fails unless two numbers are equal up to rounding. */
static void assert_near(double a, double b) {
    assert_at_most(fabs(a - b), TIME_ROUNDING, "%g should be %g", a, b);
}

/** @return The movement of a command. */
static Move move(const char *name) {
    return command_find(command_table, name)->move;
}

/** @return Movement of the camera up to a time. */
static Movement consume_camera_motion(HeldKeys *held_keys, double time) {
    Movement light, camera;
    held_keys_consume(held_keys, time, &light, &camera);
    assert_false(movement_is_nonzero(light));
    return camera;
}

/** A tap moves by a 60th of a second, however short it is. */
static void test_motion_tap(void **state) {
    (void)state;
    HeldKeys held_keys = {.speed = 1};
    assert_false(held_keys_is_active(&held_keys));
    held_keys_press(&held_keys, move("camera up"), 5);
    held_keys_release(&held_keys, move("camera up"), 5.001);
    assert_true(held_keys_is_active(&held_keys));
    assert_near(consume_camera_motion(&held_keys, 5.002).up, HELD_KEYS_MINIMUM_HOLD);
    assert_false(held_keys_is_active(&held_keys));
    assert_false(movement_is_nonzero(consume_camera_motion(&held_keys, 6)));
}

/** A key moves by the time that it was held, however often it is consumed. */
static void test_motion_held(void **state) {
    (void)state;
    HeldKeys held_keys = {.speed = 1};
    held_keys_press(&held_keys, move("camera left"), 5);
    double way = consume_camera_motion(&held_keys, 5).right;
    assert_near(way, -HELD_KEYS_MINIMUM_HOLD);
    for (double time = 5.01; time < 5.5; time += 0.0137) {
        held_keys_press(&held_keys, move("camera left"), time); /* the keyboard repeats it */
        way += consume_camera_motion(&held_keys, time).right;
        assert_true(held_keys_is_active(&held_keys));
    }
    held_keys_release(&held_keys, move("camera left"), 5.5);
    way += consume_camera_motion(&held_keys, 9).right;
    assert_near(way, -0.5);
}

/** Opposite keys cancel; others add up. */
static void test_motion_opposite(void **state) {
    (void)state;
    HeldKeys held_keys = {.speed = 1};
    held_keys_press(&held_keys, move("camera left"), 0.1);
    held_keys_press(&held_keys, move("camera right"), 0.1);
    held_keys_press(&held_keys, move("camera forward"), 0.2);
    Movement way = consume_camera_motion(&held_keys, 1.3);
    assert_true(way.right == 0);
    assert_near(way.forward, 1.1);
}

/** Shift and Ctrl count from when they are held. */
static void test_motion_speed(void **state) {
    (void)state;
    HeldKeys held_keys = {.speed = 1};
    held_keys_press(&held_keys, move("camera back"), 1);
    held_keys_set_speed(&held_keys, 4, 2);
    held_keys_set_speed(&held_keys, 1, 2.5);
    assert_near(consume_camera_motion(&held_keys, 3).forward, -(1 + 0.5 * 4 + 0.5));
    held_keys_set_speed(&held_keys, 0.25, 3);
    held_keys_release_all(&held_keys, 3);
    held_keys_press(&held_keys, move("camera back"), 4);
    held_keys_release_all(&held_keys, 4);
    assert_near(consume_camera_motion(&held_keys, 5).forward, -HELD_KEYS_MINIMUM_HOLD / 4);
}

/** Light and camera are moved by separate keys. */
static void test_motion_two(void **state) {
    (void)state;
    HeldKeys held_keys = {.speed = 1};
    Movement light, camera;
    held_keys_press(&held_keys, move("light away"), 0);
    held_keys_press(&held_keys, move("camera down"), 0);
    held_keys_consume(&held_keys, 2, &light, &camera);
    assert_near(light.forward, 2);
    assert_near(camera.up, -2);
    assert_true(light.up == 0 && light.right == 0 && camera.forward == 0);
}

/** Fails unless a key has a command. @param name Its name; NULL: the key has none. */
static void assert_key(SDL_Scancode scancode, SDL_Keycode letter, bool by_letter,
                       const char *name) {
    const SDL_Keysym key = {.scancode = scancode, .sym = letter};
    const Command *command = command_find_key(command_table, key, by_letter);
    if (name) {
        assert_non_null(command);
        assert_string_equal(command->name, name);
    } else {
        assert_null(command);
    }
}

/** The light's keys go by position or by letter, never by both. */
static void test_keymap_light(void **state) {
    (void)state;
    /* The keys of an AZERTY keyboard: the same either way. */
    for (int by_letter = 0; by_letter < 2; by_letter++) {
        assert_key(SDL_SCANCODE_W, SDLK_z, by_letter, "light up");
        assert_key(SDL_SCANCODE_S, SDLK_s, by_letter, "light down");
        assert_key(SDL_SCANCODE_A, SDLK_q, by_letter, "light left");
        assert_key(SDL_SCANCODE_D, SDLK_d, by_letter, "light right");
        assert_key(SDL_SCANCODE_E, SDLK_e, by_letter, "light away");
        assert_key(SDL_SCANCODE_Z, SDLK_w, by_letter, "light nearer");
    }
    /* The keys of a QWERTY keyboard. */
    assert_key(SDL_SCANCODE_W, SDLK_w, false, "light up");
    assert_key(SDL_SCANCODE_W, SDLK_w, true, "light nearer");
    assert_key(SDL_SCANCODE_Z, SDLK_z, false, "light nearer");
    assert_key(SDL_SCANCODE_Z, SDLK_z, true, "light up");
    assert_key(SDL_SCANCODE_Q, SDLK_q, false, NULL);
    assert_key(SDL_SCANCODE_A, SDLK_a, true, NULL);
    /* The P of a Dvorak keyboard is at the position of R, its O at that of S. */
    assert_key(SDL_SCANCODE_R, SDLK_p, false, "snapshot");
    assert_key(SDL_SCANCODE_S, SDLK_o, false, "light down");
}

/** The other keys go by what is printed on them. */
static void test_keymap_others(void **state) {
    (void)state;
    static const struct {
        SDL_Keycode key;
        const char *name;
    } rows[] = {{SDLK_UP, "camera up"},
                {SDLK_DOWN, "camera down"},
                {SDLK_LEFT, "camera left"},
                {SDLK_RIGHT, "camera right"},
                {SDLK_PAGEUP, "camera forward"},
                {SDLK_PAGEDOWN, "camera back"},
                {SDLK_p, "snapshot"},
                {SDLK_F12, "snapshot"},
                {SDLK_HOME, "home"},
                {SDLK_TAB, "next light"},
                {SDLK_F1, "help"},
                {SDLK_h, "help"},
                {SDLK_F11, "full screen"},
                {SDLK_ESCAPE, "leave"},
                {SDLK_SPACE, "time"},
                {SDLK_r, "record"},
                {SDLK_f, "scenes"},
                {SDLK_RETURN, "caption"},
                {SDLK_F3, "next thing"},
                {SDLK_F13, NULL},
                {SDLK_F5, "presentation"},
                {0, NULL}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        assert_key(SDL_SCANCODE_UNKNOWN, rows[i].key, false, rows[i].name);
        assert_key(SDL_SCANCODE_UNKNOWN, rows[i].key, true, rows[i].name);
    }
}

/** @return The keys of a row of the help. */
static const char *help_text_keys(const HelpList *list, const char *text) {
    for (size_t i = 0; i < list->count; i++) {
        if (strcmp(list->rows[i].text, text) == 0) {
            return list->rows[i].label;
        }
    }
    fail_msg("the help does not tell of: %s", text);
    return "";
}

/** The help names keys as on a US keyboard, SDL's default. */
static void test_keymap_help(void **state) {
    (void)state;
    HelpList list;
    Help help = {.commands = command_table};
    help_write_list(&help, &list);
    assert_in_range(list.count, 20, HELP_ROWS_MAXIMUM - 1);
    assert_string_equal(list.rows[0].text, "Scenes and lessons");
    assert_true(list.rows[0].is_heading);
    assert_string_equal(list.rows[1].label, "F");
    assert_string_equal(help_text_keys(&list, "lamp up, down"), "W  S");
    assert_string_equal(help_text_keys(&list, "lamp away from you, nearer"), "E  Z");
    assert_string_equal(help_text_keys(&list, "camera forward, back"), "Page Up  Page Down");
    assert_string_equal(help_text_keys(&list, "save the picture (Shift: as on the screen)"),
                        "P  F12");
    assert_string_equal(help_text_keys(&list, "close what lies on top; at last leave"), "Esc");
    assert_string_equal(help_text_keys(&list, "take a change back, do it again"), "Ctrl+Z  Ctrl+Y");
    assert_string_equal(help_text_keys(&list, "this help: all keys"), "F1  H  ?");
    assert_string_equal(help_text_keys(&list, "the toolbar by keys: arrows, Enter; Esc: back"),
                        "Shift+F2");
    // Those of a lesson are those of the commands that steer it.
    assert_string_equal(help_text_keys(&list, "hold the lesson, or let it go on"), "Space");
    assert_string_equal(help_text_keys(&list, "a step of the lesson back, on at once"), ",  .");
    assert_string_equal(help_text_keys(&list, "answer its question; choose on its end card"),
                        "1 to 9");
    assert_string_equal(help_text_keys(&list, "leave the lesson: press twice"), "Esc");
    assert_string_equal(
        help_text_keys(&list, "show or hide camera, shadow, mirrored, refracted rays"),
        "Shift+1  Shift+2  Shift+3  Shift+4");
    // Each row can be understood alone: no two say the same.
    for (size_t i = 0; i < list.count; i++) {
        for (size_t j = 0; j < i; j++) {
            assert_string_not_equal(list.rows[i].text, list.rows[j].text);
        }
    }
    help.by_letter = true;
    help_write_list(&help, &list);
    assert_string_equal(help_text_keys(&list, "lamp up, down"), "Z  S");
    assert_string_equal(help_text_keys(&list, "lamp away from you, nearer"), "E  W");
}

/** Arrows select a key of the help, and Enter requests its command. */
static void test_help_keys(void **state) {
    (void)state;
    Help help = {.commands = command_table, .selected = {-1, 0}};
    assert_true(help_handle_key(&help, SDLK_RETURN));
    assert_null(help.requested);
    assert_true(help_handle_key(&help, SDLK_DOWN));
    assert_true(help_handle_key(&help, SDLK_RETURN));
    assert_string_equal(help.requested->name, "scenes");
    for (int row = 0; row < 3; row++) { // Record, words, and over a heading.
        assert_true(help_handle_key(&help, SDLK_DOWN));
    }
    assert_true(help_handle_key(&help, SDLK_RETURN));
    assert_string_equal(help.requested->name, "light up");
    assert_true(help_handle_key(&help, SDLK_RIGHT) && help_handle_key(&help, SDLK_RIGHT));
    assert_true(help_handle_key(&help, SDLK_RETURN));
    assert_string_equal(help.requested->name, "light down");
    assert_true(help_handle_key(&help, SDLK_END) && help_handle_key(&help, SDLK_RETURN));
    assert_string_equal(help.requested->name, "quit");
    assert_true(help_handle_key(&help, SDLK_HOME) && help_handle_key(&help, SDLK_UP));
    assert_int_equal(help.selected.row, 1);
    assert_false(help_handle_key(&help, SDLK_v));
}

/** @return The row of a position. */
static const Command *row_at(SDL_Scancode scancode) {
    return command_find_key(command_table, (SDL_Keysym){.scancode = scancode}, false);
}

/** The drawn keyboard has a word on each key with a command, in the colour of its group. */
static void test_keyboard_labels(void **state) {
    (void)state;
    const Help help = {.commands = command_table};
    assert_string_equal(row_at(SDL_SCANCODE_W)->name, "light up");
    assert_int_equal(help_group(&help, row_at(SDL_SCANCODE_W)), 3);
    assert_string_equal(key_action_label(row_at(SDL_SCANCODE_W)), "up");
    assert_null(row_at(SDL_SCANCODE_F3));
    assert_string_equal(key_action_label(NULL), "");
    assert_string_equal(key_action_label(row_at(SDL_SCANCODE_LSHIFT)), "fast");
    assert_string_equal(key_action_label(row_at(SDL_SCANCODE_RCTRL)), "fine");
    assert_int_equal(help_group(&help, row_at(SDL_SCANCODE_LSHIFT)), 10);
    assert_string_equal(key_cap_label(SDL_SCANCODE_LEFT), "←");
}

/** Every command has a unique name and an action; every row is found by its keys. */
static void test_command_table(void **state) {
    (void)state;
    for (const Command *row = command_table; command_is_row(row); row++) {
        if (row->name) {
            assert_ptr_equal(command_find(command_table, row->name), row);
            assert_true(command_is_move(row) == !row->run);
        }
        for (int i = 0; i < COMMAND_KEYS; i++) {
            SDL_Keysym key = {.scancode = row->keys[i].scancode,
                              .sym = row->keys[i].keycode,
                              .mod = (row->flags & COMMAND_SHIFT ? KMOD_LSHIFT : 0) |
                                     (row->flags & COMMAND_CTRL ? KMOD_LCTRL : 0)};
            if (key.scancode || key.sym) {
                assert_ptr_equal(command_find_key(command_table, key, false), row);
            }
        }
    }
    const SDL_Keysym shifted = {.sym = SDLK_HOME, .mod = KMOD_RSHIFT};
    assert_string_equal(command_find_key(command_table, shifted, false)->name, "home");
}

/** The parts of src/view, from the bottom, as the comment of view/app.h lists them. */
static const char *const view_parts[] = {"state/",  "window/", "gui/", "loading/",
                                         "panels/", "window",  "app.", "commands/",
                                         "lesson/", "input/",  "view."};

/** @return The index of a file's part. @param path The path after `view/`. */
static int view_part(const char *path) {
    for (int i = 0; i < (int)(sizeof view_parts / sizeof *view_parts); i++) {
        if (strncmp(path, view_parts[i], strlen(view_parts[i])) == 0) {
            return i;
        }
    }
    fail_msg("%s is in no part of src/view", path);
    return -1;
}

/** Each part of src/view includes only parts below it. */
static void test_parts(void **state) {
    (void)state;
    glob_t files = {0};
    assert_int_equal(glob("src/view/*.[ch]", 0, NULL, &files), 0);
    assert_int_equal(glob("src/view/*/*.[ch]", GLOB_APPEND, NULL, &files), 0);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        const char *path = files.gl_pathv[i] + strlen("src/view/");
        FILE *file = fopen(files.gl_pathv[i], "r");
        char line[512], included[512];
        assert_non_null(file);
        while (fgets(line, sizeof line, file)) {
            if (sscanf(line, "#include \"view/%[^\"]", included) == 1 &&
                view_part(included) > view_part(path)) {
                fail_msg("src/view/%s includes view/%s", path, included);
            }
        }
        fclose(file);
    }
    globfree(&files);
}

/** A keyboard: what is printed on its keys, in the order of #letter_keys; `~`: a dead key. */
typedef struct Keyboard {
    const char *name;        /**< Its name. */
    const char32_t *printed; /**< Its signs. */
} Keyboard;

/** The keys of letters and signs, row by row. SDL calls the digits so on all keyboards. */
static const SDL_Scancode letter_keys[] = {
    SDL_SCANCODE_GRAVE,     SDL_SCANCODE_MINUS,       SDL_SCANCODE_EQUALS,
    SDL_SCANCODE_Q,         SDL_SCANCODE_W,           SDL_SCANCODE_E,
    SDL_SCANCODE_R,         SDL_SCANCODE_T,           SDL_SCANCODE_Y,
    SDL_SCANCODE_U,         SDL_SCANCODE_I,           SDL_SCANCODE_O,
    SDL_SCANCODE_P,         SDL_SCANCODE_LEFTBRACKET, SDL_SCANCODE_RIGHTBRACKET,
    SDL_SCANCODE_A,         SDL_SCANCODE_S,           SDL_SCANCODE_D,
    SDL_SCANCODE_F,         SDL_SCANCODE_G,           SDL_SCANCODE_H,
    SDL_SCANCODE_J,         SDL_SCANCODE_K,           SDL_SCANCODE_L,
    SDL_SCANCODE_SEMICOLON, SDL_SCANCODE_APOSTROPHE,  SDL_SCANCODE_BACKSLASH,
    SDL_SCANCODE_Z,         SDL_SCANCODE_X,           SDL_SCANCODE_C,
    SDL_SCANCODE_V,         SDL_SCANCODE_B,           SDL_SCANCODE_N,
    SDL_SCANCODE_M,         SDL_SCANCODE_COMMA,       SDL_SCANCODE_PERIOD,
    SDL_SCANCODE_SLASH};
/** Number of them. */
enum { LETTER_KEYS = sizeof letter_keys / sizeof *letter_keys };

/** @return What SDL says of a key without modifiers. */
static SDL_Keycode keycode_on(const Keyboard *keyboard, SDL_Scancode scancode) {
    for (int i = 0; i < LETTER_KEYS; i++) {
        if (letter_keys[i] == scancode) {
            char32_t printed = keyboard->printed[i];
            return printed == U'~' ? SDLK_SCANCODE_MASK : (SDL_Keycode)printed;
        }
    }
    return SDL_GetKeyFromScancode(scancode);
}

/** @return Whether a key of a keyboard without keypad, alone or with AltGr, runs a command. */
static bool is_reached(const Keyboard *keyboard, const Command *command) {
    for (int scancode = SDL_SCANCODE_A; scancode < SDL_NUM_SCANCODES; scancode++) {
        bool is_of_keypad =
            scancode >= SDL_SCANCODE_NUMLOCKCLEAR && scancode <= SDL_SCANCODE_KP_PERIOD;
        SDL_Keysym key = {.scancode = (SDL_Scancode)scancode,
                          .sym = keycode_on(keyboard, (SDL_Scancode)scancode)};
        for (int altgr = 0; altgr < 2 && !is_of_keypad; altgr++) {
            key.mod = (Uint16)((command->flags & COMMAND_SHIFT ? KMOD_LSHIFT : 0) |
                               (command->flags & COMMAND_CTRL ? KMOD_LCTRL : 0) |
                               (altgr ? KMOD_MODE : 0));
            if (command_find_key(command_table, key, false) == command) {
                return true;
            }
        }
    }
    return false;
}

/** Every command that has a key is reached on each keyboard, though letters are elsewhere and some
 *  signs are dead keys, or need Shift. */
static void test_keyboards(void **state) {
    (void)state;
    static const Keyboard keyboards[] = {
        {"American", U"`-=qwertyuiop[]asdfghjkl;'\\zxcvbnm,./"},
        {"French", U"²)=azertyuiop~$qsdfghjklmù*wxcvbn,;:!"},
        {"Belgian", U"²)-azertyuiop~$qsdfghjklmùµwxcvbn,;:="},
        {"Swiss French", U"§'~qwertzuiopè~asdfghjkléà$yxcvbnm,.-"},
        {"Canadian French", U"#-=qwertyuiop~~asdfghjkl;~<zxcvbnm,.é"},
        {"German", U"~ß~qwertzuiopü+asdfghjklöä#yxcvbnm,.-"},
        {"bépo", U"$=%bépoè~vdljzwauie,ctsrnmçàyx.k'qghf"},
        {"Dvorak", U"`[]',.pyfgcrl/=aoeuidhtns-\\;qjkxbmwvz"},
        {"Spanish", U"º'¡qwertyuiop~+asdfghjklñ~çzxcvbnm,.-"},
    };
    for (size_t i = 0; i < sizeof keyboards / sizeof *keyboards; i++) {
        for (const Command *row = command_table; command_is_row(row); row++) {
            bool has_key = row->keys[0].scancode != 0 || row->keys[0].keycode != 0;
            if (row->name && has_key && !is_reached(&keyboards[i], row)) {
                fail_msg("%s: no key for %s", keyboards[i].name, row->name);
            }
        }
    }
    // German and Swiss: y lies where the light is moved, so that rounding is shown by AltGr y.
    const SDL_Keysym y = {.scancode = SDL_SCANCODE_Z, .sym = SDLK_y};
    const SDL_Keysym altgr_y = {.scancode = SDL_SCANCODE_Z, .sym = SDLK_y, .mod = KMOD_RALT};
    assert_true(command_is(command_find_key(command_table, y, false), "light nearer"));
    assert_true(command_is(command_find_key(command_table, altgr_y, false), "layer rounding"));
}

/** Each layer of the bar's list has its command. */
static void test_toolbar_commands(void **state) {
    (void)state;
    for (int layer = 0; layer < LAYER_COUNT; layer++) {
        const Command *command = command_find(command_table, toolbar_layer_command((Layer)layer));
        assert_non_null(command);
        assert_int_equal(command->argument, layer);
    }
}

/** Each button says what it does, in a sentence that no other has, and names its keys as on the
 *  keyboard in use. */
static void test_tooltips(void **state) {
    (void)state;
    const Help help = {.commands = command_table};
    char text[TOOLTIP_SIZE], other[TOOLTIP_SIZE];
    size_t count = 0;
    for (const Command *a = command_table; command_is_row(a); a++) {
        const char *sentence = a->name ? tooltip_sentence(a->name) : NULL;
        count += sentence != NULL;
        for (const Command *b = command_table; sentence && b < a; b++) {
            const char *earlier = b->name ? tooltip_sentence(b->name) : NULL;
            assert_false(earlier && strcmp(earlier, sentence) == 0);
        }
    }
    assert_int_equal(count, 39);
    assert_string_equal(tooltip_write(&help, "undo", text), "take the last change back — Ctrl+Z");
    assert_string_equal(tooltip_write(&help, "magnifier", text),
                        "the pixels under the mouse as large squares — F4");
    assert_non_null(
        strstr(tooltip_write_pair(&help, "deeper", "less deep", ", ", text), "— B, Shift+B"));
    assert_string_equal(tooltip_write(&help, "shadow rays", text),
                        "show or hide the rays to the lamps — Shift+2");
    assert_string_not_equal(tooltip_write(&help, "chart", text),
                            tooltip_write(&help, "settings", other));
    assert_string_equal(tooltip_write(&help, "light up", text), "");
}

/** A mark that is dragged stays under the mouse, or goes along the direction of view; what lies
 *  behind the camera moves to the same side as the mouse, no less far than ahead of it. */
static void test_light_drag(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    const SDL_Rect picture = {10, 20, 800, 600};
    Vec3d before, after, offset;
    assert_true(scene_light_center(&scene->lights[0], &before));
    ProjectedView view = {scene->camera, picture.w, picture.h};
    double x[2], y[2];
    assert_true(projected_view_point(&view, before, &x[0], &y[0]));
    assert_true(light_marks_drag_offset(scene, 0, &picture, (GuiPoint){100, 100},
                                        (GuiPoint){140, 170}, false, &offset));
    after = vec3d_add(before, offset);
    assert_true(projected_view_point(&view, after, &x[1], &y[1]));
    assert_at_most(fabs(x[1] - x[0] - 40), PIXEL_ROUNDING, "%g pixels right", x[1] - x[0]);
    assert_at_most(fabs(y[1] - y[0] - 70), PIXEL_ROUNDING, "%g pixels down", y[1] - y[0]);
    assert_near(vec3d_dot(offset, scene->camera.direction), 0);
    assert_true(light_marks_drag_offset(scene, 0, &picture, (GuiPoint){100, 100},
                                        (GuiPoint){140, 70}, true, &offset));
    assert_true(vec3d_dot(offset, scene->camera.direction) > 0);
    assert_near(vec3d_dot(offset, scene->camera.up), 0);
    assert_near(vec3d_dot(offset, scene_camera_right(&scene->camera)), 0);
    scene->camera.direction = vec3d_scale(scene->camera.direction, -1);
    assert_true(light_marks_drag_offset(scene, 0, &picture, (GuiPoint){100, 100},
                                        (GuiPoint){140, 170}, false, &offset));
    assert_true(vec3d_dot(offset, scene_camera_right(&scene->camera)) > 0);
    assert_true(vec3d_dot(offset, scene->camera.up) < 0);
    assert_true(vec3d_length(offset) >= vec3d_length(vec3d_subtract(after, before)));
    assert_false(light_marks_drag_offset(scene, scene->light_count, &picture, (GuiPoint){0, 0},
                                         (GuiPoint){1, 1}, false, &offset));
    scene_destroy(scene);
}

/** Only overridden settings are applied. Strategies and lighting modes are cyclic, numbers have
 * limits. */
static void test_settings_override(void **state) {
    (void)state;
    Error error = {0};
    SettingsOverride overrides = {0};
    RenderSettings now = {.engine = engine_find("auto", &error),
                          .samples = 1,
                          .trace = {.offset = OFFSET_BOUND, .epsilon = 1e-4, .depth = 0}};
    const RenderSettings requested = now;
    static const struct {
        SettingsChangeFn *change;
        int step;
    } changes[] = {{settings_override_offset, 1},   {settings_override_epsilon, 2},
                   {settings_override_epsilon, 10}, {settings_override_samples, -1},
                   {settings_override_depth, -1},   {settings_override_lighting, -1},
                   {settings_override_engine, -1}};
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        changes[i].change(&overrides, &now, changes[i].step);
        settings_override_apply(&overrides, &now);
        assert_int_equal(now.trace.offset, i == 0 ? OFFSET_NONE : OFFSET_FIXED);
    }
    assert_true(fabs(now.trace.epsilon / 2e-3 - 1) < 1e-12);
    assert_int_equal(now.samples, 1);
    assert_int_equal(now.trace.depth, 0);
    assert_int_equal(now.lighting, LIGHTING_UNLIT);
    assert_true(now.engine->mantissa_bits > 53);
    for (int i = 0; i < 100; i++) {
        settings_override_epsilon(&overrides, &now, -10);
        settings_override_apply(&overrides, &now);
    }
    assert_true(now.trace.epsilon > 0);
    RenderSettings other = requested;
    settings_override_apply(&(SettingsOverride){0}, &other);
    assert_memory_equal(&other, &requested, sizeof other);
}

/** Median and maximum of the latencies; what is not counted. */
static void test_latency(void **state) {
    (void)state;
    Latency latency = {0};
    assert_int_equal(latency_summary(&latency).count, 0);
    latency_on_presented(&latency, 1);
    for (int i = 1; i <= 300; i++) {
        latency_on_input(&latency, 10 * i);
        latency_on_draw_started(&latency);
        latency_on_input(&latency, 10 * i + 5); /* came too late for this drawing */
        latency_on_presented(&latency, 10 * i + (i <= 200 ? 0.25 : 0.5));
        latency_discard_pending(&latency);
    }
    LatencySummary summary = latency_summary(&latency);
    assert_int_equal(summary.count, 300);
    assert_near(summary.median, 0.25);
    assert_near(summary.worst, 0.5);
    latency_deinit(&latency);
}

/** The median of an even number of latencies is the mean of two; many are no problem. */
static void test_latency_many(void **state) {
    (void)state;
    Latency latency = {0};
    for (int i = 0; i < 2 * LATENCY_PENDING_MAXIMUM; i++) {
        latency_on_input(&latency, i);
    }
    latency_on_draw_started(&latency);
    latency_on_presented(&latency, LATENCY_PENDING_MAXIMUM);
    LatencySummary summary = latency_summary(&latency);
    assert_int_equal(summary.count, LATENCY_PENDING_MAXIMUM);
    assert_near(summary.median, (LATENCY_PENDING_MAXIMUM + 1) / 2.0);
    assert_near(summary.worst, LATENCY_PENDING_MAXIMUM);
    latency_deinit(&latency);
}

/** @return Whether there is a file. */
static bool file_exists(const char *folder, const char *name) {
    char path[NUMBERED_FILE_PATH_SIZE];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return access(path, F_OK) == 0;
}

/** Removes a file of a folder. */
static void remove_from_folder(const char *folder, const char *name) {
    char path[NUMBERED_FILE_PATH_SIZE];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    assert_int_equal(unlink(path), 0);
}

/** Snapshots get the next free number, even if a broken link has it. */
static void test_snapshot_numbers(void **state) {
    (void)state;
    char folder[] = "/tmp/dioptre-view-XXXXXX";
    assert_non_null(mkdtemp(folder));
    char path[NUMBERED_FILE_PATH_SIZE], link[64];
    snprintf(link, sizeof link, "%s/box-0002.bmp", folder);
    assert_int_equal(symlink("/nowhere/at/all", link), 0);
    Picture picture = {0};
    Error error = {0};
    assert_true(picture_init(&picture, 3, 2, &error));
    assert_true(snapshot_write(folder, "box", &picture, path, &error));
    assert_true(snapshot_write(folder, "box", &picture, path, &error));
    assert_true(file_exists(folder, "box-0001.bmp") && file_exists(folder, "box-0003.bmp"));
    assert_non_null(strstr(path, "/box-0003.bmp"));
    remove_from_folder(folder, "box-0001.bmp");
    remove_from_folder(folder, "box-0002.bmp");
    remove_from_folder(folder, "box-0003.bmp");
    assert_int_equal(rmdir(folder), 0);
    assert_false(snapshot_write(folder, "box", &picture, path, &error));
    assert_int_equal(error.status, STATUS_FAILED);
    picture_deinit(&picture);
}

/** Too long a folder name is reported. */
static void test_snapshot_long_path(void **state) {
    (void)state;
    char path[NUMBERED_FILE_PATH_SIZE], folder[NUMBERED_FILE_PATH_SIZE];
    memset(folder, 'x', sizeof folder);
    folder[sizeof folder - 1] = '\0';
    Picture picture = {0};
    Error error = {0};
    assert_false(snapshot_write(folder, "box", &picture, path, &error));
    assert_non_null(strstr(error.message, "too long"));
}

/** Pixels of the screen are converted to those of a picture. */
static void test_snapshot_convert(void **state) {
    (void)state;
    static const uint8_t bgrx[] = {1, 2, 3, 255, 4, 5, 6, 255};
    static const uint8_t rgb[] = {3, 2, 1, 6, 5, 4};
    Picture picture = {0};
    assert_true(picture_init(&picture, 2, 1, NULL));
    snapshot_from_bgrx(bgrx, &picture);
    assert_memory_equal(picture.pixels, rgb, sizeof rgb);
    picture_deinit(&picture);
}

/** @return A scene with a camera at the origin that looks along +x, and one light. */
static Scene *make_scene(void) {
    Scene *scene = scene_create(NULL);
    assert_non_null(scene);
    scene->camera =
        (SceneCamera){.direction = {1, 0, 0}, .up = {0, 1, 0}, .fov = 60, .target_distance = 10};
    scene->has_camera = true;
    SceneLight light = *(const SceneLight *)scene_light_keyword.defaults;
    assert_true(scene_add_light(scene, &light, NULL));
    return scene;
}

/** Fails unless a point is where it should be. */
static void assert_point(Vec3d point, double x, double y, double z) {
    assert_near(point.x, x);
    assert_near(point.y, y);
    assert_near(point.z, z);
}

/** Light and camera move along the axes of the picture, and are reset. */
static void test_view_state(void **state) {
    (void)state;
    Scene *scene = make_scene();
    ViewState home_view;
    assert_true(view_state_init(&home_view, scene, NULL));
    assert_point(home_view.up_axis, 0, 1, 0);
    view_state_move(&home_view, scene, 0, (Movement){.right = 1, .up = 2, .forward = 3},
                    (Movement){.right = 2}, MOTION_FLY);
    assert_point(scene->lights[0].position, 15, 1.9 + 10, 5);
    assert_point(scene->camera.position, 0, 0, 10);
    view_state_move(&home_view, scene, 7, (Movement){.up = 1}, (Movement){.up = 1, .forward = -1},
                    MOTION_FLY);
    assert_point(scene->lights[0].position, 15, 1.9 + 10, 5);
    assert_point(scene->camera.position, -5, 5, 10);
    view_state_reset(&home_view, scene);
    assert_point(scene->lights[0].position, 0, 1.9, 0);
    assert_point(scene->camera.position, 0, 0, 0);
    view_state_deinit(&home_view);
    scene_destroy(scene);
}

/** @return Where a point lies in the picture: right, up and ahead of the camera. */
static Vec3d in_picture(const SceneCamera *camera, Vec3d point) {
    Vec3d offset = vec3d_subtract(point, camera->position);
    return (Vec3d){vec3d_dot(offset, scene_camera_right(camera)), vec3d_dot(offset, camera->up),
                   vec3d_dot(offset, camera->direction)};
}

/** A camera that orbits keeps its point at its pixel and distance. */
static void test_orbit(void **state) {
    (void)state;
    Scene *scene = make_scene();
    SceneCamera *camera = &scene->camera;
    const Vec3d up = {0, 1, 0}, center = {8, 1, -2};
    const Vec3d before = in_picture(camera, center);
    scene_camera_orbit(camera, up, center, 30, -20);
    Vec3d after = in_picture(camera, center);
    assert_point(after, before.x, before.y, before.z);
    assert_true(vec3d_length(camera->position) > 1);
    assert_true(camera->position.y > 1 && camera->direction.y < 0);
    scene_camera_orbit(camera, up, (Vec3d){8, 0, 0}, 0, -1000);
    assert_true(fabs(camera->direction.y) < 1);
    scene_destroy(scene);
}

/** The speed of keys follows the scene's size, but an unset one the camera's distance. */
static void test_move_speed(void **state) {
    (void)state;
    Scene *scene = make_scene();
    assert_near(view_state_move_speed(scene), 5); // A lamp alone has no size.
    SceneLight light = *(const SceneLight *)scene_light_keyword.defaults;
    light.position = (Vec3d){0, 1.9, 4};
    assert_true(scene_add_light(scene, &light, NULL));
    assert_near(view_state_move_speed(scene), 1);
    ViewState home_view;
    assert_true(view_state_init(&home_view, scene, NULL));
    view_state_move(&home_view, scene, 0, (Movement){.up = 0.5}, (Movement){.right = 2},
                    MOTION_FLY);
    assert_point(scene->lights[0].position, 0, 1.9 + 0.5, 0);
    assert_point(scene->camera.position, 0, 0, 2);
    home_view.move_speed = 0;
    view_state_move(&home_view, scene, 0, (Movement){.up = 0.5}, (Movement){0}, MOTION_FLY);
    assert_point(scene->lights[0].position, 0, 1.9 + 0.5 + 2.5, 0);
    view_state_deinit(&home_view);
    scene->lights[1].position.z = 1000; // Half the distance to what the camera looks at.
    assert_near(view_state_move_speed(scene), 5);
    scene_destroy(scene);
}

/** What was moved is put back; what was not is as the scene has it now, which may be another time.
 */
static void test_restored_view(void **state) {
    (void)state;
    Scene *scene = make_scene();
    ViewState home_view, saved;
    assert_true(view_state_init(&home_view, scene, NULL));
    const SceneCamera camera = scene->camera;
    view_state_move(&home_view, scene, 0, (Movement){.right = 1}, (Movement){0}, MOTION_FLY);
    const Vec3d moved = scene->lights[0].position;
    assert_true(view_state_save_current(&saved, &home_view, scene, NULL));
    scene->lights[0].intensity = home_view.lights[0].intensity = 0.125;
    home_view.camera.fov = 31;
    view_state_move(&home_view, scene, 0, (Movement){.up = 1}, (Movement){.up = 1}, MOTION_FLY);
    view_state_restore_current(&saved, &home_view, scene);
    assert_memory_equal(&scene->lights[0].position, &moved, sizeof moved);
    assert_true(scene->lights[0].intensity == 0.125 && home_view.is_light_moved[0]);
    assert_true(scene->camera.fov == 31 && !home_view.is_camera_moved);
    assert_memory_equal(&scene->camera.position, &camera.position, sizeof camera.position);
    view_state_deinit(&saved);
    view_state_deinit(&home_view);
    scene_destroy(scene);
}

/**
 * Whoever walks stays at one height, to the bit, however the camera is tilted or rolled, also
 * where it looks straight down or up. Up is straight up. Whoever flies sinks.
 */
static void test_walking(void **state) {
    (void)state;
    static const Vec3d directions[] = {{0.3, -0.7, -0.6}, {0.3, 0.7, -0.6}, {0, -1, 0},
                                       {0, 1, 0},         {1e-9, -1, 0},    {-0.4, 0, 0.9}};
    for (size_t i = 0; i < sizeof directions / sizeof *directions; i++) {
        Error error = {0};
        Scene *scene = make_scene();
        ViewState home_view;
        scene->camera.position = (Vec3d){0.1, 2.3, 0.7};
        scene->camera.direction = directions[i];
        scene->camera.up = (Vec3d){0.2, 1, 0.1};
        assert_true(scene_camera_keyword.finish(&scene->camera, 0, &error));
        assert_true(view_state_init(&home_view, scene, NULL));
        Vec3d from = scene->camera.position, ahead = scene->camera.direction;
        Vec3d top = scene->camera.up;
        double height = from.y, sign = ahead.y > 0 ? -1 : 1;
        for (int step = 0; step < 100; step++) {
            view_state_move(&home_view, scene, 7, (Movement){0},
                            (Movement){.forward = 0.016, .right = step % 2 ? 0.01 : -0.01},
                            MOTION_WALK);
            assert_true(scene->camera.position.y == height);
        }
        // It went forward: along the horizontal part of its direction, or to the top of a map.
        Vec3d way = vec3d_subtract(scene->camera.position, from);
        Vec3d expected = hypot(ahead.x, ahead.z) > 1e-6 ? (Vec3d){ahead.x, 0, ahead.z}
                                                        : (Vec3d){sign * top.x, 0, sign * top.z};
        double units = 100 * 0.016 * 0.5 * scene->camera.target_distance;
        expected = vec3d_scale(vec3d_normalize(expected), units);
        assert_near(way.x, expected.x);
        assert_near(way.z, expected.z);
        from = scene->camera.position;
        view_state_move(&home_view, scene, 7, (Movement){0}, (Movement){.up = 1}, MOTION_WALK);
        assert_point(vec3d_subtract(scene->camera.position, from), 0,
                     0.5 * scene->camera.target_distance, 0);
        from = scene->camera.position;
        view_state_move(&home_view, scene, 7, (Movement){0}, (Movement){.forward = 1}, MOTION_FLY);
        way = vec3d_scale(ahead, 0.5 * scene->camera.target_distance);
        assert_point(vec3d_subtract(scene->camera.position, from), way.x, way.y, way.z);
        view_state_deinit(&home_view);
        scene_destroy(scene);
    }
}

/** Objects that the user moved stay there at other times, until they are reset. */
static void test_view_state_renew(void **state) {
    (void)state;
    const SceneLight light = {.position = {7, 7, 7}, .intensity = 9};
    Error error = {0};
    for (int moved = 0; moved < 2; moved++) {
        Scene *before = make_scene(), *after = make_scene();
        assert_true(scene_add_light(after, &light, &error));
        after->camera.position = (Vec3d){4, 5, 6};
        after->lights[0].position = (Vec3d){1, 2, 3};
        after->lights[0].intensity = 0.5;
        ViewState view_state;
        assert_true(view_state_init(&view_state, before, NULL));
        if (moved) {
            view_state_move(&view_state, before, 0, (Movement){.up = 1}, (Movement){.right = 2},
                            MOTION_FLY);
        }
        Vec3d eye = moved ? before->camera.position : after->camera.position;
        Vec3d light_position = moved ? before->lights[0].position : after->lights[0].position;
        assert_true(view_state_transfer(&view_state, before, after, &error));
        assert_point(after->camera.position, eye.x, eye.y, eye.z);
        assert_point(after->lights[0].position, light_position.x, light_position.y,
                     light_position.z);
        assert_near(after->lights[0].intensity, 0.5);
        assert_point(after->lights[1].position, 7, 7, 7);
        view_state_reset(&view_state, after);
        assert_point(after->camera.position, 4, 5, 6);
        assert_point(after->lights[0].position, 1, 2, 3);
        assert_true(view_state_transfer(&view_state, after, before, &error));
        assert_false(view_state.is_camera_moved || view_state.is_light_moved[0]);
        view_state_deinit(&view_state);
        scene_destroy(before);
        scene_destroy(after);
    }
}

/** The time pauses, runs and steps, by milliseconds. */
static void test_time_control(void **state) {
    (void)state;
    Timeline timeline = {.time = 1.5};
    assert_true(timeline_time_at(&timeline, 100) == 1.5);
    timeline_run(&timeline, 100);
    assert_true(timeline_time_at(&timeline, 100.1234567) == 1.623);
    timeline_run(&timeline, 100.5);
    assert_true(timeline_time_at(&timeline, 101) == 2.5);
    timeline_pause(&timeline, 101.25);
    assert_true(timeline_time_at(&timeline, 200) == 2.75);
    timeline_step(&timeline, -2, 300);
    assert_true(timeline_time_at(&timeline, 400) == 2.67);
    timeline = (Timeline){.time = 0};
    for (int i = 1; i < 1000; i++) {
        timeline_step(&timeline, 1, 0);
        assert_true(timeline.time == i / 25.0); // Exactly the time of a film's frame.
    }
    timeline = (Timeline){.time = 1e300, .is_running = true};
    assert_true(timeline_time_at(&timeline, 5) == 1e300);
}

/** The up axis comes from the camera, unless it looks steeply. */
static void test_view_state_vertical(void **state) {
    (void)state;
    static const Vec3d rows[][3] = {/* direction, up, vertical */
                                    {{0.6, -0.64, 0.48}, {0.5, 0.768, 0.4}, {0, 1, 0}},
                                    {{0, -1, 0}, {0, 0, -1}, {0, 1, 0}},
                                    {{1, 0, 0}, {0, 0, 1}, {0, 0, 1}},
                                    {{1, 0, 0}, {0, -1, 0}, {0, -1, 0}},
                                    {{0, 0, 1}, {-1, 0, 0}, {-1, 0, 0}}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        Scene *scene = make_scene();
        scene->camera.direction = rows[i][0];
        scene->camera.up = rows[i][1];
        ViewState view_state;
        assert_true(view_state_init(&view_state, scene, NULL));
        assert_point(view_state.up_axis, rows[i][2].x, rows[i][2].y, rows[i][2].z);
        view_state_deinit(&view_state);
        scene_destroy(scene);
    }
}

/** Camera and lights are printed as the scene language writes them. */
static void test_scene_text(void **state) {
    (void)state;
    Scene *scene = make_scene();
    scene->camera.position = (Vec3d){0.1, -2, 1e-30};
    char text[1024] = "";
    FILE *file = fmemopen(text, sizeof text, "w");
    assert_non_null(file);
    scene_text_print(scene, file);
    fclose(file);
    scene_destroy(scene);
    assert_string_equal(text, "camera { position = {0.1, -2, 1e-30}, "
                              "direction = {1, 0, 0}, up = {0, 1, 0}, fov = 60 }  "
                              "light { position = {0, 1.9, 0}, color = {1, 1, 1}, intensity = 1, "
                              "falloff = \"none\", falloff_constant = 2, radius = 0 }");
}

/** The title shows pass and speed. */
static void test_title(void **state) {
    (void)state;
    RenderStats report = {.seconds = 0.0123,
                          .rays = {.camera = 500000, .reflection = 45500, .shadow = 500000},
                          .stride = 1,
                          .samples = 6};
    TitleContent content = {
        .name = "box", .width = 800, .height = 600, .status_text = "", .light_count = 1};
    char title[TITLE_SIZE];
    title_write(&content, title);
    assert_string_equal(title, "box — 800×600");
    content.report = &report;
    title_write(&content, title);
    assert_string_equal(title, "box — 800×600, pass 1 px, 6 samples, 12.3 ms, 85 Mrays/s");
    report.is_finished = true;
    content.light_count = 3;
    content.light = 1;
    content.status_text = "saved x.bmp";
    title_write(&content, title);
    assert_string_equal(title, "box — 800×600, pass 1 px, 6 samples, 12.3 ms, 85 Mrays/s, finished"
                               " — light 2 of 3 — saved x.bmp");
    // Where there is little room the message is whole, and not what the picture costs.
    content.room = 60;
    title_write(&content, title);
    assert_string_equal(title, "box — 800×600, pass 1 px, finished — light 2 of 3 — saved x.bmp");
    content.room = 120;
    title_write(&content, title);
    assert_non_null(strstr(title, "85 Mrays/s"));
    report.rays.unresolved = 60000;
    content.status_text = "";
    title_write(&content, title);
    assert_string_equal(title, "box — 800×600, pass 1 px, 6 samples, 12.3 ms, 85 Mrays/s, finished"
                               ", 12 % lack light — light 2 of 3");
    const double time = 3.04;
    content = (TitleContent){.name = "box",
                             .width = 8,
                             .height = 6,
                             .status_text = "",
                             .time = &time,
                             .is_running = true};
    title_write(&content, title);
    assert_string_equal(title, "box — 8×6 — t 3.04 s, running");
    char name[2 * TITLE_SIZE];
    memset(name, 'n', sizeof name);
    name[sizeof name - 1] = '\0';
    content.name = name;
    title_write(&content, title);
    assert_int_equal(strlen(title), TITLE_SIZE - 1);
}

/** @return What stands in the row of a panel that has a label. */
static const char *hud_text(const Hud *hud, const char *label) {
    for (size_t i = 0; i < hud->count; i++) {
        if (strcmp(hud->rows[i].label, label) == 0) {
            return hud->row_texts[i];
        }
    }
    fail_msg("no row %s", label);
    return "";
}

/** The panel tells the time until all pixels had a ray from that of the picture, which the title
 *  has. */
static void test_times(void **state) {
    (void)state;
    Error error = {0};
    Viewport viewport = {.settings = {.engine = engine_find("f64x1", &error), .samples = 4},
                         .report = {.seconds = 2.1568,
                                    .rays = {.camera = 1000},
                                    .stride = 1,
                                    .samples = 4,
                                    .is_finished = true},
                         .render_seconds = 0.3317};
    const HudContent content = {.viewport = &viewport, .shows_settings = true};
    const TitleContent title_content = {
        .name = "box", .width = 8, .height = 6, .status_text = "", .report = &viewport.report};
    Hud hud = {0};
    char title[TITLE_SIZE];
    hud_update(&hud, &content, 1);
    title_write(&title_content, title);
    assert_string_equal(hud_text(&hud, "first pass"), "331.7 ms");
    assert_string_equal(hud_text(&hud, "in all"), "2156.8 ms");
    assert_non_null(strstr(title, "4 samples, 2156.8 ms,"));
    viewport.previous_render_seconds = 0.5;
    hud_update(&hud, &content, 2);
    assert_string_equal(hud_text(&hud, "first pass"), "331.7 ms, −168.3 (× 0.66)");
}

/** Settings that were tried have one point each; the front is what none beats in time and error. */
static void test_settings_chart(void **state) {
    (void)state;
    SettingsChart chart = {.count = 0};
    Error error = {0};
    RenderSettings settings = {.engine = engine_find("f32x4", &error),
                               .samples = 16,
                               .trace = {.depth = 8, .offset = OFFSET_FIXED, .epsilon = 1e-4}};
    RenderSettings precise = settings, slow = settings, as_fast = settings;
    precise.engine = engine_find("f64x1", &error);
    slow.samples = 64;
    as_fast.trace.offset = OFFSET_BOUND;
    settings_chart_add(&chart, &settings, 1, 2);
    settings_chart_add(&chart, &precise, 2, 1);
    settings_chart_add(&chart, &slow, 3, 1.5);
    settings_chart_add(&chart, &as_fast, 2.05, 1.001);
    assert_true(chart.points[0].is_pareto && chart.points[1].is_pareto);
    assert_false(chart.points[2].is_pareto || chart.points[3].is_pareto);
    settings_chart_add(&chart, &slow, 3, 0.5);
    assert_int_equal((int)chart.count, 4);
    assert_true(chart.points[2].is_pareto && settings_chart_has(&chart, &slow));
    for (int i = 0; i < SETTINGS_CHART_POINTS; i++) {
        RenderSettings other = settings;
        other.trace.depth = 9 + i;
        settings_chart_add(&chart, &other, i + 1, 1);
    }
    assert_int_equal((int)chart.count, SETTINGS_CHART_POINTS);
    assert_false(settings_chart_has(&chart, &slow));
    // The oldest are gone.
    assert_int_equal(chart.points[0].settings.trace.depth, 9);
    assert_int_equal(chart.points[SETTINGS_CHART_POINTS - 1].settings.trace.depth,
                     9 + SETTINGS_CHART_POINTS - 1);
    char name[SETTINGS_NAME_SIZE];
    settings_name_write(&settings, name);
    assert_string_equal(name, "float, fixed 0.0001, 8 × 16");
}

/** The error of settings is measured in a thread: depth 0 is farther from the reference than the
 *  scene's own; a reset forgets the reference. */
static void test_error_meter(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    RenderSettings settings = render_settings_default(scene);
    Error error = {0};
    ErrorMeter meter = {.event = SDL_USEREVENT};
    double errors[2] = {0, 0};
    settings.samples = 4;
    for (int i = 0; i < 2; i++) {
        settings.trace.depth = i == 0 ? 8 : 0;
        assert_true(error_meter_start(&meter, scene, &settings, &error));
        while (!error_meter_take(&meter, &errors[i])) {
            SDL_Delay(1);
        }
        assert_true(meter.has_truth && !meter.is_busy);
    }
    assert_true(errors[0] > 0 && errors[1] > 2 * errors[0]);
    assert_true(error_meter_start(&meter, scene, &settings, &error));
    error_meter_reset(&meter);
    assert_false(meter.has_truth || meter.is_busy || error_meter_take(&meter, &errors[0]));
    scene_destroy(scene);
}

/** The magnifier follows the mouse, until keys move it; it stays in the picture. */
static void test_magnifier(void **state) {
    (void)state;
    Magnifier magnifier = {0};
    const PixelPosition mouse = {5, 6}, other = {7, 6};
    magnifier_toggle(&magnifier);
    magnifier_follow(&magnifier, NULL, 80, 60);
    assert_true(magnifier.is_on && magnifier.pixel.x == 40 && magnifier.pixel.y == 30);
    magnifier_follow(&magnifier, &mouse, 80, 60);
    assert_true(magnifier.pixel.x == 5 && magnifier.pixel.y == 6);
    magnifier_step(&magnifier, -10, 1);
    magnifier_follow(&magnifier, &mouse, 80, 60);
    assert_true(magnifier.pixel.x == 0 && magnifier.pixel.y == 7);
    magnifier_step(&magnifier, 100, 100);
    magnifier_follow(&magnifier, NULL, 80, 60);
    assert_true(magnifier.pixel.x == 79 && magnifier.pixel.y == 59);
    magnifier_follow(&magnifier, &other, 80, 60);
    assert_true(magnifier.pixel.x == 7 && magnifier.pixel.y == 6);
    magnifier_toggle(&magnifier);
    assert_false(magnifier.is_on);
}

/** Words of scene files have names for readers; a word without one is its own name. */
static void test_scene_words(void **state) {
    (void)state;
    assert_string_equal(scene_word("ior"), "refractive index");
    assert_string_equal(scene_word("quad"), "quadrilateral");
    assert_string_equal(scene_word("a new shape"), "a new shape");
    // No name says a word of the scene language that readers do not: they have no underscores.
    for (int i = 0; scene_object_keyword(i); i++) {
        const Parameter *row;
        assert_null(strchr(scene_word(scene_object_keyword(i)->name), '_'));
        for (int j = 0; (row = scene_object_row(i, j)); j++) {
            assert_null(strchr(scene_word(row->name), '_'));
        }
    }
}

/** A readout has place, shape with its line, and value with unit; of two pictures the difference.
 */
static void test_readout(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    char text[READOUT_SIZE];
    PixelReadout readout = {.scene = scene,
                            .x = 3,
                            .y = 4,
                            .readings = {{.rgb = {1, 2, 3}, .shape = 5, .distance = 2}},
                            .count = 1};
    pixel_readout_write(&readout, text);
    assert_string_equal(text, "pixel (3, 4) under the mouse, sphere (line 35 of the scene), "
                              "colour 1 2 3 of 255");
    readout.samples = 16;
    pixel_readout_write(&readout, text);
    assert_non_null(strstr(text, "of 255 (mean of up to 16 samples)"));
    readout.readings[0].layer = readout.readings[1].layer = LAYER_SHAPES;
    readout.readings[0].values[0] = 5; // The index would contradict the name.
    pixel_readout_write(&readout, text);
    assert_string_equal(text,
                        "pixel (3, 4) under the mouse, shapes: sphere (line 35 of the scene)");
    readout.readings[1].shape = 3;
    readout.readings[1].values[0] = 3;
    readout.count = 2;
    pixel_readout_write(&readout, text);
    assert_string_equal(text,
                        "pixel (3, 4) under the mouse\n"
                        "left: shapes: sphere (line 35 of the scene)\n"
                        "right: shapes: quadrilateral 4 (line 24 of the scene)\nnot the same");
    readout.readings[0].layer = readout.readings[1].layer = LAYER_DISTANCE;
    readout.readings[0].values[0] = 2;
    readout.readings[1].values[0] = 2.5;
    readout.count = 2;
    readout.is_magnified = true;
    pixel_readout_write(&readout, text);
    assert_string_equal(text, "pixel (3, 4) in the magnifier, sphere (line 35 of the scene)\n"
                              "left: distance: 2 scene units\nright: distance: 2.5 scene units\n"
                              "left minus right: −0.5 scene units");
    readout.readings[1].layer = LAYER_RAYS;
    pixel_readout_difference(readout.readings, text);
    assert_string_equal(text, "two different layers are not compared");
    readout.readings[0].shape = 3;
    pixel_readout_write(&readout, text);
    assert_non_null(strstr(text, "quadrilateral 4 (line 24 of the scene)"));
    scene_destroy(scene);
}

/** @return The legend of a layer, of which a quarter is measured; rounding is not. */
static Legend legend_of(const Scene *scene, Layer layer, double low, double high,
                        bool is_finished) {
    Error error = {0};
    LayerMarks marks = {.count = 2};
    RenderSettings settings = render_settings_default(scene);
    settings.engine = engine_find("f32x4", &error);
    RenderStats report = {.stride = 2,
                          .is_finished = is_finished,
                          .layer = {.layer = layer,
                                    .scale = layer_scale(layer, low, high),
                                    .pixel_count = 1000,
                                    .artifact_pixels = 3,
                                    .measured_fraction = 0.25,
                                    .reference = layer == LAYER_ERROR ? "f128x1" : NULL}};
    LegendContent content = {.scene = scene,
                             .report = &report,
                             .settings = &settings,
                             .marks = &marks,
                             .progress = 0.4,
                             .cannot_round = true};
    Legend legend;
    legend_write(&content, &legend);
    return legend;
}

/** Legends say unit, scale, counts, and what is not known yet. */
static void test_legend(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    Legend light = legend_of(scene, LAYER_SHADED, 0, 0, true);
    assert_string_equal(light.title, "");
    Legend rays = legend_of(scene, LAYER_RAYS, 2, 17, true);
    assert_string_equal(rays.unit, "rays per pixel, log scale");
    assert_true(rays.has_bar && rays.entry_count == 5);
    Legend error = legend_of(scene, LAYER_ERROR, 0, 1, false);
    assert_string_equal(error.notes[0], "so far, off by over a step: 3 (0.3 %)");
    assert_string_equal(error.notes[1],
                        "reference quad (f128x1): 25 % of the pixels, 40 % of the work");
    assert_string_equal(error.notes[2], "2 places have rings");
    error = legend_of(scene, LAYER_ERROR, 0, 1, true);
    assert_string_equal(error.notes[0], "off by over a step: 3 (0.3 %)");
    assert_string_equal(error.notes[1], "reference: quad (f128x1)");
    Legend rounding = legend_of(scene, LAYER_ROUNDING, 0, 1, true);
    assert_string_equal(rounding.notes[0], "not measured: numbers round to nearest only here");
    Legend steps = legend_of(scene, LAYER_STEPS, 1, 0, true);
    assert_false(steps.has_bar);
    assert_string_equal(steps.notes[0], "no ray marches: no distance field is in view");
    Legend operations = legend_of(scene, LAYER_OPERATIONS, 1, 0, true);
    assert_string_equal(operations.notes[0], steps.notes[0]);
    Legend time = legend_of(scene, LAYER_TIME, 1, 9, true);
    assert_string_equal(time.notes[0], "one number per block of 8 × 8 pixels");
    Legend shapes = legend_of(scene, LAYER_SHAPES, 0, 7, true);
    assert_string_equal(shapes.texts[5], "sphere (line 35 of the scene)");
    assert_int_equal((int)shapes.entry_count, (int)scene->shape_count);
    scene_destroy(scene);
}

/** A window opens on an invisible screen, and closes when requested. */
static void test_window(void **state) {
    (void)state;
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    assert_true(view_is_possible());
    Scene *scene = make_scene();
    ViewSettings settings = {
        .render = render_settings_default(scene), .path = "test.lua", .snapshot_dir = "/nowhere"};
    atomic_bool stop = true;
    Error error = {0};
    assert_int_equal(view_run(scene, &settings, &stop, &error), STATUS_INTERRUPTED);
    setenv("SDL_VIDEODRIVER", "no such driver", 1);
    assert_false(view_is_possible());
    assert_int_equal(view_run(scene, &settings, &stop, &error), STATUS_FAILED);
    assert_non_null(strstr(error.message, "no display to open a window on"));
    scene_destroy(scene);
}

/** The requests of a window for scenes. */
typedef struct LoadRequests {
    char path[64];    /**< The newest file; empty: none. */
    atomic_int count; /**< Number of requests. */
} LoadRequests;

/** Loads a scene. See #ViewLoader. @return A scene; NULL for `wrong.lua`. */
static Scene *load_requested(void *context, const ViewRequest *request, const atomic_bool *stop,
                             RenderSettings *render, RenderSettings *own, Lesson **lesson,
                             Error *error) {
    (void)stop, (void)lesson;
    LoadRequests *requests = context;
    snprintf(requests->path, sizeof requests->path, "%s", request->path ? request->path : "");
    requests->count++;
    if (strcmp(requests->path, "wrong.lua") == 0) {
        error_set(error, STATUS_SCENE, "wrong.lua:1: all of it");
        return NULL;
    }
    Scene *scene = make_scene();
    *render = *own = render_settings_default(scene);
    return scene;
}

/**
 * The thread that drops two files on the window, each after the previous one was requested, then
 * closes it.
 * @return NULL
 */
static void *drop_two_files(void *context) {
    LoadRequests *requests = context;
    static const char *const files[] = {"other.lua", "wrong.lua"};
    SDL_Delay(300); // The window does not exist yet, so its state cannot be queried.
    for (int i = 0; i < 2; i++) {
        SDL_Event event = {.drop = {.type = SDL_DROPFILE, .file = SDL_strdup(files[i])}};
        SDL_PushEvent(&event);
        for (int wait = 0; wait < 500 && atomic_load(&requests->count) <= i; wait++) {
            SDL_Delay(20);
        }
    }
    SDL_Event event = {.type = SDL_QUIT};
    SDL_PushEvent(&event);
    return NULL;
}

/** A dropped scene is shown; a faulty one leaves the previous scene. */
static void test_drop(void **state) {
    (void)state;
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    Scene *scene = make_scene();
    LoadRequests requests = {0};
    ViewSettings settings = {.render = render_settings_default(scene),
                             .path = "test.lua",
                             .snapshot_dir = "/nowhere",
                             .load = load_requested,
                             .loader_context = &requests};
    pthread_t dropper;
    assert_int_equal(pthread_create(&dropper, NULL, drop_two_files, &requests), 0);
    Error error = {0};
    assert_int_equal(view_run(scene, &settings, NULL, &error), STATUS_OK);
    pthread_join(dropper, NULL);
    assert_int_equal(requests.count, 2);
    assert_string_equal(requests.path, "wrong.lua");
    scene_destroy(scene);
}

/** The thread that lays two fingers on the window, spreads and moves them, then closes it. @return
 *  NULL */
static void *pinch(void *context) {
    (void)context;
    static const float places[][3] = {{0.5F, 0.5F, 0}, {0.6F, 0.5F, 0}, {0.6F, 0.5F, 0.1F}};
    SDL_Delay(300); // The window does not exist yet, so its state cannot be queried.
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        SDL_Event event = {.mgesture = {.type = SDL_MULTIGESTURE,
                                        .numFingers = 2,
                                        .x = places[i][0],
                                        .y = places[i][1],
                                        .dDist = places[i][2]}};
        SDL_PushEvent(&event);
        // One of the fingers is a mouse, too: it must not turn the camera meanwhile.
        SDL_Event mouse = {.motion = {.type = SDL_MOUSEMOTION,
                                      .state = SDL_BUTTON_LMASK,
                                      .x = 100 + 50 * (int)i,
                                      .y = 100,
                                      .xrel = 50}};
        SDL_PushEvent(&mouse);
    }
    SDL_Event three = {.mgesture = {.type = SDL_MULTIGESTURE, .numFingers = 3, .dDist = 1}};
    SDL_PushEvent(&three);
    SDL_Event event = {.type = SDL_QUIT};
    SDL_PushEvent(&event);
    return NULL;
}

/** Two fingers pan by their middle and zoom by their distance; they do not turn the camera. */
static void test_two_fingers(void **state) {
    (void)state;
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    Scene *scene = make_scene();
    const SceneCamera before = scene->camera;
    ViewSettings settings = {
        .render = render_settings_default(scene), .path = "test.lua", .snapshot_dir = "/nowhere"};
    pthread_t fingers;
    assert_int_equal(pthread_create(&fingers, NULL, pinch, NULL), 0);
    Error error = {0};
    assert_int_equal(view_run(scene, &settings, NULL, &error), STATUS_OK);
    pthread_join(fingers, NULL);
    // A tenth of the picture's width at the target, against the fingers: it follows them.
    double shift = vec3d_dot(vec3d_subtract(scene->camera.position, before.position),
                             scene_camera_right(&before));
    double width = 2 * before.target_distance * tan(before.fov / 2 * M_PI / 180);
    assert_at_most(fabs(shift + width / 10), 0.01 * width, "moved by %g of %g", shift, width);
    assert_true(vec3d_max_abs(vec3d_subtract(scene->camera.direction, before.direction)) == 0);
    // Three notches of the wheel, each a tenth of the picture.
    assert_at_most(fabs(tan(scene->camera.fov * M_PI / 360) / tan(M_PI / 6) - pow(0.9, 3)), 1e-6,
                   "fov %g", scene->camera.fov);
    scene_destroy(scene);
}

/** Moves and edits are undone in the order in which they were made. */
static void test_view_history(void **state) {
    (void)state;
    Scene *scene = make_scene();
    ViewState home;
    ViewHistory history = {.count = 0};
    const Movement right = {.right = 1}, none = {.right = 0};
    PictureChoice choice = {.active = 0};
    const ViewTarget target = {&home, scene, &choice};
    assert_true(view_state_init(&home, scene, NULL));
    assert_false(view_history_undo(&history, &target, 0));
    // Two moves of one key, then the camera at once, then one edit, then the light again.
    const double times[] = {1, 1.2, 1.3, 20};
    for (size_t i = 0; i < 4; i++) {
        const ViewStep step = {.edits = i == 3, .subject = i == 2 ? VIEW_SUBJECT_ALL : 0};
        view_history_note(&history, &home, scene, &step, times[i]);
        view_state_move(&home, scene, 0, i == 2 ? none : right, i == 2 ? right : none, MOTION_FLY);
    }
    assert_int_equal(history.count, 3);
    Vec3d light = scene->lights[0].position, camera = scene->camera.position;
    assert_false(view_history_undo(&history, &target, 0)); // The edit comes first.
    assert_true(view_history_undo(&history, &target, 1));
    assert_false(view_history_undo(&history, &target, 1)); // Now the edit is the last.
    assert_true(view_history_undo(&history, &target, 0));
    assert_point(scene->camera.position, 0, 0, 0);
    assert_true(home.is_light_moved[0] && !home.is_camera_moved);
    assert_true(view_history_undo(&history, &target, 0));
    assert_point(scene->lights[0].position, home.lights[0].position.x, home.lights[0].position.y,
                 home.lights[0].position.z);
    assert_true(view_history_redo(&history, &target, 0));
    assert_true(view_history_redo(&history, &target, 0));
    assert_point(scene->camera.position, camera.x, camera.y, camera.z);
    assert_false(view_history_redo(&history, &target, 0)); // The edit comes first.
    assert_true(view_history_redo(&history, &target, 1));
    assert_point(scene->lights[0].position, light.x, light.y, light.z);
    // A new move forgets what was undone; the oldest moves go.
    assert_true(view_history_undo(&history, &target, 1));
    for (int i = 0; i < 2 * VIEW_STEPS_MAXIMUM; i++) {
        view_history_note(&history, &home, scene, &(ViewStep){.edits = 1}, 100 + i);
    }
    assert_int_equal(history.count, VIEW_STEPS_MAXIMUM);
    assert_false(view_history_redo(&history, &target, 1));
    view_history_clear(&history);
    view_state_deinit(&home);
    scene_destroy(scene);
}

/* --- objects ---------------------------------------------------------------------------------- */

/** @return An edit of a sphere. @param row A row with one number. */
static SceneOverride sphere_edit(int number, const char *row, double value) {
    int keyword = scene_object_keyword_find("sphere");
    return (SceneOverride){keyword, number, scene_object_row_find(keyword, row), {value}};
}

/** Adds an edit. */
static void add_edit(EditHistory *history, SceneOverride edit, bool continues) {
    Error error = {0};
    assert_true(edit_history_add(history, &edit, continues, &error));
}

/** @return The value in force of a sphere's radius; 0: none. */
static double radius_in_force(const EditHistory *history, int number) {
    const SceneOverride field = sphere_edit(number, "radius", 0);
    const SceneOverride *found = edit_history_find(history, &field);
    return found ? found->numbers[0] : 0;
}

/** A group of edits is undone and done again at once; a new edit forgets what was undone. */
static void test_edit_history(void **state) {
    (void)state;
    EditHistory history = {0};
    SceneOverride overrides[SCENE_OVERRIDES_MAXIMUM];
    assert_false(edit_history_undo(&history));
    assert_false(edit_history_redo(&history));
    add_edit(&history, sphere_edit(1, "radius", 2), true);
    add_edit(&history, sphere_edit(2, "radius", 3), false);
    add_edit(&history, sphere_edit(1, "radius", 4), true);
    add_edit(&history, sphere_edit(2, "radius", 5), true);
    assert_int_equal(history.count, 3); // The last one replaces one of its group.
    assert_int_equal(edit_history_overrides(&history, overrides), 2);
    assert_true(overrides[0].numbers[0] == 4 && overrides[1].numbers[0] == 5);
    uint64_t revision = history.revision;
    assert_true(edit_history_undo(&history));
    assert_true(history.revision > revision);
    assert_true(radius_in_force(&history, 1) == 2 && radius_in_force(&history, 2) == 0);
    assert_true(edit_history_redo(&history));
    assert_true(radius_in_force(&history, 1) == 4 && radius_in_force(&history, 2) == 5);
    assert_true(edit_history_undo(&history));
    add_edit(&history, sphere_edit(3, "radius", 6), false);
    assert_false(edit_history_redo(&history));
    assert_true(edit_history_undo(&history) && edit_history_undo(&history));
    assert_false(edit_history_undo(&history));
    assert_int_equal(edit_history_overrides(&history, overrides), 0);
    edit_history_deinit(&history);
}

/** Once the file has other values, undo leads back to those that it had. */
static void test_edit_originals(void **state) {
    (void)state;
    Error error = {0};
    EditHistory history = {0};
    SceneOverride overrides[SCENE_OVERRIDES_MAXIMUM];
    const SceneOverride original = sphere_edit(1, "radius", 1), other = sphere_edit(1, "radius", 7);
    assert_true(edit_history_keep_original(&history, &original, &error));
    add_edit(&history, sphere_edit(1, "radius", 2), false);
    assert_true(edit_history_keep_original(&history, &other, &error));
    assert_true(edit_history_undo(&history));
    assert_int_equal(edit_history_overrides(&history, overrides), 0);
    assert_true(edit_history_redo(&history));
    edit_history_wake_originals(&history, original.keyword, 1);
    assert_true(radius_in_force(&history, 1) == 2);
    assert_true(edit_history_undo(&history));
    assert_true(radius_in_force(&history, 1) == 1);
    assert_false(edit_history_undo(&history));
    edit_history_deinit(&history);
}

/** Edits are checked as a scene file's own values, alone and with the object's other values. */
static void test_edit_check(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    int box = scene_object_keyword_find("box"), material = scene_object_keyword_find("material");
    SceneObject object;
    Error error = {0};
    assert_true(scene_object_find(scene, box, 1, &object));
    assert_int_equal(object.origin->number, 1);
    assert_true(object.origin->line > 0);
    double low[3];
    int low_row = scene_object_row_find(box, "min"), high_row = scene_object_row_find(box, "max");
    scene_object_get(&object, low_row, low);
    const SceneOverride edits[] = {{box, 1, high_row, {low[0], 10, 10}},
                                   {box, 1, low_row, {low[0] - 1, low[1], low[2]}},
                                   {box, 2, low_row, {NAN, 0, 0}}};
    assert_false(scene_override_check(&object, edits, 1, &error));
    assert_string_equal(error.message, "box needs min below max in x, y and z");
    assert_true(scene_override_check(&object, edits, 3, &error));
    const SceneOverride scale = {box, 1, scene_object_row_find(box, "scale"), {0, 1, 1}};
    assert_false(scene_override_check(&object, &scale, 1, &error));
    assert_true(scene_object_find(scene, material, 1, &object));
    const SceneOverride wrong[] = {
        {material, 1, scene_object_row_find(material, "ior"), {NAN}},
        {material, 1, scene_object_row_find(material, "color"), {2, 0, 0}},
        {material, 1, scene_object_row_find(material, "texture"), {1}},
        {material, 1, 1000, {1}}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_false(scene_override_check(&object, &wrong[i], 1, &error));
    }
    assert_false(scene_object_find(scene, box, 0, &object));
    assert_false(scene_object_find(scene, box, 99, &object));
    assert_false(scene_object_find(scene, 99, 1, &object));
    scene_destroy(scene);
}

/** A value is replaced or added in the text of a scene, and nothing else changes. */
static void test_source_edit(void **state) {
    (void)state;
    static const struct {
        const char *text;   // The scene.
        int line;           // Line of the sphere.
        const char *field;  // Its field, which gets the value 7.
        const char *wanted; // The new text; NULL: it is refused.
    } cases[] = {
        {"sphere { radius = 1 }", 1, "radius", "sphere { radius = 7 }"},
        {"sphere{radius=-1.5e3,center={1,2,3}}", 1, "radius", "sphere{radius=7,center={1,2,3}}"},
        {"sphere { center = {1, -2, 3} }", 1, "center", "sphere { center = 7 }"},
        {"sphere { center = {1, -- radius = 2\n 2, 3} }", 1, "radius",
         "sphere { center = {1, -- radius = 2\n 2, 3}, radius = 7 }"},
        {"sphere {}", 1, "radius", "sphere { radius = 7}"},
        {"sphere({ radius = 1; })", 1, "radius", "sphere({ radius = 7; })"},
        {"\r\nsphere {\r\n  radius = 1,\r\n}\r\n", 2, "radius",
         "\r\nsphere {\r\n  radius = 7,\r\n}\r\n"},
        {"sphere {\n  a = 1, -- the end\n}", 1, "radius",
         "sphere {\n  a = 1, radius = 7, -- the end\n}"},
        {"#!/usr/bin/dioptre\n--[[ sphere {\n]] sphere { radius = 1 }", 3, "radius",
         "#!/usr/bin/dioptre\n--[[ sphere {\n]] sphere { radius = 7 }"},
        {"x = 'sphere { radius = 1 }' sphere { [\"radius\"] = 1 }", 1, "radius",
         "x = 'sphere { radius = 1 }' sphere { [\"radius\"] = 7 }"},
        {"sphere { material = material { radius = 2 }, radius = 1 }", 1, "radius",
         "sphere { material = material { radius = 2 }, radius = 7 }"},
        {"sphere { f = function() if a then return { radius = 2 } end end, radius = 1 }", 1,
         "radius", "sphere { f = function() if a then return { radius = 2 } end end, radius = 7 }"},
        {"sphere { radius = r }", 1, "radius", NULL},
        {"sphere { radius = 1 + 1 }", 1, "radius", NULL},
        {"sphere { radius = ({1})[1] }", 1, "radius", NULL},
        {"sphere { center = {x, 0, 0} }", 1, "center", NULL},
        {"sphere { radius = 1, radius = 2 }", 1, "radius", NULL},
        {"sphere { [k] = 1 }", 1, "radius", NULL},
        {"sphere { radius = 1 } sphere { radius = 2 }", 1, "radius", NULL},
        {"sphere(options)", 1, "radius", NULL},
        {"my.sphere { radius = 1 }", 1, "radius", NULL},
        {"sphere { radius = 1 }", 2, "radius", NULL},
        {"sphere { radius = 'one\\'", 1, "center", "sphere { radius = 'one\\', center = 7"},
        {"", 1, "radius", NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Error error = {0};
        size_t size = 0;
        const SourceField field = {"sphere", cases[i].line, cases[i].field, "7"};
        char *text = source_edit_set(cases[i].text, strlen(cases[i].text), &field, &size, &error);
        if (!text != !cases[i].wanted || (text && strcmp(text, cases[i].wanted) != 0)) {
            fail_msg("%s\nbecomes: %s (%s)", cases[i].text, text ? text : "nothing", error.message);
        }
        assert_true(text ? size == strlen(text) : error.message[0] != '\0');
        free(text);
    }
}

/** The text of an object makes the same object again. */
static void test_object_text(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    SceneObject object;
    assert_true(scene_object_find(scene, scene_object_keyword_find("sphere"), 1, &object));
    char *text = scene_text_of_object(scene, &object);
    assert_string_equal(text, "sphere { center = {-0.8, -1.15, -0.9}, radius = 0.85, material = "
                              "material { color = {0.95, 0.05, 0.04}, specular = 0.9, shininess = "
                              "150, reflectivity = {0.42, 0.2, 0.2} } }");
    free(text);
    scene_destroy(scene);
}

/** Ctrl with a letter is a command of its own, however the letter alone is used. */
static void test_keymap_ctrl(void **state) {
    (void)state;
    const SDL_Keysym undo = {.scancode = SDL_SCANCODE_Z, .sym = SDLK_z, .mod = KMOD_LCTRL};
    const SDL_Keysym redo = {
        .scancode = SDL_SCANCODE_Z, .sym = SDLK_z, .mod = KMOD_RCTRL | KMOD_LSHIFT};
    const SDL_Keysym plain = {.scancode = SDL_SCANCODE_Z, .sym = SDLK_z};
    assert_string_equal(command_find_key(command_table, undo, false)->name, "undo");
    assert_string_equal(command_find_key(command_table, redo, false)->name, "undo back");
    assert_string_equal(command_find_key(command_table, plain, false)->name, "light nearer");
}

/** Gives SDL a keyboard, which is a US one without a screen. */
static int start_keyboard(void **state) {
    (void)state;
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    return SDL_InitSubSystem(SDL_INIT_VIDEO);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_motion_tap),
        cmocka_unit_test(test_motion_held),
        cmocka_unit_test(test_motion_opposite),
        cmocka_unit_test(test_motion_speed),
        cmocka_unit_test(test_motion_two),
        cmocka_unit_test(test_keymap_light),
        cmocka_unit_test(test_keymap_others),
        cmocka_unit_test(test_keymap_help),
        cmocka_unit_test(test_help_keys),
        cmocka_unit_test(test_keyboard_labels),
        cmocka_unit_test(test_command_table),
        cmocka_unit_test(test_toolbar_commands),
        cmocka_unit_test(test_tooltips),
        cmocka_unit_test(test_keyboards),
        cmocka_unit_test(test_light_drag),
        cmocka_unit_test(test_parts),
        cmocka_unit_test(test_settings_override),
        cmocka_unit_test(test_latency),
        cmocka_unit_test(test_latency_many),
        cmocka_unit_test(test_snapshot_numbers),
        cmocka_unit_test(test_snapshot_long_path),
        cmocka_unit_test(test_snapshot_convert),
        cmocka_unit_test(test_view_state),
        cmocka_unit_test(test_move_speed),
        cmocka_unit_test(test_orbit),
        cmocka_unit_test(test_restored_view),
        cmocka_unit_test(test_walking),
        cmocka_unit_test(test_view_state_renew),
        cmocka_unit_test(test_time_control),
        cmocka_unit_test(test_view_state_vertical),
        cmocka_unit_test(test_scene_text),
        cmocka_unit_test(test_title),
        cmocka_unit_test(test_times),
        cmocka_unit_test(test_magnifier),
        cmocka_unit_test(test_settings_chart),
        cmocka_unit_test(test_error_meter),
        cmocka_unit_test(test_scene_words),
        cmocka_unit_test(test_readout),
        cmocka_unit_test(test_legend),
        cmocka_unit_test(test_window),
        cmocka_unit_test(test_drop),
        cmocka_unit_test(test_two_fingers),
        cmocka_unit_test(test_view_history),
        cmocka_unit_test(test_edit_history),
        cmocka_unit_test(test_edit_originals),
        cmocka_unit_test(test_edit_check),
        cmocka_unit_test(test_source_edit),
        cmocka_unit_test(test_object_text),
        cmocka_unit_test(test_keymap_ctrl),
    };
    return cmocka_run_group_tests(tests, start_keyboard, NULL);
}
