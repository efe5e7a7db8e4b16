/**
 * @file
 * @brief Distance fields that a scene gives as a function: the tape computes what Lua computes, in
 *        every engine; its box and its slope are right; what cannot be a tape is refused.
 *
 * The SDF interpreter is compiled into this test in double, with one lane.
 */
#define REAL_BITS 64
#define LANES 1
#include "sdf_compiled.h"

#include "fixtures.h"

#include "dioptre/script.h"

#include <lauxlib.h>
#include <lualib.h>

/** Points per function. */
enum { POINTS = 20000 / WORKLOAD_DIVISOR };
/** Rays per function and engine. */
enum { RAYS = 4096 };

/** @return The sine in quad, from the C library. */
extern Quadruple sinf128(Quadruple x);

/** A distance field as a function. */
typedef struct FunctionCase {
    const char *name; /**< Its name. */
    const char *text; /**< What stands between `sdf {` and `}`. */
    const char *twin; /**< The same from `distance`; NULL: there is none. */
    int ulps;         /**< Ulps by which it may differ from Lua's value. */
    double half_edge; /**< Half the longest edge of its bounding box; infinite: it has none. */
    double slope;     /**< Its largest slope. */
} FunctionCase;

/** What the functions call. */
static const char helpers[] =
    "local abs, min, max, sqrt, sin, cos = math.abs, math.min, math.max, math.sqrt, math.sin, "
    "math.cos\n"
    "local function length(x, y, z) return sqrt(x * x + y * y + z * z) end\n"
    "local function outside(x, y, z)\n"
    "  return length(max(x, 0), max(y, 0), max(z, 0)) + min(max(x, max(y, z)), 0)\n"
    "end\n"
    "local function frame(x, y, z, h, e)\n"
    "  x, y, z = abs(x) - h, abs(y) - h, abs(z) - h\n"
    "  local a, b, c = abs(x + e) - e, abs(y + e) - e, abs(z + e) - e\n"
    "  return min(outside(x, b, c), outside(a, y, c), outside(a, b, z))\n"
    "end\n"
    "local function smooth(a, b, r)\n"
    "  local h = max(r - abs(a - b), 0) / r\n"
    "  return min(a, b) - h * h * r * 0.25\n"
    "end\n";

/** The functions: those of report B, and one of all operations. */
static const FunctionCase cases[] = {
    {"sphere", "function(x, y, z) return length(x, y, z) - 1 end", "distance.sphere {}", 0, 1, 1},
    {"box", "function(x, y, z) return outside(abs(x) - 0.5, abs(y) - 1, abs(z) - 1.5) end",
     "distance.box { size = {1, 2, 3} }", 0, 1.5, 1},
    {"frame", "field = function(x, y, z) return frame(x, y, z, 0.6, 0.07) end",
     "distance.box_frame { size = {1.2, 1.2, 1.2}, edge = 0.14 }", 0, 0.6, 1},
    {"repetition",
     "function(x, y, z)\n"
     "  return length((x + 1.5) % 3 - 1.5, (y + 1.5) % 3 - 1.5, (z + 1.5) % 3 - 1.5) - 1 end",
     "distance.sphere {}:repeat_every{3, 3, 3}", 64, HUGE_VAL, 1},
    {"flat sphere", "function(x, y, z) return 0.01 * length(x, y, z) - 0.01 end",
     "distance.sphere {}", 0, 1, 0.01},
    {"smooth union",
     "function(x, y, z)\n"
     "  return smooth(length(x, y, z) - 1, length(x - 1, y - 0.5, z) - 0.75, 0.5) end",
     NULL, 0, 1.5, 1},
    {"turned frame",
     "function(x, y, z)\n"
     "  local c, s = cos(0.6), sin(0.6)\n"
     "  x, y = c * x - s * y, s * x + c * y\n"
     "  y, z = c * y - s * z, s * y + c * z\n"
     "  return frame(x, y, z, 0.6, 0.07) end",
     NULL, 0, 1.02, 1},
    {"three times too steep", "function(x, y, z) return 3 * length(x, y, z) - 3 end", NULL, 0, 1,
     3},
    {"implicit sphere", "function(x, y, z) return x ^ 2 + y * y + z * z - 1 end", NULL, 0, 1,
     3.4641},
    {"waves",
     "function(x, y, z) return (length(x, y, z) - 1 - 0.1 * sin(5 * x) * cos(4 * z)) / 2 end", NULL,
     4, 1.1, 0.75},
    {"all operations",
     "function(x, y, z)\n"
     "  local a = -x / (2 + y ^ 2) + z // 1 * 0 + math.floor(y) * 0 + math.ceil(y) * 0\n"
     "  return 0.3 * max(length(a, y ^ -2 * 0 + y, abs(z) ^ 1.5 * 0 + z) - 1, 5 - 2 ^ 3 + a * 0) "
     "end",
     NULL, 4, HUGE_VAL, 0}};

