/**
 * @file
 * @brief Runs of scene texts, lessons and NFF inside this process.
 */
#include "shared/script_target.h"

#include "script/script_question.h"

#include <lauxlib.h>
#include <lualib.h>
#include <math.h>

/** Memory of a Lua state, bytes: little, so that no run is slow. */
static const size_t MEMORY_LIMIT = (size_t)4 << 20;
/** Calls of the hook until a run ends; there is one per call and per thousand instructions. */
enum { HOOK_CALLS_LIMIT = 3000 };

/** Most steps of library functions in one run, which call no hook meanwhile. The program ends such
 * a run by its limit of processor time; the fuzzer would take it for a hang. */
static const double LIBRARY_STEPS_LIMIT = 1e7;

/** The Lua state of the run; there is one at a time. */
static struct {
    lua_State *lua;               /**< The state; NULL: none. */
    lua_Alloc allocate;           /**< Its allocator. */
    void *context;                /**< The allocator's context, which ends with the run. */
    bool is_running;              /**< Whether the run has not ended. */
    lua_Hook hook;                /**< Its hook. */
    int hook_calls;               /**< Calls of the hook so far. */
    double library_steps;         /**< Steps of library functions so far. */
    const ScriptRequest *request; /**< The request of the run. */
} current;

// What the linker's --wrap calls in place of the functions, and the functions themselves.
lua_State *__real_lua_newstate(lua_Alloc allocate, void *context);
lua_State *__wrap_lua_newstate(lua_Alloc allocate, void *context);
void __real_lua_sethook(lua_State *L, lua_Hook hook, int mask, int count);
void __wrap_lua_sethook(lua_State *L, lua_Hook hook, int mask, int count);
void __wrap_worker_enter_sandbox(size_t bytes);
WorkerAnswer __wrap_worker_job_ask(const void *question, size_t size);

/** Allocates as the program does; after the run it only frees. See lua_Alloc. */
static void *allocate(void *context, void *block, size_t old_size, size_t new_size) {
    (void)context;
    if (current.is_running) {
        return current.allocate(current.context, block, old_size, new_size);
    }
    if (new_size == 0) {
        free(block);
        return NULL;
    }
    return realloc(block, new_size);
}

/** Creates the Lua state of a run. See lua_newstate. */
lua_State *__wrap_lua_newstate(lua_Alloc allocator, void *context) {
    FUZZ_REQUIRE(!current.lua);
    current.allocate = allocator;
    current.context = context;
    current.lua = __real_lua_newstate(allocate, NULL);
    return current.lua;
}

/** @return Most steps of a search for a pattern: each repetition may try all lengths, from each
 *          position. The arguments are the text and the pattern. */
static double pattern_steps(lua_State *L, lua_Debug *call) {
    bool has_both = lua_getlocal(L, call, 1) && lua_getlocal(L, call, 2);
    const char *text = has_both ? lua_tostring(L, -2) : NULL;
    const char *pattern = has_both ? lua_tostring(L, -1) : NULL;
    if (!text || !pattern) {
        return 0;
    }
    int loops = 1;
    size_t length = lua_rawlen(L, -1);
    for (size_t i = 0; i < length; i++) {
        bool is_balance = pattern[i] == 'b' && i > 0 && pattern[i - 1] == '%';
        loops += is_balance || (pattern[i] && strchr("*+-?", pattern[i]));
    }
    return pow((double)lua_rawlen(L, -2) + 1, loops) * (double)(length + 1);
}

/** @return Steps of `string.gmatch`, whose iterator may search once per character. */
static double all_matches_steps(lua_State *L, lua_Debug *call) {
    double once = pattern_steps(L, call);
    return once > 0 ? once * (double)(lua_rawlen(L, -2) + 1) : 0;
}

/** @return A number that is an argument of a call; 0 if it is none. */
static double number_argument(lua_State *L, lua_Debug *call, int index) {
    return lua_getlocal(L, call, index) ? lua_tonumber(L, -1) : 0;
}

/** @return Steps of `string.rep`: repetitions of an empty text need no memory. */
static double repetition_steps(lua_State *L, lua_Debug *call) {
    return number_argument(L, call, 2);
}

/** @return Steps of `table.move`. */
static double move_steps(lua_State *L, lua_Debug *call) {
    return number_argument(L, call, 3) - number_argument(L, call, 2);
}

/** @return Steps of a function that loops over a table: infinite if a metamethod gives its length.
 */
static double length_steps(lua_State *L, lua_Debug *call) {
    return lua_getlocal(L, call, 1) && luaL_getmetafield(L, -1, "__len") ? HUGE_VAL : 0;
}

/** A library function that may take long without calling a hook. */
typedef struct LongFunction {
    const char *library;                            /**< Name of its library. */
    const char *name;                               /**< Its name. */
    double (*steps)(lua_State *L, lua_Debug *call); /**< Bound on the steps of a call. */
    lua_CFunction function;                         /**< The function. */
} LongFunction;

/** @return The steps of a call that is beginning; 0 unless it is of a long library function. */
static double library_steps(lua_State *L, lua_Debug *call) {
    static LongFunction functions[] = {
        {"string", "find", pattern_steps, NULL},       {"string", "match", pattern_steps, NULL},
        {"string", "gmatch", all_matches_steps, NULL}, {"string", "gsub", pattern_steps, NULL},
        {"string", "rep", repetition_steps, NULL},     {"table", "move", move_steps, NULL},
        {"table", "insert", length_steps, NULL},       {"table", "remove", length_steps, NULL},
        {"table", "concat", length_steps, NULL},       {"table", "sort", length_steps, NULL}};
    const size_t count = sizeof functions / sizeof *functions;
    if (!functions[0].function) {
        lua_State *libraries = luaL_newstate();
        FUZZ_REQUIRE(libraries);
        luaL_openlibs(libraries);
        for (size_t i = 0; i < count; i++) {
            lua_getglobal(libraries, functions[i].library);
            lua_getfield(libraries, -1, functions[i].name);
            functions[i].function = lua_tocfunction(libraries, -1);
            FUZZ_REQUIRE(functions[i].function);
        }
        lua_close(libraries);
    }
    lua_getinfo(L, "f", call);
    lua_CFunction called = lua_tocfunction(L, -1);
    for (size_t i = 0; called && i < count; i++) {
        if (functions[i].function == called) {
            return functions[i].steps(L, call);
        }
    }
    return 0;
}

