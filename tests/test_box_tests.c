/**
 * @file
 * @brief Boxes and one ray, in any number type and width: it visits the children of a node from
 *        near to far, so that the first hit rules out what lies behind, and no test of many boxes
 *        or many rays loses a box that a ray meets.
 */
#include "box_tests/box_tests.h"

/** See engine_checks.h. */
#define ENGINE_CHECKS BoxChecks
/** See engine_checks.h. */
#define ENGINE_CHECKS_OF(name) box_tests_##name
#include "seeded_checks.h"

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
