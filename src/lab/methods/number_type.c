/**
 * @file
 * @brief The number type that this folder is compiled for, with all families of methods in it.
 */
#include "lab/methods/family.h"

#include <stdlib.h>

/** Is a #NumberType.round. */
static Quadruple number_round(Quadruple x) {
    return (Quadruple)(scalar)x;
}

/** Is a #NumberType.evaluate. */
static void number_evaluate(const MethodFamily *family, const Method *method, size_t count,
                            const Quadruple *inputs, Quadruple *outputs) {
    real input[METHOD_NUMBERS_MAXIMUM], output[METHOD_NUMBERS_MAXIMUM];
    for (size_t n = 0; n < count; n++) {
        for (int i = 0; i < family->input_count; i++) {
            input[i] = (scalar)*inputs++;
        }
        method->run(input, output);
        for (int i = 0; i < family->output_count; i++) {
            *outputs++ = (Quadruple)output[i];
        }
    }
}

/** Is a #NumberType.pack_inputs. */
static void *number_pack(const MethodFamily *family, size_t count, const Quadruple *inputs) {
    size_t numbers = count * (size_t)family->input_count;
    real *packed = calloc(numbers, sizeof *packed);
    for (size_t i = 0; packed && i < numbers; i++) {
        packed[i] = (scalar)inputs[i];
    }
    return packed;
}

/** Is a #NumberType.evaluate_packed. */
static void number_evaluate_packed(const MethodFamily *family, const Method *method, size_t count,
                                   const void *packed) {
    real output[METHOD_NUMBERS_MAXIMUM];
    const real *input = packed;
    for (size_t n = 0; n < count; n++, input += family->input_count) {
        method->run(input, output);
    }
}

/** All families. */
static const MethodFamily *const method_families[] = {&sphere_family,
                                                      &cylinder_wall_family,
                                                      &cylinder_solid_family,
                                                      &plane_family,
                                                      &triangle_family,
                                                      &intersector_disk_family,
                                                      &intersector_cone_family,
                                                      &intersector_ellipsoid_family,
                                                      &intersector_torus_family,
                                                      &intersector_capsule_family,
                                                      &box_slabs_family,
                                                      &box_cube_family,
                                                      &ray_offset_family,
                                                      &shells_family,
                                                      &sphere_uv_family,
                                                      &fresnel_family,
                                                      &gradient_family,
                                                      &sphere_tracing_family,
                                                      &domain_repetition_family,
                                                      &bounces_family,
                                                      NULL};

/** The only symbol of this folder that is visible outside, under a name per number type. */
extern const NumberType NUMBER_TYPE;

const NumberType NUMBER_TYPE = {.name = NUMBER_TYPE_NAME,
                                .mantissa_bits = MANTISSA_BITS,
                                .families = method_families,
                                .round = number_round,
                                .evaluate = number_evaluate,
                                .pack_inputs = number_pack,
                                .evaluate_packed = number_evaluate_packed};
