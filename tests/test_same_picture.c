/**
 * @file
 * @brief Tests that a scene file is the same scene on every run: nothing that a script can read
 *        depends on addresses, random seeds, the clock or the folder in which it lies.
 */
#include "scene_files.h"

// --- texts ---------------------------------------------------------------------------------------

/** Number of runs that are compared. Each is a process with other addresses and another seed. */
enum { RUNS = 5 };

/** Memory of these scenes, bytes: little, because one of them finds out how much. */
#define TEXT_MEMORY ((size_t)16 << 20)

/** Beginning of all texts: `say` ends the scene with a text. */
#define SAY "local function say(...) error(table.concat({...}, ' '), 0) end\n"

/** Loads a scene that ends with a text. @param[out] text The text. */
static void run_text(const Fixture *fixture, const char *script, char text[ERROR_MESSAGE_SIZE]) {
    char whole[4096];
    Error error = {0};
    snprintf(whole, sizeof whole, "%s%s", SAY, script);
    write_text(fixture->path, whole);
    ScriptRequest request = script_request_for(fixture->path);
    request.memory_limit = TEXT_MEMORY;
    assert_null(script_load(&request, &error));
    assert_int_equal(error.status, STATUS_SCENE);
    strcpy(text, error.message);
}

/** Asserts the text of a scene, and that it is the same in all runs. */
static void assert_same_text(const Fixture *fixture, const char *script, const char *wanted) {
    char first[ERROR_MESSAGE_SIZE], text[ERROR_MESSAGE_SIZE];
    run_text(fixture, script, first);
    const char *said = strstr(first, ": ");
    if (!said || (wanted && strcmp(said + 2, wanted) != 0)) {
        fail_msg("%s\nwanted: %s\ngot: %s", script, wanted, first);
    }
    for (int i = 1; i < RUNS; i++) {
        run_text(fixture, script, text);
        if (strcmp(first, text) != 0) {
            fail_msg("%s\nfirst: %s\nthen: %s", script, first, text);
        }
    }
}

/** A script, and the text that it ends with. */
typedef struct TextCase {
    const char *script; /**< The script. */
    const char *text;   /**< The text; NULL: any, but the same in all runs. */
} TextCase;

/** Asserts texts. */
static void assert_same_texts(void **state, const TextCase *cases, size_t count) {
    for (size_t i = 0; i < count; i++) {
        assert_same_text(*state, cases[i].script, cases[i].text);
    }
}

// --- tests ---------------------------------------------------------------------------------------

/** Objects are numbered in the order in which their texts are asked for. */
static void test_addresses(void **state) {
    static const TextCase cases[] = {
        {"local a, b = {}, {}\nsay(tostring(b), tostring(a), tostring(b), tostring(print))",
         "table: 1 table: 2 table: 1 function: 3"},
        {"say(tostring(say), tostring(sphere {}), tostring(material {}))",
         "function: 1 sphere: 2 material: 3"},
        {"say(tostring(distance.sphere {}), tostring(string), tostring(_ENV))", NULL},
        {"local f = function() end\nsay(('%s|%12s|%-9s|%s'):format(f, {}, 'x', f))",
         "function: 1|    table: 2|x        |function: 1"},
        {"say((('%s%%%s\\0%s'):format(1, {}, {}):gsub('%z', '0')))", "1%table: 10table: 2"},
        {"local named = setmetatable({}, { __name = 'ball' })\nsay(tostring(named))", "ball: 1"},
        {"local own = setmetatable({}, { __tostring = function() return 'own' end })\n"
         "say(tostring(own), ('%s'):format(own))",
         "own own"},
        {"say(tostring(nil), tostring(1), tostring(0.1), tostring(true), tostring('x'))",
         "nil 1 0.1 true x"},
        {"say(select(2, pcall(string.format, '%p', {})))",
         "string.format takes no %p here: addresses are others in each run"},
        {"say(select(2, pcall(string.format, '\\0%s%-20p', 1, {})))",
         "string.format takes no %p here: addresses are others in each run"},
        {"say(select(2, pcall(string.format, '%d', {})))",
         "bad argument #2 to 'string.format' (number expected, got table)"},
        {"say(select(2, pcall(string.format, '%s')))",
         "bad argument #2 to 'string.format' (no value)"},
        {"say(select(2, pcall(error, {})) and 'table')", "table"},
        {"for i = 1, 1e4 do local x = tostring({}) end say(tostring({}))", "table: 10001"},
    };
    assert_same_texts(state, cases, COUNT(cases));
}

