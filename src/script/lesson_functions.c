/**
 * @file
 * @brief Functions of lessons. Each adds a step at the current time of the lesson, which `wait` and
 * `hold` advance. `lesson`, the first call, names the scene.
 */
#include "script/lesson_functions.h"

#include "base/language.h"
#include "base/suggest.h"
#include "dioptre/scene_override.h"
#include "script/lesson_fields.h"
#include "script/lua_error.h"
#include "script/script_sandbox.h"

#include <lauxlib.h>
#include <math.h>
#include <stdalign.h>
#include <string.h>

/** Largest factor of `speed`. */
static const double SPEED_MAXIMUM = 1000;
/** Smallest factor of `speed`. */
static const double SPEED_MINIMUM = 0.001;
/** Largest rotation of the camera in one step, degrees. */
static const double TURN_MAXIMUM = 360;
/** Largest number of an object. */
static const double OBJECT_NUMBER_MAXIMUM = 1e9;
/** Largest number of notches of the mouse wheel in one step. */
static const double NOTCHES_MAXIMUM = 1000;

/** @return The lesson being read; raises an error before the call of `lesson`. */
static LessonBuilder *current_builder(lua_State *L) {
    LessonBuilder *builder = ((ScriptRun *)script_sandbox_of(L)->context)->lesson_builder;
    if (!builder->lesson->scene[0]) {
        lua_error_tr(L, "a lesson begins with lesson { scene = \"FILE.lua\" }");
    }
    return builder;
}

/**
 * Adds a step at the current time.
 * @param L     The state.
 * @param step  The step; its time is set here.
 */
static void add_step(lua_State *L, LessonStep step) {
    LessonBuilder *builder = current_builder(L);
    Error error = {0};
    step.time = builder->time;
    if (!lesson_add(builder->lesson, &step, &error)) {
        lua_error_tr(L, "%s", error.message);
    }
}

/** Ends what the last question has asked to watch: its answer is shown here. */
static void explain_question(lua_State *L) {
    LessonBuilder *builder = current_builder(L);
    if (builder->is_asking) {
        builder->is_asking = false;
        add_step(L, (LessonStep){.kind = LESSON_EXPLAIN,
                                 .action = (int)builder->lesson->question_count - 1});
    }
}

/**
 * Reads an argument that is a number; raises an error if it is none or out of range.
 * @param L        The state.
 * @param index    Index of the argument.
 * @param name     Its name in errors.
 * @param minimum  Smallest valid value.
 * @param maximum  Largest valid value.
 * @return The number.
 */
static double read_number(lua_State *L, int index, const char *name, double minimum,
                          double maximum) {
    const Parameter row = {
        .name = name, .type = PARAMETER_NUMBER, .minimum = minimum, .maximum = maximum};
    double value = 0;
    read_value(L, index, &row, &value);
    return value;
}

/**
 * Raises an error if a call has too few or too many arguments.
 * @param L        The state.
 * @param minimum  Smallest number of arguments.
 * @param maximum  Largest number of arguments.
 * @param usage    The call with its arguments, for the error.
 */
static void check_argument_count(lua_State *L, int minimum, int maximum, const char *usage) {
    current_builder(L);
    if (lua_gettop(L) < minimum || lua_gettop(L) > maximum) {
        lua_error_tr(L, "it is called so: %s", usage);
    }
}

/**
 * Reads the name of an action; raises an error for an unknown one.
 * @param L        The state, with the name as first argument.
 * @param is_move  Whether it must be a move.
 * @return Its index in the list.
 */
static int read_action(lua_State *L, bool is_move) {
    const ActionNames *actions = current_builder(L)->actions;
    Suggestion suggestion = {.word = luaL_checkstring(L, 1)};
    for (int i = 0; actions->names[i] && (!is_move || i < actions->move_count); i++) {
        if (strcmp(actions->names[i], suggestion.word) == 0) {
            return i;
        }
        suggest_try(&suggestion, actions->names[i]);
    }
    char hint[SUGGEST_HINT_SIZE];
    return lua_error_tr(L,
                        is_move ? N_("there is no move `%s`%s") : N_("there is no action `%s`%s"),
                        suggestion.word, suggest_hint(&suggestion, hint));
}

