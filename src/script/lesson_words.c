/**
 * @file
 * @brief The words of lessons. Each adds a step at the time that the words `wait` and `hold` have
 *        brought it to; `lesson`, the first, says which scene it is about.
 */
#include "script/lesson_words.h"

#include "dioptre/language.h"
#include "script/lesson_fields.h"
#include "script/raise.h"
#include "script/sandbox.h"
#include "script/suggest.h"

#include <lauxlib.h>
#include <libintl.h>
#include <math.h>
#include <string.h>

/** Fastest that moves may be asked to go. */
static const double SPEED_MAXIMUM = 1000;
/** Slowest that they may. */
static const double SPEED_MINIMUM = 0.001;
/** Farthest that the camera turns in one step, degrees. */
static const double TURN_MAXIMUM = 360;
/** Most notches of the wheel in one step. */
static const double NOTCHES_MAXIMUM = 1000;

/** @return The lesson that a state reads; raises an error before the word `lesson`.
 *  @param L The state. */
static LessonRun *begun(lua_State *L) {
    LessonRun *run = ((Run *)sandbox_of(L)->context)->lesson;
    if (!run->lesson->scene[0]) {
        raise_error(L, "a lesson begins with lesson { scene = \"FILE.lua\" }");
    }
    return run;
}

/** Adds a step to the lesson, now. @param L The state. @param step The step; its time is set. */
static void add(lua_State *L, LessonStep step) {
    LessonRun *run = begun(L);
    Error error = {0};
    step.time = run->time;
    if (!lesson_add(run->lesson, &step, &error)) {
        raise_error(L, "%s", error.message);
    }
}

/**
 * Reads a number that a word was called with; raises an error about anything else.
 * @param L        The state.
 * @param index    Which of the values.
 * @param name     What to call it in errors.
 * @param minimum  Smallest.
 * @param maximum  Largest.
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

/** Raises an error unless a word was called with a number of values. @param L The state.
 *  @param least Fewest. @param most Most. @param usage How it is called. */
static void check_count(lua_State *L, int least, int most, const char *usage) {
    begun(L);
    if (lua_gettop(L) < least || lua_gettop(L) > most) {
        raise_error(L, "it is called so: %s", usage);
    }
}

/**
 * Reads the name of an action; raises an error about any other.
 * @param L        The state, with the name first.
 * @param is_move  Whether only moves will do.
 * @return Its place in the list.
 */
static int read_action(lua_State *L, bool is_move) {
    const ActionNames *actions = begun(L)->actions;
    Suggestion suggestion = {.wanted = luaL_checkstring(L, 1)};
    for (int i = 0; actions->names[i] && (!is_move || i < actions->move_count); i++) {
        if (strcmp(actions->names[i], suggestion.wanted) == 0) {
            return i;
        }
        suggest_try(&suggestion, actions->names[i]);
    }
    char hint[SUGGEST_HINT_SIZE];
    return raise_error(L, is_move ? N_("there is no move `%s`%s") : N_("there is no action `%s`%s"),
                       suggestion.wanted, suggest_hint(&suggestion, hint));
}

/** Lets time go by. @param L The state. @param index Which value says how much, seconds. */
static void pass_time(lua_State *L, int index) {
    double seconds = read_number(L, index, "seconds", 0, LESSON_WAIT_MAXIMUM);
    begun(L)->time += llround(seconds * 1000);
}

/** `lesson { scene = ..., ... }`. See lua_CFunction. @param L The state. @return 0 */
static int call_lesson(lua_State *L) {
    Lesson *lesson = ((Run *)sandbox_of(L)->context)->lesson->lesson;
    if (lesson->scene[0]) {
        return raise_error(L, "a file holds one lesson, not two");
    }
    lesson_fields_read_lesson(L, lesson);
    return 0;
}

/** `caption { en = ..., fr = ..., wait = true }` or `caption "..."`. See lua_CFunction.
 *  @param L The state. @return 0 */
static int call_caption(lua_State *L) {
    check_count(L, 1, 1, "caption { en = \"...\", fr = \"...\", wait = true }");
    LessonStep step = {.kind = LESSON_CAPTION};
    lesson_fields_read_caption(L, begun(L)->lesson, &step);
    add(L, step);
    return 0;
}

/** `wait(SECONDS)`. See lua_CFunction. @param L The state. @return 0 */
static int call_wait(lua_State *L) {
    check_count(L, 1, 1, "wait(SECONDS)");
    pass_time(L, 1);
    return 0;
}

/** `press "ACTION"`. See lua_CFunction. @param L The state. @return 0 */
static int call_press(lua_State *L) {
    check_count(L, 1, 1, "press \"ACTION\"");
    add(L, (LessonStep){.kind = LESSON_PRESS, .action = read_action(L, false)});
    return 0;
}

/** `release "MOVE"`. See lua_CFunction. @param L The state. @return 0 */
static int call_release(lua_State *L) {
    check_count(L, 1, 1, "release \"MOVE\"");
    add(L, (LessonStep){.kind = LESSON_RELEASE, .action = read_action(L, true)});
    return 0;
}

