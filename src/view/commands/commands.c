/**
 * @file
 * @brief The table of commands.
 *
 * The light's keys are at fixed positions, wherever the letters of the keyboard in use are: those
 * of z s q d e w on an AZERTY keyboard. So are the two keys that step the time, right of M or N: ;
 * and : on an AZERTY keyboard. SDL names positions by the US keyboard. All other keys go by what is
 * printed on them; where the light or the time has such a key, with AltGr: y on a German or Swiss
 * keyboard.
 */
#include "view/commands/actions.h"

#include "base/language.h"

/** A key by its position, named by the US keyboard, and by its letter with `--keys letters`. */
#define PLACE(position, letter)                                                                    \
    { .scancode = SDL_SCANCODE_##position, .keycode = SDLK_##letter }
/** A key by its position, always, with its name in the help. */
#define ONLY_PLACE(position, name_)                                                                \
    { .scancode = SDL_SCANCODE_##position, .label = name_ }
/** A key by its position, where no other command has it. */
#define SPARE(position)                                                                            \
    { .scancode = SDL_SCANCODE_##position, .is_spare = true }
/** A key by what is printed on it. */
#define KEY(letter)                                                                                \
    { .keycode = SDLK_##letter }
/** A key by what is printed on it, with its name in the help; empty: none. */
#define NAMED(letter, name_)                                                                       \
    { .keycode = SDLK_##letter, .label = name_ }
/** No key, only a name in the help. */
#define NO_KEY(name_)                                                                              \
    { .label = name_ }

/** Heading of the help: what else can be seen. */
#define SCENES .group = N_("Scenes and lessons")
/** Heading of the help: what the mouse does in the picture, and fingers. */
#define MOUSE .group = N_("Mouse, in the picture")
/** Heading of the help: keys of the lights. */
#define LIGHT .group = N_("Light")
/** Heading of the help: keys of the camera. */
#define CAMERA .group = N_("Camera")
/** Heading of the help: keys of the time. */
#define TIME .group = N_("Time")
/** Heading of the help: what is shown, and how it is rendered. */
#define PICTURE .group = N_("Picture")
/** Heading of the help: what is changed of shapes and lights. */
#define OBJECTS .group = N_("Objects")
/** Heading of the help: keys of the ray tree. */
#define RAYS .group = N_("Rays of one pixel")
/** Heading of the help: what keys do while a lesson plays. */
#define LESSON .group = N_("Lesson, while it plays")
/** Heading of the help: all other keys. */
#define PROGRAM .group = N_("Program")

/** A move along an axis of the picture (1) or against it (-1). */
#define MOVES(subject_, axis_, sign_)                                                              \
    .flags = COMMAND_WHILE_PAUSED, .move = {MOVE_##subject_, MOVE_##axis_, sign_}
/** A function with its argument. */
#define RUNS(function, argument_) .run = function, .argument = argument_

/** The help of the first five layers. */
#define FIRST_LAYERS .help = N_("show light, normals, distance, shapes, (u, v)")
/** The help of the other layers. */
#define LAST_LAYERS .help = N_("show rays, marching, time, error, acne; rounding (Shift: operations)")
/** The help of the keys that choose rays. */
#define RAY_STEPS .help = N_("the ray before, after; let the next one fly")
/** The help of the keys that hide rays. */
#define RAY_SORTS .help = N_("show or hide camera, shadow, mirrored, refracted rays")
/** The help of the keys of drawings beside the rays. */
#define RAY_DRAWINGS .help = N_("arrows along the light; plan, march, microscope")
/** The help of the keys of epsilon. */
#define EPSILON .help = N_("epsilon half, twice (Shift: 1/10, 10 times)")

// clang-format off
const Command command_table[] = {
    {"scenes", {KEY(f)}, N_("scenes"), SCENES, .help = N_("all scenes and lessons, with pictures (Shift: lessons)"), .flags = COMMAND_UNRECORDED, RUNS(action_browse_scenes, 0)},
    {"lessons", {KEY(f)}, .flags = COMMAND_SHIFT | COMMAND_UNRECORDED, RUNS(action_browse_scenes, 1)},
    {"record", {KEY(r)}, N_("record"), SCENES, .help = N_("record a lesson, or end it"), .flags = COMMAND_UNRECORDED, RUNS(action_toggle_recording, 0)},
    {"caption", {NAMED(RETURN, N_("Enter"))}, N_("words"), SCENES, .help = N_("type words for the lesson recorded"), .flags = COMMAND_UNRECORDED, RUNS(action_begin_caption, 0)},

    {NULL, {NO_KEY(N_("Drag"))}, NULL, MOUSE, .help = N_("look around from where the camera is")},
    {NULL, {NO_KEY(N_("Drag a lamp"))}, NULL, MOUSE, .help = N_("or the selected thing (Shift: away, nearer)")},
    {NULL, {NO_KEY(N_("Click"))}, NULL, MOUSE, .help = N_("select a thing: all its values")},
    {NULL, {NO_KEY(N_("Right button"))}, NULL, MOUSE, .help = N_("orbit around the point there (or Alt and drag)")},
    {NULL, {NO_KEY(N_("Middle button"))}, NULL, MOUSE, .help = N_("camera sideways (or Shift and right button)")},
    {NULL, {NO_KEY(N_("Wheel"))}, NULL, MOUSE, .help = N_("field of view: narrower, wider")},
    {NULL, {NO_KEY(N_("Two fingers"))}, NULL, MOUSE, .help = N_("camera sideways; spread: field of view")},

    {"light up", {PLACE(W, z)}, N_("up"), LIGHT, .help = N_("lamp up, down"), MOVES(LIGHT, UP, 1)},
    {"light down", {PLACE(S, s)}, N_("down"), LIGHT, .help = N_("lamp up, down"), MOVES(LIGHT, UP, -1)},
    {"light left", {PLACE(A, q)}, N_("left"), LIGHT, .help = N_("lamp left, right"), MOVES(LIGHT, RIGHT, -1)},
    {"light right", {PLACE(D, d)}, N_("right"), LIGHT, .help = N_("lamp left, right"), MOVES(LIGHT, RIGHT, 1)},
    {"light away", {PLACE(E, e)}, N_("away"), LIGHT, .help = N_("lamp away from you, nearer"), MOVES(LIGHT, FORWARD, 1)},
    {"light nearer", {PLACE(Z, w)}, N_("near"), LIGHT, .help = N_("lamp away from you, nearer"), MOVES(LIGHT, FORWARD, -1)},
    {"next light", {NAMED(TAB, N_("Tab"))}, N_("next"), LIGHT, .help = N_("keys move the next lamp"),
     .flags = COMMAND_WHILE_PAUSED, RUNS(action_select_next_light, 0)},

    {"camera up", {NAMED(UP, "↑")}, N_("up"), CAMERA, .help = N_("camera up, down"), MOVES(CAMERA, UP, 1)},
    {"camera down", {NAMED(DOWN, "↓")}, N_("down"), CAMERA, .help = N_("camera up, down"), MOVES(CAMERA, UP, -1)},
    {"camera left", {NAMED(LEFT, "←")}, N_("left"), CAMERA, .help = N_("camera left, right"), MOVES(CAMERA, RIGHT, -1)},
    {"camera right", {NAMED(RIGHT, "→")}, N_("right"), CAMERA, .help = N_("camera left, right"), MOVES(CAMERA, RIGHT, 1)},
    {"camera forward", {NAMED(PAGEUP, N_("Page Up"))}, N_("forward"), CAMERA, .help = N_("camera forward, back"), MOVES(CAMERA, FORWARD, 1)},
    {"camera back", {NAMED(PAGEDOWN, N_("Page Down"))}, N_("back"), CAMERA, .help = N_("camera forward, back"), MOVES(CAMERA, FORWARD, -1)},
    {"walk", {NAMED(END, N_("End"))}, N_("walk"), CAMERA, .help = N_("camera: walk at one height, or fly"), RUNS(action_toggle_walking, 0)},

    {"time", {NAMED(SPACE, N_("Space"))}, NULL, TIME, .help = N_("run or hold the scene's time"), RUNS(action_toggle_time, 0)},
    {"time back", {PLACE(COMMA, COMMA)}, N_("back"), TIME, .help = N_("the scene's time: a step back, on"), .flags = COMMAND_REPEATS, RUNS(action_step_time, -1)},
    {"time on", {PLACE(PERIOD, PERIOD)}, N_("on"), TIME, .help = N_("the scene's time: a step back, on"), .flags = COMMAND_REPEATS, RUNS(action_step_time, 1)},

    {"layer light", {ONLY_PLACE(1, "1")}, N_("light"), PICTURE, FIRST_LAYERS, .flags = COMMAND_CHOICE, RUNS(action_set_layer, LAYER_SHADED)},
    {"layer normals", {ONLY_PLACE(2, "2")}, N_("normals"), PICTURE, FIRST_LAYERS, .flags = COMMAND_CHOICE, RUNS(action_set_layer, LAYER_NORMALS)},
    {"layer distance", {ONLY_PLACE(3, "3")}, N_("distance"), PICTURE, FIRST_LAYERS, .flags = COMMAND_CHOICE, RUNS(action_set_layer, LAYER_DISTANCE)},
    {"layer shapes", {ONLY_PLACE(4, "4")}, N_("shapes"), PICTURE, FIRST_LAYERS, .flags = COMMAND_CHOICE, RUNS(action_set_layer, LAYER_SHAPES)},
    {"layer places", {ONLY_PLACE(5, "5")}, "(u, v)", PICTURE, FIRST_LAYERS, .flags = COMMAND_CHOICE, RUNS(action_set_layer, LAYER_UV)},
    {"layer rays", {ONLY_PLACE(6, "6")}, N_("rays"), PICTURE, LAST_LAYERS, .flags = COMMAND_CHOICE, RUNS(action_set_layer, LAYER_RAYS)},
    {"layer steps", {ONLY_PLACE(7, "7")}, N_("march"), PICTURE, LAST_LAYERS, .flags = COMMAND_CHOICE, RUNS(action_set_layer, LAYER_STEPS)},
    {"layer time", {ONLY_PLACE(8, "8")}, N_("time"), PICTURE, LAST_LAYERS, .flags = COMMAND_CHOICE, RUNS(action_set_layer, LAYER_TIME)},
    {"layer error", {ONLY_PLACE(9, "9")}, N_("error"), PICTURE, LAST_LAYERS, .flags = COMMAND_CHOICE, RUNS(action_set_layer, LAYER_ERROR)},
    {"layer acne", {ONLY_PLACE(0, "0")}, N_("acne"), PICTURE, LAST_LAYERS, .flags = COMMAND_CHOICE, RUNS(action_set_layer, LAYER_ACNE)},
    {"layer rounding", {KEY(y)}, N_("round"), PICTURE, LAST_LAYERS, .flags = COMMAND_CHOICE, RUNS(action_set_layer, LAYER_ROUNDING)},
    {"layer operations", {KEY(y)}, .flags = COMMAND_CHOICE | COMMAND_SHIFT, RUNS(action_set_layer, LAYER_OPERATIONS)},
    {"offset", {KEY(o)}, N_("offset"), PICTURE, .help = N_("offset: none (shows acne), fixed, bound"), .flags = COMMAND_CHOICE, RUNS(action_change_offset, 1)},
    {"offset back", {KEY(o)}, .flags = COMMAND_CHOICE | COMMAND_SHIFT, RUNS(action_change_offset, -1)},
    {"epsilon half", {ONLY_PLACE(LEFTBRACKET, NULL)}, "ε / 2", PICTURE, EPSILON, .flags = COMMAND_CHOICE | COMMAND_REPEATS, RUNS(action_change_epsilon, -2)},
    {"epsilon tenth", {ONLY_PLACE(LEFTBRACKET, NULL)}, .flags = COMMAND_CHOICE | COMMAND_SHIFT | COMMAND_REPEATS, RUNS(action_change_epsilon, -10)},
    {"epsilon twice", {ONLY_PLACE(RIGHTBRACKET, NULL)}, "ε × 2", PICTURE, EPSILON, .flags = COMMAND_CHOICE | COMMAND_REPEATS, RUNS(action_change_epsilon, 2)},
    {"epsilon ten times", {ONLY_PLACE(RIGHTBRACKET, NULL)}, .flags = COMMAND_CHOICE | COMMAND_SHIFT | COMMAND_REPEATS, RUNS(action_change_epsilon, 10)},
    {"engine", {KEY(g)}, N_("engine"), PICTURE, .help = N_("number type: float, double, quad"), .flags = COMMAND_CHOICE, RUNS(action_change_engine, 1)},
    {"engine back", {KEY(g)}, .flags = COMMAND_CHOICE | COMMAND_SHIFT, RUNS(action_change_engine, -1)},
    {"light mode", {KEY(m)}, N_("light"), PICTURE, .help = N_("which light: lamps and ambient, lamps alone, none"), .flags = COMMAND_CHOICE, RUNS(action_change_lighting, 1)},
    {"light mode back", {KEY(m)}, .flags = COMMAND_CHOICE | COMMAND_SHIFT, RUNS(action_change_lighting, -1)},
    {"deeper", {KEY(b)}, N_("depth"), PICTURE, .help = N_("depth: more bounces (Shift: fewer)"), .flags = COMMAND_CHOICE, RUNS(action_change_depth, 1)},
    {"less deep", {KEY(b)}, .flags = COMMAND_CHOICE | COMMAND_SHIFT, RUNS(action_change_depth, -1)},
    {"samples twice", {KEY(n)}, N_("samples"), PICTURE, .help = N_("samples per pixel: twice (Shift: half)"), .flags = COMMAND_CHOICE, RUNS(action_change_samples, 1)},
    {"samples half", {KEY(n)}, .flags = COMMAND_CHOICE | COMMAND_SHIFT, RUNS(action_change_samples, -1)},
    {"methods", {KEY(u)}, N_("reports"), PICTURE, .help = N_("draw as report A, B, C or D did"), .flags = COMMAND_CHOICE, RUNS(action_change_methods, 1)},
    {"methods back", {KEY(u)}, .flags = COMMAND_CHOICE | COMMAND_SHIFT, RUNS(action_change_methods, -1)},
    {"pixel corners", {KEY(F8)}, N_("corners"), PICTURE, .help = N_("rays through corners or centres of pixels"), .flags = COMMAND_CHOICE, RUNS(action_change_pixel, 1)},
    {"settings", {KEY(i)}, N_("costs"), PICTURE, .help = N_("settings, and what the picture costs"), RUNS(action_toggle_settings, 0)},
    {"chart", {KEY(F9)}, N_("chart"), PICTURE, .help = N_("chart of settings: time against error"), RUNS(action_toggle_chart, 0)},
    {"magnifier", {KEY(F4)}, N_("magnify"), PICTURE, .help = N_("magnifier: pixels as squares"), RUNS(action_toggle_magnifier, 0)},
    {"as at first", {NAMED(BACKSPACE, N_("Backspace"))}, N_("as at first"), PICTURE, .help = N_("settings and layer as at first"), .flags = COMMAND_CHOICE, RUNS(action_reset_settings, 0)},
    {"split", {KEY(x)}, N_("split"), PICTURE, .help = N_("two pictures, their difference, one"), .flags = COMMAND_CHOICE, RUNS(action_cycle_split, 1)},
    {"split back", {KEY(x)}, .flags = COMMAND_CHOICE | COMMAND_SHIFT, RUNS(action_cycle_split, -1)},
    {"other side", {KEY(t)}, N_("side"), PICTURE, .help = N_("choose which of two pictures keys change"), RUNS(action_swap_side, 0)},
    {"bar left", {KEY(F6)}, N_("bar ←"), PICTURE, .help = N_("bar between two pictures: left, right"), .flags = COMMAND_REPEATS, RUNS(action_move_bar, -1)},
    {"bar right", {KEY(F7)}, N_("bar →"), PICTURE, .help = N_("bar between two pictures: left, right"), .flags = COMMAND_REPEATS, RUNS(action_move_bar, 1)},

    {"next thing", {KEY(F3)}, N_("thing"), OBJECTS, .help = N_("select the next thing (Shift: before)"), .flags = COMMAND_UNRECORDED | COMMAND_REPEATS, RUNS(action_select_thing, 1)},
    {"thing before", {KEY(F3)}, .flags = COMMAND_SHIFT | COMMAND_UNRECORDED | COMMAND_REPEATS, RUNS(action_select_thing, -1)},
    {"inspector keys", {KEY(F10)}, N_("edit"), OBJECTS, .help = N_("set its values by keys: arrows; Esc: back"), .flags = COMMAND_UNRECORDED, RUNS(action_take_keyboard, 0)},
    {"things", {KEY(F10)}, NULL, OBJECTS, .help = N_("all things of the scene: a list"), .flags = COMMAND_SHIFT | COMMAND_UNRECORDED, RUNS(action_list_things, 0)},
    {"undo", {KEY(z)}, NULL, OBJECTS, .help = N_("take a change back, do it again"), .flags = COMMAND_CTRL | COMMAND_REPEATS, RUNS(action_undo, 0)},
    {"redo", {KEY(y)}, NULL, OBJECTS, .help = N_("take a change back, do it again"), .flags = COMMAND_CTRL | COMMAND_REPEATS, RUNS(action_redo, 0)},
    {"undo back", {KEY(z)}, .flags = COMMAND_CTRL | COMMAND_SHIFT | COMMAND_REPEATS, RUNS(action_redo, 0)},
    {"copy object", {KEY(c)}, NULL, OBJECTS, .help = N_("copy the thing as text of a scene"), .flags = COMMAND_CTRL | COMMAND_UNRECORDED, RUNS(action_copy_object, 0)},
    {"save copy", {KEY(s)}, .flags = COMMAND_CTRL | COMMAND_SHIFT | COMMAND_UNRECORDED, RUNS(action_save_copy, 0)},
    {"write object", {KEY(s)}, NULL, OBJECTS, .help = N_("save changes in the scene file (Shift: a copy)"), .flags = COMMAND_CTRL | COMMAND_UNRECORDED, RUNS(action_write_object, 0)},

    {"rays", {KEY(v)}, N_("rays"), RAYS, .help = N_("rays of the pixel under the mouse, or the picture"), RUNS(action_toggle_rays, 0)},
    {NULL, {NO_KEY(N_("Click"))}, NULL, RAYS, .help = N_("beside the rays: those of the pixel clicked")},
    {NULL, {NO_KEY(N_("Ctrl+←↑↓→"))}, NULL, RAYS, .help = N_("rays of the pixel beside; magnifier: there")},
    {"ray back", {KEY(j)}, N_("ray −"), RAYS, RAY_STEPS, .flags = COMMAND_REPEATS, RUNS(action_select_ray, -1)},
    {"ray on", {KEY(k)}, N_("ray +"), RAYS, RAY_STEPS, .flags = COMMAND_REPEATS, RUNS(action_select_ray, 1)},
    {"fly ray", {NO_KEY(N_("Space"))}, NULL, RAYS, RAY_STEPS, RUNS(action_fly_ray, 0)},
    {"camera rays", {ONLY_PLACE(1, "1")}, NULL, RAYS, RAY_SORTS, .flags = COMMAND_SHIFT, RUNS(action_toggle_ray_kind, RAY_CAMERA)},
    {"shadow rays", {ONLY_PLACE(2, "2")}, NULL, RAYS, RAY_SORTS, .flags = COMMAND_SHIFT, RUNS(action_toggle_ray_kind, RAY_SHADOW)},
    {"mirrored rays", {ONLY_PLACE(3, "3")}, NULL, RAYS, RAY_SORTS, .flags = COMMAND_SHIFT, RUNS(action_toggle_ray_kind, RAY_REFLECTION)},
    {"refracted rays", {ONLY_PLACE(4, "4")}, NULL, RAYS, RAY_SORTS, .flags = COMMAND_SHIFT, RUNS(action_toggle_ray_kind, RAY_REFRACTION)},
    {"arrows", {ONLY_PLACE(5, "5")}, NULL, RAYS, RAY_DRAWINGS, .flags = COMMAND_SHIFT, RUNS(action_turn_arrows, 0)},
    {"ray plan", {ONLY_PLACE(6, "6")}, NULL, RAYS, RAY_DRAWINGS, .flags = COMMAND_SHIFT, RUNS(action_toggle_ray_pane, RAY_PANE_PLAN)},
    {"ray march", {ONLY_PLACE(7, "7")}, NULL, RAYS, RAY_DRAWINGS, .flags = COMMAND_SHIFT, RUNS(action_toggle_ray_pane, RAY_PANE_MARCH)},
    {"hit microscope", {ONLY_PLACE(8, "8")}, NULL, RAYS, RAY_DRAWINGS, .flags = COMMAND_SHIFT, RUNS(action_toggle_ray_pane, RAY_PANE_MICROSCOPE)},
    {NULL, {NO_KEY("←↑↓→")}, NULL, RAYS, .help = N_("around the rays; or the mouse")},
    {NULL, {NO_KEY(N_("Page Up")), NO_KEY(N_("Page Down"))}, NULL, RAYS, .help = N_("scroll their formulas (Shift: nearer, farther)")},

    {.keys_of = "time", LESSON, .help = N_("hold the lesson, or let it go on")},
    {.keys_of = "time back", LESSON, .help = N_("a step of the lesson back, on at once")},
    {.keys_of = "time on", LESSON, .help = N_("a step of the lesson back, on at once")},
    {NULL, {NO_KEY(N_("1 to 9"))}, NULL, LESSON, .help = N_("answer its question; choose on its end card")},
    {NULL, {NO_KEY(N_("Click"))}, NULL, LESSON, .help = N_("an answer; 2/9: any step; ✕: leave")},
    {.keys_of = "leave", LESSON, .help = N_("leave the lesson: press twice")},

    {NULL, {ONLY_PLACE(LSHIFT, N_("Shift")), ONLY_PLACE(RSHIFT, "")}, N_("fast"), PROGRAM, .help = N_("held with a move: fast, fine")},
    {NULL, {ONLY_PLACE(LCTRL, N_("Ctrl")), ONLY_PLACE(RCTRL, "")}, N_("fine"), PROGRAM, .help = N_("held with a move: fast, fine")},
    {"home", {NAMED(HOME, N_("Home"))}, N_("reset"), PROGRAM, .help = N_("camera and lamps as the scene has them"),
     .flags = COMMAND_WHILE_PAUSED, RUNS(action_reset_view, 0)},
    {"snapshot", {KEY(p), KEY(F12)}, N_("photo"), PROGRAM, .help = N_("save the picture (Shift: as on the screen)"), .flags = COMMAND_WHILE_PLAYING, RUNS(action_request_snapshot, 0)},
    {"snapshot of the screen", {KEY(p), KEY(F12)}, .flags = COMMAND_SHIFT | COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(action_save_screen, 0)},
    {"copy", {KEY(c)}, N_("copy"), PROGRAM, .help = N_("camera and light as text, to paste"),
     .flags = COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(action_copy_view, 0)},
    {"text larger", {NAMED(EQUALS, "+"), NAMED(PLUS, "+"), NAMED(KP_PLUS, ""), SPARE(EQUALS)}, "A +", PROGRAM, .help = N_("letters larger, smaller"),
     .flags = COMMAND_WHILE_PLAYING | COMMAND_REPEATS, RUNS(action_scale_text, 1)},
    {"text smaller", {NAMED(MINUS, "-"), NAMED(KP_MINUS, ""), SPARE(MINUS), SPARE(GRAVE)}, "A −", PROGRAM, .help = N_("letters larger, smaller"),
     .flags = COMMAND_WHILE_PLAYING | COMMAND_REPEATS, RUNS(action_scale_text, -1)},
    {"language", {KEY(l)}, "en / fr", PROGRAM, .help = N_("English, français"),
     .flags = COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(action_switch_language, 0)},
    {"help", {KEY(F1), KEY(h), NO_KEY("?")}, N_("help"), PROGRAM, .help = N_("this help: all keys"), .flags = COMMAND_WHILE_PLAYING, RUNS(action_toggle_help, 0)},
    {"toolbar", {KEY(F2)}, N_("tools"), PROGRAM, .help = N_("show or hide the toolbar"),
     .flags = COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(action_toggle_toolbar, 0)},
    {"toolbar keys", {KEY(F2)}, NULL, PROGRAM, .help = N_("the toolbar by keys: arrows, Enter; Esc: back"),
     .flags = COMMAND_SHIFT | COMMAND_UNRECORDED, RUNS(action_take_toolbar, 0)},
    {"presentation", {KEY(F5)}, N_("class"), PROGRAM, .help = N_("for a class: large letters, no toolbar"),
     .flags = COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(action_toggle_presentation, 0)},
    {"full screen", {KEY(F11)}, N_("screen"), PROGRAM, .help = N_("the whole screen, or a window"), .flags = COMMAND_WHILE_PLAYING, RUNS(action_toggle_full_screen, 0)},
    {"leave", {NAMED(ESCAPE, N_("Esc"))}, N_("leave"), PROGRAM, .help = N_("close what lies on top; at last leave"),
     .flags = COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(action_leave, 0)},
    {"quit", {KEY(q)}, NULL, PROGRAM, .help = N_("leave dioptre"),
     .flags = COMMAND_CTRL | COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(action_quit, 0)},
    {0},
};
// clang-format on
