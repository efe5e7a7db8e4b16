/**
 * @file
 * @brief Tests of scene files: what they can say, what is said of wrong ones, what they cannot do.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "dioptre/script.h"
#include "assets/child.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/** Number of items of an array. */
#define COUNT(array) (sizeof(array) / sizeof *(array))

/** Where the scene files of these tests lie, from the top of the sources. */
#define SCRIPTS "tests/scripts/"

// --- a shape of our own, so that these tests do not hang on the tracer --------------------------

/** A shape with a field of every type. */
typedef struct Ball {
    Vector3 center;  /**< A vector. */
    double radius;   /**< A number, above 0. */
    Vector3 axis;    /**< A direction. */
    Color tint;      /**< A colour, 0 to 1. */
    int rings;       /**< A whole number, 0 to 9. */
    bool is_hollow;  /**< A boolean. */
    int finish;      /**< A word. */
    double diameter; /**< Worked out from the radius. */
} Ball;

/** Words of the field `finish`. */
static const char *const finish_words[] = {"matt", "satin", "glossy", NULL};

/** Fields of the shape; the first is row 0. */
static const Parameter ball_parameters[] = {
    {.name = "center",
     .type = PARAMETER_VECTOR,
     .offset = offsetof(Ball, center),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM},
    {.name = "radius",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(Ball, radius),
     .maximum = LENGTH_MAXIMUM,
     .above_minimum = true},
    {.name = "axis",
     .type = PARAMETER_DIRECTION,
     .offset = offsetof(Ball, axis),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM},
    {.name = "tint", .type = PARAMETER_COLOR, .offset = offsetof(Ball, tint), .maximum = 1},
    {.name = "rings", .type = PARAMETER_INTEGER, .offset = offsetof(Ball, rings), .maximum = 9},
    {.name = "hollow", .type = PARAMETER_BOOLEAN, .offset = offsetof(Ball, is_hollow)},
    {.name = "finish",
     .type = PARAMETER_WORD,
     .offset = offsetof(Ball, finish),
     .words = finish_words},
    {0}};

/** A ball as it is when nothing is said. */
static const Ball ball_defaults = {.radius = 1, .axis = {0, 1, 0}, .tint = {1, 1, 1}};

/** Bits of the rows that were given: hollow and rings. */
enum { GIVEN_RINGS = 1 << 4, GIVEN_HOLLOW = 1 << 5 };

/** Works the diameter out; rings do not go with hollow. See #Keyword.finish. @param values A #Ball.
 *  @param given See there. @param error See there. @return See there. */
static bool ball_finish(void *values, uint64_t given, Error *error) {
    Ball *ball = values;
    ball->diameter = 2 * ball->radius;
    if ((given & GIVEN_RINGS) && (given & GIVEN_HOLLOW)) {
        return error_set(error, STATUS_SCENE, "sphere takes rings or hollow, not both");
    }
    return true;
}

/** A shape that these tests call sphere. */
static const Keyword ball_keyword = {.name = "sphere",
                                     .parameters = ball_parameters,
                                     .size = sizeof(Ball),
                                     .defaults = &ball_defaults,
                                     .finish = ball_finish};
/** Another, to tell kinds apart. */
static const Keyword other_keyword = {.name = "plane",
                                      .parameters = ball_parameters,
                                      .size = sizeof(Ball),
                                      .defaults = &ball_defaults};
/** What the scenes of these tests can name. */
static const Keyword *const shapes[] = {&other_keyword, &ball_keyword, NULL};

// --- helpers -------------------------------------------------------------------------------------

/** What the tests share: a folder that is empty at first and gone at the end. */
typedef struct Bench {
    char folder[64]; /**< The folder. */
    char path[128];  /**< A scene file in it. */
} Bench;

/** Makes the folder. @param state Becomes a #Bench. @return 0 when it is there. */
static int set_up(void **state) {
    Bench *bench = calloc(1, sizeof *bench);
    snprintf(bench->folder, sizeof bench->folder, "/tmp/dioptre-script-XXXXXX");
    bool is_made = mkdtemp(bench->folder) != NULL;
    snprintf(bench->path, sizeof bench->path, "%s/scene.lua", bench->folder);
    *state = bench;
    return is_made ? 0 : -1;
}

/** Removes the folder with all that is in it. @param state A #Bench. @return 0 when it is gone. */
static int tear_down(void **state) {
    Bench *bench = *state;
    char command[128];
    snprintf(command, sizeof command, "rm -rf '%s'", bench->folder);
    int status = system(command);
    free(bench);
    return status;
}

/** Writes a file. @param path Where. @param text What. @param length Bytes of it. */
static void write_bytes(const char *path, const char *text, size_t length) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
}

/** Writes a text file. @param path Where. @param text What. */
static void write_file(const char *path, const char *text) {
    write_bytes(path, text, strlen(text));
}

/** @return What to ask for, with limits that are wide enough. @param path The scene file. */
static ScriptRequest request_for(const char *path) {
    return (ScriptRequest){
        .path = path, .seconds = SCRIPT_SECONDS, .memory = SCRIPT_MEMORY, .shape_keywords = shapes};
}

/** @return The scene of a text, which must be good. @param bench Where. @param text The text. */
static Scene *load_good(const Bench *bench, const char *text) {
    Error error = {0};
    write_file(bench->path, text);
    ScriptRequest request = request_for(bench->path);
    Scene *scene = script_load(&request, &error);
    if (!scene) {
        fail_msg("%s\n%s", text, error.message);
    }
    assert_int_equal(error.status, STATUS_DONE);
    return scene;
}

