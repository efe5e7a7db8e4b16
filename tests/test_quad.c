/**
 * @file
 * @brief Tests of the machine's quad numbers: product and quotient are correctly rounded.
 */
#include "quad_pairs.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

/** Pairs in which carries run far are multiplied and divided to the last bit. */
static void test_pairs(void **state) {
    (void)state;
    assert_int_equal(count_wrong_pairs(300000), 0);
}

/** 1 / x with x just under 1 is just over 1; LLVM's library says 2. */
static void test_reciprocal(void **state) {
    (void)state;
    volatile Quadruple just_under_1 = 1 - (Quadruple)0x1p-113L;
    assert_true(1 / just_under_1 > 1 && 1 / just_under_1 < 1.5L);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_pairs),
                                       cmocka_unit_test(test_reciprocal)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
