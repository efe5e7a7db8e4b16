/**
 * @file
 * @brief Boxes and one ray, in any number type and width: it visits the children of a node from
 *        near to far, so that the first hit rules out what lies behind, and no pack of boxes loses
 *        one that it meets.
 */
#include "box_tests/box_tests.h"

#include "dioptre/engine.h"
#include "testing.h"

/** The checks of an engine. The makefile defines ENGINE_LIST(X) as X(name) for each. */
#define DECLARE(name) extern const BoxChecks box_tests_##name;
ENGINE_LIST(DECLARE)

/** An engine and its checks. */
typedef struct EngineChecks {
    const char *engine;      /**< Its name. */
    const BoxChecks *checks; /**< Its checks. */
} EngineChecks;

/** The checks of an engine, and a comma. */
#define ROW(name) {#name, &box_tests_##name},
static const EngineChecks all_checks[] = {ENGINE_LIST(ROW)};

/** Octants of directions. */
enum { OCTANT_COUNT = 8 };

/** The order of a node has each child once, from far to near. */
static void test_nodes(void **state) {
    (void)state;
    Error error = {0};
    for (size_t i = 0; i < COUNT(all_checks); i++) {
        for (uint64_t seed = 1; engine_find(all_checks[i].engine, &error) && seed <= 3; seed++) {
            const char *fault = all_checks[i].checks->nodes(seed);
            if (fault) {
                fail_msg("%s: %s", all_checks[i].engine, fault);
            }
        }
    }
}

/** A ray along a row of boxes visits the leaf of the first box only. */
static void test_row(void **state) {
    (void)state;
    Error error = {0};
    for (size_t i = 0; i < COUNT(all_checks); i++) {
        for (unsigned octant = 0;
             engine_find(all_checks[i].engine, &error) && octant < OCTANT_COUNT; octant++) {
            assert_int_equal(all_checks[i].checks->leaves(octant), 1);
        }
    }
}

/** A pack has each box that the ray meets by the test of one box, and no lower bound beyond its. */
static void test_packs(void **state) {
    (void)state;
    Error error = {0};
    for (size_t i = 0; i < COUNT(all_checks); i++) {
        for (uint64_t seed = 1; engine_find(all_checks[i].engine, &error) && seed <= 3; seed++) {
            const char *fault = all_checks[i].checks->packs(seed);
            if (fault) {
                fail_msg("%s: %s", all_checks[i].engine, fault);
            }
        }
    }
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_nodes), cmocka_unit_test(test_row),
                                       cmocka_unit_test(test_packs)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
