/**
 * @file
 * @brief How much fewer rays a test traces under a sanitizer.
 */
#ifndef TESTS_WORKLOAD_H
#define TESTS_WORKLOAD_H

#if defined(__SANITIZE_ADDRESS__)
/** Sanitizers make code about ten times as slow, and look for wrong accesses, not for rare rays. */
enum { WORKLOAD_DIVISOR = 10 };
#else
/** The number of rays is divided by this. */
enum { WORKLOAD_DIVISOR = 1 };
#endif

#endif
