/**
 * @file
 * @brief Names of processors by CPUID, and which of them take the engine of AVX-512.
 */
#include "testing.h"

#include "dioptre/engine.h"
#include "render/processor.h"

#include <string.h>

/** Registers of CPUID of processors in shops, and what their makers call them. */
static const struct {
    const char *maker;   /**< EBX, EDX, ECX of leaf 0. */
    uint32_t signature;  /**< EAX of leaf 1. */
    int family;          /**< Family. */
    int model;           /**< Model. */
    bool prefers_avx512; /**< Whether the engine of 16 lanes was measured to be faster. */
} known[] = {
    {"GenuineIntel", 0x000c06f2, 6, 0xcf, true},  // Emerald Rapids.
    {"GenuineIntel", 0x000806f8, 6, 0x8f, true},  // Sapphire Rapids.
    {"GenuineIntel", 0x00050657, 6, 0x55, false}, // Cascade Lake, which lowers its clock.
    {"GenuineIntel", 0x000306c3, 6, 0x3c, false}, // Haswell, without AVX-512.
    {"GenuineIntel", 0x00000f43, 15, 4, false},   // Pentium 4: a family with an extension of 0.
    {"AuthenticAMD", 0x00a10f11, 25, 0x11, true}, // Zen 4: two halves, and faster.
    {"AuthenticAMD", 0x000806f8, 6, 0x8f, false}, // Another maker's numbers mean others.
    {"", 0, 0, 0, false},                         // No CPUID at all.
};

/** Family and model are put together as the makers' manuals say. */
static void test_decoding(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        uint32_t maker[3] = {0};
        memcpy(maker, known[i].maker, strlen(known[i].maker));
        Processor processor = processor_from_cpuid(maker, known[i].signature);
        assert_string_equal(processor.maker, known[i].maker);
        assert_int_equal(processor.family, known[i].family);
        assert_int_equal(processor.model, known[i].model);
        assert_int_equal(processor_prefers_avx512(&processor), known[i].prefers_avx512);
    }
}

/** `auto` is the engine of AVX-512 exactly where the processor has it and is on the list, and never
 *  one that the processor cannot run. */
static void test_choice(void **state) {
    (void)state;
    const Processor processor = processor_current();
    const Engine *chosen = engine_with_role(ENGINE_FASTEST);
    bool has_avx512 = false;
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        has_avx512 =
            has_avx512 || ((*engine)->needs == ENGINE_NEEDS_AVX512 && engine_is_supported(*engine));
    }
    assert_true(engine_is_supported(chosen));
    assert_int_equal(chosen->needs == ENGINE_NEEDS_AVX512,
                     has_avx512 && processor_prefers_avx512(&processor));
    assert_ptr_equal(engine_find("auto", NULL), chosen);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_decoding),
                                       cmocka_unit_test(test_choice)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
