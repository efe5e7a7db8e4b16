/**
 * @file
 * @brief Shafts, in any number type and width: they miss no shape that one of their rays meets, and
 *        most of those that all rays miss.
 */
#include "shafts/shafts.h"

/** See engine_checks.h. */
#define ENGINE_CHECKS ShaftChecks
/** See engine_checks.h. */
#define ENGINE_CHECKS_OF(name) shafts_##name
#include "seeded_checks.h"

/** @param state Not used. */
static void test_support(void **state) {
    (void)state;
    run_check(SHAFT_SUPPORT);
}

/** @param state Not used. */
static void test_beam(void **state) {
    (void)state;
    run_check(SHAFT_BEAM);
}

/** @param state Not used. */
static void test_point(void **state) {
    (void)state;
    run_check(SHAFT_POINT);
}

/** @param state Not used. */
static void test_cone(void **state) {
    (void)state;
    run_check(SHAFT_CONE);
}

/** @param state Not used. */
static void test_plane(void **state) {
    (void)state;
    run_check(SHAFT_PLANE);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_support), cmocka_unit_test(test_beam),
                                       cmocka_unit_test(test_point), cmocka_unit_test(test_cone),
                                       cmocka_unit_test(test_plane)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
