/**
 * @file
 * @brief Fields of the functions of lessons, read by parameter tables as in scenes.
 */
#include "script/lesson_fields.h"

#include "base/language.h"
#include "dioptre/scene.h"
#include "script/lua_error.h"
#include "script/script_question.h"
#include "script/script_run.h"
#include "script/script_sandbox.h"

#include <lauxlib.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

/** Largest absolute value of a scene's time, seconds. */
static const double TIME_MAXIMUM = 1e9;

/** Rows of #lesson_parameters. */
typedef enum {
    ROW_SCENE,   /**< File of the scene. */
    ROW_TITLE,   /**< Title. */
    ROW_LEARNT,  /**< What the lesson teaches. */
    ROW_ENGINE,  /**< Engine. */
    ROW_SIZE,    /**< Size of the window. */
    ROW_NUMBERS, /**< First of the rows that #read_fields reads. */
} LessonParameter;

/** Fields of `lesson`. Rows before #ROW_NUMBERS are read in this file; their types are unused. */
static const Parameter lesson_parameters[] = {[ROW_SCENE] = {.name = "scene"},
                                              [ROW_TITLE] = {.name = "title"},
                                              [ROW_LEARNT] = {.name = "learnt"},
                                              [ROW_ENGINE] = {.name = "engine"},
                                              [ROW_SIZE] = {.name = "size",
                                                            .type = PARAMETER_UV,
                                                            .minimum = 1,
                                                            .maximum = IMAGE_SIZE_MAXIMUM},
                                              {.name = "samples",
                                               .type = PARAMETER_INTEGER,
                                               .offset = offsetof(LessonSettings, samples),
                                               .minimum = 1,
                                               .maximum = SAMPLES_MAXIMUM},
                                              {.name = "depth",
                                               .type = PARAMETER_INTEGER,
                                               .offset = offsetof(LessonSettings, depth),
                                               .minimum = 0,
                                               .maximum = DEPTH_MAXIMUM},
                                              {.name = "offset",
                                               .type = PARAMETER_CHOICE,
                                               .offset = offsetof(LessonSettings, offset),
                                               .choices = offset_strategy_names},
                                              {.name = "epsilon",
                                               .type = PARAMETER_NUMBER,
                                               .offset = offsetof(LessonSettings, epsilon),
                                               .minimum = 0,
                                               .maximum = LENGTH_MAXIMUM},
                                              {.name = "time",
                                               .type = PARAMETER_NUMBER,
                                               .offset = offsetof(LessonSettings, time),
                                               .minimum = -TIME_MAXIMUM,
                                               .maximum = TIME_MAXIMUM},
                                              {.name = "move_speed",
                                               .type = PARAMETER_NUMBER,
                                               .offset = offsetof(LessonSettings, move_speed),
                                               .minimum = LENGTH_MINIMUM,
                                               .maximum = LENGTH_MAXIMUM},
                                              {0}};

/** `lesson`, for errors about its fields. */
static const Keyword lesson_keyword = {.name = "lesson", .parameters = lesson_parameters};

/** Fields of `caption`. */
static const Parameter caption_parameters[] = {
    {.name = "en"}, {.name = "fr"}, {.name = "wait", .type = PARAMETER_BOOLEAN}, {0}};
/** `caption`, for errors about its fields. */
static const Keyword caption_keyword = {.name = "caption", .parameters = caption_parameters};

/** Rows of #ask_parameters that #read_value reads. */
enum { ASK_ROW_RIGHT = 3 };
/** Fields of `ask`. */
static const Parameter ask_parameters[] = {{.name = "en"},
                                           {.name = "fr"},
                                           {.name = "choices"},
                                           [ASK_ROW_RIGHT] = {.name = "right",
                                                              .type = PARAMETER_INTEGER,
                                                              .minimum = 1,
                                                              .maximum = LESSON_CHOICES_MAXIMUM},
                                           {.name = "because"},
                                           {0}};
/** `ask`, for errors about its fields. */
static const Keyword ask_keyword = {.name = "ask", .parameters = ask_parameters};