/**
 * Advances the time of the lesson.
 * @param L      The state.
 * @param index  Index of the argument with the seconds.
 */
static void advance_time(lua_State *L, int index) {
    double seconds = read_number(L, index, "seconds", 0, LESSON_WAIT_MAXIMUM);
    current_builder(L)->time += llround(seconds * MILLISECONDS_PER_SECOND);
}

/** `lesson { scene = ..., ... }`. See lua_CFunction. @return 0 */
static int call_lesson(lua_State *L) {
    Lesson *lesson = ((ScriptRun *)script_sandbox_of(L)->context)->lesson_builder->lesson;
    if (lesson->scene[0]) {
        return lua_error_tr(L, "a file holds one lesson, not two");
    }
    lesson_fields_read(L, lesson);
    return 0;
}

/**
 * `caption { en = ..., fr = ..., wait = true }` or `caption "TEXT"`. See lua_CFunction.
 * @return 0
 */
static int call_caption(lua_State *L) {
    check_argument_count(L, 1, 1, "caption { en = \"...\", fr = \"...\", wait = true }");
    LessonStep step = {.kind = LESSON_CAPTION};
    lesson_fields_read_caption(L, current_builder(L)->lesson, &step);
    explain_question(L);
    add_step(L, step);
    return 0;
}

/**
 * `ask { en = ..., fr = ..., choices = {...}, right = 1, because = ... }`. See lua_CFunction.
 * @return 0
 */
static int call_ask(lua_State *L) {
    LessonQuestion question = {0};
    Error error = {0};
    check_argument_count(L, 1, 1,
                         "ask { en = \"...\", choices = {...}, right = 1, because = \"...\" }");
    LessonBuilder *builder = current_builder(L);
    lesson_fields_read_question(L, builder->lesson, &question);
    explain_question(L);
    if (!lesson_add_question(builder->lesson, &question, builder->time, &error)) {
        lua_error_tr(L, "%s", error.message);
    }
    builder->is_asking = true;
    return 0;
}

/** `explain()`: the last question is answered here. See lua_CFunction. @return 0 */
static int call_explain(lua_State *L) {
    check_argument_count(L, 0, 0, "explain()");
    if (!current_builder(L)->is_asking) {
        return lua_error_tr(L, "no question is open here: explain() stands after what was asked "
                               "about, before the next caption or question");
    }
    explain_question(L);
    return 0;
}

/** `wait(SECONDS)`. See lua_CFunction. @return 0 */
static int call_wait(lua_State *L) {
    check_argument_count(L, 1, 1, "wait(SECONDS)");
    advance_time(L, 1);
    return 0;
}

/** `press "ACTION"`, `press("ACTION", true)`. See lua_CFunction. @return 0 */
static int call_press(lua_State *L) {
    check_argument_count(L, 1, 2, "press \"ACTION\"");
    add_step(L, (LessonStep){.kind = LESSON_PRESS,
                             .action = read_action(L, false),
                             .continues = lua_toboolean(L, 2)});
    return 0;
}

/** `release "MOVE"`. See lua_CFunction. @return 0 */
static int call_release(lua_State *L) {
    check_argument_count(L, 1, 1, "release \"MOVE\"");
    add_step(L, (LessonStep){.kind = LESSON_RELEASE, .action = read_action(L, true)});
    return 0;
}

/** `hold("MOVE", SECONDS)`: press, wait and release. See lua_CFunction. @return 0 */
static int call_hold(lua_State *L) {
    check_argument_count(L, 2, 2, "hold(\"MOVE\", SECONDS)");
    int move = read_action(L, true);
    add_step(L, (LessonStep){.kind = LESSON_PRESS, .action = move});
    advance_time(L, 2);
    add_step(L, (LessonStep){.kind = LESSON_RELEASE, .action = move});
    return 0;
}