/** Number of functions. */
enum { CASES = sizeof cases / sizeof *cases };

/* --- scenes ----------------------------------------------------------------------------------- */

/** @return The scene of a text, or NULL. @param[out] error What is wrong. */
static Scene *load(void **state, const char *text, Error *error) {
    const char *path = fixture_path(state, "scene.lua");
    write_file(path, text, strlen(text));
    const ScriptRequest request = {.path = path,
                                   .time = 2,
                                   .time_limit = SCRIPT_TIME_LIMIT,
                                   .memory_limit = SCRIPT_MEMORY_LIMIT};
    return script_load(&request, error);
}

/** @return The scene with one field. @param field What stands between `sdf {` and `}`. */
static Scene *load_field(void **state, const char *field) {
    char text[4096];
    Error error = {0};
    snprintf(text, sizeof text, "%scamera { position = {0, 0, 5} }\nsdf { %s, max_steps = 4096 }\n",
             helpers, field);
    Scene *scene = load(state, text, &error);
    if (!scene) {
        fail_msg("%s\n%s", text, error.message);
    }
    return scene;
}

/** @return The field of a scene. */
static const Sdf *field_of(const Scene *scene) {
    return ((const SdfShapeParameters *)scene->shapes[0].parameters)->field;
}

/** @return A random point, from some thousandths to some units from zero. */
static Vec3d random_point(uint64_t *seed) {
    double size = exp2(12 * random_unit_double(seed) - 9);
    return (Vec3d){size * (2 * random_unit_double(seed) - 1),
                   size * (2 * random_unit_double(seed) - 1),
                   size * (2 * random_unit_double(seed) - 1)};
}

/* --- values ----------------------------------------------------------------------------------- */

/** @return A state of plain Lua whose global `field` is the function of a case. */
static lua_State *plain_lua(const FunctionCase *subject) {
    char text[4096];
    lua_State *L = luaL_newstate();
    luaL_openlibs(L);
    snprintf(text, sizeof text, "%slocal t = { %s }\nfield = t.field or t[1]\n", helpers,
             subject->text);
    if (luaL_dostring(L, text) != LUA_OK) {
        fail_msg("%s", lua_tostring(L, -1));
    }
    return L;
}

/** @return The value of Lua's function. */
static double lua_value(lua_State *L, Vec3d p) {
    lua_getglobal(L, "field");
    lua_pushnumber(L, p.x);
    lua_pushnumber(L, p.y);
    lua_pushnumber(L, p.z);
    lua_call(L, 3, 1);
    double value = lua_tonumber(L, -1);
    lua_pop(L, 1);
    return value;
}

/** The tape has the bits of Lua: of plain Lua, which knows nothing of tapes. */
static void test_values(void **state) {
    for (int i = 0; i < CASES; i++) {
        Scene *scene = load_field(state, cases[i].text);
        const Sdf *field = field_of(scene);
        lua_State *L = plain_lua(&cases[i]);
        uint64_t seed = 1;
        double worst = 0, factor = field->nodes[0].operands[SDF_TAPE_FACTOR];
        // Clamping is for points outside the box; here the function itself is compared.
        Sdf *plain = calloc(1, sdf_size(field->node_count));
        memcpy(plain, field, sdf_size(field->node_count));
        plain->nodes[0].operands[SDF_TAPE_CLAMPS] = 0;
        CompiledSdf compiled = compile_sdf(plain);
        for (int n = 0; n < POINTS; n++) {
            Vec3d p = random_point(&seed);
            double wanted = lua_value(L, p) * factor, size = fmax(vec3d_max_abs(p), 1);
            double value = sdf_distance(&compiled.program, vec3_of(p), 1);
            worst = fmax(worst, fabs(value - wanted) / (size * 0x1p-52));
        }
        printf("  %-22s %3d operations, %g ulps from Lua\n", cases[i].name, field->node_count - 1,
               worst);
        assert_at_most(worst, cases[i].ulps, "%s, ulps", cases[i].name);
        lua_close(L);
        free(plain);
        free(compiled.memory);
        scene_destroy(scene);
    }
}