/** Fields of a text. */
static const Parameter text_parameters[] = {{.name = "en"}, {.name = "fr"}, {0}};

/**
 * Reads a string; raises an error for any other type.
 * @param L       The state.
 * @param index   Index of the value on the stack.
 * @param name    Its name in errors.
 * @param lesson  The lesson, which owns the copy.
 * @return The string.
 */
static const char *read_text(lua_State *L, int index, const char *name, Lesson *lesson) {
    size_t length;
    const Parameter row = {.name = name};
    if (lua_type(L, index) != LUA_TSTRING) {
        read_type_error(L, index, &row, N_("text"));
    }
    const char *text = lua_tolstring(L, index, &length);
    Error error = {0};
    if (length == 0 || length != strlen(text)) {
        lua_error_tr(L, "%s must not be empty, nor hold a zero byte", name);
    }
    const char *copy = lesson_store_text(lesson, text, &error);
    if (!copy) {
        lua_error_tr(L, "%s", error.message);
    }
    return copy;
}

/**
 * @return The string in a field, see #read_text; NULL without the field.
 * @param L       The state.
 * @param table   Index of the table on the stack.
 * @param name    Name of the field.
 * @param lesson  The lesson, which owns the copy.
 */
static const char *read_text_field(lua_State *L, int table, const char *name, Lesson *lesson) {
    bool is_given = lua_getfield(L, table, name) != LUA_TNIL;
    const char *text = is_given ? read_text(L, lua_gettop(L), name, lesson) : NULL;
    lua_pop(L, 1);
    return text;
}

/**
 * Reads a text of a lesson: one string for all languages, or a table with one per language.
 * @param L       The state.
 * @param index   Index of the value on the stack.
 * @param name    Its name in errors.
 * @param lesson  The lesson, which owns the copy.
 * @return The text, in at least one language.
 */
static LessonText read_lesson_text(lua_State *L, int index, const char *name, Lesson *lesson) {
    if (!lua_istable(L, index)) {
        const char *text = read_text(L, index, name, lesson);
        return (LessonText){text, text};
    }
    LessonText text = {read_text_field(L, index, "en", lesson),
                       read_text_field(L, index, "fr", lesson)};
    if (!text.english && !text.french) {
        lua_error_tr(L, "%s needs words: { en = \"...\", fr = \"...\" }", name);
    }
    return text;
}

/** Reads a text whose table may have no other fields. See #read_lesson_text. */
static LessonText read_plain_text(lua_State *L, int index, const char *name, Lesson *lesson) {
    const Keyword keyword = {.name = name, .parameters = text_parameters};
    const Keyword *const keywords[] = {&keyword, NULL};
    if (lua_istable(L, index)) {
        read_check_table(L, index, keywords, NULL);
    }
    return read_lesson_text(L, index, name, lesson);
}

/** Reads the title. @param L The state, with the lesson's table first. */
static void read_title(lua_State *L, Lesson *lesson) {
    if (lua_getfield(L, 1, "title") != LUA_TNIL) {
        lesson->title = read_plain_text(L, lua_gettop(L), "title", lesson);
    }
    lua_pop(L, 1);
}

/**
 * Reads a list of texts, the field of a table; raises an error if it has too few or too many.
 * @param L        The state, with the table first.
 * @param name     Name of the field.
 * @param minimum  Least number of texts; 0: the field may be missing.
 * @param maximum  Most texts.
 * @param lesson   The lesson, which owns the copies.
 * @param texts    The texts; has room for \p maximum.
 * @return Number of texts.
 */
