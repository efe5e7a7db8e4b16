/**
 * @file
 * @brief Runs checks of all engines that take a seed and say what is wrong. See engine_checks.h,
 *        which a test includes by this.
 */
#ifndef DIOPTRE_TESTS_SEEDED_CHECKS_H
#define DIOPTRE_TESTS_SEEDED_CHECKS_H

#include "engine_checks.h"
#include "testing.h"

/** Runs a check with some seeds in all engines that have what it checks. @param check Its index. */
static void run_check(int check) {
    Error error = {0};
    for (size_t i = 0; i < COUNT(all_checks); i++) {
        const ENGINE_CHECKS *checks = all_checks[i].checks;
        bool is_there = checks->run[check] && engine_find(all_checks[i].engine, &error);
        for (uint64_t seed = 1; is_there && seed <= 3; seed++) {
            const char *fault = checks->run[check](seed);
            if (fault) {
                fail_msg("%s: %s", all_checks[i].engine, fault);
            }
        }
    }
}

#endif
