/**
 * @file
 * @brief The checks of all engines, for a test whose checks the Makefile compiles once per engine:
 *        the table `all_checks`.
 *
 * Before the test includes this, it defines ENGINE_CHECKS, the type of an engine's checks, and
 * ENGINE_CHECKS_OF(name), the name of those of an engine. The Makefile defines ENGINE_LIST(X) as
 * X(name) for each.
 */
#ifndef DIOPTRE_TESTS_ENGINE_CHECKS_H
#define DIOPTRE_TESTS_ENGINE_CHECKS_H

#include "dioptre/engine.h"

/** Declares the checks of an engine. */
#define DECLARE(name) extern const ENGINE_CHECKS ENGINE_CHECKS_OF(name);
ENGINE_LIST(DECLARE)

/** An engine and its checks. */
typedef struct EngineChecks {
    const char *engine;          /**< Its name. */
    const ENGINE_CHECKS *checks; /**< Its checks. */
} EngineChecks;

/** The checks of an engine, and a comma. */
#define ROW(name) {#name, &ENGINE_CHECKS_OF(name)},
static const EngineChecks all_checks[] = {ENGINE_LIST(ROW)};

#endif