/**
 * Checks that a scene is refused.
 * @param request  What to load.
 * @param place    How the message must begin.
 * @param words    What must be in it.
 */
static void assert_refused(const ScriptRequest *request, const char *place, const char *words) {
    Error error = {0};
    Scene *scene = script_load(request, &error);
    if (scene || error.status != STATUS_SCENE ||
        strncmp(error.message, place, strlen(place)) != 0 || !strstr(error.message, words)) {
        fail_msg("wanted: %s%s\ngot: (%d) %s", place, words, error.status,
                 scene ? "a scene" : error.message);
    }
}

/**
 * Checks that a text is refused.
 * @param bench    Where to put it.
 * @param text     The text.
 * @param line     The line that must be named.
 * @param words    What must be said.
 * @param limits   Its seconds and memory count; NULL: wide enough.
 */
static void assert_text_refused(const Bench *bench, const char *text, int line, const char *words,
                                const ScriptRequest *limits) {
    char place[160];
    ScriptRequest request = request_for(bench->path);
    if (limits) {
        request.seconds = limits->seconds;
        request.memory = limits->memory;
    }
    write_file(bench->path, text);
    snprintf(place, sizeof place, "%s:%d: ", bench->path, line);
    assert_refused(&request, place, words);
}

/** @return The parameters of a ball of a scene. @param scene The scene. @param i Which shape. */
static const Ball *ball_of(const Scene *scene, size_t i) {
    assert_true(i < scene->shape_count);
    return scene->shapes[i].parameters;
}

/** Checks a vector. @param v The vector. @param x Wanted. @param y Wanted. @param z Wanted. */
static void assert_vector(Vector3 v, double x, double y, double z) {
    assert_true(v.x == x && v.y == y && v.z == z);
}

/** Checks a colour. @param c The colour. @param r Wanted. @param g Wanted. @param b Wanted. */
static void assert_color(Color c, double r, double g, double b) {
    assert_true(c.red == r && c.green == g && c.blue == b);
}

// --- what scenes can say -------------------------------------------------------------------------

/** An empty scene with a camera has every default. @param state A #Bench. */
static void test_defaults(void **state) {
    Scene *scene = load_good(*state, "camera {}");
    assert_true(scene->has_camera);
    assert_vector(scene->camera.direction, 0, 0, -1);
    assert_int_equal(scene->image.width, 800);
    assert_color(scene->ambient, 0, 0, 0);
    assert_int_equal(scene->light_count, 0);
    assert_int_equal(scene->shape_count, 0);
    assert_int_equal(scene->material_count, 1);
    scene_destroy(scene);
}

/** Every keyword fills its struct. @param state A #Bench. */
static void test_keywords(void **state) {
    Scene *scene = load_good(
        *state, "camera { position = {0, 0, 6.5}, look_at = {0, 0, 0}, fov = 50 }\n"
                "image { width = 320, height = 200.0, encoding = 'linear', depth = 5 }\n"
                "ambient { 0.1, 0.2, 0.3 }\n"
                "sky { horizon = 0.5, zenith = {0, 0, 1} }\n"
                "light { position = {1, 2, 3}, intensity = 200, falloff = 'inverse_square' }\n"
                "light { color = {1, 0, 0} }\n");
    assert_vector(scene->camera.position, 0, 0, 6.5);
    assert_vector(scene->camera.direction, 0, 0, -1);
    assert_true(scene->camera.fov == 50);
    assert_int_equal(scene->image.width, 320);
    assert_int_equal(scene->image.height, 200);
    assert_int_equal(scene->image.encoding, ENCODING_LINEAR);
    assert_int_equal(scene->image.depth, 5);
    assert_color(scene->ambient, 0.1, 0.2, 0.3);
    assert_color(scene->sky.horizon, 0.5, 0.5, 0.5);
    assert_color(scene->sky.zenith, 0, 0, 1);
    assert_int_equal(scene->light_count, 2);
    assert_vector(scene->lights[0].position, 1, 2, 3);
    assert_true(scene->lights[0].intensity == 200);
    assert_int_equal(scene->lights[0].falloff, FALLOFF_INVERSE_SQUARE);
    assert_color(scene->lights[1].color, 1, 0, 0);
    scene_destroy(scene);
}

/** A field of every type arrives; finish works on it. @param state A #Bench. */
static void test_field_types(void **state) {
    Scene *scene =
        load_good(*state, "camera {}\n"
                          "sphere { center = {1, -2, 3.5}, radius = 4, axis = {0, 0, 2},\n"
                          "         tint = {0.25, 0.5, 1}, rings = 3.0, finish = 'glossy' }\n"
                          "plane { hollow = true }\n");
    const Ball *ball = ball_of(scene, 0);
    assert_vector(ball->center, 1, -2, 3.5);
    assert_vector(ball->axis, 0, 0, 2);
    assert_color(ball->tint, 0.25, 0.5, 1);
    assert_true(ball->radius == 4 && ball->diameter == 8);
    assert_int_equal(ball->rings, 3);
    assert_int_equal(ball->finish, 2);
    assert_false(ball->is_hollow);
    assert_int_equal(scene->shapes[0].kind, 1);
    assert_int_equal(scene->shapes[1].kind, 0);
    assert_true(ball_of(scene, 1)->is_hollow);
    assert_true(ball_of(scene, 1)->radius == 1);
    scene_destroy(scene);
}

