/**
 * @file
 * @brief Distance fields in the engine's numbers: a tape of steps, each done for LANES points at
 *        once.
 */
#ifndef DIOPTRE_TRACE_FIELD_H
#define DIOPTRE_TRACE_FIELD_H

#include "dioptre/field.h"
#include "trace/vector.h"

typedef struct FieldMachine FieldMachine;

/** A step of a tape. */
typedef struct FieldCode {
    /** Does it. @param machine What it works on. @param code The step. */
    void (*run)(FieldMachine *machine, const struct FieldCode *code);
    int body;                      /**< How many of the next steps are its body. */
    scalar numbers[FIELD_NUMBERS]; /**< With what; see #FieldOperation. */
} FieldCode;

/** What a field says of LANES points. */
typedef struct FieldSample {
    real distance;   /**< The distance, or a bound; negative inside. */
    Vector gradient; /**< Which way it grows, and how fast; only if asked for. */
} FieldSample;

/** Makes a tape. @param[out] codes As many steps as the field has. @param field The field. */
void field_code(FieldCode *codes, const Field *field);

/**
 * @return The distances of points.
 * @param codes   The tape.
 * @param count   How many steps.
 * @param point   The points.
 * @param active  The lanes that count; of others anything may be said.
 */
real field_distance(const FieldCode *codes, int count, Vector point, mask active);

/**
 * @return The distances of points with their derivatives, which are carried along the tape.
 * @param codes   The tape.
 * @param count   How many steps.
 * @param point   The points.
 * @param active  The lanes that count; of others anything may be said.
 */
FieldSample field_sample(const FieldCode *codes, int count, Vector point, mask active);

#endif
