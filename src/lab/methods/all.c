/**
 * @file
 * @brief All methods of the laboratory as one file for the compiler: see src/trace/all.c.
 */
#include "lab/methods/bounces.c"
#include "lab/methods/box.c"
#include "lab/methods/cylinder.c"
#include "lab/methods/domain_repetition.c"
#include "lab/methods/fresnel.c"
#include "lab/methods/gradient.c"
#include "lab/methods/intersectors.c"
#include "lab/methods/number_type.c"
#include "lab/methods/plane.c"
#include "lab/methods/ray_offset.c"
#include "lab/methods/shells.c"
#include "lab/methods/sphere.c"
#include "lab/methods/sphere_tracing.c"
#include "lab/methods/sphere_uv.c"
#include "lab/methods/triangle.c"
