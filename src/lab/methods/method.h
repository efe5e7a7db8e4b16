/**
 * @file
 * @brief A method: one formula for a question that every ray tracer has to answer.
 *
 * The C files of this folder are written over `real` (trace/math/real.h), as the tracer is, and are
 * compiled once per number type. One file holds one or two families: the methods that answer the
 * same question, side by side, and a table of them at the end. A new method is a function and a
 * row of that table.
 */
#ifndef DIOPTRE_LAB_METHODS_METHOD_H
#define DIOPTRE_LAB_METHODS_METHOD_H

#include "dioptre/engine.h"

/** A method. */
typedef struct Method {
    const char *name;  /**< As in tables, such as `textbook`. */
    const char *label; /**< As in charts, where room is short. */
    /**
     * Computes an answer.
     * @param input        The family's input struct, in the number type.
     * @param[out] output  The family's output struct, in the number type.
     */
    void (*run)(const void *input, void *output);
} Method;

/** Methods that answer the same question. */
typedef struct MethodFamily {
    const char *name;      /**< Such as `sphere`. */
    int input_count;       /**< Numbers of an input. */
    int output_count;      /**< Numbers of an output. */
    const Method *methods; /**< The methods, ended by one without a name. */
} MethodFamily;

/** Most numbers of an input or an output. */
enum { METHOD_NUMBERS_MAXIMUM = 25 };

/** All methods in one number type. */
typedef struct NumberType {
    const char *name;                    /**< Such as `double`. */
    int mantissa_bits;                   /**< With the leading 1. */
    const MethodFamily *const *families; /**< The same in each type, ended by NULL. */

    /** @return The nearest number of the type. */
    Quadruple (*round)(Quadruple x);

    /**
     * Runs a method of a family.
     * @param inputs        The numbers of all inputs, which the type can represent.
     * @param[out] outputs  The numbers of all outputs, exactly.
     */
    void (*evaluate)(const MethodFamily *family, const Method *method, size_t count,
                     const Quadruple *inputs, Quadruple *outputs);

    /**
     * Converts inputs to the number type, for #evaluate_packed.
     * @param inputs  The numbers of all inputs, which the type can represent.
     * @return They, to be released with free; NULL without memory.
     */
    void *(*pack_inputs)(const MethodFamily *family, size_t count, const Quadruple *inputs);

    /** Runs a method on all inputs and discards the outputs, to be timed. */
    void (*evaluate_packed)(const MethodFamily *family, const Method *method, size_t count,
                            const void *packed);
} NumberType;

/** @return A family by its name, or NULL. */
const MethodFamily *number_type_family(const NumberType *type, const char *name);

#endif
