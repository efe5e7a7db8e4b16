/**
 * @file
 * @brief Runs of scene texts, lessons and NFF inside this process.
 */
#include "shared/script_target.h"

#include "script/script_question.h"

#include <lauxlib.h>

/** Memory of a Lua state, bytes: little, so that no run is slow. */
static const size_t MEMORY_LIMIT = (size_t)4 << 20;
/** Calls of the hook until a run ends; there is one per call and per thousand instructions. */
enum { HOOK_CALLS_LIMIT = 3000 };

/** The Lua state of the run; there is one at a time. */
static struct {
    lua_State *lua;               /**< The state; NULL: none. */
    lua_Alloc allocate;           /**< Its allocator. */
    void *context;                /**< The allocator's context, which ends with the run. */
    bool is_running;              /**< Whether the run has not ended. */
    lua_Hook hook;                /**< Its hook. */
    int hook_calls;               /**< Calls of the hook so far. */
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

/** Ends a run that is too long; else calls the program's hook. See lua_Hook. */
static void counting_hook(lua_State *L, lua_Debug *event) {
    current.hook(L, event);
    if (++current.hook_calls > HOOK_CALLS_LIMIT) {
        luaL_error(L, "the fuzzer's limit");
    }
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
