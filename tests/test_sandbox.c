/**
 * @file
 * @brief Tests of the sandbox of scene scripts: no escape, limits of time, memory and output,
 *        processes.
 */
#include "scene_files.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

// --- escapes -------------------------------------------------------------------------------------

/** Functions that would allow an escape do not exist. */
static void test_escapes(void **state) {
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

/** Messages contain no terminal control sequences, and their length is limited. */
static void test_messages_are_clean(void **state) {
    const Fixture *fixture = *state;
    assert_text_refused(fixture, "error('a\\27[31mb\\0c\\rd\\155e\\194\\155f\\127')", 1,
                        "a\\27[31mb\\0c\\13d\\155e\\194\\155f\\127", NULL);
    assert_text_refused(fixture, "error('d\xC3\xA9j\xC3\xA0 vu \xE2\x82\xAC\\xff')", 1,
                        "d\xC3\xA9j\xC3\xA0 vu \xE2\x82\xAC\\255", NULL);
    assert_text_refused(fixture, "error(('\\1y'):rep(1e6))", 1, "\\1y\\1y\\1y", NULL);
    assert_text_refused(fixture, "error('100%s %n')", 1, "100%s %n", NULL);
}

// --- limits --------------------------------------------------------------------------------------

/** @return Processor time of the child processes that have ended, seconds. */
static double children_seconds(void) {
    struct rusage usage;
    getrusage(RUSAGE_CHILDREN, &usage);
    return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/** The time limit interrupts loops and calls of library functions. */
static void test_time_limit(void **state) {
    static const InvalidScene cases[] = {
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
        double start = children_seconds();
        assert_text_refused(
            *state, cases[i].text, cases[i].line, cases[i].message,
            &(ScriptRequest){.time_limit = 0.2, .memory_limit = SCRIPT_MEMORY_LIMIT});
        double taken = children_seconds() - start;
        assert_true(taken > 0.19 && taken < 1.5);
    }
}

/** The memory limit holds. */
static void test_memory_limit(void **state) {
    static const char words[] = "the scene needs more than 4 MiB of memory";
    static const InvalidScene cases[] = {
        {"camera {}\nlocal x = ('x'):rep(1 << 30)", 2, words},
        {"local x = 'x'\nwhile true do\n  x = x .. x\nend", 3, words},
        {"local list = {}\nwhile true do\n  list[#list + 1] = {}\nend", 3, words},
        {"for i = 1, 1e9 do\n  rawset(_ENV, i, i)\nend", 2, words},
        {"local x = ('x'):rep(1500000)\nlocal y = x .. x", 2, words},
        {"local function f()\n  return 1 + f()\nend\nf()", 2, words},
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        assert_text_refused(
            *state, cases[i].text, cases[i].line, cases[i].message,
            &(ScriptRequest){.time_limit = SCRIPT_TIME_LIMIT, .memory_limit = 4 << 20});
    }
    assert_text_refused(*state, "camera {}", 1, "needs more than 0.000976562 MiB",
                        &(ScriptRequest){.time_limit = SCRIPT_TIME_LIMIT, .memory_limit = 1024});
    assert_text_refused(*state, "camera {}", 1, "needs more than 0.0078125 MiB",
                        &(ScriptRequest){.time_limit = SCRIPT_TIME_LIMIT, .memory_limit = 8192});
}

/** A script that catches a failed allocation can still be valid. */
static void test_refused_memory_can_be_caught(void **state) {
    Scene *scene = load_valid_scene(*state, "camera {}\nassert(not pcall(string.rep, 'x', 1e10))");
    scene_destroy(scene);
}

/** Printed text goes to standard error, without control characters, up to a limit. */
static void test_print(void **state) {
    const Fixture *fixture = *state;
    char path[128], got[256] = "";
    snprintf(path, sizeof path, "%s/printed", fixture->folder);
    int saved_fd = dup(STDERR_FILENO), file = open(path, O_RDWR | O_CREAT | O_TRUNC, 0600);
    dup2(file, STDERR_FILENO);
    Scene *scene = load_valid_scene(fixture, "camera {} print('one', 2, nil, '\\27[2J')\n"
                                             "for i = 1, 1e5 do print(('y'):rep(99)) end");
    dup2(saved_fd, STDERR_FILENO);
    scene_destroy(scene);
    off_t size = lseek(file, 0, SEEK_END);
    assert_true(size > 65000 && size < 67000);
    assert_true(pread(file, got, sizeof got - 1, 0) > 0);
    assert_int_equal(strncmp(got, "one\t2\tnil\t\\27[2J\nyyy", 20), 0);
    assert_true(pread(file, got, 50, size - 50) == 50);
    assert_non_null(strstr(got, "printed more"));
    close(file);
    close(saved_fd);
}

// --- processes -----------------------------------------------------------------------------------

/** Does nothing. */
static void ignore_alarm(int signal) {
    (void)signal;
}

/** Signals do not interrupt waiting for the worker, and no child process is left. */
static void test_signals_while_waiting(void **state) {
    struct sigaction before, act = {.sa_handler = ignore_alarm};
    const struct itimerval fast = {{0, 10000}, {0, 10000}}, off = {{0, 0}, {0, 0}};
    sigaction(SIGALRM, &act, &before);
    setitimer(ITIMER_REAL, &fast, NULL);
    assert_text_refused(*state, "while true do end", 1, "0.2 s",
                        &(ScriptRequest){.time_limit = 0.2, .memory_limit = SCRIPT_MEMORY_LIMIT});
    setitimer(ITIMER_REAL, &off, NULL);
    sigaction(SIGALRM, &before, NULL);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
    assert_int_equal(errno, ECHILD);
}

/** Scenes load in a program that ignores SIGCHLD. */
static void test_children_reaped_by_the_system(void **state) {
    struct sigaction before, act = {.sa_handler = SIG_IGN};
    sigaction(SIGCHLD, &act, &before);
    scene_destroy(load_valid_scene(*state, "camera {}"));
    assert_text_refused(*state, "while true do end", 1, "0.1 s",
                        &(ScriptRequest){.time_limit = 0.1, .memory_limit = SCRIPT_MEMORY_LIMIT});
    sigaction(SIGCHLD, &before, NULL);
}

/** @return 0 if all tests pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_escapes),
        cmocka_unit_test(test_messages_are_clean),
        cmocka_unit_test(test_time_limit),
        cmocka_unit_test(test_memory_limit),
        cmocka_unit_test(test_refused_memory_can_be_caught),
        cmocka_unit_test(test_print),
        cmocka_unit_test(test_signals_while_waiting),
        cmocka_unit_test(test_children_reaped_by_the_system),
    };
    return cmocka_run_group_tests_name("sandbox", tests, scene_fixture_set_up, fixture_tear_down);
}
