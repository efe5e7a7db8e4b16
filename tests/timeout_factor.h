/**
 * @file
 * @brief How much less a test asks where everything is slow.
 */
#ifndef TESTS_TIMEOUT_FACTOR_H
#define TESTS_TIMEOUT_FACTOR_H

#if defined(__SANITIZE_ADDRESS__)
/** A sanitizer makes everything about ten times as slow: so many fewer rays. */
enum { TIMEOUT_FACTOR = 10 };
#else
/** See above. */
enum { TIMEOUT_FACTOR = 1 };
#endif

#endif
