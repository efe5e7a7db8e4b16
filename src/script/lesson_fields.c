/**
 * @file
 * @brief The tables of lessons. Numbers and words are read by parameter tables, as in scenes.
 */
#include "script/lesson_fields.h"

#include "dioptre/language.h"
#include "dioptre/offset.h"
#include "dioptre/scene.h"
#include "script/raise.h"
#include "script/run.h"
#include "script/sandbox.h"

#include <errno.h>
#include <lauxlib.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/** Latest and earliest that a scene's time may be, seconds. */
static const double TIME_MAXIMUM = 1e9;

/** The rows of #lesson_rows. */
typedef enum {
    ROW_SCENE,   /**< The scene's file. */
    ROW_TITLE,   /**< What the lesson is called. */
    ROW_ENGINE,  /**< The engine. */
    ROW_SIZE,    /**< The window's size. */
    ROW_NUMBERS, /**< The first of the rows that the tables alone can read. */
} LessonRow;

/** What `lesson` takes. Rows before #ROW_NUMBERS are read here; their types say nothing. */
static const Parameter lesson_rows[] = {[ROW_SCENE] = {.name = "scene"},
                                        [ROW_TITLE] = {.name = "title"},
                                        [ROW_ENGINE] = {.name = "engine"},
                                        [ROW_SIZE] = {.name = "size",
                                                      .type = PARAMETER_PAIR,
                                                      .minimum = 1,
                                                      .maximum = IMAGE_SIZE_MAXIMUM},
                                        {.name = "samples",
                                         .type = PARAMETER_INTEGER,
                                         .offset = offsetof(LessonLook, samples),
                                         .minimum = 1,
                                         .maximum = SAMPLES_MAXIMUM},
                                        {.name = "depth",
                                         .type = PARAMETER_INTEGER,
                                         .offset = offsetof(LessonLook, depth),
                                         .minimum = 0,
                                         .maximum = DEPTH_MAXIMUM},
                                        {.name = "offset",
                                         .type = PARAMETER_WORD,
                                         .offset = offsetof(LessonLook, offset),
                                         .words = offset_names},
                                        {.name = "epsilon",
                                         .type = PARAMETER_NUMBER,
                                         .offset = offsetof(LessonLook, epsilon),
                                         .minimum = 0,
                                         .maximum = LENGTH_MAXIMUM},
                                        {.name = "time",
                                         .type = PARAMETER_NUMBER,
                                         .offset = offsetof(LessonLook, time),
                                         .minimum = -TIME_MAXIMUM,
                                         .maximum = TIME_MAXIMUM},
                                        {0}};

/** `lesson`, for errors about its fields. */
static const Keyword lesson_keyword = {.name = "lesson", .parameters = lesson_rows};

/** What `caption` takes. */
static const Parameter caption_rows[] = {
    {.name = "en"}, {.name = "fr"}, {.name = "wait", .type = PARAMETER_BOOLEAN}, {0}};
/** `caption`, for errors about its fields. */
static const Keyword caption_keyword = {.name = "caption", .parameters = caption_rows};

/** What a title takes. */
static const Parameter text_rows[] = {{.name = "en"}, {.name = "fr"}, {0}};

/**
 * Reads text; raises an error about anything else.
 * @param L       The state.
 * @param index   Where it is.
 * @param name    What to call it in errors.
 * @param lesson  The lesson, which keeps it.
 * @return The text.
 */
static const char *read_text(lua_State *L, int index, const char *name, Lesson *lesson) {
    size_t length;
    const Parameter row = {.name = name};
    if (lua_type(L, index) != LUA_TSTRING) {
        read_raise_type(L, index, &row, N_("text"));
    }
    const char *text = lua_tolstring(L, index, &length);
    Error error = {0};
    if (length == 0 || length != strlen(text)) {
        raise_error(L, "%s must not be empty, nor hold a zero byte", name);
    }
    const char *kept = lesson_keep(lesson, text, &error);
    if (!kept) {
        raise_error(L, "%s", error.message);
    }
    return kept;
}

/** @return Text of a field, see #read_text; NULL where it is not given. @param L The state.
 *  @param table Where the table is. @param name The field. @param lesson The lesson. */
