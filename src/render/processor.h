/**
 * @file
 * @brief The processor that the program runs on, as its CPUID instruction names it, and whether
 *        AVX-512 was measured to be faster there than AVX2.
 */
#ifndef DIOPTRE_RENDER_PROCESSOR_H
#define DIOPTRE_RENDER_PROCESSOR_H

#include <stdbool.h>
#include <stdint.h>

/** A series of processors. */
typedef struct Processor {
    char maker[13]; /**< The maker's name, 12 letters; empty: unknown, or no x86. */
    int family;     /**< Family, with its extension. */
    int model;      /**< Model, with its extension. */
} Processor;

/**
 * @return A processor from the registers of CPUID.
 * @param maker      EBX, EDX and ECX of leaf 0: the letters of the maker's name.
 * @param signature  EAX of leaf 1: family and model.
 */
Processor processor_from_cpuid(const uint32_t maker[3], uint32_t signature);

/** @return The processor that runs this. */
Processor processor_current(void);

/**
 * @return Whether 16 floats by AVX-512 were measured to be faster than 8 by AVX2 on processors of
 *         this series. Of others nobody knows: some lower their clock for AVX-512, some take two
 *         halves one after the other. `make bench` measures it.
 */
bool processor_prefers_avx512(const Processor *processor);

#endif
