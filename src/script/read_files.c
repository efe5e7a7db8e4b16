/**
 * @file
 * @brief Names of files in the tables of a scene.
 */
#include "assets/mesh_file.h"
#include "assets/texture_file.h"
#include "dioptre/language.h"
#include "script/file.h"
#include "script/raise.h"
#include "script/read.h"
#include "script/run.h"
#include "script/sandbox.h"
#include "script/text.h"

#include <lauxlib.h>
#include <string.h>

/** A kind of file that a scene can name. */
typedef struct FileKind {
    const char *wanted; /**< What a name must be, in words. */
    /** Says whether a file may be of this kind, by its name and kind. @param path The file.
     *  @param[out] error Why not. @return Whether it may. */
    bool (*check)(const char *path, Error *error);
    /** Notes it, once. @param scene The scene. @param file The file. @param[out] place Its place.
     *  @param[out] error What is wrong. @return false when the scene is full. */
    bool (*add)(Scene *scene, const SceneFile *file, size_t *place, Error *error);
} FileKind;

/**
 * Notes a file in the scene, unless it is there already.
 * @param L            The state.
 * @param kind         What kind of file it is.
 * @param name         The file's name.
 * @param real         Where it is.
 * @param[out] place   Its place in the scene.
 * @param[out] error   What is wrong.
 * @return false when the scene is full.
 */
static bool note_file(lua_State *L, const FileKind *kind, const char *name, const char *real,
                      size_t *place, Error *error) {
    const Sandbox *sandbox = sandbox_of(L);
    const Run *run = sandbox->context;
    char where[TEXT_PATH_SIZE + sizeof ":-2147483648"];
    report_describe(sandbox->report, sandbox_location(L), where, sizeof where);
    SceneFile file = {.path = real, .name = name, .where = where};
    return kind->add(run->scene, &file, place, error);
}

/**
 * Reads the name of a file as its place in the scene.
 * @param L      The state.
 * @param index  Where the name is.
 * @param row    What it should be.
 * @param kind   What kind of file it names.
 * @return Its place.
 */
static size_t read_file(lua_State *L, int index, const Parameter *row, const FileKind *kind) {
    const Run *run = sandbox_of(L)->context;
    char shown[PATH_MAX], real[PATH_MAX];
    size_t length, place = 0;
    Error error = {0};
    if (lua_type(L, index) != LUA_TSTRING) {
        read_raise_type(L, index, row, kind->wanted);
    }
    const char *name = lua_tolstring(L, index, &length);
    if (length != strlen(name)) {
        raise_error(L, "%s must not have a zero byte in its name", row->name);
    }
    bool is_fine = file_find(run->request, name, shown, real, &error) &&
                   kind->check(real, &error) && note_file(L, kind, name, real, &place, &error);
    if (!is_fine) {
        raise_error(L, "%s: %s", name, error.message);
    }
    return place;
}

void read_mesh_name(lua_State *L, int index, const Parameter *row, void *field) {
    static const FileKind kind = {N_("the name of a model file"), mesh_file_check, scene_add_mesh};
    *(size_t *)field = read_file(L, index, row, &kind);
}

void read_texture_name(lua_State *L, int index, const Parameter *row, void *field) {
    static const FileKind kind = {N_("the name of a picture file"), texture_file_check,
                                  scene_add_texture};
    *(size_t *)field = read_file(L, index, row, &kind) + 1;
}