/** `speed(FACTOR)`. See lua_CFunction. @return 0 */
static int call_speed(lua_State *L) {
    check_argument_count(L, 1, 1, "speed(FACTOR)");
    double factor = read_number(L, 1, "speed", SPEED_MINIMUM, SPEED_MAXIMUM);
    add_step(L, (LessonStep){.kind = LESSON_SPEED, .x = factor});
    return 0;
}

/** Adds a step of two numbers, to the right and up: the first two arguments.
 *  @param limit The largest size of both. */
static void add_step_right_up(lua_State *L, LessonStep step, const char *name, double limit) {
    step.x = read_number(L, 1, name, -limit, limit);
    step.y = read_number(L, 2, name, -limit, limit);
    add_step(L, step);
}

/** `turn(RIGHT, UP)`, degrees. See lua_CFunction. @return 0 */
static int call_turn(lua_State *L) {
    check_argument_count(L, 2, 2, "turn(DEGREES_RIGHT, DEGREES_UP)");
    add_step_right_up(L, (LessonStep){.kind = LESSON_TURN}, "turn", TURN_MAXIMUM);
    return 0;
}

/** `orbit(RIGHT, UP, X, Y, Z)`, degrees around a point. See lua_CFunction. @return 0 */
static int call_orbit(lua_State *L) {
    check_argument_count(L, 5, 5, "orbit(DEGREES_RIGHT, DEGREES_UP, X, Y, Z)");
    LessonStep step = {.kind = LESSON_ORBIT};
    for (int i = 0; i < 3; i++) {
        step.center[i] = read_number(L, 3 + i, "orbit", -LENGTH_MAXIMUM, LENGTH_MAXIMUM);
    }
    add_step_right_up(L, step, "orbit", TURN_MAXIMUM);
    return 0;
}

/** `pan(RIGHT, UP)`, scene units. See lua_CFunction. @return 0 */
static int call_pan(lua_State *L) {
    check_argument_count(L, 2, 2, "pan(RIGHT, UP)");
    add_step_right_up(L, (LessonStep){.kind = LESSON_PAN}, "pan", LENGTH_MAXIMUM);
    return 0;
}

/** `zoom(NOTCHES)`. See lua_CFunction. @return 0 */
static int call_zoom(lua_State *L) {
    check_argument_count(L, 1, 1, "zoom(NOTCHES)");
    double notches = read_number(L, 1, "zoom", -NOTCHES_MAXIMUM, NOTCHES_MAXIMUM);
    add_step(L, (LessonStep){.kind = LESSON_ZOOM, .x = notches});
    return 0;
}

/** `size(WIDTH, HEIGHT)`. See lua_CFunction. @return 0 */
static int call_size(lua_State *L) {
    check_argument_count(L, 2, 2, "size(WIDTH, HEIGHT)");
    LessonStep step = {.kind = LESSON_SIZE};
    step.x = floor(read_number(L, 1, "size", 1, IMAGE_SIZE_MAXIMUM));
    step.y = floor(read_number(L, 2, "size", 1, IMAGE_SIZE_MAXIMUM));
    add_step(L, step);
    return 0;
}

/** Adds a step at a pixel: the first two arguments, fractions of the image. @param name The called
 *  function, for errors. */
static void add_step_at_pixel(lua_State *L, LessonStepKind kind, const char *name) {
    LessonStep step = {.kind = kind};
    step.x = read_number(L, 1, name, 0, 1);
    step.y = read_number(L, 2, name, 0, 1);
    add_step(L, step);
}

/** `pixel(X, Y)`: shows the rays of a pixel. See lua_CFunction. @return 0 */
static int call_pixel(lua_State *L) {
    check_argument_count(L, 2, 2, "pixel(X, Y)");
    add_step_at_pixel(L, LESSON_PIXEL, "pixel");
    return 0;
}

/** `mark(X, Y)`: marks a pixel. See lua_CFunction. @return 0 */
static int call_mark(lua_State *L) {
    check_argument_count(L, 2, 2, "mark(X, Y)");
    add_step_at_pixel(L, LESSON_MARK, "mark");
    return 0;
}