/** Derivatives agree with differences. */
static void test_gradients(void **state) {
    const double h = 1e-6;
    for (int i = 0; i < CASES; i++) {
        Scene *scene = load_field(state, cases[i].text);
        const Sdf *field = field_of(scene);
        CompiledSdf compiled = compile_sdf(field);
        uint64_t seed = 1;
        int wrong = 0;
        for (int n = 0; n < POINTS / 10; n++) {
            Vec3d p = random_point(&seed);
            SdfSample here = sdf_sample(&compiled.program, vec3_of(p), 1);
            assert_true(here.distance == sdf_distance(&compiled.program, vec3_of(p), 1));
            bool is_outside =
                vec3d_max_abs(vec3d_subtract(p, vec3d_min(vec3d_max(p, field->low), field->high))) >
                0;
            const double carried[3] = {here.gradient.x, here.gradient.y, here.gradient.z};
            for (int axis = 0; axis < 3 && !is_outside; axis++) {
                Vec3d step = {axis == 0 ? h : 0, axis == 1 ? h : 0, axis == 2 ? h : 0};
                double up = sdf_distance(&compiled.program, vec3_of(vec3d_add(p, step)), 1);
                double down = sdf_distance(&compiled.program, vec3_of(vec3d_subtract(p, step)), 1);
                wrong += !(fabs((up - down) / (2 * h) - carried[axis]) < 1e-4);
            }
        }
        // An edge may lie between the two points of a difference.
        printf("  %-22s gradients unlike differences: %g\n", cases[i].name, wrong / (0.3 * POINTS));
        assert_at_most(wrong / (0.3 * POINTS), 2e-3, "%s, gradients", cases[i].name);
        free(compiled.memory);
        scene_destroy(scene);
    }
}

/** A step that occurs twice is computed once, and one that nobody needs is not computed. */
static void test_common_steps(void **state) {
    static const struct {
        const char *text; /**< The field. */
        int steps;        /**< Its operations. */
    } fields[] = {
        {"function(x, y, z) return x * x + y * (x * x) - 1 end", 4},
        {"function(x, y, z) return (x + y) * (y + x) - 1 end", 3},
        {"function(x, y, z) local unused = z / 3; return x * x - 1 end", 2},
        {"function(x, y, z) local d = math.huge; for i = 1, 3 do d = min(d, x * 1 - 0) end return "
         "d "
         "end",
         0},
        {"function(x, y, z) return x / 4 - 2 * 3 - -(-(y)) end", 3},
    };
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        Scene *scene = load_field(state, fields[i].text);
        assert_int_equal(field_of(scene)->node_count - 1, fields[i].steps);
        scene_destroy(scene);
    }
}

/* --- rays ------------------------------------------------------------------------------------- */

/** @return Rays towards a field. */
static const RayQueryQuad *random_rays(void) {
    static RayQueryQuad rays[RAYS];
    uint64_t seed = 1;
    for (int n = 0; n < RAYS; n++) {
        for (int i = 0; i < 3; i++) {
            rays[n].origin[i] = random_float(&seed, -4, 4);
            rays[n].direction[i] =
                round_to_float(random_float(&seed, -1, 1) - (double)rays[n].origin[i]);
        }
    }
    return rays;
}

/** Intersects rays with a field. @return Number of rays. */
static int intersect(const Engine *engine, const Scene *scene, RayResult *results) {
    int count = engine->mantissa_bits > 64 ? RAYS / 64 : RAYS / WORKLOAD_DIVISOR;
    Tracer *tracer = create_tracer(engine, scene);
    engine->intersect(tracer, (size_t)count, random_rays(), results);
    engine->destroy(tracer);
    return count;
}

/** @return Whether two hits have the same bits. */
static bool hits_equal(const RayResult *a, const RayResult *b) {
    bool is_equal = a->shape == b->shape;
    for (int i = 0; i < 3 && a->shape >= 0; i++) {
        is_equal = is_equal && a->distance == b->distance && a->point[i] == b->point[i] &&
                   a->normal[i] == b->normal[i];
    }
    return is_equal;
}

