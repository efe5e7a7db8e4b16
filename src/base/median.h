/**
 * @file
 * @brief The median of numbers.
 */
#ifndef DIOPTRE_BASE_MEDIAN_H
#define DIOPTRE_BASE_MEDIAN_H

#include <stddef.h>

/** Sorts numbers, the smallest first. @param count Their number, at least 1. @return Their median.
 */
double median_sort(double *numbers, size_t count);

#endif
