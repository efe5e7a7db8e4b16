/**
 * @file
 * @brief The number type that this folder is compiled for, as an object.
 */
#include "lab/methods/registry.h"
#include "trace/real.h"

#include <stdlib.h>

/** @return The nearest number of the type. See #NumberType.round. @param x Any number. */
static Quadruple number_round(Quadruple x) {
    return (Quadruple)(scalar)x;
}

/**
 * Asks a method. See #NumberType.ask.
 * @param method        The method.
 * @param count         How many questions.
 * @param questions     The numbers of each.
 * @param[out] answers  The numbers of each answer.
 */
static void number_ask(const Method *method, size_t count, const Quadruple *questions,
                       Quadruple *answers) {
    real question[METHOD_NUMBERS_MAXIMUM], answer[METHOD_NUMBERS_MAXIMUM];
    for (size_t n = 0; n < count; n++) {
        for (int i = 0; i < method->inputs; i++) {
            question[i] = (scalar)*questions++;
        }
        method->run(question, answer);
        for (int i = 0; i < method->outputs; i++) {
            *answers++ = (Quadruple)answer[i];
        }
    }
}

/** @return Questions as methods want them. See #NumberType.pack. @param method The method.
 *  @param count How many. @param questions The numbers of each. */
static void *number_pack(const Method *method, size_t count, const Quadruple *questions) {
    size_t numbers = count * (size_t)method->inputs;
    real *packed = calloc(numbers, sizeof *packed);
    for (size_t i = 0; packed && i < numbers; i++) {
        packed[i] = (scalar)questions[i];
    }
    return packed;
}

/** Asks a method and forgets the answers. See #NumberType.repeat. @param method The method.
 *  @param count How many questions. @param packed They. */
static void number_repeat(const Method *method, size_t count, const void *packed) {
    real answer[METHOD_NUMBERS_MAXIMUM];
    const real *question = packed;
    for (size_t n = 0; n < count; n++, question += method->inputs) {
        method->run(question, answer);
    }
}

/** The one thing of this folder that can be seen from outside. */
extern const NumberType NUMBER_TYPE;

const NumberType NUMBER_TYPE = {.name = NUMBER_TYPE_NAME,
                                .mantissa_bits = MANTISSA_BITS,
                                .methods = method_list,
                                .round = number_round,
                                .ask = number_ask,
                                .pack = number_pack,
                                .repeat = number_repeat};
