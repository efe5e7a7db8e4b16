/**
 * @file
 * @brief The methods there are.
 */
#include "lab/methods/registry.h"

const Method *const method_list[] = {
    &sphere_expanded, &sphere_textbook, &sphere_projection,  &sphere_projection_relative,
    &sphere_haines,   &sphere_mixed,    &sphere_compensated, NULL};
