/**
 * @file
 * @brief Octrees of tapes alone: fewer steps, and the same bits at any point, in any number type
 * and width.
 */
#include "tape_octree/tape_octree.h"

#include "dioptre/engine.h"
#include "testing.h"

#include <string.h>

/** The checks of an engine. The makefile defines ENGINE_LIST(X) as X(name) for each. */
#define DECLARE(name) extern const OctreeChecks tape_octree_##name;
ENGINE_LIST(DECLARE)

/** An engine and its checks. */
typedef struct EngineChecks {
    const char *engine;         /**< Its name. */
    const OctreeChecks *checks; /**< Its checks. */
} EngineChecks;

/** The checks of an engine, and a comma. */
#define ROW(name) {#name, &tape_octree_##name},
static const EngineChecks all_checks[] = {ENGINE_LIST(ROW)};

/** Random tapes per engine. */
enum { TAPES = 60 };

/** Tapes of any operations have the same bits with an octree, and some are shorter there. */
static void test_operations(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT(all_checks); i++) {
        const char *name = all_checks[i].engine;
        uint64_t steps = 0, whole_steps = 0;
        unsigned octrees = 0;
        Error error = {0};
        for (uint64_t seed = 1; engine_find(name, &error) && seed <= TAPES; seed++) {
            const OctreeFinding finding = all_checks[i].checks->run(seed, 0);
            if (finding.fault) {
                fail_msg("%s, tape %d: %s, point %d", name, (int)seed, finding.fault,
                         finding.point);
            }
            octrees += finding.cells > 1;
            steps += finding.steps;
            whole_steps += finding.whole_steps;
        }
        // Quad is the reference: it evaluates whole tapes.
        const bool has_octrees = strncmp(name, "f128", 4) != 0;
        assert_true(whole_steps == 0 || (octrees > TAPES / 4) == has_octrees);
        assert_true(whole_steps == 0 || has_octrees || steps == whole_steps);
    }
}

/** Of a union of many balls few are near any point: a single ray needs a quarter of the steps. */
static void test_balls(void **state) {
    (void)state;
    Error error = {0};
    for (size_t i = 0; i < COUNT(all_checks); i++) {
        const Engine *engine = engine_find(all_checks[i].engine, &error);
        for (uint64_t seed = 1; engine && seed <= 3; seed++) {
            const OctreeFinding finding = all_checks[i].checks->run(seed, 70);
            assert_null(finding.fault);
            if (engine->lanes == 1 && finding.cells > 0) {
                assert_true(finding.cells > 1000);
                assert_true(4 * finding.steps < finding.whole_steps);
            }
        }
    }
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_operations),
                                       cmocka_unit_test(test_balls)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
