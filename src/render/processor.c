/**
 * @file
 * @brief Names of processors by CPUID, and the list of those on which AVX-512 was measured.
 *
 * A list and no measurement at the start: the same machine then takes the same engine each time,
 * however busy it is, and nothing is kept that could be damaged.
 */
#include "render/processor.h"

#include <stddef.h>
#include <string.h>

#if defined(__x86_64__)
#include <cpuid.h>
#endif

/** A series on which both engines were measured. */
typedef struct MeasuredSeries {
    const char *maker;   /**< See #Processor.maker. */
    int family;          /**< Family. */
    int model;           /**< Model. */
    bool prefers_avx512; /**< Whether the engine of 16 lanes was faster. */
} MeasuredSeries;

/** Ten scenes or more of this program, of all kinds, drawn in turn by both engines. */
static const MeasuredSeries measured[] = {
    {"GenuineIntel", 6, 0x8f, true},  // Sapphire Rapids.
    {"GenuineIntel", 6, 0xcf, true},  // Emerald Rapids: 1.05 to 1.3 times as fast.
    {"AuthenticAMD", 25, 0x11, true}, // Zen 4, Genoa: 0.93 to 1.3 times, 14 of 15 scenes above 1.
};

Processor processor_from_cpuid(const uint32_t maker[3], uint32_t signature) {
    Processor processor = {0};
    memcpy(processor.maker, maker, sizeof processor.maker - 1);
    uint32_t family = signature >> 8 & 0xf, model = signature >> 4 & 0xf;
    // Makers ran out of four bits: family 15 continues in further ones, and so do the models of it
    // and of Intel's family 6.
    if (family == 6 || family == 15) {
        model |= signature >> 12 & 0xf0;
    }
    if (family == 15) {
        family += signature >> 20 & 0xff;
    }
    processor.family = (int)family;
    processor.model = (int)model;
    return processor;
}

Processor processor_current(void) {
    Processor processor = {0};
#if defined(__x86_64__)
    uint32_t signature, maker[3], unused, highest;
    if (__get_cpuid(0, &highest, &maker[0], &maker[2], &maker[1]) &&
        __get_cpuid(1, &signature, &unused, &unused, &unused)) {
        processor = processor_from_cpuid(maker, signature);
    }
#endif
    return processor;
}

bool processor_prefers_avx512(const Processor *processor) {
    for (size_t i = 0; i < sizeof measured / sizeof *measured; i++) {
        const MeasuredSeries *series = &measured[i];
        if (strcmp(series->maker, processor->maker) == 0 && series->family == processor->family &&
            series->model == processor->model) {
            return series->prefers_avx512;
        }
    }
    return false;
}
