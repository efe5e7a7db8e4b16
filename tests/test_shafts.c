/**
 * @file
 * @brief Shafts, in any number type and width: they miss no shape that one of their rays meets, and
 *        most of those that all rays miss.
 */
#include "shafts/shafts.h"

#include "testing.h"

/** See engine_checks.h. */
#define ENGINE_CHECKS ShaftChecks
/** See engine_checks.h. */
#define ENGINE_CHECKS_OF(name) shafts_##name
#include "engine_checks.h"

/** Runs a check in all engines that have what it checks. */
static void run_check(ShaftCheck check) {
    Error error = {0};
    for (size_t i = 0; i < COUNT(all_checks); i++) {
        const ShaftChecks *checks = all_checks[i].checks;
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
