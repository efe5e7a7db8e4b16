/**
 * @file
 * @brief How much less a test asks where everything is slow.
 */
#ifndef DIOPTRE_TESTS_SLOWNESS_H
#define DIOPTRE_TESTS_SLOWNESS_H

#if defined(__SANITIZE_ADDRESS__)
/** A sanitizer makes everything about ten times as slow: so many fewer rays. */
enum { SLOWNESS = 10 };
#else
/** See above. */
enum { SLOWNESS = 1 };
#endif

#endif
