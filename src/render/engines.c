/**
 * @file
 * @brief The engines that this program was built with, and which of them this machine can run.
 */
#include "dioptre/engine.h"

#include "base/language.h"
#include "render/processor.h"

#include <stdio.h>
#include <string.h>

/** Declares an engine. The makefile defines ENGINE_LIST(X) as X(name) for each. */
#define DECLARE(name) extern const Engine engine_##name;
ENGINE_LIST(DECLARE)

/** The address of an engine, and a comma. */
#define ADDRESS(name) &engine_##name,

const Engine *const *engine_list(void) {
    static const Engine *const engines[] = {ENGINE_LIST(ADDRESS) NULL};
    return engines;
}

/** @return The instruction set that an engine needs and the processor lacks; NULL: none. */
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

/** @return The engine that AVX-512 runs, where the processor has it; NULL: there is none. */
static const Engine *engine_avx512(void) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if ((*engine)->needs == ENGINE_NEEDS_AVX512 && engine_is_supported(*engine)) {
            return *engine;
        }
    }
    return NULL;
}

/** @return The fastest engine of this processor, as far as that was measured. */
static const Engine *engine_fastest(void) {
    const Engine *widest = engine_avx512();
    const Processor processor = processor_current();
    if (widest && processor_prefers_avx512(&processor)) {
        return widest;
    }
    // The list is in order of preference: the engine of AVX-512 comes behind that of AVX2.
    const Engine *const *engine = engine_list();
    while (*engine && !engine_is_supported(*engine)) {
        engine++;
    }
    return *engine;
}

const char *engine_fastest_reason(void) {
    const Engine *widest = engine_avx512(), *fastest = engine_fastest();
    return !widest             ? N_("the default for this processor")
           : widest == fastest ? N_("AVX-512 was measured to be faster on this processor than AVX2")
                               : N_("the default; AVX-512 was not measured on this processor");
}

const Engine *engine_with_role(EngineRole role) {
    enum { DOUBLE_BITS = 53 };
    if (role == ENGINE_FASTEST) {
        return engine_fastest();
    }
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        int bits = (*engine)->mantissa_bits;
        bool has_role = role == ENGINE_DOUBLE ? bits == DOUBLE_BITS : bits > DOUBLE_BITS;
        if (has_role && engine_is_supported(*engine)) {
            return *engine;
        }
    }
    return NULL;
}

const Engine *engine_scalar(const Engine *engine) {
    for (const Engine *const *other = engine_list(); *other; other++) {
        if ((*other)->lanes == 1 && (*other)->mantissa_bits == engine->mantissa_bits) {
            return *other;
        }
    }
    return engine;
}

/** Reports that there is no engine of a name, and which there are. */
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
        return engine_with_role(ENGINE_FASTEST);
    }
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if (strcmp(name, (*engine)->name) == 0) {
            const char *missing = engine_missing_feature(*engine);
            if (missing) {
                error_set(error, STATUS_USAGE, "engine %s needs a processor with %s", name,
                          missing);
            }
            return missing ? NULL : *engine;
        }
    }
    error_unknown_engine(name, error);
    return NULL;
}