/** `walk(RIGHT, DOWN)`, pixels. See lua_CFunction. @return 0 */
static int call_walk(lua_State *L) {
    check_argument_count(L, 2, 2, "walk(RIGHT, DOWN)");
    LessonStep step = {.kind = LESSON_WALK};
    step.x = floor(read_number(L, 1, "walk", -IMAGE_SIZE_MAXIMUM, IMAGE_SIZE_MAXIMUM));
    step.y = floor(read_number(L, 2, "walk", -IMAGE_SIZE_MAXIMUM, IMAGE_SIZE_MAXIMUM));
    add_step(L, step);
    return 0;
}

/** `ray(NUMBER)`: chooses one of the rays that are shown. See lua_CFunction. @return 0 */
static int call_ray(lua_State *L) {
    check_argument_count(L, 1, 1, "ray(NUMBER)");
    LessonStep step = {.kind = LESSON_RAY};
    step.action = (int)read_number(L, 1, "ray", 0, LESSON_RAYS_MAXIMUM - 1);
    add_step(L, step);
    return 0;
}

/** `bar(SHARE)`, a fraction of the window's width. See lua_CFunction. @return 0 */
static int call_bar(lua_State *L) {
    check_argument_count(L, 1, 1, "bar(SHARE)");
    add_step(L, (LessonStep){.kind = LESSON_BAR, .x = read_number(L, 1, "bar", 0, 1)});
    return 0;
}

/** `drag(LIGHT, X, Y, Z)`: moves a light, counted from 1. See lua_CFunction. @return 0 */
static int call_drag(lua_State *L) {
    check_argument_count(L, 4, 4, "drag(LIGHT, X, Y, Z)");
    LessonStep step = {.kind = LESSON_DRAG};
    step.action = (int)read_number(L, 1, "drag", 1, LESSON_LIGHTS_MAXIMUM) - 1;
    step.x = read_number(L, 2, "drag", -LENGTH_MAXIMUM, LENGTH_MAXIMUM);
    step.y = read_number(L, 3, "drag", -LENGTH_MAXIMUM, LENGTH_MAXIMUM);
    step.z = read_number(L, 4, "drag", -LENGTH_MAXIMUM, LENGTH_MAXIMUM);
    add_step(L, step);
    return 0;
}

/** Reads the keyword and the number of an object: the first two arguments. */
static void read_object(lua_State *L, LessonStep *step) {
    Suggestion suggestion = {.word = luaL_checkstring(L, 1)};
    char hint[SUGGEST_HINT_SIZE];
    const Keyword *keyword;
    step->keyword = scene_object_keyword_find(suggestion.word);
    for (int i = 0; step->keyword < 0 && (keyword = scene_object_keyword(i)); i++) {
        suggest_try(&suggestion, keyword->name);
    }
    if (step->keyword < 0) {
        lua_error_tr(L, "there is no object `%s`%s", suggestion.word,
                     suggest_hint(&suggestion, hint));
    }
    step->action = (int)read_number(L, 2, suggestion.word, 1, OBJECT_NUMBER_MAXIMUM);
}

/** `select(OBJECT, NUMBER, X, Y)`, clicked at fractions of the image; `select()`: none. See
 *  lua_CFunction. @return 0 */
static int call_select(lua_State *L) {
    check_argument_count(L, 0, 4, "select(\"OBJECT\", NUMBER, X, Y)");
    LessonStep step = {.kind = LESSON_SELECT, .x = -1};
    if (lua_gettop(L) > 0) {
        read_object(L, &step);
    }
    if (lua_gettop(L) > 2) {
        step.x = read_number(L, 3, "select", 0, 1);
        step.y = read_number(L, 4, "select", 0, 1);
    }
    add_step(L, step);
    return 0;
}

