/**
 * @file
 * @brief The median of numbers.
 */
#include "base/median.h"

#include <stdlib.h>

/** @return Order of two numbers, for qsort. */
static int compare_doubles(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double median_sort(double *numbers, size_t count) {
    qsort(numbers, count, sizeof *numbers, compare_doubles);
    return (numbers[(count - 1) / 2] + numbers[count / 2]) / 2;
}