/** Materials are handed on by what they return. @param state A #Bench. */
static void test_materials(void **state) {
    Scene *scene = load_good(
        *state, "camera {}\n"
                "local looks = { material { specular = 0.5 }, material { reflectivity = 0.8 } }\n"
                "sphere {}\n"
                "for i = 1, 2 do sphere { material = looks[i] } end\n"
                "local ball = sphere { material = looks[1] }\n"
                "assert(ball ~= nil and looks[1] ~= looks[2])\n");
    assert_int_equal(scene->material_count, 3);
    const size_t wanted[] = {0, 1, 2, 1};
    assert_int_equal(scene->shape_count, COUNT(wanted));
    for (size_t i = 0; i < COUNT(wanted); i++) {
        assert_int_equal(scene->shapes[i].material, wanted[i]);
    }
    assert_true(scene->materials[1].specular == 0.5);
    assert_color(scene->materials[2].reflectivity, 0.8, 0.8, 0.8);
    scene_destroy(scene);
}

/** One colour, written in a way. */
typedef struct ColorCase {
    const char *text; /**< The scene. */
    Color wanted;     /**< Its ambient light. */
} ColorCase;

/** Colours may be written in three ways; the last call counts. @param state A #Bench. */
static void test_colors(void **state) {
    static const ColorCase cases[] = {
        {"camera {} ambient { 0.15, 0.25, 0.5 }", {0.15, 0.25, 0.5}},
        {"camera {} ambient(0.2)", {0.2, 0.2, 0.2}},
        {"camera {} ambient '#ff0000'", {1, 0, 0}},
        {"camera {} ambient(1) ambient '#000000'", {0, 0, 0}},
        // The two pieces of the curve: 10/255 is on the straight one, 11/255 on the other.
        {"camera {} ambient '#0A0b80'",
         {10 / 255.0 / 12.92, 0.0033465357638991595, 0.21586050011389926}},
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        Scene *scene = load_good(*state, cases[i].text);
        const Color *wanted = &cases[i].wanted;
        assert_true(fabs(scene->ambient.red - wanted->red) < 1e-16);
        assert_true(fabs(scene->ambient.green - wanted->green) < 1e-16);
        assert_true(fabs(scene->ambient.blue - wanted->blue) < 1e-16);
        scene_destroy(scene);
    }
}

/** Camera, image and sky are replaced by a later call. @param state A #Bench. */
static void test_later_calls_replace(void **state) {
    Scene *scene = load_good(*state, "camera { fov = 20 } image { width = 5 } sky { color = 1 }\n"
                                     "camera { fov = 30 } image { depth = 2 } sky {}\n");
    assert_true(scene->camera.fov == 30);
    assert_int_equal(scene->image.width, 800);
    assert_int_equal(scene->image.depth, 2);
    assert_color(scene->sky.zenith, 0, 0, 0);
    scene_destroy(scene);
}

/** A scene knows the time. @param state A #Bench. */
static void test_time(void **state) {
    const Bench *bench = *state;
    write_file(bench->path, "camera {} sphere { center = {t, 0, 0} }");
    ScriptRequest request = request_for(bench->path);
    request.time = 2.5;
    Scene *scene = script_load(&request, NULL);
    assert_non_null(scene);
    assert_vector(ball_of(scene, 0)->center, 2.5, 0, 0);
    scene_destroy(scene);
}

/** Fields may be inherited, as Lua does it. @param state A #Bench. */
static void test_inherited_fields(void **state) {
    Scene *scene = load_good(*state, "camera {}\n"
                                     "local big = { __index = { radius = 7 } }\n"
                                     "sphere(setmetatable({ rings = 1 }, big))\n");
    assert_true(ball_of(scene, 0)->radius == 7);
    assert_int_equal(ball_of(scene, 0)->rings, 1);
    scene_destroy(scene);
}

/** Random numbers and the order of tables are the same on every run. @param state A #Bench. */
static void test_determinism(void **state) {
    Scene *scene = load_good(
        *state, "camera {}\n"
                "sphere { center = {math.random(), math.random(1000), math.random()} }\n"
                "local word = ''\n"
                "local list = { 'a', 'b', [9] = 'd', [-1] = 'Z', [2.5] = 'e', [1e3] = 'dd',\n"
                "               one = 'g', Two = 'f', [true] = 'i', [false] = 'h' }\n"
                "for key, value in pairs(list) do word = word .. value; list[key] = nil end\n"
                "assert(word == 'Zabdddefghi' and next(list) == nil, word)\n"
                "local other = {}\n"
                "for key in pairs { [list] = 1, [print] = 2, [3] = 3 } do\n"
                "  other[#other + 1] = type(key)\n"
                "end\n"
                "assert(#other == 3 and other[1] == 'number')\n");
    // xoshiro256** from our seed: the same on every machine.
    assert_vector(ball_of(scene, 0)->center, 0.84161702650617698, 295, 0.33064000904983071);
    scene_destroy(scene);
}

/** Marks before the text do not move its lines. @param state A #Bench. */
static void test_marks_before_the_text(void **state) {
    const char *text = "\xEF\xBB\xBF#!/usr/bin/env dioptre\ncamera {}\n";
    scene_destroy(load_good(*state, text));
    assert_text_refused(*state, "#!/usr/bin/env dioptre\ncamera {}\nx = y", 3, "`y`", NULL);
}

// --- what is said of wrong scenes ----------------------------------------------------------------

