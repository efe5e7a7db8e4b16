/**
 * @file
 * @brief Tests of languages with threads and processes. tests/language.sh tests the translations.
 */
#include "testing.h"

#include "assets/process/worker_main.h"
#include "assets/process/worker_process.h"
#include "base/language.h"

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

/** Runs the tests. @return Number of failed tests. */
int main(int argc, char **argv) {
    static const WorkerTask tasks[] = {{"translate", translate_task}, {0}};
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_workers),
                                       cmocka_unit_test(test_numbers)};
    if (worker_is_requested(argc, argv)) {
        worker_main(argv, tasks);
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
