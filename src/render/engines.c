/**
 * @file
 * @brief The engines that this program was built with, and which of them this machine can run.
 */
#include "dioptre/engine.h"

#include <stdio.h>
#include <string.h>

extern const Engine engine_f32x8;  /**< Eight floats at once. */
extern const Engine engine_f32x16; /**< Sixteen floats at once. */
extern const Engine engine_f32x4;  /**< Four floats at once. */
extern const Engine engine_f32x1;  /**< Float, one ray after the other. */
extern const Engine engine_f64x4;  /**< Four doubles at once. */
extern const Engine engine_f64x1;  /**< Double, one ray after the other. */
extern const Engine engine_f128x1; /**< Quad: the reference. */

const Engine *const *engine_list(void) {
    static const Engine *const engines[] = {
        &engine_f32x8, &engine_f32x16, &engine_f32x4,  &engine_f32x1,
        &engine_f64x4, &engine_f64x1,  &engine_f128x1, NULL};
    return engines;
}

/** @return What an engine needs of the processor and it does not have; NULL where it can run.
 *  @param engine The engine. */
static const char *engine_lacks(const Engine *engine) {
#if defined(__x86_64__)
    bool is_avx2 = engine == &engine_f32x8 || engine == &engine_f64x4;
    bool is_avx512 = engine == &engine_f32x16;
    if (is_avx2 && !__builtin_cpu_supports("avx2")) {
        return "AVX2";
    }
    if (is_avx512 && !(__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))) {
        return "AVX-512";
    }
#else
    (void)engine;
#endif
    return NULL;
}

bool engine_is_supported(const Engine *engine) {
    return engine_lacks(engine) == NULL;
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

/** Says which engines there are. @param name What was asked for. @param[out] error The message. */
static void engine_unknown(const char *name, Error *error) {
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
                      engine_lacks(*engine));
            return NULL;
        }
    }
    engine_unknown(name, error);
    return NULL;
}
