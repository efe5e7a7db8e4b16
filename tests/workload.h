/**
 * @file
 * @brief Reduction of the number of rays under a sanitizer.
 */
#ifndef TESTS_WORKLOAD_H
#define TESTS_WORKLOAD_H

#if defined(__SANITIZE_ADDRESS__)
/**
 * Sanitizers make code about ten times slower. They detect invalid accesses, which need no rare
 * rays.
 */
enum { WORKLOAD_DIVISOR = 10 };
#else
/** Divisor of the number of rays. */
enum { WORKLOAD_DIVISOR = 1 };
#endif

#endif
