/**
 * @file
 * @brief Tests of scene files: their features, and the messages for invalid ones.
 */
#include "scene_files.h"

// --- helpers -------------------------------------------------------------------------------------

/** @return The parameters of a ball in a scene. */
static const TestBall *ball_parameters_of(const Scene *scene, size_t i) {
    assert_true(i < scene->shape_count);
    return scene->shapes[i].parameters;
}

/** Asserts the components of a vector. */
static void assert_vector(Vec3d v, double x, double y, double z) {
    assert_true(v.x == x && v.y == y && v.z == z);
}

// --- features ------------------------------------------------------------------------------------

/** A scene with only a camera has the defaults. */
static void test_defaults(void **state) {
    Scene *scene = load_valid_scene(*state, "camera {}");
    assert_true(scene->has_camera);
    assert_vector(scene->camera.direction, 0, 0, -1);
    assert_int_equal(scene->image.width, 800);
    assert_color(scene->ambient, 0, 0, 0);
    assert_int_equal(scene->light_count, 0);
    assert_int_equal(scene->shape_count, 0);
    assert_int_equal(scene->material_count, 1);
    scene_destroy(scene);
}

/** Every keyword fills its struct. */
static void test_keywords(void **state) {
    Scene *scene = load_valid_scene(
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

/** Fields of all types are stored, and Keyword::finish is called. */
static void test_field_types(void **state) {
    Scene *scene = load_valid_scene(
        *state, "camera {}\n"
                "sphere { center = {1, -2, 3.5}, radius = 4, axis = {0, 0, 2},\n"
                "         tint = {0.25, 0.5, 1}, rings = 3.0, finish = 'glossy' }\n"
                "plane { hollow = true }\n");
    const TestBall *ball = ball_parameters_of(scene, 0);
    assert_vector(ball->center, 1, -2, 3.5);
    assert_vector(ball->axis, 0, 0, 2);
    assert_color(ball->tint, 0.25, 0.5, 1);
    assert_true(ball->radius == 4 && ball->diameter == 8);
    assert_int_equal(ball->rings, 3);
    assert_int_equal(ball->finish, 2);
    assert_false(ball->is_hollow);
    assert_int_equal(scene->shapes[0].class_index, 1);
    assert_int_equal(scene->shapes[1].class_index, 0);
    assert_true(ball_parameters_of(scene, 1)->is_hollow);
    assert_true(ball_parameters_of(scene, 1)->radius == 1);
    scene_destroy(scene);
}

/**
 * Every shape can be scaled, rotated and moved; other shapes have no transform. A pair is two
 * numbers.
 */
static void test_transforms(void **state) {
    Scene *scene = load_valid_scene(*state, "camera {}\n"
                                            "sphere { spot = {0.25, 1} }\n"
                                            "sphere { scale = 2 }\n"
                                            "plane { scale = {1, -2, 3}, rotate = {90, 0, 90},\n"
                                            "        translate = {4, 5, 6} }\n");
    assert_true(ball_parameters_of(scene, 0)->uv.u == 0.25 &&
                ball_parameters_of(scene, 0)->uv.v == 1);
    assert_null(scene->shapes[0].transform);
    const Transform *twice = scene->shapes[1].transform, *all = scene->shapes[2].transform;
    assert_vector(twice->scale, 2, 2, 2);
    assert_vector(twice->translate, 0, 0, 0);
    assert_vector(all->translate, 4, 5, 6);
    // The scale comes first. The rotation about x moves y to z and z to -y; then about z, x to y
    // and y to -x.
    const double linear[3][3] = {{0, 0, 3}, {1, 0, 0}, {0, -2, 0}};
    for (int i = 0; i < 9; i++) {
        assert_true(all->matrix[i / 3][i % 3] == linear[i / 3][i % 3]);
    }
    scene_destroy(scene);
}

/** Materials are passed to shapes as return values. */
static void test_materials(void **state) {
    Scene *scene = load_valid_scene(
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
        assert_int_equal(scene->shapes[i].material_index, wanted[i]);
    }
    assert_true(scene->materials[1].specular == 0.5);
    assert_color(scene->materials[2].reflectivity, 0.8, 0.8, 0.8);
    scene_destroy(scene);
}

/** A colour in one notation. */
typedef struct ColorCase {
    const char *text; /**< The scene. */
    Rgbd wanted;      /**< The expected ambient light. */
} ColorCase;

/** Colours have three notations; the last call counts. */
static void test_colors(void **state) {
    static const ColorCase cases[] = {
        {"camera {} ambient { 0.15, 0.25, 0.5 }", {0.15, 0.25, 0.5}},
        {"camera {} ambient(0.2)", {0.2, 0.2, 0.2}},
        {"camera {} ambient '#ff0000'", {1, 0, 0}},
        {"camera {} ambient(1) ambient '#000000'", {0, 0, 0}},
        // The two pieces of the sRGB curve: 10/255 is on the linear one, 11/255 on the other.
        {"camera {} ambient '#0A0b80'",
         {10 / 255.0 / 12.92, 0.0033465357638991595, 0.21586050011389926}},
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        Scene *scene = load_valid_scene(*state, cases[i].text);
        const Rgbd *wanted = &cases[i].wanted;
        assert_true(fabs(scene->ambient.red - wanted->red) < 1e-16);
        assert_true(fabs(scene->ambient.green - wanted->green) < 1e-16);
        assert_true(fabs(scene->ambient.blue - wanted->blue) < 1e-16);
        scene_destroy(scene);
    }
}

/** A later call replaces camera, image and sky. */
static void test_later_calls_replace(void **state) {
    Scene *scene =
        load_valid_scene(*state, "camera { fov = 20 } image { width = 5 } sky { color = 1 }\n"
                                 "camera { fov = 30 } image { depth = 2 } sky {}\n");
    assert_true(scene->camera.fov == 30);
    assert_int_equal(scene->image.width, 800);
    assert_int_equal(scene->image.depth, 2);
    assert_color(scene->sky.zenith, 0, 0, 0);
    scene_destroy(scene);
}

/** Scripts have access to the time. */
static void test_time(void **state) {
    const Fixture *fixture = *state;
    write_text(fixture->path, "camera {} sphere { center = {t, 0, 0} }");
    ScriptRequest request = script_request_for(fixture->path);
    request.time = 2.5;
    Scene *scene = script_load(&request, NULL);
    assert_non_null(scene);
    assert_vector(ball_parameters_of(scene, 0)->center, 2.5, 0, 0);
    scene_destroy(scene);
}

/** Fields can be inherited by a metatable. */
static void test_inherited_fields(void **state) {
    Scene *scene = load_valid_scene(*state, "camera {}\n"
                                            "local big = { __index = { radius = 7 } }\n"
                                            "sphere(setmetatable({ rings = 1 }, big))\n");
    assert_true(ball_parameters_of(scene, 0)->radius == 7);
    assert_int_equal(ball_parameters_of(scene, 0)->rings, 1);
    scene_destroy(scene);
}

/** Random numbers and the order of tables are equal in every run. */
static void test_determinism(void **state) {
    Scene *scene = load_valid_scene(
        *state, "camera {}\n"
                "sphere { center = {math.random(), math.random(1000), math.random()} }\n"
                "local word = ''\n"
                "local list = { 'a', 'b', [9] = 'd', [-1] = 'Z', [2.5] = 'e', [1e3] = 'dd',\n"
                "               one = 'g', Two = 'f', [true] = 'i', [false] = 'h' }\n"
                "for key, value in pairs(list) do word = word .. value; list[key] = nil end\n"
                "assert(word == 'Zabdddefghi' and next(list) == nil, word)\n"
                "local other = {}\n"
                "for key in pairs { [list] = 1, [3] = 3 } do other[#other + 1] = type(key) end\n"
                "assert(#other == 2 and other[1] == 'number')\n");
    // xoshiro256** from a fixed seed: equal on every machine.
    assert_vector(ball_parameters_of(scene, 0)->center, 0.84161702650617698, 295,
                  0.33064000904983071);
    scene_destroy(scene);
}

/** A byte order mark or a first line with #! does not change line numbers. */
static void test_marks_before_the_text(void **state) {
    const char *text = "\xEF\xBB\xBF#!/usr/bin/env dioptre\ncamera {}\n";
    scene_destroy(load_valid_scene(*state, text));
    assert_text_refused(*state, "#!/usr/bin/env dioptre\ncamera {}\nx = y", 3, "`y`", NULL);
}

// --- messages for invalid scenes -----------------------------------------------------------------

/** Unknown keywords and fields. */
static void test_unknown_words(void **state) {
    static const InvalidScene cases[] = {
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
        {"sphere { transalte = {1, 1, 1} }", 1, "did you mean `translate`?"},
        {"light { scale = 1 }", 1, "light has no field `scale`"},
        {"light { material = 1 }", 1, "light has no field `material`"},
        {"sphere { xyzzy = 1 }", 1, "sphere has no field `xyzzy`"},
        {"sphere { finish = 'glosy' }", 1,
         "must be `matt`, `satin` or `glossy`, not `glosy`; did you mean `glossy`?"},
        {"light { falloff = 'linear' }", 1,
         "falloff must be `none`, `inverse_square` or `inverse_linear`, not `linear`"},
    };
    assert_all_refused(state, cases, COUNT(cases));
}

/** Values of a wrong type. */
static void test_wrong_types(void **state) {
    static const InvalidScene cases[] = {
        {"sphere { radius = 'x' }", 1, "radius must be a number, not a string"},
        {"sphere { radius = '1' }", 1, "radius must be a number, not a string"},
        {"sphere { radius = false }", 1, "radius must be a number, not a boolean"},
        {"sphere { radius = {1} }", 1, "radius must be a number, not a table"},
        {"sphere { rings = 1.5 }", 1, "rings must be a whole number, not 1.5"},
        {"sphere { hollow = 1 }", 1, "hollow must be true or false, not a number"},
        {"sphere { finish = 1 }", 1, "finish must be `matt`, `satin` or `glossy`, not a number"},
        {"sphere { center = 1 }", 1, "center must be three numbers {x, y, z}, not a number"},
        {"sphere { center = {1, 2} }", 1, "there are 2 things"},
        {"sphere { tint = {0, 5} }", 1, "there are 2 things"},
        {"sphere { center = {1, 2, 3, 4} }", 1, "there are 4 things"},
        {"sphere { center = {x = 1, y = 2, z = 3} }", 1, "three numbers {x, y, z}"},
        {"sphere { center = {1, 2, 3, w = 4} }", 1, "three numbers {x, y, z}"},
        {"sphere { center = {1, '2', 3} }", 1, "number 2 of them is a string"},
        {"sphere { tint = true }", 1, "tint must be a colour"},
        {"sphere { tint = '#ff000' }", 1, "not \"#ff000\""},
        {"sphere { tint = 'red' }", 1, "tint must be a colour such as \"#ff8000\""},
        {"sphere { tint = '#ff00gg' }", 1, "tint must be a colour"},
        {"sphere { spot = {1} }", 1, "spot must be two numbers {u, v}; there is 1 thing"},
        {"sphere { spot = {u = 1, v = 2} }", 1,
         "spot must be two numbers {u, v}: the numbers alone, without names"},
        {"sphere { spot = 1 }", 1, "spot must be two numbers {u, v}, not a number"},
        {"sphere { scale = 'big' }", 1,
         "scale must be one number, or three numbers {x, y, z}, not a string"},
        {"sphere { rotate = 90 }", 1, "rotate must be three numbers {x, y, z}, not a number"},
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

/** Values that are out of range, NaN or inconsistent. */
static void test_wrong_values(void **state) {
    static const InvalidScene cases[] = {
        {"sphere { radius = 0 }", 1, "radius must be above 0"},
        {"sphere { spot = {0, 2} }", 1, "spot must be at least 0 and at most 1, not 2"},
        {"sphere { spot = {0, 1.0000001} }", 1,
         "spot must be at least 0 and at most 1, not 1.0000001"},
        {"sphere { scale = {1, -1e-7, 1} }", 1, "scale must not be nearer to zero than 1e-06"},
        {"sphere { scale = {1, 1, 2e6} }", 1, "scale must be at least -1e+06 and at most 1e+06"},
        {"sphere { rotate = {0, 0/0, 0} }", 1, "rotate must be a finite number"},
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

/** A camera looks where it is told: at a point, along a direction, or by two angles. */
static void test_cameras(void **state) {
    const double half = sqrt(0.5);
    static const InvalidScene wrong[] = {
        {"camera { pan = 1, direction = {0, 0, 1} }", 1, "only one of look_at, direction, and pan"},
        {"camera { position = {1, 2, 3}, look_at = {1, 2, 3} }", 1, "its own position"}};
    const struct {
        const char *text; /**< Of the scene. */
        Vec3d direction;  /**< Where it looks. */
        Vec3d up;         /**< Its up. */
    } cameras[] = {
        {"camera { pan = 90 }", {1, 0, 0}, {0, 1, 0}},
        {"camera { tilt = 45 }", {0, half, -half}, {0, half, half}},
        {"camera { pan = 180, tilt = -45 }", {0, -half, half}, {0, half, half}},
        // Straight down, north is the top of the picture, and straight up it is at the bottom.
        {"camera { tilt = -90 }", {0, -1, 0}, {0, 0, -1}},
        {"camera { pan = 90, tilt = -90 }", {0, -1, 0}, {1, 0, 0}},
        {"camera { pan = 90, tilt = 90 }", {0, 1, 0}, {-1, 0, 0}},
        {"camera { pan = 180, tilt = -90 }", {0, -1, 0}, {0, 0, 1}},
        {"camera { direction = {0, 1, 0} }", {0, 1, 0}, {0, 0, 1}},
        {"camera { direction = {1, 0, 0}, up = {2, 0, 0} }", {1, 0, 0}, {0, 0, 1}},
        {"camera { direction = {0, 0, 1}, up = {0, 0, 1} }", {0, 0, 1}, {1, 0, 0}}};
    for (size_t i = 0; i < COUNT(cameras); i++) {
        Scene *scene = load_valid_scene(*state, cameras[i].text);
        Vec3d direction = vec3d_subtract(scene->camera.direction, cameras[i].direction);
        Vec3d up = vec3d_subtract(scene->camera.up, cameras[i].up);
        assert_at_most(vec3d_max_abs(direction), 1e-15, "%s: direction", cameras[i].text);
        assert_at_most(vec3d_max_abs(up), 1e-15, "%s: up %g %g %g", cameras[i].text,
                       scene->camera.up.x, scene->camera.up.y, scene->camera.up.z);
        scene_destroy(scene);
    }
    assert_all_refused(state, wrong, COUNT(wrong));
}

/** Errors of Lua are reported at the innermost line of the scene file. */
static void test_lua_errors(void **state) {
    static const InvalidScene cases[] = {
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
        {"local m = {}\nlocal t = setmetatable({}, m)\nm.__mode = 'k'", 1, "may not use __mode"},
        {"do local m = {} setmetatable({}, m) rawset(m, '__mode', 'v') end", 1,
         "may not use __mode"},
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

/** @return The scene of a fixture with overrides, by the real worker; NULL: it is refused. */
static Scene *load_overridden(const Fixture *fixture, const SceneOverride *overrides, size_t count,
                              Error *error) {
    ScriptRequest request = script_request_for(fixture->path);
    request.shape_keywords = scene_shape_keywords;
    request.worker = NULL;
    request.overrides = overrides;
    request.override_count = count;
    return script_load(&request, error);
}

/** Overrides take the place of the file's values for one call only. */
static void test_overrides(void **state) {
    const Fixture *fixture = *state;
    Error error = {0};
    int sphere = scene_object_keyword_find("sphere"), light = scene_object_keyword_find("light");
    int material = scene_object_keyword_find("material");
    write_text(fixture->path, "camera {}\nlocal shared = { radius = 1 }\n"
                              "for i = 1, 2 do sphere(shared) end\n"
                              "light { intensity = 2 }\nlocal m = material {}\n"
                              "sphere {\n  material = m, scale = 2\n}\n"
                              "sphere(setmetatable({}, { __index = { radius = 7 } }))\n");
    const SceneOverride overrides[] = {
        {sphere, 2, scene_object_row_find(sphere, "radius"), {3}},
        {sphere, 3, scene_object_row_find(sphere, "translate"), {1, 2, 3}},
        {sphere, 4, scene_object_row_find(sphere, "center"), {1, 2, 3}},
        {sphere, 9, scene_object_row_find(sphere, "radius"), {3}},
        {light, 1, scene_object_row_find(light, "falloff"), {FALLOFF_INVERSE_SQUARE}},
        {material, 1, scene_object_row_find(material, "color"), {0.5, 0.25, 0.1}},
        {sphere, 1, 1000, {3}},
        {99, 1, 0, {3}},
        {sphere, 1, scene_object_row_find(sphere, "radius"), {(double)NAN}}};
    Scene *scene =
        load_overridden(fixture, overrides, sizeof overrides / sizeof *overrides, &error);
    assert_string_equal(error.message, "");
    assert_non_null(scene);
    const SphereParameters *first = scene->shapes[0].parameters;
    const SphereParameters *second = scene->shapes[1].parameters;
    assert_true(first->radius == 1 && second->radius == 3);
    assert_true(scene->shapes[2].transform->translate.y == 2);
    assert_true(scene->shapes[2].transform->scale.x == 2);
    const SphereParameters *inheriting = scene->shapes[3].parameters;
    assert_true(inheriting->radius == 7 && inheriting->center.y == 2);
    assert_int_equal(scene->lights[0].falloff, FALLOFF_INVERSE_SQUARE);
    assert_true(scene->lights[0].intensity == 2);
    assert_true(scene->materials[1].color.green == 0.25);
    assert_int_equal(scene->shapes[1].origin.number, 2);
    assert_int_equal(scene->shapes[1].origin.line, 3);
    assert_int_equal(scene->shapes[2].origin.line, 6);
    assert_int_equal(scene->lights[0].origin.line, 4);
    assert_int_equal(scene->materials[1].origin.number, 1);
    scene_destroy(scene);
}

/** Overrides are checked as the file's own values are. */
static void test_wrong_overrides(void **state) {
    const Fixture *fixture = *state;
    Error error = {0};
    int material = scene_object_keyword_find("material");
    const SceneOverride both[] = {
        {material, 1, scene_object_row_find(material, "transparency"), {1, 1, 1}},
        {material, 1, scene_object_row_find(material, "reflectivity"), {0.5, 0, 0}}};
    write_text(fixture->path, "camera {}\nmaterial {}\n");
    assert_null(load_overridden(fixture, both, 2, &error));
    assert_non_null(strstr(error.message, ":2: reflectivity and transparency are 1.5 together"));
}

/** @return 0 if all tests pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_defaults),
        cmocka_unit_test(test_keywords),
        cmocka_unit_test(test_cameras),
        cmocka_unit_test(test_overrides),
        cmocka_unit_test(test_wrong_overrides),
        cmocka_unit_test(test_field_types),
        cmocka_unit_test(test_transforms),
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
    };
    return cmocka_run_group_tests_name("script", tests, scene_fixture_set_up, fixture_tear_down);
}