/** `hold("MOVE", SECONDS)`: press, wait and release. See lua_CFunction. @param L The state.
 *  @return 0 */
static int call_hold(lua_State *L) {
    check_count(L, 2, 2, "hold(\"MOVE\", SECONDS)");
    int move = read_action(L, true);
    add(L, (LessonStep){.kind = LESSON_PRESS, .action = move});
    pass_time(L, 2);
    add(L, (LessonStep){.kind = LESSON_RELEASE, .action = move});
    return 0;
}

/** `speed(FACTOR)`. See lua_CFunction. @param L The state. @return 0 */
static int call_speed(lua_State *L) {
    check_count(L, 1, 1, "speed(FACTOR)");
    double factor = read_number(L, 1, "speed", SPEED_MINIMUM, SPEED_MAXIMUM);
    add(L, (LessonStep){.kind = LESSON_SPEED, .right = factor});
    return 0;
}

/** `turn(RIGHT, UP)`, degrees. See lua_CFunction. @param L The state. @return 0 */
static int call_turn(lua_State *L) {
    check_count(L, 2, 2, "turn(DEGREES_RIGHT, DEGREES_UP)");
    LessonStep step = {.kind = LESSON_TURN};
    step.right = read_number(L, 1, "turn", -TURN_MAXIMUM, TURN_MAXIMUM);
    step.up = read_number(L, 2, "turn", -TURN_MAXIMUM, TURN_MAXIMUM);
    add(L, step);
    return 0;
}

/** `zoom(NOTCHES)`. See lua_CFunction. @param L The state. @return 0 */
static int call_zoom(lua_State *L) {
    check_count(L, 1, 1, "zoom(NOTCHES)");
    double notches = read_number(L, 1, "zoom", -NOTCHES_MAXIMUM, NOTCHES_MAXIMUM);
    add(L, (LessonStep){.kind = LESSON_ZOOM, .right = notches});
    return 0;
}

/** `size(WIDTH, HEIGHT)`. See lua_CFunction. @param L The state. @return 0 */
static int call_size(lua_State *L) {
    check_count(L, 2, 2, "size(WIDTH, HEIGHT)");
    LessonStep step = {.kind = LESSON_SIZE};
    step.right = floor(read_number(L, 1, "size", 1, IMAGE_SIZE_MAXIMUM));
    step.up = floor(read_number(L, 2, "size", 1, IMAGE_SIZE_MAXIMUM));
    add(L, step);
    return 0;
}

/** `pixel(X, Y)`, shares of the picture. See lua_CFunction. @param L The state. @return 0 */
static int call_pixel(lua_State *L) {
    check_count(L, 2, 2, "pixel(X, Y)");
    LessonStep step = {.kind = LESSON_PIXEL};
    step.right = read_number(L, 1, "pixel", 0, 1);
    step.up = read_number(L, 2, "pixel", 0, 1);
    add(L, step);
    return 0;
}

/** `walk(RIGHT, DOWN)`, pixels. See lua_CFunction. @param L The state. @return 0 */
static int call_walk(lua_State *L) {
    check_count(L, 2, 2, "walk(RIGHT, DOWN)");
    LessonStep step = {.kind = LESSON_WALK};
    step.right = floor(read_number(L, 1, "walk", -IMAGE_SIZE_MAXIMUM, IMAGE_SIZE_MAXIMUM));
    step.up = floor(read_number(L, 2, "walk", -IMAGE_SIZE_MAXIMUM, IMAGE_SIZE_MAXIMUM));
    add(L, step);
    return 0;
}

/** `bar(SHARE)` of the window's width. See lua_CFunction. @param L The state. @return 0 */
static int call_bar(lua_State *L) {
    check_count(L, 1, 1, "bar(SHARE)");
    add(L, (LessonStep){.kind = LESSON_BAR, .right = read_number(L, 1, "bar", 0, 1)});
    return 0;
}

/** `snapshot()`. See lua_CFunction. @param L The state. @return 0 */
static int call_snapshot(lua_State *L) {
    check_count(L, 0, 0, "snapshot()");
    add(L, (LessonStep){.kind = LESSON_SNAPSHOT});
    return 0;
}

/** Makes the words of lessons known. See #Vocabulary.open. @param L The state. */
static void open_words(lua_State *L) {
    static const luaL_Reg words[] = {
        {"lesson", call_lesson}, {"caption", call_caption},  {"wait", call_wait},
        {"press", call_press},   {"release", call_release},  {"hold", call_hold},
        {"speed", call_speed},   {"turn", call_turn},        {"zoom", call_zoom},
        {"size", call_size},     {"pixel", call_pixel},      {"walk", call_walk},
        {"bar", call_bar},       {"snapshot", call_snapshot}};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        lua_register(L, words[i].name, words[i].func);
    }
}

/** Sees that there is a lesson. See #Vocabulary.check. @param L The state. */
static void check(lua_State *L) {
    begun(L);
}

const Vocabulary lesson_vocabulary = {.open = open_words, .check = check};
