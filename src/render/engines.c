/**
 * @file
 * @brief The engines that this program was built with, and which of them this machine can run.
 */
#include "dioptre/engine.h"

#include <stdio.h>
#include <string.h>

/** Declares an engine. The makefile lists them: ENGINE_LIST(X) is X(name) for each. */
#define DECLARE(name) extern const Engine engine_##name;
ENGINE_LIST(DECLARE)

/** The address of an engine, and a comma. */
#define ADDRESS(name) &engine_##name,

const Engine *const *engine_list(void) {
    static const Engine *const engines[] = {ENGINE_LIST(ADDRESS) NULL};
    return engines;
}

/** @return What an engine needs of the processor and it does not have; NULL where it can run. */
static const char *engine_missing_feature(const Engine *engine) {
#if defined(__x86_64__)
    if (engine->needs == ENGINE_NEEDS_AVX2 && !__builtin_cpu_supports("avx2")) {
        return "AVX2";
    }
    if (engine->needs == ENGINE_NEEDS_AVX512 &&
        !(__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))) {
        return "AVX-512";
    }
#else
    (void)engine;
#endif
    return NULL;
}

bool engine_is_supported(const Engine *engine) {
    return engine_missing_feature(engine) == NULL;
}

/** @return The first engine that this machine can run; there is always one. Sixteen lanes are for
 *          who asks for them: some processors slow down their clock to run them. */
static const Engine *engine_preferred(void) {
    const Engine *const *engine = engine_list();
    while (!engine_is_supported(*engine)) {
        engine++;
    }
    return *engine;
}

/** Says which engines there are. */
static void error_unknown_engine(const char *name, Error *error) {
    char names[128] = "";
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        strncat(names, " ", sizeof names - strlen(names) - 1);
        strncat(names, (*engine)->name, sizeof names - strlen(names) - 1);
    }
    error_set(error, STATUS_USAGE, "no engine '%s': there are auto%s", name, names);
}

const Engine *engine_find(const char *name, Error *error) {
    if (strcmp(name, "auto") == 0) {
        return engine_preferred();
    }
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if (strcmp(name, (*engine)->name) == 0) {
            if (engine_is_supported(*engine)) {
                return *engine;
            }
            error_set(error, STATUS_USAGE, "engine %s needs a processor with %s", name,
                      engine_missing_feature(*engine));
            return NULL;
        }
    }
    error_unknown_engine(name, error);
    return NULL;
}
