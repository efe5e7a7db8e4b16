/**
 * @file
 * @brief Octrees of tapes alone: fewer steps, and the same bits at any point, in any number type
 * and width.
 */
#include "tape_octree/tape_octree.h"

#include "testing.h"

#include <string.h>

/** See engine_checks.h. */
#define ENGINE_CHECKS OctreeChecks
/** See engine_checks.h. */
#define ENGINE_CHECKS_OF(name) tape_octree_##name
#include "engine_checks.h"

/** Random tapes per engine. */
enum { TAPES = 60 };

/** @return Whether an engine has octrees: quad, the reference, evaluates whole tapes. */
static bool has_octrees(const char *engine) {
    return strncmp(engine, "f128", 4) != 0;
}

/** Tapes of any operations have the same bits with an octree, and some are shorter there. */
static void test_operations(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT(all_checks); i++) {
        const char *name = all_checks[i].engine;
        uint64_t steps = 0, whole_steps = 0;
        unsigned octrees = 0;
        Error error = {0};
        if (!engine_find(name, &error)) {
            continue;
        }
        for (uint64_t seed = 1; seed <= TAPES; seed++) {
            const OctreeFinding finding = all_checks[i].checks->run(seed, 0);
            if (finding.fault) {
                fail_msg("%s, tape %d: %s, point %d", name, (int)seed, finding.fault,
                         finding.point);
            }
            octrees += finding.cells > 1;
            steps += finding.steps;
            whole_steps += finding.whole_steps;
        }
        assert_int_equal(octrees > TAPES / 4, has_octrees(name));
        assert_int_equal(steps < whole_steps, has_octrees(name));
    }
}

/** Of a union of many balls few are near any point: a ray alone needs less than a third of the
 *  steps, and a vector less than all. */
static void test_balls(void **state) {
    (void)state;
    Error error = {0};
    for (size_t i = 0; i < COUNT(all_checks); i++) {
        const Engine *engine = engine_find(all_checks[i].engine, &error);
        for (uint64_t seed = 1; engine && has_octrees(engine->name) && seed <= 3; seed++) {
            const OctreeFinding finding = all_checks[i].checks->run(seed, 70);
            assert_null(finding.fault);
            assert_true(finding.cells > 1000);
            const uint64_t part = engine->lanes == 1 ? 3 : 1;
            assert_true(part * finding.steps < finding.whole_steps);
        }
    }
}

/** Where cells would be no use, or would have no size, there are none. */
static void test_refusals(void **state) {
    (void)state;
    Error error = {0};
    for (size_t i = 0; i < COUNT(all_checks); i++) {
        for (int k = 0; engine_find(all_checks[i].engine, &error) && k < OCTREE_REFUSAL_COUNT;
             k++) {
            assert_int_equal(all_checks[i].checks->cells((OctreeRefusal)k), 0);
        }
    }
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_operations),
                                       cmocka_unit_test(test_balls),
                                       cmocka_unit_test(test_refusals)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
