/**
 * @file
 * @brief A method: one way of answering a question that every ray tracer asks, in every number
 *        type.
 *
 * The files of this folder are written over `real` (trace/math/real.h) as the tracer is, and
 * compiled once a number type. A method is one file with one `const Method`, and two lines in
 * registry.h and registry.c. What it is asked and what it answers are structs of nothing but
 * `real`s, which all methods of a family share (sphere.h, triangle.h, ...).
 */
#ifndef DIOPTRE_LAB_METHODS_METHOD_H
#define DIOPTRE_LAB_METHODS_METHOD_H

#include "dioptre/engine.h"

/** A method. */
typedef struct Method {
    const char *group; /**< Those that are asked the same, such as `sphere`. */
    const char *name;  /**< Such as `textbook`. */
    const char *label; /**< The same in a chart, as short as can be. */
    int input_count;   /**< Numbers of a question. */
    int output_count;  /**< Numbers of an answer. */
    /**
     * Answers a question.
     * @param question     The family's struct of questions, in the number type.
     * @param[out] answer  The family's struct of answers, in the number type.
     */
    void (*run)(const void *question, void *answer);
} Method;

/** How many numbers a struct of nothing but `real`s has. */
#define NUMBERS_IN(type) ((int)(sizeof(type) / sizeof(real)))

/** Most numbers of a question or an answer. */
enum { METHOD_NUMBERS_MAXIMUM = 24 };

/** All methods in one number type. */
typedef struct NumberType {
    const char *name;             /**< Such as `double`. */
    int mantissa_bits;            /**< The leading 1 included. */
    const Method *const *methods; /**< The same in each type, ended by NULL. */

    /** @return The nearest number of the type. */
    Quadruple (*round)(Quadruple x);

    /**
     * Asks a method.
     * @param questions  The numbers of each, which the type can hold.
     * @param[out] answers  The numbers of each answer, exactly.
     */
    void (*evaluate)(const Method *method, size_t count, const Quadruple *questions,
                     Quadruple *answers);

    /**
     * Makes questions what methods want, for #evaluate_packed.
     * @param questions  The numbers of each, which the type can hold.
     * @return They, to be given back with free; NULL without memory.
     */
    void *(*pack_inputs)(const Method *method, size_t count, const Quadruple *questions);

    /** Asks a method one question after the other and forgets the answers: for a clock. */
    void (*evaluate_packed)(const Method *method, size_t count, const void *packed);
} NumberType;

#endif
