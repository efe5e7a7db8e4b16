/**
 * @file
 * @brief Keywords of the scene language that add to a scene.
 */
#include "script/keywords.h"

#include "script/lua_error.h"
#include "script/read_parameters.h"
#include "script/script_run.h"
#include "script/script_sandbox.h"

#include <lauxlib.h>

/** The arguments of a keyword, as read. */
typedef struct KeywordCall {
    const Keyword *keyword;     /**< The keyword. */
    size_t kind;                /**< For shapes and lights: index of the class. */
    const void *values;         /**< The keyword's struct, finished. */
    size_t material;            /**< For shapes: index of the material in #Scene.materials. */
    const Transform *transform; /**< For shapes: the transform; NULL: none. */
    SceneOrigin origin;         /**< Where the call is. */
} KeywordCall;

/** Adds the result of a call to the scene. @return false when the scene's memory is full. */
typedef bool AddFunction(Scene *scene, const KeywordCall *call, Error *error);

/** A keyword with the function that adds its result to the scene. */
typedef struct KeywordFunction {
    const Keyword *keyword; /**< Its name and fields. */
    AddFunction *add;       /**< Adds the result to the scene. */
    bool is_shape;          /**< Whether it takes the fields of all shapes. */
    size_t kind;            /**< Index of the shape's or light's class. */
    int calls;              /**< Number of its calls in this run. */
} KeywordFunction;

/** Result of a keyword in Lua: a reference to a part of the scene. */
typedef struct SceneHandle {
    size_t material; /**< Index in #Scene.materials: of the material itself, or of that of the
                        shape. */
} SceneHandle;

/** Replaces the camera. See #AddFunction. @return true */
static bool add_camera(Scene *scene, const KeywordCall *call, Error *error) {
    (void)error;
    scene->camera = *(const SceneCamera *)call->values;
    scene->has_camera = true;
    return true;
}

/** Replaces size and quality of the image. See #AddFunction. @return true */
static bool add_image(Scene *scene, const KeywordCall *call, Error *error) {
    (void)error;
    scene->image = *(const SceneImage *)call->values;
    return true;
}

/** Replaces the sky. See #AddFunction. @return true */
static bool add_sky(Scene *scene, const KeywordCall *call, Error *error) {
    (void)error;
    scene->sky = *(const SceneSky *)call->values;
    return true;
}

/** Adds a light. See #AddFunction. @return false when the scene's memory is full. */
static bool add_light(Scene *scene, const KeywordCall *call, Error *error) {
    SceneLight light = *(const SceneLight *)call->values;
    light.class_index = call->kind;
    light.origin = call->origin;
    return scene_add_light(scene, &light, error);
}

/** Adds a material. See #AddFunction. @return false when the scene's memory is full. */
static bool add_material(Scene *scene, const KeywordCall *call, Error *error) {
    SceneMaterial material = *(const SceneMaterial *)call->values;
    material.origin = call->origin;
    return scene_add_material(scene, &material, error);
}

/** Adds a shape. See #AddFunction. @return false when the scene's memory is full. */
static bool add_shape(Scene *scene, const KeywordCall *call, Error *error) {
    if (keyword_has_field(call->keyword) && scene->materials[call->material].texture_id > 0) {
        return error_set(error, STATUS_SCENE, "%s takes no picture: no point of it has a (u, v)",
                         call->keyword->name);
    }
    if (!scene_add_shape(scene, call->kind, call->keyword, call->values, call->material, error)) {
        return false;
    }
    scene->shapes[scene->shape_count - 1].origin = call->origin;
    return !call->transform || scene_set_last_transform(scene, call->transform, error);
}

/** The keywords of every scene, apart from shapes and lights. */
static const KeywordFunction scene_keywords[] = {
    {.keyword = &scene_camera_keyword, .add = add_camera},
    {.keyword = &scene_image_keyword, .add = add_image},
    {.keyword = &scene_sky_keyword, .add = add_sky},
    {.keyword = &scene_material_keyword, .add = add_material}};