/** Ends a run that is too long; else calls the program's hook. See lua_Hook. */
static void counting_hook(lua_State *L, lua_Debug *event) {
    int top = lua_gettop(L);
    bool is_call = event->event == LUA_HOOKCALL || event->event == LUA_HOOKTAILCALL;
    current.hook(L, event);
    current.library_steps += is_call ? fmax(library_steps(L, event), 0) : 0;
    if (++current.hook_calls > HOOK_CALLS_LIMIT || current.library_steps > LIBRARY_STEPS_LIMIT) {
        luaL_error(L, "the fuzzer's limit");
    }
    lua_settop(L, top);
}

/** Sets the hook of a run. See lua_sethook. */
void __wrap_lua_sethook(lua_State *L, lua_Hook hook, int mask, int count) {
    current.hook = hook;
    __real_lua_sethook(L, counting_hook, mask, count);
}

/** Leaves this process as it is: it is no worker. */
void __wrap_worker_enter_sandbox(size_t bytes) {
    (void)bytes;
}

/** Answers a question as the program does, but prints nothing. See #worker_job_ask. */
WorkerAnswer __wrap_worker_job_ask(const void *question, size_t size) {
    static const ScriptAnswer none;
    WorkerResponse response = {.bytes = &none, .size = sizeof none};
    ScriptQuestion asked;
    FUZZ_REQUIRE(size == sizeof asked);
    memcpy(&asked, question, size);
    ScriptResponder responder = {.request = current.request,
                                 .is_lesson = asked.kind == SCRIPT_ASK_SCENE};
    bool is_print = asked.kind == SCRIPT_ASK_PRINT;
    FUZZ_REQUIRE(is_print || script_question_answer(&responder, question, size, &response));
    void *copy = malloc(response.size);
    FUZZ_REQUIRE(copy);
    memcpy(copy, response.bytes, response.size);
    return (WorkerAnswer){copy, response.size, response.file > 0 ? response.file : -1};
}

/** @return An empty report. It is a megabyte, which is allocated once. */
static ScriptResult *empty_result(void) {
    static ScriptResult *result;
    result = result ? result : script_result_create(FUZZ_SCRIPT_PATH);
    FUZZ_REQUIRE(result);
    result->error = (Error){0};
    result->location = SOURCE_LOCATION_START;
    result->file_count = 1;
    return result;
}

bool fuzz_run_init(FuzzRun *run, const uint8_t *data, size_t size) {
    Error error = {0};
    *run = (FuzzRun){.text = {.text = malloc(size ? size : 1), .size = size},
                     .request = {.path = FUZZ_SCRIPT_PATH,
                                 .base_dir = "scenes",
                                 .memory_limit = MEMORY_LIMIT,
                                 .shape_keywords = scene_shape_keywords}};
    FUZZ_REQUIRE(run->text.text);
    memcpy(run->text.text, data, size); // In memory of its own: the sanitizer sees its end.
    run->run = (ScriptRun){
        .request = &run->request, .text = &run->text, .job = &run->job, .result = empty_result()};
    if (!script_text_check(&run->text, NULL, &error)) {
        FUZZ_REQUIRE(error.status == STATUS_SCENE);
        fuzz_check_error(&error);
        return false;
    }
    return true;
}

bool fuzz_run_execute(FuzzRun *run, void (*execute)(ScriptRun *run)) {
    const ScriptResult *result = run->run.result;
    current.request = &run->request;
    current.hook_calls = 0;
    current.library_steps = 0;
    current.is_running = true;
    execute(&run->run);
    current.is_running = false;
    if (current.lua) {
        lua_close(current.lua);
        current.lua = NULL;
        run->text = (ScriptText){0}; // Freed as soon as it was compiled.
    }
    if (result->error.status != STATUS_OK) {
        FUZZ_REQUIRE(result->error.status == STATUS_SCENE);
        fuzz_check_error(&result->error);
        FUZZ_REQUIRE(strncmp(result->error.message, FUZZ_SCRIPT_PATH ":", 9) == 0 ||
                     result->file_count > 1);
        FUZZ_REQUIRE(result->location.file >= 0 && result->location.file < result->file_count);
    }
    return result->error.status == STATUS_OK;
}

void fuzz_run_deinit(FuzzRun *run) {
    script_text_deinit(&run->text);
}

void fuzz_run_scene(const uint8_t *data, size_t size, const ScriptDialect *dialect,
                    void (*execute)(ScriptRun *run), void (*check)(const Scene *scene)) {
    Error error = {0};
    FuzzRun run;
    Scene *scene = scene_create(&error);
    FUZZ_REQUIRE(scene);
    if (fuzz_run_init(&run, data, size)) {
        run.run.dialect = dialect;
        run.run.scene = scene;
        if (fuzz_run_execute(&run, execute)) {
            FUZZ_REQUIRE(scene->has_camera && scene->material_count >= 1);
            check(scene);
        }
    }
    fuzz_run_deinit(&run);
    scene_destroy(scene);
}