/** `pairs` and `next` go by the keys, and leave out what is removed on the way. */
static void test_order_of_keys(void **state) {
    static const TextCase cases[] = {
        {"local t, keys = {}, {}\nfor i = 1, 300 do t['k' .. i * 7919 % 1000] = i end\n"
         "for k in pairs(t) do keys[#keys + 1] = k end\n"
         "for i = 2, #keys do assert(keys[i - 1] < keys[i]) end say(#keys, keys[1], keys[300])",
         "300 k102 k996"},
        {"local t, keys = { 'a', 'b', [4] = 'd', x = 1, [2.5] = 2, [true] = 3 }, {}\n"
         "for k in next, t do keys[#keys + 1] = tostring(k) end say(table.unpack(keys))",
         "1 2 4 2.5 x true"},
        {"local t, n = {}, 0\nfor i = 1, 100 do t['x' .. i] = i end\n"
         "for k in pairs(t) do n = n + 1 t[k] = nil t['x' .. n + 50] = nil end say(n)",
         NULL},
        {"local t, n = {}, 0\nfor i = 1, 100 do t['x' .. i] = i end\n"
         "for k in next, t do n = n + 1 t[k] = nil end say(n, tostring(next(t)))",
         "100 nil"},
        {"local t = { a = 1, b = 2, c = 3, d = 4 }\nt.b = nil\n"
         "say(next(t, 'a'), next(t, 'b'), tostring(next(t, 'd')), next(t, 'bb'), next(t))",
         "c c nil c a 1"},
        {"local t, all = { a = 1, b = 2, c = 3 }, {}\n"
         "for k in next, t do for l in next, t do all[#all + 1] = k .. l end end\n"
         "say(table.unpack(all))",
         "aa ab ac ba bb bc ca cb cc"},
        {"local t = { a = 1 }\nassert(next(t, 'a') == nil)\nt.b = 2\nsay(next(t, 'a'))", "b 2"},
        {"local t = { 1, 2, 3 }\nfor k in pairs(t) do t[k] = nil t[2] = nil end\n"
         "say(tostring(next(t)), tostring(next({})))",
         "nil nil"},
        // A single key without an order has a place: the last.
        {"local t, all = { [{}] = 'last', 'first', x = 'second' }, {}\n"
         "for _, v in pairs(t) do all[#all + 1] = v end\n"
         "for _, v in next, t do all[#all + 1] = v end say(table.unpack(all))",
         "first second last first second last"},
        {"local one = { [{}] = 1 }\nsay(type(next(one)), tostring(next(one, (next(one)))))",
         "table nil"},
        {"say(select(2, pcall(pairs, { [{}] = 1, [print] = 2 })))",
         "pairs has no order for keys that are tables, functions or parts of the scene; put them "
         "into a list"},
        {"say(select(2, pcall(next, { [{}] = 1, [print] = 2 })))",
         "pairs has no order for keys that are tables, functions or parts of the scene; put them "
         "into a list"},
        {"local t = { [{}] = 1, [print] = 2, 3 }\nsay(next(t), pcall(next, t, 1) and 'bad' or "
         "'ok')",
         "1 ok"},
        {"say(pcall(pairs) and 'bad' or 'ok', pcall(next, 1) and 'bad' or 'ok')", "ok ok"},
        {"local t = setmetatable({ b = 1, a = 2 }, {})\nlocal f, s, k = pairs(t)\n"
         "say(f(s, k), tostring(f(s)), tostring(f(s)))",
         "a b nil"},
        // The first unknown field by its name is told.
        {"say(select(2, pcall(sphere, { zz = 1, yy = 2, xx = 3, ww = 4, vv = 5 })))",
         "sphere has no field `vv`"},
        {"say(select(2, pcall(sphere, { zz = 1, 2, [print] = 3 })))",
         "sphere takes fields with names, such as `center = ...`; one has none; a decimal number "
         "has a point: 0.5, not 0,5"},
    };
    assert_same_texts(state, cases, COUNT(cases));
}

/** Walks through many keys take time for each key, not for each pair of keys. */
static void test_many_keys(void **state) {
    Scene *scene;
    Error error = {0};
    ScriptRequest request = script_request_for(((const Fixture *)*state)->path);
    // Plain loops take ten times less; with a search of all keys for each step, the limit of 10 s
    // would not suffice.
    request.time_limit = 1.5;
    write_text(request.path,
               "camera {}\nlocal t, n = {}, 0\nfor i = 1, 20000 do t['key ' .. i] = i end\n"
               "for k, v in pairs(t) do n = n + v end\nassert(n == 200010000)\n"
               "for k, v in next, t do n = n - v end\nassert(n == 0)\n"
               "local k, v = next(t)\nwhile k do n = n + v; k, v = next(t, k) end\n"
               "assert(n == 200010000)\n"
               "for i = 1, 20000 do t[i], t[i + 0.5], t[-i] = i, i, i end\n"
               "n = 0 for k in pairs(t) do n = n + 1 end assert(n == 80000)");
    scene = script_load(&request, &error);
    assert_string_equal(error.message, "");
    scene_destroy(scene);
}

