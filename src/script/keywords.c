/**
 * @file
 * @brief The words of the scene language that add to a scene.
 */
#include "script/keywords.h"

#include "script/raise.h"
#include "script/read.h"
#include "script/run.h"
#include "script/sandbox.h"

#include <lauxlib.h>

/** What a call of a word has read. */
typedef struct Call {
    const Keyword *keyword;     /**< The word. */
    size_t kind;                /**< Which shape it is, in the engines' order; if it is one. */
    const void *values;         /**< The keyword's struct, finished. */
    size_t material;            /**< Place of the material that it wears; if it is a shape. */
    const Transform *transform; /**< What becomes of it; NULL: nothing, or it is no shape. */
} Call;

/**
 * Puts what a call has read into the scene.
 * @param[in,out] scene  The scene.
 * @param call           What was read; copied.
 * @param[out] error     What is wrong.
 * @return false if the scene is full.
 */
typedef bool Adder(Scene *scene, const Call *call, Error *error);

/** A word of the language: a keyword, and what becomes of what it reads. */
typedef struct Word {
    const Keyword *keyword; /**< Its name and fields. */
    Adder *add;             /**< What becomes of them. */
    bool is_shape;          /**< Whether it takes the fields of every shape too. */
    size_t kind;            /**< Which shape, in the engines' order. */
} Word;

/** What the words return: a thing of the scene. */
typedef struct Thing {
    size_t material; /**< Place of the material that it is, or wears. */
} Thing;

/** Replaces the camera. See #Adder. @param scene See there. @param call A Camera.
 *  @param error Not used. @return true */
static bool add_camera(Scene *scene, const Call *call, Error *error) {
    (void)error;
    scene->camera = *(const Camera *)call->values;
    scene->has_camera = true;
    return true;
}

/** Replaces size and quality of the picture. See #Adder. @param scene See there.
 *  @param call An Image. @param error Not used. @return true */
static bool add_image(Scene *scene, const Call *call, Error *error) {
    (void)error;
    scene->image = *(const Image *)call->values;
    return true;
}

/** Replaces the sky. See #Adder. @param scene See there. @param call A Sky.
 *  @param error Not used. @return true */
static bool add_sky(Scene *scene, const Call *call, Error *error) {
    (void)error;
    scene->sky = *(const Sky *)call->values;
    return true;
}

/** Adds a lamp or a sun. See #Adder. @param scene See there. @param call A Light.
 *  @param error See there. @return See there. */
static bool add_light(Scene *scene, const Call *call, Error *error) {
    return scene_add_light(scene, call->values, error);
}

/** Adds a material. See #Adder. @param scene See there. @param call A Material.
 *  @param error See there. @return See there. */
static bool add_material(Scene *scene, const Call *call, Error *error) {
    return scene_add_material(scene, call->values, error);
}

/** Adds a shape. See #Adder. @param scene See there. @param call The shape's parameters.
 *  @param error See there. @return See there. */
static bool add_shape(Scene *scene, const Call *call, Error *error) {
    bool is_field = call->keyword->parameters->type == PARAMETER_FIELD;
    if (is_field && scene->materials[call->material].texture > 0) {
        return error_set(error, STATUS_SCENE, "%s takes no picture: no point of it has a (u, v)",
                         call->keyword->name);
    }
    return scene_add_shape(scene, call->kind, call->keyword, call->values, call->material, error) &&
           (!call->transform || scene_transform_shape(scene, call->transform, error));
}

/** The words of every scene. */
static const Word words[] = {{.keyword = &camera_keyword, .add = add_camera},
                             {.keyword = &image_keyword, .add = add_image},
                             {.keyword = &sky_keyword, .add = add_sky},
                             {.keyword = &light_keyword, .add = add_light},
                             {.keyword = &sun_keyword, .add = add_light},
                             {.keyword = &material_keyword, .add = add_material}};

/** What `ambient` takes. */
static const Parameter ambient_row = {.name = "ambient",
                                      .type = PARAMETER_COLOR,
                                      .minimum = 0,
                                      .maximum = INTENSITY_MAXIMUM,
                                      .unit = "linear light",
                                      .help = "light from everywhere"};

/**
 * Reads the field `material` of a shape's table.
 * @param L  The state; the table is the first argument.
 * @return Its place; that of the matt white one where there is no such field.
 */
