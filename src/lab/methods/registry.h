/**
 * @file
 * @brief The methods there are.
 */
#ifndef DIOPTRE_LAB_METHODS_REGISTRY_H
#define DIOPTRE_LAB_METHODS_REGISTRY_H

#include "lab/methods/method.h"

extern const Method *const method_list[]; /**< All of the below, ended by NULL. */

extern const Method sphere_expanded;            /**< Every product of the quadratic by itself. */
extern const Method sphere_textbook;            /**< The quadratic, relative to the centre. */
extern const Method sphere_projection;          /**< By the nearest point of the line. */
extern const Method sphere_projection_relative; /**< The same, relative to the origin. */
extern const Method sphere_haines;              /**< With a discriminant that does not cancel. */
extern const Method sphere_mixed;               /**< The same in the next better precision. */
extern const Method sphere_compensated;         /**< The same with errors carried along. */

#endif
