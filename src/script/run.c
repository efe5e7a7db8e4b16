/**
 * @file
 * @brief What the child does.
 */
#include "script/run.h"

#include "script/fields.h"
#include "script/include.h"
#include "script/keywords.h"
#include "script/library.h"
#include "script/lua_words.h"
#include "script/raise.h"
#include "script/sandbox.h"

#include <lauxlib.h>
#include <libintl.h>
#include <locale.h>
#include <stdio.h>
#include <string.h>

/** Makes a scene's words known. See #Vocabulary.open. @param L The state. */
static void open_scene(lua_State *L) {
    keywords_open(L);
    fields_open(L);
    include_open(L);
}

/** Sees that a scene has a camera. See #Vocabulary.check. @param L The state. */
static void check_scene(lua_State *L) {
    if (!((Run *)sandbox_of(L)->context)->scene->has_camera) {
        raise_error(L, "there is no camera in the scene; "
                       "try camera { position = {0, 0, 5}, look_at = {0, 0, 0} }");
    }
}

const Vocabulary scene_vocabulary = {.open = open_scene, .check = check_scene};

/**
 * Does all that may raise an error: sets the state up and runs the text. See lua_CFunction.
 * @param L  The state.
 * @return 0: no results.
 */
static int run_in_state(lua_State *L) {
    Run *run = sandbox_of(L)->context;
    library_open(L);
    run->vocabulary->open(L);
    sandbox_watch(L);
    Source text = *run->source;
    sandbox_load(L, &text, run->request->path);
    lua_call(L, 0, 0);
    run->vocabulary->check(L);
    return 0;
}

/**
 * Writes an error that nothing caught into the report. Takes no memory of the state, since that
 * may be what the error is about. See lua_pcall.
 * @param L  The state, with the error on its stack.
 * @return 1: the error.
 */
static int report_error(lua_State *L) {
    Report *report = sandbox_of(L)->report;
    char words[ERROR_MESSAGE_SIZE];
    size_t length;
    const char *text = words;
    if (lua_type(L, 1) == LUA_TSTRING) {
        text = lua_tolstring(L, 1, &length);
    } else {
        length = (size_t)snprintf(words, sizeof words,
                                  gettext("error was called with a %s, not with words"),
                                  luaL_typename(L, 1));
    }
    Location location = sandbox_location(L);
    size_t start = report_read_location(report, text, &location);
    char translated[ERROR_MESSAGE_SIZE];
    if (lua_words_translate(text + start, translated, sizeof translated)) {
        report_fail(report, location, translated, strlen(translated));
    } else {
        report_fail(report, location, text + start, length - start);
    }
    return 1;
}

/**
 * Sees that a report tells what a run came to.
 * @param sandbox  The sandbox of the run.
 * @param status   What lua_pcall gave.
 */
static void conclude(const Sandbox *sandbox, int status) {
    Report *report = sandbox->report;
    char words[ERROR_MESSAGE_SIZE];
    if (status == LUA_ERRMEM) {
        sandbox_describe_refusal(sandbox, words, sizeof words);
        report_fail(report, sandbox->refused, words, strlen(words));
    } else if (status != LUA_OK && report->error.status == STATUS_DONE) {
        const char *crowd = gettext("too many errors at once");
        report_fail(report, report->location, crowd, strlen(crowd));
    }
}

/** Runs the same scene whatever the user's system speaks; its errors alone are in that language. */
static void speak_plainly(void) {
    static const int categories[] = {LC_COLLATE, LC_CTYPE, LC_MONETARY, LC_NUMERIC, LC_TIME};
    for (size_t i = 0; i < sizeof categories / sizeof *categories; i++) {
        setlocale(categories[i], "C");
    }
}

void run_text(Run *run) {
    Sandbox sandbox = {.report = run->report, .context = run, .memory = run->request->memory};
    int status = LUA_ERRMEM;
    speak_plainly();
    if (sandbox_init(&sandbox)) {
        lua_State *L = sandbox.lua;
        lua_pushcfunction(L, report_error);
        lua_pushcfunction(L, run_in_state);
        status = lua_pcall(L, 0, 0, 1);
    }
    conclude(&sandbox, status);
    run->report->is_done = true;
}