/** Argument of `ambient`. */
static const Parameter ambient_parameter = {.name = "ambient",
                                            .type = PARAMETER_COLOR,
                                            .minimum = 0,
                                            .maximum = INTENSITY_MAXIMUM,
                                            .unit = "linear light",
                                            .help = "light from everywhere"};

/**
 * Reads the field `material` of a shape.
 * @param L  The state; the table is the first argument.
 * @return Index of the material in #Scene.materials; 0, diffuse white, without the field.
 */
static size_t read_material(lua_State *L) {
    if (lua_getfield(L, 1, scene_material_keyword.name) == LUA_TNIL) {
        return 0;
    }
    const SceneHandle *handle = luaL_testudata(L, -1, scene_material_keyword.name);
    if (!handle) {
        lua_error_tr(L, "material must be what material { ... } has returned, not %s",
                     read_describe(L, lua_gettop(L)));
        return 0;
    }
    return handle->material;
}

/**
 * Pushes a reference to a part of the scene. Scripts can only pass it on.
 * @param L         The state.
 * @param name      The keyword that created it.
 * @param material  Index of its material in #Scene.materials.
 */
static void push_handle(lua_State *L, const char *name, size_t material) {
    SceneHandle *handle = lua_newuserdatauv(L, sizeof *handle, 0);
    handle->material = material;
    if (luaL_newmetatable(L, name)) {
        lua_pushboolean(L, false);
        lua_setfield(L, -2, "__metatable");
    }
    lua_setmetatable(L, -2);
}

/**
 * Reads the fields of all shapes: material and transform.
 * @param L             The state; the table is the first argument.
 * @param[in,out] call  The arguments; its structs are owned by Lua and lie on the stack.
 */
static void read_shape_fields(lua_State *L, KeywordCall *call) {
    uint64_t given;
    const Transform *transform = read_fields(L, &transform_keyword, &given);
    call->transform = given ? transform : NULL;
    call->material = read_material(L);
}

/**
 * Reads all arguments of a keyword.
 * @param L         The state, with the table.
 * @param function  The keyword.
 * @return The arguments; its structs are owned by Lua and lie on the stack.
 */
static KeywordCall read_call(lua_State *L, const KeywordFunction *function) {
    const Keyword *const keywords[] = {function->keyword,
                                       function->is_shape ? &transform_keyword : NULL, NULL};
    read_check_arguments(L, keywords, function->is_shape ? &scene_material_keyword : NULL);
    KeywordCall call = {.keyword = function->keyword, .kind = function->kind};
    call.values = read_fields(L, function->keyword, &call.origin.given);
    if (function->is_shape) {
        read_shape_fields(L, &call);
    }
    return call;
}

/** Pushes the value of an override as a scene file would write it. */
static void push_override(lua_State *L, const Parameter *row, const double *numbers) {
    int count = parameter_number_count(row->type);
    if (row->type == PARAMETER_BOOLEAN) {
        lua_pushboolean(L, numbers[0] != 0);
    } else if (row->type == PARAMETER_CHOICE) {
        lua_pushstring(L, row->choices[(int)numbers[0]]);
    } else if (count == 1) {
        lua_pushnumber(L, numbers[0]);
    } else {
        lua_createtable(L, count, 0);
        for (int i = 0; i < count; i++) {
            lua_pushnumber(L, numbers[i]);
            lua_rawseti(L, -2, i + 1);
        }
    }
}

/** Replaces the argument of a call by a copy of the table, which other calls may share; fields that
 *  it inherits stay. */
static void copy_argument(lua_State *L) {
    lua_newtable(L);
    if (lua_getmetatable(L, 1)) {
        lua_setmetatable(L, -2);
    }
    lua_pushnil(L);
    while (lua_next(L, 1)) {
        lua_pushvalue(L, -2);
        lua_insert(L, -2);
        lua_rawset(L, -4);
    }
    lua_replace(L, 1);
}