/** @return The first engine with the number type of another. */
static const Engine *first_of_type(const Engine *engine) {
    const Engine *const *first = engine_list();
    while ((*first)->mantissa_bits != engine->mantissa_bits || !engine_is_supported(*first)) {
        first++;
    }
    return *first;
}

/** Engines of the same number type find the same bits. */
static void test_lanes(void **state) {
    static RayResult hits[RAYS], others[RAYS];
    for (int i = 0; i < CASES; i++) {
        Scene *scene = load_field(state, cases[i].text);
        for (const Engine *const *engine = engine_list(); *engine; engine++) {
            const Engine *first = engine_is_supported(*engine) ? first_of_type(*engine) : *engine;
            int count = *engine == first ? 0 : intersect(*engine, scene, hits), unlike = 0;
            if (count > 0) {
                intersect(first, scene, others);
            }
            for (int n = 0; n < count; n++) {
                unlike += !hits_equal(&hits[n], &others[n]);
            }
            assert_at_most(unlike, 0, "%s, %s against %s", cases[i].name, (*engine)->name,
                           first->name);
        }
        scene_destroy(scene);
    }
}

/** A function has the hits of its twin. */
static void test_twins(void **state) {
    static RayResult hits[RAYS], twins[RAYS];
    for (int i = 0; i < CASES && cases[i].twin; i++) {
        Scene *scene = load_field(state, cases[i].text), *twin = load_field(state, cases[i].twin);
        for (const Engine *const *engine = engine_list(); *engine; engine++) {
            if (!engine_is_supported(*engine)) {
                continue;
            }
            int count = intersect(*engine, scene, hits), unlike = 0, hit = 0;
            intersect(*engine, twin, twins);
            for (int n = 0; n < count; n++) {
                double off = (double)(hits[n].distance - twins[n].distance);
                bool is_hit = hits[n].shape >= 0;
                hit += is_hit;
                unlike += hits[n].shape != twins[n].shape || (is_hit && !(fabs(off) <= 2e-4));
            }
            printf("  %-22s %-7s %d of %d rays hit, %d unlike the twin\n", cases[i].name,
                   (*engine)->name, hit, count, unlike);
            // Rays that pass within the tolerance of the surface.
            assert_at_most(unlike, count / 1000, "%s in %s, unlike", cases[i].name,
                           (*engine)->name);
            assert_true(hit > count / 4);
        }
        scene_destroy(scene);
        scene_destroy(twin);
    }
}

/** Sines of every engine are right in its number type: rays fall on the surface y = sin x. */
static void test_sines(void **state) {
    enum { COUNT = 512 };
    static RayQueryQuad rays[COUNT];
    static RayResult hits[COUNT];
    Scene *scene = load_field(state, "function(x, y, z) return y - sin(x) end");
    uint64_t seed = 1;
    for (int n = 0; n < COUNT; n++) {
        double size = exp2(14 * random_unit_double(&seed) - 4);
        rays[n] = (RayQueryQuad){{random_float(&seed, -size, size), 2, 0.5}, {0, -1, 0}};
    }
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if (!engine_is_supported(*engine)) {
            continue;
        }
        Tracer *tracer = create_tracer(*engine, scene);
        double worst = 0;
        (*engine)->intersect(tracer, COUNT, rays, hits);
        for (int n = 0; n < COUNT; n++) {
            assert_int_equal(hits[n].shape, 0);
            Quadruple error = hits[n].point[1] - sinf128(rays[n].origin[0]);
            worst = fmax(worst, fabs((double)(error / roundoff(*engine))));
        }
        printf("  %-7s sines are off by %.2f half ulps of 1\n", (*engine)->name, worst);
        // The distance 2 - sin x has an ulp of up to 4 of these.
        assert_at_most(worst, 8, "sines in %s", (*engine)->name);
        (*engine)->destroy(tracer);
    }
    scene_destroy(scene);
}

/* --- boxes and slopes ------------------------------------------------------------------------- */