/** A wrong scene. */
typedef struct WrongCase {
    const char *text;  /**< The scene. */
    int line;          /**< The line that is to blame. */
    const char *words; /**< What must be said. */
} WrongCase;

/** Each wrong text is refused with its line and the right words. @param state A #Bench.
 *  @param cases The texts. @param count How many. */
static void assert_all_refused(void **state, const WrongCase *cases, size_t count) {
    for (size_t i = 0; i < count; i++) {
        assert_text_refused(*state, cases[i].text, cases[i].line, cases[i].words, NULL);
    }
}

/** Words and fields that are not there. @param state A #Bench. */
static void test_unknown_words(void **state) {
    static const WrongCase cases[] = {
        {"camera {}\n\nspere { radius = 1 }", 3, "unknown word `spere`; did you mean `sphere`?"},
        {"Sphere {}", 1, "did you mean `sphere`?"},
        {"camra {}", 1, "did you mean `camera`?"},
        {"local x = colour", 1, "unknown word `colour`"},
        {"x = math.sine(1)", 1, "unknown word `math.sine`; did you mean `math.sin`?"},
        {"x = ('x'):uper()", 1, "did you mean `string.upper`?"},
        {"sphere {\n  radius = 1,\n  radus = 2\n}", 1,
         "sphere has no field `radus`; did you mean `radius`?"},
        {"sphere { cetner = {0, 0, 0} }", 1, "did you mean `center`?"},
        {"sphere { materail = 1 }", 1, "did you mean `material`?"},
        {"light { material = 1 }", 1, "light has no field `material`"},
        {"sphere { xyzzy = 1 }", 1, "sphere has no field `xyzzy`"},
        {"sphere { finish = 'glosy' }", 1,
         "must be `matt`, `satin` or `glossy`, not `glosy`; did you mean `glossy`?"},
        {"light { falloff = 'linear' }", 1,
         "falloff must be `none` or `inverse_square`, not `linear`"},
    };
    assert_all_refused(state, cases, COUNT(cases));
}

/** Values of a wrong type. @param state A #Bench. */
static void test_wrong_types(void **state) {
    static const WrongCase cases[] = {
        {"sphere { radius = 'x' }", 1, "radius must be a number, not a string"},
        {"sphere { radius = '1' }", 1, "radius must be a number, not a string"},
        {"sphere { radius = false }", 1, "radius must be a number, not a boolean"},
        {"sphere { radius = {1} }", 1, "radius must be a number, not a table"},
        {"sphere { rings = 1.5 }", 1, "rings must be a whole number, not 1.5"},
        {"sphere { hollow = 1 }", 1, "hollow must be true or false, not a number"},
        {"sphere { finish = 1 }", 1, "finish must be `matt`, `satin` or `glossy`, not a number"},
        {"sphere { center = 1 }", 1, "center must be three numbers {x, y, z}, not a number"},
        {"sphere { center = {1, 2} }", 1, "there are 2 things"},
        {"sphere { center = {1, 2, 3, 4} }", 1, "there are 4 things"},
        {"sphere { center = {x = 1, y = 2, z = 3} }", 1, "three numbers {x, y, z}"},
        {"sphere { center = {1, 2, 3, w = 4} }", 1, "three numbers {x, y, z}"},
        {"sphere { center = {1, '2', 3} }", 1, "number 2 of them is a string"},
        {"sphere { tint = true }", 1, "tint must be a colour"},
        {"sphere { tint = '#ff000' }", 1, "not \"#ff000\""},
        {"sphere { tint = 'red' }", 1, "tint must be a colour such as \"#ff8000\""},
        {"sphere { tint = '#ff00gg' }", 1, "tint must be a colour"},
        {"sphere { {0, 0, 0}, radius = 1 }", 1, "sphere takes fields with names"},
        {"sphere(1)", 1, "sphere takes its fields in braces"},
        {"sphere()", 1, "sphere takes its fields in braces"},
        {"sphere({}, {})", 1, "sphere takes its fields in braces"},
        {"sphere { material = 'red' }", 1,
         "must be what material { ... } has returned, not a string"},
        {"sphere { material = { color = 1 } }", 1, "not a table"},
        {"sphere { material = sphere {} }", 1, "not a sphere"},
        {"sphere { material = image {} }", 1, "not an image"},
        {"ambient()", 1, "ambient takes one colour"},
        {"ambient(print)", 1, "ambient must be a colour"},
    };
    assert_all_refused(state, cases, COUNT(cases));
}

/** Values that are out of range, or no numbers, or do not fit together. @param state A #Bench. */
static void test_wrong_values(void **state) {
    static const WrongCase cases[] = {
        {"sphere { radius = 0 }", 1, "radius must be above 0"},
        {"sphere { radius = 1e16 }", 1, "radius must be"},
        {"sphere { radius = 0/0 }", 1, "radius must be a finite number"},
        {"sphere { radius = 1/0 }", 1, "radius must be a finite number"},
        {"sphere { center = {0, -1/0, 0} }", 1, "center must be a finite number"},
        {"sphere { center = {0, 0, -1e300} }", 1, "center must be"},
        {"sphere { rings = 10 }", 1, "rings must be"},
        {"sphere { rings = -1 }", 1, "rings must be"},
        {"sphere { rings = 2^53 }", 1, "rings must be"},
        {"sphere { axis = {0, 0, 0} }", 1, "axis must not be zero"},
        {"sphere { tint = {0, 2, 0} }", 1, "tint must be"},
        {"sphere { tint = -0.1 }", 1, "tint must be"},
        {"ambient(-1)", 1, "ambient must be"},
        {"ambient { 0, 1e16, 0 }", 1, "ambient must be"},
        {"ambient(0/0)", 1, "ambient must be a finite number"},
        {"image { width = 0 }", 1, "width must be"},
        {"camera { fov = 180 }", 1, "fov must be"},
        {"camera { look_at = {0, 0, 0} }", 1, "own position"},
        {"camera { look_at = {0, 0, 1}, pan = 3 }", 1, "only one of"},
        {"sphere { rings = 1, hollow = true }", 1, "rings or hollow, not both"},
        {"-- nothing\n\n", 1, "there is no camera"},
        {"", 1, "there is no camera"},
    };
    assert_all_refused(state, cases, COUNT(cases));
}