/** Reads the field and the value of `set`. */
static void read_setting(lua_State *L, LessonStep *step) {
    const Keyword *keyword = scene_object_keyword(step->keyword);
    Suggestion suggestion = {.word = luaL_checkstring(L, 3)};
    char hint[SUGGEST_HINT_SIZE];
    const Parameter *row;
    for (int i = 0; (row = scene_object_row(step->keyword, i)); i++) {
        suggest_try(&suggestion, row->name);
    }
    step->row = scene_object_row_find(step->keyword, suggestion.word);
    row = scene_object_row(step->keyword, step->row);
    if (!row) {
        lua_error_tr(L, "%s has no field `%s`%s", keyword->name, suggestion.word,
                     suggest_hint(&suggestion, hint));
        return;
    }
    if (parameter_number_count(row->type) == 0) {
        lua_error_tr(L, "%s is no number", row->name);
    }
    alignas(max_align_t) char value[PARAMETER_NUMBERS_MAXIMUM * sizeof(double)] = {0};
    double numbers[PARAMETER_NUMBERS_MAXIMUM] = {0};
    Parameter alone = *row;
    alone.offset = 0;
    read_value(L, 4, row, value);
    parameter_get_numbers(&alone, value, numbers);
    step->x = numbers[0];
    step->y = numbers[1];
    step->z = numbers[2];
}

/** `set(OBJECT, NUMBER, FIELD, VALUE, CONTINUES)`. See lua_CFunction. @return 0 */
static int call_set(lua_State *L) {
    check_argument_count(L, 4, 5, "set(\"OBJECT\", NUMBER, \"FIELD\", VALUE)");
    LessonStep step = {.kind = LESSON_SET, .continues = lua_toboolean(L, 5)};
    read_object(L, &step);
    read_setting(L, &step);
    add_step(L, step);
    return 0;
}

/** `move(OBJECT, NUMBER, X, Y, Z, CONTINUES)`, scene units. See lua_CFunction. @return 0 */
static int call_move(lua_State *L) {
    check_argument_count(L, 5, 6, "move(\"OBJECT\", NUMBER, X, Y, Z)");
    LessonStep step = {.kind = LESSON_MOVE, .continues = lua_toboolean(L, 6)};
    read_object(L, &step);
    step.x = read_number(L, 3, "move", -LENGTH_MAXIMUM, LENGTH_MAXIMUM);
    step.y = read_number(L, 4, "move", -LENGTH_MAXIMUM, LENGTH_MAXIMUM);
    step.z = read_number(L, 5, "move", -LENGTH_MAXIMUM, LENGTH_MAXIMUM);
    add_step(L, step);
    return 0;
}

/** `snapshot()`. See lua_CFunction. @return 0 */
static int call_snapshot(lua_State *L) {
    check_argument_count(L, 0, 0, "snapshot()");
    add_step(L, (LessonStep){.kind = LESSON_SNAPSHOT});
    return 0;
}

/** Adds the functions of lessons to a state. See #ScriptDialect.open. */
static void register_functions(lua_State *L) {
    static const luaL_Reg functions[] = {
        {"lesson", call_lesson}, {"caption", call_caption}, {"wait", call_wait},
        {"press", call_press},   {"release", call_release}, {"hold", call_hold},
        {"speed", call_speed},   {"turn", call_turn},       {"zoom", call_zoom},
        {"size", call_size},     {"pixel", call_pixel},     {"walk", call_walk},
        {"ray", call_ray},       {"bar", call_bar},         {"drag", call_drag},
        {"ask", call_ask},       {"explain", call_explain}, {"select", call_select},
        {"set", call_set},       {"orbit", call_orbit},     {"pan", call_pan},
        {"move", call_move},     {"mark", call_mark},       {"snapshot", call_snapshot}};
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) {
        lua_register(L, functions[i].name, functions[i].func);
    }
}

/** Raises an error if the file contains no lesson; explains its last question. See
 *  #ScriptDialect.check. */
static void check_lesson(lua_State *L) {
    explain_question(L);
}

const ScriptDialect lesson_dialect = {.open = register_functions, .check = check_lesson};
