/**
 * @file
 * @brief Tests of languages with threads and processes. tests/language.sh tests the translations.
 */
#include "testing.h"

#include "assets/process/worker_main.h"
#include "assets/process/worker_process.h"
#include "base/language.h"
#include "base/typeset_numbers.h"

#include <libintl.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/** Number of workers. */
enum { WORKERS = 30 };

/** Translates words until it is stopped. @return NULL */
static void *translate_until_stopped(void *context) {
    atomic_bool *is_over = context;
    while (!atomic_load(is_over)) {
        if (!gettext("no memory for a lesson") || !ngettext(", %d sample", ", %d samples", 2)) {
            break;
        }
    }
    return NULL;
}

/** Task of a worker: reports its language, and translates words. */
static void translate_task(WorkerJob *job) {
    static bool is_french;
    is_french = language_is_french() && gettext("no memory for a lesson");
    job->report = &is_french;
    job->report_size = sizeof is_french;
}

/** Workers use the language of the program, whatever its other threads do. */
static void test_workers(void **state) {
    (void)state;
    pthread_t threads[2];
    atomic_bool is_over = false;
    setenv("LANGUAGE", "fr", 1);
    setenv("LC_ALL", "C.UTF-8", 1);
    language_init();
    assert_true(language_is_french());
    for (int i = 0; i < 2; i++) {
        assert_int_equal(pthread_create(&threads[i], NULL, translate_until_stopped, &is_over), 0);
    }
    int wrong = 0;
    for (int i = 0; i < WORKERS; i++) {
        bool is_french;
        const WorkerCall call = {.program = "/proc/self/exe",
                                 .task = "translate",
                                 .time_limit = 5,
                                 .report = &is_french,
                                 .report_capacity = sizeof is_french};
        wrong += worker_process_call_once(&call).end != WORKER_FINISHED;
        wrong += is_french != language_is_french();
        language_toggle();
    }
    atomic_store(&is_over, true);
    for (int i = 0; i < 2; i++) {
        pthread_join(threads[i], NULL);
    }
    assert_int_equal(wrong, 0);
}

/** Numbers of the window have a comma in French, and semicolons where commas stood between them;
 *  names, words and what has no room stay. */
static void test_numbers(void **state) {
    (void)state;
    static const struct {
        const char *text, *french;
    } cases[] = {
        {"1.5e-04 ms, 3.25 %", "1,5e-04 ms, 3,25 %"},
        {"(0.5, -1, 2.25)", "(0,5\xc2\xa0; -1\xc2\xa0; 2,25)"},
        {"(inf, nan, 1)", "(inf\xc2\xa0; nan\xc2\xa0; 1)"},
        {"n (4, 5), 6, 7", "n (4\xc2\xa0; 5), 6, 7"},
        {"1) (0.5, 2)", "1) (0,5\xc2\xa0; 2)"},
        {"(u, v): 1, 2.5", "(u, v): 1, 2,5"},
        {"end 3. Then .5 a.b 1.x", "end 3. Then .5 a.b 1.x"},
        {"", ""},
    };
    for (int is_french = 0; is_french < 2; is_french++) {
        language_init_as(is_french);
        for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
            char text[64];
            strcpy(text, cases[i].text);
            language_localize_numbers(text, sizeof text);
            assert_string_equal(text, is_french ? cases[i].french : cases[i].text);
        }
    }
    // A sign takes two bytes more than what it replaces.
    char full[] = "(0.5, 1, 2)";
    language_localize_numbers(full, sizeof full);
    assert_string_equal(full, "(0,5, 1, 2)");
    char room[] = "(0.5, 1, 2)\0\0";
    language_localize_numbers(room, sizeof room);
    assert_string_equal(room, "(0,5\xc2\xa0; 1, 2)");
}

/** Numbers that are only read have a minus sign, powers of ten, and in French groups of digits;
 *  names and hyphens stay. */
static void test_typeset(void **state) {
    (void)state;
    static const struct {
        const char *text, *english, *french;
    } cases[] = {
        {"1.0e-04 ms", "1.0 × 10⁻⁴ ms", "1,0 × 10⁻⁴ ms"},
        {"2e+20, 3e-300, 1e+00", "2 × 10²⁰, 3 × 10⁻³⁰⁰, 1 × 10⁰", "2 × 10²⁰, 3 × 10⁻³⁰⁰, 1 × 10⁰"},
        {"(-0.5, 1e-05)", "(−0.5, 1 × 10⁻⁵)", "(−0,5 ; 1 × 10⁻⁵)"},
        {"1 / 2e-05 = 1 / 3e-05² = -4", "1 / (2 × 10⁻⁵) = 1 / (3 × 10⁻⁵)² = −4",
         "1 / (2 × 10⁻⁵) = 1 / (3 × 10⁻⁵)² = −4"},
        {"480000, 1234, 12345678.5", "480000, 1234, 12345678.5", "480 000, 1234, 12 345 678,5"},
        {"0.123456 00012", "0.123456 00012", "0,123456 00012"},
        {"f32x16 box-0001 scene-12345.lua 1e5x a-3 2-3 12345px", NULL, NULL},
        {"12345_6 _12345 --4 (5)-6", NULL, NULL},
        {"", "", ""},
    };
    for (int is_french = 0; is_french < 2; is_french++) {
        language_init_as(is_french);
        for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
            const char *wanted = is_french ? cases[i].french : cases[i].english;
            char text[128];
            strcpy(text, cases[i].text);
            typeset_numbers(text, sizeof text);
            assert_string_equal(text, wanted ? wanted : cases[i].text);
            typeset_numbers(text, sizeof text); // What is set stays as it is.
            assert_string_equal(text, wanted ? wanted : cases[i].text);
        }
    }
    char full[] = "(0.5) -1"; // Two bytes more are wanted.
    typeset_numbers(full, sizeof full);
    assert_string_equal(full, "(0,5) -1");
    char longer[2 * TYPESET_TEXT_SIZE], before[sizeof longer];
    memset(longer, 'x', sizeof longer);
    strcpy(longer + sizeof longer - 4, " -1");
    strcpy(before, longer);
    typeset_numbers(longer, sizeof longer);
    assert_string_equal(longer, before);
}

/** Runs the tests. @return Number of failed tests. */
int main(int argc, char **argv) {
    static const WorkerTask tasks[] = {{"translate", translate_task}, {0}};
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_workers),
                                       cmocka_unit_test(test_numbers),
                                       cmocka_unit_test(test_typeset)};
    if (worker_is_requested(argc, argv)) {
        worker_main(argv, tasks);
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