/** Errors of Lua itself, at the innermost line of the scene. @param state A #Bench. */
static void test_lua_errors(void **state) {
    static const WrongCase cases[] = {
        {"camera {\n  fov = = 2\n}", 2, "unexpected symbol near '='"},
        {"camera {}\nif true then", 2, "'end' expected"},
        {"local x\n\nx.y = 1", 3, "attempt to index a nil value (local 'x')"},
        {"local function f(r)\n  sphere { radius = r }\nend\nf(1)\nf(-1)", 2, "radius must be"},
        {"local function f(r)\n  return sphere { radius = r }\nend\nf(-1)", 2, "radius must be"},
        {"local function f()\n  error('from here', 2)\nend\nf()", 4, "from here"},
        {"local good, message = pcall(function()\n  error('inside')\nend)\nerror(message, 0)", 2,
         "inside"},
        {"\npcall(error, 'caught')\nerror { 1 }", 3,
         "error was called with a table, not with words"},
        {"\nerror(nil)", 2, "error was called with a nil"},
        {"\nerror()", 2, "error was called with a nil"},
        {"\nerror(12)", 2, "error was called with a number"},
        {"\nerror('no line', 0)", 2, "no line"},
        {"\nassert(false)", 2, "assertion failed!"},
        {"\nassert(nil, 'a reason')", 2, "a reason"},
        {"local x = setmetatable({}, { __index = function(_, k)\n  error('no ' .. k)\nend })\nx = "
         "x.foo",
         2, "no foo"},
        {"sphere(setmetatable({}, { __index = function(_, k)\n  error('no ' .. k)\nend }))", 2,
         "no center"},
        {"print(setmetatable({}, { __tostring = function()\n  error('shy')\nend }))", 2, "shy"},
        {"tostring(setmetatable({}, { __tostring = function() return {} end }))", 1,
         "'__tostring' must return a string"},
        {"\nsetmetatable({}, { __gc = function() error('late') end })", 2, "may not use __gc"},
        {"local t = setmetatable({}, { __close = function()\n  error('closing')\nend })\ndo local "
         "x <close> = t end",
         2, "closing"},
        {"local function f()\n  return 1 + f()\nend\nf()", 2, "stack overflow"},
        {"local t = {}\nsetmetatable(t, { __index = function(t, k)\n  return t[k + 1]\nend "
         "})\nlocal x = t[1]",
         3, "stack overflow"},
        {"table.sort({3, 2, 1}, function(a, b)\n  return a < nil\nend)", 2, "attempt to compare"},
        {"string.rep()", 1, "bad argument #1 to 'rep'"},
        {"string.format('%99999d', 1)", 1, "invalid conversion"},
        {"math.randomseed()", 1, "bad argument #1 to 'randomseed'"},
        {"setmetatable(math, {})", 1, "protected metatable"},
        {"getmetatable('').__index = nil", 1, "attempt to index a boolean value"},
        {"local red = material {}\nred.color = 1", 2,
         "attempt to index a material value (local 'red')"},
    };
    assert_all_refused(state, cases, COUNT(cases));
}

/** What would be a way out is not there. @param state A #Bench. */
static void test_ways_out(void **state) {
    static const char *const words[] = {
        "io",        "os",         "debug",    "package",     "require",
        "load",      "loadstring", "loadfile", "dofile",      "collectgarbage",
        "coroutine", "warn",       "_G",       "string.dump", "('x').dump"};
    for (size_t i = 0; i < COUNT(words); i++) {
        char text[64];
        snprintf(text, sizeof text, "camera {}\nlocal x = %s", words[i]);
        assert_text_refused(*state, text, 2, "unknown word `", NULL);
    }
}

/** Messages cannot play with a terminal, nor are they without end. @param state A #Bench. */
static void test_messages_are_clean(void **state) {
    const Bench *bench = *state;
    assert_text_refused(bench, "error('a\\27[31mb\\0c\\rd\\155e\\194\\155f\\127')", 1,
                        "a\\27[31mb\\0c\\13d\\155e\\194\\155f\\127", NULL);
    assert_text_refused(bench, "error('d\xC3\xA9j\xC3\xA0 vu \xE2\x82\xAC\\xff')", 1,
                        "d\xC3\xA9j\xC3\xA0 vu \xE2\x82\xAC\\255", NULL);
    assert_text_refused(bench, "error(('\\1y'):rep(1e6))", 1, "\\1y\\1y\\1y", NULL);
    assert_text_refused(bench, "error('100%s %n')", 1, "100%s %n", NULL);
}

// --- limits --------------------------------------------------------------------------------------

