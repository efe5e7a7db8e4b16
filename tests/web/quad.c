/**
 * @file
 * @brief Judges the page's quad numbers: see quad_pairs.h.
 */
#include "quad_pairs.h"

#include <stdio.h>

/** @return The number of wrong pairs of 300 000, at most 1. */
int main(void) {
    int wrong = count_wrong_pairs(300000);
    printf("%d of 300000 pairs of quad numbers are multiplied or divided wrongly\n", wrong);
    return wrong > 0;
}
