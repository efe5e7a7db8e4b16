/**
 * @file
 * @brief Boxes and one ray, in any number type and width: it visits the children of a node from
 *        near to far, so that the first hit rules out what lies behind, and no test of many boxes
 *        or many rays loses a box that a ray meets.
 */
#include "box_tests/box_tests.h"

#include "testing.h"

/** See engine_checks.h. */
#define ENGINE_CHECKS BoxChecks
/** See engine_checks.h. */
#define ENGINE_CHECKS_OF(name) box_tests_##name
#include "engine_checks.h"

/** Runs a check in all engines that have what it checks. */
static void run_check(BoxCheck check) {
    Error error = {0};
    for (size_t i = 0; i < COUNT(all_checks); i++) {
        const BoxChecks *checks = all_checks[i].checks;
        bool is_there = checks->run[check] && engine_find(all_checks[i].engine, &error);
        for (uint64_t seed = 1; is_there && seed <= 3; seed++) {
            const char *fault = checks->run[check](seed);
            if (fault) {
                fail_msg("%s: %s", all_checks[i].engine, fault);
            }
        }
    }
}

/** @param state Not used. */
static void test_orders(void **state) {
    (void)state;
    run_check(BOX_ORDERS);
}

/** @param state Not used. */
static void test_row(void **state) {
    (void)state;
    run_check(BOX_ROW);
}

/** @param state Not used. */
static void test_packs(void **state) {
    (void)state;
    run_check(BOX_PACKS);
}

/** @param state Not used. */
static void test_quads(void **state) {
    (void)state;
    run_check(BOX_QUADS);
}

/** @param state Not used. */
static void test_intervals(void **state) {
    (void)state;
    run_check(BOX_INTERVALS);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_orders), cmocka_unit_test(test_row),
                                       cmocka_unit_test(test_packs), cmocka_unit_test(test_quads),
                                       cmocka_unit_test(test_intervals)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