/** A scene that asks for too much. */
typedef struct GreedyCase {
    const char *text;  /**< The scene. */
    int line;          /**< The line that is to blame. */
    const char *words; /**< What must be said. */
} GreedyCase;

/** @return Seconds on a clock that nobody sets. */
static double clock_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** Nothing runs past its time: not a loop, nor a call of a library. @param state A #Bench. */
static void test_time_limit(void **state) {
    static const GreedyCase cases[] = {
        {"camera {}\nwhile true do\nend", 2, "the scene ran for more than 0.2 s"},
        {"\nlocal function f()\n  while true do pcall(error) end\nend\npcall(f)", 3, "0.2 s"},
        {"while true do\n  pcall(string.rep, 'x', 1e12)\nend", 2, "0.2 s"},
        {"\n\nlocal x = ('a'):rep(60):find(('a*'):rep(60) .. 'b')", 3, "0.2 s"},
        {"local x = ('a'):rep(60)\nx = x:gsub(('a*'):rep(60) .. 'b', '')", 2, "0.2 s"},
        {"\nlocal x = ('a'):rep(60000):find(('a-'):rep(100) .. 'b')", 2, "0.2 s"},
        {"\ntable.move({}, 1, math.maxinteger - 1, 2)", 2, "0.2 s"},
        {"\nselect('#', table.concat(setmetatable({}, { __len = function() return 1e15 end,\n"
         "  __index = function() return '' end })))",
         3, "0.2 s"},
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        double start = clock_seconds();
        assert_text_refused(*state, cases[i].text, cases[i].line, cases[i].words,
                            &(ScriptRequest){.seconds = 0.2, .memory = SCRIPT_MEMORY});
        double taken = clock_seconds() - start;
        assert_true(taken > 0.19 && taken < 1.5);
    }
}

/** No scene takes more memory than it may. @param state A #Bench. */
static void test_memory_limit(void **state) {
    static const char words[] = "the scene needs more than 4 MiB of memory";
    static const GreedyCase cases[] = {
        {"camera {}\nlocal x = ('x'):rep(1 << 30)", 2, words},
        {"local x = 'x'\nwhile true do\n  x = x .. x\nend", 3, words},
        {"local list = {}\nwhile true do\n  list[#list + 1] = {}\nend", 3, words},
        {"for i = 1, 1e9 do\n  rawset(_ENV, i, i)\nend", 2, words},
        {"local x = ('x'):rep(1500000)\nlocal y = x .. x", 2, words},
        {"local function f()\n  return 1 + f()\nend\nf()", 2, words},
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        assert_text_refused(*state, cases[i].text, cases[i].line, cases[i].words,
                            &(ScriptRequest){.seconds = SCRIPT_SECONDS, .memory = 4 << 20});
    }
    assert_text_refused(*state, "camera {}", 1, "needs more than 0.000976562 MiB",
                        &(ScriptRequest){.seconds = SCRIPT_SECONDS, .memory = 1024});
    assert_text_refused(*state, "camera {}", 1, "needs more than 0.0078125 MiB",
                        &(ScriptRequest){.seconds = SCRIPT_SECONDS, .memory = 8192});
}

/** A scene that asks for too much, but takes no for an answer, is good. @param state A #Bench. */
static void test_refused_memory_can_be_caught(void **state) {
    Scene *scene = load_good(*state, "camera {}\nassert(not pcall(string.rep, 'x', 1e10))");
    scene_destroy(scene);
}

/** Text goes to standard error, clean, up to a limit. @param state A #Bench. */
static void test_print(void **state) {
    const Bench *bench = *state;
    char path[128], got[256] = "";
    snprintf(path, sizeof path, "%s/printed", bench->folder);
    int kept = dup(STDERR_FILENO), file = open(path, O_RDWR | O_CREAT | O_TRUNC, 0600);
    dup2(file, STDERR_FILENO);
    Scene *scene = load_good(bench, "camera {} print('one', 2, nil, '\\27[2J')\n"
                                    "for i = 1, 1e5 do print(('y'):rep(99)) end");
    dup2(kept, STDERR_FILENO);
    scene_destroy(scene);
    off_t size = lseek(file, 0, SEEK_END);
    assert_true(size > 65000 && size < 67000);
    assert_true(pread(file, got, sizeof got - 1, 0) > 0);
    assert_int_equal(strncmp(got, "one\t2\tnil\t\\27[2J\nyyy", 20), 0);
    assert_true(pread(file, got, 50, size - 50) == 50);
    assert_non_null(strstr(got, "printed more"));
    close(file);
    close(kept);
}

// --- files ---------------------------------------------------------------------------------------

/** A scene may be made of files in its folder. @param state Not used. */
static void test_include(void **state) {
    (void)state;
    ScriptRequest request = request_for(SCRIPTS "room.lua");
    Error error = {0};
    Scene *scene = script_load(&request, &error);
    assert_string_equal(error.message, "");
    assert_non_null(scene);
    assert_int_equal(scene->shape_count, 3);
    assert_int_equal(scene->shapes[2].material, 1);
    assert_color(scene->materials[1].color, 1, 0, 0);
    scene_destroy(scene);
}

/** An error is told in the file that it is in; a ring of files ends. @param state Not used. */
static void test_wrong_includes(void **state) {
    (void)state;
    ScriptRequest request = request_for(SCRIPTS "wrong-part.lua");
    assert_refused(&request, SCRIPTS "parts/wrong.lua:2: ", "radius must be");
    request = request_for(SCRIPTS "ring.lua");
    assert_refused(&request, SCRIPTS "ring.lua:3: ", "more than 32 deep");
}

