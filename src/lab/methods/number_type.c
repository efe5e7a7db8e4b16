/**
 * @file
 * @brief The number type that this folder is compiled for, as an object.
 */
#include "lab/methods/registry.h"
#include "trace/math/real.h"

#include <stdlib.h>

/** @return The nearest number of the type. See #NumberType.round. */
static Quadruple number_round(Quadruple x) {
    return (Quadruple)(scalar)x;
}

/** Asks a method. See #NumberType.evaluate. @param[out] outputs The numbers of each answer. */
static void number_evaluate(const Method *method, size_t count, const Quadruple *inputs,
                            Quadruple *outputs) {
    real input[METHOD_NUMBERS_MAXIMUM], output[METHOD_NUMBERS_MAXIMUM];
    for (size_t n = 0; n < count; n++) {
        for (int i = 0; i < method->input_count; i++) {
            input[i] = (scalar)*inputs++;
        }
        method->run(input, output);
        for (int i = 0; i < method->output_count; i++) {
            *outputs++ = (Quadruple)output[i];
        }
    }
}

/** @return Questions as methods want them. See #NumberType.pack_inputs. */
static void *number_pack(const Method *method, size_t count, const Quadruple *inputs) {
    size_t numbers = count * (size_t)method->input_count;
    real *packed = calloc(numbers, sizeof *packed);
    for (size_t i = 0; packed && i < numbers; i++) {
        packed[i] = (scalar)inputs[i];
    }
    return packed;
}

/** Asks a method and forgets the answers. See #NumberType.evaluate_packed. */
static void number_evaluate_packed(const Method *method, size_t count, const void *packed) {
    real output[METHOD_NUMBERS_MAXIMUM];
    const real *question = packed;
    for (size_t n = 0; n < count; n++, question += method->input_count) {
        method->run(question, output);
    }
}

/** The one thing of this folder that can be seen from outside. */
extern const NumberType NUMBER_TYPE;

const NumberType NUMBER_TYPE = {.name = NUMBER_TYPE_NAME,
                                .mantissa_bits = MANTISSA_BITS,
                                .methods = method_list,
                                .round = number_round,
                                .evaluate = number_evaluate,
                                .pack_inputs = number_pack,
                                .evaluate_packed = number_evaluate_packed};
