/**
 * @file
 * @brief The compaction of wavefronts alone: sparse vectors of rays become full packets, and no ray
 *        is lost, doubled or mixed with another, in any number type and width.
 */
#include "compaction/compaction.h"

#include "testing.h"

/** See engine_checks.h. */
#define ENGINE_CHECKS CompactionChecks
/** See engine_checks.h. */
#define ENGINE_CHECKS_OF(name) compaction_##name
#include "engine_checks.h"

/** Runs a check at all types and widths that the processor has. */
static void run_check(CompactionCheck check) {
    for (size_t i = 0; i < COUNT(all_checks); i++) {
        const char *name = all_checks[i].engine;
        Error error = {0};
        for (uint64_t seed = 1; engine_find(name, &error) && seed <= 4; seed++) {
            CompactionFault fault = all_checks[i].checks->run[check](seed);
            if (fault.what) {
                fail_msg("%s: %s, place %u, lanes %x", name, fault.what, fault.place, fault.bits);
            }
        }
    }
}

/** @param state Not used. */
static void test_patterns(void **state) {
    (void)state;
    run_check(COMPACTION_PATTERNS);
}

/** @param state Not used. */
static void test_streams(void **state) {
    (void)state;
    run_check(COMPACTION_STREAMS);
}

/** @param state Not used. */
static void test_packets(void **state) {
    (void)state;
    run_check(COMPACTION_PACKETS);
}

/** @param state Not used. */
static void test_joins(void **state) {
    (void)state;
    run_check(COMPACTION_JOINS);
}

/** @param state Not used. */
static void test_merges(void **state) {
    (void)state;
    run_check(COMPACTION_MERGES);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_patterns),
                                       cmocka_unit_test(test_streams),
                                       cmocka_unit_test(test_packets), cmocka_unit_test(test_joins),
                                       cmocka_unit_test(test_merges)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