/** No file outside the folder can be included, and nothing but text. @param state A #Bench. */
static void test_include_stays_inside(void **state) {
    const Bench *bench = *state;
    char path[192], outside[192], text[256];
    snprintf(outside, sizeof outside, "%s-outside.lua", bench->folder);
    write_file(outside, "ambient(1)");
    snprintf(path, sizeof path, "%s/link.lua", bench->folder);
    assert_int_equal(symlink(outside, path), 0);
    snprintf(path, sizeof path, "%s/fifo.lua", bench->folder);
    assert_int_equal(mkfifo(path, 0600), 0);
    snprintf(path, sizeof path, "%s/compiled.lua", bench->folder);
    write_file(path, "\x1BLua");
    snprintf(text, sizeof text, "\ninclude '../%s'", strrchr(outside, '/') + 1);
    assert_text_refused(bench, text, 2, "it lies outside the scene's folder", NULL);
    snprintf(text, sizeof text, "\ninclude '%s'", outside);
    assert_text_refused(bench, text, 2, "from the scene file", NULL);
    static const WrongCase cases[] = {
        {"\ninclude 'link.lua'", 2, "cannot include `link.lua`: it lies outside"},
        {"\ninclude '/etc/passwd'", 2, "from the scene file"},
        {"\ninclude 'none.lua'", 2, "cannot include `none.lua`: No such file or directory"},
        {"\ninclude '.'", 2, "it lies outside the scene's folder"},
        {"\ninclude ''", 2, "it lies outside the scene's folder"},
        {"\ninclude 'fifo.lua'", 2, "not a regular file"},
        {"\ninclude 'compiled.lua'", 2, "compiled Lua"},
        {"\ninclude 'a\\0b'", 2, "zero byte"},
        {"\ninclude {}", 2, "bad argument #1 to 'include'"},
        {"\ninclude(('x'):rep(1e5))", 2, "cannot include"},
    };
    assert_all_refused(state, cases, COUNT(cases));
    unlink(outside);
}

/** Includes that fail in pcall do not count as depth. @param state A #Bench. */
static void test_include_depth_is_given_back(void **state) {
    const Bench *bench = *state;
    char path[128];
    snprintf(path, sizeof path, "%s/broken.lua", bench->folder);
    write_file(path, "error('broken')");
    Scene *scene = load_good(bench, "camera {}\nfor i = 1, 99 do pcall(include, 'broken.lua') end\n"
                                    "assert(not pcall(include, 'broken.lua'))");
    scene_destroy(scene);
}

/** What is no scene file is refused, and nothing waits. @param state A #Bench. */
static void test_no_scene_files(void **state) {
    const Bench *bench = *state;
    ScriptRequest request = request_for("no/such/file.lua");
    assert_refused(&request, "no/such/file.lua: ", "No such file or directory");
    request.path = bench->folder;
    assert_refused(&request, bench->folder, ": this is a folder");
    request.path = "/dev/zero";
    assert_refused(&request, "/dev/zero: ", "not a regular file");
    char path[128];
    snprintf(path, sizeof path, "%s/fifo", bench->folder);
    assert_int_equal(mkfifo(path, 0600), 0);
    request.path = path;
    assert_refused(&request, path, ": not a regular file");
    assert_text_refused(bench, "\x1BLuaS\n\n", 1, "compiled Lua", NULL);
    request.path = bench->path;
    write_bytes(bench->path, "camera {}\n\nx = '\0'", 18);
    char place[160];
    snprintf(place, sizeof place, "%s:3: ", bench->path);
    assert_refused(&request, place, "not text");
    assert_int_equal(truncate(bench->path, 17 << 20), 0);
    assert_refused(&request, bench->path, ": longer than 16 MiB");
    if (geteuid() != 0 && chmod(bench->path, 0) == 0) {
        assert_refused(&request, bench->path, ": Permission denied");
        chmod(bench->path, 0600);
    }
}

/** The whole path is told, although Lua cuts names at 60. @param state A #Bench. */
static void test_long_paths(void **state) {
    static const char *const texts[] = {"\nsphere { radius = -1 }", "\n= 1", "\nlocal x = nil + 1",
                                        "\ninclude 'part.lua'"};
    const Bench *bench = *state;
    char folder[400], path[420], part[420], place[430];
    snprintf(folder, sizeof folder, "%s/%0*d", bench->folder, 200, 0);
    assert_int_equal(mkdir(folder, 0700), 0);
    snprintf(path, sizeof path, "%s/s.lua", folder);
    snprintf(part, sizeof part, "%s/part.lua", folder);
    write_file(part, "\nsphere { radius = -1 }");
    for (size_t i = 0; i < COUNT(texts); i++) {
        write_file(path, texts[i]);
        ScriptRequest request = request_for(path);
        snprintf(place, sizeof place, "%s:2: ", i == 3 ? part : path);
        assert_refused(&request, place, "");
    }
}

/** A path that would leave no room for words is told by its end. @param state A #Bench. */
static void test_endless_paths(void **state) {
    (void)state;
    char path[1500];
    memset(path, 'x', sizeof path);
    path[sizeof path - 1] = '\0';
    ScriptRequest request = request_for(path);
    assert_refused(&request, "...xxx", "xxx: File name too long");
}