static size_t read_material(lua_State *L) {
    if (lua_getfield(L, 1, material_keyword.name) == LUA_TNIL) {
        return 0;
    }
    const Thing *thing = luaL_testudata(L, -1, material_keyword.name);
    if (!thing) {
        raise_error(L, "material must be what material { ... } has returned, not %s",
                    read_describe(L, lua_gettop(L)));
        return 0;
    }
    return thing->material;
}

/**
 * Puts a thing of the scene on the stack. It can be handed on, and that is all.
 * @param L         The state.
 * @param name      The keyword that made it.
 * @param material  Place of the material that it is, or wears.
 */
static void push_thing(lua_State *L, const char *name, size_t material) {
    Thing *thing = lua_newuserdatauv(L, sizeof *thing, 0);
    thing->material = material;
    if (luaL_newmetatable(L, name)) {
        lua_pushboolean(L, false);
        lua_setfield(L, -2, "__metatable");
    }
    lua_setmetatable(L, -2);
}

/**
 * Reads what every shape takes besides its own fields.
 * @param L              The state; the table is the first argument.
 * @param[in,out] call   What was read; a struct that it points to is Lua's, and on the stack.
 */
static void read_shape(lua_State *L, Call *call) {
    uint64_t given;
    const Transform *transform = read_fields(L, &transform_keyword, &given);
    call->transform = given ? transform : NULL;
    call->material = read_material(L);
}

/**
 * Reads all that a word was called with.
 * @param L     The state, with the table.
 * @param word  The word.
 * @return What was read; its structs are Lua's, and on the stack.
 */
static Call read_call(lua_State *L, const Word *word) {
    const Keyword *const keywords[] = {word->keyword, word->is_shape ? &transform_keyword : NULL,
                                       NULL};
    uint64_t given;
    read_check_names(L, keywords, word->is_shape ? material_keyword.name : NULL);
    Call call = {.keyword = word->keyword, .kind = word->kind};
    call.values = read_fields(L, word->keyword, &given);
    if (word->is_shape) {
        read_shape(L, &call);
    }
    return call;
}

/**
 * Does what a word of the language stands for. See lua_CFunction.
 * @param L  The state, with the table; the #Word is the first upvalue.
 * @return 1: the thing that was made.
 */
static int call_word(lua_State *L) {
    const Word *word = lua_touserdata(L, lua_upvalueindex(1));
    Scene *scene = ((Run *)sandbox_of(L)->context)->scene;
    // Noted when this function was called: the scene file is the first of its files.
    Location here = sandbox_of(L)->report->location;
    Error error = {0};
    Call call = read_call(L, word);
    if (!word->add(scene, &call, &error)) {
        return raise_error(L, "%s", error.message);
    }
    if (word->is_shape && here.file == 0) {
        scene->shapes[scene->shape_count - 1].line = here.line;
    }
    bool is_material = word->keyword == &material_keyword;
    push_thing(L, word->keyword->name, is_material ? scene->material_count - 1 : call.material);
    return 1;
}

/**
 * Sets the light from everywhere: `ambient { 0.1, 0.1, 0.1 }`. See lua_CFunction.
 * @param L  The state, with a colour.
 * @return 1: the thing that was made.
 */
static int call_ambient(lua_State *L) {
    Scene *scene = ((Run *)sandbox_of(L)->context)->scene;
    if (lua_gettop(L) != 1) {
        return raise_error(L, "ambient takes one colour: ambient { red, green, blue }");
    }
    read_value(L, 1, &ambient_row, &scene->ambient);
    push_thing(L, ambient_row.name, 0);
    return 1;
}

/**
 * Makes a word a global one.
 * @param L     The state.
 * @param word  The word; copied.
 */
static void open_word(lua_State *L, const Word *word) {
    Word *kept = lua_newuserdatauv(L, sizeof *kept, 0);
    *kept = *word;
    lua_pushcclosure(L, call_word, 1);
    lua_setglobal(L, word->keyword->name);
}

void keywords_open(lua_State *L) {
    const Run *run = sandbox_of(L)->context;
    const Keyword *const *shapes = run->request->shape_keywords;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        open_word(L, &words[i]);
    }
    for (size_t i = 0; shapes[i]; i++) {
        open_word(L, &(Word){.keyword = shapes[i], .add = add_shape, .is_shape = true, .kind = i});
    }
    lua_register(L, ambient_row.name, call_ambient);
}
