/**
 * @file
 * @brief What is checked of shafts, once for each engine's number type and width.
 */
#ifndef DIOPTRE_TESTS_SHAFTS_H
#define DIOPTRE_TESTS_SHAFTS_H

#include <stdint.h>

/** What is checked. */
typedef enum ShaftCheck {
    SHAFT_SUPPORT, /**< A shape, transformed or not, reaches as far as the farthest of many points
                      of its surface, and hardly farther. */
    SHAFT_BEAM,  /**< A beam does not miss a sphere that one of its rays meets, hardly; but one that
                    all of them miss by a little more, mostly. */
    SHAFT_POINT, /**< The same for rays to a point, and spheres beside a plane along an axis. */
    SHAFT_CONE,  /**< The same for spheres beside the cone around such rays. */
    SHAFT_PLANE, /**< No ray to a point meets a plane that has all of them on one side; many planes
                    have. */
    SHAFT_CHECK_COUNT
} ShaftCheck;

/** The checks of a number type and width. */
typedef struct ShaftChecks {
    /** A check. @return What is wrong; NULL: nothing is. NULL: the engine has no such thing. */
    const char *(*run[SHAFT_CHECK_COUNT])(uint64_t seed);
} ShaftChecks;

#endif