/** Sorting keeps equal items in sequence, even where an order would lead Lua's own astray. */
static void test_sort(void **state) {
    static const TextCase cases[] = {
        {"local t = { 5, 3, 9, 1, 3, 7 } table.sort(t) say(table.unpack(t))", "1 3 3 5 7 9"},
        {"local t = { 'b', 'a', 'B', 'ab' } table.sort(t) say(table.unpack(t))", "B a ab b"},
        {"local t = {} table.sort(t) t[1] = 2 table.sort(t) say(#t, t[1])", "1 2"},
        {"local t = { 1, 2, 3, 4, 5 } table.sort(t, function(a, b) return a > b end)\n"
         "say(table.unpack(t))",
         "5 4 3 2 1"},
        {"local t = {}\nfor i = 1, 3000 do t[i] = { i * 7919 % 13, i } end\n"
         "table.sort(t, function(a, b) return a[1] < b[1] end)\n"
         "for i = 2, #t do local a, b = t[i - 1], t[i]\n"
         "  assert(a[1] < b[1] or a[1] == b[1] and a[2] < b[2]) end say('stable')",
         "stable"},
        // An order that answers what slows a quicksort most: Lua's would ask the clock then.
        {"local n, value, solid, candidate, count, t = 3000, {}, 0, 0, 0, {}\n"
         "for i = 1, n do t[i], value[i] = i, n end\n"
         "table.sort(t, function(x, y)\n  count = count + 1\n"
         "  if value[x] == n and value[y] == n then\n"
         "    local frozen = x == candidate and x or y\n"
         "    value[frozen], solid = solid, solid + 1\n  end\n"
         "  if value[x] == n then candidate = x elseif value[y] == n then candidate = y end\n"
         "  return value[x] < value[y]\nend)\n"
         "local sum = 0 for i = 1, n do sum = (sum * 31 + t[i]) % 1000003 end\n"
         "assert(count < 40000) say(count, sum)",
         NULL},
        // An order that is none: no error that depends on the sequence.
        {"local t = {}\nfor i = 1, 200 do t[i] = i end table.sort(t, function() return true end)\n"
         "table.sort(t, function() return math.random() < 0.5 end) say(#t, t[1], t[100])",
         NULL},
        {"local t = { 3, 2, 1 }\nassert(not pcall(table.sort, t, error)) say(table.unpack(t))",
         "3 2 1"},
        {"say(select(2, pcall(table.sort, { 1, {} })))", "attempt to compare table with number"},
        {"say(select(2, pcall(table.sort, 1)))",
         "bad argument #1 to 'table.sort' (table expected, got number)"},
        {"say(select(2, pcall(table.sort, { 2, 1 }, 1)))",
         "bad argument #2 to 'table.sort' (function expected, got number)"},
    };
    assert_same_texts(state, cases, COUNT(cases));
}

/** Random numbers, lengths, numbers as text, memory and errors do not differ between runs. */
static void test_other_sources(void **state) {
    static const TextCase cases[] = {
        {"say(math.random(1 << 60), math.random(), math.random(6))", NULL},
        {"math.randomseed(7) local a = math.random(1 << 60) math.randomseed(7)\n"
         "say(a == math.random(1 << 60) and 'same' or 'other', select('#', math.randomseed(3)))",
         "same 0"},
        {"say(pcall(math.randomseed) and 'bad' or 'ok')", "ok"},
        {"say(('%a %.17g %g %5.1f'):format(0.1, 1 / 3, 1e300, 2.25), 2^53, 1e15, 1 / 0, -(0 / 0))",
         NULL},
        {"local t = { 1, 2, nil, 4, nil, 6 }\nlocal u = { x = 1, y = 2, z = 3 }\n"
         "for i = 1, 40, 3 do u[i] = i end say(#t, #u, select('#', table.unpack(t)))",
         NULL},
        // How much memory is left, to the byte.
        {"local t = {}\nfor i = 1, 1000 do t['k' .. i] = { i } end\n"
         "local low, high = 0, 1 << 28\nwhile high - low > 1 do\n"
         "  local middle = (low + high) // 2\n"
         "  if pcall(string.rep, 'x', middle) then low = middle else high = middle end\nend "
         "say(low)",
         NULL},
        {"say(select(2, pcall(setmetatable, {}, { __mode = 'k' })))",
         "a scene may not use __mode: nobody knows when such a table would lose its items"},
        {"say(select(2, pcall(setmetatable, {}, { __gc = print })))",
         "a scene may not use __gc: nobody knows when it would run"},
        {"local function deep(n) return 1 + (pcall(deep, n + 1) and 0 or 0) end\n"
         "local depth = 0 local function down() depth = depth + 1 down() end\n"
         "pcall(down) say(depth)",
         NULL},
        // No path: the same scene in another folder.
        {"say('caught', select(2, pcall(error, 'x')))", "caught x"},
        {"say('caught', select(2, pcall(function() local x = nil + 1 end)))",
         "caught scene.lua:2: attempt to perform arithmetic on a nil value"},
    };
    assert_same_texts(state, cases, COUNT(cases));
}

/** @return 0 if all tests pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_addresses),     cmocka_unit_test(test_order_of_keys),
        cmocka_unit_test(test_many_keys),     cmocka_unit_test(test_sort),
        cmocka_unit_test(test_other_sources),
    };
    return cmocka_run_group_tests_name("same_picture", tests, scene_fixture_set_up,
                                       fixture_tear_down);
}