/** Boxes contain the surface, and are not much larger. */
static void test_bounds(void **state) {
    for (int i = 0; i < CASES; i++) {
        Scene *scene = load_field(state, cases[i].text);
        const Sdf *field = field_of(scene);
        Vec3d edges = vec3d_subtract(field->high, field->low);
        double half = 0.5 * vec3d_max_abs(edges);
        printf("  %-22s half edge %g\n", cases[i].name, half);
        if (isfinite(cases[i].half_edge)) {
            assert_at_most(half, 1.07 * cases[i].half_edge, "%s, box", cases[i].name);
            assert_at_most(cases[i].half_edge, 1.02 * half, "%s, box", cases[i].name);
        } else {
            assert_true(half == HUGE_VAL);
        }
        uint64_t seed = 1;
        for (int n = 0; n < POINTS; n++) {
            Vec3d p = random_point(&seed);
            Vec3d nearest = vec3d_min(vec3d_max(p, field->low), field->high);
            bool is_outside = vec3d_max_abs(vec3d_subtract(p, nearest)) > 0;
            assert_true(!is_outside || sdf_tape_value(field->nodes, p) > 0);
        }
        scene_destroy(scene);
    }
}

/** Slopes are found, and tapes are divided by them; only steep ones have a note. */
static void test_slopes(void **state) {
    for (int i = 0; i < CASES; i++) {
        Scene *scene = load_field(state, cases[i].text);
        const double *operands = field_of(scene)->nodes[0].operands;
        double slope = operands[SDF_TAPE_SLOPE], factor = operands[SDF_TAPE_FACTOR];
        printf("  %-22s slope %.9f, factor %.4f\n", cases[i].name, slope, factor);
        if (cases[i].slope == 0) {
            scene_destroy(scene);
            continue;
        }
        assert_at_most(fabs(slope - cases[i].slope), 0.01 * cases[i].slope, "%s, slope",
                       cases[i].name);
        bool is_divided = cases[i].slope > 1 || cases[i].slope < SDF_TAPE_SLOPE_MINIMUM;
        assert_int_equal(scene->note_count, is_divided);
        assert_true(is_divided ? factor * cases[i].slope < 1 && factor * cases[i].slope > 0.9
                               : factor == 1);
        scene_destroy(scene);
    }
}

/** Rays do not pass through a steep field, and in a union it is not evaluated where it is steeper
 *  than it was measured. */
static void test_steep_fields(void **state) {
    static const char *const fields[] = {
        "function(x, y, z) return x ^ 2 + y * y + z * z - 1 end",
        "distance.union(distance.field(function(x, y, z) return x ^ 2 + y * y + z * z - 1 end), "
        "distance.sphere { radius = 0.25 }:translate{0, 0, -2})",
        "function(x, y, z) return 1000 * length(x, y, z) - 1000 end",
        "function(x, y, z) return max(length(x, y, z) * 3, x ^ 4) - 3 end"};
    static RayResult hits[RAYS], truth[RAYS];
    Scene *sphere = load_field(state, "distance.sphere {}");
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
        Scene *scene = load_field(state, fields[i]);
        const Engine *engine = engine_find("f64x1", NULL);
        int count = intersect(engine, sphere, truth), missed = 0;
        intersect(engine, scene, hits);
        for (int n = 0; n < count; n++) {
            missed += truth[n].shape >= 0 &&
                      !((double)hits[n].distance <= (double)truth[n].distance * (1 + 1e-3));
        }
        // Rays that only touch the sphere.
        assert_at_most(missed, count / 400, "%s, passed through", fields[i]);
        scene_destroy(scene);
    }
    scene_destroy(sphere);
}

/** The notes of a scene name line and cause. */
static void test_notes(void **state) {
    static const struct {
        const char *text; /**< A field at line 2. */
        const char *note; /**< Part of the note. */
    } notes[] = {
        {"function(x, y, z) return 2 * x end", "scene.lua:3: this field grows by 2 per unit"},
        {"function(x, y, z) return length(x // 1, y, z) - 1 end",
         "scene.lua:3: this field jumps by "},
        {"function(x, y, z) return math.sqrt(-1 - x * x) end",
         "scene.lua:3: this field is a number at none of the points that were tried"},
        {"function(x, y, z) return x / 0 end",
         "scene.lua:3: this field is a number at none of the points that were tried"},
    };
    for (size_t i = 0; i < sizeof notes / sizeof *notes; i++) {
        char text[1024];
        Error error = {0};
        snprintf(text, sizeof text,
                 "camera {}\nlocal length = function(x, y, z) return math.sqrt(x*x+y*y+z*z) end\n"
                 "sdf { %s }",
                 notes[i].text);
        Scene *scene = load(state, text, &error);
        assert_non_null(scene);
        assert_int_equal(scene->note_count, 1);
        if (!strstr(scene->notes[0], notes[i].note)) {
            fail_msg("wanted: %s\ngot: %s", notes[i].note, scene->notes[0]);
        }
        scene_destroy(scene);
    }
}