/**
 * Gives a call the values that replace those of the file. They are checked like the file's own.
 * @param L         The state, with the arguments.
 * @param function  The keyword; this call is counted.
 */
static void apply_overrides(lua_State *L, const KeywordFunction *function) {
    const ScriptRequest *request = ((ScriptRun *)script_sandbox_of(L)->context)->request;
    bool is_copied = false;
    for (size_t i = 0; i < request->override_count && lua_istable(L, 1); i++) {
        const SceneOverride *override = &request->overrides[i];
        const Parameter *row = scene_object_row(override->keyword, override->row);
        if (override->number != function->calls || !row ||
            scene_object_keyword(override->keyword) != function->keyword ||
            !parameter_check_numbers(row, override->numbers, NULL)) {
            continue;
        }
        if (!is_copied) {
            copy_argument(L);
            is_copied = true;
        }
        lua_pushstring(L, row->name);
        push_override(L, row, override->numbers);
        lua_rawset(L, 1);
    }
}

/**
 * Calls a keyword. See lua_CFunction.
 * @param L  The state, with the table; the #KeywordFunction is the first upvalue.
 * @return 1: the reference to the new part of the scene.
 */
static int call_keyword(lua_State *L) {
    KeywordFunction *function = lua_touserdata(L, lua_upvalueindex(1));
    Scene *scene = ((ScriptRun *)script_sandbox_of(L)->context)->scene;
    // The line of this call; file 0 is the scene file.
    SourceLocation location = script_sandbox_of(L)->result->location;
    Error error = {0};
    function->calls++;
    apply_overrides(L, function);
    KeywordCall call = read_call(L, function);
    call.origin.number = function->calls;
    call.origin.line = location.file == 0 ? location.line : 0;
    if (!function->add(scene, &call, &error)) {
        return lua_error_tr(L, "%s", error.message);
    }
    bool is_material = function->keyword == &scene_material_keyword;
    push_handle(L, function->keyword->name,
                is_material ? scene->material_count - 1 : call.material);
    return 1;
}

/**
 * Sets the ambient light: `ambient { 0.1, 0.1, 0.1 }`. See lua_CFunction.
 * @param L  The state, with a colour.
 * @return 1: the reference to the new part of the scene.
 */
static int call_ambient(lua_State *L) {
    Scene *scene = ((ScriptRun *)script_sandbox_of(L)->context)->scene;
    if (lua_gettop(L) != 1) {
        return lua_error_tr(L, "ambient takes one colour: ambient { red, green, blue }");
    }
    read_value(L, 1, &ambient_parameter, &scene->ambient);
    push_handle(L, ambient_parameter.name, 0);
    return 1;
}

/** Adds a keyword as a global function. */
static void register_keyword(lua_State *L, const KeywordFunction *function) {
    KeywordFunction *copy = lua_newuserdatauv(L, sizeof *copy, 0);
    *copy = *function;
    lua_pushcclosure(L, call_keyword, 1);
    lua_setglobal(L, function->keyword->name);
}

void keywords_open(lua_State *L) {
    const ScriptRun *run = script_sandbox_of(L)->context;
    const Keyword *const *shapes = run->request->shape_keywords;
    for (size_t i = 0; i < sizeof scene_keywords / sizeof *scene_keywords; i++) {
        register_keyword(L, &scene_keywords[i]);
    }
    for (size_t i = 0; scene_light_classes[i]; i++) {
        register_keyword(L, &(KeywordFunction){.keyword = scene_light_classes[i]->keyword,
                                               .add = add_light,
                                               .kind = i});
    }
    for (size_t i = 0; shapes[i]; i++) {
        register_keyword(L,
                         &(KeywordFunction){
                             .keyword = shapes[i], .add = add_shape, .is_shape = true, .kind = i});
    }
    lua_register(L, ambient_parameter.name, call_ambient);
}