static const char *read_text_field(lua_State *L, int table, const char *name, Lesson *lesson) {
    bool is_given = lua_getfield(L, table, name) != LUA_TNIL;
    const char *text = is_given ? read_text(L, lua_gettop(L), name, lesson) : NULL;
    lua_pop(L, 1);
    return text;
}

/**
 * Reads words: one text for all languages, or a table with one for each.
 * @param L       The state.
 * @param index   Where they are.
 * @param name    What to call them in errors.
 * @param lesson  The lesson, which keeps them.
 * @return The words; at least in one language.
 */
static LessonText read_words(lua_State *L, int index, const char *name, Lesson *lesson) {
    if (!lua_istable(L, index)) {
        const char *text = read_text(L, index, name, lesson);
        return (LessonText){text, text};
    }
    LessonText text = {read_text_field(L, index, "en", lesson),
                       read_text_field(L, index, "fr", lesson)};
    if (!text.english && !text.french) {
        raise_error(L, "%s needs words: { en = \"...\", fr = \"...\" }", name);
    }
    return text;
}

/** Reads the title. @param L The state, with the lesson's table first. @param[in,out] lesson The
 *  lesson. */
static void read_title(lua_State *L, Lesson *lesson) {
    static const Keyword title = {.name = "title", .parameters = text_rows};
    static const Keyword *const keywords[] = {&title, NULL};
    if (lua_getfield(L, 1, "title") != LUA_TNIL) {
        int index = lua_gettop(L);
        if (lua_istable(L, index)) {
            read_check_table(L, index, keywords, NULL);
        }
        lesson->title = read_words(L, index, "title", lesson);
    }
    lua_pop(L, 1);
}

/** Reads the window's size. @param L The state, with the lesson's table first. @param[in,out] look
 *  Gets it. */
static void read_size(lua_State *L, LessonLook *look) {
    Pair size = {0};
    if (lua_getfield(L, 1, "size") != LUA_TNIL) {
        read_value(L, lua_gettop(L), &lesson_rows[ROW_SIZE], &size);
        look->width = (int)size.u;
        look->height = (int)size.v;
    }
    lua_pop(L, 1);
}

/**
 * Finds the scene's file: its name is as seen from the lesson's folder.
 * @param L               The state, with the lesson's table first.
 * @param[in,out] lesson  Gets its path.
 */
static void read_scene(lua_State *L, Lesson *lesson) {
    const char *path = ((Run *)sandbox_of(L)->context)->request->path;
    const char *name = read_text_field(L, 1, "scene", lesson), *slash = strrchr(path, '/');
    int folder = slash && name && name[0] != '/' ? (int)(slash + 1 - path) : 0;
    if (!name) {
        raise_error(L, "a lesson begins with lesson { scene = \"FILE.lua\" }");
    }
    int length = snprintf(lesson->scene, PATH_MAX, "%.*s%s", folder, path, name);
    if (length >= PATH_MAX || access(lesson->scene, R_OK) != 0) {
        lesson->scene[0] = '\0';
        raise_error(L, "scene `%s`: %s", name,
                    error_system(length >= PATH_MAX ? ENAMETOOLONG : errno));
    }
}

void lesson_fields_read_lesson(lua_State *L, Lesson *lesson) {
    static const Keyword *const keywords[] = {&lesson_keyword, NULL};
    read_check_names(L, keywords, NULL);
    for (const Parameter *row = lesson_rows + ROW_NUMBERS; row->name; row++) {
        if (lua_getfield(L, 1, row->name) != LUA_TNIL) {
            read_value(L, lua_gettop(L), row, (char *)&lesson->look + row->offset);
        }
        lua_pop(L, 1);
    }
    read_size(L, &lesson->look);
    read_title(L, lesson);
    lesson->look.engine = read_text_field(L, 1, "engine", lesson);
    read_scene(L, lesson);
}

void lesson_fields_read_caption(lua_State *L, Lesson *lesson, LessonStep *step) {
    static const Keyword *const keywords[] = {&caption_keyword, NULL};
    if (lua_istable(L, 1)) {
        read_check_names(L, keywords, NULL);
        if (lua_getfield(L, 1, "wait") != LUA_TNIL) {
            read_value(L, lua_gettop(L), &caption_rows[2], &step->waits);
        }
        lua_pop(L, 1);
    }
    step->text = read_words(L, 1, "caption", lesson);
}
