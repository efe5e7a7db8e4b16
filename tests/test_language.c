/**
 * @file
 * @brief Tests of the languages that need threads: a child can look words up, whatever other
 *        threads were doing when it was made. tests/language.sh tests the words.
 */
#include "testing.h"

#include "assets/process/sandbox_process.h"
#include "base/language.h"

#include <libintl.h>
#include <locale.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>

/** How many children are made. */
enum { CHILDREN = 200 };

/** Looks words up until it is told to end. @return NULL */
static void *translate_until_stopped(void *context) {
    atomic_bool *is_over = context;
    while (!atomic_load(is_over)) {
        if (!gettext("no memory for a lesson") || !ngettext(", %d sample", ", %d samples", 2)) {
            break;
        }
    }
    return NULL;
}

/** Is the child: does what a scene's child does with words. */
static void translate_in_child(void *context) {
    (void)context;
    setlocale(LC_CTYPE, "C");
    language_toggle();
    _Exit(gettext("no memory for a lesson") ? EXIT_SUCCESS : EXIT_FAILURE);
}

/** No child waits for a thread that it does not have. */
static void test_fork(void **state) {
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
    int late = 0, detail;
    for (int i = 0; i < CHILDREN && late == 0; i++) {
        late += sandbox_process_run(translate_in_child, NULL, 5, &detail) != SANDBOX_PROCESS_EXITED;
    }
    atomic_store(&is_over, true);
    for (int i = 0; i < 2; i++) {
        pthread_join(threads[i], NULL);
    }
    assert_int_equal(late, 0);
}

/** Runs the tests. @return How many failed. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_fork)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