static int read_texts(lua_State *L, const char *name, int minimum, int maximum, Lesson *lesson,
                      LessonText *texts) {
    const Parameter row = {.name = name};
    bool is_given = lua_getfield(L, 1, name) != LUA_TNIL;
    int list = lua_gettop(L);
    if ((is_given || minimum > 0) && !lua_istable(L, list)) {
        read_type_error(L, list, &row, N_("a list"));
    }
    lua_Unsigned count = is_given ? lua_rawlen(L, list) : 0;
    if (count < (lua_Unsigned)minimum || count > (lua_Unsigned)maximum) {
        lua_error_tr(L, "%s must be a list of %d to %d texts, not of %d", name, minimum, maximum,
                     count > INT_MAX ? INT_MAX : (int)count);
    }
    for (int i = 0; i < (int)count; i++) {
        lua_geti(L, list, i + 1);
        texts[i] = read_plain_text(L, lua_gettop(L), name, lesson);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return (int)count;
}

/** Reads the window's size. @param L The state, with the lesson's table first. */
static void read_size(lua_State *L, LessonSettings *settings) {
    Uvd size = {0};
    if (lua_getfield(L, 1, "size") != LUA_TNIL) {
        read_value(L, lua_gettop(L), &lesson_parameters[ROW_SIZE], &size);
        settings->width = (int)size.u;
        settings->height = (int)size.v;
    }
    lua_pop(L, 1);
}

/**
 * Reads the path of the scene's file, relative to the folder of the lesson.
 * @param L       The state, with the lesson's table first.
 * @param lesson  The lesson.
 */
static void read_scene(lua_State *L, Lesson *lesson) {
    ScriptAnswer answer;
    const char *name = read_text_field(L, 1, "scene", lesson);
    if (!name) {
        lua_error_tr(L, "a lesson begins with lesson { scene = \"FILE.lua\" }");
        return;
    }
    if (!script_question_ask(SCRIPT_ASK_SCENE, name, &answer, NULL)) {
        lua_error_tr(L, "scene `%s`: %s", name, answer.error.message);
        return;
    }
    memcpy(lesson->scene, answer.real_path, sizeof lesson->scene);
}

void lesson_fields_read(lua_State *L, Lesson *lesson) {
    static const Keyword *const keywords[] = {&lesson_keyword, NULL};
    read_check_arguments(L, keywords, NULL);
    for (const Parameter *row = lesson_parameters + ROW_NUMBERS; row->name; row++) {
        if (lua_getfield(L, 1, row->name) != LUA_TNIL) {
            read_value(L, lua_gettop(L), row, (char *)&lesson->initial_settings + row->offset);
        }
        lua_pop(L, 1);
    }
    read_size(L, &lesson->initial_settings);
    read_title(L, lesson);
    lesson->learnt_count =
        (size_t)read_texts(L, "learnt", 0, LESSON_LEARNT_MAXIMUM, lesson, lesson->learnt);
    lesson->initial_settings.engine = read_text_field(L, 1, "engine", lesson);
    read_scene(L, lesson);
}

void lesson_fields_read_caption(lua_State *L, Lesson *lesson, LessonStep *step) {
    static const Keyword *const keywords[] = {&caption_keyword, NULL};
    if (lua_istable(L, 1)) {
        read_check_arguments(L, keywords, NULL);
        if (lua_getfield(L, 1, "wait") != LUA_TNIL) {
            read_value(L, lua_gettop(L), &caption_parameters[2], &step->waits_for_viewer);
        }
        lua_pop(L, 1);
    }
    step->text = read_lesson_text(L, 1, "caption", lesson);
}

void lesson_fields_read_question(lua_State *L, Lesson *lesson, LessonQuestion *question) {
    static const Keyword *const keywords[] = {&ask_keyword, NULL};
    read_check_arguments(L, keywords, NULL);
    question->text = read_lesson_text(L, 1, "ask", lesson);
    question->choice_count = read_texts(L, "choices", LESSON_CHOICES_MINIMUM,
                                        LESSON_CHOICES_MAXIMUM, lesson, question->choices);
    lua_getfield(L, 1, "right");
    read_value(L, lua_gettop(L), &ask_parameters[ASK_ROW_RIGHT], &question->right);
    lua_pop(L, 1);
    if (question->right > question->choice_count) {
        lua_error_tr(L, "right must be at most %d, the number of choices, not %d",
                     question->choice_count, question->right);
    }
    question->right--; // Lua counts from 1.
    lua_getfield(L, 1, "because");
    question->because = read_plain_text(L, lua_gettop(L), "because", lesson);
    lua_pop(L, 1);
}
