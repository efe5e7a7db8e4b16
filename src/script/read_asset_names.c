/**
 * @file
 * @brief Names of mesh and picture files in the tables of a scene.
 */
#include "assets/images/texture_file.h"
#include "assets/meshes/mesh_file.h"
#include "base/language.h"
#include "script/lua_error.h"
#include "script/read_parameters.h"
#include "script/registry_table.h"
#include "script/script_question.h"
#include "script/script_run.h"
#include "script/script_sandbox.h"

#include "base/sanitize.h"

#include <lauxlib.h>
#include <string.h>

/** A kind of file that a scene can name: meshes or pictures. */
typedef struct AssetNameKind {
    const char *expected; /**< Description of a valid name, for errors. */
    /** Checks the ending of a name. @return Whether it is of this kind. */
    bool (*check)(const char *path, Error *error);
    /** Adds it to the scene, unless it is there. @return false when the scene's memory is full. */
    bool (*add)(Scene *scene, const SceneFile *file, size_t *place, Error *error);
} AssetNameKind;

/**
 * Adds a file to the scene, unless it is there.
 * @param L           The state.
 * @param kind        Kind of the file.
 * @param name        Its name in the scene.
 * @param real_path   Its absolute path without links.
 * @param[out] index  Its index in the scene.
 * @param[out] error  What is wrong.
 * @return false when the scene's memory is full.
 */
static bool add_asset(lua_State *L, const AssetNameKind *kind, const char *name,
                      const char *real_path, size_t *index, Error *error) {
    const ScriptSandbox *sandbox = script_sandbox_of(L);
    const ScriptRun *run = sandbox->context;
    char where[SANITIZED_PATH_SIZE + sizeof ":-2147483648"];
    script_result_format_location(sandbox->result, script_sandbox_location(L), where, sizeof where);
    SceneFile file = {.path = real_path, .name = name, .location = where};
    return kind->add(run->scene, &file, index, error);
}

/** Pushes the names of a kind that the scene has used, with the indices of their files. */
static void push_known_names(lua_State *L, const AssetNameKind *kind) {
    registry_table_push(L, kind, false);
}

/** @return Whether the scene has used the name on top of the stack. @param[out] place Its file. */
static bool find_known_name(lua_State *L, const AssetNameKind *kind, size_t *place) {
    push_known_names(L, kind);
    lua_pushvalue(L, -2);
    bool is_known = lua_rawget(L, -2) == LUA_TNUMBER;
    *place = (size_t)lua_tointeger(L, -1);
    lua_pop(L, 2);
    return is_known;
}

/** Remembers the name on top of the stack: a thousand shapes ask the program once. */
static void remember_name(lua_State *L, const AssetNameKind *kind, size_t place) {
    push_known_names(L, kind);
    lua_pushvalue(L, -2);
    lua_pushinteger(L, (lua_Integer)place);
    lua_rawset(L, -3);
    lua_pop(L, 1);
}

/**
 * Reads the name of a file and adds the file to the scene.
 * @param L      The state.
 * @param index  Stack index of the name.
 * @param row    Row of the parameter table.
 * @param kind   Kind of the file.
 * @return Index of the file in the scene.
 */
static size_t read_asset_name(lua_State *L, int index, const Parameter *row,
                              const AssetNameKind *kind) {
    size_t length, asset_index = 0;
    ScriptAnswer answer;
    if (lua_type(L, index) != LUA_TSTRING) {
        read_type_error(L, index, row, kind->expected);
    }
    const char *name = lua_tolstring(L, index, &length);
    if (length != strlen(name)) {
        lua_error_tr(L, "%s must not have a zero byte in its name", row->name);
    }
    if (length == 0) {
        lua_error_tr(L, "%s must name a file", row->name);
    }
    lua_pushvalue(L, index);
    if (find_known_name(L, kind, &asset_index)) {
        return asset_index;
    }
    bool is_added = script_question_ask(SCRIPT_ASK_ASSET, name, &answer, NULL) &&
                    kind->check(answer.real_path, &answer.error) &&
                    add_asset(L, kind, name, answer.real_path, &asset_index, &answer.error);
    if (!is_added) {
        lua_error_tr(L, "%s: %s", name, answer.error.message);
    }
    remember_name(L, kind, asset_index);
    return asset_index;
}

void read_mesh_name(lua_State *L, int index, const Parameter *row, void *field) {
    static const AssetNameKind kind = {N_("the name of a model file"), mesh_file_check,
                                       scene_add_mesh};
    *(size_t *)field = read_asset_name(L, index, row, &kind);
}

void read_texture_name(lua_State *L, int index, const Parameter *row, void *field) {
    static const AssetNameKind kind = {N_("the name of a picture file"), texture_file_check,
                                       scene_add_texture};
    *(size_t *)field = read_asset_name(L, index, row, &kind) + 1;
}