/* --- the language ----------------------------------------------------------------------------- */

/** The fourth argument is the time; only who takes it depends on it. */
static void test_time(void **state) {
    Scene *scene = load_field(state, "function(x, y, z, t) return length(x, y, z) - t end");
    assert_true(scene->is_time_dependent);
    assert_at_most(fabs(field_of(scene)->high.x - 2), 1e-3, "radius at t = 2");
    scene_destroy(scene);
    scene = load_field(state, "function(x, y, z) return length(x, y, z) - 1 end");
    assert_false(scene->is_time_dependent);
    scene_destroy(scene);
}

/** Functions take part in operations on fields, and Lua's `math` works as before. */
static void test_operations(void **state) {
    Scene *scene = load_field(
        state, "distance.union(distance.field(function(x, y, z) return length(x, y, z) - 1 end)"
               ":translate{2, 0, 0}:rotate{0, 90, 0}, distance.box {})");
    const Sdf *field = field_of(scene);
    assert_true(sdf_check(field));
    assert_at_most(fabs(field->low.z + 3), 1e-3, "lowest z");
    scene_destroy(scene);
    scene = load_field(state, "distance.sphere { radius = math.max(1, math.sqrt(4)) + math.sin(0) "
                              "+ math.floor(0.5) + math.abs(-1) - math.tointeger(1) }");
    assert_true(field_of(scene)->high.x == 2);
    scene_destroy(scene);
}