/** A scene may come from standard input. @param state A #Bench. */
static void test_standard_input(void **state) {
    const Bench *bench = *state;
    write_file(bench->path, "camera {} include 'parts/balls.lua'\nballs(2, nil)\nballs(1, 2)");
    int kept = dup(STDIN_FILENO), file = open(bench->path, O_RDONLY);
    dup2(file, STDIN_FILENO);
    ScriptRequest request = request_for("-");
    request.base_dir = SCRIPTS;
    assert_refused(&request, SCRIPTS "/parts/balls.lua:3: ", "material must be");
    lseek(STDIN_FILENO, 0, SEEK_SET);
    request.base_dir = NULL;
    assert_refused(&request, "-:1: ", "cannot include `parts/balls.lua`");
    dup2(kept, STDIN_FILENO);
    close(kept);
    close(file);
}

// --- processes -----------------------------------------------------------------------------------

/** Does nothing. @param signal Not used. */
static void ignore_alarm(int signal) {
    (void)signal;
}

/** Signals do not end the wait, and no child is left behind. @param state A #Bench. */
static void test_signals_while_waiting(void **state) {
    struct sigaction before, act = {.sa_handler = ignore_alarm};
    const struct itimerval fast = {{0, 10000}, {0, 10000}}, off = {{0, 0}, {0, 0}};
    sigaction(SIGALRM, &act, &before);
    setitimer(ITIMER_REAL, &fast, NULL);
    assert_text_refused(*state, "while true do end", 1, "0.2 s",
                        &(ScriptRequest){.seconds = 0.2, .memory = SCRIPT_MEMORY});
    setitimer(ITIMER_REAL, &off, NULL);
    sigaction(SIGALRM, &before, NULL);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
    assert_int_equal(errno, ECHILD);
}

/** A program that wants no news of its children loads scenes as well. @param state A #Bench. */
static void test_children_reaped_by_the_system(void **state) {
    struct sigaction before, act = {.sa_handler = SIG_IGN};
    sigaction(SIGCHLD, &act, &before);
    scene_destroy(load_good(*state, "camera {}"));
    assert_text_refused(*state, "while true do end", 1, "0.1 s",
                        &(ScriptRequest){.seconds = 0.1, .memory = SCRIPT_MEMORY});
    sigaction(SIGCHLD, &before, NULL);
}

/** Work that dies of a signal. @param context The signal's number. */
static void die(void *context) {
    raise(*(int *)context);
}

/** Work that takes for ever. @param context Not used. */
static void sleep_for_ever(void *context) {
    (void)context;
    for (;;) {
        pause();
    }
}

/** How a child ended is told. @param state Not used. */
static void test_child_ends(void **state) {
    (void)state;
    int detail, signals[] = {SIGINT, SIGKILL, SIGTERM, SIGCHLD};
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(child_run(die, &signals[i], 10, &detail), CHILD_CRASHED);
        assert_int_equal(detail, signals[i]);
    }
    assert_int_equal(child_run(die, &signals[3], 10, &detail), CHILD_ENDED);
    assert_int_equal(detail, 0);
    assert_int_equal(child_run(sleep_for_ever, NULL, 0.05, &detail), CHILD_LATE);
    assert_int_equal(child_run(sleep_for_ever, NULL, -1, &detail), CHILD_LATE);
}

/** A child does not outlive the program. @param state Not used. */
static void test_child_dies_with_its_parent(void **state) {
    (void)state;
    int ends[2], detail;
    char byte;
    assert_int_equal(pipe(ends), 0);
    pid_t parent = fork();
    if (parent == 0) {
        close(ends[0]);
        child_run(sleep_for_ever, NULL, 60, &detail);
        _exit(0);
    }
    close(ends[1]);
    usleep(100000);
    kill(parent, SIGKILL);
    waitpid(parent, NULL, 0);
    // Both held the other end; it is closed when both are dead.
    alarm(10);
    assert_int_equal(read(ends[0], &byte, 1), 0);
    alarm(0);
    close(ends[0]);
}

/** @return 0 if all is well. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_defaults),
        cmocka_unit_test(test_keywords),
        cmocka_unit_test(test_field_types),
        cmocka_unit_test(test_materials),
        cmocka_unit_test(test_colors),
        cmocka_unit_test(test_later_calls_replace),
        cmocka_unit_test(test_time),
        cmocka_unit_test(test_inherited_fields),
        cmocka_unit_test(test_determinism),
        cmocka_unit_test(test_marks_before_the_text),
        cmocka_unit_test(test_unknown_words),
        cmocka_unit_test(test_wrong_types),
        cmocka_unit_test(test_wrong_values),
        cmocka_unit_test(test_lua_errors),
        cmocka_unit_test(test_ways_out),
        cmocka_unit_test(test_messages_are_clean),
        cmocka_unit_test(test_time_limit),
        cmocka_unit_test(test_memory_limit),
        cmocka_unit_test(test_refused_memory_can_be_caught),
        cmocka_unit_test(test_print),
        cmocka_unit_test(test_include),
        cmocka_unit_test(test_wrong_includes),
        cmocka_unit_test(test_include_stays_inside),
        cmocka_unit_test(test_include_depth_is_given_back),
        cmocka_unit_test(test_no_scene_files),
        cmocka_unit_test(test_long_paths),
        cmocka_unit_test(test_endless_paths),
        cmocka_unit_test(test_standard_input),
        cmocka_unit_test(test_signals_while_waiting),
        cmocka_unit_test(test_children_reaped_by_the_system),
        cmocka_unit_test(test_child_ends),
        cmocka_unit_test(test_child_dies_with_its_parent),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