/** What cannot be a tape is refused, with its line. */
static void test_refused(void **state) {
    static const struct {
        const char *text;    /**< The function; its first line is line 2 of the scene. */
        int line;            /**< Line of the error. */
        const char *message; /**< Part of the message. */
    } wrong[] = {
        {"function(x, y, z)\n\nif x > 0 then return y end return z end", 4, "cannot compare"},
        {"function(x, y, z)\nif x <= y then return y end return z end", 3, "cannot compare"},
        {"function(x, y, z)\nif x == y then return y end return z end", 3, "cannot compare"},
        {"function(x, y, z)\nif x == 0 then return y end return x - 1 end", 2, "the function says"},
        {"function(x, y, z)\nreturn tostring(x) end", 3, "no value yet"},
        {"function(x, y, z)\nreturn #x end", 3, "no value yet"},
        {"function(x, y, z)\nreturn x.y end", 3, "no value yet"},
        {"function(x, y, z)\nreturn x .. 'a' end", 3, "no value yet"},
        {"function(x, y, z)\nreturn x & 1 end", 3, "no value yet"},
        {"function(x, y, z)\nreturn x(1) end", 3, "no value yet"},
        {"function(x, y, z)\nx.a = 1 end", 3, "no value yet"},
        {"function(x, y, z)\nprint(x) end", 3, "no value yet"},
        {"function(x, y, z)\nreturn ({1, 2})[x] + 1 end", 3, "nil"},
        {"function(x, y, z)\nreturn math.exp(x) end", 3, "math.exp cannot be part of a field"},
        {"function(x, y, z)\nreturn math.random(x) end", 3, "number expected"},
        {"function(x, y, z)\nreturn x + math.random() end", 2, "the function says"},
        {"function(x, y, z)\nreturn x + 'one' end", 3, "not with a string"},
        {"function(x, y, z)\nreturn x + {} end", 3, "not with a table"},
        {"function(x, y, z)\nreturn x ^ 0.3 end", 3, "whole or half exponent"},
        {"function(x, y, z)\nreturn x ^ 65 end", 3, "whole or half exponent"},
        {"function(x, y, z)\nreturn 2 ^ x end", 3, "whole or half exponent"},
        {"function(x, y, z)\nreturn x * 1e31 end", 2, "at most 1e+30"},
        {"function(x, y, z)\nreturn x + 0 / 0 end", 2, "must be finite"},
        {"function(x, y, z)\nfor i = 1, x do end return x end", 3, "number expected"},
        {"function(x, y, z)\nfor i = 1, 1e9 do x = x + i * y end return x end", 3,
         "more than 4095 operations"},
        {"function(x, y, z)\nlocal function f(a) return f(a) + 1 end return f(x) end", 3,
         "stack overflow"},
        {"function(x, y, z)\nlocal d, all = 0, {} for i = 1, 300 do all[i] = x / (i + y) end\n"
         "for i = 1, 300 do d = d + all[i] * all[301 - i] end return d end",
         2, "more than 256 numbers"},
        {"function(x, y, z) end", 2, "must return a number that depends on x, y or z, not nothing"},
        {"function(x, y, z) return 1 end", 2, "not a number"},
        {"function(x, y, z) return x, y end and nil", 2, "needs a field"},
        {"function(x, y, z) return x * x + 1 end", 2, "no surface"},
        {"math.random", 2, "wrong number of arguments"},
        {"function(x, y, z) error('no') end", 2, "no"},
        {"function(x, y, z) kept.x = kept.x or x return x - 1 end }\nsdf { function(x, y, z) "
         "return "
         "kept.x end",
         3, "must return a number"},
        {"function(x, y, z) kept.x = kept.x or x return x - 1 end }\nsdf { function(x, y, "
         "z)\nreturn x "
         "+ kept.x end",
         4, "belongs to another field"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char text[1024], place[32];
        Error error = {0};
        snprintf(text, sizeof text, "camera {} local kept = {}\nsdf { %s }", wrong[i].text);
        snprintf(place, sizeof place, "scene.lua:%d: ", wrong[i].line);
        Scene *scene = load(state, text, &error);
        if (scene || error.status != STATUS_SCENE || !strstr(error.message, place) ||
            !strstr(error.message, wrong[i].message)) {
            fail_msg("%s\nwanted: %s%s\ngot: (%d) %s", text, place, wrong[i].message, error.status,
                     scene ? "a scene" : error.message);
        }
    }
}

/** A field from a process that was taken over is refused, whatever number of it is changed. */
static void test_check(void **state) {
    Scene *scene = load_field(state, cases[2].text);
    const Sdf *field = field_of(scene);
    const double wrong[] = {-1, 0.5, 4096, 1e300, HUGE_VAL, NAN};
    Sdf *copy = calloc(1, sdf_size(field->node_count));
    assert_true(sdf_check(field));
    for (int i = 0; i < field->node_count; i++) {
        for (int n = 0; n < (i == 0 ? 2 : 4); n++) {
            for (size_t w = 0; w < sizeof wrong / sizeof *wrong; w++) {
                memcpy(copy, field, sdf_size(field->node_count));
                copy->nodes[i].operands[n] = wrong[w];
                bool is_factor =
                    i == 0 && n == SDF_TAPE_FACTOR && (wrong[w] == 0.5 || wrong[w] == 4096);
                assert_true(sdf_check(copy) == is_factor);
            }
        }
        memcpy(copy, field, sdf_size(field->node_count));
        copy->nodes[i].operands[SDF_STEP_CONSTANT] = NAN;
        assert_false(sdf_check(copy));
        memcpy(copy, field, sdf_size(field->node_count));
        copy->nodes[i].op = (SdfOp)(SDF_TAPE_STEP + 1);
        assert_false(sdf_check(copy));
        memcpy(copy, field, sdf_size(field->node_count));
        copy->nodes[i].body_count = field->node_count;
        assert_false(sdf_check(copy));
        copy->nodes[i].body_count = -1;
        assert_false(sdf_check(copy));
    }
    memcpy(copy, field, sdf_size(field->node_count));
    copy->node_count = SDF_NODES_MAXIMUM + 1;
    assert_false(sdf_check(copy));
    free(copy);
    scene_destroy(scene);
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values),       cmocka_unit_test(test_gradients),
        cmocka_unit_test(test_lanes),        cmocka_unit_test(test_twins),
        cmocka_unit_test(test_common_steps), cmocka_unit_test(test_sines),
        cmocka_unit_test(test_bounds),       cmocka_unit_test(test_slopes),
        cmocka_unit_test(test_steep_fields), cmocka_unit_test(test_notes),
        cmocka_unit_test(test_time),         cmocka_unit_test(test_operations),
        cmocka_unit_test(test_refused),      cmocka_unit_test(test_check),
    };
    return cmocka_run_group_tests_name("functions of fields", tests, fixture_set_up,
                                       fixture_tear_down);
}
